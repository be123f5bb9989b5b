"""The HTTP interface of the original, used by a client that knows the contract only; every real part behind it."""

import http.client
import json
import threading
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from pinel_desktop.app import App
from pinel_desktop.robot.robot_profile import BridgeProfile
from pinel_desktop.runs.verification import verify_run
from pinel_desktop.web.legacy import open_run
from pinel_desktop.web.legacy.api import BridgeChoice
from tests.links.aurora import free_port
from tests.live_runs import command
from tests.web.browser import Browser

WAIT_S = 60.0
RECORDINGS = Path(__file__).parent / "camera" / "recordings"
SIDE = {"action": "move_forward", "distance": 0.1}
CORNER = {"action": "turn", "angle": -90}
FAR = [{"action": "move_forward", "distance": 3}]


def until(is_so: Callable[[], bool]) -> None:
    """Waits for it."""
    due_s = time.monotonic() + WAIT_S
    while not is_so():
        assert time.monotonic() < due_s
        time.sleep(0.02)


class Client:
    """Posts commands and reads answers, as the original's page does."""

    def __init__(self, address: str) -> None:
        self._address = address

    def post(self, path: str, document: object, **headers: str) -> tuple[int, Any]:
        return self._ask(path, json.dumps(document).encode(), headers)

    def get(self, path: str) -> tuple[int, Any]:
        return self._ask(path, None)

    def execute(self, *commands: object) -> Any:
        status, answer = self.post("/execute", list(commands))
        assert status == 200, answer
        return answer

    def as_page(self, path: str, *commands: object) -> Any:
        """As `post`, by a web page of this PC."""
        status, answer = self.post(path, list(commands), Origin="http://localhost:8000")
        assert status == 200, answer
        return answer

    def _ask(
        self, path: str, body: bytes | None, more: Mapping[str, str] | None = None
    ) -> tuple[int, Any]:
        headers = {"Content-Type": "application/json", **(more or {})}
        request = urllib.request.Request(self._address + path, body, headers)
        try:
            with urllib.request.urlopen(request, timeout=WAIT_S) as answer:
                return answer.status, json.load(answer)
        except urllib.error.HTTPError as refused:
            return refused.code, json.load(refused)


class Bridged:
    """A running app with its bridge, a client of it, and the app's page."""

    def __init__(self, app: App) -> None:
        self.app = app
        address = app.wait_for_bridge()
        assert address
        self.port = int(address.rpartition(":")[2])
        self.client, self.browser = Client(address), Browser.signed_in(app.address)

    def live_run(self) -> str | None:
        run: str | None = self.browser.get("/api/status").data["run"]
        return run

    @staticmethod
    def in_background(work: Callable[[], Any]) -> tuple[threading.Thread, list[Any]]:
        """A thread that does it, and where it puts its answer."""
        answers: list[Any] = []
        thread = threading.Thread(target=lambda: answers.append(work()))
        thread.start()
        return thread, answers

    def sign(self, letter: str, work: Callable[[], Any]) -> Any:
        """What a call answers whose capture a person answers on the page."""
        thread, answers = self.in_background(work)
        while thread.is_alive():
            if run := self.live_run():
                command(self.browser, run, "answer_capture", result=letter)
            thread.join(0.05)
        return answers[0]

    def recorded_run(self, run: str) -> dict[str, Any]:
        """The record of a run that has ended or will soon, with its program, which is written a moment later."""
        until(lambda: self._read(run)["state"] != "running" and self._read(run)["version"])
        return self._read(run)

    def _read(self, run: str) -> dict[str, Any]:
        found: dict[str, Any] = self.browser.get(f"/api/runs/{run}").data
        return found

    def stop(self) -> None:
        """As the page's button does."""
        if run := self.live_run():
            command(self.browser, run, "stop")
        until(lambda: self.live_run() is None)


@pytest.fixture(scope="module")
def app(tmp_path_factory: pytest.TempPathFactory) -> Iterator[App]:
    choice = BridgeChoice(BridgeProfile(port=free_port()))
    database = tmp_path_factory.mktemp("data") / "pinel.db"
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("PINEL_LANG", "en")
        with App(database, bridge=choice, camera="9") as running:
            yield running


@pytest.fixture
def bridged(app: App) -> Iterator[Bridged]:
    it = Bridged(app)
    yield it
    it.stop()


