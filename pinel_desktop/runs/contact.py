"""Discovers real robots and tests the connection to one of them; commands zero velocity only."""

import math
import time
from dataclasses import asdict, dataclass
from typing import Any

from pinel_desktop.links import open_link
from pinel_desktop.links.real import RealLink
from pinel_desktop.robot.robot_profile import RobotProfile, RosProfile

_LISTEN_S = 1.0


@dataclass(frozen=True, slots=True)
class Contact:
    """State that a robot reported.

    Attributes:
        x_m, y_m, heading_deg: pose in the robot's own odometry frame.
        rate_hz: odometry messages per second.
        battery: charge from 0 to 1; None if the robot does not report it.
    """

    x_m: float
    y_m: float
    heading_deg: float
    rate_hz: float
    battery: float | None

    def as_message(self) -> dict[str, Any]:
        """Returns plain JSON data."""
        return asdict(self)


def robots_in_domain(robot: RobotProfile) -> list[dict[str, Any]]:
    """Returns the robots in the domain of a ROS 2 profile, as plain JSON data (`links.dds.discovery.DiscoveredRobot`).

    Raises PinelError `network_missing`, `peer_unknown`.
    """
    from pinel_desktop.links.dds.discovery import discover_robots  # noqa: PLC0415 - loads DDS

    assert isinstance(robot, RosProfile)
    return [asdict(found) for found in discover_robots(robot)]


def probe_robot(robot: RobotProfile) -> Contact:
    """Connects to a robot and commands zero velocity only. Raises what the link's `connect` and `read` raise."""
    link = open_link(robot.link, world=robot.room.as_world(), robot=robot)
    assert isinstance(link, RealLink)
    try:
        link.connect()
        before, start_s = link.n_odometry, time.monotonic()
        time.sleep(_LISTEN_S)
        pose = link.read().pose
        rate_hz = (link.n_odometry - before) / (time.monotonic() - start_s)
        return Contact(
            pose.x_m, pose.y_m, math.degrees(pose.yaw_rad), round(rate_hz, 1), link.battery
        )
    finally:
        link.close()
