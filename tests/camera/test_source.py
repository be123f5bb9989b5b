"""A camera that is opened: its frames come, and what is wrong with it is noticed."""

import threading
import time
from collections.abc import Callable, Iterator

import numpy as np
import pytest

from pinel_desktop.camera import source as module
from pinel_desktop.camera.frames import RawFrame
from pinel_desktop.camera.source import CameraSource
from pinel_desktop.errors import PinelError

WAIT_S = 10.0
NOISE = np.random.default_rng(3)


def noisy(brightness: int) -> RawFrame:
    return RawFrame(NOISE.integers(brightness, brightness + 9, (48, 64, 3), np.uint8))


class Driver:
    """A webcam whose behaviour a test chooses: gives shots, None, or blocks."""

    is_live = True

    def __init__(self) -> None:
        self.give: Callable[[], RawFrame | None] = lambda: noisy(120)
        self.n_opened, self.refuses = 0, False
        self.blocked = threading.Event()

    def open(self, address: str) -> "Driver":
        if self.refuses:
            raise PinelError("camera_missing", number=1)
        self.n_opened += 1
        return self

    def read(self) -> RawFrame | None:
        time.sleep(0.005)
        return self.give()

    def close(self) -> None:
        return


@pytest.fixture
def driver() -> Driver:
    return Driver()


@pytest.fixture
def camera(driver: Driver, monkeypatch: pytest.MonkeyPatch) -> Iterator[CameraSource]:
    for name, seconds in (("NO_FRAME_S", 0.2), ("SAME_FRAME_S", 0.3), ("_RETRY_S", 0.05)):
        monkeypatch.setattr(module, name, seconds)
    monkeypatch.setattr(module, "_CHECK_S", 0.02)
    source = CameraSource("0", driver.open)
    yield source
    source.close()


def wait_for_problem(camera: CameraSource, code: str | None) -> None:
    deadline = time.monotonic() + WAIT_S
    while (camera.problem.code if camera.problem else None) != code:
        assert time.monotonic() < deadline, camera.problem
        time.sleep(0.01)


def test_next_frame_is_always_a_later_one(camera: CameraSource) -> None:
    last_s = 0.0
    for _ in range(5):
        frame = camera.next_frame(last_s, WAIT_S)
        assert frame is not None
        assert frame.time_s > last_s
        last_s = frame.time_s
    assert camera.is_open
    assert camera.problem is None


@pytest.mark.parametrize(
    ("brightness", "code"), [(0, "camera_black"), (20, "camera_dark"), (120, None)]
)
def test_light_is_judged(
    driver: Driver, camera: CameraSource, brightness: int, code: str | None
) -> None:
    driver.give = lambda: noisy(brightness)
    wait_for_problem(camera, code)
    driver.give = lambda: noisy(120)
    wait_for_problem(camera, None)


def test_camera_that_always_gives_the_same_is_frozen(driver: Driver, camera: CameraSource) -> None:
    same = noisy(120)
    driver.give = lambda: same
    wait_for_problem(camera, "camera_frozen")
    driver.give = lambda: noisy(120)
    wait_for_problem(camera, None)


def test_camera_that_is_unplugged_is_told_and_found_again(
    driver: Driver, camera: CameraSource
) -> None:
    assert camera.next_frame(0.0, WAIT_S)
    driver.give, driver.refuses = lambda: None, True
    wait_for_problem(camera, "camera_missing")
    assert not camera.is_open
    driver.give, driver.refuses = lambda: noisy(120), False
    wait_for_problem(camera, None)
    assert driver.n_opened == 2


def test_driver_that_blocks_for_ever_is_noticed(driver: Driver, camera: CameraSource) -> None:
    assert camera.next_frame(0.0, WAIT_S)
    release = threading.Event()

    def block() -> RawFrame | None:
        release.wait(WAIT_S)
        return None

    driver.give = block
    wait_for_problem(camera, "camera_no_picture")
    release.set()


def test_driver_that_fails_in_its_own_way_is_told_and_tried_again(
    driver: Driver, camera: CameraSource
) -> None:
    assert camera.next_frame(0.0, WAIT_S)

    def broken() -> RawFrame | None:
        raise RuntimeError("select timeout")

    driver.give = broken
    wait_for_problem(camera, "camera_no_picture")
    driver.give = lambda: noisy(120)
    wait_for_problem(camera, None)
    assert driver.n_opened >= 2
