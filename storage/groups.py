"""Groups of pupils."""

import sqlite3

from storage.connection import Access
from storage.errors import StoreError
from storage.records import GroupRow
from storage.text import clean_name, name_key, new_id

# told apart on a projector and by colour-blind pupils; each dark enough for white text
COLORS = (
    "#1f6f8b",
    "#b3541e",
    "#5b4b9a",
    "#2e7d4f",
    "#a03561",
    "#8a6a00",
    "#34568b",
    "#7a3e3e",
    "#00796b",
    "#6d5d4b",
    "#9c3d97",
    "#4a6b1c",
)
_SELECT = """
    SELECT id, name, color, created_at,
           (SELECT count(*) FROM programs WHERE group_id = groups.id) AS n_programs,
           (SELECT count(*) FROM runs WHERE group_id = groups.id) AS n_runs
    FROM groups"""


class Groups:
    """The groups of the file."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def all(self) -> list[GroupRow]:
        """Newest use first."""
        with self._access.reading() as db:
            rows = db.execute(f"{_SELECT} ORDER BY used_at DESC, id DESC").fetchall()
        return [GroupRow(**dict(row)) for row in rows]

    def get(self, group_id: str) -> GroupRow:
        """Raises StoreError `group_not_found`."""
        with self._access.reading() as db:
            row = db.execute(f"{_SELECT} WHERE id = ?", [group_id]).fetchone()
        if row is None:
            raise StoreError("group_not_found", id=group_id)
        return GroupRow(**dict(row))

    def create(self, name: str) -> GroupRow:
        """Raises StoreError `group_exists`, `name_empty` or `name_too_long`."""
        clean = clean_name(name)
        group_id = self._access.write(lambda db: _insert(db, clean, self._access.now()))
        return self.get(group_id)


def touch(db: sqlite3.Connection, group_id: str, now: str) -> None:
    """Notes that the group was used, within the transaction of what it did."""
    db.execute("UPDATE groups SET used_at = ? WHERE id = ?", [now, group_id])


def _insert(db: sqlite3.Connection, name: str, now: str) -> str:
    taken = db.execute("SELECT name FROM groups WHERE name_key = ?", [name_key(name)]).fetchone()
    if taken:
        raise StoreError("group_exists", name=taken["name"])
    group_id = new_id()
    db.execute(
        "INSERT INTO groups (id, name, name_key, color, created_at, used_at) VALUES (?, ?, ?, ?, ?, ?)",
        [group_id, name, name_key(name), _rarest_color(db), now, now],
    )
    return group_id


def _rarest_color(db: sqlite3.Connection) -> str:
    used = [row["color"] for row in db.execute("SELECT color FROM groups")]
    return min(COLORS, key=used.count)
