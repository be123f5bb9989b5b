"""Merged runs are re-verified while no run is live; a run that starts here interrupts this."""

import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from pinel_desktop.judge.messages import Verdict
from pinel_desktop.school.confirming import Confirmer
from storage import RunStart, Store, open_store
from tests.attacks.forging import Pc
from tests.storage.sample_documents import SQUARE, WORLD

SLOW = (sys.executable, "-c", "import time; time.sleep(600)")
SAME = (sys.executable, "-c", 'print(\'{"outcome": "identical"}\')')
ANOTHER = (sys.executable, "-c", 'print(\'{"outcome": "altered"}\')')
NO_OUTPUT = (sys.executable, "-c", "import sys; sys.exit('a run of a later release')")


def until(reached: Callable[[], Any], bound_s: float = 30.0) -> None:
    deadline = time.monotonic() + bound_s
    while not reached():
        assert time.monotonic() < deadline, "not reached"
        time.sleep(0.02)


@pytest.fixture
def pupil(tmp_path: Path) -> Iterator[Pc]:
    with open_store(tmp_path / "pupil" / "pinel.db") as store:
        yield Pc(store, tmp_path / "pupil")


@pytest.fixture
def store(tmp_path: Path, pupil: Pc) -> Iterator[Store]:
    """A store with a run that waits for re-verification."""
    pupil.drives()
    with open_store(tmp_path / "pinel.db") as opened:
        opened.exchange.merge(pupil.file())
        yield opened


def found(store: Store, command: tuple[str, ...], *, passed: bool = True) -> dict[str, int]:
    confirmer = Confirmer(store, lambda _run: Verdict(passed, None, []), command=command)
    confirmer.start()
    until(lambda: not store.unconfirmed.waiting())
    confirmer.close()
    return store.unconfirmed.counts()


def test_what_comes_out_the_same_and_passes_counts(store: Store) -> None:
    assert found(store, SAME) == {}


def test_what_does_not_is_noted_with_its_reason(store: Store) -> None:
    assert found(store, SAME, passed=False) == {"not_passed": 1}


def test_a_record_that_comes_out_otherwise_differs(store: Store) -> None:
    assert found(store, ANOTHER) == {"differs": 1}


def test_a_record_that_cannot_be_repeated_stays_as_it_is(store: Store) -> None:
    assert found(store, NO_OUTPUT) == {"not_repeatable": 1}


def test_a_run_that_begins_here_ends_the_repetition_which_is_tried_again(store: Store) -> None:
    me = psutil.Process()
    before = {child.pid for child in me.children()}

    def repeating() -> bool:
        return any(one.pid not in before for one in me.children())

    confirmer = Confirmer(store, lambda _run: Verdict(True, None, []), command=SLOW)
    confirmer.start()
    until(repeating)
    run = store.runs.begin(RunStart("sim", "w", WORLD, 1, "0", document=SQUARE))
    until(lambda: not repeating())
    assert len(store.unconfirmed.waiting()) == 1
    store.runs.discard(run.id)
    confirmer.check_now()
    until(repeating)
    confirmer.close()
    assert not repeating()


def test_closing_between_two_searches_waits_for_no_third(store: Store) -> None:
    confirmer = Confirmer(store, lambda _run: Verdict(True, None, []), command=SLOW)

    class Closed(threading.Event):
        """`close` is called just before the thread clears the request for a search."""

        def clear(self) -> None:
            confirmer._closing.set()
            self.set()
            super().clear()

    confirmer._check_requested = Closed()
    confirmer.start()
    confirmer._thread.join(10)
    assert not confirmer._thread.is_alive()
