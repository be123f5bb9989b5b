"""Versions of programs: every state that was saved, never overwritten."""

import sqlite3
from collections.abc import Sequence
from dataclasses import astuple

from storage.connection import Access
from storage.errors import StoreError
from storage.groups import touch
from storage.records import FaultRow, Json, VersionRow
from storage.text import dumped, loaded, new_id

_SELECT = "SELECT id, program_id, created_at, workspace, document, faults, world FROM versions"
_CONTENT = ("workspace", "document", "faults", "world")
_Content = tuple[str, str | None, str, str | None]
# by number, not by time: the clocks of school PCs are often wrong
_NEWEST = f"{_SELECT} WHERE program_id = ? ORDER BY number DESC, id DESC LIMIT 1"


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
            row = db.execute(f"{_SELECT} WHERE id = ?", [version_id]).fetchone()
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
    ) -> VersionRow:
        """Keeps a state; on disk when this returns. The same content as the newest version is that version.

        Raises:
            StoreError: `program_not_found`, or why nothing could be kept.
        """
        content = (
            dumped(workspace),
            None if document is None else dumped(document),
            dumped([astuple(fault) for fault in faults]),
            None if world is None else dumped(world),
        )
        now = self._access.now()
        return self.get(self._access.write(lambda db: _insert(db, program_id, content, now)))


def _insert(db: sqlite3.Connection, program_id: str, content: _Content, now: str) -> str:
    program = db.execute("SELECT group_id FROM programs WHERE id = ?", [program_id]).fetchone()
    if program is None:
        raise StoreError("program_not_found", id=program_id)
    newest = db.execute(_NEWEST, [program_id]).fetchone()
    if newest and tuple(newest[name] for name in _CONTENT) == content:
        return str(newest["id"])
    version_id = new_id()
    db.execute(
        """INSERT INTO versions (id, program_id, number, created_at, workspace, document, faults, world)
           VALUES (?, ?, (SELECT coalesce(max(number), 0) + 1 FROM versions WHERE program_id = ?), ?, ?, ?, ?, ?)""",
        [version_id, program_id, program_id, now, *content],
    )
    db.execute("UPDATE programs SET updated_at = ? WHERE id = ?", [now, program_id])
    touch(db, program["group_id"], now)
    return version_id


def _record(row: sqlite3.Row) -> VersionRow:
    return VersionRow(
        id=row["id"],
        program_id=row["program_id"],
        created_at=row["created_at"],
        workspace=loaded(row["workspace"]),
        document=loaded(row["document"]),
        faults=tuple(FaultRow(*fault) for fault in loaded(row["faults"])),
        world=loaded(row["world"]),
    )
