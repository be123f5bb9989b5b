"""The only SQLite of the program: the wheel pysqlite3, or Python's own if there is no wheel.

A system's SQLite can have the WAL-reset fault (sqlite.org/wal.html, fixed in 3.51.3). With it, a write can be lost when
two connections write or checkpoint at the same moment. sqlite-utils chooses in the same way.

No other module imports SQLite. Two of its libraries in one process undo each other's locks on a file
(sqlite.org/howtocorrupt.html, 2.2.1). Also, code that catches the errors of one does not catch errors of the other.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import sqlite3
else:
    try:
        import pysqlite3 as sqlite3
    except ImportError:  # no wheel for this kind of PC
        import sqlite3

__all__ = ["has_wal_fault", "sqlite3"]

_FIXED_IN = (3, 51, 3)


def has_wal_fault(version: str = sqlite3.sqlite_version) -> bool:
    """Returns whether that version of SQLite can lose a write when the WAL is reset."""
    return tuple(int(part) for part in version.split(".")) < _FIXED_IN
