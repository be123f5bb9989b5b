"""The programs of tests/activities/programs: for each shipped activity wrong ones and unusual right ones.

A wrong program is a file, or a solution with changes (`changes.json`: name, then pairs of old and new text).
"""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

PROGRAMS = Path(__file__).parent / "programs"
CATALOGUE = Path(__file__).parents[2] / "pinel_desktop" / "activities" / "catalogue"


class GivenProgram(NamedTuple):
    """A program as Python text."""

    activity: str
    name: str
    text: str

    def __str__(self) -> str:
        return f"{self.activity}/{self.name}"


def solutions() -> list[GivenProgram]:
    """The solution of each activity."""
    return [_of_file(file) for file in sorted(CATALOGUE.glob("*/solution.py"))]


def others() -> list[GivenProgram]:
    """Unusual programs that pass."""
    return [_of_file(file) for file in sorted(PROGRAMS.glob("*/other_*.py"))]


def wrong() -> list[GivenProgram]:
    """Programs that must not pass."""
    files = [_of_file(file) for file in PROGRAMS.glob("*/wrong_*.py")]
    return sorted([*files, *_changed_solutions()])


def _of_file(file: Path) -> GivenProgram:
    return GivenProgram(file.parent.name, file.stem, file.read_text("utf-8"))


def _changed_solutions() -> Iterator[GivenProgram]:
    for file in PROGRAMS.glob("*/changes.json"):
        activity = file.parent.name
        for name, changes in json.loads(file.read_text("utf-8")).items():
            text = (CATALOGUE / activity / "solution.py").read_text("utf-8")
            for old, new in changes:
                assert text.count(old) == 1, f"{activity}/{name}: {old!r} is not there once"
                text = text.replace(old, new)
            yield GivenProgram(activity, name, text)
