"""Commands to a real robot in a lesson: the app records, a page draws the run, the camera reads signs meanwhile."""

import contextlib
import os
import time
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import psutil
from playwright.sync_api import Browser, expect, sync_playwright

from pinel_desktop.links.velocity_publisher import PERIOD_S
from tests.benchmarks.bench_links import percentile, sleeper
from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import CHROMIUM
from tests.e2e.python_pane import write_program
from tests.e2e.studio import Studio
from tests.e2e.test_camera import CAMERA_MS, RECORDINGS
from tests.e2e.test_classes import prepare
from tests.links.dds_domains import ROOM, own_domain
from tests.links.dds_peer import DdsPeer

DRIVES_S = 25
MEASURED_S = 15.0
PROGRAM = f"robot.drive(0.0, 10)\nrobot.wait({DRIVES_S})\n"


def open_page(browser: Browser, app: AppProcess, link: str) -> Studio:
    """A page of the app in a browser context of its own."""
    page = browser.new_context(viewport={"width": 1366, "height": 768}, locale="pt-BR").new_page()
    page.set_default_timeout(30_000)
    page.goto(link)
    return Studio(page)


@contextlib.contextmanager
def lesson(home: Path, domain: int) -> Iterator[Studio]:
    """A group's page with its program for the real robot, beside one that practises signs with the camera."""
    app = AppProcess(home, "--camera", str(RECORDINGS / "b.npz"))
    app.start()
    sandbox = ["--no-sandbox"] if os.geteuid() == 0 else []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=CHROMIUM, args=["--disable-gpu", *sandbox]
        )
        studio = open_page(browser, app, app.link)
        prepare(studio)
        record = {"domain": domain, "peers": ["127.0.0.1"], "room": ROOM.model_dump()}
        studio.send("PUT", "/real-robots/dds", {"record": record})
        studio["sign-out"].click()
        studio.enter_group("Os Tatus")
        write_program(studio, PROGRAM)
        practice = open_page(browser, app, app.fresh_link())
        practice["practice"].click()
        expect(practice["practice-text"]).to_have_value("B", timeout=CAMERA_MS)
        yield studio
        browser.close()
    app.stop()


def begin(studio: Studio, robot: DdsPeer) -> None:
    """Begins the run, and waits until the robot turns."""
    studio["robot-choice"].select_option("dds")
    studio["run"].click()
    for point in studio["before-point"].all():
        point.check()
    studio["before-go"].click()
    studio.wait_for_phase("running", 60_000)
    due_s = time.monotonic() + 30.0
    while not any(twist.omega_radps for _, twist in robot.received[-3:]):
        assert time.monotonic() < due_s, "the robot does not drive"
        time.sleep(0.05)


def test_commands_are_as_regular_as_a_sleeper_while_page_camera_and_store_are_busy(
    tmp_path: Path,
) -> None:
    with (
        own_domain() as domain,
        contextlib.closing(DdsPeer(domain)) as robot,
        lesson(tmp_path, domain) as studio,
    ):
        begin(studio, robot)
        n_before = len(robot.received)
        psutil.cpu_percent()
        with sleeper(PERIOD_S) as bare:
            time.sleep(MEASURED_S)
        busy = psutil.cpu_percent()
        at_s = [received_s for received_s, _ in robot.received[n_before:]]
        turning = [twist.omega_radps for _, twist in robot.received[n_before:]]
        studio.page.keyboard.press("F9")
        studio.wait_for_phase("stopped")
    gaps = [after - before for before, after in pairwise(at_s)]
    ours, theirs = percentile(gaps, 0.99), percentile(bare, 0.99)
    print(
        f"gaps between commands in a lesson: p99 {ours * 1e3:.1f} ms, of a bare sleeper "
        f"{theirs * 1e3:.1f} ms; the PC is {busy:.0f} % busy"
    )
    assert all(turning), "a command went stale"
    assert len(gaps) > MEASURED_S * 25
    assert ours <= 2 * theirs
