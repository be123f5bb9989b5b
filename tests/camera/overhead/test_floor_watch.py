"""The camera process follows a robot above a floor, and the app records it as a truth of the run."""

import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from pinel_desktop.camera.client import CameraClient
from pinel_desktop.camera.overhead.markers import (
    OverheadSetup,
    checked_setup,
    setting_of,
    setup_of,
)
from pinel_desktop.camera.overhead.sheets import sheets_page
from pinel_desktop.camera.overhead_trial import sightings
from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.processes.messages import Message
from pinel_desktop.robot import Pose2D
from pinel_desktop.school.truths.floor_camera import FloorCamera
from pinel_desktop.school.truths.overhead import OverheadTruth
from pinel_desktop.settings import OVERHEAD, Settings
from storage import RunStart, Store, open_store
from tests.camera.overhead.rendering import Scene
from tests.storage.sample_documents import SQUARE, WORLD

PLACE = Pose2D(1.0, 2.0, 0.3)


@pytest.fixture(scope="module")
def pictures(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of what the camera sees of a robot at rest."""
    folder = tmp_path_factory.mktemp("overhead")
    scene = Scene()
    for n in range(2):
        cv2.imwrite(str(folder / f"{n}.png"), scene.picture(PLACE))
    return folder


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    with open_store(tmp_path / "pinel.db") as store:
        yield store


class Camera:
    """A camera client that only notes what it is to follow."""

    def __init__(self) -> None:
        self.setup: dict[str, float] | None = None

    def watch_floor(self, setup: dict[str, float] | None) -> None:
        self.setup = setup


def floor_camera(settings: Settings, camera: Camera) -> FloorCamera:
    it = FloorCamera(settings)
    it.use(camera)  # type: ignore[arg-type]
    return it


def test_the_process_sends_where_the_robot_is(pictures: Path) -> None:
    messages: list[Message] = []
    client = CameraClient(
        str(pictures),
        lambda event: None,
        lambda state: None,
        lambda run, capture: None,
        on_overhead=messages.append,
    )
    try:
        client.watch_floor(OverheadSetup().model_dump())
        until_s = time.monotonic() + 60
        while not any(one["pose"] for one in messages) and time.monotonic() < until_s:
            time.sleep(0.05)
    finally:
        client.close()
    found = next(one for one in messages if one["pose"])
    x, y, *_ = found["pose"]
    assert Pose2D(x, y).distance_to(PLACE) < 0.01
    assert found["markers"] == [1, 2, 3, 4, 5]


def test_poses_are_recorded_in_the_start_frame_at_the_tick_of_their_picture(store: Store) -> None:
    settings, camera = Settings(), Camera()
    settings.choose(OVERHEAD, setting_of(OverheadSetup()))
    published: list[Message] = []
    truth = OverheadTruth(store, floor_camera(settings, camera), published.append, lambda: "en")
    run = store.runs.begin(RunStart("dds", "room", WORLD, 1, "0.3", document=SQUARE)).id
    truth.begin(run)
    assert camera.setup == OverheadSetup().model_dump()
    for tick in range(1, 61):
        event = {"type": "telemetry", "run": run, "tick": tick, "yaw_rad": 0.0, "y_m": 0.0}
        truth.observe({**event, "x_m": 0.01 * max(0, tick - 30)})
        ahead = Pose2D(0.011 * max(0, tick - 3 - 30), 0.0, 0.0)  # three ticks old, 10 % farther
        seen = [*PLACE.compose(ahead), 0.003, 0.01]
        truth.receive({"pose": seen, "age_s": 0.1, "problem": None, "missing": []})
    truth.observe({"type": "run_ended", "run": run})
    assert camera.setup is None
    until_s = time.monotonic() + 10
    while not store.truths.of_run(run) and time.monotonic() < until_s:
        time.sleep(0.01)
    (camera_truth,) = store.truths.of_run(run)
    assert camera_truth.source == "camera"
    tick, x, y, *_ = camera_truth.poses[-1]
    assert (tick, x, y) == (57, pytest.approx(0.011 * 27, abs=1e-3), pytest.approx(0, abs=1e-3))


def test_a_covered_robot_and_its_return_are_reported_once_each(store: Store) -> None:
    settings, published = Settings(), list[Message]()
    settings.choose(OVERHEAD, setting_of(OverheadSetup()))
    truth = OverheadTruth(store, floor_camera(settings, Camera()), published.append, lambda: "en")
    truth.begin("r")
    truth.observe(
        {"type": "telemetry", "run": "r", "tick": 1, "x_m": 0.0, "y_m": 0.0, "yaw_rad": 0.0}
    )
    missed = {"pose": None, "age_s": 0.0, "problem": "overhead_floor_missing", "missing": [2, 3]}
    seen = {"pose": [0.0, 0.0, 0.0, 0.003, 0.01], "age_s": 0.0, "problem": None, "missing": []}
    for message in (seen, missed, missed, seen):
        truth.receive(message)
    assert [(event["state"], event["code"]) for event in published] == [
        ("problem", "overhead_floor_missing"),
        ("seeing", None),
    ]
    assert "2, 3" in published[0]["message"]


def test_without_a_camera_above_the_floor_nothing_is_followed(store: Store) -> None:
    camera = Camera()
    truth = OverheadTruth(store, floor_camera(Settings(), camera), lambda event: None, lambda: "en")
    truth.begin("r")
    assert camera.setup is None


def test_a_trial_follows_the_robot_until_nobody_asks_and_gives_way_to_a_run() -> None:
    settings, camera = Settings(), Camera()
    it = floor_camera(settings, camera)
    with pytest.raises(PinelError, match="overhead_not_set_up"):
        it.try_out()
    it.set_up(OverheadSetup())
    assert camera.setup is None
    assert it.try_out() is None
    assert camera.setup is not None
    it.receive({"pose": None, "problem": "overhead_covered", "missing": [], "markers": [1]})
    assert (it.try_out() or {})["markers"] == [1]
    assert it.begin_run()
    it.end_trial()
    assert camera.setup is not None  # of the run
    it.set_up(None)
    it.end_run()
    assert camera.setup is None


def test_a_measure_that_cannot_be_is_named_with_its_bounds() -> None:
    measures = OverheadSetup().model_dump()
    assert checked_setup(measures) == OverheadSetup()
    for value in (0.1, 11.0, float("nan")):
        with pytest.raises(PinelError) as refused:
            checked_setup({**measures, "depth_m": value})
        assert (refused.value.params["field"], refused.value.params["low"]) == ("depth_m", 0.5)


def test_the_setting_is_read_back_and_nonsense_is_none() -> None:
    setup = OverheadSetup(width_m=2.5, robot_m=0.123)
    assert setup_of(setting_of(setup)) == setup
    assert [setup_of(text) for text in ("", "1-2", "a-b-c-d", "99000-1-1-1")] == [None] * 4


def test_the_trial_reports_the_pose_of_the_robot(pictures: Path) -> None:
    code, params = next(iter(sightings(str(pictures), OverheadSetup(), 20)))
    assert code == "overhead_seen"
    assert float(str(params["x"])) == pytest.approx(PLACE.x_m, abs=0.01)


def test_the_sheets_have_each_marker_at_its_size() -> None:
    page = sheets_page("pt-BR")
    assert page.count("<section>") == 5
    assert 'width="160mm"' in page
    assert "Marcador 5, do robô" in page
