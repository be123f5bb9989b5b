"""Activities that ship, and those of a file."""

from functools import cache
from importlib import resources
from pathlib import Path

from pydantic import ValidationError

from pinel_desktop.activities.model import Activity
from pinel_desktop.errors import PinelError

_MAX_BYTES = 2**20


@cache
def _shipped() -> dict[str, Activity]:
    folder = resources.files(__name__.rpartition(".")[0]) / "catalogue"
    texts = [entry.read_text("utf-8") for entry in folder.iterdir() if entry.name.endswith(".json")]
    activities = (Activity.model_validate_json(text) for text in texts)
    return {activity.name: activity for activity in sorted(activities, key=lambda a: a.name)}


def activity_names() -> list[str]:
    """Names of the activities that ship, in alphabetical order."""
    return list(_shipped())


def choose_activity(name_or_file: str) -> Activity:
    """The activity of that name, or of that file (`.json`).

    Raises:
        PinelError: `unknown_activity`, `file_unreadable`, `activity_invalid`.
    """
    if not name_or_file.endswith(".json"):
        if name_or_file not in _shipped():
            raise PinelError("unknown_activity", value=name_or_file, allowed=activity_names())
        return _shipped()[name_or_file]
    try:
        with Path(name_or_file).open("rb") as file:
            text = file.read(_MAX_BYTES)
    except (OSError, ValueError) as error:
        raise PinelError("file_unreadable", path=name_or_file) from error
    try:
        return Activity.model_validate_json(text)
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        place = "/" + "/".join(str(part) for part in first["loc"])
        raise PinelError(
            "activity_invalid", path=name_or_file, place=place, detail=first["msg"]
        ) from error
