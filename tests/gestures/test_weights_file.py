"""The file with the letters: what is in it comes out again, and nothing else is believed."""

import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.classifier import Samples, SignClassifier
from pinel_desktop.gestures.features import BLOCKS, N_FEATURES
from pinel_desktop.gestures.weights_file import LETTERS, load, save

LIMIT = 1_650_000


@pytest.fixture(scope="module")
def small() -> SignClassifier:
    features = np.random.default_rng(2).normal(size=(12, N_FEATURES)).astype(np.float32)
    return SignClassifier.fit(Samples(features, ("A", "B", "C") * 4), BLOCKS)


def test_the_letters_that_ship_are_the_21_static_ones() -> None:
    assert "".join(load().signs) == "ABCDEFGIKLMNOPQRSTUVW"
    assert LETTERS.stat().st_size < LIMIT


def test_a_classifier_judges_the_same_after_it_was_saved(
    small: SignClassifier, tmp_path: Path
) -> None:
    save(small, tmp_path / "a.npz")
    again = load(tmp_path / "a.npz")
    probe = np.random.default_rng(3).normal(size=(5, N_FEATURES)).astype(np.float32)
    assert np.array_equal(small.score(probe).scores, again.score(probe).scores)
    assert again.signs == small.signs


def test_the_same_classifier_is_the_same_file(small: SignClassifier, tmp_path: Path) -> None:
    save(small, tmp_path / "a.npz")
    save(load(tmp_path / "a.npz"), tmp_path / "b.npz")
    assert (tmp_path / "a.npz").read_bytes() == (tmp_path / "b.npz").read_bytes()


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(PinelError) as raised:
        load(tmp_path / "none.npz")
    assert raised.value.code == "gesture_model_missing"


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04", b"x" * 1000])
def test_what_is_no_archive_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "a.npz").write_bytes(content)
    with pytest.raises(PinelError) as raised:
        load(tmp_path / "a.npz")
    assert raised.value.code == "gesture_model_damaged"


def test_a_cut_file_is_refused(small: SignClassifier, tmp_path: Path) -> None:
    save(small, tmp_path / "a.npz")
    whole = (tmp_path / "a.npz").read_bytes()
    for length in (100, len(whole) // 2, len(whole) - 1):
        (tmp_path / "a.npz").write_bytes(whole[:length])
        with pytest.raises(PinelError):
            load(tmp_path / "a.npz")


@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("points", np.zeros((3, 200))),
        ("points", np.full((12, 200), np.nan)),
        ("members", np.full(12, 3, np.int16)),
        ("members", np.zeros(12)),
        ("signs", np.array(["A", "B"])),
        ("signs", np.array([{"a": 1}, 2, 3], dtype=object)),
        ("calibration", np.zeros(3)),
        ("weights", None),
    ],
)
def test_arrays_that_do_not_fit_are_refused(
    small: SignClassifier, tmp_path: Path, name: str, values: Any
) -> None:
    save(small, tmp_path / "a.npz")
    with np.load(tmp_path / "a.npz") as archive:
        arrays = {key: archive[key] for key in archive}
    del arrays[name]
    np.savez(tmp_path / "b.npz", **(arrays if values is None else {**arrays, name: values}))
    with pytest.raises(PinelError) as raised:
        load(tmp_path / "b.npz")
    assert raised.value.code == "gesture_model_damaged"


def test_a_damaged_member_is_noticed_by_its_checksum(small: SignClassifier, tmp_path: Path) -> None:
    save(small, tmp_path / "a.npz")
    with zipfile.ZipFile(tmp_path / "a.npz") as file:
        offset = file.getinfo("points.npy").header_offset + 2000
    content = bytearray((tmp_path / "a.npz").read_bytes())
    content[offset] ^= 0xFF
    (tmp_path / "a.npz").write_bytes(content)
    with pytest.raises(PinelError) as raised:
        load(tmp_path / "a.npz")
    assert raised.value.code == "gesture_model_damaged"
