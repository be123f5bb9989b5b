"""The camera: its state, its problem, and its choice."""

from typing import Annotated, Literal

from pydantic import Field

from pinel_desktop.web.models import Json, RequestModel, ResponseModel


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


class CameraChoice(RequestModel):
    """The camera to use: the number of a webcam, "0" for the first."""

    source: Annotated[str, Field(pattern=r"^[0-9]$")]
