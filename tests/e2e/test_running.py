"""Run, Stop, faults and failures in the page."""

import re

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.made_program import enter_made_group
from tests.e2e.studio import RUN_MS, Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

_TEN_FRAMES = """() => new Promise((done) => {
  let left = 10;
  const frame = () => (left-- ? requestAnimationFrame(frame) : done());
  frame();
})"""


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def add_move(studio: Studio, metres: str) -> None:
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    blocks.type_into(blocks.by_text("andar para frente"), metres)
    studio.eventually(lambda: studio.values("distance"), [float(metres.replace(",", "."))])


def test_stop_stops_where_the_robot_is(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 3)])
    studio.run()
    studio.page.wait_for_function(
        "() => Number(document.querySelector('[data-testid=pose-x]').dataset.value) > 0.1",
        timeout=RUN_MS,
    )
    studio["stop"].click()
    studio.wait_for_phase("stopped")

    stopped_at = studio.number("pose-x")
    assert 0.1 < stopped_at < 2.5
    studio.page.evaluate(_TEN_FRAMES)
    current_at = studio.number("pose-x")
    assert current_at == stopped_at
    expect(studio.blocks.running()).to_have_count(0)
    expect(studio["status-line"]).to_have_attribute("data-tone", "notice")
    expect(studio["run"]).to_have_attribute("data-does", "run")


def test_stop_reaches_a_run_that_another_window_began(
    studio: Studio, open_studio: OpenStudio
) -> None:
    enter_made_group(studio, [("move_forward", 3)])
    second = open_studio()
    second.page.goto(studio.page.url)
    second.wait_until_open()

    studio.run()
    expect(second["run"]).to_have_attribute("data-does", "pause", timeout=RUN_MS)
    expect(second.blocks.running()).to_have_count(1)
    second["stop"].click()
    second.wait_for_phase("stopped")
    studio.wait_for_phase("stopped")
    studio.eventually(lambda: second.number("pose-x") - studio.number("pose-x"), 0.0)
    studio.eventually(lambda: studio.number("pose-x") < 2.5, True)


def test_stop_reaches_the_run_of_another_program(studio: Studio, open_studio: OpenStudio) -> None:
    enter_made_group(studio, [("move_forward", 3)])
    second = open_studio()
    enter_made_group(second, [("move_forward", 1)])

    studio.run()
    second.wait_for_phase("running")
    expect(second["status-line"]).to_have_attribute("data-tone", "notice")
    expect(second["run"]).to_be_disabled()
    expect(second.blocks.running()).to_have_count(0)
    second["stop"].click()
    studio.wait_for_phase("stopped")
    expect(second["run"]).to_be_enabled()
    expect(second["status-line"]).to_have_attribute("data-tone", "calm")


def test_pause_holds_and_resume_goes_on(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 2.5)])
    studio.run()
    expect(studio["run"]).to_have_attribute("data-does", "pause", timeout=RUN_MS)
    studio["run"].click()
    studio.wait_for_phase("paused")
    studio["run"].click()
    studio.wait_for_phase("finished")
    studio.expect_number("pose-x", pytest.approx(2.5, abs=0.001))


def put_an_empty_not(studio: Studio) -> None:
    """Builds `repetir até que` with a `não` that lacks its value."""
    studio.blocks.click_in_toolbox("flow", "repetir até que")
    studio.blocks.click_in_toolbox("logic", re.compile("^não"))


def test_a_block_with_a_fault_says_so_until_it_is_mended(studio: Studio) -> None:
    studio.enter_new_group()
    blocks = studio.blocks
    put_an_empty_not(studio)

    expect(blocks.faulty()).to_have_count(1)
    expect(blocks.faulty()).to_contain_text("não")
    expect(blocks.fault_text()).to_be_visible()
    expect(studio["status-line"]).to_have_attribute("data-tone", "notice")

    studio["undo"].click()
    expect(blocks.faulty()).to_have_count(0)
    expect(blocks.fault_text()).to_have_count(0)
    studio.eventually(lambda: studio.values("condition"), [{"sensor": "bumper"}])


def test_the_words_of_a_fault_stand_once_however_quickly_they_are_asked_for(studio: Studio) -> None:
    studio.enter_new_group()
    blocks = studio.blocks
    put_an_empty_not(studio)
    expect(blocks.fault_text()).to_be_visible()
    blocks.faulty().locator(".blocklyWarningIcon").click()
    expect(blocks.fault_text()).to_have_count(0)

    studio["fault"].evaluate("button => { button.click(); button.click(); }")
    expect(blocks.fault_text()).to_be_visible()
    studio.page.wait_for_timeout(500)  # a second message would appear a moment later
    expect(blocks.fault_text()).to_have_count(1)


def test_a_failed_run_says_why_and_leaves_the_workspace_alone(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 9)])
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "parar", blocks.beside(blocks.by_text("andar para frente")))
    studio.eventually(studio.stacks, 2)
    before = studio.workspace()

    studio.run()
    studio.wait_for_phase("failed")
    expect(studio["status-line"]).to_have_attribute("data-tone", "fault")
    expect(blocks.all()).to_have_count(3)
    studio.wait_until_saved()
    assert studio.workspace() == before


def test_a_sign_answered_by_hand_decides_what_the_robot_does(studio: Studio) -> None:
    studio.enter_new_group()
    blocks = studio.blocks
    blocks.drag_from_toolbox("gestures", "ler sinal", blocks.below(blocks.start()))
    blocks.drag_from_toolbox("logic", "se", blocks.below(blocks.by_text("ler sinal")))
    blocks.click_in_toolbox("logic", "sinal lido")
    blocks.drag_from_toolbox(
        "motion", "andar para frente", blocks.inside(blocks.by_text("então"), row_px=56)
    )
    blocks.type_into(blocks.by_text("andar para frente"), "0,2")
    studio.eventually(studio.actions, ["classify_gestures", "conditional_execution"])

    studio.run()
    expect(studio["capture"]).to_be_visible(timeout=RUN_MS)
    studio["capture-letter"].and_(studio.page.locator('[data-letter="B"]')).click()
    studio.wait_for_phase("finished")
    studio.expect_number("pose-x", pytest.approx(0.2, abs=0.001))
