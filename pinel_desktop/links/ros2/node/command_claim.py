"""Detects other nodes that drive the robot, by the ROS graph."""

import uuid
from collections import namedtuple

import rclpy
from drivers import WITHDRAWAL_TIMEOUT_S, Claim, drivers

# Discovery may report a publisher this long before the name of its node.
NAMED_S = 0.5
PINEL = "pinel_"
UNKNOWN = "_NODE_NAME_UNKNOWN_"
# Bytes of an endpoint's GID: the common prefix of a participant's endpoints, and the length in DDS.
PARTICIPANT_BYTES, IDENTIFIER_BYTES = 12, 16
# Every node publishes this topic from its start.
OF_EVERY_NODE = "/parameter_events"


class RefusalError(Exception):
    """An error that the app reports to a person: a message code and its parameters."""

    def __init__(self, code, **params):
        super().__init__(code)
        self.code, self.params = code, params


# A node of the domain. Two nodes may have the same name, so the participant distinguishes them.
Who = namedtuple("Who", ["participant", "namespace", "name"])


class CommandClaim(Claim):
    """Watches the publishers of a command topic, except this node's own publisher."""

    def __init__(self, node, command_topic, odometry_topic):
        super().__init__()
        self._node = node
        self._command_topic, self._odometry_topic = command_topic, odometry_topic
        # a GID of Zenoh does not contain the participant
        self._has_participants = "zenoh" not in rclpy.get_rmw_implementation_identifier()
        # The name is unique, so all of these nodes are this one.
        own = self._nodes(node.get_publishers_info_by_topic(OF_EVERY_NODE))
        self._own = {who for who in own if who.name == node.get_name()}
        self._is_nameless = False  # whether the last poll found a node with an unknown name

    def holder(self):
        """Returns the name of another node that commands the robot; None without one.

        Of several, prefers a node that is no PINEL, because only PINEL nodes withdraw. If the node is unknown, returns
        the identifier of its endpoint.
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
        return WITHDRAWAL_TIMEOUT_S if is_newcomer and is_pinel else 0.0

    def problem(self):
        return RefusalError("robot_held", topic=self._command_topic, holder=self.holder() or "?")

    def _nodes(self, endpoints):
        """Returns the nodes of endpoints, each with the identifier of one of its endpoints."""
        return {self._node_of(endpoint): identifier(endpoint) for endpoint in endpoints}

    def _node_of(self, endpoint):
        participant = tuple(endpoint.endpoint_gid[:PARTICIPANT_BYTES])
        known = participant if self._has_participants else None
        return Who(known, endpoint.node_namespace, endpoint.node_name)


def identifier(endpoint):
    """Returns an endpoint's identifier in the notation of DDS; it replaces an unknown node name."""
    return str(uuid.UUID(bytes=bytes(endpoint.endpoint_gid[:IDENTIFIER_BYTES])))
