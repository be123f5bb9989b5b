"""What a simulated robot does with the spec of a real robot's run: the prediction of that run.

The program, the room, the seed, the limits and the goal tolerances of the run are the same, and so are the inputs that
people gave. What they have not given yet ends the prediction. The robot is that of the spec's setting without its
chance: the ideal one, or a calibrated one, whose true path and odometry differ.
"""

from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import BlockEnded, BlockStarted, Event, Telemetry
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import Observer
from pinel_desktop.execution.inputs import Capture, Pending
from pinel_desktop.execution.limits import StepLimit
from pinel_desktop.program.sensors import SENSORS
from pinel_desktop.robot import SimulationConfig
from pinel_desktop.runs.recorded_inputs import WireEvent, capture_of, typed_answer
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start

Path = NDArray[np.float64]
T = TypeVar("T")

EMPTY_ROOM = "empty_room"
MAX_TICKS = 600 * TICK_HZ
_NO_CHANCE = dict.fromkeys(
    (
        "wheel_bias_sd",
        "wheel_noise",
        "pose_noise_m",
        "pose_noise_rad",
        "sonar_noise",
        "lidar_noise_m",
    ),
    0.0,
)
# a program that only calculates ends soon: the judge's process answers other requests, too
_STEP_LIMIT = StepLimit(at_rest=100_000, total=300_000)


@dataclass(slots=True)
class Step:
    """One execution of a command that takes time: a motion, or a wait.

    Attributes:
        pointer, block, action, amount: as in the event `block_started`.
        start, end: ticks; `end` is None if the command did not come to its end.
    """

    pointer: str
    block: str | None
    action: str
    amount: float | None
    start: int
    end: int | None = None


@dataclass(frozen=True, slots=True)
class Prediction:
    """The predicted run.

    Attributes:
        path: true poses in the start frame, shape (n + 1, 3), m and rad; row i is tick i, the heading has no jumps.
        odometry: what the robot believes meanwhile, in the same form; of the ideal robot the same.
        steps: the executed steps.
        awaits_input: whether it ends at an input that nobody has given yet.
        is_cut: whether it ends because it is longer than `MAX_TICKS`.
        reads_sensors: whether the program measures the world around the robot, of which only the room is known.
        knows_room: whether the room could be simulated; the prediction is for an empty one otherwise.
    """

    path: Path
    odometry: Path
    steps: list[Step]
    awaits_input: bool
    is_cut: bool
    reads_sensors: bool
    knows_room: bool


class GivenInputs:
    """The inputs that people gave in a run, one for each wait; a missing one ends the prediction.

    Raises PinelError `run_damaged` for malformed events.
    """

    is_live = False

    def __init__(self, events: Iterable[WireEvent]) -> None:
        self.is_missing = False
        self._control = RunControl()
        self.gestures = _Given[Capture](self.end)
        self.answers = _Given[str](self.end)
        try:
            for event in events:
                if event["type"] == "answered":
                    self.answers.values.append(typed_answer(event["value"]))
                elif event["type"] == "gesture_result" and event["source"] == "capture":
                    self.gestures.values.append(capture_of(event))
        except (KeyError, TypeError) as error:
            raise PinelError("run_damaged", part="events") from error

    def attach(self, control: RunControl) -> Observer | None:
        self._control = control
        return None

    def end(self) -> None:
        """Ends the prediction."""
        self.is_missing = True
        self._control.stop()


class _Given(Generic[T]):
    def __init__(self, at_end: Any) -> None:
        self.values: deque[T] = deque()
        self._at_end, self._is_due = at_end, False

    def begin(self, question: str) -> None:
        self._is_due = False

    def poll(self) -> T | Pending:
        if self._is_due and self.values:
            return self.values.popleft()
        if self._is_due:
            self._at_end()
        self._is_due = True
        return Pending.TICK

    def cancel(self) -> None:
        return


