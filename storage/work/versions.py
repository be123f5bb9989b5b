"""Versions of programs: every state that was saved, never overwritten."""

import sqlite3
from collections.abc import Sequence
from dataclasses import astuple

from storage.connection import Access, Moment
from storage.errors import StoreError
from storage.groups import touch
from storage.json_check import is_object, parsed
from storage.lessons import lesson_for
from storage.limits import MAX_NUMBER
from storage.records import FaultRow, Json, VersionMark, VersionRow
from storage.text import clean_name, dumped, loaded, new_id

_SELECT = """
    SELECT versions.id, program_id, created_at, workspace, document, faults, world, number, parent_id, lesson_id,
           coalesce(version_labels.text, '') AS label
    FROM versions LEFT JOIN version_labels ON version_labels.id = versions.id"""
_MARK = """
    SELECT versions.id, number, versions.created_at, document IS NOT NULL AS can_run, parent_id, lesson_id,
           coalesce(version_labels.text, '') AS label, computers.name AS computer,
           (SELECT count(*) FROM runs WHERE version_id = versions.id) AS n_runs,
           (SELECT count(*) FROM runs WHERE version_id = versions.id AND passed) AS n_passed
    FROM versions LEFT JOIN version_labels ON version_labels.id = versions.id
         LEFT JOIN computers ON computers.id = versions.computer_id"""
_CONTENT = ("workspace", "document", "faults", "world")
_Content = tuple[str, str | None, str, str | None]
# ends of the line that another PC than that of the newest made of an older version
_ELSEWHERE = f"""{_MARK} WHERE program_id = :program
         AND versions.computer_id IS NOT (SELECT computer_id FROM versions WHERE id = :newest)
         AND versions.id NOT IN (SELECT parent_id FROM versions WHERE program_id = :program AND parent_id IS NOT NULL)
    ORDER BY number DESC, versions.id DESC LIMIT 1"""
# by number, not by time: the clocks of school PCs are often wrong
_NEWEST = f"{_SELECT} WHERE program_id = ? ORDER BY number DESC, versions.id DESC LIMIT 1"


class Versions:
    """The versions of the file."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def newest(self, program_id: str) -> VersionRow | None:
        """None for a program that was never saved."""
        with self._access.reading() as db:
            row = db.execute(_NEWEST, [program_id]).fetchone()
        return _record(row) if row else None

    def get(self, version_id: str) -> VersionRow:
        """Raises StoreError `version_not_found`."""
        with self._access.reading() as db:
            row = db.execute(f"{_SELECT} WHERE versions.id = ?", [version_id]).fetchone()
        if row is None:
            raise StoreError("version_not_found", id=version_id)
        return _record(row)

    def save(
        self,
        program_id: str,
        workspace: Json,
        document: Json | None,
        faults: Sequence[FaultRow] = (),
        world: Json | None = None,
        *,
        parent_id: str | None = None,
    ) -> VersionRow:
        """Keeps a state; on disk when this returns. The same content as the newest version is that version.

        Args:
            parent_id: the version that was edited; the newest when not told.

        Raises:
            StoreError: `program_not_found`; `version_not_found` where the one edited is none of this program;
                `work_unreadable` too deep, or with numbers too long, to be read on another PC; or why nothing could
                be kept.
        """
        content = (
            dumped(workspace),
            None if document is None else dumped(document),
            dumped([astuple(fault) for fault in faults]),
            None if world is None else dumped(world),
        )
        _require_readable(content)
        now = self._access.moment()
        return self.get(
            self._access.write(lambda db: _insert(db, program_id, content, parent_id, now))
        )

    def elsewhere(self, newest: VersionRow) -> VersionMark | None:
        """The last of what another PC made of an older version while this newest was made; None where there is none."""
        with self._access.reading() as db:
            row = db.execute(
                _ELSEWHERE, {"program": newest.program_id, "newest": newest.id}
            ).fetchone()
        return _mark(row) if row else None

    def line_of(
        self, program_id: str, *, before: str | None = None, limit: int = 200
    ) -> list[VersionMark]:
        """The program's versions, the newest first; `before` is the id of the last of the page before."""
        after = "(number, versions.id) < (SELECT number, id FROM versions WHERE id = ?)"
        with self._access.reading() as db:
            rows = db.execute(
                f"""{_MARK} WHERE program_id = ? AND (? IS NULL OR {after})
                    ORDER BY number DESC, versions.id DESC LIMIT ?""",
                [program_id, before, before, limit],
            ).fetchall()
        return [_mark(row) for row in rows]

    def label(self, version_id: str, text: str) -> VersionRow:
        """Gives a version a name, or with "" takes it away. Raises StoreError `version_not_found`, `name_too_long`."""
        clean, now = clean_name(text) if text.strip() else "", self._access.now()

        def write(db: sqlite3.Connection) -> None:
            if db.execute("SELECT 1 FROM versions WHERE id = ?", [version_id]).fetchone() is None:
                raise StoreError("version_not_found", id=version_id)
            db.execute(
                """INSERT INTO version_labels (id, text, changed_at) VALUES (?, ?, ?)
                   ON CONFLICT (id) DO UPDATE SET text = excluded.text, revision = revision + 1,
                       changed_at = excluded.changed_at""",
                [version_id, clean, now],
            )

        self._access.write(write)
        return self.get(version_id)


