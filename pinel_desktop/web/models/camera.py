"""The camera: its state, its problem, and its choice."""

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from pinel_desktop.web.models import DEFERRED, Json, RequestModel, ResponseModel


class CameraProblem(ResponseModel):
    """Why the camera cannot be used, and the remedy."""

    code: str
    params: Json
    message: str
    remedy: str


class CameraStatus(ResponseModel):
    """The state of the camera; `problem` is why it cannot be used, with the remedy."""

    state: Literal["off", "opening", "on", "failed"]
    source: str
    problem: CameraProblem | None


class Recognizers(ResponseModel):
    """What reads the signs: the landmarks, or one of the detectors of this PC.

    `chosen` and `in_use` are names of detectors, "" the landmarks; `of_command` is the recognizer that the command line
    gave the app in place of the choice, null without one. `problem` is why the chosen one cannot be used.
    """

    chosen: str
    in_use: str
    of_command: str | None
    detectors: list[str]
    signs: list[str]
    problem: CameraProblem | None


class RecognizerChoice(RequestModel):
    """Name of a detector; "" for the landmarks."""

    name: Annotated[str, Field(pattern="^[A-Za-z0-9_-]{0,60}$")]


class NameOfDetectorFile(RequestModel):
    """The name of the file that the person chose."""

    name: Annotated[str, Field(max_length=255)]


class DetectorPath(BaseModel):
    """The name of a detector in a path."""

    model_config = DEFERRED

    name: Annotated[str, Field(pattern="^[A-Za-z0-9_-]{1,60}$")]


class CameraChoice(RequestModel):
    """The camera to use: the number of a webcam, "0" for the first."""

    source: Annotated[str, Field(pattern=r"^[0-9]$")]
