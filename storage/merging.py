"""Bringing a bundle into a store: the union of both by key, of two states of one row the greater.

As the union does not ask who was first, bundles give the same store in any order, and a bundle that was merged
before changes nothing. A key in `tombstones` stays deleted, with all that belongs to it; but nothing that is here goes
because a file says so, unless a person says so too. Each bundle is one transaction: of one that is cut off nothing is
there, and it can be merged again.
"""

import sqlite3
from dataclasses import dataclass
from pathlib import Path

from storage.bundle_reading import open_bundle
from storage.bundles import BundleInfo
from storage.connection import Access
from storage.content import (
    CLASSROOMS,
    COMPUTERS,
    EVENTS,
    GROUPS,
    LABELS,
    LESSONS,
    NOTES,
    PROGRAMS,
    RUNS,
    TELEMETRY,
    VERSIONS,
    Content,
    columns,
)
from storage.errors import StoreError
from storage.removal import Doomed, Exported, Gone, bury_below, doomed, remove_keys, tombstones
from storage.text import dumped, new_id

_FIRST = ("revision", "changed_at")
# what decides before all else: a run that was cut off, as in a backup that came back, is less than one that has ended
_RULES = {"runs": ("{side}.reason IS NOT 'interrupted'", "coalesce({side}.duration_s, 0)")}
_DEAD = "(SELECT id FROM main.tombstones)"
_BEFORE_VERSIONS = (COMPUTERS, CLASSROOMS, GROUPS, LESSONS, PROGRAMS)
_SKIPPED = (*_BEFORE_VERSIONS, VERSIONS, LABELS, RUNS, NOTES)
# what can be deleted by a key of its own
_HERE = " UNION ALL ".join(
    f"SELECT id FROM main.{content.table}"
    for content in (CLASSROOMS, GROUPS, LESSONS, PROGRAMS, VERSIONS, LABELS, RUNS, NOTES)
)


@dataclass(frozen=True, slots=True)
class MergeReport:
    """What a bundle brought; each by table, without those of which there were none.

    Attributes:
        added: rows that were not there.
        changed: rows of which the bundle had a later state.
        skipped: rows that were not brought in, as they or what they belong to was deleted here.
        removed: rows that went, as they were deleted where the bundle is from.
        would_delete: what stays, though it was deleted there, until the bundle is merged with `delete`.
        buried: keys of what was deleted; backups are to lose the same.
        exports: files that were written from this store and may still hold it.
        still_in: backups that could not be written anew, and may hold it.
    """

    info: BundleInfo
    added: dict[str, int]
    changed: dict[str, int]
    skipped: dict[str, int]
    removed: dict[str, int]
    would_delete: Doomed | None = None
    buried: tuple[str, ...] = ()
    exports: tuple[Exported, ...] = ()
    still_in: tuple[Path, ...] = ()

    @property
    def left_in(self) -> list[str]:
        """Files that people have to delete by hand, as they may hold what was deleted."""
        return [one.path for one in self.exports] + [str(path) for path in self.still_in]

    @property
    def nothing_new(self) -> bool:
        """All of it was known, or was deleted here."""
        return not (self.added or self.changed or self.removed or self.would_delete)


@dataclass(frozen=True, slots=True)
class Heard:
    """A PC whose bundles were merged into the store; `n_runs` are its runs in the store."""

    computer_id: str
    name: str
    exported_at: str
    merged_at: str
    n_runs: int


def merge(access: Access, path: Path, *, delete: bool = False) -> MergeReport:
    """Brings a bundle in; on disk when this returns.

    Args:
        delete: also deletes here what was deleted for good where the bundle is from; not from the log nor from
            backups, which `Exchange.merge` does.

    Raises:
        StoreError: the bundle is refused (see `open_bundle`), it deletes a run that goes on here (`run_in_progress`)
            or the store cannot be written; nothing has changed.
    """
    with open_bundle(path) as bundle:
        return access.write(
            lambda db: merge_attached(db, bundle.info, access.now(), delete=delete),
            attached=bundle.address,
        )


def merge_attached(
    db: sqlite3.Connection, info: BundleInfo, now: str, *, delete: bool
) -> MergeReport:
    """The same with the bundle attached as the schema `bundle`, within the caller's transaction."""
    merging = _Merging(db, delete=delete)
    if _known(db, info):
        would_delete = merging.would_delete()
        if not (would_delete and delete):
            _note(db, info, now, {})
            merging.count_skipped()
            return MergeReport(info, {}, {}, _some(merging.skipped), {}, would_delete)
    db.execute("PRAGMA defer_foreign_keys = ON")
    before = tombstones(db) if delete else set()
    merging.tombstones()
    for content in _BEFORE_VERSIONS:
        merging.bury(content)
        merging.rows(content)
    gone = _removed(db) if delete else Gone({}, ())
    for content in (VERSIONS, LABELS):
        merging.rows(content)
    merging.runs()
    merging.rows(NOTES)
    _note(db, info, now, merging.added)
    return MergeReport(
        info,
        _some(merging.added),
        _some(merging.changed),
        _some(merging.skipped),
        gone.counts,
        None if delete else merging.would_delete(),
        tuple(sorted(tombstones(db) - before)) if gone.counts else (),
        gone.exports,
    )


