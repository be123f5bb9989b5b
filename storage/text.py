"""JSON, ids, times and names as the store writes them."""

import json
import unicodedata
from datetime import UTC, datetime
from typing import Any

import uuid6

from storage.errors import StoreError

MAX_NAME = 60


def new_id() -> str:
    """UUIDv7 text; within a process each is greater than the one before, even when the clock goes back."""
    return str(uuid6.uuid7())


def time_text(moment: datetime) -> str:
    """ISO 8601 in UTC; to the microsecond, so that what follows at once still sorts after."""
    return moment.astimezone(UTC).isoformat(timespec="microseconds").replace("+00:00", "Z")


def dumped(value: object) -> str:
    """JSON in ASCII: a lone surrogate in a pupil's text must not keep the row from being written."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False)


def loaded(text: str | None) -> Any:
    """The value of a JSON column, None for NULL."""
    return None if text is None else json.loads(text)


def clean_name(name: str) -> str:
    """A name without control characters and superfluous spaces.

    Raises:
        StoreError: `name_empty` or `name_too_long`.
    """
    visible = "".join(" " if unicodedata.category(char) == "Cc" else char for char in name)
    clean = " ".join(visible.split())
    if not clean:
        raise StoreError("name_empty")
    if len(clean) > MAX_NAME:
        raise StoreError("name_too_long", length=len(clean), max=MAX_NAME)
    return clean


def name_key(name: str) -> str:
    """What two groups must not share: the name without case and spaces."""
    return "".join(unicodedata.normalize("NFKC", name).casefold().split())
