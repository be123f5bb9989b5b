"""The card's check list during a run, missing results at their block, and the message of success."""

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_layout import cut

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

FANFARE = [523, 659, 784, 1047]
TWO_LEFT_TURNS = """
robot.move_forward(3)
robot.turn(90)
robot.move_forward(3)
robot.turn(90)
robot.move_forward(3)
"""


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def open_mission(studio: Studio, name: str) -> None:
    studio.enter_new_group(level=None)
    studio["open-activities"].click()
    studio.page.locator(f"[data-testid=activity-card][data-activity={name}]").click()
    studio.wait_until_open()


def hurry(studio: Studio) -> None:
    """Sets the speed for a run that the test does not check meanwhile."""
    studio.choose_level(2)
    studio["speed"].select_option("10")


def line(studio: Studio, text: str) -> Locator:
    return studio["checks"].get_by_role("listitem").filter(has_text=text)


def expect_state(studio: Studio, text: str, state: str) -> None:
    expect(line(studio, text)).to_have_attribute("data-state", state, timeout=RUN_MS)


def test_the_list_fills_while_the_robot_drives(studio: Studio) -> None:
    open_mission(studio, "left_right")
    studio.choose_level(2)
    for text in ("Chegar ao fim", "Não encostar", "Passar por padaria", "Terminar em “praça”"):
        expect_state(studio, text, "open")
    write_program(studio, f"{TWO_LEFT_TURNS}robot.wait(120)\n")
    studio["speed"].select_option("5")
    studio.run()
    expect(studio["mission-sheet"]).to_have_count(0)
    studio["mission-fold"].click()
    studio.wait_for_phase("running")
    expect(studio["status-line"]).to_have_attribute("data-tone", "moving")
    expect_state(studio, "Não encostar", "met")
    expect(line(studio, "Passar por padaria")).to_contain_text("já: padaria", timeout=RUN_MS)
    expect_state(studio, "Chegar ao fim", "open")
    studio["speed"].select_option("10")
    studio.wait_for_phase("finished")
    expect_state(studio, "Chegar ao fim", "met")
    expect_state(studio, "Passar por padaria", "broken")
    expect(line(studio, "Terminar em “praça”")).to_contain_text("a 6 m de lá")
    assert violations(studio, "checks") == []
    assert cut(studio, "checks") == []
    studio["mission-fold"].click()
    expect(studio["mission"]).to_contain_text("2 de 4")


def test_what_the_run_lacks_is_shown_at_its_block_until_the_program_changes(
    studio: Studio,
) -> None:
    open_mission(studio, "left_right")
    write_program(studio, TWO_LEFT_TURNS)
    hurry(studio)
    studio.run()
    studio.wait_for_phase("finished")
    expect(studio["status-line"]).to_contain_text(
        "Ainda não: O robô girou 180° à esquerda", timeout=RUN_MS
    )
    turn = studio.page.locator(".blocklyWorkspace .pinelAdvice")
    expect(turn).to_have_count(1)
    expect(turn).to_contain_text("girar")
    bubble = studio.page.locator(".pinelNoticeBubble")
    expect(bubble).to_have_count(0)  # the line above the floor says it already
    expect(studio.blocks.faulty()).to_have_count(0)
    studio.page.set_viewport_size({"width": 1366, "height": 640})
    studio.page.mouse.move(600, 500)
    studio.page.mouse.wheel(0, -3000)
    expect(turn).not_to_be_in_viewport()
    studio["advice-block"].click()
    expect(turn).to_be_in_viewport()
    expect(bubble).to_be_in_viewport()
    expect(bubble).to_contain_text("O robô girou 180° à esquerda")

    studio.blocks.type_into(turn, "45")
    expect(turn).to_have_count(0)
    expect(bubble).to_have_count(0)
    expect(studio["advice-block"]).to_have_count(0)


