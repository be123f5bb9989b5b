"""Runs and programs on the projector: readable from the last row, stepped by keys, with or without names of groups."""

import re
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, Route, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.blocks import box_of
from tests.e2e.review_school import LONG_NAME, Past, Teacher

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

TEXTS_PER_HEIGHT = 30
# the smallest text of the page, in pixels, with its content; blocks have a scale of their own
_MIN_TEXT = """() => {
  const found = [];
  const texts = document.createTreeWalker(document.querySelector('main'), NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const { parentElement: parent, data } = texts.currentNode;
    const box = parent.getBoundingClientRect();
    if (!data.trim() || !box.width || parent.closest('.visually-hidden, title')) continue;
    if (!parent.checkVisibility({ visibilityProperty: true })) continue;
    const scale = parent.getScreenCTM?.().a ?? 1;
    found.push([parseFloat(getComputedStyle(parent).fontSize) * scale, data.trim()]);
  }
  return found.sort((one, other) => one[0] - other[0])[0];
}"""
# records the texts that the floor draws, in pixels of the page
_WATCH_FLOOR = """() => {
  window.floorTexts = [];
  const draw = CanvasRenderingContext2D.prototype.fillText;
  CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
    const { a, b } = this.getTransform();
    const size = parseFloat(/([\\d.]+)px/.exec(this.font)[1]) * Math.hypot(a, b);
    window.floorTexts.push([size / devicePixelRatio, text]);
    return draw.call(this, text, ...place);
  };
}"""


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


def _present(teacher: Teacher, *runs: str) -> Locator:
    teacher.go("/".join(["present", "same", *runs]))
    teacher.studio.wait_for_screen("presentation")
    return teacher["presentation"]


def _without_motion(teacher: Teacher) -> None:
    """Makes each step be there at once."""
    teacher.page.emulate_media(reduced_motion="reduce")


def _press(teacher: Teacher, *keys: str) -> None:
    for key in keys:
        teacher.page.keyboard.press(key)


def _tick(screen: Locator) -> float:
    return float(screen.get_attribute("data-tick") or "nan")


def _floor_texts(page: Page) -> list[tuple[float, str]]:
    page.evaluate(_WATCH_FLOOR)
    page.get_by_test_id("theme").click()  # draws the floor again
    page.wait_for_function("() => floorTexts.length > 0")
    found: list[tuple[float, str]] = page.evaluate("floorTexts")
    return found


@pytest.mark.parametrize("size", [(1366, 768), (1024, 768), (1920, 1080)], ids=str)
def test_every_text_is_a_thirtieth_of_the_picture(teacher: Teacher, size: tuple[int, int]) -> None:
    width, height = size
    _without_motion(teacher)
    crashed, _stopped, passed = teacher.past.runs
    teacher.page.set_viewport_size({"width": width, "height": height})
    for runs in ([crashed], [crashed, passed]):
        _present(teacher, *runs)
        expect(teacher["presentation-keys"]).to_be_visible()
        assert _min_text(teacher)[0] >= height / TEXTS_PER_HEIGHT, _min_text(teacher)
        _press(teacher, *["PageDown"] * 40)
        expect(teacher["presentation-run"].first).to_have_attribute("data-phase", "failed")
        text = _min_text(teacher)
        assert text[0] >= height / TEXTS_PER_HEIGHT, text
        if len(runs) == 1:  # two low floors have no numbers
            floor = min(_floor_texts(teacher.page))
            assert floor[0] >= height / TEXTS_PER_HEIGHT, floor
        scrolls = "document.documentElement.scrollWidth > innerWidth"
        assert not teacher.page.evaluate(scrolls)


def _min_text(teacher: Teacher) -> tuple[float, str]:
    found: tuple[float, str] = teacher.page.evaluate(_MIN_TEXT)
    return found


