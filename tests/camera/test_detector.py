"""The camera process with another recognizer than the landmarks, over pictures of one colour."""

import os
import queue
import signal
from pathlib import Path

import pytest

from pinel_desktop.camera.client import RecognizerState
from tests.camera.test_client import WAIT_S, Harness
from tests.gestures.colour_detector import GREEN, RED, write_detector, write_pictures

pytestmark = pytest.mark.waits


def test_its_signs_answer_captures_without_landmarks(tmp_path: Path) -> None:
    detector = write_detector(tmp_path / "colours.onnx")
    harness = Harness(str(write_pictures(tmp_path / "green", GREEN)))
    try:
        harness.camera.set_recognizer(f"yolo:{detector}")
        state = harness.camera.wait_for_recognizer(WAIT_S)
        assert (state.problem, state.signs) == (None, ("A", "B"))
        harness.event("capture_started")
        _, capture = harness.answers.get(timeout=WAIT_S)
        assert (capture.label, capture.by, capture.second) == ("B", "camera", "A")
        (hand,) = next(event["hands"] for event in iter(harness.events.get, None) if event["hands"])
        assert (hand["points"], hand["handedness"], hand["sure"]) == ([], None, True)
        assert all(0.0 <= side <= 1.0 for side in hand["box"])
    finally:
        harness.camera.close()


def test_one_that_cannot_be_used_leaves_the_landmarks(tmp_path: Path) -> None:
    (tmp_path / "text.onnx").write_text("no model")
    harness = Harness()
    try:
        harness.camera.set_recognizer(f"yolo:{tmp_path / 'text.onnx'}")
        state = harness.camera.wait_for_recognizer(WAIT_S)
        assert state.problem is not None
        assert (state.problem.code, state.in_use) == ("detector_unreadable", "landmarks")
        harness.event("capture_started")
        assert harness.answers.get(timeout=WAIT_S)[1].label == "B"
    finally:
        harness.camera.close()


@pytest.mark.skipif(os.name == "nt", reason="Windows kills in another way")
def test_a_new_process_loads_it_again(tmp_path: Path) -> None:
    detector = write_detector(tmp_path / "colours.onnx")
    loaded: queue.Queue[RecognizerState] = queue.Queue()
    harness = Harness(str(write_pictures(tmp_path / "red", RED)), on_recognizer=loaded.put)
    try:
        harness.camera.set_recognizer(f"yolo:{detector}")
        harness.camera.start()
        assert loaded.get(timeout=WAIT_S).is_loaded
        pid = harness.camera.pid
        assert pid is not None
        os.kill(pid, signal.SIGKILL)
        assert loaded.get(timeout=WAIT_S).signs == ("A", "B")
        harness.event("capture_started")
        assert harness.answers.get(timeout=WAIT_S)[1].label == "A"
    finally:
        harness.camera.close()
