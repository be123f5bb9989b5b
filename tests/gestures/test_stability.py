"""When a sign counts as shown."""

import numpy as np
import pytest
from numpy.typing import NDArray

from pinel_desktop.gestures.stability import (
    MIN_HOLD_S,
    N_FRAMES,
    Decision,
    FramePrediction,
    StabilityFilter,
)

FIST = np.random.default_rng(1).uniform(100, 200, (21, 2)).astype(np.float32)


class Camera:
    """Frames at a steady rate."""

    def __init__(self, rate_hz: float = 15.0) -> None:
        self.stability_filter, self._step_s, self.now_s = StabilityFilter(), 1.0 / rate_hz, 0.0
        self.confidence = 0.98

    def show(self, label: str | None, points: NDArray[np.float32] | None = FIST) -> Decision | None:
        self.now_s += self._step_s
        return self.stability_filter.update(
            FramePrediction(self.now_s, label, self.confidence, "S", points)
        )

    def show_for(self, n: int, label: str | None) -> list[Decision]:
        return [decision for _ in range(n) if (decision := self.show(label))]


@pytest.mark.parametrize("rate_hz", [5.0, 15.0, 30.0, 120.0])
def test_steady_sign_is_decided_after_some_frames_and_some_time(rate_hz: float) -> None:
    camera = Camera(rate_hz)
    while not (decision := camera.show("A")):
        assert camera.now_s < 2.0
    assert decision == Decision("A", 0.98, "S")
    assert camera.now_s >= MIN_HOLD_S
    assert camera.now_s * rate_hz >= N_FRAMES - 0.5


def test_progress_grows_to_the_decision_and_begins_anew() -> None:
    camera = Camera()
    progress = []
    while not camera.show("A"):
        progress.append(camera.stability_filter.progress)
    assert progress == sorted(progress)
    assert 0.0 <= progress[0] < progress[-1] < 1.0
    assert camera.stability_filter.progress == 0.0


@pytest.mark.parametrize("other", ["B", None])
def test_frame_that_says_something_else_begins_anew(other: str | None) -> None:
    camera = Camera()
    assert not camera.show_for(4, "A")
    assert not camera.show(other)
    assert not camera.show_for(4, "A")
    assert camera.show_for(4, "A")


def test_hand_on_its_way_is_not_counted() -> None:
    camera = Camera()
    for i in range(60):
        assert camera.show("A", FIST + 20 * i) is None
    assert camera.stability_filter.progress == 0.0


def test_hand_that_trembles_is_counted() -> None:
    camera, noise = Camera(), np.random.default_rng(2)
    decisions = [
        camera.show("A", FIST + noise.normal(0, 1.0, (21, 2)).astype(np.float32)) for _ in range(10)
    ]
    assert any(decisions)


def test_sign_that_is_not_certain_is_waited_for() -> None:
    camera = Camera()
    camera.confidence = 0.9
    assert not camera.show_for(10, "A")
    assert camera.stability_filter.progress == 1.0
    camera.confidence = 0.999
    assert camera.show_for(60, "A")


def test_sequence_of_doubtful_frames_decides_nothing() -> None:
    camera = Camera()
    assert not camera.show_for(100, None)
    assert camera.stability_filter.label == ""


def test_nothing_of_before_counts_once_begun_anew() -> None:
    camera = Camera()
    camera.show_for(4, "A")
    camera.stability_filter.reset()
    assert not camera.show_for(4, "A")
