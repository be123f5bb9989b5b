"""At a zoom of 200 % nothing is cut, nothing covers a control, and no screen scrolls sideways."""

import re

import pytest
from playwright.sync_api import ViewportSize

from tests.e2e.app_process import AppProcess
from tests.e2e.layout_faults import layout_faults
from tests.e2e.review_school import LONG_NAME, Past, Teacher

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

NARROW: ViewportSize = {"width": 683, "height": 768}
# names, and the program's name in the header, may be shortened
MAY_BE_CUT = re.compile(f"{LONG_NAME[:20]}|program-name")


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


def test_no_screen_outside_the_studio_has_faults_of_layout(teacher: Teacher) -> None:
    teacher.page.set_viewport_size(NARROW)
    crashed, _stopped, passed = teacher.past.runs
    program = teacher.studio.api(f"/groups/{teacher.past.group}/programs")["programs"][0]["id"]
    found: dict[str, list[str]] = {}
    for place, shows in {
        "teacher/lessons": "lesson-row",
        "": "group-card",
        "practice": "practice-mode",
        f"work/{teacher.past.group}": "program-card",
        f"album/{teacher.past.group}": "album-place",
        f"run/{passed}": "replay-slider",
        f"compare/{crashed}/{passed}": "compare-side",
        f"versions/{program}": "version-shown",
        "runs": "compare-choose",
        "teacher/files": "shared-folder",
        f"present/same/program/{program}": "presentation",
    }.items():
        teacher.go(place)
        teacher.studio.wait_for_screen(shows)
        faults = [one for one in layout_faults(teacher.page) if not MAY_BE_CUT.search(one)]
        if faults:
            found[place] = faults
    assert found == {}
