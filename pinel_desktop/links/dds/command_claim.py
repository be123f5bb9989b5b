"""Detects other programs that drive the robot, by the endpoints in its DDS domain."""

import uuid

from pinel_desktop.errors import PinelError
from pinel_desktop.links.dds.graph import Endpoint, Graph, Participant
from pinel_desktop.links.ros2.node.drivers import WITHDRAWAL_TIMEOUT_S, Claim, drivers


class CommandClaim(Claim[Participant]):
    """Watches the publishers of a command topic, except this PC's own publisher."""

    def __init__(self, graph: Graph, topic: str, odometry_topic: str) -> None:
        super().__init__()
        self._graph, self._topic, self._odometry_topic = graph, topic, odometry_topic

    def holder(self) -> Participant | None:
        owners = map(self._graph.participant, self._drivers())
        there = [owner for owner in owners if not owner.has_exited]
        return min(there, key=lambda owner: owner.is_pinel, default=None)

    def withdraws_within_s(self, holder: Participant, *, is_newcomer: bool) -> float:
        return WITHDRAWAL_TIMEOUT_S if holder.is_pinel and is_newcomer else 0.0

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
