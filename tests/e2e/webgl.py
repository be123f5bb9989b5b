"""A browser that draws WebGL without a graphics card, and the floor in 3D in it."""

from collections.abc import Iterator
from contextlib import contextmanager

from playwright.sync_api import Browser, Locator, expect

from tests.e2e.conftest import CHROMIUM
from tests.e2e.studio import Studio

# a warning of this browser about each screenshot of a WebGL canvas
SCREENSHOT_WARNING = "GPU stall due to ReadPixels"


@contextmanager
def webgl_browser(other: Browser) -> Iterator[Browser]:
    """Starts such a browser beside the one of the other tests: one process has one Playwright."""
    arguments = ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"]
    browser = other.browser_type.launch(executable_path=CHROMIUM, args=arguments)
    yield browser
    browser.close()


def choose(studio: Studio, test_id: str, value: str) -> None:
    studio.page.locator(f'[data-testid="{test_id}"][data-value="{value}"]').first.click()


def open_3d(studio: Studio) -> Locator:
    """Shows the floors in 3D and waits for the first frame; returns the first floor."""
    choose(studio, "floor-view", "true")
    expect(studio["scene-3d"].first).to_be_visible()
    expect(studio["scene"].first).to_be_hidden()
    return studio["scene-3d"].first


def frame_of(floor: Locator) -> str:
    """The pixels of a floor, to compare with those of another moment."""
    return floor.screenshot().hex()


def expect_another_frame(studio: Studio, floor: Locator, before: str) -> None:
    studio.eventually(lambda: frame_of(floor) != before, True)
