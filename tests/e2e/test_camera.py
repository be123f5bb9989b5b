"""Signs at a camera: in a program that waits for a sign, and in practice without a program."""

import re
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Locator, expect

from pinel_desktop.camera.client import IDLE_OFF_S
from pinel_desktop.messages import LANGUAGES
from storage import open_store
from tests.camera.taught_hands import packed, shown, write_doubtful_number, write_unknown_hand
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.delays import slower
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_layout import SCREENS, cut

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

RECORDINGS = Path(__file__).parents[1] / "camera" / "recordings"
NO_CAMERA = "9"
UNKNOWN_SIGN = "strange"
DOUBTFUL_NUMBER = "doubtful"
THREE_FINGERS = str(RECORDINGS / "w.npz")
AS_MANY_METRES = "robot.read_number(timeout=60)\nrobot.move_forward(robot.number_shown)\n"
IF_B = 'if robot.gesture_result == "B":\n    robot.move_forward(0.2)\n'
WAITS_FOR_B = f"robot.classify_gestures(timeout=60)\n{IF_B}"
# the camera may be slow to open on a busy PC
CAMERA_MS = 30_000 * slower()


@pytest.fixture
def camera() -> str:
    return str(RECORDINGS / "b.npz")


@pytest.fixture
def app(tmp_path: Path, camera: str) -> Iterator[AppProcess]:
    if camera == UNKNOWN_SIGN:  # a hand that shows no letter
        camera = str(write_unknown_hand(tmp_path / "strange.npz"))
    if camera == DOUBTFUL_NUMBER:
        camera = str(write_doubtful_number(tmp_path / "doubtful.npz"))
    app = AppProcess(tmp_path, "--camera", camera)
    app.start()
    yield app
    app.stop()


def test_a_sign_that_the_camera_sees_decides_what_the_robot_does(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, WAITS_FOR_B)
    studio.run()
    studio.wait_for_phase("finished", RUN_MS + CAMERA_MS)
    studio.expect_number("pose-x", pytest.approx(0.2, abs=0.001))
    expect(studio["status-line"]).to_contain_text("A câmera viu B (")


def test_a_sign_after_which_nothing_moves_is_shown_large_marked_on_the_strip_and_replayed(
    studio: Studio,
) -> None:
    studio.enter_new_group()
    write_program(studio, "robot.classify_gestures(timeout=60)\n")
    studio.run()
    card, marks = studio["captured"].filter(has_text="Vi um B"), studio["capture-mark"]
    card.wait_for(timeout=CAMERA_MS)  # by frames: it is shown for a moment
    expect(card).to_be_hidden()
    expect(marks).to_have_text(["B"])
    expect(marks).to_have_accessible_name(re.compile("A câmera viu B"))
    marks.press("Enter")
    card.wait_for()
    assert violations(studio, "past-run-slider") == []
    studio["past-run-replay"].click()
    expect(studio["replay-play"]).to_have_attribute("data-does", "play")
    studio["replay-play"].click()
    card.wait_for()
    expect(card).to_be_hidden()
    expect(studio["replay-play"]).to_have_attribute("data-does", "play")
    expect(marks).to_have_text(["B"])


@pytest.mark.parametrize("camera", [THREE_FINGERS])
def test_the_robot_drives_as_many_metres_as_fingers_are_raised(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, AS_MANY_METRES)
    assert studio.commands()[1]["distance"] == {"gesture": "number"}
    studio.run()
    studio.wait_for_phase("finished", RUN_MS + CAMERA_MS)
    studio.expect_number("pose-x", pytest.approx(3.0, abs=0.001))
    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    (run,) = studio.api(f"/groups/{group}/runs")["runs"]
    events = studio.api(f"/runs/{run['id']}/events")["events"]
    numbers = [event for event in events if event["type"] == "gesture_result"]
    assert [(one["what"], one["result"], one["by"]) for one in numbers] == [
        ("number", "3", "camera")
    ]
    studio.page.goto(f"{studio.origin}/#/run/{run['id']}")
    expect(studio["replay-slider"]).to_be_visible()


@pytest.mark.parametrize("camera", [DOUBTFUL_NUMBER])
def test_a_number_in_doubt_is_shown_as_two_and_answered_by_hand(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, AS_MANY_METRES)
    studio.run()
    expect(studio["reading"]).to_have_attribute("data-kind", "unsure", timeout=CAMERA_MS)
    expect(studio["reading"]).to_contain_text("3 ou 4?")
    assert violations(studio, "reading") == []
    studio["capture-letter"].and_(studio.page.locator('[data-letter="2"]')).click()
    studio.wait_for_phase("finished")
    studio.expect_number("pose-x", pytest.approx(2.0, abs=0.001))


