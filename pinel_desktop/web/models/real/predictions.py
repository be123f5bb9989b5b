"""Predictions of runs on real robots."""

from typing import Annotated, Literal

from pydantic import Field

from pinel_desktop.web.models import Id, ResponseModel

Source = Annotated[
    Literal["odometry", "tape", "camera", "localisation"],
    Field(description="where the poses come from: the robot's odometry, or a source of truth"),
]


class PredictedStep(ResponseModel):
    """An executed motion or wait of the prediction; `end` is null if it did not come to its end."""

    pointer: str
    block: str | None
    action: str
    amount: Annotated[float | None, Field(description="m, degrees or s")]
    start: Annotated[int, Field(description="tick")]
    end: int | None


class StepDifference(ResponseModel):
    """A step of the real run beside the predicted one; measured values are null where the source saw nothing."""

    block: str | None
    action: str
    amount: float | None
    tick: Annotated[int, Field(description="tick of the real run at which it started")]
    predicted_turned_deg: Annotated[float, Field(description="counterclockwise")]
    predicted_moved_m: Annotated[float, Field(description="from its start to its end")]
    turned_deg: float | None
    moved_m: Annotated[float | None, Field(description="in the predicted direction")]


class EndDifference(ResponseModel):
    """Where the robot stood at the end, from where the prediction ends."""

    source: Source
    distance_m: float
    heading_deg: Annotated[float, Field(description="counterclockwise from the predicted heading")]


class Finding(ResponseModel):
    """A difference that is worth a sentence."""

    kind: Literal["turn", "move"]
    how: Annotated[
        Literal["each", "once", "average"],
        Field(
            description="each time the step ran, in one execution, or on average of turns, of which the sum is known"
        ),
    ]
    source: Source
    difference: Annotated[
        float, Field(description="how much more than predicted, degrees or m; negative: less")
    ]
    n: Annotated[int, Field(description="number of executions")]
    block: str | None
    action: str
    amount: float | None
    tick: int


class RunDifference(ResponseModel):
    """A real robot's run beside its prediction."""

    source: Source
    steps: list[StepDifference]
    at_end: EndDifference | None
    is_whole: Annotated[
        bool,
        Field(description="`at_end` is after the whole run, and the prediction did the same steps"),
    ]
    ate_m: Annotated[
        float | None,
        Field(
            description="absolute trajectory error (RMSE; Sturm et al. 2012), the paths aligned at their start"
        ),
    ]
    parted: Annotated[
        str | None,
        Field(
            description='block at which the real run did another step; "" for a step without a block'
        ),
    ]
    findings: Annotated[list[Finding], Field(description="the largest first")]


class RunPrediction(ResponseModel):
    """What a simulated robot does with the spec of a real robot's run, and the run beside it."""

    robot: Annotated[
        str | None,
        Field(description="name of the calibrated robot that predicts; null for the ideal one"),
    ]
    within_m: Annotated[
        float | None,
        Field(
            description="distance from the predicted end within which 95 of 100 runs end; null if nobody can tell"
        ),
    ]
    path: Annotated[
        list[tuple[float, float, float, float]],
        Field(description="tick, true x (m), y (m), heading (rad, without jumps); start frame"),
    ]
    steps: list[PredictedStep]
    awaits_input: Annotated[bool, Field(description="it ends where an input is not given yet")]
    is_cut: Annotated[bool, Field(description="it ends after 10 minutes")]
    reads_sensors: Annotated[
        bool, Field(description="the program measures the world, of which only the room is known")
    ]
    knows_room: Annotated[bool, Field(description="otherwise it is for an empty room")]
    difference: RunDifference


class UnusualRun(ResponseModel):
    """A run whose difference from its prediction is out of the ordinary for its robot."""

    run: Id
    kind: Annotated[
        Literal["turn", "move", "path"],
        Field(
            description="of a turn (degrees), a move (m), or the whole path (trajectory error, m)"
        ),
    ]
    difference: float
    usual: Annotated[float, Field(description="median of the robot's other runs")]
    n_runs: Annotated[int, Field(description="number of the robot's other runs")]
    source: Source
    block: str | None
    action: str | None
    amount: float | None
    tick: int | None


class UnusualRuns(ResponseModel):
    """The newest runs of real robots that are out of the ordinary."""

    runs: list[UnusualRun]
