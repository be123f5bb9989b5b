"""Steps, breakpoints and speed of a run."""

import time

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.python_pane import write_program
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def put_two_moves(studio: Studio, back_m: float = 0.2) -> None:
    """Builds two moves: forward, then backward."""
    write_program(studio, f"robot.move_forward(0.2)\nrobot.move_backward({back_m})\n")
    studio.eventually(lambda: studio.values("distance"), [0.2, back_m])


def expect_paused_before(studio: Studio, block: str) -> None:
    """Waits for the end of a step, by the id of the next block: the run was paused before the step too."""
    expect(studio.blocks.running()).to_have_attribute("data-id", block)
    studio.wait_for_phase("paused")


def dots(studio: Studio) -> Locator:
    return studio.page.locator(".blocklyBlockCanvas .pinelBreakpoint")


def test_a_run_is_steered_by_keys(studio: Studio) -> None:
    studio.enter_new_group()
    put_two_moves(studio, 3)
    forward, backward = (command["block"] for command in studio.commands())
    press = studio.page.keyboard.press
    press("F7")
    expect_paused_before(studio, forward)
    press("F10")
    expect_paused_before(studio, backward)
    press("F8")
    studio.wait_for_phase("running")
    press("Shift+F8")
    studio.wait_for_phase("stopped")


def test_a_program_is_run_block_by_block(studio: Studio) -> None:
    studio.enter_new_group()
    put_two_moves(studio)
    studio["step"].click()
    studio.wait_for_phase("paused")
    expect(studio["run"]).to_have_attribute("data-does", "resume")
    studio.expect_number("pose-x", pytest.approx(0.0, abs=1e-6))

    expect(studio.blocks.running()).to_contain_text("andar para frente")
    studio["step"].click()
    expect(studio["pose-x"]).to_have_attribute("data-value", "0.2000", timeout=20_000)
    studio.wait_for_phase("paused")
    studio["run"].click()
    studio.wait_for_phase("finished")


def test_the_run_pauses_at_a_breakpoint(studio: Studio) -> None:
    studio.enter_new_group()
    put_two_moves(studio)
    studio.blocks.by_text("andar para trás").click(button="right")
    expect(studio.page.locator(".blocklyContextMenu")).to_contain_text("F6")
    studio.page.get_by_text("Pausar aqui", exact=True).click()
    expect(dots(studio)).to_have_count(1)

    studio.run()
    studio.wait_for_phase("paused")
    expect(studio["pose-x"]).to_have_attribute("data-value", "0.2000")
    expect(studio["status-line"]).to_contain_text("Em pausa antes deste bloco")
    studio["run"].click()
    studio.wait_for_phase("finished")


def test_fast_forward_is_faster_than_the_clock(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, "robot.wait(20)\n")
    studio["speed"].select_option("10")
    start_s = time.monotonic()
    studio.run_to_the_end()
    duration_s = time.monotonic() - start_s
    studio.expect_number("elapsed", pytest.approx(20, abs=0.1))
    assert duration_s < 20


def test_the_value_of_a_block_is_shown_while_the_run_stands(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, "robot.move_forward(0.25)\nrobot.say(robot.x * 2)\n")
    studio.eventually(studio.actions, ["move_forward", "say"])
    speech_block = studio.blocks.by_text("dizer")
    speech_block.click(button="right", position={"x": 20, "y": 26})
    studio.page.get_by_text("Pausar aqui", exact=True).click()
    studio.run()
    studio.wait_for_phase("paused")
    studio.blocks.by_text("posição").hover(position={"x": 20, "y": 16})
    expect(studio.page.locator(".pinelValue")).to_have_text("0,25")
    studio["run"].click()
    studio.wait_for_phase("finished")


def test_sensors_calls_and_variables_are_watched_while_the_run_stands(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(
        studio,
        "def look(n):\n    robot.say(robot.sonar(3))\n    robot.say(n)\n\nside = 2\nlook(side)\n",
    )
    document = studio.document() or {}
    assign, call = (command["block"] for command in document["commands"])
    speech_block = document["functions"][0]["commands"][0]["block"]
    studio["step"].click()
    expect_paused_before(studio, assign)
    watched = studio.page.locator('[data-testid="watch-value"]')
    # the sonar's; no variable has a value yet
    expect(watched.filter(visible=True)).to_have_count(1)
    for block in (call, speech_block):
        studio["step"].click()
        expect_paused_before(studio, block)
    expect(studio.page.locator('[data-name="side"]')).to_have_text("2")
    expect(studio.page.locator('[data-name="n"]')).to_have_text("2")
    expect(studio.page.locator('[data-name="dentro de"]')).to_contain_text("look")
    # (4 - 0.229) / cos 10°
    expect(studio.page.locator('[data-name="sonar 3 (m)"]')).to_have_text("3,83")
    studio["step-out"].click()
    studio.wait_for_phase("finished")


def test_a_long_program_has_a_map(studio: Studio) -> None:
    studio.enter_new_group()
    overview = studio.page.locator(".pinelOverview")
    expect(overview).to_be_hidden()
    write_program(studio, "robot.beep()\n" * 60 + "robot.stop()\n")
    expect(overview).to_be_visible()
    last = studio.blocks.by_text("parar")
    expect(last).not_to_be_in_viewport()
    overview.click(position={"x": 12, "y": 168})
    expect(last).to_be_in_viewport()
