"""A school day of eight hours at one PC: the app needs no more memory at its end than after its first lesson."""

import gc
import threading
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import psutil
import pytest

from pinel_desktop.app import App
from storage.file.backups import list_backups
from tests.storage.sample_runs import block_started, ended, sample
from tests.web.browser import Browser
from tests.web.conftest import SQUARE
from tests.web.fake_engine import FakeEngine

LESSON_MIN, N_LESSONS = 50, 9
EDITS_A_BURST = 30  # one a second, then the group talks for as long
RUN_EVERY_MIN, RUN_S = 3, 60
TICK_HZ = 30
MAX_GROWTH_MB = 12.0


class Day:
    """A group after the other edits and runs; the clocks of the app go as fast as the work does."""

    def __init__(self, app: App) -> None:
        self._app = app
        self._now_s = 0.0
        self._browser = Browser.signed_in(app.address)
        app._recorder._clock = lambda: self._now_s
        start = datetime.now(UTC)
        app._maintenance._clock = lambda: start + timedelta(seconds=self._now_s)
        self.n_edits = self.n_runs = 0

    def lesson(self, name: str) -> None:
        group = self._browser.post("/api/groups", {"name": name}).data["id"]
        program = self._browser.post(f"/api/groups/{group}/programs", {"name": "P"}).data["id"]
        for minute in range(LESSON_MIN):
            version = self._burst(program)
            if minute % RUN_EVERY_MIN == 0:
                self._run(version)
        for page in (f"/api/groups/{group}/runs", f"/api/programs/{program}", "/api/status"):
            assert self._browser.get(page).status == 200
        self._app._maintenance.check_space()
        self._app._maintenance.back_up()

    def _burst(self, program: str) -> str:
        for _ in range(EDITS_A_BURST):
            self.n_edits += 1
            self._now_s += 1
            blocks = {"n": self.n_edits, "text": "x" * (self.n_edits * 997 % 9000)}
            saved = self._browser.post(
                f"/api/programs/{program}/versions",
                {"workspace": {"blocks": blocks}, "document": SQUARE},
            )
            assert saved.status == 200, saved.body
        self._now_s += 60 - EDITS_A_BURST
        return str(saved.data["id"])

    def _run(self, version: str) -> None:
        engine: Any = self._app._engine
        response = self._browser.post("/api/runs", {"version_id": version, "world": "empty_room"})
        run, n_samples = response.data["id"], RUN_S * TICK_HZ
        engine.send(block_started(run, 0))
        for tick in range(n_samples):
            self._now_s += 1 / TICK_HZ
            engine.send(sample(run, tick, seq=1 + tick, x_m=(tick % 300) / 100))
        engine.send(ended(run, 1 + n_samples, n_samples))
        engine.live_run = None
        self.n_runs += 1
        for part in ("", "/events", "/telemetry"):
            assert self._browser.get(f"/api/runs/{run}{part}").status == 200


def memory_mb() -> float:
    gc.collect()
    return float(psutil.Process().memory_info().rss) / 1e6


@pytest.mark.nightly
@pytest.mark.timeout(1800)
def test_memory_is_flat_over_a_school_day(tmp_path: Path) -> None:
    path, sizes = tmp_path / "pinel.db", []
    with App(path, make_engine=FakeEngine) as app:
        watching = Browser.signed_in(app.address)
        day = Day(app)

        def watch() -> None:
            with watching.stream() as stream:
                for _event in stream.events():
                    pass

        page = threading.Thread(target=watch)
        page.start()
        for n in range(N_LESSONS):
            day.lesson(f"Grupo {n}")
            sizes.append(memory_mb())
        runs = app._store.runs.newest(1000)
        assert {run.state for run in runs} == {"finished"}
        assert len(runs) == day.n_runs
    page.join()
    print(
        f"\n{day.n_edits} edits, {day.n_runs} runs of {RUN_S} s; resident after each lesson "
        f"{', '.join(f'{size:.0f}' for size in sizes)} MB, to grow by at most {MAX_GROWTH_MB}"
    )
    assert len(list_backups(path)) == 1
    assert sizes[-1] - sizes[0] <= MAX_GROWTH_MB
