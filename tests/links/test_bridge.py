"""The bridge, driven by a client that knows the original's HTTP contract only, and by clients that break it."""

import contextlib
import gc
import http.client
import json
import math
import socket
import threading
import time
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links.bridge import http_server as listening
from pinel_desktop.links.bridge.http_server import MAX_BODY_BYTES, MAX_CONNECTIONS, BridgeHttpServer
from pinel_desktop.links.bridge.routes import STATUS, Response
from pinel_desktop.links.bridge.transport import BridgeTransport
from pinel_desktop.links.real import RealLink
from pinel_desktop.links.transport import Localised, Odometry
from pinel_desktop.robot import STANDSTILL, SimulationConfig, Twist2D
from pinel_desktop.robot.robot_profile import BridgeProfile, RobotProfile, Room
from tests.in_time import in_time
from tests.links.aurora import Aurora, free_port
from tests.links.real_link_contract import Peer, RealLinkContract

pytestmark = pytest.mark.waits

ROOM = Room(width_m=20.0, depth_m=20.0)
POSE = {"x": 1.0, "y": 2.0, "yaw": 0.5}


class TestBridgeLink(RealLinkContract):
    link = "bridge"
    twist_error = 0.3  # of poses that come early or late on a busy PC

    def start_peer(self) -> tuple[Peer, RobotProfile]:
        record = BridgeProfile(port=free_port(), max_v_mps=1.2, max_omega_dps=300.0, room=ROOM)
        self.aurora = Aurora(record.port)
        return self.aurora, record

    def stop_peer(self) -> None:
        self.aurora.close()

    def test_no_client_hears_a_velocity_beyond_the_robot(self) -> None:
        self.drive(self.open(), Twist2D(50.0, -50.0), 0.5)
        velocities = [twist for _, twist in self.peer.received]
        assert max(twist.v_mps for twist in velocities) == 1.2
        assert min(twist.omega_radps for twist in velocities) >= -math.radians(300.0)

    def test_a_client_that_crashes_is_lost(self) -> None:
        run = self.start_run()
        self.wait_until_driving()
        self.aurora.kill()
        ended = run.result().ended
        assert (ended.state, ended.reason) == ("failed", "link_lost")

    def test_the_client_stops_by_itself_when_the_run_is_over(self) -> None:
        result = self.start_run([{"action": "move_forward", "distance": 0.3}]).result()
        assert result.ended.state == "finished", result.ended
        assert self.aurora.has_ended(within_s=10.0)


class Robot:
    """Receives what the bridge hands on."""

    def __init__(self) -> None:
        self.poses: list[Odometry] = []
        self.problems: list[PinelError] = []

    def on_odometry(self, odometry: Odometry) -> None:
        self.poses.append(odometry)

    def on_holder(self, name: str | None) -> None:
        pass

    def on_localised(self, localised: Localised) -> None:
        raise AssertionError("this robot has no localisation")

    def on_battery(self, level: float) -> None:
        raise AssertionError("no battery on the bridge")

    def on_problem(self, problem: PinelError) -> None:
        self.problems.append(problem)


class Bridge:
    """An open bridge on a free port, and requests to it."""

    def __init__(self, **record: Any) -> None:
        self.robot = Robot()
        self.transport = BridgeTransport(BridgeProfile(port=0, **record))
        # opening waits for a client: here for nobody
        self.transport.open(self.robot, lambda: True)

    def ask(
        self,
        method: str,
        path: str,
        body: bytes | None = None,
        headers: dict[str, str] | None = None,
    ) -> tuple[int, dict[str, Any]]:
        client = http.client.HTTPConnection("127.0.0.1", self.transport.port, timeout=20)
        with contextlib.closing(client):
            client.request(method, path, body, headers or {})
            answer = client.getresponse()
            return answer.status, json.loads(answer.read())

    def post(self, path: str, document: object = None) -> tuple[int, dict[str, Any]]:
        return self.ask("POST", path, json.dumps(document).encode())

    def connect(self) -> socket.socket:
        return socket.create_connection(("127.0.0.1", self.transport.port), timeout=20)


@pytest.fixture
def open_bridge() -> Iterator[Callable[..., Bridge]]:
    opened: list[Bridge] = []

    def opening(**record: Any) -> Bridge:
        opened.append(Bridge(**record))
        return opened[-1]

    yield opening
    for bridge in opened:
        bridge.transport.close()


