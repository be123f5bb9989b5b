"""Opens the real window without WebGL and works in its page as a group does; prints the results as JSON.

    python weak_pc_probe.py DATABASE

A mission's run, a run that waits for recorded signs, and its replay; each is started by a click.
"""

import json
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from pinel_desktop.desktop import window as windows
from pinel_desktop.desktop.app_process import AppProcess
from pinel_desktop.desktop.ending import end_process
from pinel_desktop.desktop.gtk_window import GtkWindow
from pinel_desktop.desktop.presenter import TITLE, USABLE
from pinel_desktop.desktop.self_check import (
    MISSION,
    RECORDED_SIGNS,
    Client,
    make_program,
    signs_of,
)
from pinel_desktop.instance import InstanceLock
from scripts.screenshots.programs import forward, repeat, sign, turn, workspace

SQUARE = workspace(repeat(4, forward(1), turn(90)))
# the recorded hand shows B for a while, then A
SIGNS = workspace(repeat(6, sign(30), forward(0.2)))
_OF_RUN = ("state", "passed", "closing_error_m", "duration_s")
_WITHIN_S = 200.0
_POLL_S = 0.1
_WEBGL = "!!document.createElement('canvas').getContext('webgl')"
_SIZE = "[innerWidth, innerHeight]"
_PLAY_DOES = "document.querySelector('[data-testid=replay-play]')?.dataset.does"
_CAN_RUN = "document.querySelector('[data-testid=run]')?.disabled === false"


class WindowWithoutWebGl(GtkWindow):
    def __init__(self, window: Any) -> None:
        super().__init__(window)
        self._page.get_settings().props.enable_webgl = False


class Probe:
    """The app, its window, and what was found."""

    def __init__(self, database: Path) -> None:
        self.found: dict[str, Any] = {}
        self._instance = InstanceLock(database)
        self._instance.acquire()
        self._started_s = time.monotonic()
        self._app = AppProcess(
            database, lambda request: None, self._close, camera=str(RECORDED_SIGNS)
        )
        self._app.start()
        self._client = Client(self._app.address())
        self._mission, self._signs = make_program(self._client), make_program(self._client)
        self._save(self._mission, {"workspace": SQUARE, "document": None, "setup": MISSION})
        self._save(self._signs, {"workspace": SIGNS, "document": None})
        self._window = windows.NativeWindow(
            lambda: f"{self._app.address()}#/program/{self._mission}",
            TITLE,
            self._app.language,
            on_open=self._work,
        )

    def _save(self, program: str, content: dict[str, Any]) -> None:
        self._client.post(f"/api/programs/{program}/versions", content)

    def run(self) -> None:
        """Shows the window until all is done."""
        try:
            self._window.run("gtk")
        finally:
            self._app.close()
            self._instance.release()

    def _close(self) -> None:
        self._window.close()

    def _work(self) -> None:
        try:
            self._step("start", lambda: self._until(USABLE))
            self.found["webgl"] = self._window.run_script(_WEBGL)
            self.found["size"] = self._window.run_script(_SIZE)
            self._step("mission", self._drive_mission)
            self._step("capture", self._capture)
            self._step("replay", self._replay)
        except Exception as error:
            self.found["error"] = repr(error)
            self.found["page"] = self._window.run_script("document.body.innerText")
        self._window.close()

    def _step(self, name: str, work: Callable[[], object]) -> None:
        work()
        now_s = time.monotonic()
        self.found[f"{name}_s"] = round(now_s - self._started_s, 1)
        self._started_s = now_s

    def _drive_mission(self) -> None:
        run = self._run_by_click(self._mission)
        self._wait(lambda: self._client.get(f"/api/runs/{run}")["passed"] is not None, "judge")
        self._until("!!document.querySelector('[data-testid=mission-done]')")
        end = self._client.get(f"/api/runs/{run}")
        self.found["run"] = {key: end[key] for key in _OF_RUN}

    def _capture(self) -> None:
        self._go(f"#/program/{self._signs}", USABLE)
        self._run = self._run_by_click(self._signs)
        self.found["signs"] = signs_of(self._client, self._run)

    def _replay(self) -> None:
        self._go(f"#/run/{self._run}", f"{_PLAY_DOES} === 'play'")
        self._click("replay-play")
        self._until(f"{_PLAY_DOES} === 'pause'")
        self._until(f"{_PLAY_DOES} === 'play'")

    def _run_by_click(self, program: str) -> str:
        """Runs the open program; returns the id of its run, which has ended."""
        self._wait(lambda: self._client.get("/api/status")["engine"] == "ready", "engine")
        self._until(_CAN_RUN)
        self._click("run")
        self._wait(lambda: bool(self._runs(program)), "run")
        run = str(self._runs(program)[0]["id"])
        self._wait(lambda: self._client.get(f"/api/runs/{run}")["ended_at"] is not None, "end")
        return run

    def _runs(self, program: str) -> list[dict[str, Any]]:
        groups = self._client.get("/api/groups")["groups"]
        runs = (self._client.get(f"/api/groups/{group['id']}/runs")["runs"] for group in groups)
        return [run for some in runs for run in some if run["program_id"] == program]

    def _go(self, place: str, shown: str) -> None:
        self._window.run_script(f"location.hash = {json.dumps(place)}")
        self._until(f"location.hash === {json.dumps(place)} && {shown}")

    def _click(self, test_id: str) -> None:
        self._window.run_script(f"document.querySelector('[data-testid={test_id}]').click()")

    def _until(self, condition: str) -> None:
        self._wait(lambda: self._window.run_script(condition) is True, condition)

    def _wait(self, is_done: Callable[[], bool], what: str) -> None:
        due_s = time.monotonic() + _WITHIN_S
        while not is_done():
            if time.monotonic() > due_s:
                raise TimeoutError(what)
            time.sleep(_POLL_S)


def main() -> None:
    windows.GtkWindow = WindowWithoutWebGl  # type: ignore[attr-defined]
    probe = Probe(Path(sys.argv[1]))
    probe.run()
    print(json.dumps(probe.found), flush=True)
    end_process(0)


main()