@pytest.mark.parametrize("camera", [NO_CAMERA])
def test_a_number_is_answered_without_a_camera_and_no_button_is_cut_off(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, AS_MANY_METRES.replace("60", "600"))
    studio.run()
    expect(studio["capture-letter"]).to_have_count(12)
    for layout in each_layout(studio):
        assert cut(studio, "capture-letter") == [], layout
        expect(studio["capture-letter"].last, layout).to_be_in_viewport(ratio=1)
    assert violations(studio, "capture-letter") == []
    studio["capture-letter"].last.click()
    studio.wait_for_phase("failed")
    expect(studio["status-line"]).to_contain_text("−1")


def test_signs_are_practised_and_spelled_without_a_program(studio: Studio) -> None:
    studio["practice"].click()
    expect(studio.page).to_have_title("Praticar letras e sinais · PINEL")
    expect(studio["camera-picture"]).to_have_attribute("data-state", "on", timeout=CAMERA_MS)
    expect(studio["practice-text"]).to_have_value("B", timeout=CAMERA_MS)
    expect(studio["reading"]).to_have_attribute("data-kind", "sure")
    assert violations(studio, "reading") == []
    assert studio.page.evaluate("document.querySelector('.camera img').naturalWidth") > 0
    studio["practice-text"].fill("XYZ")
    studio["practice-clear"].click()
    # the hand still shows B, which may be spelled again at once
    expect(studio["practice-text"]).to_have_value(re.compile("^B*$"))


def test_practice_leads_back_to_the_program_of_the_own_group_only(studio: Studio) -> None:
    back = studio.page.get_by_role("link", name="Voltar ao programa")
    studio.enter_new_group("Os Tatus")
    studio.page.evaluate("location.hash = '#/practice'")
    expect(back).to_be_visible()
    back.click()
    studio["home"].click()
    studio["practice"].click()
    expect(studio["practice-text"]).to_be_visible()
    expect(back).to_have_count(0)


def test_practice_on_a_low_screen_shows_letter_and_choice_of_letters(studio: Studio) -> None:
    studio.page.set_viewport_size({"width": 1024, "height": 600})
    studio["practice"].click()
    expect(studio["practice-text"]).to_have_value("B", timeout=CAMERA_MS)
    drawing = studio.page.locator(".imitation .sign-drawing").bounding_box()
    letters = studio.page.locator(".imitation__letters").bounding_box()
    assert drawing is not None
    assert letters is not None
    assert drawing["height"] >= 100
    assert letters["height"] >= 2 * 44  # two rows, the others scroll
    for control in ("practice-text", "practice-clear", "camera-picture"):
        expect(studio[control]).to_be_in_viewport(ratio=1)


def each_layout(studio: Studio) -> Iterator[str]:
    """Yields each combination of language and window size; the texts of faults depend on the language."""
    for language in LANGUAGES:
        studio.choose_language(language)
        for width, height in SCREENS:
            studio.page.set_viewport_size({"width": width, "height": height})
            yield f"{language}, {width} x {height}"


@pytest.mark.parametrize("camera", [NO_CAMERA])
def test_without_a_camera_the_buttons_answer_and_nothing_is_cut_off(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, WAITS_FOR_B.replace("60", "600"))
    studio.run()
    expect(studio["camera-trouble"]).to_have_attribute(
        "data-code", "camera_missing", timeout=CAMERA_MS
    )
    for layout in each_layout(studio):
        assert cut(studio, "camera-trouble") == [], layout
        none = studio["capture-letter"].last
        expect(none, layout).to_be_in_viewport(ratio=1)
    expect_names_and_contrast(studio, "camera-trouble")
    studio["capture-letter"].and_(studio.page.locator('[data-letter="B"]')).click()
    studio.wait_for_phase("finished")
    studio.expect_number("pose-x", pytest.approx(0.2, abs=0.001))


def expect_names_and_contrast(studio: Studio, shown: str) -> None:
    """Checks names in every language and contrast in one; colours do not depend on the language."""
    studio.page.set_viewport_size({"width": 1366, "height": 768})
    for language in LANGUAGES:
        studio.choose_language(language)
        found = violations(studio, shown, every_theme=language == LANGUAGES[0])
        assert found == [], language


@pytest.mark.parametrize("camera", [NO_CAMERA])
def test_practice_goes_on_without_a_camera(studio: Studio) -> None:
    studio["practice"].click()
    expect(studio["camera-trouble"]).to_be_visible(timeout=CAMERA_MS)
    for layout in each_layout(studio):
        assert cut(studio, "camera-trouble") == [], layout
    studio.page.keyboard.press("l")
    expect(studio["practice-sign"].and_(studio.page.locator("[aria-pressed=true]"))).to_have_text(
        "L"
    )
    studio["practice-text"].fill("OI")
    expect(studio["practice-text"]).to_have_value("OI")
    expect_names_and_contrast(studio, "camera-trouble")
    studio["practice-clear"].click()
    expect(studio["practice-text"]).to_have_value("")


