"""A robot of ROS 2 on DDS, as a process: `python -m tests.links.dds_robot JSON`.

It follows velocities at once (`Unicycle`) and prints each one that comes as a line of JSON; a line on its standard
input changes what it does.
"""

import json
import math
import sys
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from cyclonedds.core import Policy, Qos
from cyclonedds.idl import IdlStruct
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

from pinel_desktop.links.dds import messages as m
from pinel_desktop.links.dds.session import Session, delete
from pinel_desktop.robot import Pose2D, Twist2D
from tests.links.unicycle import Unicycle

PERIOD_S = 0.01
# the robot's start in the frame of its map
START_ON_MAP = Pose2D(1.0, 2.0, math.pi / 2)
# and on the floor under a camera
START_ON_FLOOR = Pose2D(0.8, 1.5, 0.0)


@dataclass
class Behaviour:
    """What the robot offers, and how it misbehaves.

    Attributes:
        command: type that it subscribes to; empty for none.
        odometry: type that it publishes; empty for none.
        sensors: publishes a scan, sonars, a bumper and its battery.
        left_topics: topics that it published, or subscribed to, and has left.
        is_mute: reports nothing.
        broken: `nan`, `quaternion`, `jump`, `frame`, `clock` or `ahead`: what is wrong with the odometry.
        period_s: from one message to the next.
        publishes_commands: somebody else's participant publishes commands, too.
        listens_to_commands: that one hears commands, too.
        localisation: type of the poses of its own localisation, on `amcl_pose`; empty for none. The start is
            `START_ON_MAP` in its map.
        localisation_frame: the frame that those poses name.
        localised_nan: they are NaN.
        pose_file: a file with its true pose on a floor, renewed while it drives; empty for none.
        slips: the share of its way ahead that it only believes to drive.
        relays: the robot's own one publishes commands, as a bridge to ROS 1.
        asks_for_last: it hears only who keeps the last command for it.
    """

    domain: int
    command: str = "Twist"
    odometry: str = "Odometry"
    namespace: str = ""
    sensors: bool = False
    left_topics: Sequence[str] = ()
    is_mute: bool = False
    broken: str = ""
    period_s: float = PERIOD_S
    publishes_commands: bool = False
    listens_to_commands: bool = False
    asks_for_last: bool = False
    relays: bool = False
    localisation: str = ""
    localisation_frame: str = "map"
    localised_nan: bool = False
    pose_file: str = ""
    slips: float = 0.0


