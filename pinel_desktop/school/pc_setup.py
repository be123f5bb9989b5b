"""The set-up file of a PC, `pinel.toml`: what a technician decides once for all PCs of a school (docs/install.md).

`read_pc_setup` checks the whole file, and `apply` then changes the database and the settings; both may be repeated.
"""

import re
import tomllib
import uuid
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, get_args

from pinel_desktop.command_name import command_name
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import explain
from pinel_desktop.paths import read_regular
from pinel_desktop.robot.robot_profile import PROFILES, profile_from
from pinel_desktop.school.robot_profiles import RobotProfiles, require_room
from pinel_desktop.school.teacher import TeacherSessions, stored_pin
from pinel_desktop.settings import CAMERA, KIOSK, LANGUAGE, RESETS, SETTINGS, THEME, Settings
from storage import Store, StoreError
from storage.exchange.backup_share import COPIES_BACKUPS, SHARED_FOLDER
from storage.exchange.lesson_merging import check_lesson_file
from storage.text import clean_name, name_key
from storage.work.class_presets import LEVELS, SwapMinutes

# the classes of all PCs that read the same file must have the same key, or a merge would list them twice
_CLASSES = uuid.UUID("6f1c1d52-3f8a-5c55-9d0f-8a8f6d0b7a11")
_MAX_BYTES = 1_000_000
_SETTINGS = {"language": LANGUAGE, "theme": THEME, "camera": CAMERA}
_TEXT, _BOOLEAN = '"…"', "true, false"


class PcSetupError(Exception):
    """A set-up file has faults; `faults` names the line of each."""

    def __init__(self, faults: list[PinelError]) -> None:
        super().__init__(f"{len(faults)} faults")
        self.faults = faults


@dataclass(slots=True)
class PcSetup:
    """The contents of a set-up file; None or empty for what it does not decide.

    Attributes:
        settings: values by the names of `SETTINGS`.
        school: tells classes of the same name in two schools apart.
        swap_minutes: minutes between reminders to swap roles, in the class.
        lesson: a lesson file, to open on the PC.
        pin: the stored form of the teacher's PIN.
        kiosk: whether the window opens in kiosk mode.
        at_login: whether the window opens at each login.
        resets: whether the PC's disk is as before after each start.
        robots: fields of the profiles of real robots, by link.
    """

    settings: dict[str, str] = field(default_factory=dict)
    school: str = ""
    classroom: str | None = None
    level: int | None = None
    swap_minutes: int | None = None
    lesson: Path | None = None
    shared_folder: str | None = None
    takes_backups: bool | None = None
    pin: Mapping[str, Any] | None = None
    kiosk: bool | None = None
    at_login: bool | None = None
    resets: bool | None = None
    robots: dict[str, dict[str, Any]] = field(default_factory=dict)


def read_pc_setup(path: Path) -> PcSetup:
    """Reads a set-up file.

    Raises:
        PcSetupError: with every fault: `file_unreadable`, `pc_setup_syntax`, `pc_setup_unknown`, `pc_setup_value`,
            `pc_setup_needs_class`, `pc_setup_needs_pin`, or `pc_setup_entry` with the fault of the lesson file or of a
            robot's profile.
    """
    try:
        content = read_regular(path)
        text = content[:_MAX_BYTES].decode("utf-8")
        found = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        line = re.search(r"line (\d+)", str(error))
        last = text.count("\n") + 1
        values = {"line": int(line[1]) if line else last, "path": str(path), "problem": str(error)}
        raise PcSetupError([PinelError("pc_setup_syntax", **values)]) from error
    except (OSError, ValueError, RecursionError) as error:
        raise PcSetupError([PinelError("file_unreadable", path=str(path))]) from error
    return _Reader(found, text, path).read()


