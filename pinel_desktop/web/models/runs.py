"""Live and recorded runs."""

from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.engine.commands import BlockIds, SpeedFactor
from pinel_desktop.robot import PIONEER_3DX, Feedback, Preset
from pinel_desktop.web.models import Id, Json, RequestModel, ResponseModel, Time
from pinel_desktop.web.models.events import Event
from pinel_desktop.web.models.robots import RobotName
from pinel_desktop.web.models.work import Version
from pinel_desktop.web.models.worlds import Start, World
from storage import SIMULATOR

Point = tuple[float, float]


# `waiting` until this PC has repeated the run, else the finding
Unconfirmed = Literal["waiting", "differs", "not_passed", "not_repeatable"]


class Run(ResponseModel):
    """One execution of a version; metrics are null until the run has ended."""

    id: Id
    program_id: Id | None
    program_name: str | None
    version_id: Id | None
    group_id: Id | None
    link: str
    model: Annotated[
        str | None,
        Field(description="which robot drove; null of the first releases: the default"),
    ]
    calibrated_robot: Annotated[
        str | None, Field(description="name of the robot with a real one's errors; null of others")
    ]
    world: str
    seed: int
    state: Literal["running", "finished", "stopped", "failed"]
    reason: str | None
    message: str | None
    remedy: str | None
    params: Json
    block: str | None
    started_at: Time
    ended_at: Time | None
    duration_s: float | None
    n_executed: int | None
    path_length_m: float | None
    closing_error_m: Annotated[
        float | None,
        Field(
            description="where the robot truly is, null where only its estimate exists; the estimate itself without "
            "`estimated_closing_error_m` beside it, as earlier releases recorded it"
        ),
    ]
    estimated_closing_error_m: Annotated[
        float | None, Field(description="by the pose that the robot itself estimates")
    ]
    telemetry_sha256: str | None
    lesson_id: Id | None
    activity: str | None
    passed: Annotated[
        bool | None,
        Field(
            description="null without activity, before it was checked, if it was not judged, and while `unconfirmed`"
        ),
    ]
    unconfirmed: Annotated[
        Unconfirmed | None,
        Field(description="why a run that came with a file does not count; null where it counts"),
    ]
    path: Annotated[list[Point], Field(max_length=64, description="x, y in m, for the picture")]


class RunWithVersion(Run):
    """A run with the data for its replay; `version` is null for runs of the command line."""

    by_robot: Annotated[bool, Field(description="judged by what a real robot measured")]
    not_judged: Annotated[
        str | None, Field(description="why a run on a real robot was not judged, in words")
    ]
    missing: Annotated[
        str | None, Field(description="what a run that did not pass lacks, in words")
    ]
    missing_block: Annotated[str | None, Field(description="id of the block that it is about")]
    other_computer: Annotated[
        str | None, Field(description="name of the PC on which it ran; null for this PC")
    ]
    version: Version | None
    world_document: World | None


class RunList(ResponseModel):
    """Runs, newest first; `next` is the value of `before` for the next page, null at the end."""

    runs: list[Run]
    next: Id | None


class RunPage(RequestModel):
    """A page of the list."""

    before: Id | None = None
    limit: Annotated[int, Field(ge=1, le=200)] = 50


class CloudInputs(RequestModel):
    """What all robots of a cloud read, and where they start."""

    run_id: Annotated[
        Id | None, Field(description="the run whose signs and answers the robots read")
    ] = None
    case: Annotated[
        int, Field(ge=1, le=100, description="number of the activity's case that the robots drive")
    ] = 1


class NewRun(RequestModel):
    """A version to run, with world, robot and debugging options."""

    version_id: Id
    world: Annotated[str, Field(max_length=100, description="a name, or `own`: the version's")]
    seed: Annotated[int | None, Field(strict=True, ge=0, le=2**53 - 1)] = None
    start: Annotated[Start | None, Field(description="another start than the world's")] = None
    model: RobotName = PIONEER_3DX.name
    preset: Preset = "ideal"
    feedback: Feedback = "pose"
    calibrated_robot: Annotated[
        Id | None,
        Field(
            description="a robot with a real one's errors, instead of model and preset; of a real robot's run, the one"
            " that predicts it"
        ),
    ] = None
    breakpoints: BlockIds = Field(default_factory=list)
    speed: SpeedFactor = 1.0
    robot: Annotated[
        str, Field(max_length=20, description="`sim`, or the link of a real robot that is set up")
    ] = SIMULATOR
    slow: Annotated[bool, Field(description="a real robot at half of its speeds")] = False
    cloud: Annotated[
        CloudInputs | None,
        Field(
            description="one robot of a cloud, by its seed: an activity neither judges it nor chooses its preset"
        ),
    ] = None
    paused: Annotated[bool, Field(description="hold before the first block")] = False


class CommandAnswer(ResponseModel):
    """The value of `evaluate`, or a message why it has none; null for all other commands."""

    value: Any
    problem: str | None


class RunEvents(ResponseModel):
    """All events of a run except telemetry, in order."""

    events: list[Event]


class NewCloud(CloudInputs):
    """A version for many robots, with its world, as for a run."""

    id: Annotated[
        str,
        Field(min_length=1, max_length=64, description="chosen by the page: its events name it"),
    ]
    version_id: Id
    world: Annotated[str, Field(max_length=100, description="a name, or `own`: the version's")]
    start: Annotated[Start | None, Field(description="another start than the world's")] = None
    model: RobotName = PIONEER_3DX.name
    calibrated_robot: Annotated[
        Id | None, Field(description="a robot with a real one's errors, instead of the model")
    ] = None
    robot: Annotated[str, Field(max_length=20, description="`sim`; others are refused")] = SIMULATOR


class Cloud(ResponseModel):
    """A cloud that has begun; `cloud` events have its robots."""

    id: Id
    n: Annotated[int, Field(description="number of its robots")]
