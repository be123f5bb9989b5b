"""Versions of programs: every saved state, never overwritten."""

from collections.abc import Sequence
from dataclasses import astuple
from typing import Any

from storage.errors import StoreError
from storage.file.connection import Timestamp
from storage.file.repository import Repository
from storage.json_check import is_deep, is_object
from storage.limits import MAX_NUMBER
from storage.row_types import FaultRow, Json, VersionRow, VersionSummary
from storage.run_validity import counted
from storage.sql import exists, insert, not_found, require, selected, update_row
from storage.sqlite import sqlite3
from storage.tables.work import VERSIONS
from storage.text import clean_name, from_json, id_of, local_time, readable_object, to_json
from storage.work.groups import record_use
from storage.work.lessons import lesson_for

_LABEL = "coalesce((SELECT text FROM version_labels WHERE version_labels.id = versions.id), '')"
# compares `versions` with `parents`; compares the long workspaces only if something else has changed
SETUP_ONLY = """CASE WHEN versions.setup IS NOT parents.setup OR versions.world IS NOT parents.world
           THEN versions.workspace IS parents.workspace ELSE 0 END"""
_SELECT = selected(VersionRow, "versions", label=_LABEL)
_SUMMARY = selected(
    VersionSummary,
    "versions",
    can_run="document IS NOT NULL",
    label=_LABEL,
    computer="SELECT name FROM computers WHERE computers.id = versions.computer_id",
    n_runs="SELECT count(*) FROM runs WHERE version_id = versions.id",
    n_passed=f"SELECT count(*) FROM runs WHERE version_id = versions.id AND {counted()}",
    setup_only=f"SELECT {SETUP_ONLY} FROM versions AS parents WHERE parents.id = versions.parent_id",
)
_CONTENT = ("workspace", "document", "faults", "world", "setup")
_Content = tuple[str, str | None, str, str | None, str | None]
# by number, not by time: the clocks of school PCs are often wrong
_NEWEST_FIRST = "ORDER BY number DESC, id DESC"
_NEWEST = f"SELECT id FROM versions WHERE program_id = ? {_NEWEST_FIRST} LIMIT 1"
# SQLite compares, because a damaged newest version may not be readable
_SAME = f"""SELECT id, number, {" AND ".join(f"{name} IS ?" for name in _CONTENT)} AS is_same
    FROM versions WHERE program_id = ? {_NEWEST_FIRST} LIMIT 1"""
_EARLIER = f"""SELECT id FROM versions WHERE program_id = ?
    AND (number, id) < (SELECT number, id FROM versions WHERE id = ?) {_NEWEST_FIRST}"""
# versions without a successor, made on another PC than the newest
_NEWEST_ON_OTHER_PC = f"""{_SUMMARY} WHERE program_id = ?
         AND computer_id IS NOT (SELECT computer_id FROM versions WHERE id = ?)
         AND id NOT IN (SELECT parent_id FROM versions WHERE program_id = ? AND parent_id IS NOT NULL)
    {_NEWEST_FIRST} LIMIT 1"""


