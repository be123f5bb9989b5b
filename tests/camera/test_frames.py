"""Sources of frames: pictures, videos, recordings, and what a driver may give instead of a frame."""

import re
from itertools import islice
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

import pinel_desktop
from pinel_desktop.camera.frames import FrameReader, as_rgb, open_reader
from pinel_desktop.camera.landmark_sequence import (
    RecordedHand,
    read_landmark_sequence,
    write_landmark_sequence,
)
from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.features import N_ACTIVATIONS, N_SHAPE

pytestmark = pytest.mark.waits

RED_BGR = (0, 0, 255)


def picture(width: int = 64, height: int = 48) -> Any:
    return np.full((height, width, 3), RED_BGR, np.uint8)


def shapes(reader: FrameReader, n: int) -> set[tuple[int, ...]]:
    shots = [reader.read() for _ in range(n)]
    reader.close()
    return {shot.picture.shape for shot in shots if shot}


@pytest.mark.parametrize(
    "garbage",
    [
        None,
        "frame",
        np.zeros((0, 0, 3), np.uint8),
        np.zeros((8, 640, 3), np.uint8),
        np.zeros((480, 640, 2), np.uint8),
        np.zeros((480, 640, 3), np.float32),
        np.zeros((2, 480, 640, 3), np.uint8),
    ],
)
def test_what_is_no_picture_is_no_frame(garbage: object) -> None:
    assert as_rgb(garbage) is None


def test_frames_are_rgb_whatever_the_driver_gives() -> None:
    bgr = picture()
    for frame in (bgr, cv2.cvtColor(bgr, cv2.COLOR_BGR2BGRA)):
        rgb = as_rgb(frame)
        assert rgb is not None
        assert tuple(rgb[0, 0]) == (255, 0, 0)
    grey = as_rgb(np.full((48, 64), 7, np.uint8))
    assert grey is not None
    assert grey.shape == (48, 64, 3)


def test_frame_of_an_8k_camera_is_reduced_in_its_proportions() -> None:
    rgb = as_rgb(np.zeros((4320, 7680, 3), np.uint8))
    assert rgb is not None
    assert rgb.shape[1] / rgb.shape[0] == pytest.approx(16 / 9, rel=0.01)
    assert max(rgb.shape) <= 1280


def test_folder_shows_its_pictures_by_name_again_and_again(tmp_path: Path) -> None:
    cv2.imwrite(str(tmp_path / "a.png"), picture(64, 48))
    cv2.imwrite(str(tmp_path / "b.PNG"), picture(48, 64))
    (tmp_path / "notes.txt").write_text("no picture", encoding="utf-8")
    assert shapes(open_reader(str(tmp_path)), 30) == {(48, 64, 3), (64, 48, 3)}


def test_damaged_pictures_of_a_folder_are_passed_over(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(100))
    cv2.imwrite(str(tmp_path / "b.png"), picture())
    assert shapes(open_reader(str(tmp_path)), 30) == {(48, 64, 3)}


def test_video_begins_again_at_its_end(tmp_path: Path) -> None:
    path = tmp_path / "video.avi"
    video = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"MJPG"), 30.0, (64, 48))
    for _ in range(3):
        video.write(picture())
    video.release()
    reader = open_reader(str(path))
    assert all(shot is not None for shot in (reader.read() for _ in range(8)))
    reader.close()


def test_recording_gives_hands_without_pictures(tmp_path: Path) -> None:
    path = tmp_path / "hands.npz"
    hand = RecordedHand(
        np.full((21, 2), 100, np.float32),
        np.ones(N_SHAPE + N_ACTIVATIONS, np.float32),
        is_left=True,
    )
    write_landmark_sequence(path, [hand, None])
    reader = open_reader(str(path))
    shots = list(islice(iter(reader.read, None), 3))
    assert [len(shot.hands or ()) for shot in shots] == [1, 0, 1]
    assert (shots[0].hands or ())[0].is_left
    assert len({shot.picture.tobytes() for shot in shots}) == 1


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04 no zip", bytes(1000)])
def test_damaged_recording_is_refused(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "hands.npz"
    path.write_bytes(content)
    with pytest.raises(PinelError, match="camera_source_unreadable"):
        read_landmark_sequence(path)


def test_recording_of_another_shape_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "hands.npz"
    one: dict[str, Any] = {"is_there": np.ones(1, bool), "is_left": np.ones(1, bool)}
    np.savez(path, points=np.zeros((1, 20, 2)), features=np.zeros((1, 3)), **one)
    with pytest.raises(PinelError, match="camera_source_unreadable"):
        read_landmark_sequence(path)
    np.savez(path, points=np.array([object()]), features=np.zeros((1, 3)), **one)
    with pytest.raises(PinelError, match="camera_source_unreadable"):
        read_landmark_sequence(path)


def test_source_that_cannot_be_opened_says_why(tmp_path: Path) -> None:
    text = tmp_path / "text.mp4"
    text.write_text("no video", encoding="utf-8")
    sources = {
        "9": "camera_missing",
        str(tmp_path / "nothing.mp4"): "camera_source_missing",
        str(text): "camera_source_unreadable",
        str(tmp_path): "camera_folder_empty",
    }
    for source, code in sources.items():
        with pytest.raises(PinelError) as caught:
            open_reader(source)
        assert caught.value.code == code


def test_opencv_is_loaded_with_its_limits_only() -> None:
    """A module that imports it by itself would load it without them."""
    sources = Path(pinel_desktop.__file__).parent.rglob("*.py")
    alone = [
        path.name
        for path in sources
        if re.search(r"^import cv2|^from cv2", path.read_text("utf-8"), re.M)
    ]
    assert alone == ["opencv.py"]


def test_frame_too_narrow_for_a_hand_is_no_frame(tmp_path: Path) -> None:
    for width, height in ((20, 20_000), (16_000, 16)):
        assert as_rgb(np.zeros((height, width, 3), np.uint8)) is None
        cv2.imwrite(str(tmp_path / f"{width}.png"), picture(width, height))
    cv2.imwrite(str(tmp_path / "z.png"), picture())
    assert shapes(open_reader(str(tmp_path)), 60) == {(48, 64, 3)}


def test_large_pictures_of_a_folder_are_reduced(tmp_path: Path) -> None:
    cv2.imwrite(str(tmp_path / "a.png"), picture(7680, 4320))
    assert shapes(open_reader(str(tmp_path)), 1) == {(720, 1280, 3)}


@pytest.mark.parametrize("wrong", [np.nan, np.inf])
def test_recording_of_what_is_no_number_is_refused(tmp_path: Path, wrong: float) -> None:
    for points, features in ((wrong, 0.0), (0.0, wrong)):
        hand = RecordedHand(
            np.full((21, 2), points, np.float32),
            np.full(N_SHAPE + N_ACTIVATIONS, features, np.float32),
            False,
        )
        write_landmark_sequence(tmp_path / "hand.npz", [hand])
        with pytest.raises(PinelError, match="camera_source_unreadable"):
            read_landmark_sequence(tmp_path / "hand.npz")