def test_calls_that_follow_one_another_are_one_run_that_can_be_repeated(bridged: Bridged) -> None:
    """Experiment 4: classify; if B drive the square, classify again, if A drive the triangle; all in calls."""
    client = bridged.client
    square = {
        "action": "conditional_execution",
        "condition": 'resultado == "B"',
        "commands": [SIDE, CORNER] * 4,
    }
    triangle = {
        "action": "conditional_execution",
        "condition": "result == 'A'",
        "commands": [SIDE, {"action": "turn", "angle": 120}] * 3,
    }
    assert client.get("/get_last_gesture_result") == (200, {"resultado": None})
    classify = {"action": "classificar_gestos", "status": "pending"}
    assert bridged.sign("B", lambda: client.execute(classify)) == {"status": "ok", "n_executed": 1}
    run = bridged.live_run()
    assert run
    command(bridged.browser, run, "speed", factor=10)
    assert client.get("/get_last_gesture_result") == (200, {"resultado": "B"})
    assert client.execute(triangle, square) == {"status": "ok", "n_executed": 8}
    answer = bridged.sign("A", lambda: client.post("/classify_gestures", {}))
    assert answer == (200, {"result": "A"})
    assert client.execute(square) == {"status": "ok", "n_executed": 0}
    assert client.execute(triangle) == {"status": "ok", "n_executed": 6}
    for one in (SIDE, CORNER):
        assert client.execute(one) == {"status": "ok", "n_executed": 1}
    assert client.execute() == {"status": "ok", "n_executed": 0}
    assert bridged.live_run() == run
    bridged.stop()
    _check_record(bridged, run, [classify, triangle, square, classify, square, triangle, SIDE])


def _check_record(bridged: Bridged, run_id: str, commands: list[dict[str, Any]]) -> None:
    """The page lists and replays it as any other; it is verified with the whole program."""
    shown = bridged.recorded_run(run_id)
    listed = bridged.browser.get(f"/api/groups/{shown['group_id']}/runs").data["runs"]
    assert listed[0]["id"] == run_id
    assert (shown["state"], shown["program_name"], shown["n_executed"]) == (
        "finished",
        "HTTP bridge",
        18,
    )
    assert shown["version"]["workspace"]["document"] == shown["version"]["document"]
    actions = [one["action"] for one in shown["version"]["document"]["commands"]]
    assert actions[:-1] == [
        one["action"].replace("classificar_gestos", "classify_gestures") for one in commands
    ]
    store = bridged.app._store
    assert verify_run(store, store.runs.get(run_id)).outcome == "identical"


def test_nothing_moves_for_a_call_with_faults(bridged: Bridged) -> None:
    client = bridged.client
    broken = [SIDE, {"action": "fly"}, {"action": "move_forward", "distance": -1}]
    status, answer = client.post("/execute", broken)
    assert status == 422
    faults = answer["error"]["faults"]
    assert [(one["code"], one["pointer"]) for one in faults] == [
        ("unknown_action", "/1"),
        ("distance_out_of_range", "/2/distance"),
    ]
    assert all(one["message"] and one["remedy"] for one in faults)
    for body, code in (
        (b'[{"action": "move_forward", "distance": NaN}]', "invalid_program"),
        (b'[{"action": "move_forward"', "invalid_program"),
        (b"\xff\x00", "invalid_program"),
        (b"[" * 50_000, "invalid_program"),
        (b'"move_forward"', "invalid_program"),
        (b'{"pinel_ir": 1, "commands": []}', "bridge_list_needed"),
    ):
        status, answer = client._ask("/execute", body)
        assert (status, answer["error"]["code"]) == (422, code)
    assert client._ask("/execute", b" " * (2**20 + 1))[0] == 413
    assert client.get("/execute")[0] == 405
    assert bridged.live_run() is None


def test_one_call_at_a_time_and_a_stopped_one_says_so(bridged: Bridged) -> None:
    client = bridged.client
    thread, answers = bridged.in_background(lambda: client.execute(SIDE, *FAR))
    until(lambda: bridged.live_run() is not None)
    for path in ("/execute", "/classify_gestures"):
        status, answer = client.post(path, [SIDE])
        assert (status, answer["error"]["code"]) == (409, "bridge_busy")
    bridged.stop()
    thread.join()
    (answer,) = answers
    assert (answer["status"], answer["error"]["code"]) == ("stopped", "stopped_by_person")
    assert client.execute(SIDE) == {"status": "ok", "n_executed": 1}


