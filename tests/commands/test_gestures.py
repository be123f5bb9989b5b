"""`pinel gestures`, as it is typed, with drawn hands."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from pinel_desktop.gestures import networks
from pinel_desktop.gestures.training import evaluation
from pinel_desktop.gestures.training.folds import CROPS
from pinel_desktop.gestures.training.moving_hands import letter_path
from pinel_desktop.paths import database_path
from storage import open_store
from tests.camera.moving_hands import write_moving_hand
from tests.commands.typed import pinel
from tests.gestures.colour_detector import RED, coloured, write_detector
from tests.gestures.drawn import drawn_hand
from tests.gestures.photo_folder import LETTERS, SOURCES, make_photos


def written(path: Path, picture: np.ndarray) -> str:
    cv2.imwrite(str(path), picture[..., ::-1])
    return str(path)


def lines(text: str) -> list[dict[str, Any]]:
    return [json.loads(line) for line in text.splitlines()]


def test_each_picture_gets_a_line(tmp_path: Path) -> None:
    hand = written(tmp_path / "l.png", drawn_hand())
    wall = written(tmp_path / "wall.png", np.full((480, 640, 3), 90, np.uint8))
    done = pinel("gestures", "classify", hand, wall)
    assert done.exit_code == 0
    sign, nothing = lines(done.stdout)
    assert list(sign) == [
        "file", "letter", "best", "confidence", "second", "box", "handedness", "ms",
    ]  # fmt: skip
    assert (sign["file"], sign["letter"], sign["best"]) == (hand, "L", "L")
    assert 0 < sign["confidence"] <= 1
    assert sign["handedness"] in ("left", "right")
    left, top, right, bottom = sign["box"]
    assert 100 < left < right < 450
    assert 100 < top < bottom < 550
    assert nothing == {**dict.fromkeys(sign), "file": wall, "ms": nothing["ms"]}


def test_a_stretched_picture_is_read_with_its_own_shape(tmp_path: Path) -> None:
    wide = np.full((640, 1138, 3), (70, 90, 110), np.uint8)
    wide[:, 250:890] = drawn_hand()
    file = written(tmp_path / "stretched.png", np.asarray(cv2.resize(wide, (640, 640))))
    (found,) = lines(pinel("gestures", "classify", "--aspect", "16:9", file).stdout)
    assert found["letter"] == "L"
    assert found["box"][2] > 500  # pixels of the picture without stretch


def test_a_detector_classifies_pictures_in_the_same_form(tmp_path: Path) -> None:
    detector = write_detector(tmp_path / "colours.onnx")
    red = written(tmp_path / "red.png", coloured(RED))
    done = pinel("gestures", "classify", "--recognizer", f"yolo:{detector}", red)
    (found,) = lines(done.stdout)
    assert (found["letter"], found["second"], found["handedness"]) == ("A", "B", None)
    assert found["box"] == [60, 5, 260, 155]


def test_pictures_for_a_detector_are_unstretched_and_a_source_can_be_left_out(
    tmp_path: Path,
) -> None:
    photos = make_photos(tmp_path / "photos").parent
    target = tmp_path / "data"
    done = pinel("gestures", "yolo-data", str(photos), str(target), "--without", "p2_webcam")
    assert done.exit_code == 0
    assert done.stdout.strip() == str(target / "data.yaml")
    assert 'names: ["B", "L", "V"]' in (target / "data.yaml").read_text("utf-8")
    names = {
        part: {f.name for f in (target / part / "images").iterdir()} for part in ("train", "valid")
    }
    assert {name.split("_")[0] for name in names["valid"]} == {"p2"}
    assert {name.split("_")[0] for name in names["train"]} == {
        "p1",
        "p3",
    }  # g8 may show any of them
    height, width = cv2.imread(str(target / "valid" / "images" / "p2_webcam_L0.jpg")).shape[:2]
    assert width / height == pytest.approx(16 / 9, abs=0.01)
    label = (target / "valid" / "labels" / "p2_webcam_L0.txt").read_text("utf-8")
    assert label.split()[0] == "1"
    old = (photos / "train" / "labels" / "p2_webcam_L0.txt").read_text("utf-8")
    assert [float(side) for side in label.split()[1:]] == pytest.approx(
        [float(side) for side in old.split()[1:]], abs=1e-5
    )


def test_landmarks_and_a_detector_are_compared_in_one_table(tmp_path: Path) -> None:
    photos = make_photos(tmp_path / "photos", n_each=1).parent
    detector = write_detector(tmp_path / "colours.onnx")
    left_out = ("--left-out", f"p1_webcam={detector}")
    done = pinel("gestures", "compare", str(photos), "--detector", str(detector), *left_out)
    assert done.exit_code == 0, done.stderr
    head, _, *rows = done.stdout.splitlines()
    assert head == "| | landmarks | YOLOv8n |"
    assert rows[0].startswith("| p1_webcam: right | 1.000 [")
    assert [row.split("|")[1].strip() for row in rows][-2:] == [
        "ms a frame, one thread",
        "memory, MB",
    ]


def test_a_detector_is_evaluated_as_it_is(tmp_path: Path) -> None:
    photos = str(make_photos(tmp_path / "photos").parent)
    detector = f"yolo:{write_detector(tmp_path / 'colours.onnx')}"
    done = pinel("gestures", "evaluate", photos, "--recognizer", detector, "--json")
    report = json.loads(done.stdout)
    assert report["photos"] == report["right"]["of"] == report["painted_over_answered"]["of"] == 24
    assert set(report) == {
        "photos", "right", "answered", "right_of_answered", "painted_over_answered",
    }  # fmt: skip
    refused = pinel("gestures", "evaluate", photos, "--recognizer", detector, "--numbers")
    assert refused.exit_code == 2


@pytest.mark.parametrize("data", ["none.yaml", "text.yaml"])
def test_a_detector_is_not_trained_without_data(tmp_path: Path, data: str) -> None:
    (tmp_path / "text.yaml").write_text("nothing")
    done = pinel("gestures", "train-yolo", str(tmp_path / data))
    assert done.exit_code == 1
    assert data in done.stderr


@pytest.mark.parametrize("aspect", ["16", "16:0", "a:b", "1:100", "-1:1"])
def test_an_aspect_of_another_form_is_refused(tmp_path: Path, aspect: str) -> None:
    done = pinel("gestures", "classify", f"--aspect={aspect}", str(tmp_path / "a.png"))
    assert done.exit_code == 2
    assert "16:9" in done.stderr


def test_a_file_that_is_no_picture_is_named_and_the_others_are_read(tmp_path: Path) -> None:
    text = tmp_path / "text.png"
    text.write_text("no picture", "utf-8")
    done = pinel("gestures", "classify", str(text), written(tmp_path / "l.png", drawn_hand()))
    assert done.exit_code == 2
    assert f"“{text}” is no picture that can be read." in done.stderr
    assert [found["best"] for found in lines(done.stdout)] == ["L"]


def test_a_missing_network_is_said_in_words(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    missing = networks.NetworkFile("none.onnx", networks.PALM.sha256)
    monkeypatch.setattr("pinel_desktop.gestures.hands.PALM", missing)
    done = pinel("gestures", "classify", str(tmp_path / "a.png"))
    assert done.exit_code == 1
    assert "A part of the sign recognition is missing" in done.stderr
    assert "make setup" in done.stderr


def test_letters_trained_from_a_folder_are_evaluated_by_source(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # trains half as often; tests/gestures/test_training.py has what it counts
    monkeypatch.setattr(evaluation, "unknown_refused", lambda *_: {})
    trained_and_evaluated(tmp_path, SOURCES[:2])


@pytest.mark.nightly
@pytest.mark.timeout(400)  # trains 24 times
def test_letters_trained_from_all_sources_are_evaluated_by_source(tmp_path: Path) -> None:
    report = trained_and_evaluated(tmp_path, SOURCES)
    assert set(report["strict"]["unknown_letter_refused"]["by_letter"]) == set(LETTERS)


def trained_and_evaluated(tmp_path: Path, sources: Sequence[str]) -> dict[str, Any]:
    table = make_photos(tmp_path, sources=sources)
    recordings, trained = tmp_path / "recordings.npz", tmp_path / "letters.npz"
    folder = (str(tmp_path), "--recordings", str(recordings))
    done = pinel("gestures", "train", *folder, "--output", str(trained))
    assert done.exit_code == 0
    assert "3 letters" in done.stdout
    assert trained.is_file()
    unseen = pinel("gestures", "evaluate", *folder, "--leave-one-source-out", str(table), "--json")
    report: dict[str, Any] = json.loads(unseen.stdout)
    assert report["photos"] == 6 * len(sources)
    assert set(report["strict"]["by_source"]) == {*sources} - {CROPS}
    assert set(report["speed_ms"]) == {"cold", "tracking"}
    known = pinel("gestures", "evaluate", *folder)
    assert known.exit_code == 0
    assert "hands_found / by_source / p1_webcam: 1.000 [" in known.stdout
    return report


def test_a_folder_without_a_table_is_said_to_hold_no_pictures(tmp_path: Path) -> None:
    for command in ("evaluate", "train"):
        done = pinel("gestures", command, str(tmp_path))
        assert done.exit_code == 1
        assert "There are no labelled pictures here" in done.stderr


class TestTeach:
    @pytest.fixture
    def classroom(self, home: Path) -> str:
        with open_store(database_path()) as store:
            return store.classrooms.create("5º B").id

    def taught(self, classroom: str) -> dict[str, tuple[int, int]]:
        with open_store(database_path()) as store:
            found = store.taught_signs.of_classroom(classroom)
        return {one.sign: (one.n_samples, one.n_movements) for one in found}

    def test_pictures_teach_a_sign_and_those_of_no_use_are_named(
        self, classroom: str, tmp_path: Path
    ) -> None:
        hand = written(tmp_path / "l.png", drawn_hand())
        wall = written(tmp_path / "wall.png", np.full((480, 640, 3), 90, np.uint8))
        done = pinel("gestures", "teach", "vai", hand, hand, wall, "--class", "5º b")
        assert done.exit_code == 2
        assert wall in done.stderr
        (report,) = lines(done.stdout)
        assert report == {
            "class": "5º B",
            "sign": "vai",
            "is_moving": False,
            "added": 2,
            "samples": 2,
            "movements": 0,
        }
        assert self.taught(classroom) == {"vai": (2, 0)}

    def test_a_camera_teaches_hands_at_rest_and_movements(
        self, classroom: str, tmp_path: Path
    ) -> None:
        path = letter_path("Z")
        recording = str(write_moving_hand(tmp_path / "z.npz", "B", path, range(5)))
        for options, added in ((("--moving",), 5), ((), 10)):
            done = pinel(
                "gestures", "teach", "z", "--class", classroom, "--camera", recording, *options
            )
            assert done.exit_code == 0, done.output
            assert lines(done.stdout)[0]["added"] == added
        assert self.taught(classroom) == {"Z": (10, 5)}

    @pytest.mark.parametrize(
        "arguments",
        [
            ("J", "--class", "5º B"),
            ("J", "a.png", "--camera", "0", "--class", "5º B"),
            ("J", "a.png", "--moving", "--class", "5º B"),
            ("J", "a.png"),
            ("J", "a.png", "--class", "9º Z"),
            ("a/b", "a.png", "--class", "5º B"),
            ("J", "missing.png", "--class", "5º B"),
            ("J", "--camera", "missing.mp4", "--class", "5º B"),
        ],
    )
    def test_bad_input_is_told_and_nothing_is_taught(
        self, classroom: str, arguments: tuple[str, ...]
    ) -> None:
        done = pinel("gestures", "teach", *arguments)
        assert done.exit_code != 0
        assert done.stdout == ""
        assert done.stderr
        assert self.taught(classroom) == {}
