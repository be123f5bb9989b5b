"""If the first request of a teacher's screen fails, the screen reports it and offers another attempt."""

import re

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.review_school import Past, Teacher
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


@pytest.mark.parametrize(
    ("place", "asked", "shown"),
    [
        ("teacher/lessons", "/api/teacher$", "teacher-part"),
        ("teacher/lessons", "/api/classrooms/[^/]+/lessons", "lesson-row"),
        ("teacher/classes", "/api/classrooms$", "class-group"),
        ("teacher/files", "/api/folders$", "shared-folder"),
        ("teacher/computer", "/api/computer$", "computer-name"),
        ("lesson/{lesson}", "/api/lessons/[^/]+/review", "review-group"),
        ("runs", r"/api/runs\?", "history-run"),
        ("compare/{run}/{run}", "/api/runs/[^/]+", "compare-side"),
    ],
)
def test_a_screen_that_could_not_be_loaded_can_be_tried_again(
    teacher: Teacher, watch: Watch, place: str, asked: str, shown: str
) -> None:
    watch.expect("500 (Internal Server Error)")
    address = re.compile(asked)
    teacher.page.route(address, lambda route: route.fulfill(status=500, body="{}"))
    teacher.go(place.format(lesson=teacher.past.lesson, run=teacher.past.runs[0]))
    teacher.page.reload()
    expect(teacher["not-loaded"]).to_be_visible()
    expect(teacher["problem"]).to_be_visible()
    teacher.page.unroute(address)
    teacher["try-again"].click()
    expect(teacher[shown].first).to_be_visible()
    expect(teacher["not-loaded"]).to_have_count(0)
