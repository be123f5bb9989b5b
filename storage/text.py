"""JSON, ids, times and names in the form that the store writes."""

import contextlib
import hashlib
import json
import re
import secrets
import threading
import time
import unicodedata
import uuid
from datetime import UTC, datetime, timedelta
from typing import Any

from storage.errors import StoreError
from storage.limits import LAST_YEAR, MAX_NAME

_UNSEEN = ("Cf", "Cs")
# joiners, which are part of emoji and of words in several scripts
_JOINERS = "\u200c\u200d"
# letters and symbols by their category, but blank: fillers of Hangul and Braille
_BLANKS = "\u115f\u1160\u3164\uffa0\u2800"
_NUMBERS = re.compile(r"([0-9]+)")


class _Ids:
    """UUIDv7 of RFC 9562: a time in ms, then random bits. The time increases even when the clock is set back."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._last_ms = 0

    def next(self) -> str:
        with self._lock:
            now_ms = min(time.time_ns() // 10**6, _LATEST_CLOCK_MS)
            self._last_ms = ms = max(now_ms, self._last_ms + 1)
        chance = secrets.randbits(74)
        high, low = chance >> 62, chance & (2**62 - 1)
        return str(uuid.UUID(int=ms << 80 | 7 << 76 | high << 64 | 2 << 62 | low))

    def continue_after(self, newest: str) -> None:
        with self._lock, contextlib.suppress(ValueError):
            self._last_ms = max(self._last_ms, uuid.UUID(newest).int >> 80)


_LATEST_CLOCK_MS = 4_102_444_800_000  # the year 2100: clocks of PCs end with 2099
_ids = _Ids()
# ids from here on are implausible: forged, or made after a forged one. The clock is not believed beyond 2100, so ids
# after the last one of such a clock have 30 years of milliseconds
FIRST_IMPLAUSIBLE_ID = "04979793-8400"  # 2130
_HEX = "[0-9a-f]"
_ID_PATTERN = "-".join((8 * _HEX, 4 * _HEX, "[78]" + 3 * _HEX, 4 * _HEX, 12 * _HEX))
# SQL condition: the id has the form of UUIDv7 or UUIDv8; otherwise it is damaged
IS_ID = f"id GLOB '{_ID_PATTERN}'"
_VERSION_AT = 14
_FIRST_NOT_FOLLOWED = "03bb2cc3-d800"  # 2100


def new_id() -> str:
    """Returns UUIDv7 text, greater than every one before, even when the clock is set back."""
    return _ids.next()


def id_of(content: str) -> str:
    """Returns UUIDv8 text of RFC 9562, greater than every one before as `new_id`.

    The id has a time, then bits of the SHA-256 of the row's values that never change. So nobody can make another row
    with this id.
    """
    return _bound(new_id(), content)


def may_be_of(key: str, content: str) -> bool:
    """Returns whether the id belongs to this content; True for an id without hash, as in releases before 0.3."""
    return key[_VERSION_AT] != "8" or key == _bound(key, content)


def _bound(key: str, content: str) -> str:
    digest = hashlib.sha256(content.encode()).hexdigest()
    return f"{key[:_VERSION_AT]}8{digest[:3]}-8{digest[3:6]}-{digest[6:18]}"


def continue_after(newest: str) -> None:
    """Makes all further ids greater than this one, which this PC made before, maybe at a later time of its clock.

    A text that is no id, or that no clock can have made, changes nothing.
    """
    if newest < _FIRST_NOT_FOLLOWED:
        _ids.continue_after(newest)


def utc_now() -> datetime:
    """Returns the time by the PC's clock."""
    return datetime.now(UTC)


def time_text(moment: datetime) -> str:
    """Returns ISO 8601 in UTC, to the microsecond, so that times in quick succession still sort."""
    return moment.astimezone(UTC).isoformat(timespec="microseconds").replace("+00:00", "Z")


def local_time(moment: datetime | str) -> str:
    """Returns a time to the minute by the clock of this PC, for people; messages localise it.

    Raises:
        ValueError: the text is no time.
        OverflowError: a time at the end of the calendar.
    """
    found = datetime.fromisoformat(moment) if isinstance(moment, str) else moment
    return f"{found.astimezone():%Y-%m-%d %H:%M}"


