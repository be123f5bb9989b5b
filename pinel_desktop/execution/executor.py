"""The executor runs a program on a link: commands until one needs time, then a tick of 1/30 s, repeated to the end."""

from collections.abc import Callable
from dataclasses import dataclass, field
from random import Random
from typing import Any, Literal

from pinel_desktop.control import DEFAULT_GAINS, SLIPPING_GAINS, Gains
from pinel_desktop.control.goal import GOALS, Goals, at_rest
from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import (
    CommandsAwaited,
    Event,
    GestureResult,
    Marked,
    RunEnded,
    RunState,
    Telemetry,
)
from pinel_desktop.execution.await_commands import MOVED_BY_HAND_M, await_commands
from pinel_desktop.execution.clock import TICK_HZ, TICK_S, WALL_TIME, Clock, UnpacedClock, WallTime
from pinel_desktop.execution.context import RunContext, RunFailureError, Sources
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.debug.debugger import Debugger
from pinel_desktop.execution.debug.inspection import process_evaluations
from pinel_desktop.execution.debug.sensor_stream import SensorStream
from pinel_desktop.execution.debug.variable_watch import VariableWatch
from pinel_desktop.execution.inputs import Inputs, ScriptedInputs
from pinel_desktop.execution.limits import StepLimit
from pinel_desktop.execution.recorder import TelemetryRecorder
from pinel_desktop.execution.semantics import CURRENT
from pinel_desktop.execution.stack import ProgramStack
from pinel_desktop.program.limits import MAX_RUN_S, MAX_STEPS_PER_TICK
from pinel_desktop.program.model import Program
from pinel_desktop.robot import PIONEER_3DX, STANDSTILL, Pose2D, RobotLink, RobotModel, RobotState

Outcome = Literal["finished", "stopped", "failed"]
# (tick, event); tick 0 is the time before the first tick
Observer = Callable[[int, Event], None]

_MAX_TICKS = round(MAX_RUN_S * TICK_HZ)
_REST_TICKS = TICK_HZ
_APP_LOST_S = 2.0
_NOWHERE = (None, None, None)
_WITHOUT_REST = ("link_lost", "internal_error", "time_limit")


class _Stopped(Exception):  # noqa: N818 - not an error
    """Stop was requested."""


@dataclass(frozen=True, slots=True)
class RunResult:
    """Outcome of a run: the closing event, and further values that `pinel run` prints; variables as JSON data."""

    ended: RunEnded
    telemetry: TelemetryRecorder
    gesture_result: str
    shown_texts: list[str]
    marks: list[Marked]
    n_beeps: int
    variables: dict[str, Any]


@dataclass(frozen=True, slots=True)
class RunOptions:
    """Options of a run; the defaults suit a headless run without observer.

    Attributes:
        observer: called with every event; without one no events are created, which is faster.
        clock: paces the ticks.
        control: requests of other threads.
        wall: wall-clock time, for inputs of people.
        inputs: results of captures, answers to questions.
        seed: seed of the run's random generator.
        robot: dimensions and limits of the robot.
        gains: gains of the controller; None for the link's defaults.
        goals: goal tolerances and settle times of motions.
        semantics: version of the meaning of commands and sensors (`semantics.py`).
        step_limit: ends a run that only calculates, as failed, reason `too_busy`; None for no limit.
    """

    observer: Observer | None = None
    clock: Clock = field(default_factory=UnpacedClock)
    control: RunControl = field(default_factory=RunControl)
    wall: WallTime = WALL_TIME
    inputs: Inputs = field(default_factory=ScriptedInputs)
    seed: int = 0
    robot: RobotModel = PIONEER_3DX
    gains: Gains | None = None
    goals: Goals = GOALS
    semantics: int = CURRENT
    step_limit: StepLimit | None = None


def execute(program: Program, link: RobotLink, options: RunOptions | None = None) -> RunResult:
    """Runs `program` to its end on `link`; connects the link first and closes it last.

    Every exit path commands zero velocity. Errors become the outcome `failed` with a reason; only errors of the
    observer at the closing event are raised.
    """
    return _Run(program, link, options or RunOptions()).to_the_end()


