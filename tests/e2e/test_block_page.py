"""A block page made for the original PINEL, from HTTP and from a file, drives the robot of `pinel serve --bridge`."""

import functools
import http.server
import json
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest
from playwright.sync_api import Browser as Chromium
from playwright.sync_api import Page

from tests.e2e.app_process import AppProcess
from tests.links.aurora import Aurora, free_port
from tests.web.browser import Browser

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(240)]

PAGE = Path(__file__).with_name("block_page.html")
B = Path(__file__).parents[1] / "camera" / "recordings" / "b.npz"
OVER_MS = 180_000
WAIT_S = 60.0
SIDE: dict[str, Any] = {"action": "move_forward", "distance": 0.2}
CORNER: dict[str, Any] = {"action": "turn", "angle": -90}
BRANCH = {"action": "conditional_execution", "sign": "B", "commands": [SIDE, CORNER]}
OTHER = {"action": "conditional_execution", "sign": "A", "commands": [SIDE] * 9}
PROGRAM = [{"action": "classificar_gestos"}, OTHER, BRANCH, {"action": "stop"}]
SENT: dict[str, Any] = {"action": "set_gesture_result", "resultado": "B"}
DRIVEN: list[dict[str, Any]] = [SENT, SIDE, CORNER, {"action": "stop"}]


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_: object) -> None:
        pass


@pytest.fixture(scope="module")
def origins() -> Iterator[dict[str, str]]:
    """The page's addresses: over HTTP from another port of this PC, and as a file."""
    handler = functools.partial(Quiet, directory=str(PAGE.parent))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        over_http = f"http://localhost:{server.server_port}/{PAGE.name}"
        yield {"http": over_http, "file": PAGE.as_uri()}
        server.shutdown()


class Served:
    """`pinel serve --bridge` with a camera that shows B, and the robot that its calls drive."""

    def __init__(self, home: Path, robot: str, *options: str) -> None:
        self.port = free_port()
        self.aurora = Aurora(self.port) if robot == "bridge" else None
        bridge = ("--bridge", f"127.0.0.1:{self.port}", "--robot", robot)
        self._app = AppProcess(home, *bridge, "--camera", str(B), *options)
        self.browser = Browser.signed_in(self._app.start())
        due_s = time.monotonic() + WAIT_S
        # the app logs its address when it listens
        while f"http://127.0.0.1:{self.port}" not in self._app.log():
            assert time.monotonic() < due_s
            time.sleep(0.1)

    def only_run(self) -> dict[str, Any]:
        """Returns the run, which ends by itself soon after the page's batch."""
        due_s = time.monotonic() + WAIT_S
        while True:
            (group,) = self.browser.get("/api/groups").data["groups"]
            (run,) = self.browser.get(f"/api/groups/{group['id']}/runs").data["runs"]
            found: dict[str, Any] = self.browser.get(f"/api/runs/{run['id']}").data
            if found["state"] != "running" and found["version"]:
                return found
            assert time.monotonic() < due_s, found
            time.sleep(0.1)

    def close(self) -> None:
        self._app.stop()
        if self.aurora:
            self.aurora.close()


def opened(page: Page, address: str, port: int, *, flags: bool) -> None:
    setting = {"port": port, "flags": flags, "commands": PROGRAM}
    page.goto(f"{address}#{quote(json.dumps(setting))}")


def played(page: Page) -> Any:
    """Returns the responses that the page has read, when it has finished."""
    page.click("#run")
    page.wait_for_function("window.over", timeout=OVER_MS)
    over = page.evaluate("window.over")
    assert over["problem"] is None, over
    return over["answers"]


def conversation(*, flags: bool) -> list[list[Any]]:
    begin = [["/bridge/run_start", 200, {"ok": True}]] if flags else []
    end = [["/bridge/run_end", 200, {"ok": True}]] * 2 if flags else []
    return [
        ["/get_last_gesture_result", 200, {"resultado": None}],
        *begin,
        ["/classify_stream", 200, None],
        ["/get_last_gesture_result", 200, {"resultado": "B"}],
        *(["/execute", 200, [{**one, "status": "ok"}]] for one in DRIVEN),
        *end,
    ]


@pytest.mark.parametrize(("origin", "robot"), [("http", "bridge"), ("file", "sim")])
def test_a_page_of_this_pc_plays_a_program_with_a_gesture(
    browser: Chromium, origins: dict[str, str], tmp_path: Path, origin: str, robot: str
) -> None:
    served = Served(tmp_path, robot, *(["--bridge-file-pages"] if origin == "file" else []))
    page = browser.new_page()
    try:
        opened(page, origins[origin], served.port, flags=True)
        assert played(page) == conversation(flags=True)
        run = served.only_run()
        if served.aurora:  # the client ends when no run is active and the robot has moved
            assert served.aurora.has_ended(within_s=WAIT_S)
    finally:
        page.close()
        served.close()
    assert (run["state"], run["reason"]) == ("finished", None)
    actions = [one["action"] for one in run["version"]["document"]["commands"]]
    assert actions == ["classify_gestures", *(one["action"] for one in DRIVEN)]
    assert run["estimated_closing_error_m"] == pytest.approx(0.2, abs=0.02)
    # only the robot's own estimate exists
    assert (run["closing_error_m"] is None) == (robot == "bridge")


def test_the_page_of_august_sets_no_flag(
    browser: Chromium, origins: dict[str, str], tmp_path: Path
) -> None:
    served = Served(tmp_path, "sim", "--bridge-file-pages")
    page = browser.new_page()
    try:
        opened(page, origins["file"], served.port, flags=False)
        assert played(page) == conversation(flags=False)
    finally:
        page.close()
        served.close()


def test_without_the_option_a_page_opened_as_a_file_drives_nothing(
    browser: Chromium, origins: dict[str, str], tmp_path: Path
) -> None:
    served = Served(tmp_path, "sim")
    page = browser.new_page()
    try:
        opened(page, origins["file"], served.port, flags=True)
        page.click("#run")
        page.wait_for_function("window.over", timeout=OVER_MS)
        assert "Failed to fetch" in page.evaluate("window.over.problem")
        assert served.browser.get("/api/groups").data["groups"] == []
    finally:
        page.close()
        served.close()
