"""Validation rules: which values a column may have in a bundle.

Anybody can make a file on a stick, and its values end up in lists, in the editor and in later exports. So these are
refused: keys that are no keys, numbers that overflow with the next change, blobs that unpack to gigabytes.
"""

import math
import re
import struct
from collections.abc import Callable
from datetime import datetime
from functools import lru_cache
from itertools import pairwise
from typing import Any

from storage.json_check import is_object, parsed
from storage.limits import (
    FARTHEST_M,
    LAST_YEAR,
    MAX_COUNT,
    MAX_NAME,
    MAX_ROBOT_PARAMETERS,
    MAX_SIGN,
    MAX_TAUGHT_SAMPLES,
    MAX_TRUE_POSES,
    N_FEATURES,
)
from storage.text import FIRST_IMPLAUSIBLE_ID

Rule = Callable[[Any], bool]

_MAX_SHORT = 200
MAX_TEXT = 10_000
_UUID = r"[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}"
_UUID_LENGTH = 36
_TIME = re.compile(r"[0-9]{4}(-[0-9]{2}){2}T[0-9]{2}(:[0-9]{2}){2}(\.[0-9]{1,6})?Z")
# control characters, and characters that change the direction of the text after them
_UNSEEN = re.compile(r"[\x00-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")
_WORLD_PARTS = {
    **dict.fromkeys(("size_m", "walls", "boxes", "zones", "floor", "prints"), list),
    "start": dict,
    "ground": str,
}


_ACTIVITY_PARTS = {"name": str, "title": dict, "checks": list, "cases": list, "solution": dict}
_GOAL_PARTS = {"lines": list, "zones": list, "boxes": dict}


def optional(rule: Rule) -> Rule:
    """Accepts NULL and all values of the rule."""
    return lambda value: value is None or rule(value)


def matching(pattern: str) -> Rule:
    """Accepts texts that match a regular expression as a whole."""
    compiled = re.compile(pattern)
    return lambda value: isinstance(value, str) and compiled.fullmatch(value) is not None


def one_of(*texts: str) -> Rule:
    """Accepts these texts only."""
    return lambda value: value in texts


def whole(low: int, high: int) -> Rule:
    """Accepts integers between two limits."""
    return lambda value: isinstance(value, int) and low <= value <= high


def line(max_length: int, min_length: int = 0) -> Rule:
    """Accepts one line of text without invisible characters."""
    return lambda value: (
        isinstance(value, str)
        and min_length <= len(value) <= max_length
        and not _UNSEEN.search(value)
    )


def lines(max_length: int) -> Rule:
    """Accepts text of several lines."""
    return lambda value: isinstance(value, str) and len(value) <= max_length and "\0" not in value


def block(value: Any) -> bool:
    """Accepts the key of a block in the editor: any text of bounded length."""
    return isinstance(value, str) and len(value) <= MAX_TEXT


def blob(value: Any) -> bool:
    """Accepts octets."""
    return isinstance(value, bytes)


def hands(value: Any) -> bool:
    """Accepts samples of a taught sign: 1 to `MAX_TAUGHT_SAMPLES` rows of `N_FEATURES` float16, all finite."""
    if not isinstance(value, bytes):
        return False
    n_samples, rest = divmod(len(value), 2 * N_FEATURES)
    if rest or not 1 <= n_samples <= MAX_TAUGHT_SAMPLES:
        return False
    return all(map(math.isfinite, struct.unpack(f"<{n_samples * N_FEATURES}e", value)))


def real(value: Any) -> bool:
    """Accepts a number that is also finite as a float."""
    try:
        return isinstance(value, int | float) and math.isfinite(value)
    except OverflowError:
        return False


def key(value: Any) -> bool:
    """Accepts a UUID. If it begins with a time, later times must be left for rows that are made afterwards."""
    return isinstance(value, str) and len(value) == _UUID_LENGTH and _is_key(value)


@lru_cache(maxsize=256)  # consecutive rows of one run have the same key
def _is_key(text: str) -> bool:
    return _is_uuid(text) and not (text[14] in "78" and text >= FIRST_IMPLAUSIBLE_ID)


def time(value: Any) -> bool:
    """Accepts a time as the store writes it, a day away from both ends of the calendar, as time zones need."""
    if not isinstance(value, str) or not _TIME.fullmatch(value):
        return False
    try:
        return 1 < datetime.fromisoformat(value).year <= LAST_YEAR
    except ValueError:
        return False


