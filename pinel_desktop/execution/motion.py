"""Closed-loop lines, arcs and turns on the spot, shared by the motion primitives."""

import math
from collections.abc import Callable

from pinel_desktop.control import (
    ApproachCheck,
    ArcTracker,
    Breakaway,
    LineTracker,
    ProgressCheck,
    hold_position,
    s_curve,
)
from pinel_desktop.control.goal import at_rest
from pinel_desktop.execution.clock import TICK_HZ, TICK_S
from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.execution.requests import Routine
from pinel_desktop.program.limits import MAX_RUN_S
from pinel_desktop.robot import STANDSTILL, Pose2D, Twist2D, wrap_angle

_BLOCKED_TICKS = 2 * TICK_HZ
_MOVE_STEP_M = 0.01
_TURN_STEP_RAD = math.radians(1.0)
_NEARLY_DONE_RAD = math.radians(5.0)
_BESIDE_M = 0.05  # cross-track error at the end of an arc; the next motion corrects less
# cross-track error of a straight motion that was pushed off its line; an arc before it may leave up
# to 0.05 m
_OFF_LINE_M = 0.1
_ALREADY_THERE_M = 1e-6
# Upper bounds of the speed added against static friction. The wheels of a robot that was never
# oiled stick below 0.03 m/s.
_BREAKAWAY_MPS, _BREAKAWAY_RADPS = 0.1, 0.6
_MIN_SPEED = 1e-6  # m/s, rad/s; a motion at this speed ends as blocked
_MAX_PROFILE_S = MAX_RUN_S + 60.0
_MAX_CACHED_S = 120.0


def _never() -> bool:
    return False


class _Setpoints:
    """The moving set-point of one motion; advances every tick. After a pause, plans again from the robot's position."""

    def __init__(
        self, context: RunContext, goal: float, plan: Callable[[float], tuple[float, ...]]
    ) -> None:
        self._context, self._goal, self._plan = context, goal, plan
        # Commands take effect late: the robot is expected behind the set-point by the delay.
        late = context.command_delay_s / TICK_S
        self._late_ticks = int(late)
        self._late_part = late - self._late_ticks
        self._start(0.0)

    def _start(self, done: float) -> None:
        self._n_resumed = self._context.n_resumed
        self._offset = done
        self._points = self._plan(self._goal - done)
        self._last = len(self._points) - 1
        self._index = 0
        self._before = self._now = 0.0

    def next(self, done: float) -> tuple[float, float, int]:
        """Expected position of the robot now, speed until the next tick, ticks since the end (negative before)."""
        if self._n_resumed != self._context.n_resumed:
            self._start(done)
        index, self._index = self._index, self._index + 1
        now, upcoming = self._now, self._at(index + 1)
        self._now = upcoming
        late = index - self._late_ticks
        if self._late_ticks:
            before, expected = self._at(late - 1), self._at(late)
        else:
            before, expected = self._before, now
            self._before = now
        expected = self._offset + expected - (expected - before) * self._late_part
        return expected, (upcoming - now) * TICK_HZ, late - self._last

    def _at(self, index: int) -> float:
        """The set-point at a tick, constant before its start and after its end."""
        return self._points[min(max(index, 0), self._last)]


class _SlideDetector:
    """Detects that an obstacle has pushed a straight motion off its line, and the robot comes no nearer to its goal.

    A robot that slides along a wall makes progress along its line, too, and ends beside the goal or beyond it.
    """

    def __init__(self, context: RunContext, line: LineTracker, distance_m: float) -> None:
        self._context, self._line, self._distance_m = context, line, distance_m
        self._goal = line.point(distance_m)
        self._start()

    def _start(self) -> None:
        self._n_resumed = self._context.n_resumed
        self._approach = ApproachCheck(_MOVE_STEP_M, _BLOCKED_TICKS)

    def is_beside(self) -> bool:
        """Returns whether the robot is off its line, farther than the controller alone would let it deviate."""
        return abs(self._line.across(self._context.pose)) > _OFF_LINE_M

    def is_stuck(self) -> bool:
        """Returns whether the robot is off its line and came no nearer to its goal for 2 s; called at every tick."""
        context = self._context
        if self._n_resumed != context.n_resumed:  # somebody may have moved the robot
            self._start()
        stuck = self._approach.stuck(context.pose.distance_to(self._goal), context.tick)
        return stuck and self.is_beside()

    def done_m(self, along_m: float) -> float:
        """Returns the completed part of the motion; off the line, how much nearer the robot came to its goal."""
        if not self.is_beside():
            return along_m
        nearer_m = max(abs(self._distance_m) - self._approach.nearest_m, 0.0)
        return math.copysign(nearer_m, self._distance_m)


