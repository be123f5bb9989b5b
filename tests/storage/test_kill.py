"""The power is cut: what was acknowledged is there, and the file is whole."""

import json
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest

from storage import open_store

N_KILLS = 10
BUSY_GROUP = Path(__file__).with_name("busy_group.py")


def acknowledged_before_kill(path: Path, n_lines: int) -> list[dict[str, str]]:
    """Starts a busy group, kills it after it has said `n_lines` things, and gives what it said."""
    with subprocess.Popen(
        [sys.executable, str(BUSY_GROUP), str(path)], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        lines = [process.stdout.readline() for _ in range(n_lines)]
        process.kill()
        lines += process.stdout.readlines()
    return [json.loads(line) for line in lines if line.endswith("}\n")]


@pytest.mark.skipif(sys.platform == "win32", reason="kill -9")
def test_nothing_acknowledged_is_lost_in_ten_kills(path: Path) -> None:
    said: list[dict[str, str]] = []
    for n in range(N_KILLS):
        said += acknowledged_before_kill(path, n_lines=3 + 7 * n)
    with open_store(path, close_interrupted=True) as store:
        assert store.notice is None
        for line in said:
            if line["kept"] == "version":
                assert store.versions.get(line["id"]).workspace == {"text": line["text"]}
            else:
                state = store.runs.get(line["id"]).state
                assert state == ("finished" if line["kept"] == "end of run" else state)
                assert state in ("finished", "failed")
    with sqlite3.connect(path) as db:
        assert db.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
        assert db.execute("PRAGMA foreign_key_check").fetchall() == []
    db.close()
    kinds = {line["kept"] for line in said}
    assert kinds == {"version", "run", "end of run"}