@pytest.fixture
def bridge(open_bridge: Callable[..., Bridge]) -> Bridge:
    return open_bridge()


def code_of(answer: tuple[int, dict[str, Any]]) -> str:
    """The code of a refusal, whose status must be that of the code."""
    status, document = answer
    code: str = document["error"]["code"]
    assert status == STATUS[code]
    assert document["error"]["message"]
    assert document["error"]["remedy"]
    return code


def test_the_routes_answer_as_those_of_the_original(bridge: Bridge) -> None:
    bridge.transport.send(Twist2D(0.25, -0.5))
    status, velocity = bridge.ask("GET", "/bridge/cmd_vel")
    assert (status, velocity["linear_x"], velocity["angular_z"]) == (200, 0.25, -0.5)
    assert abs(velocity["ts"] - time.time()) < 60.0
    assert bridge.post("/bridge/pose", POSE) == (200, {"ok": True})
    assert bridge.ask("GET", "/bridge/status") == (200, {"active": True})
    assert bridge.robot.poses == [Odometry(1.0, 2.0, 0.5, None, None)]


def test_whole_numbers_and_further_fields_are_fine(bridge: Bridge) -> None:
    assert bridge.post("/bridge/pose", {"x": 1, "y": 0, "yaw": 0, "ts": 12.0})[0] == 200


def test_a_velocity_expires_even_if_the_sender_hangs(
    bridge: Bridge, monkeypatch: pytest.MonkeyPatch
) -> None:
    bridge.transport.send(Twist2D(0.25, 0.0))
    now_s = time.monotonic()
    monkeypatch.setattr(time, "monotonic", lambda: now_s + 0.3)
    assert bridge.ask("GET", "/bridge/cmd_vel")[1]["linear_x"] == 0.0


@pytest.mark.parametrize(
    "body",
    [
        b'{"x": NaN, "y": 0, "yaw": 0}',
        b'{"x": 0, "y": Infinity, "yaw": 0}',
        b"",
        b"x=1&y=2&yaw=0",
        b"\xff\xfe\x00",
        b"[" * 60_000,
        b'{"x": ' + b"9" * 5_000 + b', "y": 0, "yaw": 0}',
    ],
)
def test_what_is_no_json_is_refused(bridge: Bridge, body: bytes) -> None:
    assert code_of(bridge.ask("POST", "/bridge/pose", body)) == "bridge_json_invalid"
    # no pose, but counted as an impossible one: a robot that posts nothing else is named
    assert [math.isnan(pose.x_m) for pose in bridge.robot.poses] == [True]


@pytest.mark.parametrize(
    ("document", "field"),
    [
        ({"x": 0, "y": 0}, "yaw"),
        ({"x": None, "y": 0, "yaw": 0}, "x"),
        ({"x": 0, "y": "1", "yaw": 0}, "y"),
        ({"x": 0, "y": True, "yaw": 0}, "y"),
        ({"x": 1e30, "y": 0, "yaw": 0}, "x"),
        ({"x": 10**400, "y": 0, "yaw": 0}, "x"),
        ([1, 2, 3], "x"),
        ("pose", "x"),
        (None, "x"),
    ],
)
def test_an_impossible_pose_is_refused_by_its_field(
    bridge: Bridge, document: Any, field: str
) -> None:
    answer = bridge.post("/bridge/pose", document)
    assert code_of(answer) == "bridge_pose_invalid"
    assert answer[1]["error"]["params"]["field"] == field
    # the link counts it, and names a robot that posts nothing else
    assert [math.isnan(pose.x_m) for pose in bridge.robot.poses] == [True]


def test_a_robot_that_posts_impossible_poses_only_is_named() -> None:
    record = BridgeProfile(port=free_port())
    transport = BridgeTransport(record)
    link = RealLink(record, SimulationConfig(), transport)
    problems: list[PinelError] = []

    def connect() -> None:
        try:
            link.connect()
        except PinelError as problem:
            problems.append(problem)

    connecting = threading.Thread(target=connect)
    connecting.start()
    while connecting.is_alive():
        with contextlib.suppress(OSError):
            client = http.client.HTTPConnection("127.0.0.1", transport.port, timeout=20)
            with contextlib.closing(client):
                client.request("GET", "/bridge/cmd_vel")
                client.getresponse().read()
                client.request("POST", "/bridge/pose", b'{"x": null, "y": 0, "yaw": 0}')
                client.getresponse().read()
        connecting.join(0.05)
    link.close()
    assert [problem.code for problem in problems] == ["odometry_invalid"]


