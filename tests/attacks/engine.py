"""The tools of `a process that hangs or grows`: a real app with its engine's process, which the test may stop."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import psutil

from pinel_desktop.app import App
from pinel_desktop.engine.client import EngineClient
from pinel_desktop.engine.commands import Answer
from pinel_desktop.errors import PinelError
from tests.live_runs import command, saved, start_run
from tests.web import browser
from tests.web.browser import Browser

# the end of a run, and how long after the engine was stopped it came, in s
Ended = tuple[dict[str, Any], float]

WAIT_S = 30.0
# an engine is ended after two seconds of silence, a Stop is answered after one; what is more is a busy PC's
NOTICED_S, SOON_S = 10.0, 5.0
FAR = {"pinel_ir": 1, "name": "n", "commands": [{"action": "move_forward", "distance": 3}]}
NOTHING: dict[str, Any] = {"pinel_ir": 1, "name": "n", "commands": []}


@dataclass
class Flood:
    """What became of many commands.

    Attributes:
        codes: of the errors; "" where a command was taken.
        max_s: the longest time that one of them took.
        grown_mb: memory of the app.
    """

    codes: set[str] = field(default_factory=set)
    max_s: float = 0.0
    grown_mb: float = 0.0


class Desk:
    """An app at which a group runs its programs."""

    def __init__(self, app: App) -> None:
        self.browser = Browser.signed_in(app.address)
        assert isinstance(app._engine, EngineClient)
        self.engine = app._engine
        assert self.engine.wait_until_ready(WAIT_S)

    @property
    def process(self) -> psutil.Process:
        return psutil.Process(self.engine.pid)

    def run_to_the_end(self) -> dict[str, Any]:
        """Another run, with its end."""
        with self.browser.stream() as stream:
            stream.next()
            start_run(self.browser, saved(self.browser, NOTHING))
            return stream.until("run_ended")[-1]

    @contextmanager
    def run_with_frozen_engine(self) -> Iterator[tuple[str, Callable[[], Ended]]]:
        """A run whose engine is stopped in the middle: its id, and what waits for its end."""
        with self.browser.stream() as stream:
            stream.next()
            run = start_run(self.browser, saved(self.browser, FAR))
            stream.until("telemetry")
            self.process.suspend()
            frozen_s = time.monotonic()
            yield (
                run,
                lambda: (stream.until("run_ended")[-1], time.monotonic() - frozen_s),
            )

    def flood(self, run: str, n: int) -> Flood:
        """What becomes of `n` commands of 1,000 letters each."""
        flood, app = Flood(), psutil.Process()
        before = app.memory_info().rss
        for _ in range(n):
            start_s, code = time.monotonic(), ""
            try:
                self.engine.command(run, Answer(value=1_000 * "a"))
            except PinelError as error:
                code = error.code
            flood.codes.add(code)
            flood.max_s = max(flood.max_s, time.monotonic() - start_s)
        flood.grown_mb = (app.memory_info().rss - before) / 1e6
        return flood

    def command(self, run: str, do: str, **more: Any) -> tuple[browser.ApiResponse, float]:
        """The answer, and after how many s it came."""
        start_s = time.monotonic()
        return command(self.browser, run, do, **more), time.monotonic() - start_s


@contextmanager
def desk(folder: Path) -> Iterator[Desk]:
    with App(folder / "pinel.db") as app:
        yield Desk(app)
