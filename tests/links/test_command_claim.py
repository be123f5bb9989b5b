"""The rule of who drives a robot of ROS 2, over a graph that the test writes."""

import time
import uuid
from typing import Any, cast

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links.dds.command_claim import CommandClaim
from pinel_desktop.links.dds.graph import Endpoint, Graph, Participant
from pinel_desktop.links.dds.transport import DdsTransport
from pinel_desktop.robot import PIONEER_3DX, STANDSTILL, Twist2D
from tests.links.dds_domains import local_profile

OTHER = Endpoint("cmd_vel", "Twist", uuid.UUID(int=1), "")


class WrittenGraph:
    """Its publishers are those that the test names."""

    def __init__(self) -> None:
        self.there: list[Endpoint] = []

    def publishers(self, topic: str) -> list[Endpoint]:
        return self.there

    def subscribers(self, topic: str) -> list[Endpoint]:
        return []

    def participant(self, key: uuid.UUID) -> Participant:
        return Participant("blue", is_pinel=True, has_exited=False)


class _Writer:
    def __init__(self, sent: list[Any]) -> None:
        self.write = sent.append


@pytest.fixture
def graph() -> WrittenGraph:
    return WrittenGraph()


@pytest.fixture
def holds(graph: WrittenGraph) -> CommandClaim:
    held = CommandClaim(cast("Graph", graph), "cmd_vel", "odom")
    held.announce()
    return held


def test_who_shows_that_it_drives_looks_again_before_the_robot_moves(
    graph: WrittenGraph, holds: CommandClaim
) -> None:
    assert not holds.check_claim()
    graph.there = [OTHER]  # it began at the same moment, and is seen now
    with pytest.raises(PinelError, match="robot_held"):
        holds.check_claim()


def test_a_pc_that_paused_looks_as_often_as_any_other(
    holds: CommandClaim, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What it saw first after the pause may be old."""
    started_s = time.monotonic()
    monkeypatch.setattr(time, "monotonic", lambda: started_s + 60.0)
    assert [holds.check_claim() for _ in range(7)] == [False] * 6 + [True]


def test_a_robot_that_another_pinel_drives_too_stands_until_one_withdraws(
    graph: WrittenGraph, holds: CommandClaim, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two that hear of each other late each believe that they were here first."""
    started_s = time.monotonic()
    monkeypatch.setattr(time, "monotonic", lambda: started_s + 60.0)
    sent: list[Any] = []
    transport = DdsTransport(local_profile(1), PIONEER_3DX)
    transport._claim, transport._writer = holds, cast("Any", _Writer(sent))
    for is_there in (False, True, False):
        graph.there = [OTHER] if is_there else []
        holds.require_alone()
        transport.send(Twist2D(0.3, 0.0))
    assert [each.linear.x for each in sent] == [0.3, STANDSTILL.v_mps, 0.3]
