"""Operates the page by its test ids (`data-testid`)."""

import itertools
import re
import time
from collections.abc import Callable, Sequence
from typing import Any, TypeVar, cast

from playwright.sync_api import APIResponse, Locator, Page, Request, Response, Route, expect

from tests.e2e.blocks import Blocks
from tests.e2e.delays import slower

TIMEOUT_MS = 15_000 * slower()  # for one wait, on a busy PC
RUN_MS = 60_000 * slower()  # a run in real time
SAVE_S = 10.0 * slower()
POLL_MS = 50

_OVER = re.compile("finished|stopped|failed")
# observers of an element's size, such as the header's, change the page at the end of the frame
# after a resize
_TWO_FRAMES = (
    "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
)
# except in an open card below the header
_IN_HEADER = "one => !!one.closest('header.header') && !one.closest('.card')"
# no request and no used font is loading, no button waits for its request, and no element moves
# except permanent animations
_AT_REST = """() => !document.querySelector('[aria-busy=true]') && document.fonts.status === 'loaded'
  && document.getAnimations()
  .every((one) => one.playState !== 'running' || one.effect.getComputedTiming().endTime === Infinity)"""
_NUMBERS = itertools.count(1)

# a picture or a stream may never end
_FETCHED = {"document", "fetch", "script", "stylesheet", "xhr"}
_N_IDLE_POLLS, _IDLE_POLL_MS = 2, 20  # a response may cause another request a moment later

T = TypeVar("T")


class PendingRequests:
    """The requests of a page that have no response yet."""

    def __init__(self, page: Page) -> None:
        self._page, self._requests = page, set[Request]()
        page.on("request", self._begin)
        page.on("requestfinished", self._end)
        page.on("requestfailed", self._end)

    def wait_for_none(self) -> None:
        """Waits until every request has its response. Raises AssertionError with the requests that have none."""
        deadline, calm = time.monotonic() + TIMEOUT_MS / 1000, 0
        while calm < _N_IDLE_POLLS:
            assert time.monotonic() < deadline, [one.url for one in self._requests]
            calm = 0 if self._requests else calm + 1
            self._page.wait_for_timeout(_IDLE_POLL_MS)

    def _begin(self, request: Request) -> None:
        if request.is_navigation_request() and request.frame == self._page.main_frame:
            self._requests.clear()  # the previous page's requests do not matter
        if request.resource_type in _FETCHED and not request.url.endswith("/stream"):
            self._requests.add(request)

    def _end(self, request: Request) -> None:
        self._requests.discard(request)


