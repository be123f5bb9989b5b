"""Writing bundles: one file that SQLite opens, with all of a store or what one class, group or program needs.

The tables are those of a store, so that it opens in Datasette with the same views, and one more, `bundle`, which
tells where it is from and by its checksum that it is whole (docs/bundles.md).
"""

import logging
import os
import sqlite3
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from storage.bundle_rules import odd_rows
from storage.connection import Access
from storage.content import CONTENT, Content, columns, content_hash
from storage.errors import StoreError, translated
from storage.limits import MAX_REVISION
from storage.schema import migrate
from storage.text import dumped, new_id

_log = logging.getLogger(__name__)

FORMAT = 1
SUFFIX = ".pinel"
BUNDLE_TABLE = """CREATE TABLE bundle (
    format INTEGER NOT NULL,
    app_version TEXT NOT NULL,
    exported_at TEXT NOT NULL,
    computer_id TEXT NOT NULL,
    computer_name TEXT NOT NULL,
    content_hash TEXT NOT NULL,
    counts TEXT NOT NULL,
    anonymous INTEGER NOT NULL
) STRICT"""
Alteration = Callable[[sqlite3.Connection], None]

# What of a table belongs to what was copied before it. Lessons, classes and PCs come last: of them goes what is named.
_BELONGING = {
    "tombstones": "0",
    "groups": "0",
    "programs": "group_id IN (SELECT id FROM main.groups)",
    "versions": "program_id IN (SELECT id FROM main.programs)",
    "version_labels": "id IN (SELECT id FROM main.versions)",
    "runs": """(program_id IN (SELECT id FROM main.programs)
        OR program_id IS NULL AND group_id IN (SELECT id FROM main.groups))""",
    "events": "run_id IN (SELECT id FROM main.runs)",
    "telemetry": "run_id IN (SELECT id FROM main.runs)",
    "notes": "run_id IN (SELECT id FROM main.runs)",
    "lessons": "id IN (SELECT lesson_id FROM main.runs UNION SELECT lesson_id FROM main.versions)",
    "classrooms": "id IN (SELECT classroom_id FROM main.groups UNION SELECT classroom_id FROM main.lessons)",
    "computers": """id IN (SELECT computer_id FROM main.versions UNION SELECT computer_id FROM main.runs
        UNION SELECT computer_id FROM main.lessons)""",
}
_JOINED = "id IN (SELECT part_of FROM store.lessons WHERE id IN (SELECT id FROM main.lessons))"


@dataclass(frozen=True, slots=True)
class BundleInfo:
    """What a bundle says of itself.

    Attributes:
        content_hash: `content.content_hash` of what it holds, as the release that wrote it counts it.
        counts: rows by table.
        anonymous: names and texts were left out.
        left_out: of one just written, `table.column key` of rows that other PCs would refuse.
    """

    path: Path
    app_version: str
    exported_at: str
    computer_id: str
    computer_name: str
    content_hash: str
    counts: dict[str, int]
    anonymous: bool
    left_out: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Scope:
    """What goes into a bundle: all, or one class, group or program with what it belongs to."""

    classroom_id: str | None = None
    group_id: str | None = None
    program_id: str | None = None

    @property
    def whole(self) -> bool:
        """All of the store."""
        return not (self.classroom_id or self.group_id or self.program_id)

    def condition(self, table: str) -> str:
        """Which rows of a table of the schema `store` go, with places for `values`."""
        if self.whole:
            return "1"
        return self._own().get(table, _BELONGING[table])

    def values(self) -> dict[str, str | None]:
        """Values of the places in conditions."""
        return {
            "classroom": self.classroom_id,
            "group": self.group_id,
            "program": self.program_id,
        }

    def require(self, db: sqlite3.Connection) -> None:
        """Raises StoreError `classroom_not_found`, `group_not_found` or `program_not_found`."""
        for kind, key in self.values().items():
            if key and not db.execute(f"SELECT 1 FROM {kind}s WHERE id = ?", [key]).fetchone():
                raise StoreError(f"{kind}_not_found", id=key)

    def _own(self) -> dict[str, str]:
        if self.program_id:
            return {
                "groups": "id IN (SELECT group_id FROM store.programs WHERE id = :program)",
                "programs": "id = :program",
            }
        if self.group_id:
            return {"groups": "id = :group"}
        return {
            "tombstones": "1",
            "groups": "classroom_id = :classroom",
            "lessons": f"(classroom_id = :classroom OR {_BELONGING['lessons']})",
            "classrooms": f"(id = :classroom OR {_BELONGING['classrooms']})",
        }


ALL = Scope()


def export_bundle(
    access: Access,
    dest: Path,
    *,
    app_version: str,
    computer: tuple[str, str],
    scope: Scope = ALL,
    alter: Alteration | None = None,
    is_noted: bool = True,
) -> BundleInfo:
    """Writes what is on disk at this moment and has ended; a file is there only when it is whole.

    Args:
        dest: the file; where there is one already, the new one gets a number.
        computer: key and name of this PC.
        alter: changes the copy before it is finished; the bundle then counts as anonymous.
        is_noted: whether `exports` says where the file is; not for one that is handed on at once.

    Raises:
        StoreError: `classroom_not_found`, `group_not_found`, `program_not_found`; `export_failed` or `disk_full`
            where nothing could be written.
    """
    with access.reading() as db:
        scope.require(db)
    with _free_name(dest) as final:
        part = final.with_name(f".{final.name}.part")
        try:
            info = _written(access, part, final, app_version, computer, scope, alter)
            _synced(part)
            os.replace(part, final)
        except sqlite3.Error as error:
            raise _not_written(translated(error, part), dest) from error
        finally:
            part.unlink(missing_ok=True)
        _synced_folder(final.parent)
    if is_noted:
        note_export(access, info, scope)
    return info


