"""A whole run of a robot that slips, seen by a camera above a rendered floor, and compared with its prediction."""

import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.engine.client import EngineClient
from tests.links.dds_domains import local_profile, own_domain
from tests.links.dds_peer import DdsPeer
from tests.web.browser import Browser

pytestmark = [pytest.mark.waits, pytest.mark.timeout(300)]

SOON_S = 120.0
DISTANCE_M, SLIPS = 1.0, 0.1
MEASURES = {"width_m": 3.0, "depth_m": 3.0, "camera_m": 2.7, "robot_m": 0.25}
STRAIGHT: dict[str, Any] = {
    "pinel_ir": 1,
    "name": "straight",
    "functions": [],
    "commands": [
        {"action": "wait", "block": "w", "seconds": 3},  # the camera adjusts to the floor
        {"action": "move_forward", "block": "m", "distance": DISTANCE_M},
        {"action": "wait", "block": "e", "seconds": 1},
    ],
}


def watched_engine(*arguments: Any, **options: Any) -> EngineClient:
    """An engine whose robot somebody watches."""
    return EngineClient(*arguments, **{**options, "is_watched": lambda: True})


@pytest.fixture
def pose_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where the robot truly is; the camera process renders it."""
    file = tmp_path / "pose.json"
    command = [sys.executable, "-m", "tests.camera.overhead.rendered_camera", str(file)]
    monkeypatch.setattr("pinel_desktop.camera.client.own_command", lambda _name: command)
    return file


@pytest.fixture
def robot(pose_file: Path) -> Iterator[dict[str, Any]]:
    """The record of a robot in a process of its own."""
    with own_domain() as domain:
        peer = DdsPeer(domain, pose_file=str(pose_file), slips=SLIPS)
        yield local_profile(domain, max_v_mps=0.2).model_dump(mode="json")
        peer.close()


def wait_for(condition: Callable[[], Any]) -> Any:
    due_s = time.monotonic() + SOON_S
    while not (found := condition()):
        assert time.monotonic() < due_s
        time.sleep(0.1)
    return found


def test_a_run_under_the_overhead_camera_is_compared_by_it(
    start_app: Callable[..., App], robot: dict[str, Any]
) -> None:
    app = start_app(make_engine=watched_engine)
    teacher = Browser.signed_in(app.address)
    teacher.put("/api/teacher/pin", {"pin": "314159"})
    assert teacher.put("/api/real-robots/dds", {"record": robot}).status == 200
    assert teacher.put("/api/overhead", MEASURES).data["is_on"]
    wait_for(lambda: teacher.post("/api/overhead/trial").data["code"] == "overhead_seen")

    group = teacher.post("/api/groups", {"name": "Os Tatus"}).data["id"]
    program = teacher.post(f"/api/groups/{group}/programs", {"name": "Reta"}).data["id"]
    content = {"workspace": {"blocks": {}}, "document": STRAIGHT}
    version = teacher.post(f"/api/programs/{program}/versions", content).data["id"]
    answer = teacher.post("/api/runs", {"version_id": version, "world": "room", "robot": "dds"})
    run = answer.data["id"]
    truths = wait_for(lambda: teacher.get(f"/api/runs/{run}/truths").data["truths"])

    (camera,) = truths
    assert camera["source"] == "camera"
    assert camera["covered_s"] > 2
    end = camera["poses"][-1]
    assert end["x_m"] == pytest.approx((1 - SLIPS) * DISTANCE_M, abs=0.02)
    assert end["y_m"] == pytest.approx(0.0, abs=0.02)
    prediction = teacher.get(f"/api/runs/{run}/prediction").data
    assert prediction["difference"]["source"] == "camera"
    (finding,) = prediction["difference"]["findings"]
    assert (finding["block"], finding["source"]) == ("m", "camera")
    assert finding["difference"] == pytest.approx(-SLIPS * DISTANCE_M, abs=0.05)
