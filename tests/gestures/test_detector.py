"""Detectors from ONNX files: what is read in a picture, and what is refused and why."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import onnx
import pytest
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.letters import LETTERS
from pinel_desktop.gestures.recognition import LandmarkRecognizer
from pinel_desktop.gestures.recognizers import open_recognizer
from pinel_desktop.gestures.yolo import address
from pinel_desktop.gestures.yolo.detector import YoloDetector, letterbox, open_detector
from tests.gestures.colour_detector import (
    GREEN,
    GREY,
    METADATA,
    RED,
    SIDE,
    coloured,
    model,
    write_detector,
)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return write_detector(tmp_path / "colours.onnx")


def test_the_sign_of_a_picture_is_found_with_its_place(file: Path) -> None:
    detector = open_recognizer(f"yolo:{file}")
    assert detector.signs == ("A", "B")
    (sign,) = detector.read(coloured(RED, 320, 240))
    assert (sign.prediction.sign, sign.prediction.best, sign.prediction.second) == ("A", "A", "B")
    assert sign.prediction.confidence > 0.6
    # the picture fills the input in width: 5 px of it are one of the input, with 8 px of border above
    assert sign.box == pytest.approx((60.0, 5.0, 260.0, 155.0))
    assert sign.hand is None
    assert detector.track(coloured(GREEN))[0].prediction.sign == "B"


def test_a_weak_sign_is_doubted_and_no_sign_is_none(file: Path) -> None:
    detector = open_detector(file)
    assert detector.read(coloured(GREY)) == []
    (weak,) = detector.read(coloured((140, 40, 40), 200, 200))
    assert (weak.prediction.sign, weak.prediction.best) == (None, "A")
    (both,) = detector.read(coloured((250, 240, 20), 200, 200))
    assert (both.prediction.sign, both.prediction.best, both.prediction.second) == (None, "A", "B")


@pytest.mark.parametrize("size", [(640, 360), (360, 640), (16, 16), (3000, 17)])
def test_a_picture_of_any_shape_is_fitted_without_a_stretch(size: tuple[int, int]) -> None:
    width, height = size
    fitted, scale, (x, y) = letterbox(coloured(RED, width, height), (SIDE, 2 * SIDE))
    assert fitted.shape == (SIDE, 2 * SIDE, 3)
    inside = (fitted == RED).all(axis=2)
    rows, columns = np.flatnonzero(inside.any(1)), np.flatnonzero(inside.any(0))
    assert (columns[0], rows[0]) == (x, y)
    assert len(columns) == max(1, round(width * scale))
    assert len(rows) == max(1, round(height * scale))


def test_the_landmarks_are_a_recognizer_too() -> None:
    recognizer = open_recognizer("landmarks")
    assert isinstance(recognizer, LandmarkRecognizer)
    assert set(recognizer.signs) == set(LETTERS)


@pytest.mark.parametrize("name", ["", "yolo", "yolo:", "landmarks:x", "other:file.onnx"])
def test_a_recognizer_that_does_not_exist_is_refused(name: str) -> None:
    with pytest.raises(PinelError, match="recognizer_unknown"):
        open_recognizer(name)


def external(tmp_path: Path) -> onnx.ModelProto:
    """A model whose numbers are in another file, beside it and in the working folder."""
    made = model()
    onnx.save_model(
        made,
        str(tmp_path / "saved.onnx"),
        save_as_external_data=True,
        location="numbers.bin",
        size_threshold=0,
    )
    return onnx.load(str(tmp_path / "saved.onnx"), load_external_data=False)


@pytest.mark.parametrize(
    ("code", "made"),
    [
        ("detector_task_wrong", model({**METADATA, "task": "segment"})),
        ("detector_task_wrong", model({**METADATA, "task": "classify"})),
        ("detector_names_missing", model({"task": "detect"})),
        ("detector_names_missing", model({**METADATA, "names": "{0: 'A', 2: 'B'}"})),
        ("detector_names_missing", model({**METADATA, "names": "['A', 'A']"})),
        ("detector_names_missing", model({**METADATA, "names": "__import__('os').getcwd()"})),
        ("detector_names_missing", model({**METADATA, "names": "(" * 5000})),
        ("detector_shape_wrong", model({**METADATA, "names": "['A', 'B', 'C']"})),
        ("detector_shape_wrong", model(shape=(1, 3, 8, 8))),
        ("detector_shape_wrong", model(shape=(4, 3, SIDE, SIDE))),
        ("detector_shape_wrong", model({**METADATA, "imgsz": "big"}, shape=(1, 3, "h", "w"))),
        ("detector_output_invalid", model(box=(float("nan"),) * 4)),
        ("detector_not_alone", model(operator="my.operators")),
    ],
)
def test_another_model_is_refused_with_the_reason(
    tmp_path: Path, code: str, made: onnx.ModelProto
) -> None:
    file = write_detector(tmp_path / "model.onnx", made)
    with pytest.raises(PinelError, match=code) as refused:
        open_detector(file)
    assert refused.value.params["file"] == "model.onnx"


def test_data_in_another_file_is_not_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = write_detector(tmp_path / "external.onnx", external(tmp_path))
    monkeypatch.chdir(tmp_path)
    assert (tmp_path / "numbers.bin").is_file()
    with pytest.raises(PinelError, match="detector_not_alone"):
        open_detector(file)


def test_sides_that_the_file_leaves_open_are_those_of_the_training(tmp_path: Path) -> None:
    file = write_detector(tmp_path / "open.onnx", model(shape=(1, 3, "h", "w")))
    assert open_detector(file).read(coloured(RED))[0].prediction.sign == "A"


@pytest.mark.parametrize("content", [b"", b"hello " * 1000, model().SerializeToString()[:200]])
def test_what_is_no_model_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "text.onnx").write_bytes(content)
    with pytest.raises(PinelError, match="detector_unreadable"):
        open_detector(tmp_path / "text.onnx")


def test_missing_wrong_and_too_large_files_are_refused_unread(tmp_path: Path) -> None:
    for name, code in (("none.onnx", "detector_missing"), ("model.txt", "detector_type_wrong")):
        with pytest.raises(PinelError, match=code):
            open_detector(tmp_path / name)
    (tmp_path / "folder.onnx").mkdir()
    with pytest.raises(PinelError, match="detector_missing"):
        open_detector(tmp_path / "folder.onnx")
    with (tmp_path / "large.onnx").open("wb") as large:
        large.truncate(address.MAX_FILE_BYTES + 1)  # a hole: it takes no room on the disk
    with pytest.raises(PinelError, match="detector_too_large"):
        open_detector(tmp_path / "large.onnx")


def test_a_pt_file_without_pytorch_names_the_extra(tmp_path: Path) -> None:
    """In a process of its own, whose Python finds no PyTorch, whatever this one has."""
    (tmp_path / "best.pt").write_bytes(b"PK")
    script = (
        "import sys; sys.modules['torch'] = None\n"
        "from pathlib import Path\n"
        "from pinel_desktop.errors import PinelError\n"
        "from pinel_desktop.gestures.yolo.detector import open_detector\n"
        "try: open_detector(Path(sys.argv[1]))\n"
        "except PinelError as error: print(error.code)\n"
    )
    command = [sys.executable, "-c", script, str(tmp_path / "best.pt")]
    output = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert output.strip() == "detector_extra_missing"


class _Broken:
    """A network whose output has numbers that are none, as after a training that went wrong."""

    file = "broken.onnx"
    names: tuple[str, ...] = ("A",)
    size = (SIDE, SIDE)

    def __call__(self, batch: NDArray[np.float32]) -> NDArray[np.float32]:
        output = np.array([[32, 32], [32, 32], [20, 20], [20, 20], [0.9, 0.8]], np.float32)
        if batch.max() > 0.9:
            output[0, 0] = np.nan
        return output


def test_boxes_that_are_no_numbers_are_left_out() -> None:
    detector = YoloDetector(_Broken())
    assert [one.prediction.confidence for one in detector.read(coloured(RED))] == [
        pytest.approx(0.8)
    ]
