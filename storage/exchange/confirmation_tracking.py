"""Tracks the runs of a bundle whose pass does not count until this PC has re-verified them.

Anybody can make a bundle. So each pass that comes with one gets an entry in `unconfirmed_runs`, whoever wrote the
bundle. The entry is deleted when this PC has repeated the run with the same record and a pass
(`pinel_desktop/school/confirming.py`). A run whose re-verification failed may be replaced by the bundle's record.

In the SQL `main` is the store and `bundle` the bundle. A row of the store is `ours`, a row of the bundle `theirs`.
"""

from collections.abc import Iterator
from contextlib import contextmanager

from storage.exchange.joins import may_merge, rows_in_both
from storage.file.row_checksums import OF_RUNS, content_checksum, copy_rows
from storage.sql import row_count
from storage.sqlite import sqlite3
from storage.tables.runs import RUNS
from storage.text import to_json

_UNCONFIRMED = "main.unconfirmed_runs"
# condition: the run counts as passed, or is still to be judged by its record; only such runs need an entry
_COUNTS = "activity IS NOT NULL AND (passed = 1 OR passed IS NULL AND check_report IS NULL)"
_IS_CUT_OFF = "ours.state = 'running' OR ours.reason IS 'interrupted'"
_IS_TO_BE_JUDGED = f"ours.passed IS NULL AND ours.check_report IS NULL AND NOT ({_IS_CUT_OFF})"
# condition: the run `ours` counts here as passed, or is still to be judged; no bundle changes it
COUNTS_HERE = f"""(ours.activity IS NOT NULL AND (ours.passed IS 1 OR {_IS_TO_BE_JUDGED})
    AND ours.id NOT IN (SELECT run_id FROM {_UNCONFIRMED}))"""
_REFUTED = f"""SELECT ours.id {rows_in_both(RUNS)} JOIN {_UNCONFIRMED} AS mark ON mark.run_id = ours.id
    WHERE mark.finding IS NOT NULL AND theirs.passed = 1 AND theirs.state <> 'running'"""


@contextmanager
def tracking_unconfirmed(
    db: sqlite3.Connection, now: str, *, replaces_refuted: bool = True
) -> Iterator[None]:
    """Records in `unconfirmed_runs` the runs that a merge within this context adds or changes, if they count.

    Args:
        replaces_refuted: if re-verification refuted a run on this PC, replaces it by the bundle's run, which is then
            re-verified. The forged record may have arrived before the record of the PC that ran the program.
    """
    shared = f"SELECT * FROM main.runs WHERE id IN (SELECT id FROM bundle.runs) AND {_COUNTS}"
    db.execute(f"CREATE TEMP TABLE before AS {shared}")
    refuted = [str(row[0]) for row in db.execute(_REFUTED)] if replaces_refuted else []
    others = [run_id for run_id in refuted if _differs(db, run_id)]
    yield
    for run_id in others:
        _replace(db, run_id)
    db.execute(
        f"""INSERT OR REPLACE INTO {_UNCONFIRMED} (run_id, marked_at)
            SELECT id, ? FROM ({shared} EXCEPT SELECT * FROM temp.before)
            UNION SELECT value, ? FROM json_each(?)""",
        [now, now, to_json(others)],
    )
    db.execute("DROP TABLE temp.before")


def n_unconfirmed(db: sqlite3.Connection) -> int:
    """Returns how many runs of the bundle have an entry in `unconfirmed_runs`."""
    return row_count(db, _UNCONFIRMED, "run_id IN (SELECT id FROM bundle.runs)")


def _differs(db: sqlite3.Connection, run_id: str) -> bool:
    return any(
        content_checksum(db, table, run_id) != content_checksum(db, table, run_id, "bundle")
        for table in OF_RUNS
    )


def _replace(db: sqlite3.Connection, run_id: str) -> None:
    """Replaces a run by the bundle's, unless its group or version was deleted here."""
    which = f"SELECT 1 FROM bundle.runs AS theirs WHERE id = ? AND {may_merge(RUNS)}"
    if db.execute(which, [run_id]).fetchone():
        for table in OF_RUNS:
            copy_rows(db, table, run_id, "bundle")
