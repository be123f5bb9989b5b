"""The first screens, for people who are blind or have low vision."""

import pytest

from tests.e2e.axe import violations
from tests.e2e.python_pane import edit_python, open_python, write_program
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]


def test_screens_have_names_and_contrast(studio: Studio) -> None:
    found: dict[str, list[str]] = {}

    def check(screen: str, shows: str) -> None:
        found[screen] = violations(studio, shows)

    check("start", "group-name")
    studio.enter_new_group()
    check("studio, empty", "run")
    write_program(studio, 'robot.move_forward(0.1)\nrobot.say("oi")\n')
    open_python(studio)
    check("studio with text", "python-text")
    edit_python(studio, "robot.fly()\n")
    check("text with a fault", "python-fault")
    assert {screen: one for screen, one in found.items() if one} == {}
