"""Whether somebody else drives the robot: two publishers of one command topic would pull it to and fro."""

import time
import uuid

from pinel_desktop.errors import PinelError
from pinel_desktop.links.dds.graph import Endpoint, Graph, Participant
from pinel_desktop.links.ros2.node.drivers import drivers

# Others in the domain have answered by then: they are known before the first command.
_LISTENING_S = 1.0
# Of it, after this PC shows that it drives: of two that begin together one sees the other. Looks, not time: what a PC
# that stood still for a while saw last may be old.
_CLAIM_S, _CLAIM_LOOKS = 0.3, 6
# Another PINEL that comes later withdraws by itself before this; what else comes is not waited for.
_WITHDRAWS_WITHIN_S = 3.0


class Holding:
    """Watches the publishers of a command topic other than this PC's own.

    Attributes:
        is_disputed: somebody else was there at the last look; this PC sends zeros only.
    """

    def __init__(self, graph: Graph, topic: str, odometry_topic: str) -> None:
        self._graph, self._topic, self._odometry_topic = graph, topic, odometry_topic
        self._began_s = time.monotonic()
        self._since_s: float | None = None  # another PINEL has been there
        self._n_looks = 0
        self.is_disputed = False

    def holder(self) -> Participant | None:
        """Somebody else who publishes commands now; the one that cannot withdraw first."""
        owners = map(self._graph.participant, self._drivers())
        there = [owner for owner in owners if not owner.is_gone]
        return min(there, key=lambda owner: owner.is_pinel, default=None)

    def is_free(self) -> bool:
        """Whether nobody has published for long enough to be sure."""
        if self.holder() is not None:
            self._began_s = time.monotonic()
        return time.monotonic() - self._began_s >= _LISTENING_S - _CLAIM_S

    def began(self) -> None:
        """This PC publishes commands from now on."""
        self._began_s = time.monotonic()

    def is_claimed(self) -> bool:
        """Looks again; whether enough looks since `began` saw nobody else. Raises as `require_alone`."""
        self.require_alone()
        self._n_looks += 1
        return self._n_looks > _CLAIM_LOOKS

    def require_alone(self) -> None:
        """Raises PinelError `robot_held` when somebody else begins to drive, and does not withdraw.

        Until then the robot is disputed: the other one may believe as well that it was here first.
        """
        holder = self.holder()
        self.is_disputed = holder is not None
        if holder is None:
            self._since_s = None
            return
        now_s = time.monotonic()
        self._since_s = self._since_s or now_s
        was_alone = self._since_s - self._began_s > 2 * _LISTENING_S
        if holder.is_pinel and was_alone and now_s - self._since_s < _WITHDRAWS_WITHIN_S:
            return
        raise self.problem()

    def problem(self) -> PinelError:
        holder = self.holder()
        return PinelError(
            "robot_held", holder=holder.name if holder else "?", topic=f"/{self._topic}"
        )

    def _drivers(self) -> set[uuid.UUID]:
        graph = self._graph
        return drivers(
            _participants(graph.publishers(self._topic)),
            _participants(graph.subscribers(self._topic)),
            _participants(graph.publishers(self._odometry_topic)),
        )


def _participants(endpoints: list[Endpoint]) -> set[uuid.UUID]:
    return {endpoint.participant for endpoint in endpoints}
