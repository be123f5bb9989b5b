"""Notes of the teacher about runs, which the group reads next time."""

from collections.abc import Callable

from storage.errors import StoreError
from storage.file.repository import Repository
from storage.limits import MAX_NOTE
from storage.row_types import NoteRow
from storage.sql import insert, not_found, require, selected, update_row
from storage.sqlite import sqlite3
from storage.text import clean_text, new_id

_RUN = {name: f"runs.{name}" for name in ("program_id", "program_name")}
_SELECT = f"{selected(NoteRow, 'notes', **_RUN)} JOIN runs ON runs.id = notes.run_id"


class Notes(Repository):
    """The notes of the file."""

    def of_run(self, run_id: str) -> list[NoteRow]:
        """Returns the notes about a run, oldest first."""
        return self._select("notes.run_id = ? ORDER BY notes.id", run_id)

    def of_group(self, group_id: str, *, unseen: bool = False) -> list[NoteRow]:
        """Returns the notes to a group, newest first; with `unseen` those that the group has not read yet."""
        more = " AND notes.seen_at IS NULL" if unseen else ""
        return self._select(f"runs.group_id = ?{more} ORDER BY notes.id DESC", group_id)

    def get(self, note_id: str) -> NoteRow:
        """Returns a note. Raises StoreError `note_not_found`."""
        found = self._select("notes.id = ?", note_id)
        if not found:
            raise not_found("notes", note_id)
        return found[0]

    def write(self, run_id: str, text: str) -> NoteRow:
        """Adds a note. Raises StoreError `run_not_found`, `note_empty` or `note_too_long`."""
        now = self._database.now()
        row = {"id": new_id(), "run_id": run_id, "text": _clean(text)}
        row |= {"written_at": now, "changed_at": now}

        def write(db: sqlite3.Connection) -> None:
            require(db, "runs", run_id)
            insert(db, "notes", row)

        return self._after(row["id"], write)

    def rewrite(self, note_id: str, text: str) -> NoteRow:
        """Replaces the text, which then counts as unread. Raises StoreError as `write`, and `note_not_found`."""
        values, now = {"text": _clean(text), "seen_at": None}, self._database.now()
        return self._after(note_id, lambda db: update_row(db, "notes", note_id, values, now))

    def acknowledge(self, note_id: str) -> NoteRow:
        """Records that the group has read it, without raising the revision.

        A greater revision would win over a text that the teacher writes meanwhile on another PC.

        Raises:
            StoreError: `note_not_found`.
        """
        query, values = "UPDATE notes SET seen_at = ? WHERE id = ?", [self._database.now(), note_id]
        return self._after(note_id, lambda db: db.execute(query, values).rowcount)

    def _after(self, note_id: str, write: Callable[[sqlite3.Connection], object]) -> NoteRow:
        self._database.write(write)
        return self.get(note_id)

    def _select(self, condition: str, value: str) -> list[NoteRow]:
        return [NoteRow(**dict(row)) for row in self._rows(f"{_SELECT} WHERE {condition}", value)]


def _clean(text: str) -> str:
    clean = clean_text(text)
    if not clean:
        raise StoreError("note_empty")
    if len(clean) > MAX_NOTE:
        raise StoreError("note_too_long", length=len(clean), max=MAX_NOTE)
    return clean
