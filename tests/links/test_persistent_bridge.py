"""The bridge that stands between runs: what it says by itself, and the routes that somebody else answers."""

import base64
import http.client
import json
import queue
import threading
from collections.abc import Iterator
from typing import Any

import pytest

from pinel_desktop.links.bridge.pending_requests import MAX_PENDING_PER_PATH, PendingRequests
from pinel_desktop.links.bridge.persistent_bridge import DelegatedRoute, PersistentBridge
from pinel_desktop.links.bridge.transport import BridgeTransport
from pinel_desktop.robot import Twist2D
from pinel_desktop.robot.robot_profile import BridgeProfile
from tests.links.aurora import free_port
from tests.links.test_bridge import POSE, Robot

pytestmark = pytest.mark.waits

WAIT_S = 20.0
HANDED = {"/execute": DelegatedRoute("POST", 1000), "/stream": DelegatedRoute("GET")}
LOCAL = {"Origin": "http://localhost:3000"}
FOREIGN = {"Origin": "http://evil.example"}


class BridgeHarness:
    """A standing bridge, and the owner who answers."""

    def __init__(
        self, *, key: str = "", hang_timeout_s: float = WAIT_S, file_pages: bool = False
    ) -> None:
        self.messages: queue.Queue[dict[str, Any]] = queue.Queue()
        self.pending = PendingRequests(self.messages.put, hang_timeout_s)
        self.profile = BridgeProfile(port=free_port(), key=key)
        self.bridge = PersistentBridge(
            self.profile, HANDED, self.pending.submit, file_pages=file_pages
        )
        self.bridge.start()

    def connect(self) -> http.client.HTTPConnection:
        return http.client.HTTPConnection("127.0.0.1", self.bridge.port, timeout=WAIT_S)

    def ask(
        self, method: str, path: str, body: str | None = None, **headers: str
    ) -> tuple[int, Any]:
        client = self.connect()
        client.request(method, path, body and body.encode(), headers)
        answer = client.getresponse()
        text = answer.read()
        client.close()
        return answer.status, json.loads(text) if text else dict(answer.headers)

    def respond_next(self, **answer: Any) -> None:
        def work() -> None:
            question = self.messages.get(timeout=WAIT_S)
            self.pending.settle({"question": question["question"], "status": 200, **answer})

        threading.Thread(target=work, daemon=True).start()

    def close(self) -> None:
        self.pending.close()
        self.bridge.close()


@pytest.fixture
def harness() -> Iterator[BridgeHarness]:
    it = BridgeHarness()
    yield it
    it.close()


def test_without_a_run_a_client_that_loops_stands_still(harness: BridgeHarness) -> None:
    status, velocity = harness.ask("GET", "/bridge/cmd_vel")
    assert (status, velocity["linear_x"], velocity["angular_z"]) == (200, 0.0, 0.0)
    assert harness.ask("POST", "/bridge/pose", json.dumps(POSE)) == (200, {"ok": True})
    assert harness.ask("GET", "/bridge/status") == (200, {"active": False})
    assert harness.ask("GET", "/other")[0] == 404


def test_the_status_tells_the_flag_of_the_page_also_across_runs(harness: BridgeHarness) -> None:
    active, inactive = (200, {"active": True}), (200, {"active": False})
    for _ in range(2):
        assert harness.ask("POST", "/bridge/run_start") == (200, {"ok": True})
        assert harness.ask("GET", "/bridge/status") == active
    transport = BridgeTransport(harness.profile)
    transport.open(Robot(), lambda: True)
    transport.close()
    assert harness.ask("GET", "/bridge/status") == active
    for _ in range(2):
        assert harness.ask("POST", "/bridge/run_end") == (200, {"ok": True})
        assert harness.ask("GET", "/bridge/status") == inactive


