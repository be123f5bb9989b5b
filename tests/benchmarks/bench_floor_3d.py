"""How long a frame of the floor in 3D takes without a graphics card: in a replay, and beside three.js alone.

The replay is the real page's, with made samples. For the comparison, one page draws the same room at 640 x 480 by the
page's view and by a dozen lines of three.js, a frame of each in turn.
"""

import functools
import http.server
import statistics
import subprocess
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect, sync_playwright

from pinel_desktop.robot.models import PIONEER_3DX
from tests.benchmarks.bench_scene import FRAME_GAPS, driven, events, telemetry
from tests.e2e.conftest import CHROMIUM
from tests.e2e.studio import Studio

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
WORLD = "furnished_room"
REPLAY_S = 60
TICK_HZ = 30
FRAMES, WARM_UP = 240, 40
MIN_FRAMES_PER_S = 30
MAX_TIMES_BARE = 1.5
FRAME = (640, 480)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    arguments = ["--no-sandbox", "--enable-unsafe-swiftshader"]
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=arguments)
        yield browser
        browser.close()


def test_a_minute_of_replay_in_3d_has_30_frames_a_second(page: Page) -> None:
    run = driven(Studio(page), WORLD)
    rows = (REPLAY_S + 10) * TICK_HZ
    page.route("**/telemetry", lambda route: route.fulfill(body=telemetry(rows)))
    page.route(
        "**/api/runs/*/events", lambda route: route.fulfill(json={"events": events(run, rows)})
    )
    page.goto(f"{page.url.split('#')[0]}#/run/{run}")
    page.reload()
    page.locator('[data-testid="floor-view"][data-value="true"]').click()
    floor = page.get_by_test_id("scene-3d")
    expect(page.get_by_test_id("scene")).to_be_hidden()
    # the view has the size of the figure, whatever is beside it
    page.locator(".scene").evaluate(
        """(one, [width, height]) => Object.assign(one.style, {
            position: 'fixed', inset: '0 auto auto 0', zIndex: 99, width: `${width}px`, height: `${height}px`})""",
        FRAME,
    )
    page.get_by_test_id("replay-slider").fill("0")
    page.get_by_test_id("replay-play").click()
    page.wait_for_timeout(1500)
    gaps = page.evaluate(FRAME_GAPS, REPLAY_S)
    width, height = floor.evaluate("one => [one.width, one.height]")
    rate = len(gaps) / REPLAY_S
    p95 = gaps[len(gaps) * 95 // 100]
    print(f"replay in 3D, {width} x {height}: {rate:.1f} frames a second (95 %: {p95:.0f} ms)")
    assert rate >= MIN_FRAMES_PER_S


def test_a_frame_costs_little_more_than_the_same_room_in_bare_three_js(page: Page) -> None:
    studio = Studio(page)
    world = next(one for one in studio.api("/worlds")["worlds"] if one["name"] == WORLD)
    robot = next(one for one in studio.api("/robots")["robots"] if one["name"] == PIONEER_3DX.name)
    with _served(_built()) as address:
        page.goto(address)
        page.wait_for_function("() => 'measure' in window")
        found = page.evaluate(
            "([world, robot, frames]) => measure(world, robot, frames)", [world, robot, FRAMES]
        )
    ours, bare = (statistics.median(times[WARM_UP:]) for times in found)
    print(f"a frame in 3D: {ours:.1f} ms; bare three.js: {bare:.1f} ms; {ours / bare:.2f} times")
    assert ours < MAX_TIMES_BARE * bare


def _built() -> Path:
    script = 'PATH="$(sh scripts/node.sh):$PATH" && cd ui && exec npx vite build --logLevel warn --config "$0"'
    config = HERE / "bare_floor" / "vite.config.mjs"
    subprocess.run(["sh", "-c", script, str(config)], cwd=ROOT, check=True)
    return ROOT / "build" / "bare-floor"


@contextmanager
def _served(folder: Path) -> Iterator[str]:
    """Serves a folder on this PC; yields its address."""
    handler = functools.partial(http.server.SimpleHTTPRequestHandler, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()
