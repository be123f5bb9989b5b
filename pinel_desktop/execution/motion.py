"""Driving a line and turning on the spot: what the motion primitives have in common."""

import math
from collections.abc import Callable, Iterator

from pinel_desktop.control import DEFAULT_GAINS, Line, ProgressCheck, s_curve
from pinel_desktop.control.goal import MOVE_GOAL, TURN_GOAL, GoalCheck
from pinel_desktop.execution.clock import TICK_HZ, TICK_S
from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.robot import STANDSTILL, Pose2D, Twist2D, wrap_angle

_BLOCKED_TICKS = 2 * TICK_HZ
_MOVE_STEP_M = 0.01
_TURN_STEP_RAD = math.radians(1.0)
_AT_REST_MPS, _AT_REST_RADPS = 1e-3, 2e-3


class _Setpoints:
    """The moving set-point of one motion, one step a tick, planned anew from where the robot is after a pause."""

    def __init__(
        self, context: RunContext, goal: float, plan: Callable[[float], tuple[float, ...]]
    ) -> None:
        self._context, self._goal, self._plan = context, goal, plan
        # A command acts a moment late: at a tick the robot is expected that much behind the set-point.
        self._lag = context.command_delay_s / TICK_S
        self._start(0.0)

    def _start(self, done: float) -> None:
        self._n_resumed = self._context.n_resumed
        self._offset = done
        self._points = self._plan(self._goal - done)
        self._last = len(self._points) - 1
        self._index = 0
        self._previous = self._now = 0.0

    def next(self, done: float) -> tuple[float, float, int]:
        """Where the robot is expected now, how fast it is to go until the next tick, ticks past the end."""
        if self._n_resumed != self._context.n_resumed:
            self._start(done)
        now, index, last = self._now, self._index + 1, self._last
        expected = self._offset + now - (now - self._previous) * self._lag
        upcoming = self._points[index if index < last else last]
        self._previous, self._now, self._index = now, upcoming, index
        return expected, (upcoming - now) * TICK_HZ, index - last - 1


def drive_straight(context: RunContext, distance_m: float) -> Iterator[None]:
    """Drives from the reference along its heading, backwards for a negative distance; closed loop."""
    line = Line(_reference(context), DEFAULT_GAINS)
    robot = context.robot

    def plan(rest_m: float) -> tuple[float, ...]:
        return s_curve(
            rest_m, robot.start_v_mps, robot.acceleration_mps2, robot.smoothing_s, TICK_S
        )

    setpoints = _Setpoints(context, distance_m, plan)
    progress = ProgressCheck(_MOVE_STEP_M, _BLOCKED_TICKS)
    while True:
        along = line.along(context.pose)
        expected, speed, past_end = setpoints.next(along)
        if past_end >= 0 and _arrived(context, MOVE_GOAL, distance_m - along, past_end):
            break
        if progress.stuck(along, context.tick):
            raise RunFailureError("blocked", done=round(along, 3), amount=distance_m, unit="m")
        context.command = line.correct(context.pose, expected - along, speed)
        if context.observed:
            context.setpoint, context.done = line.point(expected), along
        yield
    context.reference = context.setpoint = line.point(distance_m)
    context.command = STANDSTILL


def turn_on_the_spot(context: RunContext, angle_rad: float) -> Iterator[None]:
    """Turns by the whole angle in its sign's direction, also beyond a full circle; closed loop."""
    start = _reference(context)
    robot = context.robot

    def plan(rest_rad: float) -> tuple[float, ...]:
        return s_curve(
            rest_rad,
            robot.start_omega_radps,
            robot.angular_acceleration_radps2,
            robot.smoothing_s,
            TICK_S,
        )

    setpoints = _Setpoints(context, angle_rad, plan)
    progress = ProgressCheck(_TURN_STEP_RAD, _BLOCKED_TICKS)
    turned, yaw = 0.0, start.yaw_rad
    while True:
        turned += wrap_angle(context.pose.yaw_rad - yaw)
        yaw = context.pose.yaw_rad
        expected, speed, past_end = setpoints.next(turned)
        if past_end >= 0 and _arrived(context, TURN_GOAL, angle_rad - turned, past_end):
            break
        if progress.stuck(turned, context.tick):
            done = round(math.degrees(turned), 1)
            amount = round(math.degrees(angle_rad), 6)
            raise RunFailureError("blocked", done=done, amount=amount, unit="°")
        context.command = Twist2D(0.0, speed + DEFAULT_GAINS.yaw * (expected - turned))
        if context.observed:
            context.setpoint = start._replace(yaw_rad=wrap_angle(start.yaw_rad + expected))
            context.done = math.degrees(turned)
        yield
    context.reference = start._replace(yaw_rad=wrap_angle(start.yaw_rad + angle_rad))
    context.setpoint, context.command = context.reference, STANDSTILL


def come_to_rest(context: RunContext) -> Iterator[None]:
    """Commands standstill until the robot is measured to stand, for at most two seconds."""
    for waited in range(_BLOCKED_TICKS):
        context.command = STANDSTILL
        if waited > 0 and at_rest(context.twist):
            return
        yield


def at_rest(twist: Twist2D) -> bool:
    """Whether a measured twist is standstill."""
    return abs(twist.v_mps) < _AT_REST_MPS and abs(twist.omega_radps) < _AT_REST_RADPS


def _arrived(context: RunContext, goal: GoalCheck, error: float, ticks_past_end: int) -> bool:
    return goal.arrived(error, ticks_past_end) and at_rest(context.twist)


def _reference(context: RunContext) -> Pose2D:
    """Where the next motion begins: the goal of the last one, unless the robot was moved since."""
    if context.moved_by_hand:
        context.moved_by_hand = False
        context.reference = context.pose
    return context.reference
