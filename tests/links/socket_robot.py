"""A robot for the fake ROS (`fake_ros`), which it talks to over a socket; it serves several nodes."""

import contextlib
import itertools
import json
import socket
import sys
import threading
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.links.ros2 import installed, transport
from pinel_desktop.robot import Twist2D
from tests.links.two_pcs import ReceivedVelocity
from tests.links.unicycle import Unicycle

FAKE = Path(__file__).parent / "fake_ros"
GRAPH: dict[str, Any] = {
    "command_type": "geometry_msgs/msg/Twist",
    "published": {
        "/odom": "nav_msgs/msg/Odometry",
        "/scan": "sensor_msgs/msg/LaserScan",
        "/sonar": "sensor_msgs/msg/PointCloud",
        "/sonar_ring": "sensor_msgs/msg/Range",
        "/bumper_state": "std_msgs/msg/Bool",
        "/battery_state": "sensor_msgs/msg/BatteryState",
    },
    "others": [],
}
SENSORS: list[tuple[str, dict[str, Any]]] = [
    ("/scan", {"kind": "scan", "ahead": 1.25}),
    ("/sonar", {"kind": "points", "points": [[1.7225 + n / 10, 0.0] for n in range(16)]}),
    *(
        ("/sonar_ring", {"kind": "range", "frame": f"sonar_{n}", "range": 1.5 + n / 10})
        for n in range(16)
    ),
    ("/bumper_state", {"kind": "bumper", "pressed": True}),
    ("/battery_state", {"kind": "battery", "level": 0.75}),
]


# the pose comes 100 times a second; a node that decodes all else as often would fall behind on a busy PC
SENSORS_EVERY = 10


class SocketRobot:
    """A unicycle that reports its pose 100 times a second, and what its sensors see ten times.

    Attributes:
        types: message types of the velocities that came.
        received: the velocities with the connection that they came over.
        is_localised: publishes its pose on its map, too, which is that of the odometry.
    """

    def __init__(self) -> None:
        self.unicycle = Unicycle()
        self.types: set[str] = set()
        self.is_localised = False
        self.received: list[ReceivedVelocity] = []
        self._withdrawn: list[str] = []
        self._others: list[str] = []
        self._publishers: dict[socket.socket, str] = {}
        self._nodes: list[socket.socket] = []
        self._lock, self._publishing = threading.Lock(), threading.Lock()
        self._server = socket.create_server(("127.0.0.1", 0))
        self.port = self._server.getsockname()[1]
        self._ending = threading.Event()
        self._threads = [threading.Thread(target=self._accept, daemon=True)]
        self._threads[0].start()

    def withdraw(self, topics: Iterable[str]) -> None:
        """Neither publishes these topics any more nor subscribes to them."""
        self._withdrawn = list(topics)
        self._publish_graph()

    def let_drive(self, others: Iterable[str]) -> None:
        """Nodes of these names command it, too."""
        self._others = list(others)
        self._publish_graph()

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                node, _ = self._server.accept()
                self._nodes.append(node)
                self._publish_graph()
                for work in (self._receive, self._report):
                    thread = threading.Thread(target=work, args=(node,), daemon=True)
                    self._threads.append(thread)
                    thread.start()

    def _receive(self, node: socket.socket) -> None:
        with node, contextlib.suppress(OSError), node.makefile("r", encoding="utf-8") as lines:
            for line in lines:
                sent = json.loads(line)
                if "publishes" in sent:
                    self._publishers[node] = sent["publishes"]
                    self._publish_graph()
                    continue
                self.types.add(sent["type"])
                if "/cmd_vel" not in self._withdrawn:
                    self.unicycle.receive(Twist2D(*sent["twist"]))
                    self.received.append(ReceivedVelocity(*self.unicycle.received[-1], id(node)))
        self._nodes.remove(node)
        self._publishers.pop(node, None)
        self._publish_graph()

    def _publish_graph(self) -> None:
        with self._publishing:  # what is told last is the newest
            names = [*self._publishers.values(), *self._others]
            graph = {"kind": "graph", "publishers": names, "gone": self._withdrawn}
            for node in list(self._nodes):
                self._send(node, graph)

    def _send(self, node: socket.socket, report: dict[str, Any]) -> None:
        with contextlib.suppress(OSError), self._lock:
            node.sendall(json.dumps(report).encode() + b"\n")

    def _report(self, node: socket.socket) -> None:
        for n in itertools.count():
            if node not in self._nodes or self._ending.wait(0.01):
                return
            if not self.unicycle.is_mute:
                pose = list(self.unicycle.report())
                self._send(node, {"kind": "odometry", "pose": pose})
                if self.is_localised:
                    self._send(node, {"kind": "localised", "pose": [*pose[:6], "map"]})
            if n % SENSORS_EVERY == 0:
                self._publish_sensors(node)

    def _publish_sensors(self, node: socket.socket) -> None:
        for topic, reading in SENSORS:
            if topic not in self._withdrawn:
                self._send(node, reading)

    def close(self) -> None:
        self._ending.set()
        self._server.shutdown(socket.SHUT_RDWR)
        self._server.close()
        for thread in self._threads:
            thread.join(5.0)


def fake_environment(robot: SocketRobot, **graph: Any) -> dict[str, str]:
    """The environment in which a node meets the fake ROS."""
    full_graph = {**GRAPH, "port": robot.port, **graph}
    return {"PINEL_FAKE_ROS": json.dumps(full_graph), "PYTHONPATH": str(FAKE)}


def use_fake_ros(monkeypatch: pytest.MonkeyPatch, robot: SocketRobot, **graph: Any) -> None:
    """Lets the link find the fake ROS in place of an installed one."""
    for name, value in fake_environment(robot, **graph).items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(
        transport,
        "node_command",
        lambda configuration: [sys.executable, str(installed.NODE), configuration],
    )
