"""docs/district.md: its commands and queries, as they stand there, on the work of two small schools."""

import re
import shlex
from contextlib import closing
from pathlib import Path

import duckdb
import pytest

from storage.sqlite import sqlite3
from tests.commands.typed import PROGRAMS, pinel

PAGE = (Path(__file__).parents[1] / "docs" / "district.md").read_text("utf-8")
COMMANDS = re.findall(r"^(pinel .*)$", "\n".join(re.findall(r"```sh\n(.*?)```", PAGE, re.S)), re.M)
QUERIES = re.findall(r"```sql\n(.*?)```", PAGE, re.S)


@pytest.fixture
def district(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder in which the page's commands were given, with bundles of two schools, one of which changed a run."""
    monkeypatch.setenv("PINEL_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("PINEL_LANG", "en")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bundles").mkdir()
    for name, program in (("a", "square"), ("b", "triangle")):
        database = tmp_path / f"{name}.db"
        for preset in ("ideal", "realistic"):
            file = str(PROGRAMS / f"{program}.json")
            assert pinel("--db", str(database), "run", file, "--preset", preset).exit_code == 0
        if name == "b":
            change_a_run(database)
        pinel("--db", str(database), "export", str(tmp_path / "bundles" / f"{name}.pinel"))
        (tmp_path / f"{program}.json").write_bytes((PROGRAMS / f"{program}.json").read_bytes())
    for line in COMMANDS:
        give(line, tmp_path)
    return tmp_path


def change_a_run(database: Path) -> None:
    """Makes a run look shorter than it was, as somebody with an SQLite editor would."""
    with closing(sqlite3.connect(database)) as db, db:
        db.execute("UPDATE runs SET path_length_m = 1 WHERE id = (SELECT max(id) FROM runs)")


def give(line: str, folder: Path) -> None:
    """Gives a command of the page: on this PC instead of a cluster, and with few seeds."""
    line, _, out = line.partition(" > ")
    line = re.sub(r"--dask \S+", "--workers 1", line).replace("--seeds 1000", "--seeds 4")
    arguments = [
        part
        for word in shlex.split(line)[1:]
        for part in ([str(file) for file in sorted(folder.glob(word))] if "*" in word else [word])
    ]
    result = pinel(*arguments)
    assert result.exit_code in (0, 1), result.output
    if out:
        (folder / out).write_text(result.stdout, "utf-8")


def test_each_query_of_the_page_answers(district: Path) -> None:
    with duckdb.connect() as db:
        counts, passes, strange, firm, track = (db.execute(query).fetchall() for query in QUERIES)
    assert dict(counts) == {"identical": 3, "altered": 1}
    assert sum(runs for _, _, runs, _ in passes) == 3
    assert [outcome for *_, outcome in strange] == ["altered"]
    assert [(program, runs, success) for program, _, runs, success, *_ in firm] == [
        ("square.json", 4, 100.0),
        ("triangle.json", 4, 100.0),
    ]
    assert sum(runs for _, runs, _ in track) == 8
