"""The table of attacks, continued: what is given as a picture and is none. It reads as `test_attacks.py` does."""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import cv2
import numpy as np
import pytest

from tests.gestures.drawn import drawn_hand

pytestmark = pytest.mark.timeout(300)

# address space in KiB: what would be read without end ends the command, not the PC
_MEMORY = 'ulimit -v 8000000; exec "$@"'
WAIT_S = 120.0


class Classified(NamedTuple):
    letters: list[str]
    errors: str
    status: int


def classified(*pictures: Path) -> Classified:
    """What `pinel gestures classify` prints."""
    command = [sys.executable, "-m", "pinel_desktop", "gestures", "classify", *map(str, pictures)]
    done = subprocess.run(
        ["sh", "-c", _MEMORY, "sh", *command],
        env={**os.environ, "PINEL_LANG": "en", "OPENBLAS_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
        timeout=WAIT_S,
        check=False,
    )
    lines: list[dict[str, Any]] = [json.loads(line) for line in done.stdout.splitlines()]
    return Classified([line["best"] for line in lines], done.stderr, done.returncode)


@pytest.fixture
def hand(tmp_path: Path) -> Path:
    file = tmp_path / "hand.png"
    cv2.imwrite(str(file), drawn_hand()[..., ::-1])
    return file


@pytest.mark.parametrize(
    "put",
    [
        lambda path: path.symlink_to("/dev/zero"),
        lambda path: path.symlink_to("/dev/urandom"),
        os.mkfifo,
        Path.mkdir,
    ],
    ids=["endless zeros", "endless chance", "pipe", "folder"],
)
def test_what_is_no_file_is_said_to_be_no_picture_and_the_others_are_read(
    tmp_path: Path, hand: Path, put: Callable[[Path], None]
) -> None:
    other = tmp_path / "other.png"
    put(other)
    letters, errors, status = classified(other, hand)
    assert f"“{other}” is no picture that can be read." in errors
    assert (letters, status) == (["L"], 2)


@pytest.mark.parametrize(
    ("width", "height", "size_text"),
    [
        (
            1_000_000,
            1,
            "is 1000000 x 1 pixels, too small for a hand to be seen. Use a picture with at least 16",
        ),
        (20_000, 100, "is 20000 x 100 pixels, too large. Use a picture with at most 16384"),
    ],
)
def test_a_picture_of_hostile_sides_is_refused_with_its_sides_and_the_bound(
    tmp_path: Path, hand: Path, width: int, height: int, size_text: str
) -> None:
    long = tmp_path / "long.png"
    cv2.imwrite(str(long), np.zeros((height, width), np.uint8))
    letters, errors, status = classified(long, hand)
    assert f"“{long}” {size_text} pixels on each side." in errors
    assert (letters, status) == (["L"], 2)