def _removed(db: sqlite3.Connection) -> Gone:
    """Deletes what is dead now. Raises StoreError `run_in_progress`."""
    running = _running(db)
    gone = remove_keys(db, ())
    if _running(db) != running:  # it is being recorded, and its group sits before it
        raise StoreError("run_in_progress")
    return gone


def heard_from(access: Access) -> list[Heard]:
    """Every PC that bundles were from, the one heard of last first."""
    with access.reading() as db:
        rows = db.execute(
            """SELECT merges.computer_id, coalesce(computers.name, merges.computer_name) AS name,
                      max(merges.exported_at) AS exported_at, max(merges.merged_at) AS merged_at,
                      (SELECT count(*) FROM runs WHERE runs.computer_id = merges.computer_id) AS n_runs
               FROM merges LEFT JOIN computers ON computers.id = merges.computer_id
               GROUP BY merges.computer_id ORDER BY max(merges.merged_at) DESC, merges.computer_id"""
        ).fetchall()
    return [Heard(**dict(row)) for row in rows]


class _Merging:
    """One bundle on its way in, table by table; counts what becomes of its rows."""

    def __init__(self, db: sqlite3.Connection, *, delete: bool) -> None:
        self.added: dict[str, int] = {}
        self.changed: dict[str, int] = {}
        self.skipped: dict[str, int] = {}
        self._db = db
        self._delete = delete

    def tombstones(self) -> None:
        """Of what is here only when it is to be deleted."""
        kept = "" if self._delete else f" WHERE id NOT IN ({_HERE})"
        self.added["tombstones"] = self._do(
            f"INSERT OR IGNORE INTO main.tombstones SELECT id FROM bundle.tombstones{kept}"
        )

    def bury(self, content: Content) -> None:
        """What is, in its later state, part of something deleted is deleted by a key of its own."""
        of_ours = f" OR {self._is_later(content)}" if self._delete else ""
        for column, _ in content.parents:
            self._do(
                f"INSERT OR IGNORE INTO main.tombstones SELECT theirs.id {_both(content, 'LEFT')}"
                f" WHERE theirs.{column} IN {_DEAD} AND (ours.id IS NULL{of_ours})"
            )

    def would_delete(self) -> Doomed | None:
        """What goes from here when the bundle is merged with `delete`, after all else of it is in."""
        self._do("SAVEPOINT trial")
        try:
            self._do(
                "INSERT OR IGNORE INTO main.tombstones"
                f" SELECT id FROM bundle.tombstones WHERE id IN ({_HERE})"
            )
            trial = _Merging(self._db, delete=True)
            for content in _BEFORE_VERSIONS:
                trial.bury(content)
            bury_below(self._db)
            return doomed(self._db)
        finally:
            self._do("ROLLBACK TO trial")
            self._do("RELEASE trial")

    def rows(self, content: Content) -> None:
        """Adds what is not here and may be, and brings the rest to its later state."""
        names = columns(self._db, content.table)
        self._count_skipped(content)
        self.added[content.table] = self._do(
            f"INSERT INTO main.{content.table} ({', '.join(names)})"
            f" SELECT {of('theirs', names)} FROM bundle.{content.table} AS theirs"
            f" WHERE {may_come(content)} AND {is_new(content)} ORDER BY {of('theirs', content.key)}"
        )
        self.changed[content.table] = self._bring_forward(content, may_come(content))

    def runs(self) -> None:
        """Runs with their events and samples: those of the later state, of equal states all."""
        later, equal = self._is_later(RUNS), self._is_equal(RUNS)
        self._do(f"CREATE TEMP TABLE replaced AS SELECT ours.id {_both(RUNS)} WHERE {later}")
        self._do(f"CREATE TEMP TABLE shared AS SELECT ours.id {_both(RUNS)} WHERE {equal}")
        self._do(
            f"""CREATE TEMP TABLE coming AS
                SELECT theirs.id {_both(RUNS, "LEFT")}
                WHERE {may_come(RUNS)} AND (ours.id IS NULL OR {later} OR {equal})"""
        )
        for content in (EVENTS, TELEMETRY):
            self._do(f"DELETE FROM main.{content.table} WHERE run_id IN temp.replaced")
        self.rows(RUNS)
        for content in (EVENTS, TELEMETRY):
            self._parts(content)
        for table in ("replaced", "shared", "coming"):
            self._do(f"DROP TABLE temp.{table}")

    def _parts(self, content: Content) -> None:
        names = columns(self._db, content.table)
        self._do(
            f"INSERT OR IGNORE INTO main.{content.table} ({', '.join(names)})"
            f" SELECT {of('theirs', names)} FROM bundle.{content.table} AS theirs"
            f" WHERE run_id IN temp.coming ORDER BY {of('theirs', content.key)}"
        )
        self._bring_forward(content, "theirs.run_id IN temp.shared")

    def _bring_forward(self, content: Content, condition: str) -> int:
        names = columns(self._db, content.table)
        later = f"SELECT {of('theirs', content.key)} {_both(content)} WHERE {self._is_later(content)} AND {condition}"
        same_key = " AND ".join(f"theirs.{name} = {content.table}.{name}" for name in content.key)
        return self._do(
            f"UPDATE main.{content.table} SET ({', '.join(names)}) ="
            f" (SELECT {of('theirs', names)} FROM bundle.{content.table} AS theirs WHERE {same_key})"
            f" WHERE ({', '.join(content.key)}) IN ({later})"
        )

    def count_skipped(self) -> None:
        """What stays out, of a bundle of which nothing comes."""
        for content in _SKIPPED:
            self._count_skipped(content)

    def _count_skipped(self, content: Content) -> None:
        query = (
            f"SELECT count(*) FROM bundle.{content.table} AS theirs WHERE NOT ({may_come(content)})"
        )
        self.skipped[content.table] = int(self._db.execute(query).fetchone()[0])

    def _is_later(self, content: Content) -> str:
        is_later = self._compared(content, ">")
        return f"(ours.state = 'running' OR {is_later})" if content is RUNS else is_later

    def _is_equal(self, content: Content) -> str:
        return self._compared(content, "=")

    def _compared(self, content: Content, sign: str) -> str:
        """Of two states the one with the greater revision, then time, then values is the later one."""
        names = columns(self._db, content.table)
        rest = [name for name in names if name not in (*_FIRST, *content.key)]
        order = [name for name in _FIRST if name in names] + rest
        # not coalesce alone: what stands in for NULL must not be greater than any number ("not judged" and "passed")
        theirs, ours = (
            ", ".join(
                [
                    *(rule.format(side=side) for rule in _RULES.get(content.table, ())),
                    *(f"{side}.{name} IS NOT NULL, coalesce({side}.{name}, 0)" for name in order),
                ]
            )
            for side in ("theirs", "ours")
        )
        return f"(({theirs}) {sign} ({ours}))"

    def _do(self, statement: str) -> int:
        return self._db.execute(statement).rowcount


