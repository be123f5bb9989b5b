"""Five PCs and one Pioneer: PCs that begin at the same moment never drive it together."""

import contextlib
import platform
from pathlib import Path

import pytest

from tests.links.dds_domains import own_domain
from tests.links.dds_peer import DdsPeer
from tests.links.socket_robot import SocketRobot, fake_environment
from tests.links.two_pcs import ReceivedVelocity, race, require_one_driver

pytestmark = pytest.mark.waits

# With the last one, the second PC comes to a robot that is driven.
LATE = [*(part / 10 for part in range(1, 19)), 5.0]
head_starts = pytest.mark.parametrize(
    "head_start_s", [0.0, *(pytest.param(late, marks=pytest.mark.nightly) for late in LATE)]
)


@head_starts
def test_over_dds(head_start_s: float, tmp_path: Path) -> None:
    with own_domain() as domain, contextlib.closing(DdsPeer(domain)) as robot:
        settings = (f"domain={domain}", 'peers=["127.0.0.1"]')
        options = [text for each in settings for text in ("--robot-setting", each)]
        results = race(tmp_path, ["--robot", "dds", *options], robot.received, head_start_s)
        received = [
            ReceivedVelocity(*one, sender)
            for one, sender in zip(robot.received, robot.senders, strict=False)
        ]
    print(head_start_s, [(result["state"], result["reason"]) for result in results])
    require_one_driver(results, received, platform.node())


@head_starts
def test_over_an_installed_ros(head_start_s: float, tmp_path: Path) -> None:
    with own_domain() as domain, contextlib.closing(SocketRobot()) as robot:
        environment = {"ROS_VERSION": "2", **fake_environment(robot)}
        options = ["--robot", "ros2", "--robot-setting", f"domain={domain}"]
        results = race(tmp_path, options, robot.received, head_start_s, **environment)
    print(head_start_s, [(result["state"], result["reason"]) for result in results])
    require_one_driver(results, robot.received, "pinel_")
