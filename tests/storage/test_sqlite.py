"""Which SQLite the store uses."""

import importlib.util
import subprocess
import sys

import pytest
import sqlite_utils

from storage.sqlite import has_wal_fault, sqlite3


@pytest.mark.skipif(not importlib.util.find_spec("pysqlite3"), reason="no wheel for this PC")
def test_the_sqlite_that_ships_cannot_lose_a_write_when_the_wal_begins_anew() -> None:
    assert sqlite3.__name__.startswith("pysqlite3")
    assert not has_wal_fault()


def test_sqlite_utils_uses_the_same_sqlite() -> None:
    """Two libraries in one process would undo each other's locks."""
    assert type(sqlite_utils.Database(memory=True).conn) is sqlite3.Connection


def test_where_there_is_no_wheel_the_sqlite_of_python_is_used() -> None:
    code = "import sys; sys.modules['pysqlite3'] = None; from storage.sqlite import sqlite3; print(sqlite3.__name__)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "sqlite3"
