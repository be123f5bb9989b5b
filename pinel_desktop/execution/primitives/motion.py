"""Lines, turns, arcs, velocities and stopping; distances in m, angles in degrees."""

import math

from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.execution.motion import (
    come_to_rest,
    drive_arc,
    drive_straight,
    drive_to,
    set_velocity,
    turn_on_the_spot,
)
from pinel_desktop.execution.places import middle_of
from pinel_desktop.execution.primitives.base import instant, timed
from pinel_desktop.execution.requests import Routine
from pinel_desktop.program.model import (
    Arc,
    Drive,
    GoTo,
    GoToPlace,
    MoveBackward,
    MoveForward,
    SetSpeed,
    Stop,
    Turn,
)
from pinel_desktop.robot import Twist2D


@timed("move_forward", "distance", amount=lambda distance: distance)
def move_forward(context: RunContext, _command: MoveForward, distance: float) -> Routine:
    return drive_straight(context, distance)


@timed("move_backward", "distance", amount=lambda distance: -distance)
def move_backward(context: RunContext, _command: MoveBackward, distance: float) -> Routine:
    return drive_straight(context, -distance)


@timed("turn", "angle", amount=lambda angle: angle)
def turn(context: RunContext, _command: Turn, angle: float) -> Routine:
    return turn_on_the_spot(context, math.radians(angle))


@timed("arc", "radius", "angle", amount=lambda _radius, angle: angle)
def arc(context: RunContext, _command: Arc, radius: float, angle: float) -> Routine:
    return drive_arc(context, radius, math.radians(angle))


@timed("go_to", "x", "y")
def go_to(context: RunContext, command: GoTo, x: float, y: float) -> Routine:
    return _drive(context, x, y, avoid=command.avoid)


@timed("go_to_place", "place")
def go_to_place(context: RunContext, command: GoToPlace, place: str) -> Routine:
    """Drives to the middle of a place of the world.

    Raises RunFailureError `place_not_named`, `no_places` or `unknown_place`.
    """
    x, y = middle_of(place, context.sensors.places(), context.origin)
    return _drive(context, x, y, avoid=command.avoid)


def _drive(context: RunContext, x_m: float, y_m: float, *, avoid: bool) -> Routine:
    if avoid:
        from pinel_desktop.execution.avoiding import drive_around  # noqa: PLC0415 - numpy, which few programs need

        return drive_around(context, x_m, y_m)
    return drive_to(context, x_m, y_m)


@timed("stop")
def stop(context: RunContext, _command: Stop) -> Routine:
    return come_to_rest(context)


@instant("drive", "linear", "angular")
def drive(context: RunContext, _command: Drive, linear: float, angular: float) -> None:
    set_velocity(context, Twist2D(linear, math.radians(angular)))


@instant("set_speed", "linear", "angular")
def set_speed(
    context: RunContext, _command: SetSpeed, linear: float | None, angular: float | None
) -> None:
    """Limits later motions, in m/s and degrees/s; None leaves a limit unchanged.

    Raises RunFailureError `speed_out_of_range` above the robot's limits.
    """
    robot = context.robot
    if linear is not None:
        if linear > robot.max_v_mps:
            raise _too_fast(linear, robot.max_v_mps, "m/s")
        context.max_v_mps = linear
    if angular is not None:
        max_dps = math.degrees(robot.max_omega_radps)
        if angular > max_dps + _ROUNDING:
            raise _too_fast(angular, max_dps, "°/s")
        context.max_omega_radps = min(math.radians(angular), robot.max_omega_radps)


_ROUNDING = 1e-9


def _too_fast(value: float, max_speed: float, unit: str) -> RunFailureError:
    return RunFailureError("speed_out_of_range", value=value, max=round(max_speed, 6), unit=unit)
