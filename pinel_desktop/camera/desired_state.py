"""The desired state of the camera process. Each message has all of it, so no message depends on an earlier one."""

from dataclasses import asdict, dataclass, fields
from typing import Any

from pinel_desktop.gestures.letters import LANDMARKS
from pinel_desktop.processes.messages import Message


@dataclass(frozen=True, slots=True)
class DesiredState:
    """Desired state of the camera process.

    Attributes:
        source: address of the camera, as for `frames.open_reader`; None switches the camera off.
        mirror: whether the preview is mirrored; recognition does not depend on it.
        capture: id of the capture that waits for a sign or a number; None if no capture waits.
        capture_number: whether it waits for a number shown by hand.
        preview: whether the preview has a viewer.
        annotated: whether the preview with hands and signs drawn into it has a viewer.
        caption: a line of text in the annotated preview.
        record: id of the sample recording in progress; None if there is none.
        record_moving: whether this recording waits for movements, not for hands at rest.
        recognizer: name of the recognizer of signs, as for `gestures.recognizers.open_recognizer`.
        overhead: what was measured of a camera above the floor (`overhead.markers.OverheadSetup`), while the robot is
            followed; None for no robot.
    """

    source: str | None = None
    mirror: bool = True
    capture: str | None = None
    capture_number: bool = False
    preview: bool = False
    annotated: bool = False
    caption: str = ""
    record: str | None = None
    record_moving: bool = False
    recognizer: str = LANDMARKS
    overhead: dict[str, float] | None = None

    def as_message(self) -> Message:
        return {"type": "desired_state", **asdict(self)}

    @classmethod
    def of(cls, message: dict[str, Any]) -> "DesiredState":
        return cls(**{field.name: message[field.name] for field in fields(cls)})
