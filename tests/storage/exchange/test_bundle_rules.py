"""Single values of bundles: what each rule lets in, and what looking at it costs."""

import tracemalloc
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import pytest

from storage import Store, json_check
from storage.json_check import is_object, parsed
from storage.tables.rules import time
from storage.tables.runs import RUNS
from storage.tables.work import GROUPS, VERSIONS
from storage.text import time_text
from tests.storage.bundle_makers import exported, merged, problems_in, work


@pytest.mark.parametrize("year", [2, 1970, 2026, 9998])
def test_times_that_a_clock_may_show_are_let_in(year: int) -> None:
    assert time(time_text(datetime(year, 12, 31, 23, 59, 59, 123456, UTC)))
    assert time(f"{year:04}-01-01T00:00:00Z")


@pytest.mark.parametrize(
    "text",
    [
        "2026-99-99T99:99:99Z",
        "2026-13-01T00:00:00Z",
        "2026-02-30T00:00:00Z",
        "0000-01-01T00:00:00Z",
        "0001-01-01T00:00:00Z",
        "9999-12-31T23:59:59Z",
        "٢٠٢٦-٠١-٠١T٠٠:٠٠:٠٠Z",
        "2026-01-01T00:00:00Z\n",
        "2026-01-01T00:00:00+03:00",
        "2026-01-01",
    ],
)
def test_times_that_no_clock_shows_are_not(text: str) -> None:
    assert not time(text)


@pytest.mark.parametrize(
    ("text", "allowed"),
    [
        ("0199e4a0-0000-7fff-bfff-ffffffffffff", True),
        ("04979793-83ff-7fff-bfff-ffffffffffff", True),
        ("04979793-8400-7000-8000-000000000000", False),  # no clock is at 2130
        ("f6ffffff-ffff-5fff-bfff-ffffffffffff", True),  # made of a name, without a time
    ],
)
def test_keys_leave_room_for_those_that_come_after(text: str, allowed: bool) -> None:
    assert GROUPS.rules["id"](text) is allowed


def test_what_is_changed_after_the_last_moment_still_travels(store: Store, tmp_path: Path) -> None:
    group = store.groups.create("Onças")
    last = "9998-12-31T23:59:59.999999Z"
    store._database.write(lambda db: db.execute("UPDATE groups SET changed_at = ?", [last]))
    store.groups.change(group.id, {"name": "Araras"})
    info = exported(store, tmp_path / "a.pinel")
    assert (info.left_out, info.counts["groups"]) == ((), 1)


@pytest.mark.parametrize("number", ["1" * 400, "-" + "9" * 4000, "1" * 5000, "1e400"])
def test_a_place_that_no_float_can_hold_is_refused(number: str) -> None:
    assert not RUNS.rules["path"](f"[[{number},0]]")


def test_large_texts_are_not_remembered() -> None:
    json_check._cached_read.cache_clear()
    tracemalloc.start()
    try:
        for n in range(5):
            assert is_object(f'{{"a":[{"{}," * 100_000}{n}]}}')
        assert parsed('{"a":1}') == {"a": 1}
        left, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert left < 1_000_000
    assert json_check._cached_read.cache_info().currsize == 1


@pytest.mark.parametrize(
    "world", ["{}", '{"name":5}', '{"pinel_world":1,"name":"a","walls":{}}', '{"w":-0.0}', "[]"]
)
def test_worlds_and_reports_are_of_their_kind(world: str) -> None:
    assert not RUNS.rules["world_document"](world)
    assert not VERSIONS.rules["world"](world)
    assert VERSIONS.rules["world"]('{"pinel_world":1,"name":"a","walls":[]}')
    assert not RUNS.rules["check_report"]('"x"')


def test_a_row_that_would_be_refused_does_not_keep_the_others_from_travelling(
    store: Store, tmp_path: Path, opened: Callable[..., Store]
) -> None:
    group = store.groups.create("Onças")
    valid, _ = work(store, group, "Bom")
    invalid, _ = work(store, group, "Estranho")
    store._database.write(
        lambda db: db.execute(
            "UPDATE versions SET parent_id = 'x' WHERE program_id = ?", [invalid.id]
        )
    )
    info = exported(store, tmp_path / "a.pinel")
    assert len(info.left_out) == 2
    assert all(row.startswith("versions.parent_id ") for row in info.left_out)
    assert problems_in(info.path) == []
    other = opened(tmp_path / "other.db")
    assert merged(other, info.path).added["runs"] == 1
    assert other.versions.newest(valid.id) == store.versions.newest(valid.id)
    assert other.versions.newest(invalid.id) is None