def test_a_client_that_still_sends_what_was_refused_reads_why(bridge: Bridge) -> None:
    with bridge.connect() as client:
        client.sendall(
            b"POST /post_position HTTP/1.1\r\nHost: a\r\nContent-Length: 1000000\r\n\r\n"
        )
        assert client.recv(12) == b"HTTP/1.1 413"
        for _ in range(10):
            client.sendall(100_000 * b"a")
        rest = b"".join(iter(lambda: client.recv(65_536), b""))
    assert b"bridge_too_large" in rest


def test_a_body_of_a_megabyte_is_refused_before_it_is_read(bridge: Bridge) -> None:
    with bridge.connect() as client:
        client.sendall(
            b"POST /bridge/pose HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1048576\r\n\r\n"
        )
        assert client.recv(100).startswith(b"HTTP/1.1 413 ")
    max_pose = {**POSE, "note": "a" * (MAX_BODY_BYTES - 100)}
    assert bridge.post("/bridge/pose", max_pose)[0] == 200


@pytest.mark.parametrize(
    "head",
    [
        b"GET /bridge/status\r\n\r\n",
        b"GET /bridge/status HTTP/2.0\r\n\r\n",
        b"GET http://other/bridge/status HTTP/1.1\r\n\r\n",
        b"POST /bridge/pose HTTP/1.1\r\nContent-Length: -1\r\n\r\n",
        b"POST /bridge/pose HTTP/1.1\r\nContent-Length: 2\r\nContent-Length: 3\r\n\r\n",
        b"POST /bridge/pose HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n",
        b"GET /bridge/status HTTP/1.1\r\nno colon\r\n\r\n",
        b"\x16\x03\x01\x02\x00\r\n\r\n",
        b"GET /" + b"a" * 10_000,
    ],
)
def test_what_is_no_request_is_refused_and_the_connection_closed(
    bridge: Bridge, head: bytes
) -> None:
    with bridge.connect() as client:
        client.sendall(head)
        answer = b""
        while part := client.recv(10_000):
            answer += part
    assert answer.startswith(b"HTTP/1.1 400 ")
    assert b"bridge_request_wrong" in answer
    assert bridge.ask("GET", "/bridge/status")[0] == 200


def test_other_addresses_and_methods_are_refused(bridge: Bridge) -> None:
    assert code_of(bridge.ask("GET", "/")) == "bridge_path_unknown"
    assert code_of(bridge.ask("GET", "/bridge/cmd_vel/")) == "bridge_path_unknown"
    assert code_of(bridge.ask("GET", "/bridge/pose")) == "bridge_method_wrong"
    assert code_of(bridge.ask("DELETE", "/bridge/status")) == "bridge_method_wrong"


def test_a_key_is_asked_for_in_the_header_or_the_address(
    open_bridge: Callable[..., Bridge],
) -> None:
    bridge = open_bridge(key="segredo é")
    header = {"X-PINEL-Key": "segredo é".encode().decode("latin-1")}
    assert bridge.ask("GET", "/bridge/status", headers=header)[0] == 200
    assert bridge.ask("GET", "/bridge/status?key=segredo%20%C3%A9")[0] == 200
    for path in ("/bridge/status", "/bridge/status?key=", "/bridge/status?key=segredo", "/"):
        assert code_of(bridge.ask("GET", path)) == "bridge_key_wrong"
    wrong = {"X-PINEL-Key": "segredo"}
    answer = bridge.ask("POST", "/bridge/pose", json.dumps(POSE).encode(), wrong)
    assert code_of(answer) == "bridge_key_wrong"
    assert bridge.robot.poses == []