def drive_straight(
    context: RunContext, distance_m: float, interrupted: Callable[[], bool] = _never
) -> Routine:
    """Drives from the reference along its heading, backwards for a negative distance; closed loop.

    Polls `interrupted()` at every tick; when it is true, ends early, at rest and without a reference. Raises
    RunFailureError `blocked`, also if the robot slides along an obstacle and does not reach its goal.
    """
    line = LineTracker(_begin(context), context.gains, context.trim)
    robot = context.robot

    def plan(rest_m: float) -> tuple[float, ...]:
        return _profile(rest_m, context.max_v_mps, robot.acceleration_mps2, robot.smoothing_s)

    setpoints = _Setpoints(context, distance_m, plan)
    progress = ProgressCheck(_MOVE_STEP_M, _BLOCKED_TICKS)
    sliding = _SlideDetector(context, line, distance_m)
    breakaway = Breakaway(context.goals.move, _breakaway_limit(context, _BREAKAWAY_MPS), TICK_S)
    while True:
        along = line.along(context.pose)
        expected, speed, past_end = setpoints.next(along)
        if (
            past_end >= 0
            and breakaway.is_reached(distance_m - along, context.twist, past_end)
            and not sliding.is_beside()
        ):
            break
        stuck = progress.stuck(along, context.tick), sliding.is_stuck(), breakaway.is_hopeless
        if any(stuck):
            done_m = round(sliding.done_m(along), 3)
            raise RunFailureError("blocked", done=done_m, amount=distance_m, unit="m")
        if interrupted():
            context.reference_lost = True
            yield from come_to_rest(context)
            return None
        v, omega = line.correct(context.pose, expected - along, speed)
        v += breakaway.more(distance_m - along, context.twist, past_end)
        context.command = Twist2D(v, omega)
        if context.observed:
            context.setpoint = line.point(expected)
            context.done = sliding.done_m(along)
        yield None
    _end(context, line.point(distance_m))
    return None


def turn_on_the_spot(context: RunContext, angle_rad: float) -> Routine:
    """Turns by the angle, left if positive, also by more than a full circle; closed loop.

    Raises RunFailureError `blocked`.
    """
    yield from rest_first(context)
    start = _begin(context)
    robot, gains = context.robot, context.gains

    def plan(rest_rad: float) -> tuple[float, ...]:
        return _profile(
            rest_rad, context.max_omega_radps, robot.angular_acceleration_radps2, robot.smoothing_s
        )

    setpoints = _Setpoints(context, angle_rad, plan)
    progress = ProgressCheck(_TURN_STEP_RAD, _BLOCKED_TICKS)
    breakaway = Breakaway(context.goals.turn, _breakaway_limit(context, _BREAKAWAY_RADPS), TICK_S)
    turned, yaw = 0.0, start.yaw_rad
    while True:
        turned += wrap_angle(context.pose.yaw_rad - yaw)
        yaw = context.pose.yaw_rad
        expected, speed, past_end = setpoints.next(turned)
        if past_end >= 0 and breakaway.is_reached(angle_rad - turned, context.twist, past_end):
            break
        if progress.stuck(turned, context.tick) or breakaway.is_hopeless:
            raise _blocked_turn(turned, angle_rad)
        # wheels without slip need no correction of the position
        v = hold_position(start, context.pose, gains) if gains.integral else 0.0
        more = breakaway.more(angle_rad - turned, context.twist, past_end)
        context.command = Twist2D(v, speed + gains.yaw * (expected - turned) + more)
        if context.observed:
            context.setpoint = start._replace(yaw_rad=wrap_angle(start.yaw_rad + expected))
            context.done = math.degrees(turned)
        yield None
    _end(context, start._replace(yaw_rad=wrap_angle(start.yaw_rad + angle_rad)))
    return None


def drive_arc(context: RunContext, radius_m: float, angle_rad: float) -> Routine:
    """Drives a circular arc until the heading has changed by the angle; closed loop.

    The centre is on the left for a positive angle and on the right for a negative one. A negative radius is driven
    backwards, with the centre on the other side. The set-point's speed follows an S-curve within the limits of both
    velocities. Raises RunFailureError `blocked` or `blocked_beside`.
    """
    yield from rest_first(context)
    arc = ArcTracker(_begin(context), radius_m, angle_rad, context.gains, context.trim)
    robot, length = context.robot, abs(radius_m)

    def plan(rest_rad: float) -> tuple[float, ...]:
        omega, alpha = context.max_omega_radps, robot.angular_acceleration_radps2
        if length > 0.0:
            omega = min(omega, context.max_v_mps / length)
            alpha = min(alpha, robot.acceleration_mps2 / length)
        return _profile(rest_rad, omega, alpha, robot.smoothing_s)

    setpoints = _Setpoints(context, angle_rad, plan)
    progress = ProgressCheck(_TURN_STEP_RAD, _BLOCKED_TICKS)
    path_progress = ProgressCheck(_MOVE_STEP_M, _BLOCKED_TICKS)
    move = Breakaway(context.goals.move, _breakaway_limit(context, _BREAKAWAY_MPS), TICK_S)
    turn = Breakaway(context.goals.turn, _breakaway_limit(context, _BREAKAWAY_RADPS), TICK_S)
    while True:
        done = arc.done(context.pose)
        expected, speed, past_end = setpoints.next(done)
        along_m, across_m, yaw_error = arc.errors(context.pose, expected)
        if (
            past_end >= 0
            and move.is_reached(along_m, context.twist, past_end)
            and turn.is_reached(yaw_error, context.twist, past_end)
            and abs(across_m) <= _BESIDE_M
        ):
            break
        stuck = progress.stuck(done, context.tick), path_progress.stuck(done * length, context.tick)
        if all(stuck) or move.is_hopeless or turn.is_hopeless:
            raise _blocked_arc(context, arc, done, angle_rad)
        v, omega = arc.correct(context.pose, expected, speed)
        v += move.more(along_m, context.twist, past_end)
        context.command = Twist2D(v, omega + turn.more(yaw_error, context.twist, past_end))
        if context.observed:
            context.setpoint, context.done = arc.point(expected), math.degrees(done)
        yield None
    _end(context, arc.point(angle_rad))
    return None


