"""How long a frame of a replay takes: of a short run, of one of ten thousand samples with a pen, on a printed floor.

The real page replays a real run whose samples and events are exchanged for made ones on their way to the page.
"""

import json
import math
import struct
from collections.abc import Iterator
from typing import Any, NamedTuple

import pytest
from playwright.sync_api import Browser, CDPSession, Page, Route, sync_playwright

from tests.e2e.conftest import CHROMIUM
from tests.e2e.studio import Studio
from tests.e2e.test_running import add_move

SHORT, LONG = 600, 10_500
WATCHED_S = 5
SHOWN_BEFORE_END = 400  # ticks: the replay plays on while it is watched
MAX_TIMES_SHORT = 2.0
FURNISHED = "furnished_room"
APPEARANCE = ("ground", "prints", "kind")
MAX_TIMES_PLAIN = 1.2
COLUMNS = ("tick", "x_m", "y_m", "yaw_rad", "goal_x_m", "goal_y_m", "goal_yaw_rad")
STROKE_TICKS = 500
COLORS = ("red", "blue", "green", "black")

FRAME_GAPS = """seconds => new Promise(done => {
    const gaps = [];
    let last = performance.now();
    const end = last + seconds * 1000;
    const frame = now => {
        gaps.push(now - last);
        last = now;
        if (now < end) requestAnimationFrame(frame);
        else done(gaps.sort((a, b) => a - b));
    };
    requestAnimationFrame(frame);
})"""


class Frames(NamedTuple):
    """Milliseconds from frame to frame, and how long the page worked for one."""

    median: float
    p95: float
    work: float


@pytest.fixture
def browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield browser
        browser.close()


def test_a_long_run_costs_a_frame_no_more_than_a_short_one(page: Page) -> None:
    run = driven(Studio(page))
    frames = {rows: _replayed(page, run, rows) for rows in (SHORT, LONG)}
    for rows, found in frames.items():
        print(f"{rows:6} samples: {_words(found)}")
    assert frames[LONG].work < MAX_TIMES_SHORT * frames[SHORT].work


def test_a_printed_floor_costs_a_frame_little_more_than_a_plain_one(page: Page) -> None:
    """The same room with and without its print, in turns."""
    run = driven(Studio(page), FURNISHED)
    found: dict[bool, list[Frames]] = {False: [], True: []}
    for is_printed in (False, True) * 3:
        found[is_printed].append(_replayed(page, run, SHORT, is_printed=is_printed))
    plain, printed = (min(found[one], key=lambda frames: frames.work) for one in (False, True))
    print(f"plain floor: {_words(plain)}; printed: {_words(printed)}")
    assert printed.work < MAX_TIMES_PLAIN * plain.work


def _words(frames: Frames) -> str:
    median, p95, work = frames
    return f"a frame every {median:.1f} ms (95 %: {p95:.1f}), {work:.1f} ms of work"


def driven(studio: Studio, world: str | None = None) -> str:
    studio.enter_group("Bancada")
    if world is not None:
        studio["world"].select_option(world)
    add_move(studio, "0,1")
    studio.run()
    studio.wait_for_phase("finished")
    group = studio.api("/groups")["groups"][0]["id"]
    return str(studio.api(f"/groups/{group}/runs?limit=1")["runs"][0]["id"])


def _replayed(page: Page, run: str, rows: int, *, is_printed: bool = True) -> Frames:
    origin = page.url.split("#")[0]
    page.unroute_all()
    if not is_printed:
        page.route("**/api/worlds", _without_appearance)
    page.route("**/telemetry", lambda route: route.fulfill(body=telemetry(rows)))
    page.route(
        "**/api/runs/*/events",
        lambda route: route.fulfill(json={"events": events(run, rows)}),
    )
    page.goto(f"{origin}#/run/{run}")
    page.reload()
    slider = page.get_by_test_id("replay-slider")
    slider.fill(str(rows - SHOWN_BEFORE_END))
    page.get_by_test_id("replay-play").click()
    page.wait_for_timeout(500)
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable")
    before = _work_s(session)
    gaps = page.evaluate(FRAME_GAPS, WATCHED_S)
    work = (_work_s(session) - before) * 1000 / len(gaps)
    return Frames(gaps[len(gaps) // 2], gaps[len(gaps) * 95 // 100], work)


def _without_appearance(route: Route) -> None:
    """Answers with the worlds as they are without any look."""
    answer = route.fetch()
    worlds = json.loads(
        answer.text(),
        object_hook=lambda part: {k: v for k, v in part.items() if k not in APPEARANCE},
    )
    route.fulfill(response=answer, json=worlds)


def _work_s(session: CDPSession) -> float:
    metrics = session.send("Performance.getMetrics")["metrics"]
    return float(next(one["value"] for one in metrics if one["name"] == "TaskDuration"))


def telemetry(rows: int) -> bytes:
    """A robot that winds over all of the room, at 0.38 m/s."""
    x = y = 0.0
    samples = []
    for row in range(rows):
        yaw = row * 0.013 + 0.9 * math.sin(row / 170)
        x += 0.0125 * math.cos(yaw)
        y += 0.0125 * math.sin(yaw)
        goal = (x + 0.02 * math.sin(row / 40), y + 0.02 * math.cos(row / 40), yaw)
        samples.append((row + 1, x, y, yaw, *goal))
    header = json.dumps({"columns": COLUMNS, "rows": rows, "rate_hz": 30}).encode()
    header += b" " * (-len(header) % 4)
    columns = [struct.pack(f"<{rows}f", *column) for column in zip(*samples, strict=True)]
    return struct.pack("<I", len(header)) + header + b"".join(columns)


def events(run: str, rows: int) -> list[dict[str, Any]]:
    """A pen that changes its colour again and again."""
    head: dict[str, Any] = {"v": 1, "run": run}
    begin = {"type": "run_state", "state": "running", "cause": None, "block": None}
    events: list[dict[str, Any]] = [{**head, "seq": 0, "tick": 0, **begin}]
    for number, tick in enumerate(range(0, rows, STROKE_TICKS)):
        pen = {"type": "pen", "block": None, "down": True, "color": COLORS[number % len(COLORS)]}
        events.append({**head, "seq": number + 1, "tick": tick, **pen})
    return events
