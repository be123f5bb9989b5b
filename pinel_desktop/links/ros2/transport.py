"""ROS 2 transport: talks over pipes to our node, which runs with the Python of an installed ROS (`node/node.py`)."""

import contextlib
import json
import math
import os
import platform
import queue
import re
import secrets
import subprocess
import threading
import time
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.links.localisation import sigmas_of
from pinel_desktop.links.odometry import yaw_of
from pinel_desktop.links.real import RealLink, real_link
from pinel_desktop.links.ros2.installed import node_command
from pinel_desktop.links.ros_sensors import LidarScan, RosSensors
from pinel_desktop.links.transport import Cancelled, Localised, Odometry, Receiver
from pinel_desktop.processes.standard_streams import error_output
from pinel_desktop.robot import RobotModel, Sensors, SimulationConfig, Twist2D
from pinel_desktop.robot.robot_profile import RobotProfile, Ros2Profile

# ROS starts in 1 to 2 s. The search for the robot takes up to 5 s more.
_OPEN_S = 15.0
_POLL_S = 0.05
_END_S = 3.0
_TOPICS = (
    "command_topic",
    "odometry_topic",
    "scan_topic",
    "sonar_topic",
    "bumper_topic",
    "battery_topic",
    "localisation_topic",
)
Message = dict[str, Any]


def ros2_link(
    *, world: Any, setting: SimulationConfig, seed: int, robot: RobotProfile | None
) -> RealLink:
    """Returns the link to the robot of a `Ros2Profile`. Raises PinelError `robot_not_set_up` without a profile."""
    return real_link(lambda profile: Ros2Transport(profile, setting.robot), setting, robot)


