"""Signs before a camera: in a program that waits for one, and practised without a program."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import expect

from pinel_desktop.messages import LANGUAGES
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_layout import SCREENS, cut

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

RECORDINGS = Path(__file__).parents[1] / "camera" / "recordings"
NO_CAMERA = "9"
IF_B = 'if robot.gesture_result == "B":\n    robot.move_forward(0.2)\n'
WAITS_FOR_B = f"robot.classify_gestures(timeout=60)\n{IF_B}"
# the camera may be slow to open on a busy PC
CAMERA_MS = 30_000


@pytest.fixture
def camera() -> str:
    return str(RECORDINGS / "b.npz")


@pytest.fixture
def app(tmp_path: Path, camera: str) -> Iterator[AppProcess]:
    app = AppProcess(tmp_path, "--camera", camera)
    app.start()
    yield app
    app.stop()


def test_a_sign_that_the_camera_sees_decides_what_the_robot_does(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, WAITS_FOR_B)
    studio.run()
    studio.wait_for_phase("finished", RUN_MS + CAMERA_MS)
    assert studio.number("pose-x") == pytest.approx(0.2, abs=0.001)
    expect(studio["status-line"]).to_contain_text("A câmera viu B (")


def test_signs_are_practised_and_spelled_without_a_program(studio: Studio) -> None:
    studio["practice"].click()
    expect(studio.page).to_have_title("Praticar sinais · PINEL")
    expect(studio["camera-picture"]).to_have_attribute("data-state", "on", timeout=CAMERA_MS)
    expect(studio["practice-text"]).to_have_value("B", timeout=CAMERA_MS)
    expect(studio["reading"]).to_have_attribute("data-kind", "sure")
    assert studio.page.evaluate("document.querySelector('.camera img').naturalWidth") > 0
    assert violations(studio) == []
    studio["practice-clear"].click()
    expect(studio["practice-text"]).to_have_value("")


@pytest.mark.parametrize("camera", [NO_CAMERA])
@pytest.mark.parametrize("language", LANGUAGES)
def test_without_a_camera_the_buttons_answer_and_nothing_is_cut_off(
    open_studio: OpenStudio, language: str
) -> None:
    studio = open_studio()
    studio["language"].select_option(language)
    studio.page.locator(f'html[lang="{language}"]').wait_for(state="attached")
    studio.enter_new_group()
    write_program(studio, WAITS_FOR_B)
    studio.run()
    expect(studio["camera-trouble"]).to_have_attribute(
        "data-code", "camera_missing", timeout=CAMERA_MS
    )
    for width, height in SCREENS:
        studio.page.set_viewport_size({"width": width, "height": height})
        assert cut(studio.page) == [], f"capture, {width} x {height}"
        none = studio["capture-letter"].last
        expect(none).to_be_in_viewport(ratio=1)
    assert violations(studio) == []
    studio["capture-letter"].and_(studio.page.locator('[data-letter="B"]')).click()
    studio.wait_for_phase("finished")
    assert studio.number("pose-x") == pytest.approx(0.2, abs=0.001)


@pytest.mark.parametrize("camera", [NO_CAMERA])
@pytest.mark.parametrize("language", LANGUAGES)
def test_practice_goes_on_without_a_camera(open_studio: OpenStudio, language: str) -> None:
    studio = open_studio()
    studio["language"].select_option(language)
    studio.page.locator(f'html[lang="{language}"]').wait_for(state="attached")
    studio["practice"].click()
    expect(studio["camera-trouble"]).to_be_visible(timeout=CAMERA_MS)
    for width, height in SCREENS:
        studio.page.set_viewport_size({"width": width, "height": height})
        assert cut(studio.page) == [], f"practice, {width} x {height}"
    studio.page.keyboard.press("l")
    expect(studio["practice-sign"].and_(studio.page.locator("[aria-pressed=true]"))).to_have_text(
        "L"
    )
    studio["practice-text"].fill("OI")
    expect(studio["practice-text"]).to_have_value("OI")
    assert violations(studio) == []


def test_a_class_teaches_a_sign_and_takes_it_back(studio: Studio) -> None:
    studio.tell("PUT", "/teacher/pin", {"pin": "2468"})
    classroom = studio.tell("POST", "/classrooms", {"name": "5º B"})["id"]
    studio["practice"].click()
    studio.page.locator(".teaching__title").click()
    studio["teach-name"].fill("b")
    studio["teach-record"].click()
    expect(studio["taught-sign"]).to_have_attribute("data-sign", "B", timeout=CAMERA_MS)
    assert violations(studio) == []
    for width, height in SCREENS:
        studio.page.set_viewport_size({"width": width, "height": height})
        assert cut(studio.page) == [], f"{width} x {height}"
    studio["forget-sign"].click()
    expect(studio["taught-sign"]).to_have_count(0)
    signs = studio.api(f"/classrooms/{classroom}/signs")["signs"]
    assert {sign["n_samples"] for sign in signs} == {0}
