"""Parquet files of a store, read by DuckDB."""

import builtins
import re
from pathlib import Path
from typing import Any

import duckdb
import pytest

from storage import RunRecorder, RunStart, Store, StoreError
from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.parquet import FILES
from tests.storage.bundle_makers import a_run, work
from tests.storage.sample_documents import SQUARE, WORLD
from tests.storage.sample_runs import ended

PAGE = Path(__file__).parents[3] / "docs" / "parquet.md"
TYPES = {
    "text": "VARCHAR",
    "count": "BIGINT",
    "number": "DOUBLE",
    "flag": "BOOLEAN",
    "time": "TIMESTAMP WITH TIME ZONE",
}


def written(store: Store, dest: Path, **options: Any) -> BundleInfo:
    return store.exchange.export_parquet(
        dest, app_version="0.1.0", computer=store.computers.this(), **options
    )


def ask(query: str) -> list[tuple[Any, ...]]:
    with duckdb.connect() as db:
        return db.execute(query).fetchall()


@pytest.fixture
def busy(store: Store) -> Store:
    classroom = store.classrooms.create("5º B")
    work(store, store.groups.create("Onças", classroom_id=classroom.id), "Quadrado")
    a_run(store, None)
    return store


def test_duckdb_joins_what_a_district_asks_for(busy: Store, tmp_path: Path) -> None:
    folder = written(busy, tmp_path / "school").path
    found = ask(
        f"""SELECT classrooms.name, groups.name, runs.state, runs.n_samples, runs.n_events
            FROM '{folder}/runs.parquet' AS runs JOIN '{folder}/groups.parquet' AS groups ON groups.id = group_id
            JOIN '{folder}/classrooms.parquet' AS classrooms ON classrooms.id = classroom_id"""
    )
    assert found == [("5º B", "Onças", "finished", 45, 2)]
    assert ask(f"SELECT count(*) FROM '{folder}/versions.parquet'") == [(2,)]
    started = ask(f"SELECT min(year(started_at)) FROM '{folder}/runs.parquet'")
    assert started[0][0] >= 2024


def test_many_schools_are_read_at_once(busy: Store, tmp_path: Path) -> None:
    for name in ("a", "b"):
        written(busy, tmp_path / name)
    assert ask(f"SELECT count(*) FROM read_parquet('{tmp_path}/*/runs.parquet')") == [(4,)]


def test_columns_and_types_are_those_of_the_page(busy: Store, tmp_path: Path) -> None:
    folder = written(busy, tmp_path / "school").path
    assert sorted(file.stem for file in folder.iterdir()) == sorted(FILES)
    for table, columns in FILES.items():
        rows = ask(f"DESCRIBE SELECT * FROM '{folder}/{table}.parquet'")
        assert [row[:2] for row in rows] == [(name, TYPES[kind]) for name, kind, *_ in columns]


def test_the_page_names_every_column() -> None:
    rows = re.findall(r"^\| (?:`(\w+)` )?\| `(\w+)` \| (\w+) \|", PAGE.read_text("utf-8"), re.M)
    table, documented = "", []
    for name, column, kind in rows:
        table = name or table
        documented.append((table, column, kind))
    assert documented == [(table, name, kind) for table in FILES for name, kind, *_ in FILES[table]]


def test_an_estimate_stands_beside_the_true_closing_error(busy: Store, tmp_path: Path) -> None:
    folder = written(busy, tmp_path / "school", anonymous=[]).path
    query = (
        f"SELECT DISTINCT closing_error_m, estimated_closing_error_m FROM '{folder}/runs.parquet'"
    )
    assert ask(query) == [(0.00005, 0.00002)]


def test_a_run_of_an_earlier_release_has_no_estimate_beside_its_own(
    store: Store, tmp_path: Path
) -> None:
    run = store.runs.begin(RunStart("sim", "w", WORLD, 1, "0.1.0", document=SQUARE))
    end = ended(run.id, 0, 0)
    del end["estimated_closing_error_m"]
    RunRecorder(store)(end)
    folder = written(store, tmp_path / "school").path
    query = f"SELECT closing_error_m, estimated_closing_error_m FROM '{folder}/runs.parquet'"
    assert ask(query) == [(0.00005, None)]


def test_a_store_without_anything_has_empty_tables(store: Store, tmp_path: Path) -> None:
    folder = written(store, tmp_path / "school").path
    assert ask(f"SELECT count(*) FROM '{folder}/runs.parquet'") == [(0,)]


def test_a_folder_that_is_there_stays_and_is_remembered(busy: Store, tmp_path: Path) -> None:
    (tmp_path / "school").mkdir()
    folder = written(busy, tmp_path / "school").path
    assert folder.name == "school-2"
    assert sorted(file.name for file in tmp_path.glob("*school*")) == ["school", "school-2"]
    group = busy.groups.all()[0]
    assert busy.exchange.purge("group", group.id).exports[0].path == str(folder)


def test_names_can_be_left_out(busy: Store, tmp_path: Path) -> None:
    folder = written(busy, tmp_path / "school", anonymous=[]).path
    assert ask(f"SELECT name FROM '{folder}/groups.parquet'") == [("Grupo 1",)]


def test_without_the_library_it_says_what_to_install(
    busy: Store, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = builtins.__import__

    def without(name: str, *rest: Any, **more: Any) -> Any:
        if name == "pyarrow":
            raise ImportError(name)
        return real(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(StoreError) as caught:
        written(busy, tmp_path / "school")
    assert caught.value.code == "parquet_missing"
    assert not (tmp_path / "school").exists()
