"""Nodes, publishers and subscriptions of one process, connected with a robot over a socket.

The robot also tells who else publishes commands, and of which topics it has taken leave.
"""

import hashlib
import json
import os
import socket
import threading
import time
from types import SimpleNamespace

from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy

_GRAPH = json.loads(os.environ["PINEL_FAKE_ROS"])


def get_rmw_implementation_identifier():
    return "rmw_fake"


def endpoint(name, topic_type=""):
    """Of the node `name`; what stands behind a # in it tells nodes of one name apart."""
    return SimpleNamespace(
        node_name=name.partition("#")[0],
        node_namespace="/",
        topic_type=topic_type,
        endpoint_gid=list(hashlib.sha256(name.encode()).digest()[:24]),
        qos_profile=QoSProfile(
            depth=1, history=HistoryPolicy.KEEP_LAST, reliability=ReliabilityPolicy.RELIABLE
        ),
    )


def init(*, context, domain_id):
    context.domain_id = domain_id


def shutdown(*, context):
    assert context.n_nodes == 0, "a node outlived its context: rclpy would abort"


def create_node(name, *, context):
    return Node(name, context)


class Node:
    def __init__(self, name, context):
        assert name.replace("_", "").isalnum(), "ROS refuses such a name"
        self._name, self._context = name, context
        context.n_nodes += 1
        self._robot = socket.create_connection(("127.0.0.1", _GRAPH["port"]))
        self._callbacks = {}
        self._publishers, self._withdrawn = [], []
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self):
        with self._robot.makefile("r", encoding="utf-8") as lines:
            for line in lines:
                report = json.loads(line)
                if report["kind"] == "graph":
                    self._publishers, self._withdrawn = report["publishers"], report["gone"]
                for kind, (make, callback) in list(self._callbacks.items()):
                    if kind == report["kind"]:
                        callback(make(report))

    def get_name(self):
        return self._name

    def get_subscriptions_info_by_topic(self, topic):
        there = topic == "/cmd_vel" and topic not in self._withdrawn and _GRAPH["command_type"]
        return [endpoint("robot", there)] if there else []

    def get_publishers_info_by_topic(self, topic):
        if topic == "/cmd_vel":
            names = [*_GRAPH["others"], *self._publishers]
            return [endpoint(name) for name in names]
        if topic == "/parameter_events":
            return [endpoint(self._name), endpoint("robot")]
        there = topic not in self._withdrawn and _GRAPH["published"].get(topic)
        return [endpoint("robot", there)] if there else []

    def create_publisher(self, kind, topic, qos):
        assert qos.reliability == "reliable"
        self._robot.sendall(json.dumps({"publishes": self._name}).encode() + b"\n")
        return Publisher(self, self._robot)

    def create_subscription(self, kind, topic, callback, qos):
        assert qos.reliability == "best_effort"
        self._callbacks[kind.KIND] = (kind.of, callback)

    def get_clock(self):
        stamp = SimpleNamespace(sec=int(time.time()), nanosec=0)
        return SimpleNamespace(now=lambda: SimpleNamespace(to_msg=lambda: stamp))

    def destroy_node(self):
        self._context.n_nodes -= 1
        self._robot.close()


class Publisher:
    def __init__(self, node, robot):
        self._node, self._robot = node, robot

    def get_subscription_count(self):
        return len(self._node.get_subscriptions_info_by_topic("/cmd_vel"))

    def publish(self, message):
        twist = getattr(message, "twist", message)
        sent = {"type": type(message).__name__, "twist": [twist.linear.x, twist.angular.z]}
        self._robot.sendall(json.dumps(sent).encode() + b"\n")