def _insert(
    db: sqlite3.Connection, program_id: str, content: _Content, parent_id: str | None, now: Moment
) -> str:
    program = db.execute("SELECT group_id FROM programs WHERE id = ?", [program_id]).fetchone()
    if program is None:
        raise StoreError("program_not_found", id=program_id)
    newest = db.execute(_NEWEST, [program_id]).fetchone()
    if newest and tuple(newest[name] for name in _CONTENT) == content:
        return str(newest["id"])
    if parent_id is not None:
        _require_own(db, program_id, parent_id)
    version = {
        "id": new_id(),
        "program_id": program_id,
        "number": min(newest["number"] + 1, MAX_NUMBER) if newest else 1,
        "created_at": now.text,
        **dict(zip(_CONTENT, content, strict=True)),
        "parent_id": parent_id or (newest["id"] if newest else None),
    }
    version["lesson_id"], version["computer_id"] = lesson_for(db, program["group_id"], now)
    marks = ", ".join(f":{column}" for column in version)
    db.execute(f"INSERT INTO versions ({', '.join(version)}) VALUES ({marks})", version)
    db.execute("UPDATE programs SET updated_at = ? WHERE id = ?", [now.text, program_id])
    touch(db, program["group_id"], now.text)
    return str(version["id"])


def _require_readable(content: _Content) -> None:
    """What no bundle could carry is not kept: it would hold up all that is exported with it."""
    workspace, document, faults, world = content
    others = [text for text in (document, faults, world) if text is not None]
    if not is_object(workspace) or any(parsed(text) is None for text in others):
        raise StoreError("work_unreadable")


def _require_own(db: sqlite3.Connection, program_id: str, version_id: str) -> None:
    query = "SELECT 1 FROM versions WHERE id = ? AND program_id = ?"
    if db.execute(query, [version_id, program_id]).fetchone() is None:
        raise StoreError("version_not_found", id=version_id)


def _mark(row: sqlite3.Row) -> VersionMark:
    return VersionMark(**{**dict(row), "can_run": bool(row["can_run"])})


def _record(row: sqlite3.Row) -> VersionRow:
    return VersionRow(
        id=row["id"],
        program_id=row["program_id"],
        created_at=row["created_at"],
        workspace=loaded(row["workspace"]),
        document=loaded(row["document"]),
        faults=tuple(FaultRow(*fault) for fault in loaded(row["faults"])),
        world=loaded(row["world"]),
        **{name: row[name] for name in ("number", "label", "parent_id", "lesson_id")},
    )