@pytest.mark.parametrize("camera", [NO_CAMERA])
def test_a_round_of_words_is_played_with_keys_and_says_what_went_well(studio: Studio) -> None:
    studio["practice"].click()
    studio["practice-mode"].last.click()
    target = studio["game-word"]
    first = target.get_attribute("aria-label") or ""
    studio["game-hint"].click()
    expect(studio.page.locator(".game .sign-drawing")).to_be_visible()
    for layout in each_layout(studio):
        assert cut(studio, "game-word") == [], layout
        expect(studio["game-skip"], layout).to_be_in_viewport(ratio=1)
    expect_names_and_contrast(studio, "game-word")
    studio.choose_language("pt-BR")
    for letter in first.lower():
        studio.page.keyboard.press(letter)
    expect(target).not_to_have_attribute("aria-label", first)
    for _ in range(4):
        studio["game-skip"].click()
    expect(studio["game-outcome"]).to_contain_text(f"Vocês soletraram: {first}.")
    expect(studio["game-outcome"]).to_contain_text(f"Para praticar mais: {first[0]}.")
    assert violations(studio, "game-outcome") == []
    studio["game-again"].click()
    expect(target).to_be_visible()


def test_a_class_teaches_a_sign_and_takes_it_back(studio: Studio) -> None:
    studio.send("PUT", "/teacher/pin", {"pin": "2468"})
    classroom = studio.send("POST", "/classrooms", {"name": "5º B"})["id"]
    studio["practice"].click()
    studio.page.locator(".teaching__title").click()
    studio["teach-name"].fill("b")
    studio["teach-record"].click()
    expect(studio["taught-sign"]).to_have_attribute("data-sign", "B", timeout=CAMERA_MS)
    assert violations(studio, "taught-sign") == []
    for width, height in SCREENS:
        studio.page.set_viewport_size({"width": width, "height": height})
        assert cut(studio, "taught-sign") == [], f"{width} x {height}"
    studio["teach-letter"].and_(studio.page.locator('[data-letter="J"]')).click()
    for layout in each_layout(studio):
        assert cut(studio, "taught-sign") == [], layout
    studio["forget-sign"].click()
    expect(studio["taught-sign"]).to_have_count(0)
    signs = studio.api(f"/classrooms/{classroom}/signs")["signs"]
    assert {sign["n_samples"] for sign in signs} == {0}


def sign_on_block(studio: Studio) -> Locator:
    """Returns the sign that the only comparison names."""
    field = studio.page.locator(".blocklyDropdownField")
    return studio.page.locator(".blocklyBlockCanvas .blocklyShadow").filter(has=field).last


def choose_sign(studio: Studio, name: str) -> None:
    sign_on_block(studio).click()
    menu = studio.page.locator(".blocklyDropDownDiv .blocklyMenuItem")
    menu.get_by_text(name, exact=True).click()
    expect(sign_on_block(studio)).to_contain_text(name)


def warned(studio: Studio) -> Locator:
    """Blocks that name a sign which the camera does not recognise."""
    return studio.page.locator(".blocklyBlockCanvas .pinelNotice")


@pytest.mark.parametrize("camera", [UNKNOWN_SIGN])
def test_what_a_class_teaches_is_offered_by_blocks_answered_by_the_camera_and_replayed(
    studio: Studio,
) -> None:
    studio.send("PUT", "/teacher/pin", {"pin": "2468"})
    studio.send("POST", "/classrooms", {"name": "5º B"})
    studio["practice"].click()
    studio.page.locator(".teaching__title").click()
    studio["teach-name"].fill("vai")
    studio["teach-record"].click()
    expect(studio["taught-sign"]).to_have_attribute("data-sign", "vai", timeout=CAMERA_MS)
    studio["home"].click()
    studio.enter_new_group()
    write_program(studio, WAITS_FOR_B)
    choose_sign(studio, "vai")
    expect(warned(studio)).to_have_count(0)
    studio.run()
    studio.wait_for_phase("finished", RUN_MS + CAMERA_MS)
    studio.expect_number("pose-x", pytest.approx(0.2, abs=0.001))
    expect(studio["status-line"]).to_contain_text("A câmera viu vai, um sinal da turma (")
    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    (run,) = studio.api(f"/groups/{group}/runs")["runs"]
    events = studio.api(f"/runs/{run['id']}/events")["events"]
    taught = [event for event in events if event["type"] == "gesture_result"]
    assert [(event["result"], event["by"]) for event in taught] == [("vai", "taught")]
    studio.page.goto(f"{studio.origin}/#/run/{run['id']}")
    expect(studio["replay-slider"]).to_be_visible()


