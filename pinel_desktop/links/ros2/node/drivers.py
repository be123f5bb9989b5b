"""Detection of other drivers of a robot, shared by the transports `dds` and `ros2`. Must work with Python 3.8."""

from __future__ import annotations

import time
from typing import AbstractSet, Generic, TypeVar  # noqa: UP035 - Python 3.8 has the other one without its item

T = TypeVar("T")

# Discovery of other drivers takes up to this time. It therefore precedes the first command.
_LISTENING_S = 1.0
# Its last part follows the creation of this PC's publisher. If two PCs start together, at least one
# of them then detects the other. That part ends after a number of polls, not after a time: after a
# pause of this PC, its last poll may be outdated.
_CLAIM_S, _CLAIM_POLLS = 0.3, 6
# Another PINEL that starts later withdraws by itself within this time.
WITHDRAWAL_TIMEOUT_S = 3.0
# A robot whose program restarts subscribes again within this time.
UNMATCHED_TIMEOUT_S = 1.0
# A robot without odometry for this time may not receive commands either.
LOST_TIMEOUT_S = 0.5
# At the end, such a robot is sent zeros for this time, in case its connection returns.
FINAL_ZEROS_S = 1.5


def drivers(publish: AbstractSet[T], listen: AbstractSet[T], report: AbstractSet[T]) -> set[T]:
    """Returns the participants that command a robot, without the robot itself.

    A robot may publish on its own command topic, because a bridge to ROS 1 forwards commands in both directions. A
    participant that subscribes to commands and publishes them is the robot in two cases: if it also publishes the
    odometry, or if it is the only subscriber. Any other such participant may be a program that drives and displays
    its own commands.

    Args:
        publish: participants that publish commands, without the caller.
        listen: participants that subscribe to commands.
        report: participants that publish the odometry.
    """
    robots = listen & report or (listen if len(listen) == 1 else set())
    return set(publish - robots)


class Claim(Generic[T]):
    """Claims the command topic for this PC, and watches for other publishers.

    Two publishers of one command topic would drive the robot to and fro.

    Attributes:
        is_disputed: whether the last poll found another publisher; this PC then sends zeros only.
    """

    def __init__(self) -> None:
        self._started_s = time.monotonic()
        self._disputed_since_s: float | None = None
        self._n_polls = 0
        self.is_disputed = False

    def holder(self) -> T | None:
        """Returns another publisher of commands, preferably one that cannot withdraw; None without one."""
        raise NotImplementedError

    def withdraws_within_s(self, holder: T, *, is_newcomer: bool) -> float:
        """Returns how long to wait for the withdrawal of another publisher, in s.

        Args:
            holder: the other publisher.
            is_newcomer: whether the other publisher started after this PC.
        """
        raise NotImplementedError

    def problem(self) -> Exception:
        """Returns the error about the other publisher."""
        raise NotImplementedError

    def is_free(self) -> bool:
        """Polls once; returns whether the topic has had no other publisher for long enough to be sure."""
        if self.holder() is not None:
            self._started_s = time.monotonic()
        return time.monotonic() - self._started_s >= _LISTENING_S - _CLAIM_S

    def announce(self) -> None:
        """Records that this PC has created its publisher."""
        self._started_s = time.monotonic()

    def check_claim(self) -> bool:
        """Polls once; returns whether enough polls since `announce` found no other publisher.

        Raises the errors of `require_alone`.
        """
        self.require_alone()
        self._n_polls += 1
        return self._n_polls > _CLAIM_POLLS

    def require_alone(self) -> None:
        """Polls once; raises `problem` if another publisher does not withdraw in time.

        Until then the robot is disputed, because the other publisher may have started at the same time.
        """
        holder = self.holder()
        self.is_disputed = holder is not None
        if holder is None:
            self._disputed_since_s = None
            return
        now_s = time.monotonic()
        self._disputed_since_s = since_s = self._disputed_since_s or now_s
        is_newcomer = since_s - self._started_s > 2 * _LISTENING_S
        if now_s - since_s >= self.withdraws_within_s(holder, is_newcomer=is_newcomer):
            raise self.problem()