class Ros2Transport:
    """The connection with one robot over the node's pipes. `send` never waits; only the newest velocity is queued."""

    def __init__(self, profile: Ros2Profile, robot: RobotModel) -> None:
        self._sensors = RosSensors(robot)
        self.sensors: Sensors = self._sensors
        self._profile = profile
        self._process: subprocess.Popen[str] | None = None
        self._outbox: queue.Queue[Twist2D | None] = queue.Queue(maxsize=1)
        self._has_started = False
        self._is_ready = threading.Event()
        self._problem: PinelError | None = None
        self._closing = False
        self._threads: list[threading.Thread] = []

    def open(self, receiver: Receiver, cancelled: Cancelled) -> None:
        self._begin(receiver, cancelled, drives=True)

    def listen(self, receiver: Receiver, cancelled: Cancelled) -> None:
        self._begin(receiver, cancelled, drives=False)

    def _begin(self, receiver: Receiver, cancelled: Cancelled, *, drives: bool) -> None:
        command = node_command(json.dumps({**self._configuration(), "drives": drives}))
        if command is None:
            raise PinelError("ros_missing")
        self._process = self._started(command)
        for work in (self._write, self._read):
            thread = threading.Thread(
                target=work, args=(self._process, receiver), name="ros2-node", daemon=True
            )
            thread.start()
            self._threads.append(thread)
        due_s = time.monotonic() + _OPEN_S
        while not self._is_ready.wait(_POLL_S):
            if cancelled():
                return
            if self._problem is not None:
                raise self._problem
            if time.monotonic() > due_s:
                raise PinelError("ros_silent")

    def _configuration(self) -> Message:
        profile = self._profile
        names = {name: str(getattr(profile, name)) for name in _TOPICS}
        topics = {name: topic and profile.name_of(topic) for name, topic in names.items()}
        holder = re.sub(r"[^A-Za-z0-9]", "_", platform.node()) or "pc"
        # PCs set up from one disk image share their name, and may have equal process ids.
        own = f"{holder}_{os.getpid()}_{secrets.token_hex(3)}"
        return {**topics, "domain": profile.domain, "holder": own}

    def _started(self, command: list[str]) -> subprocess.Popen[str]:
        try:
            return subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=error_output(),
                text=True,
                encoding="utf-8",
                # A signal to the terminal's process group must reach only PINEL, which ends the
                # node.
                start_new_session=True,
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
            )
        except OSError as error:
            raise PinelError("ros_does_not_start", detail=str(error)) from error

    def send(self, twist: Twist2D) -> None:
        while True:
            try:
                self._outbox.put_nowait(twist)
                return
            except queue.Full:  # the node has not read the previous velocity, which is stale now
                with contextlib.suppress(queue.Empty):
                    self._outbox.get_nowait()

    def _write(self, process: subprocess.Popen[str], receiver: Receiver) -> None:
        assert process.stdin is not None
        with contextlib.suppress(OSError, ValueError):  # the node has exited, which `_read` reports
            while (twist := self._outbox.get()) is not None:
                process.stdin.write(json.dumps({"twist": list(twist)}) + "\n")
                process.stdin.flush()
        with contextlib.suppress(OSError):
            process.stdin.close()

    def _read(self, process: subprocess.Popen[str], receiver: Receiver) -> None:
        assert process.stdout is not None
        with process.stdout:
            for line in process.stdout:
                with contextlib.suppress(ValueError, KeyError, TypeError):
                    self._handle(json.loads(line), receiver)
        if not self._closing:
            self._report(PinelError("ros_node_ended"), receiver)

    def _handle(self, message: Message, receiver: Receiver) -> None:
        kind = message["type"]
        self._has_started = True
        if kind == "odometry":
            receiver.on_odometry(_odometry(message))
        elif kind == "localised":
            receiver.on_localised(_localised(message))
        elif kind == "battery":
            level = float(message["level"])  # from 0 to 1; some robots count to 100
            receiver.on_battery(level / 100 if level > 1.0 else level)
        elif kind == "holder":
            receiver.on_holder(message["name"])
        elif kind == "ready":
            self._is_ready.set()
        elif kind == "problem":
            self._report(PinelError(message["code"], **message["params"]), receiver)
        elif message.get("sensor") == "battery":
            if kind == "withdrawn":
                receiver.on_battery(math.nan)
        else:
            self._handle_sensor(kind, message)

    def _handle_sensor(self, kind: str, message: Message) -> None:
        sensors = self._sensors
        if kind == "published":
            sensors.offer(message["sensor"])
        elif kind == "withdrawn":
            sensors.withdraw(message["sensor"])
        elif kind == "scan":
            min_range_m, max_range_m = message["bounds"]
            bounds = (message["first"], message["step"], min_range_m, max_range_m)
            sensors.on_scan(LidarScan(*bounds, message["ranges"]))
        elif kind == "range":
            sensors.on_range(message["frame"], message["range"], message["longest"])
        elif kind == "points":
            sensors.on_points([(x, y) for x, y in message["points"]])
        elif kind == "bumper":
            sensors.on_bumper(message["pressed"])

    def _report(self, problem: PinelError, receiver: Receiver) -> None:
        self._problem = self._problem or problem
        receiver.on_problem(problem)

    def bumper(self) -> bool:
        return self._sensors.touches()

    def close(self) -> None:
        process, self._closing = self._process, True
        if process is None:
            return
        with contextlib.suppress(queue.Empty):
            self._outbox.get_nowait()
        self._outbox.put(None)
        if not self._has_started:  # not on the network yet, and ROS would delay its exit
            process.kill()
        try:
            process.wait(_END_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        for thread in self._threads:
            thread.join()


def _odometry(message: Message) -> Odometry:
    (x, y), (v, omega) = message["position"], message["velocity"]
    return Odometry(x, y, _yaw(message), v, omega, message["stamp"], message["frame"])


def _localised(message: Message) -> Localised:
    x, y = message["position"]
    sigmas = sigmas_of(message["variances"])
    return Localised(x, y, _yaw(message), *sigmas, message["stamp"] or None, message["frame"])


def _yaw(message: Message) -> float:
    return yaw_of(*(math.nan if part is None else part for part in message["orientation"]))
