"""Which other node drives the robot, as the graph of ROS tells it."""

import uuid
from collections import namedtuple

import rclpy
from drivers import WITHDRAWS_S, Claim, drivers

# A publisher may be known a little before its node.
NAMED_S = 0.5
PINEL = "pinel_"
UNKNOWN = "_NODE_NAME_UNKNOWN_"
# Of the identifier of an endpoint: what all those of a participant share, and all that DDS uses.
PARTICIPANT_BYTES, IDENTIFIER_BYTES = 12, 16
# Every node publishes it from its start.
OF_EVERY_NODE = "/parameter_events"


class RefusalError(Exception):
    """Something that the app tells a person: a code and its parameters."""

    def __init__(self, code, **params):
        super().__init__(code)
        self.code, self.params = code, params


# A node of the domain. Two may have one name: their participants tell them apart.
Who = namedtuple("Who", ["participant", "namespace", "name"])


class CommandClaim(Claim):
    """Watches the publishers of a command topic other than this node's own."""

    def __init__(self, node, command_topic, odometry_topic):
        super().__init__()
        self._node = node
        self._command_topic, self._odometry_topic = command_topic, odometry_topic
        # what Zenoh gives an endpoint tells nothing of its participant
        self._has_participants = "zenoh" not in rclpy.get_rmw_implementation_identifier()
        # nobody else can have this node's name yet
        own = self._nodes(node.get_publishers_info_by_topic(OF_EVERY_NODE))
        self._own = {who for who in own if who.name == node.get_name()}
        self._is_nameless = False  # at the last look there was a node whose name is unknown

    def holder(self):
        """Name of another node that commands the robot, of one that cannot withdraw first; None without any.

        An identifier as of the direct connection where the node is unknown.
        """
        publishers = self._nodes(self._node.get_publishers_info_by_topic(self._command_topic))
        listeners = self._nodes(self._node.get_subscriptions_info_by_topic(self._command_topic))
        tellers = self._nodes(self._node.get_publishers_info_by_topic(self._odometry_topic))
        others = drivers(set(publishers) - self._own, set(listeners), set(tellers))
        self._is_nameless = any(who.name == UNKNOWN for who in others)
        names = [publishers[who] if who.name == UNKNOWN else who.name for who in others]
        return min(names, key=lambda name: (name.startswith(PINEL), name), default=None)

    def withdraws_within_s(self, holder, *, is_newcomer):
        if self._is_nameless:
            return NAMED_S
        is_pinel = holder.startswith(PINEL) and holder != self._node.get_name()
        return WITHDRAWS_S if is_newcomer and is_pinel else 0.0

    def problem(self):
        return RefusalError("robot_held", topic=self._command_topic, holder=self.holder() or "?")

    def _nodes(self, endpoints):
        """The nodes of endpoints, each with the identifier of one of these."""
        return {self._node_of(endpoint): identifier(endpoint) for endpoint in endpoints}

    def _node_of(self, endpoint):
        participant = tuple(endpoint.endpoint_gid[:PARTICIPANT_BYTES])
        known = participant if self._has_participants else None
        return Who(known, endpoint.node_namespace, endpoint.node_name)


def identifier(endpoint):
    """As DDS writes it: it names an endpoint whose node is unknown."""
    return str(uuid.UUID(bytes=bytes(endpoint.endpoint_gid[:IDENTIFIER_BYTES])))
