"""The table of attacks, continued: programs that keep connections busy. It reads as `test_attacks.py` does."""

import resource
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import psutil
import pytest

from tests.attacks.served import ServedPc, until
from tests.attacks.strangers import flood, strangers
from tests.web.conftest import SQUARE

pytestmark = [pytest.mark.waits, pytest.mark.timeout(300)]

N_CONNECTIONS = 1_100
IDLE = 0.5  # of a processor at most; a loop without end needs all of one
FAR = {**SQUARE, "commands": [{"action": "move_forward", "distance": 3}]}
SLOW = 0.1


@pytest.fixture(params=[64, 256, 1024], ids=lambda n: f"{n} files")
def pc(tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[ServedPc]:
    """May open so many files."""
    pc = ServedPc(tmp_path, open_files=request.param)
    pc.start()
    yield pc
    pc.stop()


def is_stopped(pc: ServedPc, run: str) -> bool:
    """Once it was asked for."""
    pc.client.do("POST", f"runs/{run}/commands", {"do": "stop"})
    pc.ends(run)
    return bool(pc.run(run)["state"] == "stopped")


def test_requests_that_strangers_send_by_half_hold_up_neither_stop_nor_the_page(
    pc: ServedPc,
) -> None:
    program = pc.program("square")
    with pc.client.browser.stream() as stream, strangers(pc.port) as attack:
        stream.next()
        run, n_before = pc.begins(program, FAR, speed=SLOW), pc.n_connections()
        attack.connect(N_CONNECTIONS)
        assert is_stopped(pc, run)
        assert stream.until("run_ended")[-1]["run"] == run
        assert pc.share_of_processor() < IDLE
        until(lambda: pc.n_connections() <= n_before)


@pytest.mark.parametrize("pc", [64, 1024], indirect=True)
def test_nor_do_new_ones_again_and_again(pc: ServedPc) -> None:
    program = pc.program("square")
    with flood(pc.port):
        for _ in range(3):
            run = pc.begins(program, FAR, speed=SLOW)
            assert is_stopped(pc, run)
            assert pc.client.browser.get("/").status == 200


@pytest.mark.parametrize("pc", [64], indirect=True)
def test_an_app_that_can_open_no_more_files_rests_until_it_can(pc: ServedPc) -> None:
    with ExitStack() as streams:
        for _ in range(80):
            streams.enter_context(pc.begins_to_listen())
        assert pc.share_of_processor() < IDLE
    until(lambda: pc.client.browser.get("/api/status").status == 200)


def test_where_the_system_allows_more_files_the_app_takes_them(tmp_path: Path) -> None:
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    pc = ServedPc(tmp_path)
    resource.setrlimit(resource.RLIMIT_NOFILE, (256, hard))
    try:
        pc.start()
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
    allowed = pc.process.rlimit(psutil.RLIMIT_NOFILE)
    pc.stop()
    assert allowed == (min(4096, hard), hard)
