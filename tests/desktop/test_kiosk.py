"""Kiosk mode in the real window: attempts to escape, the teacher's way out, and crashes of each process."""

import contextlib
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from pinel_desktop.desktop.screen import virtual_screen
from pinel_desktop.desktop.self_check import MISSION, SQUARE
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import RunningInstance
from tests.desktop.window_manager import window_manager
from tests.web.browser import Browser

pytestmark = pytest.mark.e2e
_PIN = {"pin": "314159"}
_WITHIN_S = 120.0
_SETTLED_S = 5.0


@pytest.fixture(scope="module")
def screen() -> Iterator[str]:
    """A virtual screen with a window manager and its usual keys, such as Alt+F4 and Super+D."""
    with virtual_screen() as display, window_manager(display):
        yield display


class Kiosk:
    """PINEL in kiosk mode on a screen, with a database of its own."""

    def __init__(self, display: str, home: Path) -> None:
        self.home = home
        self._environment = os.environ | {
            "DISPLAY": display,
            "PINEL_HOME": str(home),
            "PINEL_LANG": "en",
        }
        self._started: list[subprocess.Popen[bytes]] = []
        self.watchdog = self.start("--kiosk")

    def start(self, *arguments: str) -> "subprocess.Popen[bytes]":
        process = subprocess.Popen(
            [sys.executable, "-m", "pinel_desktop", *arguments],
            env=self._environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        self._started.append(process)
        return process

    def processes(self) -> list[psutil.Process]:
        found = []
        for process in psutil.process_iter():
            try:
                if process.environ().get("PINEL_HOME") == str(self.home):
                    found.append(process)
            except psutil.Error:  # ended meanwhile, or of another user
                continue
        return found

    def process(self, command: str) -> psutil.Process | None:
        """The process whose command line has this part."""
        for process in self.processes():
            try:
                if command in " ".join(process.cmdline()):
                    return process
            except psutil.Error:
                continue
        return None

    def page(self) -> Browser:
        """A browser on the page of the running app."""
        tab: Browser = wait_for(self._tab, "the app")
        return tab

    def _tab(self) -> Browser | None:
        """None while no app answers: the file of one that was killed stays for a moment."""
        try:
            known = json.loads((self.home / "pinel.instance.json").read_text("utf-8"))
            link = RunningInstance(known["url"], known["secret"], known["pid"]).fresh_link()
            return Browser.signed_in(link)
        except (OSError, ValueError, PinelError):
            return None

    def wait_until_open(self) -> None:
        """Waits until the process of the page runs and the app answers."""
        wait_for(lambda: self.process("WebKitWebProcess"), "the page's process")
        self.page()

    def end(self) -> None:
        """Ends whatever still runs."""
        for process in self._started:
            process.terminate()
            process.wait(60)
        for left in self.processes():
            with contextlib.suppress(psutil.Error):
                left.kill()


def wait_for(get: Callable[[], Any], what: str) -> Any:
    """Polls until `get` returns something."""
    deadline_s = time.monotonic() + _WITHIN_S
    while not (found := get()):
        assert time.monotonic() < deadline_s, what
        time.sleep(0.1)
    return found


@pytest.fixture
def kiosk(screen: str, tmp_path: Path) -> Iterator[Kiosk]:
    kiosk = Kiosk(screen, tmp_path)
    try:
        kiosk.wait_until_open()
        yield kiosk
    finally:
        kiosk.end()


@pytest.mark.timeout(600)
def test_no_key_and_no_click_leads_out_of_kiosk_mode(screen: str) -> None:
    probe = str(Path(__file__).with_name("kiosk_probe.py"))
    done = subprocess.run(
        [sys.executable, probe],
        env=os.environ | {"DISPLAY": screen},
        capture_output=True,
        text=True,
        timeout=500,  # 61 attempts on a busy PC
        check=False,
    )
    found = json.loads(done.stdout.splitlines()[-1])
    assert "error" not in found, found
    assert found["escaped"] == []
    assert found["tried"] > 60
    assert len(found["windows"]) == 1
    assert re.search(r"X=0\s+Y=0\s+WIDTH=1366\s+HEIGHT=768", found["geometry"])
    assert found["places"] == ["/here"]
    assert found["printed"], "the teacher can print"


@pytest.mark.timeout(300)
def test_the_teacher_closes_pinel_and_nothing_stays(kiosk: Kiosk) -> None:
    tab = kiosk.page()
    assert tab.get("/api/kiosk").data["is_by_command"] is True
    tab.put("/api/teacher/pin", _PIN)
    pupil = kiosk.page()
    assert pupil.post("/api/kiosk/leave", {}).error["code"] == "teacher_only"
    assert tab.post("/api/kiosk/leave", {}).status == 200
    assert kiosk.watchdog.wait(60) == 0
    wait_for(lambda: not kiosk.processes(), "all processes end")


@pytest.mark.timeout(300)
def test_the_switch_changes_the_mode_of_the_open_window(screen: str, tmp_path: Path) -> None:
    kiosk = Kiosk(screen, tmp_path)
    try:
        wait_for(lambda: kiosk.process("pinel_desktop kiosk"), "the locked window")
        kiosk.watchdog.terminate()
        kiosk.watchdog.wait(60)
        ordinary = kiosk.start()
        kiosk.wait_until_open()
        tab = kiosk.page()
        tab.put("/api/teacher/pin", _PIN)
        assert tab.put("/api/kiosk", {"is_chosen": True}).data["is_active"] is False
        wait_for(lambda: kiosk.process("kiosk --reason setting"), "the locked window")
        wait_for(lambda: kiosk.process("WebKitWebProcess"), "the page")
        tab = kiosk.page()
        tab.post("/api/teacher/enter", _PIN)
        assert tab.put("/api/kiosk", {"is_chosen": False}).data["is_active"] is True
        wait_for(lambda: not kiosk.process("kiosk --reason"), "the ordinary window")
        kiosk.wait_until_open()
        assert ordinary.poll() is None, "it is the same process for whoever has started it"
        ordinary.send_signal(signal.SIGTERM)
        assert ordinary.wait(60) == 0
    finally:
        kiosk.end()


_PROCESSES = [
    "pinel_desktop kiosk",
    "pinel_desktop --kiosk",
    "pinel_desktop app",
    "pinel_desktop engine",
    "WebKitWebProcess",
    "WebKitNetworkProcess",
]
_ON_DEMAND = ["pinel_desktop camera", "pinel_desktop judge"]


@pytest.mark.timeout(600)
@pytest.mark.parametrize("command", _PROCESSES)
def test_each_process_that_is_killed_comes_back(kiosk: Kiosk, command: str) -> None:
    work = Work(kiosk)
    kill(kiosk, command)
    work.check_that_it_is_there()


@pytest.mark.nightly
@pytest.mark.timeout(3600)
@pytest.mark.parametrize("command", [*_PROCESSES, *_ON_DEMAND])
def test_each_process_comes_back_20_times_of_20(kiosk: Kiosk, command: str) -> None:
    work = Work(kiosk)
    for n in range(20):
        if command in _ON_DEMAND:
            work.need(command)
        wait_for(lambda: is_settled(kiosk, command), command)
        kill(kiosk, command)
        work.check_that_it_is_there()
        print(f"{command}: back {n + 1} of 20", flush=True)
    work.need("pinel_desktop judge")


def is_settled(kiosk: Kiosk, command: str) -> bool:
    """Whether a process runs for so long that its end is none of a failed start (processes/supervisor.py)."""
    process = kiosk.process(command)
    return process is not None and time.time() - process.create_time() > _SETTLED_S


def kill(kiosk: Kiosk, command: str) -> None:
    """Kills a process, and waits until there is another of its kind."""
    killed = wait_for(lambda: kiosk.process(command), command)
    killed.kill()
    wait_for(lambda: (now := kiosk.process(command)) and now.pid != killed.pid, "it comes back")


class Work:
    """A group's program in a kiosk, which is to outlive each kill."""

    def __init__(self, kiosk: Kiosk) -> None:
        self._kiosk = kiosk
        tab = kiosk.page()
        self._group = tab.post("/api/groups", {"name": "Tatus"}).data["id"]
        made = tab.post(f"/api/groups/{self._group}/programs", {"name": "square"})
        self._program = made.data["id"]
        content = {"workspace": {}, "document": SQUARE, "setup": MISSION}
        saved = tab.post(f"/api/programs/{self._program}/versions", content)
        self._version = saved.data["id"]

    def check_that_it_is_there(self) -> None:
        self._kiosk.wait_until_open()
        tab = self._kiosk.page()
        assert [one["id"] for one in tab.get("/api/groups").data["groups"]] == [self._group]
        version = tab.get(f"/api/programs/{self._program}").data["version"]
        assert (version["id"], version["document"]) == (self._version, SQUARE)
        wait_for(lambda: self._kiosk.process("pinel_desktop kiosk"), "the locked window")

    def need(self, command: str) -> None:
        """Uses a process that starts late: prepares the camera, or lets a run be judged."""
        tab = self._kiosk.page()
        if command.endswith("camera"):
            assert tab.post("/api/camera/wake").status == 200
            return
        wait_for(lambda: tab.get("/api/status").data["engine"] == "ready", "the engine")
        started = {"version_id": self._version, "world": "empty_room", "speed": 10.0}
        run = tab.post("/api/runs", started).data["id"]
        wait_for(lambda: tab.get(f"/api/runs/{run}").data["passed"] is not None, "the verdict")
        assert tab.get(f"/api/runs/{run}").data["passed"]
