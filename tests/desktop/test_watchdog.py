"""The watchdog of kiosk mode, with small processes in place of the window's."""

import sys
import threading
import time
from pathlib import Path

import pytest

from pinel_desktop.desktop.kiosk.watchdog import Watchdog

LEFT, RESTARTS = 0, 75

# writes its place to the log, tells a new place if it has one, and ends as the script of its turn says
WINDOW = """
import json, os, signal, sys, time
log, script, place = sys.argv[1:]
with open(log, "a") as file:
    file.write(place + "\\n")
turn = len(open(log).readlines()) - 1
act = json.loads(script)[turn]
if "place" in act:
    print(json.dumps({"place": act["place"]}), flush=True)
if act["end"] == "killed":
    os.kill(os.getpid(), signal.SIGKILL)
if act["end"] == "waits":
    time.sleep(600)
sys.exit(act["end"])
"""


class Script:
    """The windows of a test, one after the other, and where they opened."""

    def __init__(self, log: Path, acts: str) -> None:
        self._log, self._acts = log, acts
        self.watchdog = Watchdog(self._command, final=(LEFT, RESTARTS), place="start")

    def _command(self, place: str) -> list[str]:
        return [sys.executable, "-c", WINDOW, str(self._log), self._acts, place]

    @property
    def places(self) -> list[str]:
        return self._log.read_text("utf-8").splitlines() if self._log.exists() else []


def test_a_window_that_was_killed_opens_again_at_its_place(tmp_path: Path) -> None:
    acts = '[{"place": "program/1", "end": "killed"}, {"place": "teacher", "end": 0}]'
    script = Script(tmp_path / "log", acts)
    assert script.watchdog.run() == LEFT
    assert script.places == ["start", "program/1"]


@pytest.mark.parametrize("status", [LEFT, RESTARTS])
def test_a_window_that_may_end_stays_closed(tmp_path: Path, status: int) -> None:
    script = Script(tmp_path / "log", f'[{{"place": "x", "end": {status}}}]')
    assert script.watchdog.run() == status
    assert script.places == ["start"]


def test_a_window_that_never_opens_is_tried_a_few_times(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pinel_desktop.desktop.kiosk.watchdog._LONG_S", 0.0)  # without pauses
    script = Script(
        tmp_path / "log", '[{"end": 1}, {"end": 1}, {"end": 1}, {"end": 1}, {"end": 1}]'
    )
    assert script.watchdog.run() == 1
    assert script.places == ["start"] * 5


def test_the_end_of_the_watchdog_is_the_end_of_the_window(tmp_path: Path) -> None:
    script = Script(tmp_path / "log", '[{"place": "x", "end": "waits"}]')
    statuses: list[int] = []
    running = threading.Thread(target=lambda: statuses.append(script.watchdog.run()), daemon=True)
    running.start()
    deadline_s = time.monotonic() + 60
    while not script.places and time.monotonic() < deadline_s:
        time.sleep(0.05)
    script.watchdog.end()
    running.join(20)
    assert statuses == [LEFT]
    assert script.places == ["start"]
