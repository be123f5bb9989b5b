"""Groups of pupils: a name, a colour, a picture and a robot, never the pupils' names."""

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace

from storage.choices import COLORS, GREY, PATTERNS, PICTURES
from storage.errors import StoreError
from storage.file.repository import Repository
from storage.row_types import GroupRow
from storage.sql import insert, not_found, require, selected, setup_value, update_row
from storage.sqlite import sqlite3
from storage.text import clean_name, clean_title, name_key, new_id

_COLOR = re.compile("#[0-9a-f]{6}")
# what may be chosen, and the code of the error otherwise
_CHOICES = {
    "color": ("color_unknown", COLORS),
    "picture": ("picture_unknown", ("", *PICTURES)),
    "robot_pattern": ("pattern_unknown", PATTERNS),
}
_SELECT = selected(
    GroupRow,
    "groups",
    n_programs="SELECT count(*) FROM programs WHERE group_id = groups.id AND deleted_at IS NULL",
    n_in_bin="SELECT count(*) FROM programs WHERE group_id = groups.id AND deleted_at IS NOT NULL",
    n_runs="SELECT count(*) FROM runs WHERE group_id = groups.id",
    has_album=f"""SELECT {setup_value("preset", "album")} IS NOT 0 FROM class_presets
        WHERE class_presets.id = groups.classroom_id""",
)


@dataclass(frozen=True, slots=True)
class Appearance:
    """What a new group chooses; "" leaves the choice to the store, and the robot without a name of its own."""

    color: str = ""
    picture: str = ""
    robot_name: str = ""
    robot_pattern: str = ""


class Groups(Repository):
    """The groups of the file."""

    def all(self) -> list[GroupRow]:
        """Returns all groups, the one used last first."""
        rows = self._rows(f"{_SELECT} ORDER BY used_at DESC, id DESC")
        return [_group_row(row) for row in rows]

    def get(self, group_id: str) -> GroupRow:
        """Returns a group. Raises StoreError `group_not_found`."""
        return _group_row(self._row("groups", f"{_SELECT} WHERE id = ?", group_id))

    def create(
        self,
        name: str,
        *,
        classroom_id: str | None = None,
        appearance: Appearance = Appearance(),
    ) -> GroupRow:
        """Adds a group. Colour, picture and pattern that it does not choose are ones that few groups of the class have.

        Of equally rare ones the name decides, so that groups of several PCs seldom look alike once the
        PCs are merged.

        Raises:
            StoreError: `group_exists` in that class, `classroom_not_found`, `color_unknown`, `picture_unknown`,
                `pattern_unknown`, `name_empty`, `name_too_long`.
        """
        clean, now = clean_name(name), self._database.now()
        chosen = _checked({key: value for key, value in asdict(appearance).items() if value})

        def write(db: sqlite3.Connection) -> str:
            if classroom_id is not None:
                require(db, "classrooms", classroom_id)
            _require_free(db, clean, classroom_id, "")
            group = {
                "id": new_id(),
                "name": clean,
                "name_key": name_key(clean),
                **_free_appearance(db, classroom_id, name_key(clean), chosen),
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
        """Changes some of `name`, `color`, `picture`, `robot_name`, `robot_pattern` and `classroom_id`.

        Args:
            by_teacher: raises the revision, so that in merges the change wins over pupils' changes on other PCs.

        Raises:
            StoreError: `group_not_found` and what `create` raises.
        """
        requested = _checked(changes)
        if "name" in requested:
            name = clean_name(str(requested["name"]))
            requested |= {"name": name, "name_key": name_key(name)}
        now = self._database.now()
        self._database.write(lambda db: _change(db, group_id, requested, now, by_teacher))
        return self.get(group_id)


def _group_row(row: sqlite3.Row) -> GroupRow:
    """Returns the row of a group, with grey for a damaged colour and "" for a damaged picture or pattern."""
    found = GroupRow(**dict(row))
    return replace(
        found,
        color=found.color if _COLOR.fullmatch(str(found.color)) else GREY,
        picture=found.picture if found.picture in PICTURES else "",
        has_album=found.has_album != 0,  # NULL without a preset
        robot_pattern=found.robot_pattern if found.robot_pattern in PATTERNS else "",
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


def _checked(requested: Mapping[str, str | None]) -> dict[str, str | None]:
    """Returns the changes with a clean name of the robot. Raises StoreError for what cannot be chosen."""
    checked = dict(requested)
    for column, (code, choices) in _CHOICES.items():
        if (value := checked.get(column)) is not None and value not in choices:
            raise StoreError(code, value=value, allowed=list(choices))
    if name := checked.get("robot_name"):
        checked["robot_name"] = clean_title(name)
    return checked


def _free_appearance(
    db: sqlite3.Connection, classroom_id: str | None, key: str, chosen: Mapping[str, str | None]
) -> dict[str, str | None]:
    """Returns what the group chose; for the rest, the first values that fewest groups of the class have.

    Each is counted from a place that the key of the name gives. The pattern is rather one that no
    group has in the same colour. The page proposes the same (`ui/src/work/livery/appearance.ts`).
    """
    number = _number_of(key)
    query = "SELECT color, picture, robot_pattern FROM groups WHERE classroom_id IS ?"
    others = [tuple(row) for row in db.execute(query, [classroom_id])]
    colors, pictures, patterns = (Counter(row[place] for row in others) for place in range(3))
    color = chosen.get("color") or min(_rotated(COLORS, number), key=lambda one: colors[one])
    liveries = Counter((row[0], row[2]) for row in others)
    free = {
        "color": color,
        "picture": min(
            _rotated(PICTURES, number // len(COLORS) // len(PATTERNS)),
            key=lambda one: pictures[one],
        ),
        "robot_name": "",
        "robot_pattern": min(
            _rotated(PATTERNS, number // len(COLORS)),
            key=lambda one: (liveries[color, one], patterns[one]),
        ),
    }
    return {**free, **chosen}


def _number_of(key: str) -> int:
    """Returns a number that names rarely share; the page calculates the same."""
    number = 0
    for letter in key:
        number = (31 * number + ord(letter)) % 1_000_003
    return number


def _rotated(choices: tuple[str, ...], begin: int) -> tuple[str, ...]:
    begin %= len(choices)
    return choices[begin:] + choices[:begin]
