"""`pinel run --camera` on the command line: what answers captures, and what is no camera or recognizer."""

import math
import os
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.commands.typed import SQUARE, pinel, run_json
from tests.gestures.colour_detector import GREEN, RED, write_detector, write_pictures


@pytest.mark.waits
@pytest.mark.parametrize(("letter", "metres"), [("l", 2), ("w", 3)])
def test_robot_drives_as_many_metres_as_fingers_are_raised_in_front_of_the_camera(
    letter: str, metres: int
) -> None:
    hand = Path(__file__).parents[1] / "camera" / "recordings" / f"{letter}.npz"
    program = "robot.read_number(timeout=30)\nrobot.move_forward(robot.number_shown)\n"
    status, printed = run_json("-", "--camera", str(hand), "--no-store", text=program)
    assert (status, printed["state"]) == (0, "finished")
    assert printed["pose"]["x_m"] == pytest.approx(metres, abs=0.001)


def no_video(folder: Path) -> Path:
    path = folder / "lesson.mp4"
    path.write_bytes(b"no video")
    return path


def pipe(folder: Path) -> Path:
    """Whoever opens it waits for ever."""
    os.mkfifo(folder / "pipe.mp4")
    return folder / "pipe.mp4"


@pytest.mark.parametrize(
    ("make", "reason"),
    [
        (lambda folder: folder / "nowhere.mp4", "camera_source_missing"),
        (lambda folder: folder / ("a" * 300), "camera_source_missing"),
        (lambda folder: folder, "camera_folder_empty"),
        (no_video, "camera_source_unreadable"),
        (pipe, "camera_source_missing"),
    ],
)
def test_camera_that_cannot_be_meant_ends_with_2_before_the_robot_moves(
    tmp_path: Path, make: Callable[[Path], Path], reason: str
) -> None:
    source = str(make(tmp_path))
    status, printed = run_json(SQUARE, "--camera", source, "--no-store")
    assert (status, printed["reason"], printed["pose"]) == (2, reason, None)
    assert source in printed["message"]


@pytest.mark.parametrize("number", ["9", "99999999999999999999"])
def test_webcam_that_is_not_there_ends_with_2_before_the_robot_moves(number: str) -> None:
    status, printed = run_json(SQUARE, "--camera", number, "--no-store")
    assert (status, printed["reason"], printed["pose"]) == (2, "camera_missing", None)
    assert re.findall(r"\d+", printed["message"]) == [number]


@pytest.mark.waits
@pytest.mark.parametrize(("colour", "pose"), [(GREEN, (0.2, 0.0)), (RED, (0.0, math.pi / 2))])
def test_a_detector_answers_captures(
    tmp_path: Path, colour: tuple[int, int, int], pose: tuple[float, float]
) -> None:
    detector = write_detector(tmp_path / "colours.onnx")
    pictures = write_pictures(tmp_path / "pictures", colour)
    file = tmp_path / "b_or_a.py"
    file.write_text(
        "robot.classify_gestures(timeout=60)\n"
        'if robot.gesture_result == "B":\n    robot.move_forward(0.2)\n'
        'elif robot.gesture_result == "A":\n    robot.turn(90)\n'
    )
    looking = ("--camera", str(pictures), "--recognizer", f"yolo:{detector}")
    status, printed = run_json(str(file), *looking, "--no-store")
    assert status == 0
    assert (printed["pose"]["x_m"], printed["pose"]["yaw_rad"]) == pytest.approx(pose, abs=0.01)


def test_a_detector_that_cannot_be_used_ends_with_2_before_the_robot_moves(tmp_path: Path) -> None:
    (tmp_path / "text.onnx").write_text("no model")
    looking = ("--camera", str(write_pictures(tmp_path / "pictures", RED)))
    for name, reason in (
        (f"yolo:{tmp_path / 'text.onnx'}", "detector_unreadable"),
        (f"yolo:{tmp_path / 'none.onnx'}", "detector_missing"),
        ("eyes", "recognizer_unknown"),
    ):
        status, printed = run_json(SQUARE, *looking, "--recognizer", name, "--no-store")
        assert (status, printed["reason"], printed["pose"]) == (2, reason, None)


def test_page_is_not_served_with_a_recognizer_that_is_not_there(tmp_path: Path) -> None:
    result = pinel("serve", "--recognizer", f"yolo:{tmp_path / 'none.onnx'}")
    assert result.exit_code == 1
    assert "none.onnx" in result.stderr


def test_page_is_not_served_with_a_camera_that_is_not_there(tmp_path: Path) -> None:
    result = pinel("serve", "--camera", str(tmp_path / "nowhere.mp4"))
    assert result.exit_code == 1
    assert "nowhere.mp4" in result.stderr
