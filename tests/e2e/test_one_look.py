"""A screen looks the same, whatever was opened before it."""

import re
from collections.abc import Iterable, Iterator
from typing import Any

import pytest
from playwright.sync_api import Page, Request, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.past_lesson import SQUARE, PastLesson, school_after
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

# What is on each screen when it stands.
_STANDS = {
    "start": "group-card",
    "studio": "run",
    "lesson": "review-mark",
    "compare": "replay-slider",
    "differences": "difference",
    "run": "replay-slider",
    "versions": "version-slider",
    "runs": "history-run",
    "work": "run-card",
}
# Boxes of all that is drawn with a class of ours, less Blockly's own and what stands where the mouse is. The header
# says whereto its way back leads, which is another place after another screen.
_BOXES = """() => [...document.querySelectorAll('#app .page [class]')]
  .filter((e) => !e.closest('.injectionDiv, .tip, .header'))
  .map((e) => {
    const {x, y, width, height} = e.getBoundingClientRect();
    const name = e.getAttribute('class');
    return [name, ...[x, y, width, height].map(Math.round)].join(' ');
  })"""


def _play(lesson: PastLesson) -> dict[str, str]:
    """The place of each screen that looks at the lesson."""
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
    """The app on a file with a lesson, and the place of each screen that looks at it."""
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
    studio.eventually(lambda: studio.api("/status")["engine"], "ready")  # the studio says so
    page = studio.page
    page.reload()  # the page learns that the teacher is in
    there = _seen_in_turn(page, places, places)
    page.reload()
    back = _seen_in_turn(page, places, reversed(places))
    for name in places:
        assert set(there[name]) ^ set(back[name]) == set(), name
        assert there[name] == back[name], name


def test_two_runs_side_by_side_have_a_floor_each(
    open_studio: OpenStudio, school: tuple[AppProcess, dict[str, str]]
) -> None:
    page = _teacher(open_studio()).page
    _go(page, school[1]["compare"])
    page.reload()
    floors = page.get_by_test_id("scene")
    expect(floors).to_have_count(2)
    for floor in floors.all():  # beside its blocks, which have the greater half
        box = floor.bounding_box()
        assert box is not None
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


def _seen_in_turn(page: Page, places: dict[str, str], names: Iterable[str]) -> dict[str, Any]:
    requests = UnderWay(page)
    seen = {}
    for name in names:
        _go(page, places[name])
        expect(page.get_by_test_id(_STANDS[name]).first).to_be_visible()
        seen[name] = _at_rest(page, requests)
    return seen


class UnderWay:
    """The requests of a page that are not answered yet, without the stream of events."""

    def __init__(self, page: Page) -> None:
        self.requests = set[Request]()
        page.on("request", self._begin)
        page.on("requestfinished", self._end)
        page.on("requestfailed", self._end)

    def _begin(self, request: Request) -> None:
        if not request.url.endswith("/stream"):
            self.requests.add(request)

    def _end(self, request: Request) -> None:
        self.requests.discard(request)


def _at_rest(page: Page, under_way: UnderWay) -> list[str]:
    """The boxes, once all parts of the screen are fetched and stand still."""
    before: list[str] = []
    for _ in range(100):
        page.wait_for_timeout(100)
        now = list(page.evaluate(_BOXES))
        if now == before and not under_way.requests:
            return now
        before = now
    raise AssertionError("the screen does not come to rest")
