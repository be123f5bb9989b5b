"""Two runs compared on the floor in 3D, side by side and on one floor."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.review_school import Past, Teacher
from tests.e2e.watch import Watch
from tests.e2e.webgl import (
    SCREENSHOT_WARNING,
    choose,
    expect_another_frame,
    frame_of,
    open_3d,
    webgl_browser,
)

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]


@pytest.fixture(scope="module")
def browser(browser: Browser) -> Iterator[Browser]:
    with webgl_browser(browser) as with_webgl:
        yield with_webgl


@pytest.fixture
def app(school: tuple[AppProcess, Past], watch: Watch) -> AppProcess:
    watch.expect(SCREENSHOT_WARNING)
    return school[0]


def test_two_runs_are_compared_in_3d(teacher: Teacher) -> None:
    crashed, _stopped, passed = teacher.past.runs
    teacher.go(f"compare/{crashed}/{passed}")
    expect(teacher["compare-side"]).to_have_count(2)
    choose(teacher.studio, "compare-view", "apart")
    open_3d(teacher.studio)
    expect(teacher["scene-3d"]).to_have_count(2)
    choose(teacher.studio, "compare-view", "together")
    expect(teacher["scene-3d"]).to_have_count(1)
    floor = teacher["scene-3d"]
    expect(teacher["scene"]).to_be_hidden()
    before = frame_of(floor)
    teacher["replay-slider"].fill("60")
    expect_another_frame(teacher.studio, floor, before)
    choose(teacher.studio, "floor-view", "false")
    expect(teacher["scene"]).to_be_visible()
