"""The floor in 3D: live, in the replay, three cameras, themes; and 2D where the browser cannot draw it."""

import gzip
import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from pinel_desktop.web.page import STATIC
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.blocks import Place, box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.finger import Finger
from tests.e2e.made_program import enter_made_group
from tests.e2e.studio import Studio
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

MAX_CHUNK_BYTES = 170_000
OPENINGS = 17  # one more than Chromium allows at a time

_COUNT_CONTEXTS = """() => {
    window.contexts = [];
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
        const context = get.call(this, kind, ...more);
        if (kind === 'webgl2' && !window.contexts.includes(context)) window.contexts.push(context);
        return context;
    };
}"""
_NO_WEBGL = """() => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
        return kind.startsWith('webgl') ? null : get.call(this, kind, ...more);
    };
}"""
_LOSE_CONTEXT = "() => window.contexts.at(-1).getExtension('WEBGL_lose_context').loseContext()"


@pytest.fixture(scope="module")
def browser(browser: Browser) -> Iterator[Browser]:
    with webgl_browser(browser) as with_webgl:
        yield with_webgl


@pytest.fixture
def app(lasting_app: AppProcess, watch: Watch) -> AppProcess:
    watch.expect(SCREENSHOT_WARNING)
    return lasting_app


def test_three_js_is_loaded_only_with_the_first_floor_in_3d() -> None:
    chunks = {file.name: file.read_text("utf-8") for file in (STATIC / "assets").glob("*.js")}
    with_three = [name for name, code in chunks.items() if "WebGLRenderer" in code]
    assert len(with_three) == 1
    assert not with_three[0].startswith(("index-", "start-"))
    for page in STATIC.glob("index*.html"):
        assert with_three[0] not in page.read_text("utf-8")
    assert len(gzip.compress(chunks[with_three[0]].encode())) < MAX_CHUNK_BYTES


def test_a_run_is_watched_in_3d_and_replayed_there(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 0.6)], speed=4.0)
    floor = open_3d(studio)
    at_start = frame_of(floor)
    studio.run()
    studio.wait_for_phase("finished")
    expect(floor).to_have_attribute("aria-label", re.compile(r"x 0,60\sm"))
    at_end = frame_of(floor)
    assert at_end != at_start
    choose(studio, "floor-camera", "eye")
    expect(floor).to_have_attribute("data-camera", "eye")
    expect_another_frame(studio, floor, at_end)

    studio.page.get_by_role("link", name="Rever").click()
    replayed = studio["scene-3d"]
    expect(replayed).to_be_visible()
    expect(studio["scene"]).to_be_hidden()
    begin = frame_of(replayed)
    studio["replay-slider"].fill("30")
    expect_another_frame(studio, replayed, begin)

    choose(studio, "floor-view", "false")
    expect(studio["scene"]).to_be_visible()
    expect(studio["scene-3d"]).to_have_count(0)


def test_keys_turn_the_view_and_choose_the_camera(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 0.2)])
    floor = open_3d(studio)
    floor.focus()
    for key in ("ArrowLeft", "ArrowUp", "+", "0"):
        before = frame_of(floor)
        studio.page.keyboard.press(key)
        expect_another_frame(studio, floor, before)
    for number, camera in enumerate(("orbit", "follow", "eye"), start=1):
        studio.page.keyboard.press(str(number))
        expect(floor).to_have_attribute("data-camera", camera)
    studio.page.keyboard.press("1")
    assert violations(studio, "scene-3d") == []


def test_a_finger_turns_the_view_and_two_come_nearer(open_studio: OpenStudio) -> None:
    studio = open_studio(has_touch=True)
    enter_made_group(studio, [("move_forward", 0.2)])
    floor = open_3d(studio)
    finger, box = Finger(studio.page), box_of(floor)
    middle = Place(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    at_first = frame_of(floor)
    finger.stroke(middle, Place(middle.x + 80, middle.y))
    expect_another_frame(studio, floor, at_first)
    turned = frame_of(floor)
    finger.spread(middle, 20, 80)
    expect_another_frame(studio, floor, turned)
    assert studio.page.evaluate("[scrollX, scrollY, visualViewport.scale]") == [0, 0, 1]


def test_the_picture_is_said_in_words(studio: Studio) -> None:
    studio.enter_new_group()
    studio["world"].select_option("furnished_room")
    floor = open_3d(studio)
    expect(floor).to_have_attribute("aria-label", re.compile(r"À frente, a 2,\d\d\sm: cadeira\."))


def test_ruler_and_start_stay_in_2d(studio: Studio) -> None:
    studio.enter_new_group()
    studio["scene-tools"].click()
    expect(studio["measure-tool"]).to_have_count(2)
    open_3d(studio)
    expect(studio["measure-tool"]).to_have_count(0)
    expect(studio["scene-picture"]).to_be_visible()


def test_opening_3d_again_and_again_leaves_one_context(studio: Studio) -> None:
    studio.page.evaluate(_COUNT_CONTEXTS)
    studio.enter_new_group()
    for _ in range(OPENINGS):
        open_3d(studio)
        choose(studio, "floor-view", "false")
        expect(studio["scene"]).to_be_visible()
    open_3d(studio)
    living = studio.page.evaluate("() => contexts.filter(one => !one.isContextLost()).length")
    assert studio.page.evaluate("() => contexts.length") > OPENINGS
    assert living == 1


def test_a_lost_context_leads_back_to_2d_and_another_try(studio: Studio) -> None:
    studio.page.evaluate(_COUNT_CONTEXTS)
    studio.enter_new_group()
    open_3d(studio)
    studio.page.evaluate(_LOSE_CONTEXT)
    expect(studio["solid-end"]).to_contain_text("O desenho em 3D parou.")
    expect(studio["scene"]).to_be_visible()
    studio["solid-again"].click()
    expect(studio["scene-3d"]).to_be_visible()
    expect(studio["scene"]).to_be_hidden()
    expect(studio["solid-end"]).to_have_count(0)


def test_without_webgl_the_floor_stays_in_2d_and_says_why_once(open_studio: OpenStudio) -> None:
    studio = open_studio()
    enter_made_group(studio, [("move_forward", 0.2)])
    studio.page.evaluate(_NO_WEBGL)
    choose(studio, "floor-view", "true")
    expect(studio["solid-end"]).to_contain_text("não consegue desenhar em 3D")
    expect(studio["scene-3d"]).to_have_count(0)
    expect(studio["scene"]).to_be_visible()
    studio["solid-end"].get_by_role("button").click()
    expect(studio["solid-end"]).to_have_count(0)
    studio.run()
    studio.wait_for_phase("finished")
