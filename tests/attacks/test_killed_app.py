"""The table of attacks, continued: runs whose app or judge is killed. It reads as `test_attacks.py` does."""

import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.attacks.served import ServedPc, until
from tests.web.conftest import SQUARE

pytestmark = [pytest.mark.waits, pytest.mark.timeout(300)]

FAST = 10.0
SHORT = {**SQUARE, "commands": [{"action": "move_forward", "distance": 0.1}]}
FAR = {**SQUARE, "commands": [{"action": "move_forward", "distance": 3}]}


@pytest.fixture
def pc(tmp_path: Path) -> Iterator[ServedPc]:
    pc = ServedPc(tmp_path)
    pc.start()
    yield pc
    pc.stop()


def test_runs_whose_app_was_killed_right_after_them_are_judged_once_at_the_next_start(
    pc: ServedPc,
) -> None:
    program, runs = pc.program("square"), list[str]()
    runs.append(pc.begins(program, FAR))
    with pc.frozen_judge():
        pc.client.do("POST", f"runs/{runs[0]}/commands", {"do": "stop"})
        pc.ends(runs[0])
        for document in (SQUARE, SHORT, SQUARE):
            runs.append(pc.begins(program, document, speed=FAST))
            pc.ends(runs[-1])
        assert [pc.run(run)["passed"] for run in runs] == [None] * 4
        pc.kill()
    pc.start()
    until(lambda: all(pc.is_judged(run) for run in runs))
    assert [pc.run(run)["passed"] for run in runs] == [False, True, False, True]
    judged = [pc.run(run) for run in runs]
    pc.kill()
    pc.start()
    after = pc.begins(program, SHORT, speed=FAST)
    until(lambda: pc.is_judged(after))
    assert [pc.run(run) for run in runs] == judged


def test_a_run_whose_judge_was_lost_is_judged_at_the_next_start(pc: ServedPc) -> None:
    program, is_judged = pc.program("square"), threading.Event()
    with pc.client.browser.stream() as stream:
        stream.next()
        run = pc.begins(program, SQUARE, speed=FAST)

        def listen() -> None:
            stream.until("judged")
            is_judged.set()

        listener = threading.Thread(target=listen)
        listener.start()
        pc.kill_judges_until(is_judged.is_set)
        listener.join()
    assert pc.run(run)["passed"] is None
    pc.stop()
    pc.start()
    until(lambda: pc.is_judged(run))
    assert pc.run(run)["passed"] is True
