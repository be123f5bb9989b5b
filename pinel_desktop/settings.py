"""Settings of this PC. `SETTINGS` declares all of them; no other module lists settings.

The settings are in a file beside the database: the page is served before the database is open, and cookies end with
the window. `web/page.py` sends the page its settings; the page sends changes (`PUT /api/settings/page`).
"""

import contextlib
import json
import re
import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

from pinel_desktop.messages import LANGUAGES, language_of_system
from pinel_desktop.paths import read_regular

LANGUAGE, CAMERA, THEME = "pinel_language", "pinel_camera", "pinel_theme"
KIOSK, RECOGNIZER = "pinel_kiosk", "pinel_recognizer"
OVERHEAD, RESETS = "pinel_overhead", "pinel_resets"
TEXT, MAX_TEXT = "^[A-Za-z0-9_-]*$", 4000


@dataclass(frozen=True, slots=True)
class Setting:
    """A setting, whose value is a text of letters, digits, "_" and "-".

    Attributes:
        about: description of the setting, for the page about the interface.
        values: allowed values besides the default; None for any text.
        default: value as long as nobody has chosen one; "" leaves the choice to the reader of the setting.
        of_page: whether the page reads and changes the setting.
        in_database: name of the database setting in which releases before 0.3 stored it.
    """

    about: str
    values: tuple[str, ...] | None = None
    default: str = ""
    of_page: bool = True
    in_database: str | None = None

    def allows(self, value: object) -> bool:
        """Returns whether the setting may have this value."""
        if not isinstance(value, str) or len(value) > MAX_TEXT:
            return False
        if self.values is not None and value != self.default:
            return value in self.values
        return bool(re.fullmatch(TEXT, value))


SETTINGS: Mapping[str, Setting] = {
    LANGUAGE: Setting("language of page and messages", LANGUAGES, in_database="language"),
    CAMERA: Setting(
        'number of the webcam, "0" for the first', default="0", of_page=False, in_database="camera"
    ),
    THEME: Setting("colours of the page", ("light", "dark", "contrast")),
    KIOSK: Setting('"1" opens the window in kiosk mode', ("1",), of_page=False),
    RECOGNIZER: Setting(
        "name of the detector that reads signs; landmarks without one", of_page=False
    ),
    OVERHEAD: Setting(
        "camera above the floor, as `pinel overhead` writes it; none without one", of_page=False
    ),
    RESETS: Setting('"1" on a PC whose disk is as before after each start', ("1",), of_page=False),
    "pinel_class": Setting("the class last chosen"),
    "pinel_levels": Setting("level of the blocks that each group chose"),
    "pinel_mission_levels": Setting("level of the blocks chosen for each mission"),
    "pinel_muted": Setting('"1" is without sound', ("0", "1")),
    "pinel_loudness": Setting("how loud sounds are", ("quiet", "loud"), default="normal"),
    "pinel_turns": Setting(
        "minutes after which a swap is proposed", ("5", "10", "15"), default="0"
    ),
    "pinel_split": Setting("width of the blocks in the studio, per cent"),
    "pinel_projector_names": Setting(
        '"hidden" presents runs without the names of groups', ("hidden",), default="shown"
    ),
    "pinel_tours": Setting("step of each group's guided first drive"),
    "pinel_elsewhere": Setting("versions of other PCs about which a group was told"),
}
_MAX_BYTES = 2 * len(SETTINGS) * MAX_TEXT


class Settings:
    """Values by the names of `SETTINGS`, read from the file on first use.

    If the file cannot be written, changes hold until the app ends. Anybody may have edited the file, so invalid entries
    are skipped. They stay in the file, because a newer release may have written them.

    Args:
        file: None stores the settings in memory only.
    """

    def __init__(self, file: Path | None = None) -> None:
        self._file = file
        self._stored: dict[str, Any] | None = None
        self._lock = threading.Lock()

    @classmethod
    def beside(cls, database: Path) -> "Settings":
        """Returns the settings in the file beside a database."""
        return cls(database.with_name(f"{database.name}.page.json"))

    def __getitem__(self, name: str) -> str:
        return self.chosen.get(name, SETTINGS[name].default)

    @property
    def chosen(self) -> Mapping[str, str]:
        """The values that somebody has chosen."""
        with self._lock:
            stored = self._read()
        return MappingProxyType(
            {name: value for name, value in stored.items() if _is_valid(name, value)}
        )

    @property
    def language(self) -> str:
        """Language of page and messages."""
        return self[LANGUAGE] or language_of_system()

    @property
    def opens_kiosk(self) -> bool:
        """Whether the window opens in kiosk mode."""
        return self[KIOSK] == "1"

    def of_page(self) -> dict[str, str]:
        """Returns all settings that the page reads, chosen or default."""
        return {name: self[name] for name, setting in SETTINGS.items() if setting.of_page}

    def choose(self, name: str, value: str) -> None:
        """Stores an allowed value of a setting; "" restores the default."""
        with self._lock:
            stored = {key: old for key, old in self._read().items() if key != name}
            if value:
                stored[name] = value
            self._stored = stored
            self._write(stored)

    def import_from_database(self, get: Callable[[str], object]) -> None:
        """Imports settings that releases before 0.3 stored in the database, unless they were chosen since."""
        for name, setting in SETTINGS.items():
            if setting.in_database is None or name in self.chosen:
                continue
            value = get(setting.in_database)
            if isinstance(value, str) and setting.allows(value):
                self.choose(name, value)

    def _read(self) -> dict[str, Any]:
        if self._stored is None:
            self._stored = _read(self._file) if self._file else {}
        return self._stored

    def _write(self, values: dict[str, Any]) -> None:
        if self._file is None:
            return
        # imported here, because the store would delay the window
        from storage.file.open_files import replace  # noqa: PLC0415

        new = self._file.with_name(f"{self._file.name}.new")
        with contextlib.suppress(OSError):
            new.write_text(json.dumps(values), "utf-8")
            replace(new, self._file)


def _read(file: Path) -> dict[str, Any]:
    try:
        if file.stat().st_size > _MAX_BYTES:
            return {}
        found = json.loads(read_regular(file))
    except (OSError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def _is_valid(name: str, value: object) -> bool:
    return name in SETTINGS and bool(value) and SETTINGS[name].allows(value)
