"""docs/district.md: its commands and queries, as they stand there, on the work of two small schools."""

import re
import shlex
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import duckdb
import pytest

from pinel_desktop.commands import run
from pinel_desktop.runs.record import record_of
from storage import RunStart
from tests.commands.typed import PROGRAMS, pinel

PAGE = (Path(__file__).parents[1] / "docs" / "district.md").read_text("utf-8")
COMMANDS = re.findall(r"^(pinel .*)$", "\n".join(re.findall(r"```sh\n(.*?)```", PAGE, re.S)), re.M)
QUERIES = re.findall(r"```sql\n(.*?)```", PAGE, re.S)


@pytest.fixture
def district(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder in which the page's commands were given, with bundles of two schools, one of which forged a run."""
    monkeypatch.setenv("PINEL_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("PINEL_LANG", "en")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bundles").mkdir()
    for name, program in (("a", "square"), ("b", "triangle")):
        database, file = str(tmp_path / f"{name}.db"), PROGRAMS / f"{program}.json"
        for preset in ("ideal", "realistic"):
            if (name, preset) == ("b", "realistic"):
                monkeypatch.setattr(run, "record_of", forged_record)
            assert pinel("--db", database, "run", str(file), "--preset", preset).exit_code == 0
        pinel("--db", database, "export", str(tmp_path / "bundles" / f"{name}.pinel"))
        shutil.copy(file, tmp_path)
    for line in COMMANDS:
        give(line, tmp_path)
    return tmp_path


def forged_record(*arguments: Any, **options: Any) -> RunStart:
    """The record of a run that claims to be that of another seed."""
    return replace(record_of(*arguments, **options), seed=99)


def give(line: str, folder: Path) -> None:
    """Gives a command of the page: on this PC instead of a cluster, and with few seeds."""
    line, _, out = line.partition(" > ")
    line = re.sub(r"--dask \S+", "--workers 1", line).replace("--seeds 1000", "--seeds 4")
    arguments = [
        part
        for typed in shlex.split(line)[1:]
        for part in (
            [str(file) for file in sorted(folder.glob(typed))] if "*" in typed else [typed]
        )
    ]
    result = pinel(*arguments)
    assert result.exit_code in (0, 1), result.output
    if out:
        (folder / out).write_text(result.stdout, "utf-8")


def test_each_query_of_the_page_answers(district: Path) -> None:
    with duckdb.connect() as db:
        counts, passes, forged, firm, track = (db.execute(query).fetchall() for query in QUERIES)
    assert dict(counts) == {"identical": 3, "different": 1}
    assert sum(runs for _, _, runs, _ in passes) == 3
    assert [outcome for *_, outcome in forged] == ["different"]
    assert [(program, runs, success) for program, _, runs, success, *_ in firm] == [
        ("square.json", 4, 100.0),
        ("triangle.json", 4, 100.0),
    ]
    assert sum(runs for _, runs, _ in track) == 8
