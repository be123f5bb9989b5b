"""A process that the app owns: what is sent to it arrives, and one that hangs holds up nobody."""

import sys
import threading
import time
from collections.abc import Callable
from typing import Any

import pytest

from pinel_desktop.processes import owned as owned_process
from pinel_desktop.processes.outbox import MOST_WAITING
from pinel_desktop.processes.owned import OwnedProcess
from tests.in_time import in_time

WAIT_S = 30.0
READY = 'print(\'{"type": "some_ready"}\', flush=True)'
DEAF = f"import time; {READY}; time.sleep(600)"
ECHO = f"import sys; {READY}\nfor line in sys.stdin: sys.stdout.write(line)"


def process(script: str, on_message: Callable[[dict[str, Any]], None]) -> OwnedProcess:
    made = OwnedProcess("some", [sys.executable, "-c", script], on_message, lambda: None)
    made.start()
    assert made.wait_until_ready(WAIT_S)
    return made


def test_all_that_was_sent_arrives_in_order_before_the_process_ends() -> None:
    heard: list[dict[str, Any]] = []
    owned = process(ECHO, heard.append)
    for n in range(500):
        owned.send({"n": n})
    owned.close()
    assert heard == [{"n": n} for n in range(500)]


def test_process_that_does_not_read_holds_up_neither_who_sends_nor_who_ends_it() -> None:
    owned = process(DEAF, lambda message: None)
    first, began_s = owned.pid, time.monotonic()
    owned.send({"much": "a" * 10_000_000})
    owned.kill()
    assert in_time(time.monotonic() - began_s, 1.0)
    while owned.pid == first:
        assert time.monotonic() - began_s < WAIT_S
        threading.Event().wait(0.02)
    owned.close()


def test_who_waits_for_a_process_that_is_closed_while_it_starts_goes_on() -> None:
    command = [sys.executable, "-c", "input()"]  # it never says that it is ready
    owned = OwnedProcess("some", command, lambda _: None, lambda: None)
    owned.start()
    answers: list[bool] = []
    waiting = threading.Thread(target=lambda: answers.append(owned.wait_until_ready(60)))
    waiting.start()
    owned.close()
    waiting.join(WAIT_S)
    assert answers == [False]
    assert owned.wait_until_ready(60) is False


def lost(command: list[str]) -> list[str]:
    """What is told of a process that cannot live, until it is not started again."""
    told: list[str] = []
    owned = OwnedProcess(
        "some",
        command,
        lambda message: None,
        lambda: told.append("died"),
        on_lost=lambda: told.append("lost"),
    )
    owned.start()
    assert not owned.wait_until_ready(WAIT_S)
    assert owned.state == "lost"
    owned.close()
    return told


def test_process_that_dies_three_times_soon_after_its_start_is_told_to_be_lost(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(
        owned_process, "_SHORT_LIFE_S", WAIT_S
    )  # on a busy PC Python itself starts slowly
    assert lost([sys.executable, "-c", ""]) == ["died", "died", "died", "lost"]


def test_process_that_cannot_be_started_is_told_to_be_lost() -> None:
    assert lost(["/nowhere/some"]) == ["lost"]


def test_a_process_that_does_not_read_takes_only_so_much_and_the_rest_is_refused_at_once() -> None:
    owned = process(DEAF, lambda message: None)
    line, began_s = {"much": "a" * 1_000}, time.monotonic()
    taken = [owned.send(line) for _ in range(50_000)]
    assert time.monotonic() - began_s < WAIT_S
    assert (
        MOST_WAITING - 2_000 < 1_012 * sum(taken) < MOST_WAITING + 200_000
    )  # with what the pipe holds
    assert not taken[-1]
    owned.close()


def test_a_long_message_is_taken_where_nothing_waits() -> None:
    owned = process(ECHO, lambda message: None)
    assert owned.send({"much": "a" * 2 * MOST_WAITING})
    owned.close()
