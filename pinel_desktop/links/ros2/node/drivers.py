"""The rule of who commands a robot, the same for both ways to ROS 2. It works with Python 3.8, too."""

from __future__ import annotations

import time
from typing import AbstractSet, Generic, TypeVar  # noqa: UP035 - Python 3.8 has the other one without its item

T = TypeVar("T")

# Others in the domain have answered by then: they are known before the first command.
_LISTENING_S = 1.0
# Of it, after this PC shows that it drives: of two that begin together one sees the other. Looks, not time: what a PC
# that stood still for a while saw last may be old.
_CLAIM_S, _CLAIM_POLLS = 0.3, 6
# Another PINEL that comes later withdraws by itself before this.
WITHDRAWS_S = 3.0
# A robot whose program begins anew hears again within this time.
UNMATCHED_TIMEOUT_S = 1.0
# A robot that reports nothing for longer than this may not hear, either,
LOST_TIMEOUT_S = 0.5
# and one that comes back within this time after the last command still hears that it has to stand.
LAST_S = 1.5


def drivers(publish: AbstractSet[T], listen: AbstractSet[T], report: AbstractSet[T]) -> set[T]:
    """Those who command a robot, without the robot itself: a bridge to ROS 1 passes commands on both ways.

    Whoever both listens to commands and publishes them is the robot if it tells its odometry, too, or if nobody else
    listens. Others that listen may be programs that drive, as some that show what they command.

    Args:
        publish: who publishes commands, the asking one left out.
        listen: who listens to them.
        report: who publishes the odometry.
    """
    robots = listen & report or (listen if len(listen) == 1 else set())
    return set(publish - robots)


class Claim(Generic[T]):
    """Watches who else commands the robot: two publishers of one command topic would pull it to and fro.

    Attributes:
        is_disputed: somebody else was there at the last look; this PC sends zeros only.
    """

    def __init__(self) -> None:
        self._started_s = time.monotonic()
        self._disputed_since_s: float | None = None
        self._n_polls = 0
        self.is_disputed = False

    def holder(self) -> T | None:
        """Somebody else who publishes commands now; the one that cannot withdraw first."""
        raise NotImplementedError

    def withdraws_within_s(self, holder: T, *, is_newcomer: bool) -> float:
        """How long is waited for somebody else to withdraw. `is_newcomer`: this PC drove before."""
        raise NotImplementedError

    def problem(self) -> Exception:
        """What is raised because of the holder."""
        raise NotImplementedError

    def is_free(self) -> bool:
        """Whether nobody has published for long enough to be sure."""
        if self.holder() is not None:
            self._started_s = time.monotonic()
        return time.monotonic() - self._started_s >= _LISTENING_S - _CLAIM_S

    def announce(self) -> None:
        """This PC publishes commands from now on."""
        self._started_s = time.monotonic()

    def check_claim(self) -> bool:
        """Looks again; whether enough looks since `start` saw nobody else. Raises as `require_alone`."""
        self.require_alone()
        self._n_polls += 1
        return self._n_polls > _CLAIM_POLLS

    def require_alone(self) -> None:
        """Raises `problem` when somebody else begins to drive, and does not withdraw.

        Until then the robot is disputed: the other one may believe as well that it was here first.
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