def test_a_remote_steps_from_block_to_block(teacher: Teacher) -> None:
    _without_motion(teacher)
    screen = _present(teacher, teacher.past.runs[2])
    expect(teacher["presentation-keys"]).to_be_visible()
    _press(teacher, "PageDown")
    expect(teacher["presentation-keys"]).to_have_count(0)
    first = _tick(screen)
    assert first > 0
    running = screen.locator(".pinelRunning")
    expect(running).to_have_attribute("data-id", "turn0")
    expect(teacher["status-line"]).to_contain_text("0° de 90°")
    _press(teacher, "ArrowRight")
    expect(running).to_have_attribute("data-id", "move_forward1")
    _press(teacher, "PageUp")
    assert _tick(screen) == first
    _press(teacher, "PageUp")
    assert _tick(screen) == 0
    _press(teacher, "F5")
    expect(screen).to_have_attribute("data-playing", "true")
    _press(teacher, "Enter")
    expect(screen).to_have_attribute("data-playing", "false")


def test_a_step_shows_the_robot_driving_and_waits_at_the_next_block(teacher: Teacher) -> None:
    screen = _present(teacher, teacher.past.runs[2])
    _press(teacher, "PageDown")
    running = screen.locator(".pinelRunning")
    expect(running).to_have_attribute("data-id", "turn0")
    expect(screen).to_have_attribute("data-playing", "false")
    reached = _tick(screen)
    teacher.studio.wait_for_screen("presentation")
    assert _tick(screen) == reached


def test_the_picture_is_black_until_the_next_key(teacher: Teacher) -> None:
    screen = _present(teacher, teacher.past.runs[2])
    for key in ("b", "."):
        _press(teacher, key)
        expect(teacher["presentation-black"]).to_be_visible()
        _press(teacher, "PageDown")
        expect(teacher["presentation-black"]).to_have_count(0)
        expect(screen).to_have_attribute("data-playing", "false")
    _press(teacher, "?")
    expect(teacher["presentation-keys"]).to_be_visible()


def test_names_of_groups_are_hidden_and_stay_hidden_on_this_pc(teacher: Teacher) -> None:
    crashed, _stopped, passed = teacher.past.runs
    _without_motion(teacher)
    _present(teacher, passed)
    expect(teacher["presentation-group"]).to_have_text(LONG_NAME)
    _press(teacher, "n")
    expect(teacher["presentation-group"]).to_have_text("Grupo A")
    _press(teacher, *["PageDown"] * 40)
    expect(teacher["presentation-run"]).to_have_attribute("data-phase", "finished")
    assert not [text for _, text in _floor_texts(teacher.page) if "Tatus" in text]
    teacher.page.reload()
    _present(teacher, crashed, passed)
    expect(teacher["presentation-group"]).to_have_text(["Grupo A", "Grupo B"])
    assert "Tatus" not in teacher.page.content()
    _press(teacher, "n")
    expect(teacher["presentation-group"].first).to_have_text(LONG_NAME)


def test_two_runs_are_stepped_together(teacher: Teacher) -> None:
    _without_motion(teacher)
    crashed, _stopped, passed = teacher.past.runs
    _present(teacher, crashed, passed)
    sides = teacher["presentation-run"]
    expect(sides).to_have_count(2)
    _press(teacher, "PageDown")
    expect(sides.nth(0)).not_to_have_attribute("data-tick", "0")
    ticks = {side.get_attribute("data-tick") for side in sides.all()}
    assert len(ticks) == 1
    _press(teacher, *["PageDown"] * 40)
    expect(sides.nth(0)).to_have_attribute("data-phase", "failed")
    expect(sides.nth(1)).to_have_attribute("data-phase", "finished")


