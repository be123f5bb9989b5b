"""A lesson with the camera by clicks: the teacher prepares it, three groups sign, the teacher reviews it."""

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_camera import CAMERA_MS, RECORDINGS
from tests.e2e.test_classes import PIN, open_lesson, prepare, to_part

# its parts are tested in each run: a sign decides, the verdict, the review of a lesson
pytestmark = [pytest.mark.e2e, pytest.mark.nightly, pytest.mark.timeout(300)]

READ = "robot.classify_gestures(timeout=30)\n"
MOVE_IF_B = 'if robot.gesture_result == "B":\n    robot.move_forward(1.0)\n'
SOLVED = READ + MOVE_IF_B
ALWAYS = READ + "robot.move_forward(1.0)\n"
BEFORE_READING = MOVE_IF_B + READ


@pytest.fixture
def app(tmp_path: Path) -> Iterator[AppProcess]:
    app = AppProcess(tmp_path, "--camera", str(RECORDINGS / "b.npz"))
    app.start()
    yield app
    app.stop()


def test_a_lesson_with_the_camera(studio: Studio, open_studio: OpenStudio) -> None:
    prepare(studio)
    to_part(studio, "camera")
    expect(studio["camera-ready"]).to_have_attribute("data-ready", "true", timeout=CAMERA_MS)
    to_part(studio, "lessons")
    open_lesson(studio, "Sinais", "sign_b")
    studio["sign-out"].click()

    status_texts = {}
    for name, program in {
        "Araras": SOLVED,
        "Botos": ALWAYS,
        "Corujas": BEFORE_READING,
    }.items():
        group = open_studio()
        group.enter_group(name)
        expect(group["mission"]).to_contain_text("Só com o B")
        write_program(group, program)
        for _ in range(3 if name == "Corujas" else 1):
            run = drive(group, name)
        expected = "Conseguiram" if program == SOLVED else "Ainda não"
        expect(group["status-line"]).to_contain_text(expected, timeout=RUN_MS)
        group.wait_for_screen("status-line")
        status_texts[name] = group["status-line"].inner_text()
        events = group.api(f"/runs/{run['id']}/events")["events"]
        assert {"camera"} == {one["by"] for one in events if one["type"] == "gesture_result"}
        group.page.close()
    assert "Botos" in status_texts
    assert status_texts["Botos"] != status_texts["Corujas"], status_texts

    studio["teacher-link"].click()
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    to_part(studio, "lessons")
    studio["lesson-link"].first.click()
    expect(studio["lesson-summary"]).to_contain_text("Cumpriram a atividade: 1 de 3")
    expect(studio["lesson-summary"]).to_contain_text("Precisam de ajuda")
    expect(studio["lesson-stuck"]).to_have_text(["Corujas"])


def drive(studio: Studio, group: str) -> dict[str, Any]:
    """Runs the program and returns the run after its verdict."""

    def runs() -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = studio.api(f"/groups/{group_id(studio, group)}/runs")["runs"]
        return found

    n_before = len(runs())
    studio.run()
    deadline = time.monotonic() + (RUN_MS + CAMERA_MS) / 1000
    while len(now := runs()) == n_before or now[0]["passed"] is None:
        assert time.monotonic() < deadline, now
        studio.page.wait_for_timeout(200)
    return now[0]


def group_id(studio: Studio, name: str) -> str:
    groups = studio.api("/groups")["groups"]
    return str(next(group["id"] for group in groups if group["name"] == name))
