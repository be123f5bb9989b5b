"""A network is opened only if its file is the one that was tried."""

from pathlib import Path

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.hands import HandDetector
from pinel_desktop.gestures.networks import FOLDER, HAND, PALM, checked


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for file in (PALM, HAND):
        (tmp_path / file.name).write_bytes(checked(file))
    return tmp_path


def test_the_files_that_set_up_made_are_whole() -> None:
    for file in (PALM, HAND):
        assert checked(file, FOLDER)


def test_a_missing_file_is_named(folder: Path) -> None:
    (folder / HAND.name).unlink()
    with pytest.raises(PinelError) as raised:
        HandDetector(folder)
    assert raised.value.code == "gesture_model_missing"
    assert raised.value.params == {"file": str(folder / HAND.name)}


@pytest.mark.parametrize("damage", [b"", b"not a network", None])
def test_a_damaged_file_is_never_opened(folder: Path, damage: bytes | None) -> None:
    content = (folder / PALM.name).read_bytes()
    flipped = content[:-1] + bytes([content[-1] ^ 1])
    (folder / PALM.name).write_bytes(flipped if damage is None else damage)
    with pytest.raises(PinelError) as raised:
        HandDetector(folder)
    assert raised.value.code == "gesture_model_damaged"
