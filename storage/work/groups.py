"""Groups of pupils: a name, a colour and a picture, never the pupils' names."""

import re
from collections.abc import Mapping
from dataclasses import replace

from storage.choices import COLORS, GREY, PICTURES
from storage.errors import StoreError
from storage.file.repository import Repository
from storage.row_types import GroupRow
from storage.sql import insert, not_found, require, selected, setup_value, update_row
from storage.sqlite import sqlite3
from storage.text import clean_name, name_key, new_id

_COLOR = re.compile("#[0-9a-f]{6}")
_SELECT = selected(
    GroupRow,
    "groups",
    n_programs="SELECT count(*) FROM programs WHERE group_id = groups.id AND deleted_at IS NULL",
    n_in_bin="SELECT count(*) FROM programs WHERE group_id = groups.id AND deleted_at IS NOT NULL",
    n_runs="SELECT count(*) FROM runs WHERE group_id = groups.id",
    has_album=f"""SELECT {setup_value("preset", "album")} IS NOT 0 FROM class_presets
        WHERE class_presets.id = groups.classroom_id""",
)


class Groups(Repository):
    """The groups of the file."""

    def all(self) -> list[GroupRow]:
        """Returns all groups, the one used last first."""
        rows = self._rows(f"{_SELECT} ORDER BY used_at DESC, id DESC")
        return [_group_row(row) for row in rows]

    def get(self, group_id: str) -> GroupRow:
        """Returns a group. Raises StoreError `group_not_found`."""
        return _group_row(self._row("groups", f"{_SELECT} WHERE id = ?", group_id))

    def create(self, name: str, *, classroom_id: str | None = None, picture: str = "") -> GroupRow:
        """Adds a group. Its colour, and its picture unless one is given, are ones that few groups of the class have.

        Raises:
            StoreError: `group_exists` in that class, `classroom_not_found`, `picture_unknown`, `name_empty`,
                `name_too_long`.
        """
        clean, now = clean_name(name), self._database.now()
        _require_picture(picture)

        def write(db: sqlite3.Connection) -> str:
            if classroom_id is not None:
                require(db, "classrooms", classroom_id)
            _require_free(db, clean, classroom_id, "")
            group = {
                "id": new_id(),
                "name": clean,
                "name_key": name_key(clean),
                "color": _rarest(db, "color", COLORS, classroom_id),
                "picture": picture or _rarest(db, "picture", PICTURES, classroom_id),
                "classroom_id": classroom_id,
                "created_at": now,
                "used_at": now,
                "changed_at": now,
            }
            insert(db, "groups", group)
            return str(group["id"])

        return self.get(self._database.write(write))

    def change(
        self, group_id: str, changes: Mapping[str, str | None], *, by_teacher: bool = False
    ) -> GroupRow:
        """Changes some of `name`, `color`, `picture` and `classroom_id`.

        Args:
            by_teacher: raises the revision, so that in merges the change wins over pupils' changes on other PCs.

        Raises:
            StoreError: `group_not_found` and what `create` raises; `color_unknown`.
        """
        requested = dict(changes)
        if "name" in requested:
            name = clean_name(str(requested["name"]))
            requested |= {"name": name, "name_key": name_key(name)}
        if "color" in requested and requested["color"] not in COLORS:
            raise StoreError("color_unknown", value=requested["color"], allowed=list(COLORS))
        _require_picture(str(requested.get("picture", "")))
        now = self._database.now()
        self._database.write(lambda db: _change(db, group_id, requested, now, by_teacher))
        return self.get(group_id)


def _group_row(row: sqlite3.Row) -> GroupRow:
    """Returns the row of a group, with grey for a damaged colour and "" for a damaged picture."""
    found = GroupRow(**dict(row))
    return replace(
        found,
        color=found.color if _COLOR.fullmatch(str(found.color)) else GREY,
        picture=found.picture if found.picture in PICTURES else "",
        has_album=found.has_album != 0,  # NULL without a preset
    )


def record_use(db: sqlite3.Connection, group_id: str, now: str) -> None:
    """Records that the group was used, within the transaction of its work."""
    db.execute("UPDATE groups SET used_at = ? WHERE id = ?", [now, group_id])


def _change(
    db: sqlite3.Connection,
    group_id: str,
    requested: Mapping[str, str | None],
    now: str,
    by_teacher: bool,
) -> None:
    group = db.execute("SELECT * FROM groups WHERE id = ?", [group_id]).fetchone()
    if group is None:
        raise not_found("groups", group_id)
    changes = {name: value for name, value in requested.items() if value != group[name]}
    if not changes:
        return
    classroom_id = changes.get("classroom_id", group["classroom_id"])
    if classroom_id is not None:
        require(db, "classrooms", classroom_id)
    if changes.keys() & {"name", "classroom_id"}:
        _require_free(db, changes.get("name") or group["name"], classroom_id, group_id)
    if "classroom_id" in changes and group["classroom_id"]:
        _note_former_class(db, group_id, group["classroom_id"])
    update_row(db, "groups", group_id, changes, now, n_revisions=int(by_teacher))


def _note_former_class(db: sqlite3.Connection, group_id: str, classroom_id: str) -> None:
    """Records the class that a group leaves, because another PC may delete that class meanwhile with the group."""
    values = [group_id, classroom_id]
    db.execute("INSERT OR IGNORE INTO former_classes VALUES (?, ?, 0)", values)


def _require_free(db: sqlite3.Connection, name: str, classroom_id: str | None, own_id: str) -> None:
    existing = db.execute(
        "SELECT name FROM groups WHERE name_key = ? AND classroom_id IS ? AND id != ?",
        [name_key(name), classroom_id, own_id],
    ).fetchone()
    if existing:
        raise StoreError("group_exists", name=existing["name"])


def _require_picture(picture: str) -> None:
    if picture and picture not in PICTURES:
        raise StoreError("picture_unknown", value=picture, allowed=list(PICTURES))


def _rarest(
    db: sqlite3.Connection, column: str, choice: tuple[str, ...], classroom_id: str | None
) -> str:
    """Returns the first value that fewest groups of the class have."""
    rows = db.execute(f"SELECT {column} FROM groups WHERE classroom_id IS ?", [classroom_id])
    used = [row[0] for row in rows]
    return min(choice, key=used.count)
