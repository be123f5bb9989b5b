"""A square, built and driven with the keyboard only."""

import pytest
from playwright.sync_api import expect

from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


class Keys:
    """Blockly's own keys: T to the toolbox, arrows to move, Enter to append, to drop and to edit."""

    def __init__(self, studio: Studio) -> None:
        self._keyboard = studio.page.keyboard
        self._focused = studio.page.locator(".blocklyActiveFocus")

    def press(self, *keys: str) -> None:
        for key in keys:
            self._keyboard.press(key)

    def walk_to(self, text: str, key: str, max_presses: int = 12) -> None:
        """Presses a key until the focused element contains the text."""
        for _ in range(max_presses):
            if text in self._label():
                return
            self.press(key)
        raise AssertionError(f"{key} never came to {text!r}, but to {self._label()!r}")

    def add_block(
        self, category: str, block: str, key: str = "t", direction_key: str = "ArrowDown"
    ) -> None:
        """Appends a block from the toolbox to the loop or the program; `key` moves the focus to the toolbox."""
        self.press(key)
        self.walk_to(category, direction_key)
        self.press("ArrowRight")
        self.walk_to(block, "ArrowDown")
        self.press("Enter")

    def _label(self) -> str:
        focused = self._focused.first
        return (focused.get_attribute("aria-label") or focused.text_content() or "").replace(
            "\u00a0", " "
        )


def inside(studio: Studio) -> list[str]:
    return [command["action"] for loop in studio.commands() for command in loop["commands"]]


def test_a_square_is_built_and_run_by_keyboard_alone(studio: Studio) -> None:
    keyboard = studio.page.keyboard
    expect(studio["group-name"]).to_be_visible()
    studio["group-name"].focus()
    keyboard.type("As Capivaras")
    keyboard.press("Enter")
    studio.wait_until_open()

    keys = Keys(studio)
    for _ in range(40):
        if studio.page.locator(".blocklyToolbox :focus").count():
            break
        keyboard.press("Tab")
    expect(studio["toolbox-search"]).to_be_focused()
    keyboard.press("ArrowDown")

    keys.press("w")
    keys.walk_to("quando rodar", "ArrowDown")
    keys.add_block("Controle", "repetir")
    # the flyout stays open
    keys.add_block("Movimento", "andar para frente", key="ArrowLeft", direction_key="ArrowUp")
    keys.walk_to("girar", "ArrowDown")
    keys.press("Enter", "Escape")

    studio.eventually(studio.actions, ["repeat"])
    studio.eventually(lambda: inside(studio), ["move_forward", "turn"])

    keys.walk_to("andar para frente", "ArrowUp")
    keys.press("ArrowRight", "Enter")
    expect(studio.page.locator(".blocklyHtmlInput")).to_be_focused()
    keyboard.type("0,2")
    keys.press("Enter")
    expect(studio.blocks.by_text("andar para frente")).to_contain_text("0,2")

    for _ in range(60):
        if studio.page.locator('[data-testid="run"]:focus').count():
            break
        keyboard.press("Shift+Tab" if studio["run"].is_disabled() else "Tab")
    expect(studio["run"]).to_be_focused()
    keyboard.press("Enter")
    studio.wait_for_phase("finished")
    studio.expect_number("pose-x", pytest.approx(0, abs=0.001))
    assert studio.commands()[0]["commands"][0]["distance"] == 0.2