class Versions(Repository):
    """The versions of the file."""

    def newest(self, program_id: str) -> VersionRow | None:
        """Returns the newest version, None for a program that was never saved. Raises StoreError `version_damaged`."""
        rows = self._rows(_NEWEST, program_id)
        return self.get(str(rows[0]["id"])) if rows else None

    def newest_intact(self, program_id: str) -> VersionRow | None:
        """Returns the newest version that is intact, None if there is none."""
        try:
            return self.newest(program_id)
        except StoreError as error:
            if error.code != "version_damaged":
                raise
            sound = error.params["sound"]
            return self.get(str(sound)) if sound else None

    def get(self, version_id: str) -> VersionRow:
        """Returns a version; first repairs a damaged one from a backup.

        Raises:
            StoreError: `version_not_found`; `version_damaged` with its time, and with id and time of the last intact
                version before it.
        """
        try:
            if row := self._intact_row("versions", f"{_SELECT} WHERE id = ?", version_id):
                return _version_row(row)
        except (ValueError, TypeError, RecursionError) as error:
            # a damaged row of an earlier release, which has no checksum
            raise self._damaged(version_id) from error
        raise self._damaged(version_id)

    def save(
        self,
        program_id: str,
        workspace: Json,
        document: Json | None,
        faults: Sequence[FaultRow] = (),
        world: Json | None = None,
        *,
        setup: Json | None = None,
        parent_id: str | None = None,
    ) -> VersionRow:
        """Saves a state; on disk when this returns. If the newest version has the same content, returns that version.

        Args:
            parent_id: the version that was edited; None for the newest.

        Raises:
            StoreError: `program_not_found`; `version_not_found` if the edited version is not of this program;
                `work_unreadable` if the content is too deep, or has numbers too long, to be read on another PC;
                or the reason why nothing could be saved.
        """
        content = (
            to_json(workspace),
            None if document is None else to_json(document),
            to_json([astuple(fault) for fault in faults]),
            None if world is None else to_json(world),
            None if setup is None else to_json(setup),
        )
        values = _read_back(content)
        now = self._database.timestamp()
        version_id = self._database.write(
            lambda db: _insert(db, program_id, content, parent_id, now)
        )
        return _version_row(self._row("versions", f"{_SELECT} WHERE id = ?", version_id), values)

    def _damaged(self, version_id: str) -> StoreError:
        times = "SELECT id, program_id, created_at FROM versions WHERE id = ?"
        row = self._row("versions", times, version_id)
        sound = next(filter(self._can_be_read, self._before(row["program_id"], version_id)), None)
        sound_at = self._row("versions", times, sound)["created_at"] if sound else ""
        return StoreError(
            "version_damaged",
            id=version_id,
            time=_local(row["created_at"]),
            sound=sound,
            sound_time=sound_at,
        )

    def _before(self, program_id: str, version_id: str) -> list[str]:
        return [str(row["id"]) for row in self._rows(_EARLIER, program_id, version_id)]

    def _can_be_read(self, version_id: str) -> bool:
        try:
            _version_row(self._row("versions", f"{_SELECT} WHERE id = ?", version_id))
        except (ValueError, TypeError, RecursionError):
            return False
        return self._is_intact("versions", version_id)

    def newest_on_other_pc(self, newest: VersionRow) -> VersionSummary | None:
        """Returns the newest version without successor that another PC made; None if there is none."""
        rows = self._rows(_NEWEST_ON_OTHER_PC, newest.program_id, newest.id, newest.program_id)
        return _version_summary(rows[0]) if rows else None

    def history_of(
        self, program_id: str, *, before: str | None = None, limit: int = 200
    ) -> list[VersionSummary]:
        """Returns the program's versions, newest first; `before` is the id of the last one of the previous page."""
        after = "(number, id) < (SELECT number, id FROM versions WHERE id = ?)"
        query = (
            f"{_SUMMARY} WHERE program_id = ? AND (? IS NULL OR {after}) {_NEWEST_FIRST} LIMIT ?"
        )
        return [
            _version_summary(row) for row in self._rows(query, program_id, before, before, limit)
        ]

    def label(self, version_id: str, text: str) -> VersionRow:
        """Names a version; "" deletes the name. Raises StoreError `version_not_found`, `name_too_long`."""
        clean, now = clean_name(text) if text.strip() else "", self._database.now()

        def write(db: sqlite3.Connection) -> None:
            require(db, "versions", version_id)
            if exists(db, "version_labels", version_id):
                update_row(db, "version_labels", version_id, {"text": clean}, now)
            else:
                insert(db, "version_labels", {"id": version_id, "text": clean, "changed_at": now})

        self._database.write(write)
        return self.get(version_id)


def _local(text: str) -> str:
    """Returns a stored time by the clock of this PC, "?" for a damaged time."""
    try:
        return local_time(text)
    except (ValueError, OverflowError):
        return "?"


def _insert(
    db: sqlite3.Connection,
    program_id: str,
    content: _Content,
    parent_id: str | None,
    now: Timestamp,
) -> str:
    program = db.execute("SELECT group_id FROM programs WHERE id = ?", [program_id]).fetchone()
    if program is None:
        raise not_found("programs", program_id)
    newest = db.execute(_SAME, [*content, program_id]).fetchone()
    if newest and newest["is_same"]:
        return str(newest["id"])
    if parent_id is not None:
        _require_own(db, program_id, parent_id)
    version = {
        "program_id": program_id,
        "number": min(newest["number"] + 1, MAX_NUMBER) if newest else 1,
        "created_at": now.text,
        **dict(zip(_CONTENT, content, strict=True)),
        "parent_id": parent_id or (newest["id"] if newest else None),
    }
    version["lesson_id"], version["computer_id"] = lesson_for(db, program["group_id"], now)
    version["id"] = id_of(to_json([version[name] for name in VERSIONS.bound]))
    insert(db, "versions", version)
    db.execute("UPDATE programs SET updated_at = ? WHERE id = ?", [now.text, program_id])
    record_use(db, program["group_id"], now.text)
    return str(version["id"])


def _read_back(content: _Content) -> list[Any]:
    """Returns the values of texts that `to_json` wrote. Such JSON can only be too deep or have numbers too long.

    Content that no bundle can have is refused, because every export would leave it out with its children.
    """
    workspace, *texts = content
    if (is_deep(workspace) and not is_object(workspace)) or any(
        is_deep(text or "") for text in texts
    ):
        raise StoreError("work_unreadable")
    try:
        return [from_json(text) for text in content]
    except ValueError as error:
        raise StoreError("work_unreadable") from error


def _require_own(db: sqlite3.Connection, program_id: str, version_id: str) -> None:
    query = "SELECT 1 FROM versions WHERE id = ? AND program_id = ?"
    if db.execute(query, [version_id, program_id]).fetchone() is None:
        raise not_found("versions", version_id)


def _version_summary(row: sqlite3.Row) -> VersionSummary:
    flags = {name: bool(row[name]) for name in ("can_run", "setup_only")}
    return VersionSummary(**{**dict(row), **flags, "setup": readable_object(row["setup"])})


def _version_row(row: sqlite3.Row, values: Sequence[Any] | None = None) -> VersionRow:
    """Returns the record of a row; `values` are its parsed content, if at hand."""
    content = dict(
        zip(_CONTENT, values or [from_json(row[name]) for name in _CONTENT], strict=True)
    )
    content["faults"] = tuple(FaultRow(*fault) for fault in content["faults"])
    return VersionRow(**{**dict(row), **content})
