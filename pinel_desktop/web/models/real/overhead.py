"""The camera above the floor: what was measured, and what it sees."""

from pinel_desktop.web.models import Json, RequestModel, ResponseModel


class OverheadMeasures(RequestModel):
    """Where the printed markers lie, in m.

    From the centre of floor marker 1 to that of marker 2 (`width_m`) and of marker 4 (`depth_m`); heights of the lens
    (`camera_m`) and of the robot's marker (`robot_m`) above the floor.
    """

    width_m: float
    depth_m: float
    camera_m: float
    robot_m: float


class OverheadCamera(ResponseModel):
    """The camera above the floor; while it is off, the measures are proposals."""

    is_on: bool
    width_m: float
    depth_m: float
    camera_m: float
    robot_m: float


class OverheadSighting(ResponseModel):
    """What the camera above the floor sees now.

    `code` is that of the message: `overhead_seen` with the robot's place, or a problem; null while the camera starts.
    `markers` are the numbers of the markers in the picture: 1 to 4 on the floor, 5 on the robot.
    """

    code: str | None
    params: Json
    message: str
    remedy: str
    markers: list[int]


class OverheadSheets(ResponseModel):
    """The five sheets to print, as a page (HTML) that loads nothing."""

    page: str
