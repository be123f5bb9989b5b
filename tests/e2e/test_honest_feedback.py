"""Messages of the page about a program that did nothing, failed, or was changed during its run."""

import math

import pytest
from playwright.sync_api import Locator, Route, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.blocks import box_of
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

N_TURNS = 12  # more blocks than fit in the height of the workspace


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


@pytest.fixture
def group(studio: Studio) -> Studio:
    studio.enter_new_group(level=None)
    return studio


def expect_texts(studio: Studio, tone: str, *texts: str) -> None:
    line = studio["status-line"]
    expect(line).to_have_attribute("data-tone", tone)
    for part in texts:
        expect(line).to_contain_text(part)


def is_separate(one: Locator, other: Locator) -> bool:
    a, b = box_of(one), box_of(other)
    beside = a["x"] + a["width"] <= b["x"] or b["x"] + b["width"] <= a["x"]
    above = a["y"] + a["height"] <= b["y"] or b["y"] + b["height"] <= a["y"]
    return beside or above


def test_an_empty_loop_and_a_robot_at_rest_are_no_success(group: Studio) -> None:
    group.blocks.click_in_toolbox("flow", "repetir")
    group.run()
    group.wait_for_phase("finished")
    expect_texts(group, "notice", "o robô não saiu do lugar", "Há uma repetição vazia")

    group.blocks.click_in_toolbox("motion", "girar")
    expect_texts(group, "calm", "Apertem Rodar")
    group.hurry()
    group.run()
    group.wait_for_phase("finished")
    expect_texts(group, "done", "O programa terminou")


def test_loose_blocks_are_said_to_have_done_nothing(group: Studio) -> None:
    blocks = group.blocks
    blocks.click_in_flyout("girar")
    blocks.drag_from_toolbox("motion", "parar", blocks.beside(blocks.by_text("girar"), -200))
    expect(blocks.loose()).to_have_count(1)
    group.run()
    group.wait_for_phase("finished")
    expect_texts(group, "notice", "O programa terminou", "Um bloco está solto e não rodou")


def test_a_number_changed_during_a_run_counts_in_the_next_one(group: Studio) -> None:
    blocks = group.blocks
    blocks.click_in_toolbox("flow", "esperar")
    blocks.type_into(blocks.by_text("esperar"), "30")
    expect(group["field-note"]).to_have_count(0)
    group.run()
    group.wait_for_phase("running")
    blocks.type_into(blocks.by_text("esperar"), "999")
    expect(group["field-note"]).to_contain_text("só de 0 a 600")
    expect(group["field-note"]).to_contain_text("Vale na próxima rodada.")
    expect_texts(group, "moving", "A mudança vale na próxima rodada.")
    group["stop"].click()
    group.wait_for_phase("stopped")


def test_the_block_that_failed_is_shown_until_the_program_is_mended(group: Studio) -> None:
    turns = "robot.turn(1)\n" * N_TURNS
    write_program(group, f"{turns}robot.move_forward(90)\nrobot.turn(1)\nrobot.turn(1)\n")
    group.eventually(lambda: len(group.actions()), N_TURNS + 3)
    group.run()
    group.wait_for_phase("running")
    failing = group.blocks.by_text("andar para frente")
    expect(group["status-line"]).to_contain_text("Andando", timeout=RUN_MS)
    group.page.mouse.move(600, 400)
    group.page.mouse.wheel(0, -3000)
    expect(failing).not_to_be_in_viewport()

    group.wait_for_phase("failed")
    bubble = group.blocks.fault_text()
    expect(bubble).to_be_visible()
    expect(failing).to_be_in_viewport()
    for control in (".blocklyTrash", ".pinelZoom"):
        for part in (bubble, failing.locator("> .blocklyPath").first):
            assert is_separate(part, group.page.locator(control)), control

    # the line says what happened, the block what to do: no sentence twice
    expect_texts(group, "fault", "O robô bateu em algo")
    expect(group["status-line"].locator(".status__more")).to_have_count(0)
    expect(bubble).to_contain_text("Vejam no chão onde ele bateu")
    expect(bubble).not_to_contain_text("O robô bateu em algo")
    expect(group["status-line"].get_by_role("status")).to_contain_text("Vejam no chão onde ele")
    group.blocks.type_into(failing, "0,1")
    expect(bubble).to_have_count(0)
    expect(group.blocks.faulty()).to_have_count(0)
    expect_texts(group, "calm", "Apertem Rodar")

    group.hurry()
    group.run()
    group.wait_for_phase("finished")
    expect(group.page.locator(".blocklyBubbleCanvas > *")).to_have_count(0)


def test_the_robot_says_numbers_as_the_language_does(group: Studio) -> None:
    write_program(group, 'robot.turn(10)\nrobot.say(10 / 3)\nrobot.say(join("d: ", 0.5))\n')
    group.hurry()
    group.run()
    group.wait_for_phase("finished")
    expect(group["talk"]).to_contain_text("3,33")
    expect(group["talk"]).to_contain_text("d: 0,5")
    group.choose_language("en")
    expect(group["talk"]).to_contain_text("3.33")
    expect(group["talk"]).to_contain_text("d: 0.5")
    events = group.api(
        f"/runs/{group.api(f'/groups/{_group(group)}/runs')['runs'][0]['id']}/events"
    )
    texts = [event["text"] for event in events["events"] if event["type"] == "said"]
    assert texts == ["3.33333333333", "d: 0.5"]


def _group(studio: Studio) -> str:
    return str(studio.api(f"/programs/{studio.program_id}")["group_id"])


SQUARE = "for _ in range(4):\n    robot.move_forward(1.0)\n    robot.turn(90)\n"
SEED = {"seed": 1}


def choose_wheels(studio: Studio) -> None:
    """Chooses the realistic robot that has only its odometry, with noise of a fixed seed."""
    studio.page.route("**/api/runs", _with_seed)
    studio["lifelike"].select_option("wheels")
    studio["speed"].select_option("10")


def _with_seed(route: Route) -> None:
    route.continue_(post_data={**(route.request.post_data_json or {}), **SEED})


def test_a_robot_that_only_believes_that_it_is_back_is_said_to_stand_elsewhere(
    studio: Studio,
) -> None:
    studio.enter_new_group()
    write_program(studio, SQUARE)
    choose_wheels(studio)
    studio.run_to_the_end()
    texts = ("parou a 0,07", "da partida", "O robô pensa que voltou à partida")
    expect_texts(studio, "done", *texts)
    expect(studio["status-line"]).not_to_contain_text("o robô voltou à partida")
    off_m = math.hypot(studio.number("pose-x"), studio.number("pose-y"))
    assert off_m == pytest.approx(0.068, abs=0.002), (
        "what stands beside the floor is what the floor shows"
    )

    studio["open-work"].click()
    studio["run-card"].click()
    slider = studio["replay-slider"]
    expect(slider).to_be_visible()
    slider.press("End")
    expect_texts(studio, "done", *texts)
