"""`GET /classify_stream` of a real app: how long a capture takes, who shares it, and one that begins late."""

import threading
import time
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.camera.landmark_sequence import write_landmark_sequence
from pinel_desktop.robot.robot_profile import BridgeProfile
from pinel_desktop.web.legacy import streams
from pinel_desktop.web.legacy.api import BridgeChoice
from pinel_desktop.web.legacy.open_run import OpenRun
from pinel_desktop.web.legacy.run_store import Commands
from tests.in_time import in_time
from tests.links.aurora import Aurora, free_port
from tests.test_app_legacy import (
    RECORDINGS,
    SIDE,
    WAIT_S,
    Bridged,
    Client,
    next_picture,
    pictures_of,
    until,
)

pytestmark = pytest.mark.waits

B = RECORDINGS / "b.npz"
PAGE_S = 10.0  # so long the page of the original shows the stream

OpenApp = Callable[..., tuple[str, Bridged]]


@pytest.fixture
def nobody(tmp_path: Path) -> Path:
    """A camera that sees no hand."""
    recording = tmp_path / "nobody.npz"
    write_landmark_sequence(recording, [None] * 30)
    return recording


@pytest.fixture
def open_app(tmp_path: Path) -> Iterator[OpenApp]:
    """Opens an app with the camera; returns the bridge's address too."""
    with ExitStack() as stack:

        def open_(camera: Path, robot: str = "sim") -> tuple[str, Bridged]:
            choice = BridgeChoice(BridgeProfile(port=free_port()), robot)
            app = stack.enter_context(App(tmp_path / "pinel.db", bridge=choice, camera=str(camera)))
            address = app.wait_for_bridge()
            assert address
            return address, Bridged(app)

        yield open_


def whole(address: str) -> tuple[float, list[bytes]]:
    """How long a stream takes to its end, and its pictures."""
    start_s, pictures = time.monotonic(), []
    with urllib.request.urlopen(f"{address}/classify_stream", timeout=WAIT_S) as stream:
        while picture := next_picture(stream):
            pictures.append(picture)
    return time.monotonic() - start_s, pictures


def last_result(address: str) -> Any:
    status, answer = Client(address).get("/get_last_gesture_result")
    assert status == 200
    return answer["resultado"]


def n_recorded_captures(bridged: Bridged) -> int:
    """In the program of the only run."""
    (group,) = bridged.browser.get("/api/groups").data["groups"]
    (run,) = bridged.browser.get(f"/api/groups/{group['id']}/runs").data["runs"]
    commands = bridged.recorded_run(run["id"])["version"]["document"]["commands"]
    return [one["action"] for one in commands].count("classify_gestures")


def test_without_a_sign_a_capture_ends_in_time_and_shows_that_nothing_was_recognised(
    open_app: OpenApp, nobody: Path
) -> None:
    address, _ = open_app(nobody)
    took_s, pictures = whole(address)
    assert in_time(took_s, PAGE_S)
    assert last_result(address) == ""
    assert pictures[0] != pictures[-1] == pictures[-2]  # the notice, then the result


def test_two_streams_are_one_capture_with_two_who_watch(open_app: OpenApp, nobody: Path) -> None:
    address, bridged = open_app(nobody)
    first, firsts = bridged.in_background(lambda: whole(address))
    until(lambda: bridged.live_run() is not None)
    second_s, _ = whole(address)
    first.join()
    (first_s, _) = firsts[0]
    assert in_time(first_s, PAGE_S)
    assert in_time(second_s, PAGE_S)
    assert last_result(address) == ""
    bridged.stop()
    assert n_recorded_captures(bridged) == 1


def test_a_capture_that_nobody_watches_any_more_ends_soon(open_app: OpenApp, nobody: Path) -> None:
    address, _ = open_app(nobody)
    pictures_of(address, 1)
    left_s = time.monotonic()
    until(lambda: last_result(address) == "")
    assert in_time(time.monotonic() - left_s, 5.0)


def test_a_call_during_a_capture_waits_for_its_end_and_one_for_a_capture_has_its_result(
    open_app: OpenApp,
) -> None:
    address, bridged = open_app(B)
    watching, _ = bridged.in_background(lambda: whole(address))
    until(lambda: bridged.live_run() is not None)
    assert Client(address).post("/classify_gestures", {}) == (200, {"result": "B"})
    assert Client(address).execute(SIDE) == {"status": "ok", "n_executed": 1}
    watching.join()
    bridged.stop()
    assert n_recorded_captures(bridged) == 1


def test_a_call_while_a_capture_is_just_beginning_waits_for_it(
    open_app: OpenApp, monkeypatch: pytest.MonkeyPatch
) -> None:
    send, begins = OpenRun._send, threading.Event()

    def send_late(run: OpenRun, commands: Commands) -> None:
        begins.set()
        time.sleep(0.5)
        send(run, commands)

    monkeypatch.setattr(OpenRun, "_send", send_late)
    address, bridged = open_app(B)
    watching, _ = bridged.in_background(lambda: whole(address))
    assert begins.wait(WAIT_S)
    assert Client(address).post("/classify_gestures", {}) == (200, {"result": "B"})
    watching.join()
    bridged.stop()
    assert n_recorded_captures(bridged) == 1


def test_a_capture_that_begins_late_has_its_result_for_the_page_that_asks(
    open_app: OpenApp,
) -> None:
    """The robot comes when the page has taken the stream away."""
    address, bridged = open_app(B, robot="bridge")
    whole(address)
    asking, results = bridged.in_background(lambda: last_result(address))
    aurora = Aurora(bridged.port)
    asking.join()
    bridged.stop()
    aurora.close()
    assert results == ["B"]


def test_a_capture_whose_robot_never_comes_is_given_up(
    open_app: OpenApp, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(streams, "_START_S", 1.0)
    address, bridged = open_app(B, robot="bridge")
    whole(address)
    assert last_result(address) is None
    until(lambda: bridged.live_run() is None)
    (group,) = bridged.browser.get("/api/groups").data["groups"]
    (run,) = bridged.browser.get(f"/api/groups/{group['id']}/runs").data["runs"]
    recorded = bridged.recorded_run(run["id"])
    assert (recorded["state"], recorded["reason"]) == ("stopped", "caller_left")
