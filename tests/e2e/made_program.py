"""Creates a group's program by requests, for tests of features other than building programs."""

from tests.e2e.past_lesson import Step, document_of, workspace_of
from tests.e2e.studio import Studio


def enter_made_group(
    studio: Studio, *versions: list[Step], speed: float = 1.0, activity: str | None = None
) -> None:
    """Opens the program of a new group, in the last of these versions.

    Args:
        versions: the steps of each version, the oldest first.
        speed: the chosen speed of runs, in multiples of real time.
        activity: the mission of the program.
    """
    group = studio.send("POST", "/groups", {"name": studio.unique("Os Tatus")})["id"]
    program = studio.send("POST", f"/groups/{group}/programs", {"name": "Programa 1"})["id"]
    for steps in versions:
        version = {
            "workspace": workspace_of(steps),
            "document": document_of(steps),
            "setup": {"world": "empty_room", "speed": speed, "activity": activity},
        }
        studio.send("POST", f"/programs/{program}/versions", version)
    studio.page.goto(f"{studio.origin}/#/program/{program}")
    studio.wait_until_open()
    studio.choose_level(3)