def test_the_replay_opens_at_what_the_run_lacks(studio: Studio) -> None:
    open_mission(studio, "left_right")
    write_program(studio, TWO_LEFT_TURNS)
    hurry(studio)
    studio.run()
    lacks = "Ainda não: O robô girou 180° à esquerda"
    expect(studio["status-line"]).to_contain_text(lacks, timeout=RUN_MS)
    studio["past-run-replay"].click()
    expect(studio["status-line"]).to_contain_text(lacks)
    expect(studio.page.locator(".pinelAdvice")).to_contain_text("girar")
    studio["replay-slider"].press("Home")
    expect(studio["status-line"]).not_to_contain_text("Ainda não")


def test_the_robot_of_another_case_is_shown_on_the_floor(studio: Studio) -> None:
    studio.page.emulate_media(reduced_motion="reduce")
    open_mission(studio, "to_the_red")
    write_program(studio, "robot.move_forward(1)\n")
    hurry(studio)
    studio.run()
    expect(studio["status-line"]).to_contain_text("Ainda não", timeout=RUN_MS)
    studio["mission-fold"].click()
    case = studio["case"].first
    studio.wait_for_screen("cases-tried")
    own = studio.floor_picture()
    case.click()
    expect(case).to_have_attribute("aria-pressed", "true")
    studio.eventually(lambda: studio.floor_picture() == own, False)
    assert violations(studio, "cases-tried") == []
    case.click()
    studio.eventually(lambda: studio.floor_picture() == own, True)
    case.click()
    studio.page.keyboard.press("Escape")
    studio.eventually(lambda: studio.floor_picture() == own, True)


def test_success_is_seen_heard_where_wanted_and_leads_on(studio: Studio) -> None:
    studio.page.add_init_script(
        "window.tones = []; const Own = window.OscillatorNode;"
        "window.OscillatorNode = class extends Own {"
        "  constructor(a, o) { super(a, o); window.tones.push(o.frequency); } };"
    )
    studio.page.reload()
    open_mission(studio, "to_the_bakery")
    write_program(studio, "robot.move_forward(3)\n")
    studio.hurry()
    studio.run()
    expect(studio["mission-done"]).to_contain_text("Missão cumprida!", timeout=RUN_MS)
    assert studio.page.evaluate("tones") == []
    for text in ("Chegar ao fim", "Não encostar", "Terminar em “padaria”"):
        expect_state(studio, text, "met")
    assert violations(studio, "mission-done") == []
    studio.page.set_viewport_size({"width": 1024, "height": 768})
    assert cut(studio, "mission-done") == []
    studio["success-sound"].click()
    assert studio.page.evaluate("tones") == FANFARE
    # in real time, because the test checks what disappears while the robot drives
    studio.page.unroute("**/api/runs")
    studio.run()
    studio.wait_for_phase("running")
    expect(studio["mission-done"]).to_have_count(0)
    expect(studio["mission-done"]).to_be_visible(timeout=RUN_MS)
    studio.eventually(lambda: studio.page.evaluate("tones")[4:][-4:], FANFARE)
    n_tones = studio.page.evaluate("tones.length")
    studio["success-sound"].click()
    assert studio.page.evaluate("tones.length") == n_tones
    studio["mission-next"].click()
    expect(studio["mission"]).to_contain_text("Pão e volta")
    expect_state(studio, "Passar por padaria", "open")


def test_the_other_cases_that_were_tried_are_named(studio: Studio) -> None:
    open_mission(studio, "stop_before_wall")
    write_program(studio, "robot.move_forward(6.2)\n")
    hurry(studio)
    studio.run()
    expect(studio.page.locator(".mission__mark[data-state=broken]")).to_have_count(
        2, timeout=RUN_MS
    )
    studio["mission-fold"].click()
    tried = studio["cases-tried"].get_by_role("listitem")
    expect(tried).to_have_count(2, timeout=RUN_MS)
    expect(tried.first).to_contain_text("a partida 1,75 m à frente")
    expect(tried.first).to_have_attribute("data-state", "broken")
    assert violations(studio, "cases-tried") == []
