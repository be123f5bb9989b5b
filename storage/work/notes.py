"""What the teacher writes about a run, for the group to read next time."""

import sqlite3

from storage.connection import Access
from storage.errors import StoreError
from storage.records import NoteRow
from storage.text import clean_text, new_id

MAX_NOTE = 1000
_SELECT = """
    SELECT notes.id, notes.run_id, notes.text, notes.written_at, notes.seen_at, runs.program_id, runs.program_name
    FROM notes JOIN runs ON runs.id = notes.run_id"""


class Notes:
    """The notes of the file."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def of_run(self, run_id: str) -> list[NoteRow]:
        """The oldest first."""
        return self._found("notes.run_id = ? ORDER BY notes.id", run_id)

    def of_group(self, group_id: str, *, unseen: bool = False) -> list[NoteRow]:
        """The newest first; with `unseen` those that the group has not read yet."""
        more = " AND notes.seen_at IS NULL" if unseen else ""
        return self._found(f"runs.group_id = ?{more} ORDER BY notes.id DESC", group_id)

    def get(self, note_id: str) -> NoteRow:
        """Raises StoreError `note_not_found`."""
        found = self._found("notes.id = ?", note_id)
        if not found:
            raise StoreError("note_not_found", id=note_id)
        return found[0]

    def write(self, run_id: str, text: str) -> NoteRow:
        """Raises StoreError `run_not_found`, `note_empty` or `note_too_long`."""
        clean, now = _clean(text), self._access.now()

        def insert(db: sqlite3.Connection) -> str:
            if db.execute("SELECT 1 FROM runs WHERE id = ?", [run_id]).fetchone() is None:
                raise StoreError("run_not_found", id=run_id)
            note_id = new_id()
            db.execute(
                "INSERT INTO notes (id, run_id, text, written_at, changed_at) VALUES (?, ?, ?, ?, ?)",
                [note_id, run_id, clean, now, now],
            )
            return note_id

        return self.get(self._access.write(insert))

    def rewrite(self, note_id: str, text: str) -> NoteRow:
        """Another text, which the group has not read yet. Raises StoreError as `write`, and `note_not_found`."""
        clean, now = _clean(text), self._access.now()
        return self._change(
            note_id,
            "text = ?, seen_at = NULL, changed_at = ?, revision = revision + 1",
            [clean, now],
        )

    def see(self, note_id: str) -> NoteRow:
        """Notes that the group has read it: no new state, which would beat what the teacher writes meanwhile.

        Raises:
            StoreError: `note_not_found`.
        """
        return self._change(note_id, "seen_at = ?", [self._access.now()])

    def _change(self, note_id: str, assignments: str, values: list[str]) -> NoteRow:
        self._access.write(
            lambda db: (
                db.execute(
                    f"UPDATE notes SET {assignments} WHERE id = ?", [*values, note_id]
                ).rowcount
            )
        )
        return self.get(note_id)

    def _found(self, which: str, value: str) -> list[NoteRow]:
        with self._access.reading() as db:
            rows = db.execute(f"{_SELECT} WHERE {which}", [value]).fetchall()
        return [NoteRow(**dict(row)) for row in rows]


def _clean(text: str) -> str:
    clean = clean_text(text)
    if not clean:
        raise StoreError("note_empty")
    if len(clean) > MAX_NOTE:
        raise StoreError("note_too_long", length=len(clean), max=MAX_NOTE)
    return clean
