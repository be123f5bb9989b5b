"""A screen has the same layout, whichever screens were opened before."""

import re
from collections.abc import Iterable, Iterator
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.blocks import box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.past_lesson import SQUARE, PastLesson, school_after
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

# An element that shows when each screen is complete.
_SHOWN = {
    "start": "group-card",
    "studio": "run",
    "lesson": "review-entry",
    "compare": "replay-slider",
    "differences": "difference",
    "run": "replay-slider",
    "versions": "version-slider",
    "runs": "history-run",
    "work": "run-card",
}
# Boxes of all elements with a class of ours, except Blockly's own and the tooltip at the mouse. The
# header is left out, because its link back names the previous screen.
_BOXES = """() => [...document.querySelectorAll('#app .page [class]')]
  .filter((e) => !e.closest('.injectionDiv, .tip, .header'))
  .map((e) => {
    const {x, y, width, height} = e.getBoundingClientRect();
    const name = e.getAttribute('class');
    return [name, ...[x, y, width, height].map(Math.round)].join(' ');
  })"""


def _play(lesson: PastLesson) -> dict[str, str]:
    """Writes the lesson; returns the address of each screen that shows it."""
    lesson.at(2)
    group = lesson.group("Abelhas")
    first = group.edit(("move_forward", 1))
    runs = [group.run()]
    lesson.at(4)
    second = group.edit(*SQUARE)
    runs.append(group.run())
    return {
        "start": "",
        "studio": f"program/{group.program}",
        "lesson": f"lesson/{lesson.lesson}",
        "compare": f"compare/{runs[0]}/{runs[1]}",
        "differences": f"differences/{group.program}/{first}/{second}",
        "run": f"run/{runs[1]}",
        "versions": f"versions/{group.program}/{second}",
        "runs": "runs",
        "work": f"work/{group.id}",
    }


@pytest.fixture(scope="module")
def school(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[AppProcess, dict[str, str]]]:
    """The app on a database with a lesson, and the address of each screen that shows it."""
    with school_after(tmp_path_factory.mktemp("school"), _play) as school:
        yield school


@pytest.fixture
def app(school: tuple[AppProcess, dict[str, str]]) -> AppProcess:
    return school[0]


def test_screens_look_the_same_whatever_was_opened_before(
    open_studio: OpenStudio, school: tuple[AppProcess, dict[str, str]]
) -> None:
    places = school[1]
    studio = _teacher(open_studio())
    # the studio shows this status
    studio.eventually(lambda: studio.api("/status")["engine"], "ready")
    page = studio.page
    page.reload()  # the page reads that the teacher is signed in
    there = _boxes_by_screen(studio, places, places)
    page.reload()
    back = _boxes_by_screen(studio, places, reversed(places))
    for name in places:
        changed = {
            "there": set(there[name]) - set(back[name]),
            "back": set(back[name]) - set(there[name]),
        }
        assert not any(changed.values()), f"{name}: {changed}"
        assert there[name] == back[name], name


def test_two_runs_side_by_side_have_a_floor_each(
    open_studio: OpenStudio, school: tuple[AppProcess, dict[str, str]]
) -> None:
    page = _teacher(open_studio()).page
    _go(page, school[1]["compare"])
    page.reload()
    page.locator("[data-testid=compare-view][data-value=apart]").click()
    floors = page.get_by_test_id("scene")
    expect(floors).to_have_count(2)
    for floor in (floors.first, floors.last):  # beside the blocks, which have the greater half
        box = box_of(floor)
        assert box["height"] > 300
        assert box["width"] > 250


def _teacher(studio: Studio) -> Studio:
    expect(studio["group-card"].first).to_be_visible()
    studio.page.evaluate(
        """async () => {
            const {has_pin} = await (await fetch('/api/teacher')).json();
            await fetch(has_pin ? '/api/teacher/enter' : '/api/teacher/pin', {
                method: has_pin ? 'POST' : 'PUT',
                headers: {'Content-Type': 'application/json'},
                body: '{"pin": "314159"}',
            });
        }"""
    )
    return studio


def _go(page: Page, place: str) -> None:
    page.evaluate("place => { location.hash = `#/${place}`; }", place)
    page.wait_for_url(re.compile(f"#/{place}$"))


def _boxes_by_screen(
    studio: Studio, places: dict[str, str], names: Iterable[str]
) -> dict[str, Any]:
    boxes = {}
    for name in names:
        _go(studio.page, places[name])
        boxes[name] = _boxes(studio, name)
    return boxes


def _boxes(studio: Studio, name: str) -> list[str]:
    """Returns the boxes when all parts of the screen are loaded and at rest."""
    studio.wait_for_screen(_SHOWN[name])
    before: list[str] = []
    for _ in range(100):
        studio.page.wait_for_timeout(100)
        now = list(studio.page.evaluate(_BOXES))
        if now == before:
            return now
        before = now
    raise AssertionError("the screen does not come to rest")
