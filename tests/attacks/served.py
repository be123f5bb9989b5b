"""A real `pinel serve` on its own folder, whose processes a test may freeze and kill."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psutil

from tests.attacks.damage import wait_until
from tests.compatibility.school_day import PcClient
from tests.e2e.app_process import AppProcess
from tests.web.browser import Browser

WAIT_S = 90.0  # a busy PC of two cores
PIN = "314159"


class ServedPc:
    """A PC at which a group works on a mission; `start`, and end it with `kill` or `stop`."""

    def __init__(self, home: Path) -> None:
        self.app = AppProcess(home)
        self.client = PcClient(Browser("", 0))

    def start(self) -> None:
        self.client = PcClient(Browser.signed_in(self.app.start()))

    def stop(self) -> None:
        self.app.stop()

    def kill(self) -> None:
        self.app.kill()

    @property
    def process(self) -> psutil.Process:
        return psutil.Process(self.app.pid)

    def child(self, name: str) -> psutil.Process:
        """The process of that name which the app owns now; waits until there is one."""
        until(lambda: any(self._children(name)))
        return next(self._children(name))

    def _children(self, name: str) -> Iterator[psutil.Process]:
        for child in self.process.children():
            try:
                if child.cmdline()[-1:] == [name]:
                    yield child
            except psutil.Error:  # it has ended meanwhile
                continue

    def program(self, activity: str) -> str:
        """A program of a group whose lesson is about the activity."""
        do = self.client.do
        do("PUT", "teacher/pin", {"pin": PIN})
        classroom = do("POST", "classrooms", {"name": "9º A"})["id"]
        lesson = {"title": "Aula 1", "activity": activity}
        do("POST", f"classrooms/{classroom}/lessons", lesson)
        return self.client.program(self.client.group("Onças", classroom), "Quadrado")

    def begins(self, program: str, document: dict[str, Any], **options: Any) -> str:
        version = self.client.save(program, {"workspace": {}, "document": document})
        body = {"version_id": version, "world": "empty_room", **options}
        return str(self.client.do("POST", "runs", body)["id"])

    def ends(self, run: str) -> None:
        """Waits for its end, which is on disk then."""
        until(lambda: self.run(run)["state"] != "running")

    def run(self, run: str) -> dict[str, Any]:
        found: dict[str, Any] = self.client.do("GET", f"runs/{run}")
        return found

    def is_judged(self, run: str) -> bool:
        return self.run(run)["passed"] is not None

    @contextmanager
    def frozen_judge(self) -> Iterator[None]:
        """The judge stands still from here on, and ends after."""
        judge = self.child("judge")
        judge.suspend()
        try:
            yield
        finally:
            judge.kill()
            judge.wait(WAIT_S)

    def kill_judges_until(self, done: Callable[[], bool]) -> None:
        """Each that starts dies."""
        while not done():
            for judge in self._children("judge"):
                judge.kill()
            time.sleep(0.01)


def until(is_so: Callable[[], bool]) -> None:
    """Looks again and again; fails after `WAIT_S`."""
    wait_until(is_so, WAIT_S)
