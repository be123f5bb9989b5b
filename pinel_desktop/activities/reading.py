"""Reads activities: shipped ones, and files."""

import json
import os
from collections.abc import Iterator, Mapping
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any, get_args

from pydantic import ValidationError

from pinel_desktop.activities.faults import ActivityError, schema_faults, semantic_faults
from pinel_desktop.activities.model import FORMAT, Activity, PathName
from pinel_desktop.errors import PinelError
from pinel_desktop.messages.content import program_in_language, titled, with_texts, world_titles
from pinel_desktop.program.duplicates import duplicate_key_faults
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.python_text import read_python
from sim.world import list_worlds

_MAX_BYTES = 2**20
_NO_NUMBER = 10_000  # a larger format number is a mistake, not a later release


_CATALOGUE = resources.files(__name__.rpartition(".")[0]) / "catalogue"
PATHS: tuple[PathName, ...] = get_args(PathName)


@cache
def _shipped() -> dict[str, Activity]:
    folders = sorted(entry.name for entry in _CATALOGUE.iterdir() if entry.is_dir())
    texts = [(_CATALOGUE / name / "activity.json").read_text("utf-8") for name in folders]
    documents = [with_texts(json.loads(text), "missions") for text in texts]
    activities = [Activity.model_validate(document) for document in documents]
    return {activity.name: activity for activity in sorted(activities, key=_catalogue_order)}


def _catalogue_order(activity: Activity) -> tuple[int, list[int], str]:
    """Returns the sort key of a shipped activity: path and number; activities without a path come last."""
    path = len(PATHS) if activity.path is None else PATHS.index(activity.path)
    return path, [int(part) for part in (activity.number or "").split(".") if part], activity.name


def activity_names() -> list[str]:
    """Returns the names of the shipped activities, along the paths."""
    return list(_shipped())


def shipped_activity(name: str) -> Activity:
    """Returns a shipped activity; never reads a file, because the name may come from another PC.

    Raises PinelError `unknown_activity`.
    """
    if name not in _shipped():
        raise PinelError("unknown_activity", value=name, allowed=activity_names())
    return _shipped()[name]


@cache
def solution_of(activity_name: str) -> dict[str, Any] | None:
    """Returns a program that passes a shipped activity, as a document; None if none ships."""
    return _shipped_program(activity_name, "solution.py")


def _shipped_program(activity_name: str, file_name: str) -> dict[str, Any] | None:
    file = _CATALOGUE / activity_name / file_name
    if activity_name not in _shipped() or not file.is_file():
        return None
    return read_python(file.read_text("utf-8")).result.document


@cache
def start_of(activity_name: str, language: str) -> dict[str, Any] | None:
    """Returns the program with which groups begin a shipped activity, as a document; None if it begins without blocks.

    Its names and texts are in `language`.
    """
    document = _shipped_program(activity_name, "start.py")
    return document and program_in_language(document, language)


def activity_titles(language: str) -> dict[str, str]:
    """Returns the titles of the shipped activities in a language, by name."""
    return {name: one.title.of(language) for name, one in _shipped().items()}


def world_title(activity: Activity, language: str) -> str | None:
    """Returns the title of the shipped world of an activity; None if the activity has a world document of its own."""
    return world_titles(language).get(activity.world) if isinstance(activity.world, str) else None


def shipped_texts() -> list[str]:
    """Returns names of shipped worlds and activities and all texts of these worlds; anonymous exports may have them."""
    worlds = [titled(world) for world in list_worlds()]
    return sorted({*_texts_in(worlds), *activity_names()})


def _texts_in(value: object) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping | list):
        for part in value.values() if isinstance(value, Mapping) else value:
            yield from _texts_in(part)


def choose_activity(name_or_file: str) -> Activity:
    """Returns the shipped activity of that name, or the activity in that file.

    Raises:
        PinelError: `unknown_activity`, `file_unreadable`.
        ActivityError: `activity_invalid`, with all faults of the file.
    """
    if name_or_file in _shipped():
        return _shipped()[name_or_file]
    if not is_file(name_or_file):
        raise PinelError("unknown_activity", value=name_or_file, allowed=activity_names())
    try:
        with Path(name_or_file).open("rb") as file:
            text = file.read(_MAX_BYTES)
    except (OSError, ValueError) as error:
        raise PinelError("file_unreadable", path=name_or_file) from error
    activity, faults = read_activity(text)
    if activity is None or faults:
        raise ActivityError(name_or_file, faults)
    return activity


def read_activity(text: str | bytes) -> tuple[Activity | None, tuple[Fault, ...]]:
    """Returns the activity in a JSON text, or None, and all its faults."""
    try:
        document = json.loads(text)
    except json.JSONDecodeError as error:
        params: dict[str, object] = {"line": error.lineno, "column": error.colno}
        return None, (Fault("activity_syntax", params=params),)
    except (ValueError, RecursionError):  # not UTF-8, thousands of digits, or too deep
        return None, (Fault("activity_syntax", params={"line": 1, "column": 1}),)
    if (newer := _newer(document)) is not None:
        return None, (newer,)
    doubled = duplicate_key_faults(text)
    try:
        activity = Activity.model_validate(document)
    except ValidationError as error:
        return None, (*doubled, *schema_faults(document, error))
    return activity, (*doubled, *semantic_faults(activity))


def _newer(document: object) -> Fault | None:
    """Returns the fault of an activity of a later release, whose other keys cannot be validated; else None."""
    number = document.get("pinel_activity") if isinstance(document, dict) else None
    if isinstance(number, bool) or not isinstance(number, int) or not FORMAT < number < _NO_NUMBER:
        return None
    params: dict[str, object] = {"value": number, "max": FORMAT}
    return Fault("activity_newer", "/pinel_activity", None, params)


def is_file(name_or_file: str) -> bool:
    """Returns whether a name ends in .json or is an existing file."""
    return name_or_file.lower().endswith(".json") or os.path.isfile(name_or_file)
