"""The only way to execute a run: the engine, `pinel run`, verification and the activities' checks use it."""

import contextlib
import gc
import math
from collections.abc import Callable, Iterator

from pinel_desktop.control.goal import GOALS, Goals
from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Event
from pinel_desktop.execution.clock import WALL_TIME, Clock, LiveClock, UnpacedClock, WallTime
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import Observer, RunOptions, RunResult, execute
from pinel_desktop.execution.limits import StepLimit
from pinel_desktop.links import open_link
from pinel_desktop.program.model import Program
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import RobotLink, RobotModel
from pinel_desktop.runs.spec import RunSpec

# people's actions in a recorded run take no time in its replay
_NO_TIME = WallTime(now=lambda: 0.0, sleep=lambda seconds: None)


def start(
    spec: RunSpec,
    observer: Observer | None = None,
    control: RunControl | None = None,
    *,
    wall: WallTime = WALL_TIME,
    step_limit: StepLimit | None = None,
    on_link: Callable[[RobotLink], None] = lambda link: None,
) -> RunResult:
    """Executes a run to its end, on the calling thread.

    Args:
        observer: called with every event.
        control: lets other threads pause, stop and inspect the run.
        wall: wall-clock time, for live ticks and for people's inputs.
        step_limit: ends a run that nobody watches; None for no limit.
        on_link: called with the run's link before it connects.

    Raises:
        PinelError: before the robot moves, what reading the document and opening the link raise: `invalid_program`,
            `unknown_link`, `unknown_robot`, `unknown_world`. Later errors become the outcome of the run.
    """
    control = control or RunControl()
    program = spec.program or _read(spec)
    link = open_link(
        spec.link, world=spec.world, setting=spec.setting, seed=spec.seed, robot=spec.robot
    )
    on_link(link)
    options = RunOptions(
        observer=all_of(observer, spec.inputs.attach(control)),
        clock=_clock(spec, link, control, wall),
        control=control,
        wall=wall if spec.inputs.is_live or spec.pace == "live" else _NO_TIME,
        inputs=spec.inputs,
        seed=spec.seed,
        robot=_model(spec),
        goals=_goals(spec),
        semantics=spec.semantics,
        step_limit=step_limit,
    )
    with _frozen_garbage() if spec.pace == "live" else contextlib.nullcontext():
        return execute(program, link, options)


def _read(spec: RunSpec) -> Program:
    reading = read_document(spec.document)
    if reading.program is None:
        raise PinelError("invalid_program", count=len(reading.faults))
    return reading.program


def _model(spec: RunSpec) -> RobotModel:
    model = spec.setting.robot
    return model if spec.robot is None else spec.robot.limited(model)


def _goals(spec: RunSpec) -> Goals:
    robot = spec.robot
    if robot is None:
        return GOALS
    return GOALS.widened(robot.move_tolerance_m, math.radians(robot.turn_tolerance_deg))


def _clock(spec: RunSpec, link: RobotLink, control: RunControl, wall: WallTime) -> Clock:
    """Returns the clock of the run. Only the simulator has a variable speed."""
    if not link.simulated:
        return LiveClock(wall)
    return UnpacedClock() if spec.pace == "max" else LiveClock(wall, speed=lambda: control.pace)


def all_of(*observers: Observer | None) -> Observer | None:
    """Returns one observer that calls all given observers; None without any, which is faster."""
    there = [observer for observer in observers if observer is not None]
    if len(there) < 2:
        return there[0] if there else None

    def observe(tick: int, event: Event) -> None:
        for observer in there:
            observer(tick, event)

    return observe


@contextlib.contextmanager
def _frozen_garbage() -> Iterator[None]:
    """Exempts existing objects from garbage collection: scanning a long program takes several ticks."""
    gc.freeze()
    try:
        yield
    finally:
        gc.unfreeze()