def test_a_call_tells_its_batch_and_whether_a_page_asks(harness: BridgeHarness) -> None:
    contexts = []
    for path in ("run_start", "run_start", "run_end"):
        harness.ask("POST", f"/bridge/{path}")
        client = harness.connect()
        client.request("POST", "/execute", "[]", LOCAL if path == "run_end" else {})
        question = harness.messages.get(timeout=WAIT_S)
        contexts.append((question["batch"], question["of_page"]))
        client.close()
        harness.messages.get(timeout=WAIT_S)  # withdrawn
    assert contexts == [(1, False), (2, False), (None, True)]


def test_a_run_at_its_address_uses_it_and_leaves_it_standing(harness: BridgeHarness) -> None:
    robot, transport = Robot(), BridgeTransport(harness.profile)
    transport.open(robot, lambda: True)
    transport.send(Twist2D(0.25, 0.0))
    assert harness.ask("GET", "/bridge/cmd_vel")[1]["linear_x"] == 0.25
    assert harness.ask("GET", "/bridge/status") == (200, {"active": True})
    harness.ask("POST", "/bridge/pose", json.dumps(POSE))
    assert len(robot.poses) == 1
    transport.close()
    assert harness.ask("GET", "/bridge/status") == (200, {"active": False})


def test_other_routes_are_handed_on_while_the_robot_is_answered(harness: BridgeHarness) -> None:
    answers: list[tuple[int, Any]] = []
    asking = threading.Thread(
        target=lambda: answers.append(harness.ask("POST", "/execute?a=1", '["é"]'))
    )
    asking.start()
    question = harness.messages.get(timeout=WAIT_S)
    assert (question["method"], question["path"]) == ("POST", "/execute")
    assert question["body"].encode("utf-8", "surrogateescape").decode() == '["é"]'
    assert harness.ask("GET", "/bridge/status")[0] == 200
    harness.pending.settle({"question": question["question"], "status": 409, "document": {"a": 1}})
    asking.join()
    assert answers == [(409, {"a": 1})]


def test_a_client_that_hangs_up_withdraws_its_question(harness: BridgeHarness) -> None:
    client = harness.connect()
    client.request("POST", "/execute", "[]")
    number = harness.messages.get(timeout=WAIT_S)["question"]
    client.close()
    assert harness.messages.get(timeout=WAIT_S) == {"type": "bridge_withdrawn", "question": number}
    harness.pending.settle({"question": number, "status": 200, "document": {}})  # too late


def test_an_owner_that_is_silent_is_not_waited_for() -> None:
    harness = BridgeHarness(hang_timeout_s=0.5)
    status, answer = harness.ask("POST", "/execute", "[]")
    assert (status, answer["error"]["code"]) == (504, "bridge_app_silent")
    assert harness.messages.get(timeout=WAIT_S)["type"] == "bridge_asked"
    assert harness.messages.get(timeout=WAIT_S)["type"] == "bridge_withdrawn"
    harness.close()


def test_so_many_questions_of_a_path_are_open_at_once_and_no_more(harness: BridgeHarness) -> None:
    clients = [harness.connect() for _ in range(MAX_PENDING_PER_PATH)]
    for client in clients:
        client.request("POST", "/execute", "[]")
        harness.messages.get(timeout=WAIT_S)
    status, answer = harness.ask("POST", "/execute", "[]")
    assert (status, answer["error"]["code"]) == (503, "bridge_too_many")
    harness.respond_next(document={})
    assert harness.ask("GET", "/stream")[0] == 200
    for client in clients:
        client.close()