class StepLog:
    """Collects the steps of a run from its events."""

    def __init__(self) -> None:
        self.steps: list[Step] = []

    def start(self, tick: int, step: Mapping[str, Any]) -> None:
        """Adds a `block_started`, as its fields."""
        if step["amount"] is not None or step["action"] in _TO_A_PLACE:
            self.steps.append(Step(**{name: step[name] for name in _STEP_FIELDS}, start=tick))

    def end(self, tick: int, pointer: str) -> None:
        """Adds a `block_ended`."""
        if self.steps and self.steps[-1].end is None and self.steps[-1].pointer == pointer:
            self.steps[-1].end = tick


_TO_A_PLACE = ("go_to", "go_to_place")  # their amount is not known before
_STEP_FIELDS = ("pointer", "block", "action", "amount")


def steps_of(events: Iterable[WireEvent]) -> list[Step]:
    """Returns the steps of a recorded run."""
    log = StepLog()
    for event in events:
        if event["type"] == BlockStarted.type:
            log.start(event["tick"], event)
        elif event["type"] == BlockEnded.type:
            log.end(event["tick"], event["pointer"])
    return log.steps


def predict(spec: RunSpec, events: Iterable[WireEvent]) -> Prediction:
    """Predicts the run of a real robot.

    Args:
        spec: the run's spec with the profile of its robot; its inputs are ignored.
        events: the run's events so far, in wire format.

    Raises:
        PinelError: what `start` raises before the robot moves, and `GivenInputs`.
    """
    inputs = GivenInputs(events)
    exact = replace(
        spec, link="sim", pace="max", inputs=inputs, setting=without_chance(spec.setting)
    )
    log = _PredictionLog()
    knows_room = True
    try:
        start(exact, log.observe, log.control, step_limit=_STEP_LIMIT)
    except PinelError as error:
        if error.code not in ("world_invalid", "unknown_world"):
            raise
        knows_room = False
        start(replace(exact, world=EMPTY_ROOM), log.observe, log.control, step_limit=_STEP_LIMIT)
    return Prediction(
        unwrapped(np.array(log.true)),
        unwrapped(np.array(log.believed)),
        log.steps,
        inputs.is_missing,
        log.is_cut,
        reads_world(spec.document),
        knows_room,
    )


def without_chance(setting: SimulationConfig) -> SimulationConfig:
    """Returns the setting of a robot with the same systematic errors, and none by chance."""
    if setting.preset == "ideal":
        return setting
    return replace(setting, parameters=replace(setting.parameters, **_NO_CHANCE))


class _PredictionLog(StepLog):
    def __init__(self) -> None:
        super().__init__()
        self.control, self.is_cut = RunControl(), False
        self.believed = [(0.0, 0.0, 0.0)]
        self.true = [(0.0, 0.0, 0.0)]

    def observe(self, tick: int, event: Event) -> None:
        if type(event) is Telemetry:
            believed = (event.x_m, event.y_m, event.yaw_rad)
            self.believed.append(believed)
            self.true.append(_true_pose(event) or believed)
            if tick >= MAX_TICKS and not self.is_cut:
                self.is_cut = True
                self.control.stop()
        elif type(event) is BlockStarted:
            self.start(tick, {name: getattr(event, name) for name in _STEP_FIELDS})
        elif type(event) is BlockEnded:
            self.end(tick, event.pointer)


def _true_pose(event: Telemetry) -> tuple[float, float, float] | None:
    if event.true_x_m is None or event.true_y_m is None or event.true_yaw_rad is None:
        return None
    return event.true_x_m, event.true_y_m, event.true_yaw_rad


def unwrapped(poses: Path) -> Path:
    """Returns poses whose heading counts full turns instead of jumping at half a turn."""
    return np.column_stack([poses[:, :2], np.unwrap(poses[:, 2])])


def reads_world(document: Any) -> bool:
    """Returns whether a document reads a sensor that measures the world around the robot."""
    if isinstance(document, dict):
        sensor = SENSORS.get(str(document.get("sensor")))
        return (sensor is not None and sensor.of_world) or any(map(reads_world, document.values()))
    return isinstance(document, list) and any(map(reads_world, document))