class _Reader:
    """Checks the entries of a file one by one, and collects all faults."""

    def __init__(self, found: Mapping[str, Any], text: str, path: Path) -> None:
        self._found, self._lines, self._path = found, text.splitlines(), path
        self._known: list[str] = []
        self._faults: list[PinelError] = []

    def read(self) -> PcSetup:
        lesson = self._text("lesson")
        setup = PcSetup(
            settings=dict(self._settings()),
            school=self._text("school") or "",
            classroom=self._text("class"),
            level=self._number("level", LEVELS),
            swap_minutes=self._number("swap_minutes", get_args(SwapMinutes)),
            lesson=self._path.parent / lesson if lesson else None,
            shared_folder=self._text("shared_folder"),
            takes_backups=self._boolean("copies_of_backups"),
            pin=self._pin(),
            kiosk=self._boolean("kiosk"),
            at_login=self._boolean("at_login"),
            resets=self._boolean("resets_at_reboot"),
            robots=dict(self._robots()),
        )
        self._check_together(setup)
        if self._faults:
            self._faults.sort(key=lambda fault: int(str(fault.params["line"])))
            raise PcSetupError(self._faults)
        return setup

    def _check_together(self, setup: PcSetup) -> None:
        """Checks names that do not exist, what needs a class, and the lesson file."""
        for name in self._found.keys() - set(self._known):
            self._fault("pc_setup_unknown", name, known=self._known)
        if setup.classroom is None:
            for name in {"level", "swap_minutes"} & self._found.keys():
                self._fault("pc_setup_needs_class", name)
        if setup.kiosk and "pin_hash" not in self._found:
            self._fault("pc_setup_needs_pin", "kiosk")
        if setup.lesson is not None:
            try:
                check_lesson_file(setup.lesson)
            except StoreError as error:
                self._entry_fault("lesson", error)

    def _get(self, name: str) -> Any:
        self._known.append(name)
        return self._found.get(name)

    def _settings(self) -> Iterator[tuple[str, str]]:
        for name, setting in _SETTINGS.items():
            value = self._get(name)
            if value is None:
                continue
            given = str(value) if type(value) is int else value
            if name == "camera":
                is_valid, allowed = bool(re.fullmatch("[0-9]", str(given))), "0, 1, … 9"
            else:
                declared = SETTINGS[setting]
                is_valid = bool(given) and declared.allows(given)
                allowed = ", ".join(f'"{one}"' for one in declared.values or ())
            if is_valid:
                yield setting, str(given)
            else:
                self._value_fault(name, allowed)

    def _text(self, name: str) -> str | None:
        value = self._get(name)
        if value is None:
            return None
        try:
            return clean_name(value) if name in ("class", "school") else _path_text(value)
        except (StoreError, TypeError, AttributeError):
            self._value_fault(name, _TEXT)
            return None

    def _number(self, name: str, allowed: tuple[int, ...]) -> int | None:
        value = self._get(name)
        if value is None or (type(value) is int and value in allowed):
            return value
        self._value_fault(name, ", ".join(map(str, allowed)))
        return None

    def _boolean(self, name: str) -> bool | None:
        value = self._get(name)
        if value is None or isinstance(value, bool):
            return value
        self._value_fault(name, _BOOLEAN)
        return None

    def _pin(self) -> Mapping[str, Any] | None:
        text = self._get("pin_hash")
        if text is None:
            return None
        pin = stored_pin(text)
        if pin is None:
            self._value_fault("pin_hash", f"{command_name()} pin --hash")
        return pin

    def _robots(self) -> Iterator[tuple[str, dict[str, Any]]]:
        robots = self._get("robot")
        if robots is None:
            return
        if not isinstance(robots, dict):
            self._value_fault("robot", "[robot.dds]")
            return
        for link, fields in robots.items():
            if link not in PROFILES or not isinstance(fields, dict):
                self._value_fault(
                    "robot", ", ".join(f"[robot.{one}]" for one in PROFILES), value=link
                )
                continue
            try:
                require_room(profile_from({**fields, "link": link}))
            except PinelError as error:
                self._entry_fault(f"robot.{link}", error)
            else:
                yield link, fields

    def _value_fault(self, name: str, allowed: str, value: object = None) -> None:
        shown = self._found[name] if value is None else value
        self._fault("pc_setup_value", name, value=shown, allowed=allowed)

    def _entry_fault(self, name: str, problem: PinelError | StoreError) -> None:
        text = explain(problem)
        self._fault("pc_setup_entry", name, problem=text.message, remedy=text.full_remedy)

    def _fault(self, code: str, name: str, **params: object) -> None:
        self._faults.append(PinelError(code, line=self._line_of(name), name=name, **params))

    def _line_of(self, name: str) -> int:
        """Returns the number of the line with a key or the head of a table; 1 if it is written in another way."""
        key = re.compile(rf"""\s*(?:\[\s*)?["']?{re.escape(name)}["']?\s*(?:[=.\]]|$)""")
        return next((n for n, line in enumerate(self._lines, 1) if key.match(line)), 1)


def _path_text(value: Any) -> str:
    if not isinstance(value, str) or not value.strip() or "\0" in value:
        raise TypeError
    return value


def apply(setup: PcSetup, store: Store, settings: Settings) -> None:
    """Changes database and settings as the file says. Raises StoreError if the database cannot be written."""
    classroom_id = None
    if setup.lesson is not None:
        _, lesson_id = store.exchange.merge_lesson(setup.lesson)
        classroom_id = store.lessons.resume(lesson_id).classroom_id
    for link, fields in setup.robots.items():
        RobotProfiles(store.settings, (link,)).save(link, fields)
    if setup.classroom is not None:
        classroom_id = _classroom(setup.school, setup.classroom, store)
        _apply_preset(setup, classroom_id, store)
    if setup.shared_folder is not None:
        store.settings.set(SHARED_FOLDER, setup.shared_folder)
    if setup.takes_backups is not None:
        store.settings.set(COPIES_BACKUPS, setup.takes_backups)
    if setup.pin is not None:
        TeacherSessions(store.settings).set_stored_pin(setup.pin)
    for name, is_chosen in ((KIOSK, setup.kiosk), (RESETS, setup.resets)):
        if is_chosen is not None:
            settings.choose(name, "1" if is_chosen else "")
    chosen = {"pinel_class": classroom_id} if classroom_id else {}
    for name, value in {**setup.settings, **chosen}.items():
        settings.choose(name, value)


def _classroom(school: str, name: str, store: Store) -> str:
    """Returns the key of the class with this name, which is made if it does not exist."""
    known = next(
        (row.id for row in store.classrooms.all() if name_key(row.name) == name_key(name)), None
    )
    if known is not None:
        return known
    key = uuid.uuid5(_CLASSES, f"{name_key(school)}\n{name_key(name)}")
    return store.classrooms.create(name, key=str(key)).id


def _apply_preset(setup: PcSetup, classroom_id: str, store: Store) -> None:
    decided = {"level": setup.level, "swap_minutes": setup.swap_minutes}
    changed = {name: value for name, value in decided.items() if value is not None}
    if changed:
        store.class_presets.set(classroom_id, {**store.class_presets.get(classroom_id), **changed})