def test_a_call_that_fails_says_why_and_the_next_one_begins_anew(bridged: Bridged) -> None:
    client = bridged.client
    client.execute({"action": "set_gesture_result", "result": "B"})
    unset = {"action": "move_forward", "distance": {"var": "side"}}
    answer = client.execute(SIDE, unset, SIDE)
    assert (answer["status"], answer["n_executed"]) == ("failed", 2)
    assert answer["error"]["code"] == "unset_variable"
    assert answer["error"]["remedy"]
    assert client.get("/get_last_gesture_result") == (200, {"resultado": "B"})
    assert client.execute(SIDE)["status"] == "ok"
    assert client.get("/get_last_gesture_result") == (200, {"resultado": "B"})


def test_a_page_reads_one_object_for_each_command(bridged: Bridged) -> None:
    client = bridged.client
    assert client.as_page("/execute", SIDE) == [{**SIDE, "status": "ok"}]
    sent = {"action": "set_gesture_result", "resultado": "B"}
    assert client.as_page("/execute", sent) == [{**sent, "status": "ok"}]
    result = bridged.sign("A", lambda: client.as_page("/execute", {"action": "classificar_gestos"}))
    assert result == [{"action": "classificar_gestos", "status": "ok", "resultado": "A"}]
    is_a = {"action": "conditional_execution", "condition": "resultado == 'A'", "commands": [SIDE]}
    unset = {"action": "move_forward", "distance": {"var": "side"}}
    done, broken, never = client.as_page("/execute", is_a, unset, SIDE)
    assert done == {"action": is_a["action"], "condition": is_a["condition"], "status": "ok"}
    assert (broken["status"], broken["error"]["code"]) == ("failed", "unset_variable")
    assert never == {**SIDE, "status": "not_executed"}
    assert client.as_page("/execute") == []