class DdsRobot:
    def __init__(self, behaviour: Behaviour) -> None:
        self.behaviour, self.robot = behaviour, Unicycle()
        self._session = session = Session(behaviour.domain, ("127.0.0.1",))
        self._prefix = f"{behaviour.namespace}/" if behaviour.namespace else ""
        self._commands = self._reader("cmd_vel", behaviour.command)
        self._odometry = self._writer("odom", behaviour.odometry)
        self._localisation = self._writer("amcl_pose", behaviour.localisation)
        self._others: Any = None
        if behaviour.relays:
            self._writer("cmd_vel", behaviour.command)
        self._sensors = {
            topic: (session.writer(self._prefix + topic, type(messages[0])), messages)
            for topic, messages in (SENSORS if behaviour.sensors else ())
        }

    def _reader(self, topic: str, name: str) -> Any:
        if not name:
            return None
        if self.behaviour.asks_for_last:
            return reader_of_last(self._session, self._prefix + topic, getattr(m, name))
        return self._session.reader(self._prefix + topic, getattr(m, name))

    def _writer(self, topic: str, name: str) -> Any:
        return self._session.writer(self._prefix + topic, getattr(m, name)) if name else None

    def work(self) -> None:
        threading.Thread(target=self._report, daemon=True).start()
        send({"ready": True})
        while True:
            if self._commands is not None and "cmd_vel" in self.behaviour.left_topics:
                delete(self._commands)
                self._commands = None
            for sample in self._commands.take(1) if self._commands else ():
                twist = sample if isinstance(sample, m.Twist) else getattr(sample, "twist", None)
                if twist is not None:
                    self._receive(Twist2D(twist.linear.x, twist.angular.z), sample)
            time.sleep(0.001)

    def _receive(self, twist: Twist2D, sample: Any) -> None:
        stamp = sample.header.stamp.sec if isinstance(sample, m.TwistStamped) else None
        self.robot.receive(twist)
        by = sample.sample_info.publication_handle
        send({"heard": [*self.robot.received[-1][0:1], *twist], "stamp": stamp, "by": by})

    def _report(self) -> None:
        while True:
            self._share_commands()
            if not self.behaviour.is_mute and self._odometry is not None:
                self._odometry.write(self._message())
            if self._localisation is not None:
                self._localisation.write(self._localised())
            if self.behaviour.pose_file:
                self._write_pose(Path(self.behaviour.pose_file))
            self._publish_sensors()
            time.sleep(self.behaviour.period_s)

    def _publish_sensors(self) -> None:
        for topic in set(self.behaviour.left_topics) & set(self._sensors):
            delete(self._sensors.pop(topic)[0])
        for writer, messages in self._sensors.values():
            for message in messages:
                writer.write(message)

    def _share_commands(self) -> None:
        is_desired = self.behaviour.publishes_commands
        if is_desired and self._others is None:
            self._others = Session(self.behaviour.domain, ("127.0.0.1",))
            if self.behaviour.listens_to_commands:
                self._others.reader(self._prefix + "cmd_vel", m.Twist)
            self._others.writer(self._prefix + "cmd_vel", m.Twist)
        elif not is_desired and self._others is not None:
            self._others.close()
            self._others = None

    def _message(self) -> Any:
        now, broken = self.robot.report(), self.behaviour.broken
        x = math.nan if broken == "nan" else now.x_m + (2.0 if broken == "jump" else 0.0)
        turned = m.Quaternion(z=math.sin(now.yaw_rad / 2), w=math.cos(now.yaw_rad / 2))
        if broken == "quaternion":
            turned = m.Quaternion(w=0.0)
        pose = m.Pose(m.Point(x, now.y_m), turned)
        s = time.time() + {"clock": -1e6, "ahead": 1e6}.get(broken, 0.0)
        header = m.Header(m.Time(int(s), int(s % 1 * 1e9)), "map" if broken == "frame" else "odom")
        if self.behaviour.odometry == "PoseStamped":
            return m.PoseStamped(header, pose)
        twist = m.Twist(m.Vector3(now.v_mps or 0.0), m.Vector3(z=now.omega_radps or 0.0))
        covariances = m.PoseWithCovariance(pose), m.TwistWithCovariance(twist)
        return m.Odometry(header, "base_link", *covariances)

    def _localised(self) -> Any:
        now, behaviour = self.robot.report(), self.behaviour
        x, y, yaw = START_ON_MAP.compose(Pose2D(now.x_m, now.y_m, now.yaw_rad))
        turned = m.Quaternion(z=math.sin(yaw / 2), w=math.cos(yaw / 2))
        pose = m.Pose(m.Point(math.nan if behaviour.localised_nan else x, y), turned)
        s = time.time()
        header = m.Header(m.Time(int(s), int(s % 1 * 1e9)), behaviour.localisation_frame)
        if behaviour.localisation == "PoseStamped":
            return m.PoseStamped(header, pose)
        covariance = [0.0] * 36
        covariance[0], covariance[7], covariance[35] = 0.0004, 0.0001, 0.0009
        return m.PoseWithCovarianceStamped(header, m.PoseWithCovariance(pose, covariance))

    def _write_pose(self, file: Path) -> None:
        now = self.robot.report()
        true_x_m = now.x_m * (1.0 - self.behaviour.slips)
        pose = START_ON_FLOOR.compose(Pose2D(true_x_m, now.y_m, now.yaw_rad))
        new = file.with_suffix(".new")
        new.write_text(json.dumps(pose))
        new.replace(file)


def reader_of_last(session: Session, topic: str, message: type[IdlStruct]) -> "DataReader[Any]":
    """Hears only publishers that keep their last message for it, as a transient-local subscription of ROS."""
    reliable = Policy.Reliability.Reliable(duration(milliseconds=100))
    qos = Qos(reliable, Policy.Durability.TransientLocal, Policy.History.KeepLast(10))
    return DataReader(session.participant, Topic(session.participant, f"rt/{topic}", message), qos)


SCAN = m.LaserScan(
    angle_min=-math.pi / 2,
    angle_max=math.pi / 2,
    angle_increment=math.pi / 180,
    range_min=0.1,
    range_max=8.0,
    ranges=[1.0 + index / 100 for index in range(181)],
)
POINTS = m.PointCloud(points=[m.Point32(0.2225 + 1.5 + index / 10) for index in range(16)])
RANGES = [
    m.Range(m.Header(frame_id=f"sonar_{index}"), max_range=5.0, range=1.5 + index / 10)
    for index in range(16)
]
SENSORS: tuple[tuple[str, Any], ...] = (
    ("scan", [SCAN]),
    ("sonar", [POINTS]),
    ("sonar_ring", RANGES),
    ("bumper_state", [m.Bool(data=True)]),
    ("battery_state", [m.BatteryState(percentage=0.75)]),
)


def send(message: dict[str, Any]) -> None:
    sys.stdout.write(json.dumps(message) + "\n")
    sys.stdout.flush()


def listen(robot: DdsRobot) -> None:
    """Each line changes fields of the behaviour, and is answered when it has been taken."""
    for line in sys.stdin:
        for name, value in json.loads(line).items():
            setattr(robot.behaviour, name, value)
        send({"changed": True})
    sys.exit()


def main() -> None:
    robot = DdsRobot(Behaviour(**json.loads(sys.argv[1])))
    threading.Thread(target=robot.work, daemon=True).start()
    listen(robot)


if __name__ == "__main__":
    main()
