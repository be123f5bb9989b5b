"""Checking programs in parallel: a process that dies, and a generator that is closed early."""

import json
import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from pinel_desktop.activities import check_files, choose_activity
from pinel_desktop.processes.workers import Workers
from tests.in_time import in_time

PROGRAMS = Path(__file__).parents[1] / "programs"
SQUARE = str(PROGRAMS / "square.json")


@pytest.fixture
def endless(tmp_path: Path) -> str:
    """A program that takes a minute to check, also on a fast PC: each step calculates a large sum."""
    count = {"action": "change_variable", "name": "n", "by": large_sum(6)}
    begin = {"action": "set_variable", "name": "n", "value": 0}
    file = tmp_path / "endless.json"
    file.write_text(json.dumps([begin, {"action": "forever", "commands": [count]}]), "utf-8")
    return str(file)


def large_sum(depth: int) -> object:
    """Returns an expression with 2**depth ones."""
    return {"op": "+", "args": [large_sum(depth - 1), large_sum(depth - 1)]} if depth else 1


def kill_all() -> None:
    for child in multiprocessing.active_children():
        assert child.pid is not None
        os.kill(child.pid, signal.SIGKILL)


def when(condition: Callable[[], bool], then: Callable[[], None]) -> None:
    """Calls a function on another thread as soon as a condition holds."""

    def watch() -> None:
        while not condition():
            time.sleep(0.01)
        then()

    threading.Thread(target=watch, daemon=True).start()


def test_a_process_that_dies_is_its_programs_failure_and_the_others_go_on(endless: str) -> None:
    reports = check_files(choose_activity("square"), [endless, SQUARE, SQUARE], Workers(2))
    ready = [next(reports), next(reports)]
    kill_all()
    ready += reports
    assert [(i, report.passed) for i, report in sorted(ready, key=lambda one: one[0])] == [
        (0, False),
        (1, True),
        (2, True),
    ]
    (lost,) = [report for i, report in ready if i == 0]
    assert [fault.code for fault in lost.faults] == ["check_process_lost"]
    assert lost.program == endless


def test_programs_that_wait_get_another_process(endless: str) -> None:
    when(lambda: len(multiprocessing.active_children()) == 2, kill_all)
    reports = dict(check_files(choose_activity("square"), [endless, endless, SQUARE], Workers(2)))
    assert [reports[i].passed for i in range(3)] == [False, False, True]


def test_all_processes_end_when_nobody_waits_any_more(endless: str) -> None:
    files = [SQUARE, *[endless] * 6]
    reports = check_files(choose_activity("square"), files, Workers(2))
    assert next(reports)[1].passed
    started = time.monotonic()
    reports.close()  # type: ignore[attr-defined] # a generator
    assert in_time(time.monotonic() - started, 2.0)
    assert multiprocessing.active_children() == []
