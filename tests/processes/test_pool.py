"""Cancelling the tasks of a pool from another thread, at any moment."""

import os
import threading
import time
from collections.abc import Iterator

import pytest

from pinel_desktop.processes.pool import ProcessPool


@pytest.fixture
def pool() -> Iterator[ProcessPool[float, int]]:
    pool = ProcessPool(slept, 2)
    pool.start()
    yield pool
    pool.end()


def slept(duration_s: float) -> int:
    time.sleep(duration_s)
    return os.getpid()


def test_cancelling_before_the_first_result_is_asked_for_ends_all(
    pool: ProcessPool[float, int],
) -> None:
    results = pool.results([600.0] * 4)  # a generator: nothing has begun
    pool.cancel()
    assert list(results) == []


def test_cancelling_while_a_task_is_given_ends_all(pool: ProcessPool[float, int]) -> None:
    def tasks() -> Iterator[float]:
        yield 600.0
        pool.cancel()
        yield 600.0

    assert list(pool.results(tasks())) == []


def test_after_a_cancellation_the_pool_takes_new_tasks(pool: ProcessPool[float, int]) -> None:
    ended = threading.Thread(target=lambda: list(pool.results([600.0] * 4)))
    ended.start()
    while len(pool._busy) < 2:
        time.sleep(0.01)
    pool.cancel()
    ended.join(30)
    assert not ended.is_alive()
    pool.start()
    assert [task for task, _ in pool.results([0.0, 0.0, 0.0])] == [0.0, 0.0, 0.0]
