"""Blocks and floor keep their places while a group works; the line between them moves by hand."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.blocks import Box, box_of
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_check_list import open_mission
from tests.e2e.test_layout import cut
from tests.e2e.test_missions import MOVE, put_move

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

SIZES = [(1366, 768), (1024, 768), (1920, 1080), (800, 1280)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def places(studio: Studio) -> list[Box]:
    return [box_of(studio[name]) for name in ("editor", "scene")]


def test_a_mission_moves_neither_blocks_nor_floor(studio: Studio) -> None:
    open_mission(studio, "to_the_bakery")
    expect(studio["mission-sheet"]).to_contain_text("Acabou o pão")
    studio.wait_for_screen("mission-sheet")
    before = places(studio)
    put_move(studio, "1")
    studio.hurry()
    studio.run()
    expect(studio["mission-sheet"]).to_have_count(0)
    expect(studio["status-line"]).to_contain_text("Ainda não", timeout=RUN_MS)
    expect(studio["advice-block"]).to_be_visible()
    studio.wait_for_screen("past-run")
    assert places(studio) == before, "after a run that did not pass"
    studio["mission-fold"].click()
    studio["mission-hint"].click()
    studio.page.keyboard.press("Escape")
    expect(studio["mission-sheet"]).to_have_count(0)
    studio.blocks.type_into(studio.blocks.by_text(MOVE), "3")
    studio.run()
    expect(studio["mission-done"]).to_be_visible(timeout=RUN_MS)
    studio.wait_for_screen("mission-done")
    assert places(studio) == before, "after success"


def test_a_touch_of_the_program_closes_the_sheet(studio: Studio) -> None:
    open_mission(studio, "to_the_bakery")
    expect(studio["mission-sheet"]).to_be_visible()
    assert violations(studio, "mission-sheet") == []
    studio.blocks.category("motion").click()
    expect(studio["mission-sheet"]).to_have_count(0)


def test_a_solved_mission_is_still_solved_when_it_is_opened_again(studio: Studio) -> None:
    open_mission(studio, "to_the_bakery")
    write_program(studio, "robot.move_forward(3)\n")
    studio.hurry()
    studio.run()
    expect(studio["mission-done"]).to_be_visible(timeout=RUN_MS)
    studio.wait_until_saved()
    studio.page.reload()
    expect(studio["mission"]).to_have_attribute("data-done", "true")
    studio["mission-fold"].click()
    expect(studio["mission-next"]).to_be_visible()


def test_the_mission_fits_every_window(studio: Studio) -> None:
    open_mission(studio, "left_right")
    for width, height in SIZES:
        studio.page.set_viewport_size({"width": width, "height": height})
        assert cut(studio, "mission-sheet") == [], (width, height)
        assert box_of(studio["mission-fold"])["height"] <= 52


def test_the_line_between_blocks_and_floor_moves_and_stays(studio: Studio) -> None:
    studio.enter_new_group()
    studio.wait_for_screen("editor")
    usual = box_of(studio["editor"])["width"]
    line = box_of(studio["splitter"])
    mouse, y = studio.page.mouse, line["y"] + line["height"] / 2
    mouse.move(line["x"] + line["width"] / 2, y)
    mouse.down()
    mouse.move(600, y, steps=4)
    mouse.up()
    studio.eventually(lambda: round(box_of(studio["editor"])["width"] / 10), 60)
    studio.eventually(lambda: studio.page.evaluate("sessionStorage.length"), 0)
    studio.page.reload()
    studio.wait_for_screen("editor")
    assert box_of(studio["editor"])["width"] == pytest.approx(600, abs=15)
    studio["splitter"].press("ArrowRight")
    studio.eventually(lambda: box_of(studio["editor"])["width"] > 610, True)
    studio["splitter"].press("Home")
    studio.eventually(lambda: box_of(studio["editor"])["width"], usual)


def test_scroll_bars_appear_with_a_program_that_needs_them(studio: Studio) -> None:
    studio.enter_new_group()
    bars = studio.page.locator(".blocklyMainWorkspaceScrollbar .blocklyScrollbarHandle:visible")
    expect(bars).to_have_count(0)
    write_program(studio, "robot.move_forward(1)\n" * 30)
    expect(bars).not_to_have_count(0)
