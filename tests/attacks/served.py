"""A real `pinel serve` on its own folder, whose processes a test may freeze and kill."""

import socket
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import psutil

from tests.attacks.damage import wait_until
from tests.compatibility.school_day import PcClient
from tests.e2e.app_process import AppProcess
from tests.web.browser import ApiResponse, Browser

WAIT_S = 90.0  # a busy PC of two cores
PIN = "314159"
_BUSY_S = 1.0


class RetryingBrowser(Browser):
    """Asks again where the connection was cut, as a person does who sees that nothing happened."""

    def send(self, *request: Any, **options: Any) -> ApiResponse:
        answers: list[ApiResponse] = []

        def has_answered() -> bool:
            with suppress(ConnectionError):
                answers.append(super(RetryingBrowser, self).send(*request, **options))
            return bool(answers)

        until(has_answered)
        return answers[0]


class ServedPc:
    """A PC at which a group works on a mission; `start`, and end it with `kill` or `stop`."""

    def __init__(self, home: Path, *, open_files: int | None = None) -> None:
        self.app = AppProcess(home, open_files=open_files)
        self.client = PcClient(Browser("", 0))

    def start(self) -> None:
        browser = Browser.signed_in(self.app.start())
        self.client = PcClient(RetryingBrowser(browser.host, browser.port, browser.headers))

    def stop(self) -> None:
        self.app.stop()

    def kill(self) -> None:
        self.app.kill()

    @property
    def port(self) -> int:
        return self.client.browser.port

    @property
    def process(self) -> psutil.Process:
        return psutil.Process(self.app.pid)

    def n_connections(self) -> int:
        """That the app has accepted and not closed."""
        return len(self.process.net_connections())

    def share_of_processor(self) -> float:
        """Its processor time, per second that the test itself is busy: 1 for a loop without end, on any PC."""
        before, end_s = _cpu_s(self.process), time.process_time() + _BUSY_S
        while time.process_time() < end_s:
            continue
        return (_cpu_s(self.process) - before) / _BUSY_S

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

    @contextmanager
    def begins_to_listen(self) -> Iterator[None]:
        """One more event stream of the page, which may have to wait for an answer."""
        browser = self.client.browser
        head = "".join(f"{name}: {value}\r\n" for name, value in browser.headers.items())
        address = (browser.host, browser.port)
        with socket.create_connection(address, WAIT_S) as client:
            asked = f"GET /api/stream HTTP/1.1\r\nHost: {address[0]}:{address[1]}\r\n{head}\r\n"
            client.sendall(asked.encode())
            yield

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


def _cpu_s(process: psutil.Process) -> float:
    used = process.cpu_times()
    return float(used.user + used.system)


def until(is_so: Callable[[], bool]) -> None:
    """Looks again and again; fails after `WAIT_S`."""
    wait_until(is_so, WAIT_S)