def _both(content: Content, kind: str = "") -> str:
    same_key = " AND ".join(f"ours.{name} = theirs.{name}" for name in content.key)
    return f"FROM bundle.{content.table} AS theirs {kind} JOIN main.{content.table} AS ours ON {same_key}"


def is_new(content: Content) -> str:
    """Condition: its key is not in the store."""
    same_key = " AND ".join(f"ours.{name} = theirs.{name}" for name in content.key)
    return f"NOT EXISTS (SELECT 1 FROM main.{content.table} AS ours WHERE {same_key})"


def may_come(content: Content) -> str:
    """Condition: neither it nor what it belongs to is deleted; a bundle holds what its rows belong to."""
    here = [
        f"(theirs.{column} IS NULL OR EXISTS (SELECT 1 FROM main.{table} WHERE id = theirs.{column}))"
        for column, table in content.parents
    ]
    return " AND ".join([f"theirs.id NOT IN {_DEAD}", *here])


def of(side: str, names: tuple[str, ...]) -> str:
    """Columns of `theirs` or `ours`."""
    return ", ".join(f"{side}.{name}" for name in names)


def _running(db: sqlite3.Connection) -> int:
    """Runs that have not ended; a merge neither brings nor ends any but those that it has the end of."""
    return int(db.execute("SELECT count(*) FROM main.runs WHERE state = 'running'").fetchone()[0])


def _some(counts: dict[str, int]) -> dict[str, int]:
    return {table: n for table, n in counts.items() if n > 0}


def _known(db: sqlite3.Connection, info: BundleInfo) -> bool:
    """The same content was merged before. What went since was deleted, and would not come back."""
    found = db.execute("SELECT 1 FROM main.merges WHERE checksum = ?", [info.content_hash])
    return found.fetchone() is not None


def _note(db: sqlite3.Connection, info: BundleInfo, now: str, added: dict[str, int]) -> None:
    values = {
        "id": new_id(),
        "computer_id": info.computer_id,
        "computer_name": info.computer_name,
        "file": info.path.name,
        "checksum": info.content_hash,
        "exported_at": info.exported_at,
        "merged_at": now,
        "added": dumped(_some(added)),
    }
    same = "computer_id = :computer_id AND checksum = :checksum AND exported_at = :exported_at"
    if db.execute(f"SELECT 1 FROM main.merges WHERE {same}", values).fetchone() is None:
        marks = ", ".join(f":{name}" for name in values)
        db.execute(f"INSERT INTO main.merges ({', '.join(values)}) VALUES ({marks})", values)
