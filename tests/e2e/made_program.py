"""A group whose program was made by requests, for tests of what comes after building."""

from typing import Any

from tests.e2e.past_lesson import Step, document_of, workspace_of
from tests.e2e.studio import Studio


def enter_made_group(
    studio: Studio, *steps: Step, speed: float = 1.0, name: str = "Os Tatus"
) -> list[str]:
    """Opens a new group's program of these steps; returns the ids of its blocks.

    Args:
        speed: how many times faster than the clock it runs, as chosen beside Run.
        name: begins the group's name, which is unique.
    """
    group = studio.tell("POST", "/groups", {"name": studio.unique(name)})["id"]
    program = studio.tell("POST", f"/groups/{group}/programs", {"name": "Programa 1"})["id"]
    save_steps(studio, program, *steps, speed=speed)
    studio.page.goto(f"{studio.origin}/#/program/{program}")
    studio.wait_until_open()
    studio["level"].select_option("3")
    return [command["block"] for command in studio.commands()]


def save_steps(studio: Studio, program: str, *steps: Step, speed: float = 1.0) -> None:
    """Saves the steps as the program's newest version."""
    version: dict[str, Any] = {
        "workspace": workspace_of(list(steps)),
        "document": document_of(list(steps)),
        "setup": {"world": "empty_room", "speed": speed},
    }
    studio.tell("POST", f"/programs/{program}/versions", version)