def time_or_empty(value: Any) -> bool:
    """Accepts a time, or "" for a row of a release that did not record it."""
    return value == "" or time(value)


def json_of(kind: type, check: Callable[[Any], bool] = lambda value: True) -> Rule:
    """Accepts JSON whose outermost value is of a type and passes the check."""

    def rule(value: Any) -> bool:
        found = parsed(value) if isinstance(value, str) else None
        return isinstance(found, kind) and check(found)

    return rule


def workspace(value: Any) -> bool:
    """Accepts JSON of the editor's workspace, which may be nested deeper than other JSON."""
    return isinstance(value, str) and is_object(value)


def _are_faults(value: list[Any]) -> bool:
    """Accepts faults as `row_types.FaultRow` is written: code, pointer, block, params."""
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


def _are_poses(value: list[Any]) -> bool:
    """Accepts poses as `row_types.TruthRow` has them, in the order of their ticks; the one after the run is last."""
    if len(value) > MAX_TRUE_POSES or not all(map(_is_pose, value)):
        return False
    ticks = [math.inf if pose[0] is None else pose[0] for pose in value]
    return all(before < after for before, after in pairwise(ticks))


def _is_pose(value: Any) -> bool:
    if not (isinstance(value, list) and len(value) == 6 and all(map(real, value[1:]))):
        return False
    tick, x, y, heading, sigma_m, sigma_rad = value
    return (
        (tick is None or count(tick))
        and max(abs(x), abs(y)) <= FARTHEST_M
        and abs(heading) <= math.pi
        and 0 < sigma_m <= FARTHEST_M
        and 0 < sigma_rad <= math.pi
    )


def _is_world(value: dict[str, Any]) -> bool:
    """Checks what can be checked without the simulator: version, name, and the types of the parts."""
    return (
        isinstance(value.get("pinel_world"), int)
        and isinstance(value.get("name"), str)
        and all(isinstance(value.get(part, kind()), kind) for part, kind in _WORLD_PARTS.items())
    )


def _is_activity(value: dict[str, Any]) -> bool:
    """Checks what can be checked without the app: format, name, and the types of the parts."""
    return isinstance(value.get("pinel_activity"), int) and all(
        isinstance(value.get(part, kind()), kind) for part, kind in _ACTIVITY_PARTS.items()
    )


def _are_robot_parameters(value: dict[str, Any]) -> bool:
    """Checks what can be checked without the app, which knows the names and bounds: few finite numbers."""
    return len(value) <= MAX_ROBOT_PARAMETERS and all(map(real, value.values()))


def _is_goal(value: dict[str, Any]) -> bool:
    return all(isinstance(value.get(part), kind) for part, kind in _GOAL_PARTS.items())


def _is_version_vector(value: dict[str, Any]) -> bool:
    """Accepts a version vector (`storage/exchange/deleting/knowledge.py`): a class or none, the newest key by PC."""
    newest = value.get("newest", {})
    classroom = value.get("classroom")
    return (
        value.keys() <= {"classroom", "newest"}
        and (classroom is None or key(classroom))
        and isinstance(newest, dict)
        and all((not pc or key(pc)) and key(last) for pc, last in newest.items())
    )


_is_uuid = matching(_UUID)
count = whole(0, MAX_COUNT)
flag = whole(0, 1)
identifier = matching("[a-z][a-z0-9_]{0,63}")
color = matching("#[0-9a-f]{6}")
sha256 = matching("[0-9a-f]{64}")
# part of a URL path: begins with a letter or digit, and has no character with a meaning in URLs
sign = matching(rf"[^\W_][\w '-]{{0,{MAX_SIGN - 1}}}")
short = line(_MAX_SHORT)
title = line(MAX_NAME)
name = line(MAX_NAME, min_length=1)
json_object = json_of(dict)
faults = json_of(list, _are_faults)
points = json_of(list, _are_points)
poses = json_of(list, _are_poses)
world = json_of(dict, _is_world)
activity = json_of(dict, _is_activity)
goal = json_of(dict, _is_goal)
robot_parameters = json_of(dict, _are_robot_parameters)
version_vector = json_of(dict, _is_version_vector)
