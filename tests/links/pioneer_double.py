"""A Pioneer on DDS, as a process: `python -m tests.links.pioneer_double DOMAIN [SEED]`.

It follows velocities through the physics of the realistic simulator in real time, with an exact knowledge of where it
is, stands 0.6 s after the last velocity as RosAria does, and publishes odometry, a laser scan and its battery.
"""

import json
import math
import sys
import threading
import time

from pinel_desktop.execution.recorder import TelemetryRecorder
from pinel_desktop.links.dds import messages as m
from pinel_desktop.links.dds.session import Session
from pinel_desktop.links.sim import SimLink
from pinel_desktop.robot import PIONEER_3DX, STANDSTILL, Pose2D, SimulationConfig, Twist2D
from sim.simulator import TICK_S

WATCHDOG_S = 0.6
_SCAN_EACH_TICKS = 6
assert PIONEER_3DX.laser
_SCAN_RAD = PIONEER_3DX.laser.angles_rad


class PioneerDouble:
    """The robot; `tick` advances it by one tick of the simulator.

    Attributes:
        recorder: knows the way that it truly drove.
    """

    def __init__(self, domain: int, seed: int) -> None:
        setting = SimulationConfig(preset="realistic", feedback="pose")
        self.link = SimLink(world="empty_room", setting=setting, seed=seed)
        session = Session(domain, ("127.0.0.1",))
        self._commands = session.reader("cmd_vel", m.Twist)
        self._odometry = session.writer("odom", m.Odometry)
        self._scan = session.writer("scan", m.LaserScan)
        self._battery = session.writer("battery_state", m.BatteryState)
        self._session = session
        self._commanded_s = -math.inf
        self._ticks = 0
        self.recorder = TelemetryRecorder()

    def tick(self) -> None:
        for sample in self._commands.take(1):
            if isinstance(sample, m.Twist):  # else somebody has left
                self._commanded_s = time.monotonic()
                self.link.command(Twist2D(sample.linear.x, sample.angular.z))
        if time.monotonic() - self._commanded_s > WATCHDOG_S:
            self.link.command(STANDSTILL)
        self.link.advance(TICK_S)
        self.recorder.add_true(self.true_pose()[:2])
        self._odometry.write(self._message())
        if self._ticks % _SCAN_EACH_TICKS == 0:
            self._scan.write(self._scanned())
            self._battery.write(m.BatteryState(percentage=0.8, present=True))
        self._ticks += 1

    def true_pose(self) -> Pose2D:
        pose = self.link.read().true_pose
        assert pose is not None
        return pose

    def _message(self) -> m.Odometry:
        state = self.link.read()
        x, y, yaw = state.pose
        pose = m.Pose(m.Point(x, y), m.Quaternion(z=math.sin(yaw / 2), w=math.cos(yaw / 2)))
        twist = m.Twist(m.Vector3(state.twist.v_mps), m.Vector3(z=state.twist.omega_radps))
        covariances = m.PoseWithCovariance(pose), m.TwistWithCovariance(twist)
        return m.Odometry(_header("odom"), "base_link", *covariances)

    def _scanned(self) -> m.LaserScan:
        return m.LaserScan(
            _header("laser"),
            angle_min=_SCAN_RAD[0],
            angle_max=_SCAN_RAD[-1],
            angle_increment=_SCAN_RAD[1] - _SCAN_RAD[0],
            range_min=0.02,
            range_max=8.0,
            ranges=self.link.sensors.scan(),
        )


def _header(frame: str) -> m.Header:
    now_ns = time.time_ns()
    return m.Header(m.Time(now_ns // 10**9, now_ns % 10**9), frame)


def main() -> None:
    """Runs until its input ends; then prints where it stands, seen from its start, and how far it really drove."""
    double = PioneerDouble(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 0)
    start, ended = double.true_pose(), threading.Event()

    def listen() -> None:
        sys.stdin.read()
        ended.set()

    threading.Thread(target=listen, daemon=True).start()
    print("ready", flush=True)
    due_s = time.monotonic()
    while not ended.is_set():
        double.tick()
        due_s = max(due_s + TICK_S, time.monotonic() - TICK_S)
        ended.wait(max(0.0, due_s - time.monotonic()))
    end = double.true_pose().relative_to(start)._asdict()
    print(json.dumps({**end, "way_m": double.recorder.true_path_length_m()}), flush=True)


if __name__ == "__main__":
    main()
