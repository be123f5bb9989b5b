"""What a robot's own localisation says is kept as a truth of its run, and what is wrong with it is told."""

import math
import queue
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.engine.client import EngineClient
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.robot import Pose2D
from pinel_desktop.robot.robot_profile import DdsProfile
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.school.truths.localisation import LocalisationTruth
from storage import RunStart, Store, open_store
from tests.links.dds_domains import local_profile, own_domain
from tests.links.dds_peer import DdsPeer
from tests.links.dds_robot import START_ON_MAP
from tests.storage.sample_documents import SQUARE, WORLD

SOON_S = 60.0
LOCALISED = DdsProfile(localisation_topic="amcl_pose")


class School:
    """The record of a run, and what the pages are told."""

    def __init__(self, store: Store) -> None:
        self.store = store
        self.published: list[dict[str, Any]] = []
        self.truth = LocalisationTruth(store, self.published.append, lambda: "en")
        self.run = store.runs.begin(RunStart("dds", "room", WORLD, 1, "0.3", document=SQUARE)).id

    def begin(self, robot: DdsProfile = LOCALISED) -> None:
        self.truth.begin(self.run, robot)

    def sample(self, tick: int, x_m: float) -> None:
        """Where the robot believes to be."""
        event = {"type": "telemetry", "run": self.run, "tick": tick, "y_m": 0.0, "yaw_rad": 0.0}
        self.truth.observe({**event, "x_m": x_m})

    def localise(self, ahead_m: float, age_s: float = 0.0) -> None:
        """Where the localisation says that the robot is, ahead of the start."""
        pose = [*START_ON_MAP.compose(Pose2D(ahead_m, 0.0)), 0.02, 0.03]
        self.truth.receive(self.message(pose=pose, age_s=age_s))

    def message(self, **more: Any) -> dict[str, Any]:
        empty: dict[str, Any] = {"pose": None, "code": None, "params": {}, "age_s": 0.0}
        return {"type": "robot_localised", "run": self.run, **empty, **more}

    def end(self) -> list[tuple[Any, ...]]:
        """The poses that were kept."""
        self.truth.observe({"type": "run_ended", "run": self.run})
        until_s = time.monotonic() + SOON_S
        while self.states()[-1] not in ("recorded", "nothing"):
            assert time.monotonic() < until_s
            time.sleep(0.01)
        return [pose for truth in self.store.truths.of_run(self.run) for pose in truth.poses]

    def states(self) -> list[str]:
        return [event["code"] or event["state"] for event in self.published] or [""]


@pytest.fixture
def school(tmp_path: Path) -> Iterator[School]:
    with open_store(tmp_path / "pinel.db") as store:
        yield School(store)


def test_poses_are_recorded_in_the_start_frame_at_the_tick_of_their_stamp(school: School) -> None:
    school.begin()
    for tick in range(1, 61):
        school.sample(tick, 0.01 * max(0, tick - 30))
        if tick > 3:
            school.localise(0.011 * max(0, tick - 3 - 30), age_s=0.1)
    poses = school.end()
    tick, x, y, *_ = poses[-1]
    assert (tick, x, y) == (57, pytest.approx(0.011 * 27, abs=1e-3), pytest.approx(0, abs=1e-3))
    assert school.store.truths.of_run(school.run)[0].source == "localisation"
    assert school.states() == ["recorded"]


def test_after_a_jump_nothing_counts_until_the_wheels_agree_again(school: School) -> None:
    school.begin()
    for tick in range(1, 31):
        school.sample(tick, 0.01 * tick)
        school.localise(0.01 * tick + (2.0 if 10 < tick < 20 else 0.0))
    poses = school.end()
    assert [pose[0] for pose in poses] == [*range(1, 11), *range(20, 31)]
    assert school.states() == ["localisation_jumped", "seeing", "recorded"]


def test_silence_is_reported_after_a_long_movement_without_a_pose(school: School) -> None:
    school.begin()
    school.sample(1, 0.0)
    school.localise(0.0)
    for tick in range(2, 100):
        school.sample(tick, 0.0)  # a robot at rest may be silent
    assert school.states() == [""]
    for tick in range(100, 160):
        school.sample(tick, 0.02 * (tick - 100))
    assert school.states() == ["localisation_silent"]
    assert len(school.end()) == 1


def test_a_localisation_of_another_frame_is_reported_and_nothing_is_recorded(
    school: School,
) -> None:
    school.begin()
    school.sample(1, 0.0)
    params = {"found": "odom", "wanted": "map"}
    school.truth.receive(school.message(code="localisation_other_frame", params=params))
    assert "odom" in school.published[0]["message"]
    assert school.published[0]["remedy"]
    assert school.end() == []
    assert school.states() == ["localisation_other_frame", "nothing"]


def test_without_a_topic_nothing_is_followed(school: School) -> None:
    school.begin(DdsProfile())
    school.sample(1, 0.0)
    school.localise(0.0)
    school.truth.observe({"type": "run_ended", "run": school.run})
    assert school.published == []


@pytest.mark.waits
def test_a_run_on_a_robot_with_localisation_is_measured_by_it(school: School) -> None:
    ended: queue.Queue[dict[str, Any]] = queue.Queue()

    def on_event(event: dict[str, Any]) -> None:
        school.truth.observe(event)
        if event["type"] == "run_ended":
            ended.put(event)

    with own_domain() as domain:
        peer = DdsPeer(domain, localisation="PoseWithCovarianceStamped")
        robot = local_profile(domain, localisation_topic="amcl_pose")
        client = EngineClient(on_event, on_localised=school.truth.receive)
        try:
            client.start()
            client.wait_until_ready(SOON_S)
            school.begin(robot)
            document = [
                {"action": "turn", "angle": 90},
                {"action": "move_forward", "distance": 0.4},
            ]
            spec = RunSpec(document, "empty_room", link="dds", robot=robot, inputs=ScriptedInputs())
            client.run(school.run, spec)
            assert ended.get(timeout=SOON_S)["state"] == "finished"
        finally:
            client.close()
            peer.close()
    poses = school.end()
    _, x, y, heading, sigma_m, _ = poses[-1]
    assert (x, y, heading) == pytest.approx((0.0, 0.4, math.pi / 2), abs=0.03)
    assert 0.02 <= sigma_m < 0.05
    assert len(poses) > 20