def test_web_pages_cannot_drive(bridge: Bridge) -> None:
    body = json.dumps(POSE).encode()
    for headers in ({"Origin": "http://evil.example"}, {"Sec-Fetch-Site": "cross-site"}):
        answer = bridge.ask("POST", "/bridge/pose", body, headers)
        assert code_of(answer) == "bridge_origin_wrong"
        for path in ("/bridge/run_start", "/bridge/run_end"):
            assert code_of(bridge.ask("POST", path, b"", headers)) == "bridge_page_foreign"
    for host in ("evil.example", "evil.example:5000", "[::1", "localhost.evil.example"):
        assert code_of(bridge.ask("GET", "/bridge/status", headers={"Host": host})) == (
            "bridge_host_wrong"
        )
    for host in ("localhost:5000", "192.168.0.7:5000", "[::1]:5000", socket.gethostname()):
        assert bridge.ask("GET", "/bridge/status", headers={"Host": host})[0] == 200
    assert bridge.robot.poses == []


def test_the_flag_of_a_page_neither_ends_a_run_nor_fails_it(bridge: Bridge) -> None:
    """Also from another address than the robot's, as often as the page likes, before and after poses."""
    for path in ("/bridge/run_start", "/bridge/run_end", "/bridge/run_end", "/bridge/run_start"):
        assert bridge.post(path) == (200, {"ok": True})
        assert bridge.ask("POST", path) == (200, {"ok": True})  # without a body
        bridge.post("/bridge/pose", POSE)
        assert bridge.ask("GET", "/bridge/status") == (200, {"active": True})
    bridge.transport.send(Twist2D(0.3, 0.0))
    with socket.create_connection(
        ("127.0.0.1", bridge.transport.port), timeout=20, source_address=("127.0.0.2", 0)
    ) as other:
        other.sendall(b"POST /bridge/run_end HTTP/1.0\r\n\r\n")
        answer = other.recv(10_000)
    assert answer.endswith(b'{"ok": true}')
    assert bridge.ask("GET", "/bridge/cmd_vel")[1]["linear_x"] in (0.3, 0.0)  # stale on a busy PC
    assert bridge.ask("GET", "/bridge/status") == (200, {"active": True})
    assert bridge.robot.problems == []


def test_a_second_robot_is_refused(bridge: Bridge) -> None:
    bridge.post("/bridge/pose", POSE)
    with socket.create_connection(
        ("127.0.0.1", bridge.transport.port), timeout=20, source_address=("127.0.0.2", 0)
    ) as other:
        other.sendall(b"GET /bridge/cmd_vel HTTP/1.0\r\n\r\n")
        answer = other.recv(10_000)
    assert answer.startswith(b"HTTP/1.1 409 ")
    assert b"127.0.0.1" in answer
    assert bridge.ask("GET", "/bridge/cmd_vel")[0] == 200


def test_a_connection_serves_many_requests_also_sent_at_once(bridge: Bridge) -> None:
    with bridge.connect() as client:
        for _ in range(3):
            client.sendall(b"GET /bridge/status HTTP/1.1\r\n\r\n" * 50)
            answers = b""
            while answers.count(b'"active"') < 50:
                part = client.recv(10_000)
                assert part
                answers += part
            assert answers.count(b"HTTP/1.1 200 OK") == 50


def test_a_client_that_asks_whether_it_may_send_is_told_so(bridge: Bridge) -> None:
    body = json.dumps(POSE).encode()
    with bridge.connect() as client:
        client.sendall(
            b"POST /bridge/pose HTTP/1.1\r\nExpect: 100-continue\r\nContent-Length: %d\r\n\r\n"
            % len(body)
        )
        assert client.recv(100) == b"HTTP/1.1 100 Continue\r\n\r\n"
        client.sendall(body)
        assert client.recv(1000).startswith(b"HTTP/1.1 200 ")


def test_clients_that_send_nothing_hold_up_nobody(bridge: Bridge) -> None:
    with contextlib.ExitStack() as slow:
        for _ in range(3 * MAX_CONNECTIONS):
            slow.enter_context(bridge.connect()).sendall(b"GET /bridge/sta")
        for _ in range(10):
            assert bridge.ask("GET", "/bridge/status")[0] == 200


def test_a_slow_request_is_closed(
    monkeypatch: pytest.MonkeyPatch, open_bridge: Callable[..., Bridge]
) -> None:
    monkeypatch.setattr(listening, "REQUEST_S", 0.2)
    with open_bridge().connect() as client:
        client.sendall(b"GET /bridge/sta")
        with contextlib.suppress(ConnectionResetError):
            assert client.recv(100) == b""


