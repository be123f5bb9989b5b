"""Number of actions that a novice needs: from the first start to a driving robot, and for a square."""

import time

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

MAX_TO_DRIVE = 5
MAX_FOR_A_SQUARE = 8
CHOICE_S = 2.0  # time before each action of a novice
MOVED_M = 0.05

# a click, a drag and a typed value are an action each
_COUNT_ACTIONS = """() => {
  window.actions = 0;
  let isTyping = false;
  addEventListener("pointerup", () => { window.actions++; isTyping = false; }, true);
  addEventListener("input", () => { if (!isTyping) window.actions++; isTyping = true; }, true);
}"""


def actions_of(studio: Studio) -> int:
    return int(studio.page.evaluate("window.actions"))


def wait_until_driving(studio: Studio) -> None:
    studio.page.wait_for_function(
        "least => Number(document.querySelector('[data-testid=pose-x]').dataset.value) > least",
        arg=MOVED_M,
        timeout=60_000,
    )


def test_from_the_first_launch_to_a_driving_robot(open_studio: OpenStudio, app: AppProcess) -> None:
    app.stop()
    begin = time.monotonic()
    app.start()
    studio = open_studio()
    studio.page.evaluate(_COUNT_ACTIONS)
    studio["group-name"].fill("Os Tatus")
    studio["create-group"].click()
    studio["tour-go"].click()
    studio.blocks.in_flyout("andar para frente").click(position={"x": 12, "y": 18})
    studio.run()
    wait_until_driving(studio)
    page_s = time.monotonic() - begin
    n = actions_of(studio)
    print(f"\nfirst launch to a driving robot: {n} actions, {n * CHOICE_S + page_s:.1f} s")
    assert n <= MAX_TO_DRIVE


def test_a_square_from_an_empty_program(studio: Studio) -> None:
    studio.enter_group("Os Tatus", level=None)
    expect(studio["tour"]).to_have_count(0)
    studio.page.evaluate(_COUNT_ACTIONS)
    studio.hurry()
    begin = time.monotonic()
    studio.blocks.category("flow").click()
    studio.blocks.click_in_flyout("repetir")
    studio.blocks.category("motion").click()
    studio.blocks.click_in_flyout("andar para frente")
    studio.blocks.click_in_flyout("girar")
    studio.run()
    page_s = time.monotonic() - begin
    n = actions_of(studio)
    studio.wait_for_phase("finished")
    assert [[inner["action"] for inner in loop["commands"]] for loop in studio.commands()] == [
        ["move_forward", "turn"]
    ]
    for axis in ("pose-x", "pose-y"):
        studio.expect_number(axis, pytest.approx(0, abs=0.001))
    print(f"\na square: {n} actions, {n * CHOICE_S + page_s:.1f} s until it drives")
    assert n <= MAX_FOR_A_SQUARE


def test_a_square_with_dragged_blocks_and_a_typed_length(studio: Studio) -> None:
    studio.enter_group("Os Tatus", level=None)
    studio.page.evaluate(_COUNT_ACTIONS)
    blocks = studio.blocks
    blocks.drag_from_toolbox("flow", "repetir", blocks.below(blocks.start()))
    loop = blocks.by_text("repetir")
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.inside(loop))
    # the flyout is open at motion
    move = blocks.by_text("andar para frente")
    blocks.drag_from_toolbox("motion", "girar", blocks.below(move))
    blocks.type_into(blocks.by_text("andar para frente"), "0,5")
    studio.hurry()
    studio.run()
    studio.wait_for_phase("finished")
    for axis in ("pose-x", "pose-y"):
        studio.expect_number(axis, pytest.approx(0, abs=0.001))
    n = actions_of(studio)
    print(f"\na square of dragged blocks with a typed length: {n} actions")
    assert n <= MAX_FOR_A_SQUARE
