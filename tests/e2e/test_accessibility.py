"""The first screens, for people who are blind or have low vision."""

import pytest
from playwright.sync_api import Locator

from tests.e2e.axe import violations
from tests.e2e.python_pane import edit_python, open_python, write_program
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]


def test_screens_have_names_and_contrast(studio: Studio) -> None:
    found: dict[str, list[str]] = {}

    def check(screen: str, shows: str | Locator, *, every_theme: bool = True) -> None:
        found[screen] = violations(studio, shows, every_theme=every_theme)

    check("start", "group-name")
    studio.enter_new_group(level=1)
    check("studio, palette of blocks", "run")
    studio["toolbox-search"].fill("xyzw")
    check("studio, palette of a note", studio.page.get_by_text("Nenhum bloco"))
    studio.choose_level(3)
    check("studio, empty", "run")
    studio.blocks.open_category("sensing")
    # a change of the theme closes it
    check("studio, palette of values", studio.blocks.in_flyout("bateu"), every_theme=False)
    studio.page.keyboard.press("Escape")
    write_program(studio, 'robot.move_forward(0.1)\nrobot.turn(90)\nrobot.say("oi")\n')
    studio.blocks.by_text("andar para frente").locator(".blocklyInputField").first.click()
    check("open number field", studio.page.locator(".blocklyHtmlInput"), every_theme=False)
    studio.page.keyboard.press("Escape")
    studio.blocks.by_text("girar").locator("> .blocklyDropdownField").first.click()
    check("open menu", studio.page.locator(".blocklyMenu"), every_theme=False)
    studio.page.keyboard.press("Escape")
    open_python(studio)
    check("studio with text", "python-text")
    edit_python(studio, "robot.fly()\n")
    check("text with a fault", "python-fault")
    assert {screen: one for screen, one in found.items() if one} == {}
