"""Moving, turning, stopping."""

import math
from collections.abc import Iterator

from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.motion import come_to_rest, drive_straight, turn_on_the_spot
from pinel_desktop.execution.primitives.base import timed
from pinel_desktop.program.model import MoveBackward, MoveForward, Stop, Turn


@timed("move_forward", amount=lambda command: command.distance)
def move_forward(context: RunContext, command: MoveForward) -> Iterator[None]:
    return drive_straight(context, command.distance)


@timed("move_backward", amount=lambda command: -command.distance)
def move_backward(context: RunContext, command: MoveBackward) -> Iterator[None]:
    return drive_straight(context, -command.distance)


@timed("turn", amount=lambda command: command.angle)
def turn(context: RunContext, command: Turn) -> Iterator[None]:
    return turn_on_the_spot(context, math.radians(command.angle))


@timed("stop")
def stop(context: RunContext, _command: Stop) -> Iterator[None]:
    return come_to_rest(context)
