"""Learning from a folder and measuring it, with drawn hands; whose figures say nothing, but add up."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.features import BLOCKS
from pinel_desktop.gestures.training import evaluation, letter_training
from pinel_desktop.gestures.training.folds import leave_one_source_out, strict
from pinel_desktop.gestures.training.photo_features import PhotoFeatures, load_photo_features
from pinel_desktop.gestures.training.photos import Photo, read_photos
from tests.gestures.photo_folder import LETTERS, SOURCES, make_photos


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("photos")
    make_photos(place)
    return place


@pytest.fixture(scope="module")
def photos(folder: Path) -> list[Photo]:
    return read_photos(folder)


@pytest.fixture(scope="module")
def dataset(photos: list[Photo]) -> PhotoFeatures:
    return load_photo_features(photos)


@pytest.fixture
def narrow(dataset: PhotoFeatures, monkeypatch: pytest.MonkeyPatch) -> PhotoFeatures:
    """The photographs with some features only: with all of them, each training computes for half a second."""
    blocks = (slice(0, 60), slice(60, 100))
    monkeypatch.setattr(letter_training, "BLOCKS", blocks)
    chosen = np.r_[BLOCKS[0].start : 60, BLOCKS[1].start : BLOCKS[1].start + 40]
    return replace(
        dataset,
        features=dataset.features[:, chosen],
        painted_features=dataset.painted_features[:, chosen],
    )


def test_a_photo_gets_its_shape_back_and_one_without_a_letter_is_left_out(
    photos: list[Photo],
) -> None:
    assert len(photos) == len(SOURCES) * len(LETTERS) * 2
    assert {photo.source: photo.picture().shape[:2] for photo in photos} == {
        "p1_webcam": (640, 1138),
        "p2_webcam": (640, 1138),
        "p3_webcam": (640, 1138),
        "g8_phone_mix": (853, 640),
    }


def test_a_split_is_found_with_the_table_beside_it(folder: Path, photos: list[Photo]) -> None:
    assert read_photos(folder / "train") == photos


def test_a_folder_without_a_table_is_said_to_hold_nothing(tmp_path: Path) -> None:
    with pytest.raises(PinelError) as raised:
        read_photos(tmp_path)
    assert raised.value.code == "photos_unreadable"


@pytest.mark.parametrize(
    "table", ["", "a,b\n1,2\n", "split,file,label,letter,source\nx,y.jpg,A,A,s\n"]
)
def test_a_table_that_does_not_fit_is_refused(tmp_path: Path, table: str) -> None:
    (tmp_path / "sources.csv").write_text(table, "utf-8")
    with pytest.raises(PinelError) as raised:
        read_photos(tmp_path)
    assert raised.value.code == "photos_unreadable"


def test_a_hand_that_is_painted_over_is_not_found(photos: list[Photo]) -> None:
    picture = photos[0].picture()
    painted = photos[0].painted_over(picture)
    assert painted.shape == picture.shape
    assert not np.array_equal(painted, picture)


def test_recordings_are_made_once_and_anew_for_other_photos(
    photos: list[Photo], tmp_path: Path
) -> None:
    cache = tmp_path / "build" / "a.npz"
    ticks: list[int] = []
    for chosen in (photos[:2], photos[:2], photos[:3]):
        before = len(ticks)
        made = load_photo_features(chosen, cache, lambda: ticks.append(1))
        assert len(made) == len(chosen)
        ticks.append(len(ticks) - before)
    assert [n for n in ticks if n != 1] == [2, 0, 3]


def test_every_drawn_hand_is_found_that_keeps_its_shape(dataset: PhotoFeatures) -> None:
    assert dataset.is_hand[dataset.sources != "g8_phone_mix"].all()
    assert set(dataset.letters) == set(LETTERS)


def test_nobody_who_is_tested_was_learnt_from(dataset: PhotoFeatures) -> None:
    for fold in leave_one_source_out(dataset.sources):
        assert set(dataset.sources[fold.test]) == {fold.source}
        assert fold.source not in dataset.sources[fold.train]
    tested = {fold.source for fold in strict(dataset.sources)}
    assert tested == {"p1_webcam", "p2_webcam", "p3_webcam"}
    for fold in strict(dataset.sources):
        assert not {fold.source, "g8_phone_mix"} & set(dataset.sources[fold.train])


def test_training_is_the_same_with_the_same_seed_and_not_with_another(
    narrow: PhotoFeatures,
) -> None:
    one, again, other = (letter_training.train(narrow, seed) for seed in (1, 1, 2))
    assert np.array_equal(one.points, again.points)
    assert np.array_equal(one.weights, again.weights)
    assert not np.array_equal(one.points, other.points)


def test_a_hand_between_two_letters_is_of_one_source_and_shows_nothing(
    dataset: PhotoFeatures,
) -> None:
    between = letter_training.transitions(dataset, 20, np.random.default_rng(1))
    assert set(between.signs) == {""}
    assert 5 <= len(between.signs) <= 20


def test_the_report_of_held_out_people_has_every_figure(narrow: PhotoFeatures) -> None:
    report = evaluation.evaluate_unseen(narrow)
    for part in (report["leave_one_source_out"], report["strict"]):
        assert part["accuracy"]["of"] == sum(share["of"] for share in part["by_source"].values())
        assert part["accuracy"]["n"] == sum(share["n"] for share in part["by_letter"].values())
        assert part["accuracy"]["low"] <= part["accuracy"]["share"] <= part["accuracy"]["high"]
        assert 0 <= part["calibration_error"] <= 1
    assert set(report["strict"]["unknown_letter_refused"]["by_letter"]) == set(LETTERS)
    assert report["strict"]["taught"]["accuracy"]["of"] == 0  # all of so few are taught


def test_the_report_of_the_letters_that_ship_counts_every_photo(dataset: PhotoFeatures) -> None:
    report = evaluation.evaluate_known(dataset, letter_training.fit_letters(dataset))
    assert report["photos"] == len(dataset) == report["accuracy"]["of"]
