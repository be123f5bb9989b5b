"""Clouds: one program in many robots at once."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.robot import PIONEER_3DX
from pinel_desktop.web.models import Id, RequestModel, ResponseModel
from pinel_desktop.web.models.robots import RobotName
from pinel_desktop.web.models.worlds import Start
from storage import SIMULATOR


class NewCloud(RequestModel):
    """A version for many robots, with its world, as for a run."""

    id: Annotated[
        str,
        Field(min_length=1, max_length=64, description="chosen by the page: its events name it"),
    ]
    version_id: Id
    world: Annotated[str, Field(max_length=100, description="a name, or `own`: the version's")]
    start: Annotated[Start | None, Field(description="another start than the world's")] = None
    model: RobotName = PIONEER_3DX.name
    robot: Annotated[str, Field(max_length=20, description="`sim`; others are refused")] = SIMULATOR
    run_id: Annotated[
        Id | None, Field(description="the run whose signs and answers the robots read")
    ] = None


class Cloud(ResponseModel):
    """A cloud that has begun; `cloud` events have its robots."""

    id: Id
    n: Annotated[int, Field(description="number of its robots")]