class Studio:
    """One open page."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.blocks = Blocks(page)
        self._pending = PendingRequests(page)

    def __getitem__(self, test_id: str) -> Locator:
        return self.page.get_by_test_id(test_id)

    def wait_for_screen(self, shows: str | Locator) -> None:
        """Waits until the screen is complete: all requests have responses, and no element moves.

        Args:
            shows: an element that only this screen shows, not the one before, or its test id.
        """
        one = (self[shows] if isinstance(shows, str) else shows).first
        expect(one).to_be_visible()
        assert not one.evaluate(_IN_HEADER), f"{shows}: the header is on every screen"
        self._pending.wait_for_none()
        self.page.evaluate(_TWO_FRAMES)
        self.page.wait_for_function(_AT_REST)

    def enter_group(self, name: str, level: int | None = 3, *, tour: bool = False) -> None:
        """Creates a group and waits for its first program. If `level` is None, it stays the default.

        Args:
            tour: stays in the guided first drive; otherwise it is skipped.
        """
        self["group-name"].fill(name)
        self["create-group"].click()
        self.wait_until_open()
        # in the mission of a lesson the sheet's button begins the tour
        if not tour and self.api(f"/programs/{self.program_id}")["version"] is None:
            self["tour-skip"].click()
        if level is not None:
            self.choose_level(level)

    def choose_level(self, level: int) -> None:
        """Chooses a level and waits for the editor; above the first level, the flyout does not stay open."""
        self["level"].select_option(str(level))
        if level > 1:
            expect(self.page.locator(".blocklyToolboxFlyout")).to_be_hidden()

    def enter_new_group(self, name: str = "Os Tatus", level: int | None = 3) -> None:
        """Creates a group with a unique name, for tests that share an app."""
        self.enter_group(self.unique(name), level)

    @staticmethod
    def unique(name: str) -> str:
        """Returns the name with a number, unique among the groups of these tests."""
        return f"{name} {next(_NUMBERS)}"

    def choose_language(self, language: str) -> None:
        """Chooses a language and waits until the page is in that language."""
        self["language"].select_option(language)
        expect(self.page.locator("html")).to_have_attribute("lang", language)

    def wait_until_open(self) -> None:
        expect(self.blocks.start()).to_be_visible()
        expect(self["run"]).to_be_visible()

    @property
    def program_id(self) -> str:
        match = re.search(r"#/program/([^/]+)", self.page.url)
        assert match is not None, f"no program is open at {self.page.url}"
        return match[1]

    def wait_until_saved(self) -> None:
        expect(self["saved-mark"]).to_have_attribute("data-state", "saved")

    def api(self, path: str) -> Any:
        """Sends a GET request with the page's cookie and returns the response's data."""
        return self._answer(path, self.page.context.request.get(f"{self.origin}/api{path}"))

    def send(self, method: str, path: str, data: Any = None) -> Any:
        """Sends a request with the page's cookie and returns the response's data."""
        send = self.page.context.request.fetch
        return self._answer(path, send(f"{self.origin}/api{path}", method=method, data=data))

    def open_teacher_part(self, pin: str) -> None:
        """Signs in as the teacher by a request, which sets the PIN if there is none yet."""
        has_pin = self.api("/teacher")["has_pin"]
        method, path = ("POST", "/teacher/enter") if has_pin else ("PUT", "/teacher/pin")
        self.send(method, path, {"pin": pin})

    @property
    def origin(self) -> str:
        return self.page.url.split("#")[0].rstrip("/")

    @staticmethod
    def _answer(path: str, answer: APIResponse) -> Any:
        assert answer.ok, f"{path}: {answer.status} {answer.text()}"
        return answer.json()

    def expect_each(self, locator: Locator, attribute: str, values: Sequence[str]) -> None:
        """Waits until there are as many elements as values, and each element has its value."""
        expect(locator).to_have_count(len(values))
        for place, value in enumerate(values):
            expect(locator.nth(place)).to_have_attribute(attribute, value)

    def eventually(self, read: Callable[[], T], expected: T) -> None:
        """Polls until the value is as expected: the server receives edits with a delay."""
        deadline = time.monotonic() + SAVE_S
        while (value := read()) != expected and time.monotonic() < deadline:
            self.page.wait_for_timeout(POLL_MS)
        assert value == expected, f"{value!r} instead of {expected!r}"

    def document(self) -> dict[str, Any] | None:
        """The stored program document."""
        version = self.api(f"/programs/{self.program_id}")["version"]
        return cast(dict[str, Any] | None, version and version["document"])

    def workspace(self) -> Any:
        """The newest stored workspace."""
        version = self.api(f"/programs/{self.program_id}")["version"]
        return version and version["workspace"]

    def stacks(self) -> int:
        """Number of stored stacks of blocks, including loose ones."""
        return len(self.workspace()["blocks"]["blocks"])

    def commands(self) -> list[dict[str, Any]]:
        """The stored commands; empty while the program has faults."""
        return cast(list[dict[str, Any]], (self.document() or {}).get("commands", []))

    def actions(self) -> list[str]:
        return [command["action"] for command in self.commands()]

    def values(self, key: str) -> list[Any]:
        """One parameter of each command."""
        return [command.get(key) for command in self.commands()]

    def build_square(self, side: str = "0,3") -> None:
        """Drags repeat, move and turn into a square."""
        blocks = self.blocks
        blocks.drag_from_toolbox("flow", "repetir", blocks.below(blocks.start()))
        loop = blocks.by_text("repetir")
        blocks.drag_from_toolbox("motion", "andar para frente", blocks.inside(loop))
        move = blocks.by_text("andar para frente")
        blocks.drag_from_toolbox("motion", "girar", blocks.below(move))
        blocks.type_into(blocks.by_text("andar para frente"), side)
        metres = float(side.replace(",", "."))
        self.eventually(lambda: _inner(self.commands(), "distance"), [metres, None])

    def run(self) -> None:
        """Presses Run and waits until the run has started, so that the page no longer shows the run before."""
        run = self["run"]
        expect(run).to_have_attribute("data-does", "run")
        expect(run).to_be_enabled(timeout=RUN_MS)
        with self.page.expect_response(_begins_run, timeout=RUN_MS):
            run.click()

    def hurry(self) -> None:
        """Sets runs started from now on to ten times real time, for runs that the test does not check meanwhile."""
        self.page.route("**/api/runs", _ten_times_faster)

    def run_to_the_end(self) -> None:
        """Runs the program until the page shows how the run ended."""
        self.run()
        expect(self["scene"]).to_have_attribute("data-phase", _OVER, timeout=RUN_MS)

    def wait_for_phase(self, phase: str, timeout_ms: float = RUN_MS) -> None:
        expect(self["scene"]).to_have_attribute("data-phase", phase, timeout=timeout_ms)

    def floor_picture(self) -> str:
        """The picture of the floor, as a URL."""
        picture: str = self["scene"].evaluate("canvas => canvas.toDataURL()")
        return picture

    def number(self, test_id: str) -> float:
        """Returns the exact value of a number that the page shows now, from `data-value`."""
        return float(self[test_id].get_attribute("data-value") or "nan")

    def expect_number(self, test_id: str, value: Any) -> None:
        """Waits until the page shows a number: a float, `approx`, or another object that compares as equal."""
        self.eventually(lambda: self.number(test_id), value)


def _begins_run(answer: Response) -> bool:
    return answer.request.method == "POST" and answer.url.endswith("/api/runs")


def _ten_times_faster(route: Route) -> None:
    asked = route.request
    body: dict[str, Any] = asked.post_data_json or {}
    route.continue_(post_data={**body, "speed": 10} if asked.method == "POST" else None)


def _inner(commands: list[dict[str, Any]], key: str) -> list[Any]:
    return [inside.get(key) for loop in commands for inside in loop.get("commands", [])]
