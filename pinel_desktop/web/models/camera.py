"""The camera: what it does, and through which one the app looks."""

from typing import Annotated, Literal

from pydantic import Field

from pinel_desktop.web.models import Json, RequestModel, ResponseModel


class CameraProblem(ResponseModel):
    """Why the camera is of no use, and what to do."""

    code: str
    params: Json
    message: str
    remedy: str


class CameraStatus(ResponseModel):
    """What the camera does; `problem` says why it is of no use, and what to do."""

    state: Literal["off", "opening", "on", "failed"]
    source: str
    problem: CameraProblem | None


class CameraChoice(RequestModel):
    """The camera to look through: the number of a webcam, "0" for the first."""

    source: Annotated[str, Field(pattern=r"^[0-9]$")]