def test_after_a_stop_nothing_more_of_a_page_s_batch_is_driven(
    bridged: Bridged, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The page itself would go on with its next command."""
    client = bridged.client
    monkeypatch.setattr(open_run, "BATCH_END_TIMEOUT_S", 600.0)
    assert client.post("/bridge/run_start", None) == (200, {"ok": True})
    thread, answers = bridged.in_background(lambda: client.as_page("/execute", *FAR))
    until(lambda: bridged.live_run() is not None)
    bridged.stop()
    thread.join()
    assert [one["status"] for one in answers[0]] == ["stopped"]
    (refused,) = client.as_page("/execute", SIDE)
    assert (refused["status"], refused["error"]["code"]) == ("stopped", "stopped_by_person")
    assert bridged.live_run() is None
    for path in ("run_end", "run_end", "run_start"):
        assert client.post(f"/bridge/{path}", None) == (200, {"ok": True})
    assert client.as_page("/execute", SIDE)[0]["status"] == "ok"
    assert client.post("/bridge/run_end", None) == (200, {"ok": True})
    run = bridged.live_run()
    assert client.as_page("/execute", SIDE)[0]["status"] == "ok"
    assert bridged.live_run() == run


def test_soon_after_the_batch_of_a_page_its_run_has_finished(bridged: Bridged) -> None:
    client = bridged.client
    for path in ("run_start", "run_end", "run_start"):
        client.post(f"/bridge/{path}", None)
    thread, answers = bridged.in_background(lambda: client.as_page("/execute", SIDE))
    until(lambda: bridged.live_run() is not None)
    run = bridged.live_run()
    assert run
    client.post("/bridge/run_end", None)  # in the middle of a command: of no effect on it
    thread.join()
    assert answers == [[{**SIDE, "status": "ok"}]]
    client.post("/bridge/run_end", None)
    until(lambda: bridged.live_run() is None)
    recorded = bridged.recorded_run(run)
    assert (recorded["state"], recorded["reason"], recorded["n_executed"]) == ("finished", None, 1)


def test_a_caller_who_hangs_up_stops_the_robot(bridged: Bridged) -> None:
    caller = http.client.HTTPConnection("127.0.0.1", bridged.port)
    caller.request("POST", "/execute", json.dumps(FAR))
    until(lambda: bridged.live_run() is not None)
    run = bridged.live_run()
    caller.close()
    assert run
    recorded = bridged.recorded_run(run)
    assert (recorded["state"], recorded["reason"]) == ("stopped", "caller_left")
    store = bridged.app._store
    assert verify_run(store, store.runs.get(run)).outcome == "identical"


def test_after_a_minute_of_silence_the_run_has_finished(
    bridged: Bridged, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(open_run, "NEXT_CALL_TIMEOUT_S", 0.3)
    bridged.client.execute(SIDE)
    until(lambda: bridged.live_run() is None)
    group = next(
        one
        for one in bridged.browser.get("/api/groups").data["groups"]
        if one["name"] == "HTTP bridge"
    )
    newest = f"/api/groups/{group['id']}/runs"
    until(lambda: bridged.browser.get(newest).data["runs"][0]["state"] != "running")
    runs = bridged.browser.get(newest).data["runs"]
    assert (runs[0]["state"], runs[0]["n_executed"]) == ("finished", 1)


def test_without_a_camera_the_stream_says_so_and_a_person_can_answer(bridged: Bridged) -> None:
    client = bridged.client

    def watch_and_ask() -> Any:
        refused = client.get("/classify_stream?t=1")
        until(lambda: client.get("/get_last_gesture_result")[1]["resultado"] == "C")
        return refused

    client.execute({"action": "set_gesture_result", "result": "A"})
    status, answer = bridged.sign("C", watch_and_ask)
    assert (status, answer["error"]["code"]) == (503, "camera_missing")
    assert client.execute(SIDE)["status"] == "ok"
    assert client.get("/get_last_gesture_result") == (200, {"resultado": "C"})


def test_the_camera_answers_a_capture_while_its_picture_shows_the_hand_in_a_box(
    tmp_path: Path,
) -> None:
    choice = BridgeChoice(BridgeProfile(port=free_port()))
    with App(tmp_path / "pinel.db", bridge=choice, camera=str(RECORDINGS / "b.npz")) as app:
        address = app.wait_for_bridge()
        assert address
        watching, pictures = Bridged.in_background(lambda: pictures_of(address, 3))
        assert Client(address).post("/classify_gestures", {}) == (200, {"result": "B"})
        assert Client(address).get("/get_last_gesture_result") == (200, {"resultado": "B"})
        watching.join()
    for jpeg in pictures[0]:
        shown = cv2.imdecode(np.frombuffer(jpeg, np.uint8), cv2.IMREAD_COLOR).astype(int)
        blue, green, red = shown.transpose(2, 0, 1)
        assert np.count_nonzero((green > 120) & (red < 80) & (blue < 120)) > 300  # a sure sign


def test_the_stream_is_a_capture_that_ends_by_itself_and_keeps_its_result(
    tmp_path: Path,
) -> None:
    choice = BridgeChoice(BridgeProfile(port=free_port()))
    with App(tmp_path / "pinel.db", bridge=choice, camera=str(RECORDINGS / "b.npz")) as app:
        address = app.wait_for_bridge()
        assert address
        client = Client(address)
        assert client.get("/get_last_gesture_result") == (200, {"resultado": None})
        with urllib.request.urlopen(f"{address}/classify_stream?t=1", timeout=WAIT_S) as stream:
            whole = stream.read()  # to its end
        assert whole.count(b"--frame\r\n") > 1
        assert client.get("/get_last_gesture_result") == (200, {"resultado": "B"})
        assert client.execute({"action": "set_gesture_result", "resultado": "B"}, SIDE) == {
            "status": "ok",
            "n_executed": 2,
        }
        assert client.get("/get_last_gesture_result") == (200, {"resultado": "B"})
        # who watches while a call drives watches only
        bridged = Bridged(app)
        bridged.stop()  # the run of the calls before, so that the next live run is the drive's
        driving, answers = bridged.in_background(lambda: client.execute(*FAR))
        until(lambda: bridged.live_run() is not None)
        assert client.post("/execute", [SIDE])[0] == 409
        assert len(pictures_of(address, 2)) == 2
        bridged.stop()
        driving.join()
        assert answers[0]["status"] == "stopped"


def pictures_of(address: str, count: int) -> list[bytes]:
    """The first pictures of the stream."""
    with urllib.request.urlopen(f"{address}/classify_stream", timeout=WAIT_S) as stream:
        return [next_picture(stream) for _ in range(count)]


def next_picture(stream: Any) -> bytes:
    """b"" at the end of the stream."""
    if (boundary := stream.readline()) != b"--frame\r\n":
        assert boundary in (b"", b"--frame--\r\n")
        return b""
    assert stream.readline() == b"Content-Type: image/jpeg\r\n"
    length = int(stream.readline().partition(b":")[2])
    picture: bytes = stream.read(2 + length + 2)[2:-2]
    return picture