def _breakaway_limit(context: RunContext, breakaway: float) -> float:
    """Returns the upper bound of the speed added against static friction; 0 for a simulated robot, which has none."""
    return breakaway if context.goals.sticks else 0.0


def drive_to(
    context: RunContext, x_m: float, y_m: float, interrupted: Callable[[], bool] = _never
) -> Routine:
    """Turns by the smaller angle towards a point of the start frame (m), and drives there.

    `interrupted` and errors as for `drive_straight`.
    """
    yield from rest_first(context)
    here = _begin(context)
    distance = math.hypot(x_m - here.x_m, y_m - here.y_m)
    if distance < _ALREADY_THERE_M:
        _end(context, here)
        return None
    yield from turn_on_the_spot(context, wrap_angle(_direction(here, x_m, y_m) - here.yaw_rad))
    yield from drive_straight(context, distance, interrupted)
    return None


def _direction(here: Pose2D, x_m: float, y_m: float) -> float:
    return math.atan2(y_m - here.y_m, x_m - here.x_m)


def set_velocity(context: RunContext, twist: Twist2D) -> None:
    """Sets a velocity, clamped to the limits of the run, until the next motion."""
    v, omega = context.max_v_mps, context.max_omega_radps
    context.driving = Twist2D(
        min(max(twist.v_mps, -v), v), min(max(twist.omega_radps, -omega), omega)
    )
    context.command = context.driving
    context.reference_lost = True


def come_to_rest(context: RunContext) -> Routine:
    """Commands zero velocity until the measured velocity is zero, for at most two seconds."""
    context.driving = None
    for waited in range(_BLOCKED_TICKS):
        context.command = STANDSTILL
        if waited > 0 and at_rest(context.twist):
            break
        yield None
    return None


def _profile(
    rest: float, speed: float, acceleration: float, smoothing_s: float
) -> tuple[float, ...]:
    """Returns the S-curve of the rest of a motion, cut to the longest duration of a run.

    Stop waits while a profile is computed, so planning a long slow motion must not take seconds.
    """
    speed = max(speed, _MIN_SPEED)
    max_rest = speed * _MAX_PROFILE_S
    # long plans are not cached: they are large and rarely repeated
    curve = s_curve if abs(rest) < speed * _MAX_CACHED_S else s_curve.__wrapped__
    return curve(min(max(rest, -max_rest), max_rest), speed, acceleration, smoothing_s, TICK_S)


def rest_first(context: RunContext) -> Routine:
    """After `drive`, stops the robot before the next motion: a moving robot would leave its reference."""
    if context.reference_lost:
        yield from come_to_rest(context)
    return None


def _begin(context: RunContext) -> Pose2D:
    """Start of the next motion: the goal of the last one, or the measured pose if the reference was lost."""
    context.driving = None
    if context.reference_lost:
        context.reference_lost = False
        context.reference = context.pose
    return context.reference


def _end(context: RunContext, goal: Pose2D) -> None:
    context.reference = context.setpoint = goal
    context.command = STANDSTILL


def _blocked_turn(turned_rad: float, angle_rad: float) -> RunFailureError:
    done, amount = round(math.degrees(turned_rad), 1), round(math.degrees(angle_rad), 6)
    return RunFailureError("blocked", done=done, amount=amount, unit="°")


def _blocked_arc(
    context: RunContext, arc: ArcTracker, done_rad: float, angle_rad: float
) -> RunFailureError:
    """Returns the failure of an arc.

    If the angle is nearly done but the end is far, the robot was pushed off its circle: reports that distance.
    """
    away_m = context.pose.distance_to(arc.point(angle_rad))
    if abs(angle_rad - done_rad) > _NEARLY_DONE_RAD or away_m <= _BESIDE_M:
        return _blocked_turn(done_rad, angle_rad)
    params = {"done": round(math.degrees(done_rad), 1), "amount": round(math.degrees(angle_rad), 6)}
    return RunFailureError("blocked_beside", **params, unit="°", away=round(away_m, 2))
