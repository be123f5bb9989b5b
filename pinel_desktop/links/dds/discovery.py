"""Discovers the robots of a DDS domain: participants that subscribe to velocities and publish odometry."""

import time
from dataclasses import dataclass

from pinel_desktop.links.dds.command_claim import CommandClaim
from pinel_desktop.links.dds.endpoint_search import COMMANDS, POSES
from pinel_desktop.links.dds.graph import Endpoint, Graph
from pinel_desktop.links.dds.messages import type_name
from pinel_desktop.links.dds.session import Session
from pinel_desktop.links.dds.transport import addresses
from pinel_desktop.robot.robot_profile import RosProfile

# Discovery of Fast DDS takes up to 1.1 s, and longer over Wi-Fi.
_LISTENING_S = 2.5
_COMMANDS = frozenset(map(type_name, COMMANDS))
_POSES = frozenset(map(type_name, POSES))


@dataclass(frozen=True, slots=True)
class DiscoveredRobot:
    """A robot that was found by its topics.

    Attributes:
        namespace: common namespace of both topics; empty for none.
        command_topic, odometry_topic: names without the namespace.
        holder: name of the program that drives the robot now; None without one.
    """

    namespace: str
    command_topic: str
    odometry_topic: str
    holder: str | None


def discover_robots(profile: RosProfile) -> list[DiscoveredRobot]:
    """Listens in the profile's domain for 2.5 s and returns the robots; publishes nothing.

    Raises PinelError `network_missing`, `peer_unknown`.
    """
    session = Session(profile.domain, addresses(profile.peers, lambda: False))
    try:
        graph = Graph(session)
        due_s = time.monotonic() + _LISTENING_S
        while time.monotonic() < due_s:
            graph.publishers(), graph.subscribers()  # empties the readers for further samples
            time.sleep(0.1)
        return _robots(graph)
    finally:
        session.close()


def _robots(graph: Graph) -> list[DiscoveredRobot]:
    poses = [found for found in graph.publishers() if found.type_name in _POSES]
    found = {}
    for listens in graph.subscribers():
        pose = _pose_of(listens, poses) if listens.type_name in _COMMANDS else None
        if pose is not None:
            holder = CommandClaim(graph, listens.topic, pose.topic).holder()
            found[listens.topic] = _named(
                listens.topic, pose.topic, holder.name if holder else None
            )
    return [found[topic] for topic in sorted(found)]


def _pose_of(listens: Endpoint, poses: list[Endpoint]) -> Endpoint | None:
    """Returns the robot's odometry publisher: one in the namespace of its command topic.

    Prefers a publisher of the same participant, then the usual topic name.
    """

    def rank(pose: Endpoint) -> tuple[bool, bool, str]:
        is_other = pose.participant != listens.participant
        return is_other, not pose.topic.endswith("odom"), pose.topic

    near = [pose for pose in poses if _namespace(pose.topic) == _namespace(listens.topic)]
    return min(near, key=rank, default=None)


def _named(command: str, odometry: str, holder: str | None) -> DiscoveredRobot:
    namespace = _namespace(command)
    start = len(namespace) + 1 if namespace else 0
    return DiscoveredRobot(namespace, command[start:], odometry[start:], holder)


def _namespace(topic: str) -> str:
    return topic.rpartition("/")[0]