def test_a_stream_asks_for_each_picture_until_nobody_watches(harness: BridgeHarness) -> None:
    client = harness.connect()
    for number in range(3):
        jpeg = base64.b64encode(b"picture %d" % number).decode()
        harness.respond_next(document=None, jpeg=jpeg)
        if number == 0:
            client.request("GET", "/stream")
            stream = client.getresponse()
            assert stream.headers["Content-Type"] == "multipart/x-mixed-replace; boundary=frame"
        assert stream.readline() == b"--frame\r\n"
        assert stream.readline() == b"Content-Type: image/jpeg\r\n"
        assert stream.readline() == b"Content-Length: 9\r\n"
        assert stream.read(2 + 9 + 2) == b"\r\npicture %d\r\n" % number
    question = harness.messages.get(timeout=WAIT_S)["question"]
    stream.close()
    client.close()
    assert harness.messages.get(timeout=WAIT_S) == {
        "type": "bridge_withdrawn",
        "question": question,
    }


def test_a_body_may_be_as_large_as_its_route_says(harness: BridgeHarness) -> None:
    harness.respond_next(document={})
    assert harness.ask("POST", "/execute", "a" * 1000)[0] == 200
    assert harness.ask("POST", "/execute", "a" * 1001)[0] == 413


def test_without_a_key_a_page_of_this_pc_may_ask_and_no_other(harness: BridgeHarness) -> None:
    status, headers = harness.ask("OPTIONS", "/execute", **LOCAL)
    assert (status, headers["Access-Control-Allow-Origin"]) == (204, LOCAL["Origin"])
    harness.respond_next(document={"a": 1})
    assert harness.ask("POST", "/execute", "[]", **LOCAL) == (200, {"a": 1})
    image = {"Sec-Fetch-Site": "cross-site", "Referer": "http://127.0.0.1:3000/page"}
    harness.respond_next(document={"a": 2})
    assert harness.ask("GET", "/stream", **image) == (200, {"a": 2})
    for headers in (
        FOREIGN,
        {"Origin": "null"},
        {"Sec-Fetch-Site": "cross-site"},
        {"Sec-Fetch-Site": "cross-site", "Referer": "http://evil.example/127.0.0.1"},
    ):
        for method in ("OPTIONS", "POST"):
            status, answer = harness.ask(method, "/execute", "[]", **headers)
            assert (status, answer["error"]["code"]) == (403, "bridge_page_foreign")
    status, answer = harness.ask("POST", "/execute", "[]", **LOCAL, Host="evil.example")
    assert (status, answer["error"]["code"]) == (403, "bridge_host_wrong")
    # the robot itself is no web page
    assert harness.ask("GET", "/bridge/cmd_vel", **LOCAL)[0] == 403
    assert harness.messages.empty()


