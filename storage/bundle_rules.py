"""What each column of a bundle may hold: nothing that a store would not have written, nor what could harm one.

A file from a stick may have been made by anybody. Its values end up in lists, in the editor and in later exports:
a key that is no key, a number that overflows with the next change or a blob that unpacks to gigabytes is not let in.
"""

import math
import re
import sqlite3
import zlib
from collections.abc import Callable, Iterator
from datetime import datetime
from typing import Any

from storage.content import CONTENT, TELEMETRY, Content, columns, tuples
from storage.groups import PICTURES
from storage.json_check import is_object, parsed
from storage.limits import LAST_YEAR, MAX_COUNT, MAX_NUMBER, MAX_REVISION
from storage.notes import MAX_NOTE
from storage.text import LAST_FOREIGN_ID, MAX_NAME

Rule = Callable[[Any], bool]

_MAX_ROWS = 200_000  # samples in a chunk, and in all of a run: an hour has 108,000
_MAX_SHORT = 200
_MAX_TEXT = 10_000
_SAMPLE_COLUMNS = 16
_KEY = re.compile(r"[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}")
_TIME = re.compile(r"[0-9]{4}(-[0-9]{2}){2}T[0-9]{2}(:[0-9]{2}){2}(\.[0-9]{1,6})?Z")
_COLOR = re.compile(r"#[0-9a-f]{6}")
_SHA256 = re.compile(r"[0-9a-f]{64}")
_WORD = re.compile(r"[a-z][a-z0-9_]{0,63}")
# control characters, and those that turn the direction of what follows
_UNSEEN = re.compile(r"[\x00-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


def problem_in_rows(db: sqlite3.Connection) -> str | None:
    """The first place that holds what no store writes, as `table.column`; None when all is well."""
    for content in CONTENT:
        found = _problem_in_table(db, content)
        if found:
            return found
    violation = db.execute("PRAGMA foreign_key_check").fetchone()
    return f"{violation[0]}: {violation[2]}" if violation else _problem_in_runs(db)


def matching(pattern: re.Pattern[str]) -> Rule:
    """Texts that match as a whole."""
    return lambda value: isinstance(value, str) and pattern.fullmatch(value) is not None


def whole(low: int, high: int) -> Rule:
    """Integers between two limits."""
    return lambda value: isinstance(value, int) and low <= value <= high


def visible(most: int, least: int = 0) -> Rule:
    """One line of text."""
    return lambda value: (
        isinstance(value, str) and least <= len(value) <= most and not _UNSEEN.search(value)
    )


def lines(most: int) -> Rule:
    """Text of several lines."""
    return lambda value: isinstance(value, str) and len(value) <= most and "\0" not in value


def text(value: Any) -> bool:
    """What an editor of blocks may have made a key of a block."""
    return isinstance(value, str) and len(value) <= _MAX_TEXT


def workspace(value: Any) -> bool:
    """JSON of what the editor shows."""
    return isinstance(value, str) and is_object(value)


def optional(rule: Rule) -> Rule:
    """The same, or nothing."""
    return lambda value: value is None or rule(value)


def real(value: Any) -> bool:
    """A number that is finite as a float too."""
    try:
        return isinstance(value, int | float) and math.isfinite(value)
    except OverflowError:
        return False


def time(value: Any) -> bool:
    """A moment as the store writes it, with a day to spare at both ends of the calendar for zones of time."""
    if not isinstance(value, str) or not _TIME.fullmatch(value):
        return False
    try:
        return 1 < datetime.fromisoformat(value).year <= LAST_YEAR
    except ValueError:
        return False


def json_of(kind: type, check: Callable[[Any], bool] = lambda value: True) -> Rule:
    """JSON whose outermost value is of a kind."""

    def rule(value: Any) -> bool:
        found = parsed(value) if isinstance(value, str) else None
        return isinstance(found, kind) and check(found)

    return rule


def _are_faults(value: list[Any]) -> bool:
    """As `records.FaultRow` is written: code, pointer, block, params."""
    return all(
        isinstance(fault, list)
        and len(fault) == 4
        and isinstance(fault[0], str)
        and isinstance(fault[1], str)
        and isinstance(fault[2], str | None)
        and isinstance(fault[3], dict)
        for fault in value
    )


def _are_points(value: list[Any]) -> bool:
    return len(value) <= 1000 and all(
        isinstance(point, list) and len(point) == 2 and all(map(real, point)) for point in value
    )


_WORLD_PARTS = {
    "size_m": list,
    "start": dict,
    "walls": list,
    "boxes": list,
    "zones": list,
    "floor": list,
}


def _is_world(value: dict[str, Any]) -> bool:
    """As far as it can be told without the simulator: what says that it is one, and its parts of their kinds."""
    return (
        isinstance(value.get("pinel_world"), int)
        and isinstance(value.get("name"), str)
        and all(isinstance(value.get(part, kind()), kind) for part, kind in _WORLD_PARTS.items())
    )


def unpacks(blob: Any, n_rows: int) -> bool:
    """True for telemetry of that many rows; never unpacks more than they need."""
    largest = 4 * _SAMPLE_COLUMNS * n_rows
    unpacking = zlib.decompressobj()
    try:
        octets = unpacking.decompress(blob, largest + 1)
    except (zlib.error, TypeError):
        return False
    fits = 0 < len(octets) <= largest and len(octets) % (4 * n_rows) == 0
    return fits and unpacking.eof and not unpacking.unused_data


_is_key = matching(_KEY)


def key(value: Any) -> bool:
    """Of those that count time, none so late that what is made here afterwards could not come after it."""
    return _is_key(value) and not (value[14] == "7" and value >= LAST_FOREIGN_ID)


count = whole(0, MAX_COUNT)
word = matching(_WORD)
short = visible(_MAX_SHORT)
name = visible(MAX_NAME, least=1)
flag = whole(0, 1)
_CHANGES: dict[str, Rule] = {
    "revision": whole(1, MAX_REVISION),
    "changed_at": lambda value: value == "" or time(value),
}
RULES: dict[str, dict[str, Rule]] = {
    "tombstones": {"id": key},
    "computers": {"id": key, "name": name, **_CHANGES},
    "classrooms": {"id": key, "name": name, "created_at": time, **_CHANGES},
    "groups": {
        "id": key,
        "name": name,
        "name_key": visible(20 * MAX_NAME),
        "color": matching(_COLOR),
        "created_at": time,
        "used_at": time,
        "classroom_id": optional(key),
        "picture": lambda value: value == "" or value in PICTURES,
        **_CHANGES,
    },
    "lessons": {
        "id": key,
        "classroom_id": optional(key),
        "title": visible(MAX_NAME),
        "activity": optional(short),
        "by_itself": flag,
        "computer_id": key,
        "opened_at": time,
        "used_at": time,
        "closed_at": optional(time),
        "part_of": optional(key),
        **_CHANGES,
    },
    "programs": {
        "id": key,
        "group_id": key,
        "name": name,
        "created_at": time,
        "updated_at": time,
        "deleted_at": optional(time),
        **_CHANGES,
    },
    "versions": {
        "id": key,
        "program_id": key,
        "number": whole(1, MAX_NUMBER),
        "created_at": time,
        "workspace": workspace,
        "document": optional(json_of(dict)),
        "faults": json_of(list, _are_faults),
        "world": optional(json_of(dict, _is_world)),
        "parent_id": optional(key),
        "lesson_id": optional(key),
        "computer_id": optional(key),
    },
    "version_labels": {"id": key, "text": visible(MAX_NAME), **_CHANGES},
    "runs": {
        "id": key,
        "group_id": optional(key),
        "program_id": optional(key),
        "program_name": optional(lines(_MAX_TEXT)),
        "version_id": optional(key),
        "document": optional(json_of(dict)),
        "link": short,
        "world": short,
        "world_document": json_of(dict, _is_world),
        "seed": whole(-(2**63), 2**63 - 1),
        "parameters": json_of(dict),
        "app_version": short,
        "state": lambda value: value in ("finished", "stopped", "failed"),
        "reason": optional(word),
        "params": optional(json_of(dict)),
        "block": optional(text),
        "started_at": time,
        "ended_at": optional(time),
        "duration_s": optional(real),
        "n_executed": optional(count),
        "path_length_m": optional(real),
        "closing_error_m": optional(real),
        "summary": optional(json_of(dict)),
        "telemetry_sha256": optional(matching(_SHA256)),
        "path": optional(json_of(list, _are_points)),
        "lesson_id": optional(key),
        "computer_id": optional(key),
        "activity": optional(short),
        "passed": optional(flag),
        "check_report": optional(json_of(dict)),
    },
    "events": {"run_id": key, "seq": count, "tick": count, "type": word, "data": json_of(dict)},
    "telemetry": {
        "run_id": key,
        "chunk": count,
        "first_tick": count,
        "n_rows": whole(1, _MAX_ROWS),
        "data": lambda value: isinstance(value, bytes),
    },
    "notes": {
        "id": key,
        "run_id": key,
        "text": lines(MAX_NOTE),
        "written_at": time,
        "seen_at": optional(time),
        **_CHANGES,
    },
}


def odd_rows(db: sqlite3.Connection, content: Content) -> Iterator[tuple[tuple[Any, ...], str]]:
    """Rows of a table that would be refused: the key, and the place as `table.column`; samples are not unpacked."""
    names = columns(db, content.table)
    rules = [RULES[content.table][column] for column in names]
    places = [names.index(column) for column in content.key]
    for row in tuples(db, f"SELECT {', '.join(names)} FROM {content.table}"):
        for value, rule, column in zip(row, rules, names, strict=True):
            if not rule(value):
                yield tuple(row[place] for place in places), f"{content.table}.{column}"
                break


def _problem_in_table(db: sqlite3.Connection, content: Content) -> str | None:
    if not columns(db, content.table):  # a table that the release which wrote it did not have
        return None
    for _, problem in odd_rows(db, content):
        return problem
    if content is not TELEMETRY:
        return None
    samples = tuples(db, "SELECT data, n_rows FROM telemetry")
    return None if all(unpacks(*row) for row in samples) else "telemetry.data"


def _problem_in_runs(db: sqlite3.Connection) -> str | None:
    """A run is read as a whole."""
    longest = db.execute(
        "SELECT sum(n_rows) FROM telemetry GROUP BY run_id ORDER BY 1 DESC LIMIT 1"
    )
    row = longest.fetchone()
    return "telemetry.n_rows" if row and row[0] > _MAX_ROWS else None
