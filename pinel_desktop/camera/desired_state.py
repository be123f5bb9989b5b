"""What the app wants of the camera process: each message says everything, so that none depends on another."""

from dataclasses import asdict, dataclass, fields
from typing import Any

from pinel_desktop.processes.messages import Message


@dataclass(frozen=True, slots=True)
class DesiredState:
    """What the process is to do from now on.

    Attributes:
        source: the camera to look through, as `frames.open_reader` takes it; None switches it off.
        mirror: whether pupils are to see themselves as in a mirror; signs are recognised alike.
        capture: id of the run whose capture waits for a sign; None while none does.
        preview: whether somebody watches the picture.
        annotated: whether somebody watches it with the hands and their signs drawn into it.
        caption: a line that stands in that picture.
        record: id of the recording that waits for hands; None while none does.
        record_moving: whether it waits for movements, not for hands at rest.
    """

    source: str | None = None
    mirror: bool = True
    capture: str | None = None
    preview: bool = False
    annotated: bool = False
    caption: str = ""
    record: str | None = None
    record_moving: bool = False

    def as_message(self) -> Message:
        return {"type": "want", **asdict(self)}

    @classmethod
    def of(cls, message: dict[str, Any]) -> "DesiredState":
        return cls(**{field.name: message[field.name] for field in fields(cls)})
