"""A lesson's page during the lesson, and of joined lessons of several days."""

import json
import re
from collections.abc import Iterator
from typing import NamedTuple

import pytest
from playwright.sync_api import Page, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.blocks import box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.past_lesson import SQUARE, PastLesson, school_after
from tests.e2e.review_school import PIN, sign_in
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

DAY = 24 * 60


class Past(NamedTuple):
    """Content of the database."""

    lesson: str
    group: str


def _play(lesson: PastLesson) -> Past:
    """A group edits on two days, with a pause on the first of them; there are no runs."""
    store = lesson.store
    lesson.at(1)
    emas = lesson.group("Emas")
    emas.edit(("turn", 90))
    lesson.at(3)
    emas.edit(("turn", 45))
    lesson.at(16)
    emas.edit(("turn", 30))
    lesson.at(2 * DAY)
    second = store.lessons.open(lesson.classroom, "Labirinto", "maze").id
    lesson.at(2 * DAY + 4)
    emas.edit(*SQUARE)
    store.lessons.change(second, {"part_of": lesson.lesson})
    return Past(lesson.lesson, emas.id)


@pytest.fixture(scope="module")
def school(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[AppProcess, Past]]:
    """The app on a database with two joined lessons."""
    with school_after(tmp_path_factory.mktemp("school"), _play) as school:
        yield school


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


@pytest.fixture
def past(school: tuple[AppProcess, Past]) -> Past:
    return school[1]


@pytest.fixture
def studio(open_studio: OpenStudio) -> Studio:
    """The page with the teacher signed in."""
    studio = open_studio()
    sign_in(studio)
    return studio


def test_lessons_that_were_joined_name_their_days_and_activities(
    studio: Studio, past: Past
) -> None:
    _go(studio, f"lesson/{past.lesson}")
    page = studio["lesson-page"]
    expect(page).to_contain_text("19 de novembro e 21 de novembro de 2026")
    expect(page).to_contain_text("Atividades: Um quadrado de 1 m e ")
    edits = studio["review-entry"]
    expect(edits).to_have_count(3)
    folds = page.locator(".line__fold text")
    expect(folds).to_have_text(["13 min", re.compile(r"^21\sde\snov")])
    expect(page.locator(".line__tick text").first).to_have_text(re.compile(r"^19\sde\snov"))
    edits.last.focus()
    expect(studio.page.get_by_role("tooltip")).to_contain_text(re.compile(r"21\sde\snov. às"))
    assert max(box_of(edits.nth(place))["width"] for place in range(3)) < 300
    studio.page.locator("[data-testid=lesson-time][data-value=clock]").click()
    expect(folds).to_have_text(["13 min", re.compile(r"^21\sde\snov")])


def test_the_page_is_brought_up_to_date_and_says_as_of_when_it_is(
    studio: Studio, past: Past
) -> None:
    _go(studio, f"lesson/{past.lesson}")
    group = studio["review-group"]
    refresh = studio["review-refresh"]
    expect(refresh).to_contain_text(re.compile(r"Atualizar visto às \d\d?:\d\d"))
    studio["review-open"].click()
    _send(studio.page, "PATCH", f"groups/{past.group}", name="Emas do 7º B")
    expect(group).to_have_attribute("data-name", "Emas")
    refreshed_at = refresh.get_attribute("data-at") or ""
    refresh.click()
    expect(group).to_have_attribute("data-name", "Emas do 7º B")
    expect(refresh).not_to_have_attribute("data-at", refreshed_at)
    expect(studio["review-detail"]).to_be_visible()
    expect(refresh).to_be_focused()
    _send(studio.page, "PATCH", f"groups/{past.group}", name="Emas")
    studio.page.evaluate("dispatchEvent(new Event('focus'))")
    expect(group).to_have_attribute("data-name", "Emas")
    expect(studio["review-detail"]).to_be_visible()


def test_a_page_that_is_looked_at_asks_for_the_pin_only_when_it_is_pressed(
    studio: Studio, past: Past, watch: Watch
) -> None:
    watch.expect("(FORBIDDEN)")
    studio.page.set_viewport_size({"width": 1366, "height": 420})
    _go(studio, f"lesson/{past.lesson}")
    studio["review-open"].click()
    studio.wait_for_screen("review-detail")
    studio["review-detail"].scroll_into_view_if_needed()
    scrolled = "one => one.scrollTop"
    left_at = studio["lesson-page"].evaluate(scrolled)
    assert left_at > 50
    _send(studio.page, "POST", "teacher/leave")
    with studio.page.expect_response("**/review"):
        studio.page.evaluate("dispatchEvent(new Event('focus'))")
    expect(studio["review-refresh"]).to_have_attribute("aria-busy", "false")
    expect(studio["pin"]).to_have_count(0)
    studio["review-refresh"].evaluate("one => one.click()")
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    expect(studio["review-detail"]).to_be_visible()
    studio.eventually(lambda: studio["lesson-page"].evaluate(scrolled), left_at)


def test_without_any_run_nobody_is_told_to_take_a_filter_off(studio: Studio) -> None:
    _go(studio, "runs")
    expect(studio["history-empty"]).to_contain_text("Nenhuma rodada ainda")
    expect(studio["history-empty"]).not_to_contain_text("filtro")
    expect(studio["review-refresh"]).to_be_visible()
    studio.page.locator("[data-testid=history-filter][data-name=outcome]").select_option("failed")
    expect(studio["history-empty"]).to_contain_text("Tire um filtro")


def _go(studio: Studio, place: str) -> None:
    studio.page.goto(f"{studio.page.url.split('#')[0]}#/{place}")


def _send(page: Page, method: str, place: str, **body: str) -> None:
    page.evaluate(
        """async ([method, place, body]) => {
            const headers = {"Content-Type": "application/json"};
            await fetch(`/api/${place}`, {method, headers, body});
        }""",
        [method, place, json.dumps(body)],
    )