PAGE_ROUTES = {
    "/bridge/run_start": "POST",
    "/bridge/run_end": "POST",
    "/bridge/status": "GET",
    "/execute": "POST",
    "/stream": "GET",
}
ROBOT_ROUTES = {"/bridge/cmd_vel": "GET", "/bridge/pose": "POST"}
FILE = {"Origin": "null", "Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "cors"}
FILE_PICTURE = {
    "Sec-Fetch-Site": "cross-site",
    "Sec-Fetch-Mode": "no-cors",
    "Sec-Fetch-Dest": "image",
}


def preflight(harness: BridgeHarness, path: str, page: dict[str, str]) -> tuple[int, str | None]:
    status, headers = harness.ask("OPTIONS", path, **page)
    return status, headers.get("Access-Control-Allow-Origin")


def test_a_page_of_this_pc_may_ask_all_routes_of_a_page(harness: BridgeHarness) -> None:
    for path, method in PAGE_ROUTES.items():
        assert preflight(harness, path, LOCAL) == (204, LOCAL["Origin"])
        assert preflight(harness, path, FILE)[0] == 403
        if path.startswith("/bridge/"):
            assert harness.ask(method, path, **LOCAL)[0] == 200
            assert harness.ask(method, path, **FILE)[0] == 403
            assert harness.ask(method, path, **FOREIGN)[0] == 403


def test_an_option_lets_in_pages_that_were_opened_as_a_file_and_no_site_by_its_name() -> None:
    harness = BridgeHarness(file_pages=True)
    for path in PAGE_ROUTES | ROBOT_ROUTES:
        assert preflight(harness, path, FILE) == (204, "null")
        assert preflight(harness, path, LOCAL) == (204, LOCAL["Origin"])
        assert preflight(harness, path, FOREIGN)[0] == 403
    assert harness.ask("POST", "/bridge/run_start", **FILE) == (200, {"ok": True})
    harness.respond_next(document={"a": 1})
    assert harness.ask("POST", "/execute", "[]", **FILE) == (200, {"a": 1})
    harness.respond_next(document={"a": 2})
    assert harness.ask("GET", "/stream?t=1", **FILE_PICTURE) == (200, {"a": 2})
    harness.close()


@pytest.mark.parametrize(
    ("method", "page"),
    [
        # a form, a link, or a frame of another site; it withholds its origin
        ("POST", {"Origin": "null", "Sec-Fetch-Mode": "navigate"}),
        ("GET", {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "navigate"}),
        # sent without asking whether it may
        ("POST", {"Origin": "null", "Sec-Fetch-Mode": "no-cors", "Sec-Fetch-Dest": "empty"}),
        # a browser that tells of a page of the internet that it is one
        ("OPTIONS", FILE | {"Access-Control-Request-Private-Network": "true"}),
        ("GET", FILE_PICTURE | {"Referer": "https://evil.example/"}),
    ],
)
def test_requests_that_no_page_opened_as_a_file_sends_are_refused(
    method: str, page: dict[str, str]
) -> None:
    harness = BridgeHarness(file_pages=True)
    path = "/stream" if method == "GET" else "/execute"
    status, answer = harness.ask(method, path, "[]", **page)
    assert (status, answer["error"]["code"]) == (403, "bridge_page_foreign")
    assert harness.messages.empty()
    harness.close()


def test_a_page_reads_why_it_is_refused(harness: BridgeHarness) -> None:
    client = harness.connect()
    for method, path, status in (("GET", "/execute", 405), ("GET", "/bridge/other", 404)):
        client.request(method, path, headers=LOCAL)
        answer = client.getresponse()
        answer.read()
        assert answer.status == status
        assert answer.headers["Access-Control-Allow-Origin"] == LOCAL["Origin"]
    client.close()


def test_with_a_key_any_page_that_has_it_may_ask() -> None:
    harness = BridgeHarness(key="k")
    assert harness.ask("OPTIONS", "/execute", **FOREIGN)[0] == 204
    assert harness.ask("POST", "/execute", "[]", **FOREIGN)[0] == 401
    assert harness.ask("POST", "/execute?key=l", "[]")[0] == 401
    harness.respond_next(document={})
    assert harness.ask("POST", "/execute?key=k", "[]", **FOREIGN)[0] == 200
    harness.respond_next(document={})
    assert harness.ask("POST", "/execute", "[]", **{"X-PINEL-Key": "k"}, **FOREIGN)[0] == 200
    for path, method in (PAGE_ROUTES | ROBOT_ROUTES).items():
        assert preflight(harness, path, FOREIGN) == (204, FOREIGN["Origin"])
        assert harness.ask(method, path, **FOREIGN)[0] == 401
    harness.close()


def test_a_tunnel_under_another_name_needs_the_key(harness: BridgeHarness) -> None:
    tunnel = {"Host": "a1b2.tunnel.example"}
    assert harness.ask("GET", "/bridge/cmd_vel", **tunnel)[0] == 403
    keyed = BridgeHarness(key="k")
    for path in ("/bridge/cmd_vel", "/bridge/status"):
        assert keyed.ask("GET", path, **tunnel)[0] == 401
        assert keyed.ask("GET", f"{path}?key=k", **tunnel)[0] == 200
    keyed.respond_next(document={"a": 1})
    assert keyed.ask("POST", "/execute?key=k", "[]", **tunnel) == (200, {"a": 1})
    keyed.close()
