"""The app's process, for real: start, requests for addresses, and its end at the end of the pipe."""

import os
import signal
import threading
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest

from pinel_desktop.desktop.app_process import AppProcess
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import AlreadyRunningError, InstanceLock
from tests.web.browser import Browser


class Behind:
    """One app with the lock that the window's process would hold."""

    def __init__(self, database: Path) -> None:
        self.shown, self.lost = threading.Event(), threading.Event()
        self.lock = InstanceLock(database)
        self.lock.acquire()
        self.requests: list[str] = []
        self.presented: list[str | None] = []
        self.app = AppProcess(
            database, on_request=self._handle, on_lost=self.lost.set, on_present=self._present
        )

    def _present(self, address: str | None) -> bool:
        self.presented.append(address)
        return address is not None

    def _handle(self, request: str) -> None:
        self.requests.append(request)
        if request == "show":
            self.shown.set()

    def close(self) -> None:
        self.app.close()
        self.lock.release()


@pytest.fixture
def database(tmp_path: Path) -> Path:
    return tmp_path / "pinel.db"


@pytest.fixture
def behind(database: Path) -> Iterator[Behind]:
    behind = Behind(database)
    yield behind
    behind.close()


def fetch(address: str) -> int:
    opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
    try:
        with opener.open(address, timeout=20) as answer:
            return int(answer.status)
    except urllib.error.HTTPError as error:
        error.close()
        return error.code


def test_each_address_opens_the_page_once(behind: Behind) -> None:
    behind.app.start()
    first, second = behind.app.address(), behind.app.address()
    assert [fetch(first), fetch(second), fetch(first)] == [200, 200, 401]


def test_nothing_is_touched_before_the_start(behind: Behind, database: Path) -> None:
    behind.app.close()
    assert not database.exists()


def test_a_second_start_finds_it_and_asks_for_the_window(behind: Behind, database: Path) -> None:
    behind.app.start()
    behind.app.language()
    with pytest.raises(AlreadyRunningError) as second:
        InstanceLock(database).acquire()
    second.value.running.show()
    assert behind.shown.wait(10)


def test_the_window_is_asked_to_present_runs_at_an_address_of_their_own(behind: Behind) -> None:
    behind.app.start()
    behind.app.language()
    page = Browser.signed_in(behind.app.address())
    assert page.put("/api/projector", {"runs": ["r1", "r2"]}).data == {"has_window": True}
    assert page.delete("/api/projector").status == 200
    address, end = behind.presented
    assert end is None
    assert address is not None
    link, _, place = address.partition("#")
    assert place == "/present/second/r1/r2"
    assert fetch(link) == 200


def test_the_window_presents_a_program_too(behind: Behind) -> None:
    behind.app.start()
    behind.app.language()
    page = Browser.signed_in(behind.app.address())
    assert page.put("/api/projector", {"program": "p1"}).data == {"has_window": True}
    (address,) = behind.presented
    assert address is not None
    assert address.endswith("#/present/second/program/p1")


@pytest.mark.parametrize(
    "asked",
    [
        {"runs": []},
        {"runs": ["r1", "r2", "r3"]},
        {"runs": ["../teacher"]},
        {"runs": ["r1?x"]},
        {"program": "../teacher"},
        {"runs": ["r1"], "program": "p1"},
    ],
)
def test_only_runs_or_a_program_are_presented(behind: Behind, asked: dict[str, object]) -> None:
    behind.app.start()
    behind.app.language()
    page = Browser.signed_in(behind.app.address())
    assert page.put("/api/projector", asked).status == 422
    assert behind.presented == []


def test_the_end_leaves_no_trace_of_a_running_app(behind: Behind, database: Path) -> None:
    behind.app.start()
    behind.app.language()
    behind.app.close()
    assert not list(database.parent.glob("*.instance.json"))
    assert not behind.lost.is_set()


@pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGKILL], ids=["SIGTERM", "SIGKILL"])
def test_an_app_that_dies_is_reported_and_waits_for_nobody(
    behind: Behind, how: signal.Signals
) -> None:
    behind.app.start()
    behind.app.language()
    os.kill(behind.app.pid, how)
    assert behind.lost.wait(20)
    with pytest.raises(PinelError, match="app_lost"):
        behind.app.address()
    assert behind.app.failure is not None


def test_why_it_cannot_start_reaches_the_window(
    database: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PINEL_HOME", str(tmp_path))
    monkeypatch.setattr(
        "pinel_desktop.desktop.app_process.own_command", lambda *_: ["/bin/sh", "-c", _FAILING]
    )
    behind = Behind(database)
    behind.app.start()
    try:
        with pytest.raises(PinelError, match="port_taken"):
            behind.app.language()
        assert behind.lost.wait(10)
    finally:
        behind.close()


_FAILING = """read start; echo '{"type": "failed", "code": "port_taken", "params": {"port": 1}}'"""
