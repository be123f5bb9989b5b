"""Many runs of one program: a row is a function of its job alone, whatever runs it."""

import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.activities import choose_activity
from pinel_desktop.processes.workers import Workers
from pinel_desktop.robot import SimulationConfig
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from pinel_desktop.sweep import (
    Job,
    Row,
    make_jobs,
    new_pool,
    rows_of,
    run_job,
    run_jobs,
    summary_of,
    worlds_of,
)
from sim.world import world_document
from tests.in_time import in_time

PROGRAMS = Path(__file__).parents[1] / "programs"
REALISTIC = SimulationConfig(preset="realistic", feedback="odometry")


def program(name: str) -> dict[str, Any]:
    document: dict[str, Any] = json.loads((PROGRAMS / f"{name}.json").read_text("utf-8"))
    return document


def jobs_of(name: str, world: str, n_seeds: int, **options: Any) -> list[Job]:
    places = [(world, world_document(world))]
    return list(make_jobs([(name, program(name))], places, REALISTIC, range(n_seeds), **options))


def in_order(rows: Iterator[Row]) -> list[Row]:
    return sorted(rows, key=lambda row: row.index)


def test_rows_are_the_same_in_one_process_and_in_two() -> None:
    jobs = jobs_of("square", "empty_room", 6, n_poses=20)
    alone = in_order(run_jobs(jobs, Workers(1)))
    assert in_order(run_jobs(jobs, Workers(2))) == alone
    assert [row.seed for row in alone] == list(range(6))
    assert len({row.telemetry_sha256 for row in alone}) == 6


def test_a_row_is_the_run_of_its_seed() -> None:
    row = run_job(jobs_of("square", "empty_room", 4)[3])
    spec = RunSpec(program("square"), world_document("empty_room"), setting=REALISTIC, seed=3)
    ended = start(spec).ended
    assert row.telemetry_sha256 == ended.telemetry_sha256
    assert row.closing_error_m == ended.closing_error_m


def test_jobs_are_program_by_program_world_by_world_seed_by_seed() -> None:
    programs = [(name, program(name)) for name in ("square", "maze")]
    worlds = [(name, world_document(name)) for name in ("empty_room", "maze")]
    jobs = list(make_jobs(programs, worlds, REALISTIC, [5, 2]))
    assert [job.index for job in jobs] == list(range(8))
    assert [(job.program, job.world, job.seed) for job in jobs[:5]] == [
        ("square", "empty_room", 5),
        ("square", "empty_room", 2),
        ("square", "maze", 5),
        ("square", "maze", 2),
        ("maze", "empty_room", 5),
    ]


def test_a_collision_is_blamed_on_the_block_that_drove_into_it() -> None:
    (row,) = map(run_job, jobs_of("into_the_wall", "empty_room", 1, n_poses=30))
    assert (row.cause, row.is_well, row.n_collisions) == ("collision", False, 1)
    assert row.pointer == "/commands/1"
    assert len(row.path) == 30
    assert row.end is not None
    assert row.path[-1] == pytest.approx(row.end[:2], abs=1e-3)


def test_an_activity_judges_each_run() -> None:
    activity = choose_activity("square")
    options: dict[str, Any] = {"activity": activity}
    documents = [(name, program(name)) for name in ("square", "there_and_back")]
    jobs = make_jobs(
        documents, worlds_of(activity), SimulationConfig(preset="realistic"), [1], **options
    )
    good, bad = map(run_job, jobs)
    assert (good.passed, good.cause) == (True, None)
    assert (bad.passed, bad.cause) == (False, "check")
    assert bad.check is not None


def test_a_program_that_never_ends_has_a_row_at_its_limit() -> None:
    forever = [{"action": "forever", "commands": [{"action": "wait", "seconds": 1}]}]
    job = replace(jobs_of("square", "empty_room", 1, limit_s=3.0)[0], document=json.dumps(forever))
    row = run_job(job)
    assert (row.state, row.reason, row.params) == ("failed", "too_long", {"limit": 3.0})
    assert row.cause == "failure"
    assert row.duration_s == pytest.approx(3.0, abs=1.1)


def test_a_faulty_job_is_a_row_that_says_so() -> None:
    job = replace(jobs_of("square", "empty_room", 1)[0], document='[{"action": "fly"}]')
    assert run_job(job).reason == "invalid_program"
    assert run_job(replace(job, floor="{}")).state == "failed"


def test_a_process_of_a_pool_loads_no_storage_which_would_delay_its_first_job() -> None:
    loaded = "import sys, pinel_desktop.sweep.jobs; sys.exit('storage' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", loaded], check=False).returncode == 0


def kill_every_process() -> None:
    for child in multiprocessing.active_children():
        assert child.pid is not None
        os.kill(child.pid, signal.SIGKILL)


def endless(seed: int) -> Job:
    """A job that takes a minute: each step calculates a large sum."""

    def large_sum(depth: int) -> object:
        return {"op": "+", "args": [large_sum(depth - 1)] * 2} if depth else 1

    count = {"action": "change_variable", "name": "n", "by": large_sum(6)}
    begin = {"action": "set_variable", "name": "n", "value": 0}
    text = json.dumps([begin, {"action": "forever", "commands": [count]}])
    return replace(jobs_of("square", "empty_room", 1)[0], document=text, seed=seed, index=seed)


def test_a_killed_process_is_replaced_and_its_job_tried_again() -> None:
    jobs = jobs_of("square", "empty_room", 8)
    pool = new_pool(2)
    pool.start()
    try:
        rows = rows_of(pool, jobs)
        first = [next(rows)]
        kill_every_process()
        found = in_order(iter([*first, *rows]))
    finally:
        pool.end()
    assert found == [run_job(job) for job in jobs]


def test_a_job_that_kills_its_processes_has_a_row_that_says_so() -> None:
    pool = new_pool(1)
    is_over = threading.Event()

    def kill_as_they_come() -> None:
        while not is_over.wait(0.05):
            kill_every_process()

    killer = threading.Thread(target=kill_as_they_come)
    killer.start()
    try:
        (row,) = rows_of(pool, [endless(7)])
    finally:
        is_over.set()
        killer.join()
        pool.end()
    assert (row.seed, row.reason, row.cause) == (7, "worker_lost", "failure")


def test_closing_ends_the_processes_that_are_busy() -> None:
    rows = run_jobs([*jobs_of("square", "empty_room", 1), endless(1), endless(2)], Workers(2))
    next(rows)
    started = time.monotonic()
    rows.close()
    assert in_time(time.monotonic() - started, 2.0)
    assert multiprocessing.active_children() == []


def test_the_summary_does_not_depend_on_the_order_of_the_rows() -> None:
    rows = [run_job(job) for job in jobs_of("into_the_wall", "empty_room", 3)]
    rows += [
        replace(run_job(job), index=3 + job.index) for job in jobs_of("square", "empty_room", 3)
    ]
    summary = summary_of(rows)
    assert (summary.n_runs, summary.n_well, summary.n_collided) == (6, 3, 3)
    ((reason, n),) = summary.reasons
    assert (reason.cause, n) == ("collision", 3)
    assert summary.closing_error_m is not None
    assert summary_of(reversed(rows)) == summary
    assert summary_of([]).success == 0.0
