"""Takes the network away from a robot over DDS; prints what became of it as JSON.

    unshare --map-root-user --net python -m tests.links.network_down

Runs in a network of its own, whose only interface is a loopback that this process switches off and on.
"""

import fcntl
import json
import socket
import struct
import sys
import time
from collections.abc import Callable
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.links import open_link
from pinel_desktop.robot import Twist2D
from pinel_desktop.runs.spec import RunSpec
from tests.links.dds_domains import local_profile
from tests.links.dds_peer import DdsPeer
from tests.links.real_link_contract import FAR, LiveRun

_GET_FLAGS, _SET_FLAGS, _UP = 0x8913, 0x8914, 0x1  # linux/sockios.h, linux/if.h
# none of `dds_domains.own_domain`: the network is its own, but the robot's lock file is the PC's
_DOMAIN = 100
_TIMEOUT_S = 20.0


def switch(is_up: bool) -> None:
    """Switches the loopback on or off."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        response = fcntl.ioctl(any_socket, _GET_FLAGS, struct.pack("16sh14x", b"lo", 0))
        (flags,) = struct.unpack("16xh14x", response)
        new_flags = flags | _UP if is_up else flags & ~_UP
        fcntl.ioctl(any_socket, _SET_FLAGS, struct.pack("16sh14x", b"lo", new_flags))


def until(condition: Callable[[], bool]) -> float:
    """Waits; how long it took, in s."""
    started_s = time.monotonic()
    while not condition():
        assert time.monotonic() - started_s < _TIMEOUT_S, "it did not come"
        time.sleep(0.01)
    return time.monotonic() - started_s


def is_lost(link: Any) -> bool:
    """Commands once more; whether the link says that the robot is lost."""
    link.command(Twist2D(0.2, 0.0))
    try:
        link.read()
    except PinelError as problem:
        return problem.code == "link_lost"
    return False


def a_link(robot: DdsPeer) -> dict[str, Any]:
    """A link that is kept open: as soon as the network is back, it lets the robot stand."""
    link = open_link("dds", world="empty_room", robot=local_profile(_DOMAIN))
    link.connect()
    until(lambda: not is_lost(link) and bool(robot.received) and robot.received[-1][1].v_mps == 0.2)
    switch(is_up=False)
    lost_s = until(lambda: is_lost(link))
    time.sleep(0.5)
    was_driving = robot.standstill_since_s() is None
    switch(is_up=True)
    standstill_s = until(lambda: robot.standstill_since_s() is not None)
    link.close()
    return {"lost_s": lost_s, "was_driving": was_driving, "stood_s": standstill_s}


def a_run(robot: DdsPeer, document: list[Any], drops: bool) -> dict[str, Any]:
    """How a run ends whose network goes away, or does not."""
    run = LiveRun(RunSpec(document, "empty_room", link="dds", robot=local_profile(_DOMAIN)))
    n_before = len(robot.received)
    run.thread.start()
    if drops:
        until(lambda: any(twist.v_mps > 0.1 for _, twist in robot.received[n_before:]))
        switch(is_up=False)
    ended = run.result().ended
    switch(is_up=True)
    return {"state": ended.state, "reason": ended.reason}


def main() -> None:
    switch(is_up=True)
    robot = DdsPeer(_DOMAIN)
    try:
        near = [{"action": "move_forward", "distance": 0.3}]
        results = {
            "link": a_link(robot),
            "run": a_run(robot, FAR, drops=True),
            "again": a_run(robot, near, drops=False),
        }
    finally:
        robot.close()
    json.dump(results, sys.stdout)


if __name__ == "__main__":
    main()
