"""Robots: the models of the simulator, and the real robots of this PC."""

from typing import Annotated, Literal

from pydantic import Field

from pinel_desktop.robot import ROBOTS
from pinel_desktop.runs.truth import Source
from pinel_desktop.web.models import DEFERRED, Id, Json, RequestModel, ResponseModel, Time
from pinel_desktop.web.models.worlds import World

RobotName = Annotated[str, Field(json_schema_extra={"enum": list(ROBOTS)})]


class Wheel(ResponseModel):
    """A driven wheel from above; its centre in the robot's frame."""

    x_m: float
    y_m: float
    radius_m: float
    width_m: float


class Sonar(ResponseModel):
    """A sonar: its position in the robot's frame, and its direction relative to the heading, counterclockwise."""

    x_m: float
    y_m: float
    angle_rad: float


class Laser(ResponseModel):
    """A laser scanner: its position in the robot's frame; half of its field is to each side of the heading."""

    x_m: float
    y_m: float
    field_deg: int
    min_m: float
    range_m: float


class Robot(ResponseModel):
    """A robot model: the data to draw it. The robot's frame has x ahead and y to the left."""

    name: Annotated[RobotName, Field(description="the `model` of a run")]
    title: str
    radius_m: Annotated[float, Field(description="of the circle around the body")]
    hull_m: Annotated[list[tuple[float, float]], Field(description="corners from above")]
    hull_round_m: Annotated[float, Field(description="how far corners are rounded")]
    wheels: list[Wheel]
    max_v_mps: float
    max_omega_radps: float
    sonars: Annotated[list[Sonar], Field(description="by index")]
    sonar_range_m: float
    laser: Annotated[Laser | None, Field(description="null without a laser scanner")]
    has_bumper: bool


class RobotList(ResponseModel):
    """All robot models of the simulator."""

    robots: list[Robot]


class RobotField(ResponseModel):
    """A field of a real robot's profile, with texts for its form."""

    name: Annotated[str, Field(description="of the room `room.NAME`")]
    part: Literal["speed", "room", "address", "tolerance"]
    label: str
    hint: str
    low: Annotated[float | None, Field(description="smallest number; null for a text")]
    high: float | None
    is_whole: bool
    is_list: bool


class RealRobot(ResponseModel):
    """A kind of real robot, and its set-up on this PC."""

    link: Annotated[str, Field(description="the `robot` of a run")]
    is_set_up: bool
    max_v_mps: Annotated[float, Field(description="it is never commanded faster")]
    slow_v_mps: Annotated[float, Field(description="the same in a run with `slow`")]
    world: Annotated[World | None, Field(description="its room; null before it is set up")]
    record: Annotated[
        Json | None, Field(description="what is kept, else the defaults; null if not the teacher")
    ]
    fields: list[RobotField]


class RealRobotList(ResponseModel):
    """All kinds of real robots that this release can drive."""

    robots: list[RealRobot]


class RealRobotRecord(RequestModel):
    """The profile of a real robot to store; a missing field gets its default."""

    record: Json


class RobotContact(ResponseModel):
    """Data that a robot sent, or why it cannot be reached."""

    x_m: float | None
    y_m: float | None
    heading_deg: float | None
    rate_hz: Annotated[float | None, Field(description="messages about its pose in a second")]
    battery: Annotated[float | None, Field(description="from 0 to 1; null if it does not tell")]
    problem: str | None
    remedy: str | None


class FoundRobot(ResponseModel):
    """A ROS 2 robot found in the network."""

    namespace: str
    command_topic: str
    odometry_topic: str
    holder: Annotated[str | None, Field(description="who drives it now; null for nobody")]


class FoundRobots(ResponseModel):
    """The robots in a ROS domain."""

    domain: int
    robots: list[FoundRobot]


class RobotWatch(RequestModel):
    """A request of a page that shows the state of a robot."""

    is_first: Annotated[
        bool, Field(description="it knows nothing yet: what is known comes with the events at once")
    ]


class Jog(RequestModel):
    """The keys that are pressed."""

    drive: Annotated[float, Field(ge=-1, le=1, description="1 ahead, -1 back")]
    turn: Annotated[float, Field(ge=-1, le=1, description="1 left, -1 right")]
    sent_ms: Annotated[
        float,
        Field(
            description="when, by the PC's clock, in ms since 1970; what comes late is passed over"
        ),
    ]


class LinkPath(RequestModel):
    """The `{link}` in a path."""

    model_config = DEFERRED

    link: str


class CalibratedRobot(ResponseModel):
    """A robot of the simulator with the errors of a real one."""

    id: Id
    title: str
    model: RobotName
    created_at: Time


class CalibratedRobotList(ResponseModel):
    """The calibrated robots, oldest first."""

    robots: list[CalibratedRobot]


class RealRun(ResponseModel):
    """A run on a real robot, from which one may calibrate it; `sources` measured where it truly was."""

    id: Id
    program_name: str | None
    group_name: str | None
    link: str
    started_at: Time
    duration_s: float | None
    sources: list[Source]
    shape: Annotated[
        Literal["line", "left", "right"] | None,
        Field(description="a part of the offered pattern: a line, or a square to this side"),
    ]


class RealRunList(ResponseModel):
    """Runs on real robots, newest first."""

    runs: list[RealRun]


class RunsOfRobot(RequestModel):
    """Runs of one real robot."""

    runs: Annotated[list[Id], Field(max_length=20)]


class NewCalibratedRobot(RunsOfRobot):
    """Runs of one real robot, and a name for the robot that they tell."""

    title: Annotated[str, Field(max_length=1000)]


class CalibratedParameter(ResponseModel):
    """A parameter of a robot with its 95 % interval; `nominal` is what a robot has that nobody measured.

    If the runs cannot tell it, `is_known` is false, and value, low and high are the nominal value.
    """

    name: str
    value: float
    low: float
    high: float
    nominal: float
    is_known: bool
    sources: Annotated[list[str], Field(description="a source of truth, or `odometry`")]


class Prediction(ResponseModel):
    """How well the other runs predict where one ended; `expected_m` is the noise floor."""

    place: Annotated[int, Field(description="of the run among all")]
    error_m: float
    expected_m: float
    nominal_m: Annotated[float, Field(description="error without calibration")]
    off_m: Annotated[
        tuple[float, float], Field(description="x and y of the true end from the predicted one")
    ]


class Squares(ResponseModel):
    """Figures of UMBmark (Borenstein and Feng, 1996), by squares in both directions."""

    difference: float
    track_ratio: float
    worst_m: Annotated[float, Field(description="E_max,syst")]
    left_over_m: Annotated[
        float | None,
        Field(description="the same from where the calibrated robot is predicted to end"),
    ]
    n_left: int
    n_right: int


class Calibration(ResponseModel):
    """What runs tell about a real robot; `values` are the parameters of the simulated one."""

    model: str
    runs: list[Id]
    values: dict[str, float]
    parameters: list[CalibratedParameter]
    held_out: list[Prediction]
    squares: Squares | None
