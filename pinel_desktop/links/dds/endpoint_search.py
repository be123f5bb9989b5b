"""Searches a robot by the topics of its profile. Without success, reports the topics that were found instead."""

from collections.abc import Callable, Iterable

from cyclonedds.idl import IdlStruct

from pinel_desktop.errors import PinelError
from pinel_desktop.links.dds.graph import Endpoint, Graph
from pinel_desktop.links.dds.messages import (
    Odometry,
    PoseStamped,
    Twist,
    TwistStamped,
    ros_name,
    type_name,
)
from pinel_desktop.robot.robot_profile import DdsProfile

# In order of preference, if a robot offers both.
COMMANDS: tuple[type[IdlStruct], ...] = (Twist, TwistStamped)
POSES: tuple[type[IdlStruct], ...] = (Odometry, PoseStamped)
_MAX_LISTED = 5


class EndpointSearch:
    """Searches a subscriber of the command topic and a publisher of the odometry topic.

    Attributes:
        command_type, odometry_type: message types that the robot uses; None until they are found.
    """

    def __init__(self, graph: Graph, profile: DdsProfile) -> None:
        self._graph = graph
        self._domain = profile.domain
        self._command_topic = profile.name_of(profile.command_topic)
        self._odometry_topic = profile.name_of(profile.odometry_topic)
        self.command_type: type[IdlStruct] | None = None
        self.odometry_type: type[IdlStruct] | None = None

    def is_complete(self) -> bool:
        """Polls the graph once; returns whether both endpoints are there."""
        self.command_type = _first(COMMANDS, self._graph.subscribers(self._command_topic))
        self.odometry_type = _first(POSES, self._graph.publishers(self._odometry_topic))
        return self.command_type is not None and self.odometry_type is not None

    def problem(self) -> PinelError:
        """Returns the error about the missing endpoint.

        Codes: `robot_not_found`, `robot_elsewhere`, `robot_wrong_type`, `odometry_not_found`, `odometry_elsewhere`.
        """
        if self.command_type is None:
            return self._missing("robot", self._command_topic, COMMANDS, self._graph.subscribers)
        return self._missing("odometry", self._odometry_topic, POSES, self._graph.publishers)

    def _missing(
        self,
        what: str,
        topic: str,
        expected: tuple[type[IdlStruct], ...],
        endpoints: Callable[[str], list[Endpoint]],
    ) -> PinelError:
        where = {"topic": f"/{topic}", "domain": self._domain}
        if wrong := endpoints(topic):
            found = _listed(ros_name(endpoint.type_name) for endpoint in wrong)
            types = " / ".join(ros_name(type_name(message)) for message in expected)
            return PinelError("robot_wrong_type", **where, found=found, wanted=types)
        names = {type_name(message) for message in expected}
        others = _listed(f"/{found.topic}" for found in endpoints("") if found.type_name in names)
        if others:
            return PinelError(f"{what}_elsewhere", **where, found=others)
        return PinelError(f"{what}_not_found", **where)


def _first(
    expected: tuple[type[IdlStruct], ...], endpoints: Iterable[Endpoint]
) -> type[IdlStruct] | None:
    there = {endpoint.type_name for endpoint in endpoints}
    return next((message for message in expected if type_name(message) in there), None)


def _listed(names: Iterable[str]) -> str:
    return ", ".join(sorted(set(names))[:_MAX_LISTED])
