"""The rule of who commands a robot, the same for both ways to ROS 2. It works with Python 3.8, too."""

from __future__ import annotations

from typing import AbstractSet, TypeVar  # noqa: UP035 - Python 3.8 has the other one without its item

T = TypeVar("T")


def drivers(publish: AbstractSet[T], listen: AbstractSet[T], tell: AbstractSet[T]) -> set[T]:
    """Those who command a robot, without the robot itself: a bridge to ROS 1 passes commands on both ways.

    Whoever both listens to commands and publishes them is the robot if it tells its odometry, too, or if nobody else
    listens. Others that listen may be programs that drive, as some that show what they command.

    Args:
        publish: who publishes commands, the asking one left out.
        listen: who listens to them.
        tell: who publishes the odometry.
    """
    robots = listen & tell or (listen if len(listen) == 1 else set())
    return set(publish - robots)
