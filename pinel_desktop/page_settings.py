"""What the page keeps for this PC: theme, level, class and the like. Their names and values are the page's own.

They are in a file beside the database, because the page is served before the database is open, and cookies end with the
window.
"""

import contextlib
import json
import os
import re
import threading
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

from pinel_desktop.paths import read_regular

NAME, VALUE = "^[a-z_]+$", "^[A-Za-z0-9_-]*$"
MAX_SETTINGS, MAX_NAME, MAX_VALUE = 40, 40, 4000  # a cookie had room for as much
PAGE_LANGUAGE = "pinel_language"
_MAX_BYTES = 2 * MAX_SETTINGS * MAX_VALUE


class PageSettings:
    """Names and values, read when they are first needed.

    They hold until the app ends where the file cannot be written, and are empty where it cannot be read.

    Args:
        file: None keeps them in memory only.
    """

    def __init__(self, file: Path | None = None) -> None:
        self._file = file
        self._values: dict[str, str] | None = None
        self._lock = threading.Lock()

    @classmethod
    def beside(cls, database: Path) -> "PageSettings":
        """Those of the file beside a database."""
        return cls(database.with_name(f"{database.name}.page.json"))

    @property
    def values(self) -> Mapping[str, str]:
        """All settings by name."""
        with self._lock:
            return MappingProxyType(self._read())

    def keep(self, name: str, value: str) -> None:
        """Keeps a value; an empty one forgets the setting. Of more than MAX_SETTINGS the oldest is forgotten."""
        with self._lock:
            values = {key: old for key, old in self._read().items() if key != name}
            if value:
                values[name] = value
            self._values = dict(list(values.items())[-MAX_SETTINGS:])
            self._write(self._values)

    def _read(self) -> dict[str, str]:
        if self._values is None:
            self._values = _read(self._file) if self._file else {}
        return self._values

    def _write(self, values: dict[str, str]) -> None:
        if self._file is None:
            return
        new = self._file.with_name(f"{self._file.name}.new")
        with contextlib.suppress(OSError):
            new.write_text(json.dumps(values), "utf-8")
            os.replace(new, self._file)


def _read(file: Path) -> dict[str, str]:
    """The settings of a file that anybody may have edited."""
    try:
        if file.stat().st_size > _MAX_BYTES:
            return {}
        found = json.loads(read_regular(file))
    except (OSError, ValueError, RecursionError):
        return {}
    pairs = found.items() if isinstance(found, dict) else ()
    return {name: value for name, value in pairs if _is_setting(name, value)}


def _is_setting(name: str, value: object) -> bool:
    if not isinstance(value, str) or len(name) > MAX_NAME or len(value) > MAX_VALUE:
        return False
    return bool(re.fullmatch(NAME, name) and re.fullmatch(VALUE, value))
