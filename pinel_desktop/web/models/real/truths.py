"""Where a real robot truly was in a run."""

from typing import Annotated

from pydantic import BaseModel, Field

from pinel_desktop.runs.truth import Source
from pinel_desktop.web.models import DEFERRED, Id, RequestModel, ResponseModel, Time

_TICK = "in steps of 1/30 s of robot time; null: where the robot stood after the run"
_SIGMA = "standard uncertainty (one sigma)"


class TruePose(ResponseModel):
    """A pose in the frame of the start: x ahead of the start mark, y to its left, heading counterclockwise."""

    tick: Annotated[int | None, Field(description=_TICK)]
    x_m: float
    y_m: float
    heading_rad: float
    sigma_m: Annotated[float, Field(description=f"{_SIGMA} of each coordinate")]
    sigma_rad: Annotated[float, Field(description=f"{_SIGMA} of the heading")]


class Truth(ResponseModel):
    """What one source says: a tape measure, a camera above the floor, the robot's own localisation."""

    source: Source
    measured_at: Time
    poses: Annotated[list[TruePose], Field(description="in the order of their ticks")]
    covered_s: Annotated[
        float, Field(description="for how long of the run the source knows the robot's place")
    ]


class BelievedPose(ResponseModel):
    """The pose that the robot itself estimated by its wheels, in the frame of the start."""

    x_m: float
    y_m: float
    heading_rad: float


class TruthList(ResponseModel):
    """The truths of a run, one for each source that has measured it."""

    truths: list[Truth]
    believed: Annotated[
        BelievedPose | None,
        Field(description="where the robot believed to be at the end; null without samples"),
    ]
    run_s: Annotated[float, Field(description="robot time of the run so far")]


class TruthPoses(RequestModel):
    """What a source says about a run; no poses take back what it said."""

    poses: list[TruePose]


class TruthPath(BaseModel):
    """The run and the source in a path."""

    model_config = DEFERRED

    id: Id
    source: Source