class _Run:
    def __init__(self, program: Program, link: RobotLink, options: RunOptions) -> None:
        self._link, self._observer = link, options.observer
        self._clock, self._wall, self._control = options.clock, options.wall, options.control
        self._recorder = TelemetryRecorder()
        self._origin: Pose2D | None = None
        self._tick = 0
        self._context = RunContext(
            options.robot,
            link.command_delay_s,
            Sources(
                options.inputs.gestures, options.inputs.answers, link.sensors, Random(options.seed)
            ),
            self._emit,
            observed=options.observer is not None,
            gains=options.gains or (SLIPPING_GAINS if link.slips else DEFAULT_GAINS),
            goals=options.goals,
            semantics=options.semantics,
        )
        self._stack = ProgramStack(program, self._context)
        self._step_limit, self._moved_at_step = options.step_limit, 0
        observed = options.observer is not None
        self._watcher = VariableWatch(self._context, self._stack) if observed else None
        self._sensor_stream: SensorStream | None = None
        self._debugger = Debugger(options.control, lambda: len(self._stack.calls))
        if observed:
            self._stack.should_pause = self._debugger.should_pause

    def _emit(self, event: Event) -> None:
        if self._observer is not None:
            self._observer(self._tick, event)

    def to_the_end(self) -> RunResult:
        state, reason, params = self._outcome()
        self._report()
        self._watch()
        block = self._stack.block if state != "finished" else None
        self._stack.close()
        reason, params = self._end_at_standstill(reason, params)
        if self._sensor_stream is not None:
            self._sensor_stream.report_boxes()
        self._link.close()
        if reason is not None and state == "finished":
            state = "failed"
        ended = self._ended(state, reason, params, block)
        self._emit(ended)
        result, output = self._context.gesture_result, self._context.output
        variables = self._context.variables.global_values()
        outputs = (output.shown_texts, output.marks, output.n_beeps)
        return RunResult(ended, self._recorder, result, *outputs, variables)

    def _outcome(self) -> tuple[Outcome, str | None, dict[str, Any]]:
        try:
            self._connect()
            self._run()
        except _Stopped:
            return "stopped", self._control.stop_reason, {"tick": self._tick}
        except PinelError as error:
            return "failed", error.code, error.params
        except Exception as error:
            # even a defect of PINEL must lead to the zero velocity below
            return "failed", "internal_error", {"detail": f"{type(error).__name__}: {error}"}
        return "finished", None, {}

    def _connect(self) -> None:
        self._link.connect(self._stop_requested)
        if self._control.stop_requested:
            raise _Stopped
        # only a connected link knows the robot's delay
        if not self._link.simulated:
            self._context.adapt_to(self._link.command_delay_s)
        start = self._link.read()
        self._origin = None if start.pose == Pose2D() else start.pose
        self._context.origin = start.pose
        self._recorder.true_start = start.true_pose and start.true_pose[:2]
        self._update_state(start)
        self._emit(RunState("running"))
        if self._observer is not None:
            self._sensor_stream = SensorStream(self._context, self._link, self._control)

    def _update_state(self, state: RobotState) -> None:
        pose = state.pose
        self._context.pose = pose if self._origin is None else pose.relative_to(self._origin)
        self._context.twist = state.twist

    def _run(self) -> None:
        control, stack, clock = self._control, self._stack, self._clock
        watcher, stop_requested = self._watcher, self._stop_requested
        while True:
            if control.pause_requested or control.keepalive_expired:
                self._pause_before_tick()
            stack.is_open = control.is_open
            time_needed = stack.run_until_time(MAX_STEPS_PER_TICK, stop_requested)
            if stack.awaits_commands:
                if not self._await_commands():
                    return
                continue
            self._report()
            if watcher is not None:
                watcher.report()
            self._raise_if_stopped()
            if stack.is_paused:
                continue  # the debugger has requested a pause
            if stack.awaits_person:
                self._await_person()
            elif time_needed:
                clock.wait_for_tick()
                self._pass_tick()
            elif stack.finished:
                return

    def _pause_before_tick(self) -> None:
        """Pauses the run, or waits for the app.

        A pause while an open run awaits commands takes effect before the first tick of the next commands, as in a
        replay.
        """
        if self._control.pause_requested and not self._stack.awaits_commands:
            self._pause()
        if self._control.keepalive_expired and not self._link.simulated:
            self._wait_for_app()

    def _raise_if_stopped(self) -> None:
        """Raises _Stopped, or RunFailureError `too_busy`."""
        if self._control.stop_requested:
            raise _Stopped
        limit, n_steps = self._step_limit, self._stack.n_steps
        if limit is None:
            return
        if not at_rest(self._context.twist):
            self._moved_at_step = n_steps
        if n_steps > limit.total or n_steps - self._moved_at_step > limit.at_rest:
            raise RunFailureError("too_busy", value=n_steps)

    def _stop_requested(self) -> bool:
        return self._control.stop_requested

    def _report(self) -> None:
        """Reports, once a tick, values that a loop without motion may change a thousand times."""
        context = self._context
        if "pen" in context.unreported:
            context.output.report_pen()
        if "result" in context.unreported:
            self._emit(GestureResult(context.gesture_result, "block"))
        context.unreported.clear()

    def _watch(self) -> None:
        if self._watcher is not None:
            self._watcher.report(now=True)

    def _pass_tick(self) -> None:
        context = self._context
        if self._tick >= _MAX_TICKS:
            raise RunFailureError("time_limit", max=MAX_RUN_S)
        link, command = self._link, context.command
        link.command(command)
        link.advance(TICK_S)
        self._tick = tick = self._tick + 1
        context.tick = tick + 1
        pose, twist, true_pose = link.read()
        if true_pose is not None and true_pose is not pose:
            self._recorder.add_true(true_pose[:2])
        if self._origin is not None:
            pose = pose.relative_to(self._origin)
        context.pose, context.twist = pose, twist
        self._recorder.add((tick, *pose, *twist, *command))
        if self._observer is not None:
            self._emit_tick(true_pose)

    def _emit_tick(self, true_pose: Pose2D | None) -> None:
        context = self._context
        if true_pose is not None and self._origin is not None:
            true_pose = true_pose.relative_to(self._origin)
        self._emit(
            Telemetry(
                *context.pose,
                *context.twist,
                *context.command,
                *(context.setpoint if context.driving is None else context.pose),
                context.done,
                self._link.bumper(),
                *(true_pose or _NOWHERE),
            )
        )
        if self._sensor_stream is not None:
            self._sensor_stream.report()

    def _await_person(self) -> None:
        """Waits for a tick of real time. In a simulator robot time stops; a real robot's ticks continue."""
        self._watch()
        if self._control.pause_requested:
            return
        start_s = self._wall.now()
        if self._link.simulated:
            self._idle_in_real_time()
        else:
            self._clock.wait_for_tick()
            self._pass_tick()
        self._context.waited_s += self._wall.now() - start_s

    def _await_commands(self) -> bool:
        """Waits for more commands at the end of an open run's program; returns False when the run ends there."""
        context, simulated = self._context, self._link.simulated
        self._emit(CommandsAwaited(self._stack.n_executed, context.gesture_result))
        wait = self._idle_in_real_time if simulated else self._idle_one_tick
        return await_commands(self._stack, context, self._control, wait, simulated=simulated)

    def _idle_in_real_time(self) -> None:
        """Lets a tick of real time pass; robot time stops."""
        self._wall.sleep(TICK_S)
        if self._sensor_stream is not None:
            self._sensor_stream.report_new_subscriptions()

    def _idle_one_tick(self) -> None:
        if self._control.keepalive_expired:
            self._wait_for_app()
        self._context.command = STANDSTILL
        self._clock.wait_for_tick()
        self._pass_tick()

    def _pause(self) -> None:
        """Stops the robot until resume or stop. In a simulator robot time stops, too, once the robot is at rest."""
        context = self._context
        self._watch()
        self._debugger.paused()
        debugger = self._debugger
        self._emit(RunState("paused", debugger.cause, self._stack.next_block, debugger.n_started))
        context.command = STANDSTILL
        self._settle()
        before = context.pose
        while self._control.pause_requested and not self._control.stop_requested:
            self._clock.wait_for_tick()
            process_evaluations(self._control, context)
            if self._sensor_stream is not None:
                self._sensor_stream.report_new_subscriptions()
            self._link.command(STANDSTILL)
            if not self._link.simulated:
                self._link.advance(TICK_S)
                self._update_state(self._link.read())
        if self._control.stop_requested:
            raise _Stopped
        if context.pose.distance_to(before) > MOVED_BY_HAND_M:
            context.reference_lost = True
        if context.driving is not None:
            context.command = context.driving
        context.n_resumed += 1
        self._debugger.resumed()
        self._emit(RunState("running"))

    def _wait_for_app(self) -> None:
        """Stops the robot while keepalives of the app are missing: a person could not stop it.

        Raises RunFailureError `app_silent` after 2 s.
        """
        context, due_s = self._context, self._wall.now() + _APP_LOST_S
        while self._control.keepalive_expired and not self._control.stop_requested:
            if self._wall.now() > due_s:
                raise RunFailureError("app_silent")
            self._link.command(STANDSTILL)
            self._clock.wait_for_tick()
            self._update_state(self._link.read())
        context.n_resumed += 1  # a motion plans its remainder again

    def _settle(self) -> None:
        for _ in range(_REST_TICKS):
            self._clock.wait_for_tick()
            self._pass_tick()
            if at_rest(self._context.twist):
                return

    def _end_at_standstill(
        self, reason: str | None, params: dict[str, Any]
    ) -> tuple[str | None, dict[str, Any]]:
        """Commands zero velocity at the end of every run, even before the first motion."""
        self._context.command = STANDSTILL
        try:
            self._link.command(STANDSTILL)
            if 0 < self._tick < _MAX_TICKS and reason not in _WITHOUT_REST:
                self._settle()
        except PinelError as error:
            return reason or error.code, params or error.params
        return reason, params

    def _ended(
        self, state: Outcome, reason: str | None, params: dict[str, Any], block: str | None
    ) -> RunEnded:
        recorder, link = self._recorder, self._link
        pose = recorder.last_pose()
        return RunEnded(
            state=state,
            reason=reason,
            params=params,
            block=block,
            n_executed=self._stack.n_executed,
            duration_s=self._tick / TICK_HZ,
            pose={"x_m": pose.x_m, "y_m": pose.y_m, "yaw_rad": pose.yaw_rad},
            telemetry_sha256=recorder.sha256(),
            **recorder.distances(
                simulated=link.simulated, semantics=self._context.semantics
            )._asdict(),
        )
