"""The albums of 40 groups with 2,000 runs, beside reading their rows with bare SQLite and parsing the programs."""

import json
import random
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from pinel_desktop.activities import activity_names, solution_of
from pinel_desktop.app import App
from pinel_desktop.school.album import album_of
from sim.world import world_document
from storage import RunStart, Store
from storage.sqlite import sqlite3
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine

N_GROUPS, N_RUNS = 40, 2_000
REPEATS = 9
MAX_MS = 100.0  # of one album as the page waits for it, and of one group that made all runs
MAX_RATIO = 5.0  # of all albums together
ROWS = """SELECT runs.id, activity, passed, state, path_length_m, started_at, versions.document
    FROM runs JOIN versions ON versions.id = version_id WHERE group_id = ? ORDER BY runs.id"""


def play(store: Store, group: str, n_runs: int) -> None:
    """Runs of missions in turn, each of a version of its own; two of three pass."""
    chance = random.Random(group)
    program = store.programs.create(group, "Programa").id
    names = activity_names()
    ends = []
    for number in range(n_runs):
        name = names[number % len(names)]
        document = solution_of(name) or {}
        version = store.versions.save(program, {"number": number}, document).id
        world = world_document("neighbourhood")
        start = RunStart("sim", "w", world, 0, "1", version_id=version, activity=name)
        passed = chance.random() < 0.66
        ends.append((passed, "finished" if passed else "failed", store.runs.begin(start).id))
    store._database.write(_ending(ends))


def _ending(ends: list[tuple[bool, str, str]]) -> Callable[[sqlite3.Connection], int]:
    change = """UPDATE runs SET passed = ?, state = ?, path_length_m = 4, duration_s = 6, ended_at = started_at,
        check_report = '{"cases": []}', path = '[[0, 0], [1, 0], [1, 1]]' WHERE id = ?"""
    return lambda db: int(db.executemany(change, ends).rowcount)


def best_ms(call: Callable[[], object]) -> float:
    durations = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        call()
        durations.append(time.perf_counter() - begin)
    return 1000 * min(durations)


def bare_read(path: Path, groups: list[str]) -> Callable[[], list[Any]]:
    """Returns what reads the runs of the groups and parses the programs that ran."""
    db = sqlite3.connect(path)
    return lambda: [
        json.loads(row[-1]) for group in groups for row in db.execute(ROWS, [group]).fetchall()
    ]


def test_an_album_reaches_the_page_at_once_and_costs_a_few_times_what_reading_its_rows_costs(
    tmp_path: Path,
) -> None:
    with App(tmp_path / "pinel.db", make_engine=FakeEngine) as app:
        store, page = app._store, Browser.signed_in(app.address)
        groups = [store.groups.create(f"Grupo {n}").id for n in range(N_GROUPS)]
        for group in groups:
            play(store, group, N_RUNS // N_GROUPS)
        busy = store.groups.create("Todas").id
        play(store, busy, N_RUNS)
        begin = time.perf_counter()
        page.get(f"/api/groups/{groups[0]}/album")
        first_ms = 1000 * (time.perf_counter() - begin)
        one_ms = best_ms(lambda: page.get(f"/api/groups/{groups[1]}/album"))
        busy_ms = best_ms(lambda: page.get(f"/api/groups/{busy}/album"))
        all_ms = best_ms(lambda: [album_of(store, group, "pt-BR") for group in groups])
        bare_ms = best_ms(bare_read(store.path, groups))
        assert sum(one.win is not None for one in album_of(store, busy, "en")) >= len(
            activity_names()
        )
    print(
        f"\n{N_GROUPS} groups, {N_RUNS} runs: one album over HTTP {one_ms:.1f} ms (the first one {first_ms:.0f} ms),"
        f" all {N_GROUPS} albums {all_ms:.0f} ms, their rows by bare SQLite and json {bare_ms:.1f} ms,"
        f" ratio {all_ms / bare_ms:.1f};"
        f" a group that made {N_RUNS} runs itself {busy_ms:.0f} ms"
    )
    assert one_ms < MAX_MS
    assert busy_ms < MAX_MS
    assert all_ms < MAX_RATIO * bare_ms