def note_export(access: Access, info: BundleInfo, scope: Scope) -> None:
    """Remembers where the file is, as far as the store can be written: what is deleted later may be in it."""
    if access.can_write:
        access.write(lambda db: _note(db, info, scope))


def _written(
    access: Access,
    part: Path,
    final: Path,
    app_version: str,
    computer: tuple[str, str],
    scope: Scope,
    alter: Alteration | None,
) -> BundleInfo:
    part.unlink(missing_ok=True)
    with closing(_new_database(part)) as db:
        migrate(db)
        db.execute(BUNDLE_TABLE)
        db.execute("ATTACH DATABASE ? AS store", [access.address])
        db.execute("BEGIN")
        _copy(db, scope)
        db.execute("COMMIT")
        db.execute("DETACH DATABASE store")
        if alter is not None:
            alter(db)
        left_out = _leave_out(db)
        info = BundleInfo(
            final,
            app_version,
            access.now(),
            *computer,
            content_hash(db),
            counts_of(db),
            alter is not None,
            left_out,
        )
        db.execute("INSERT INTO bundle VALUES (?, ?, ?, ?, ?, ?, ?, ?)", _row(info))
        db.execute("PRAGMA journal_mode = DELETE")
    return info


def _new_database(path: Path) -> sqlite3.Connection:
    """Without journal: it is written once, and again from the start where that fails."""
    db = sqlite3.connect(f"{path.absolute().as_uri()}?mode=rwc", uri=True, isolation_level=None)
    db.execute("PRAGMA journal_mode = OFF")
    db.execute("PRAGMA synchronous = OFF")
    return db


def _copy(db: sqlite3.Connection, scope: Scope) -> None:
    for content in sorted(CONTENT, key=lambda content: list(_BELONGING).index(content.table)):
        _copy_table(db, content, scope.condition(content.table), scope.values())
        if content.table == "lessons" and not scope.whole:
            _copy_table(db, content, _JOINED, {})


def _copy_table(
    db: sqlite3.Connection, content: Content, condition: str, values: dict[str, str | None]
) -> None:
    names = ", ".join(columns(db, content.table))
    ended = content.condition.format(schema="store")
    db.execute(
        f"INSERT OR IGNORE INTO main.{content.table} ({names}) SELECT {names} FROM store.{content.table}"
        f" WHERE {ended} AND {condition} ORDER BY {', '.join(content.key)}",
        values,
    )
    if "revision" in columns(db, content.table):
        db.execute(f"UPDATE main.{content.table} SET revision = min(revision, {MAX_REVISION})")


def _leave_out(db: sqlite3.Connection) -> tuple[str, ...]:
    """Takes rows away that would have the whole bundle refused, with what belongs to them, and says which."""
    found: list[str] = []
    for content in CONTENT:
        condition = " AND ".join(f"{column} = ?" for column in content.key)
        for key, place in list(odd_rows(db, content)):
            db.execute(f"DELETE FROM {content.table} WHERE {condition}", key)
            found.append(f"{place} {' '.join(map(str, key))}")
    while found and (orphans := db.execute("PRAGMA foreign_key_check").fetchall()):
        for table, rowid, *_ in orphans:
            db.execute(f"DELETE FROM {table} WHERE rowid = ?", [rowid])
    for row in found:
        _log.warning("left out of the bundle, as other PCs would refuse it: %s", row)
    return tuple(found)


def counts_of(db: sqlite3.Connection) -> dict[str, int]:
    """Rows by table of content."""
    tables = (content.table for content in CONTENT if columns(db, content.table))
    return {
        table: int(db.execute(f"SELECT count(*) FROM {table}").fetchone()[0]) for table in tables
    }


def _row(info: BundleInfo) -> tuple[object, ...]:
    computer = (info.computer_id, info.computer_name)
    counts = dumped(info.counts)
    return (
        FORMAT,
        info.app_version,
        info.exported_at,
        *computer,
        info.content_hash,
        counts,
        int(info.anonymous),
    )


def _note(db: sqlite3.Connection, info: BundleInfo, scope: Scope) -> None:
    content = dumped(
        {"checksum": info.content_hash, "of": scope.values(), "runs": info.counts["runs"]}
    )
    db.execute(
        "INSERT INTO exports (id, path, made_at, content) VALUES (?, ?, ?, ?)",
        [new_id(), str(info.path.absolute()), info.exported_at, content],
    )


@contextmanager
def _free_name(dest: Path) -> Iterator[Path]:
    """A name that no file has: taken at once, given back where nothing is written."""
    path, n = dest, 1
    try:
        while True:
            try:
                path.open("xb").close()
                break
            except FileExistsError:
                n += 1
                path = dest.with_name(f"{dest.stem}-{n}{dest.suffix}")
        try:
            yield path
        except BaseException:
            with suppress(OSError):
                path.unlink()
            raise
    except OSError as error:
        raise StoreError("export_failed", path=str(dest), problem=error.strerror) from error


def _synced(path: Path) -> None:
    with path.open("rb+") as file:
        os.fsync(file.fileno())


def _synced_folder(folder: Path) -> None:
    """The name is on the stick too; systems and file systems that cannot do it do so by themselves."""
    with suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def _not_written(error: StoreError, dest: Path) -> StoreError:
    if error.code == "disk_full":
        return StoreError("disk_full", path=str(dest))
    return StoreError(
        "export_failed", path=str(dest), problem=str(error.params.get("problem", error.code))
    )