def test_a_program_without_a_run_is_shown_and_stepped_block_by_block(teacher: Teacher) -> None:
    bees = next(one for one in teacher.studio.api("/groups")["groups"] if one["name"] == "Abelhas")
    teacher.go("teacher/lessons")
    teacher.studio.wait_for_screen("lesson-row")
    teacher.go(f"work/{bees['id']}")
    teacher.studio.wait_for_screen("program-card")
    buttons = [box_of(teacher[one].first)["width"] for one in ("throw-away", "present")]
    assert abs(buttons[0] - buttons[1]) < 2, "two rows of two"
    teacher["present"].click()
    expect(teacher["presentation"]).to_be_visible()
    expect(teacher["presentation-group"]).to_have_text("Abelhas")
    teacher.studio.wait_for_screen("presentation")
    expect(teacher["presentation-keys"]).not_to_contain_text("3D")
    assert _min_text(teacher)[0] >= 768 / TEXTS_PER_HEIGHT, _min_text(teacher)
    assert violations(teacher.studio, "presentation") == []
    pointed = teacher["presentation"].locator(".pinelRunning")
    _press(teacher, "PageDown", "PageDown")
    expect(pointed).to_have_attribute("data-id", "turn0")
    _press(teacher, "PageUp")
    expect(pointed).to_have_count(0)
    _press(teacher, "n", "b")
    expect(teacher["presentation-black"]).to_be_visible()
    _press(teacher, "b")
    expect(teacher["presentation-group"]).to_have_text("Grupo A")
    _press(teacher, "n", "Escape")
    expect(teacher["program-card"]).to_be_visible()


def test_it_is_accessible_in_every_theme(teacher: Teacher) -> None:
    crashed, _stopped, passed = teacher.past.runs
    _present(teacher, passed)
    assert violations(teacher.studio, "presentation") == []
    _present(teacher, crashed, passed)
    _press(teacher, "?", "3", "3", "n", "n")
    assert violations(teacher.studio, "presentation") == []


def test_it_opens_from_review_replay_and_comparison_and_leads_back(teacher: Teacher) -> None:
    crashed, _stopped, passed = teacher.past.runs
    teacher.open_lesson()
    teacher.row(LONG_NAME).get_by_test_id("review-open").click()
    expect(teacher.page.locator("[data-testid=present][data-program]")).to_be_visible()
    _there_and_back(teacher, f"{passed}$", "lesson-page")
    teacher.go(f"run/{passed}")
    _there_and_back(teacher, f"{passed}$", "replay-slider")
    teacher.go(f"compare/{crashed}/{passed}")
    _there_and_back(teacher, f"{crashed}/{passed}$", "compare-page")


def test_a_second_screen_shows_it_while_the_teacher_stays_at_the_review(teacher: Teacher) -> None:
    """The PC's second window, which the app opens (tests/desktop), is a second page here."""
    passed = teacher.past.runs[2]
    asked: list[tuple[str, Any]] = []

    def second_window(route: Route) -> None:
        asked.append((route.request.method, route.request.post_data_json))
        if route.request.method == "PUT":
            route.fulfill(json={"has_window": True})
        else:
            route.fulfill(status=200, json={})

    teacher.page.context.route("**/api/projector", second_window)
    teacher.open_lesson()
    teacher.row(LONG_NAME).get_by_test_id("review-open").click()
    teacher.page.locator(f"[data-testid=present][data-run='{passed}']").click()
    teacher.studio.eventually(lambda: asked, [("PUT", {"runs": [passed]})])
    expect(teacher["lesson-page"]).to_be_visible()
    expect(teacher["presentation"]).to_have_count(0)

    screen = teacher.page.context.new_page()
    screen.goto(f"{teacher.studio.origin}/#/present/second/{passed}")
    expect(screen.get_by_test_id("presentation-keys")).to_be_visible()
    screen.keyboard.press("PageDown")
    shown = screen.get_by_test_id("presentation")
    expect(shown.locator(".pinelRunning")).to_have_attribute("data-id", "turn0")
    screen.keyboard.press("Escape")
    teacher.studio.eventually(lambda: [method for method, _ in asked], ["PUT", "DELETE"])
    screen.close()
    expect(teacher["lesson-page"]).to_be_visible()


def _there_and_back(teacher: Teacher, runs: str, origin: str) -> None:
    teacher.studio.wait_for_screen(origin)
    first = re.search(r"[\w-]+", runs)
    assert first
    teacher.page.locator(f"[data-testid=present][data-run='{first[0]}']").first.click()
    expect(teacher["presentation"]).to_be_visible()
    assert re.search(runs, teacher.page.url)
    teacher.studio.wait_for_screen("presentation")
    _press(teacher, "Escape")
    expect(teacher[origin]).to_be_visible()
    expect(teacher["presentation"]).to_have_count(0)