def test_a_client_that_takes_no_answers_is_closed(bridge: Bridge) -> None:
    requests = b"GET /bridge/status HTTP/1.1\r\n\r\n" * 1_000_000
    with bridge.connect() as client, pytest.raises((ConnectionResetError, BrokenPipeError)):
        client.sendall(requests)


def test_a_flood_holds_up_neither_robot_nor_pinel(bridge: Bridge) -> None:
    """A thousand requests a second and more beside a client at 30 Hz, whose answers come in time."""
    ending = threading.Event()
    flooded: list[int] = []

    def flood() -> None:
        with bridge.connect() as client:
            while not ending.wait(0.01):
                client.sendall(b"GET /bridge/status HTTP/1.1\r\n\r\n" * 20)
                flooded.append(client.recv(100_000).count(b"200 OK"))

    flooding = threading.Thread(target=flood)
    flooding.start()
    try:
        due_s = time.monotonic() + 60.0
        while sum(flooded) < 1000:
            asked_s = time.monotonic()
            assert asked_s < due_s, "the flood itself is held up"
            bridge.transport.send(Twist2D(0.1, 0.0))
            assert bridge.ask("GET", "/bridge/cmd_vel")[1]["linear_x"] in (0.1, 0.0)
            assert in_time(time.monotonic() - asked_s, 5.0)
    finally:
        ending.set()
        flooding.join()


def test_who_connects_while_the_bridge_closes_is_not_forgotten() -> None:
    with warnings.catch_warnings(record=True) as caught, contextlib.ExitStack() as clients:
        warnings.simplefilter("always")
        for _ in range(30):
            server = BridgeHttpServer("127.0.0.1", 0, lambda request: Response(200, {}))
            server.start()
            for _ in range(3):
                client = socket.create_connection(("127.0.0.1", server.port))
                clients.enter_context(client)
            server.close()
        gc.collect()
    assert [str(one.message) for one in caught if one.category is ResourceWarning] == []


def test_a_port_in_use_is_named() -> None:
    with socket.socket() as first:
        first.bind(("127.0.0.1", 0))
        first.listen()
        port = first.getsockname()[1]
        transport = BridgeTransport(BridgeProfile(port=port))
        with pytest.raises(PinelError) as busy:
            transport.open(Robot(), lambda: False)
        transport.close()
    assert (busy.value.code, busy.value.params) == (
        "bridge_port_busy",
        {"port": port, "host": "127.0.0.1"},
    )


@pytest.mark.parametrize("host", ["192.0.2.1", "a..b", "no-such-name.invalid"])
def test_an_address_that_is_not_this_pcs_is_named(host: str) -> None:
    with pytest.raises(PinelError) as wrong:
        BridgeTransport(BridgeProfile(host=host, port=0)).open(Robot(), lambda: False)
    assert wrong.value.code == "bridge_address_wrong"
    assert wrong.value.params["host"] == host


def test_opening_waits_for_a_client_no_longer_than_the_record_says() -> None:
    transport = BridgeTransport(BridgeProfile(port=0, wait_s=0.2))
    with pytest.raises(PinelError) as nobody:
        transport.open(Robot(), lambda: False)
    transport.close()
    assert nobody.value.code == "bridge_no_client"


def test_nobody_is_waited_for_at_the_end_if_nobody_is_there(bridge: Bridge) -> None:
    started_s = time.monotonic()
    bridge.transport.close()
    assert in_time(time.monotonic() - started_s, 0.5)
    with pytest.raises(ConnectionRefusedError):
        bridge.connect()


def test_nothing_is_handed_out_that_was_never_sent(bridge: Bridge) -> None:
    velocity = bridge.ask("GET", "/bridge/cmd_vel")[1]
    assert Twist2D(velocity["linear_x"], velocity["angular_z"]) == STANDSTILL


def test_every_refusal_is_documented_with_its_status() -> None:
    page = (Path(__file__).parents[2] / "docs" / "bridge.md").read_text("utf-8")
    rows = [line for line in page.splitlines() if line.startswith("|")]
    for code, status in STATUS.items():
        assert any(row.startswith(f"| {status} ") and f"`{code}`" in row for row in rows), code