@pytest.mark.parametrize("camera", [NO_CAMERA])
def test_a_sign_that_the_class_does_not_know_is_warned_of_and_can_be_answered(
    studio: Studio,
) -> None:
    studio.enter_new_group()
    write_program(studio, WAITS_FOR_B.replace('"B"', '"pare"'))
    expect(warned(studio)).to_have_count(1)
    assert studio.commands()[1]["condition"]["args"][1] == "pare"
    studio.page.locator(".pinelNotice > .blocklyWarningIcon").click()
    expect(studio.blocks.fault_text()).to_contain_text("pare")
    studio.run()
    answer = studio["capture-letter"].and_(studio.page.locator('[data-letter="pare"]'))
    expect(answer).to_be_visible()
    assert violations(studio, answer) == []
    answer.click()
    studio.wait_for_phase("finished")
    studio.expect_number("pose-x", pytest.approx(0.2, abs=0.001))
    choose_sign(studio, "W")
    expect(warned(studio)).to_have_count(0)


@pytest.mark.parametrize("camera", [NO_CAMERA])
def test_sixty_signs_of_a_class_leave_nothing_cut_off(
    open_studio: OpenStudio, app: AppProcess
) -> None:
    app.stop()
    with open_store(app.database) as store:
        classroom = store.classrooms.create("5º B").id
        for n in range(60):
            name = f"sinal de nome comprido {n}" if n % 7 == 0 else f"sinal {n}"
            store.taught_signs.add(classroom, name, packed(shown("B")[:2]))
    studio = open_studio(app.start())
    studio.enter_new_group()
    write_program(studio, WAITS_FOR_B.replace("60", "600").replace('"B"', '"sinal 33"'))
    studio.run()
    field = studio["capture-find"]
    for layout in each_layout(studio):
        assert cut(studio, "capture-letter") == [], layout
        expect(field, layout).to_be_in_viewport(ratio=1)
        expect(studio["capture-letter"].first, layout).to_be_in_viewport(ratio=1)
    expect_names_and_contrast(studio, "capture-letter")
    field.fill("l 33")
    field.press("Enter")
    studio.wait_for_phase("finished")
    studio.expect_number("pose-x", pytest.approx(0.2, abs=0.001))
    studio["practice"].click()
    expect(studio["practice-sign"]).to_have_count(21 + 60)
    for layout in each_layout(studio):
        assert cut(studio, "practice-sign") == [], f"practice, {layout}"
        expect(studio["practice-hand"].first, layout).to_be_in_viewport(ratio=1)


def test_the_teacher_tries_the_camera_which_is_off_again_afterwards(studio: Studio) -> None:
    studio.send("PUT", "/teacher/pin", {"pin": "2468"})
    studio.page.goto(f"{studio.origin}/#/teacher/camera")
    studio.page.reload()
    expect(studio["camera-ready"]).to_have_attribute("data-ready", "true", timeout=CAMERA_MS)
    studio.expect_each(studio["camera-point"], "data-finding", ["good"] * 4)
    expect(studio["camera-point"].last).to_have_text("Letra ou sinal visto: B")
    assert violations(studio, "camera-point") == []
    for width, height in SCREENS:
        studio.page.set_viewport_size({"width": width, "height": height})
        assert cut(studio, "camera-point") == [], f"{width} x {height}"
    assert studio.api("/camera")["state"] == "on"
    studio.page.goto(f"{studio.origin}/#/teacher/lessons")
    expect(studio["camera-picture"]).to_have_count(0)
    deadline = time.monotonic() + IDLE_OFF_S + 30
    while studio.api("/camera")["state"] != "off":
        assert time.monotonic() < deadline
        studio.page.wait_for_timeout(100)


@pytest.mark.parametrize("camera", [NO_CAMERA])
def test_the_teacher_is_told_that_there_is_no_camera_and_what_to_do(studio: Studio) -> None:
    studio.send("PUT", "/teacher/pin", {"pin": "2468"})
    studio.page.goto(f"{studio.origin}/#/teacher/camera")
    studio.page.reload()
    expect(studio["camera-trouble"]).to_contain_text("Liguem o cabo", timeout=CAMERA_MS)
    expect(studio["camera-ready"]).to_have_attribute("data-ready", "false")
    expect(studio["camera-point"].first).to_have_attribute("data-finding", "missing")
    assert violations(studio, "camera-trouble") == []