def just_after(moment: str) -> str:
    """Returns the time a microsecond later, "" for a text that is no time.

    Of two states with one revision the later wins, so a PC whose clock is behind must not lose its own change. The
    last time that other PCs accept is returned unchanged.
    """
    try:
        now = datetime.fromisoformat(moment)
        steps = (now + timedelta(microseconds=1), now + timedelta(seconds=1))
    except (ValueError, OverflowError):
        return ""
    # compared as texts, as merges do: "12:00:00Z" is after "12:00:00.000001Z"
    after = next(filter(moment.__lt__, map(time_text, steps)), moment)
    return after if after < f"{LAST_YEAR + 1}" else moment


def to_json(value: object) -> str:
    """Returns JSON in ASCII, since a lone surrogate in a pupil's text could not be written otherwise."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False)


def from_json(text: str | None) -> Any:
    """Returns the value of a JSON column, None for NULL."""
    return None if text is None else json.loads(text)


def readable_object(text: Any) -> dict[str, Any] | None:
    """Returns the JSON object of a column; None for NULL and damaged values."""
    value = readable(text)
    return value if isinstance(value, dict) else None


def readable_points(text: Any) -> list[list[float]]:
    """Returns the points of a column; none for NULL and damaged values."""
    value = readable(text)
    return value if isinstance(value, list) and all(map(_is_point, value)) else []


def is_json(octets: bytes) -> bool:
    """Returns whether the octets are JSON."""
    try:
        json.loads(octets.decode())
    except (ValueError, RecursionError):
        return False
    return True


def readable(text: Any) -> Any:
    """Returns the value of a JSON column; None for NULL and damaged values."""
    try:
        return from_json(text)
    except (ValueError, TypeError, RecursionError):
        return None


def _is_point(point: Any) -> bool:
    return (
        isinstance(point, list)
        and len(point) == 2
        and all(isinstance(part, int | float) for part in point)
    )


def clean_name(name: str) -> str:
    """Returns a name without invisible characters: control characters, direction marks, superfluous spaces.

    Raises:
        StoreError: `name_empty` or `name_too_long`.
    """
    clean = " ".join("".join(map(_shown, name)).split())
    if not any(map(_leaves_ink, clean)):
        raise StoreError("name_empty")
    if len(clean) > MAX_NAME:
        raise StoreError("name_too_long", length=len(clean), max=MAX_NAME)
    return clean


def clean_title(title: str) -> str:
    """Returns a title like a name; "" if it has no visible character. Raises StoreError `name_too_long`."""
    try:
        return clean_name(title)
    except StoreError as error:
        if error.code == "name_empty":
            return ""
        raise


def clean_text(text: str) -> str:
    """Returns a text of several lines, without characters that cannot be written, trimmed; may be empty."""
    writable = text.encode("utf-8", "ignore").decode()
    return "\n".join(line.rstrip() for line in writable.replace("\0", "").strip().splitlines())


def name_key(name: str) -> str:
    """Returns the key that two groups must not share: the name without case, spaces and joiners."""
    visible = "".join(char for char in name if char not in _JOINERS)
    return "".join(unicodedata.normalize("NFKC", visible).casefold().split())


def natural_key(name: str) -> list[str | int]:
    """Returns a sort key without accents, case and spaces. Texts and numbers alternate, so 2 comes before 10."""
    letters = (char for char in unicodedata.normalize("NFKD", name_key(name)))
    parts = _NUMBERS.split("".join(char for char in letters if not unicodedata.combining(char)))
    return [int(part) if index % 2 else part for index, part in enumerate(parts)]


def _shown(char: str) -> str:
    if unicodedata.category(char) == "Cc":
        return " "
    return "" if unicodedata.category(char) in _UNSEEN and char not in _JOINERS else char


def _leaves_ink(char: str) -> bool:
    # Cn: an emoji newer than Python's tables
    category = unicodedata.category(char)
    return (category[0] in "LNPS" or category == "Cn") and char not in _BLANKS
