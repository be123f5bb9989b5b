"""Help beside the program: tasks, the blocks of the level to try, keys, and a search in all of them."""

import re

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import Studio
from tests.e2e.test_layout import cut

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def to_tab(studio: Studio, name: str) -> None:
    studio.page.locator(f"[data-testid=help-tab][data-tab={name}]").click()


def test_a_block_of_the_help_is_tried_in_the_program_and_the_run_shows_the_floor(
    studio: Studio,
) -> None:
    studio.enter_new_group(level=None)
    studio["help"].click()
    to_tab(studio, "blocks")
    turn = studio.page.locator("[data-testid=help-block][data-block=turn]")
    expect(turn.get_by_role("img")).to_have_accessible_name("girar à esquerda 90 °")
    expect(turn).to_contain_text("O robô gira no lugar.")
    turn.get_by_test_id("help-try").click()
    studio.eventually(studio.actions, ["turn"])
    expect(turn.get_by_test_id("help-try")).to_be_focused()
    turn.get_by_test_id("help-try").click()
    studio.eventually(studio.actions, ["turn", "turn"])
    studio["undo"].click()
    studio.eventually(studio.actions, ["turn"])
    expect(studio["stop"]).to_be_visible()
    studio.run()
    expect(studio["help-panel"]).to_have_count(0)
    expect(studio["scene"]).to_be_visible()


def test_every_block_of_the_level_is_drawn_with_its_help(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    studio["help"].click()
    to_tab(studio, "blocks")
    blocks, row = studio["help-block"], "[data-testid=help-block][data-block={}]"
    studio.wait_for_screen(studio.page.locator(row.format("repeat")))
    n_first = blocks.count()
    expect(studio.page.locator(row.format("function_def"))).to_have_count(0)
    studio.choose_level(3)
    expect(studio.page.locator(row.format("function_def"))).to_have_count(1)
    assert cut(studio, "help-block") == []
    n_all = blocks.count()
    assert n_all > 2 * n_first
    expect(blocks.locator("p").filter(has_text=re.compile(r"\w"))).to_have_count(n_all)
    small = """all => all.map(one => one.getBoundingClientRect())
      .filter(box => Math.min(box.width, box.height) <= 16)"""
    assert blocks.locator("svg").evaluate_all(small) == []


def test_a_picture_shows_what_the_robot_does_and_plays_again_when_pressed(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(reduced_motion="no-preference")
    studio.enter_new_group(level=None)
    studio["help"].click()
    to_tab(studio, "blocks")
    film = studio.page.locator("[data-block=move_forward] [data-testid=help-film]")
    robot = film.locator(".path-picture__waiting").locator("..")
    expect(film).to_have_attribute("data-part", "1.00")
    expect(film).to_have_accessible_name("Ver de novo: andar para frente 1 m")
    at_end = robot.get_attribute("transform") or ""
    film.focus()
    studio.page.keyboard.press("Enter")
    expect(film).not_to_have_attribute("data-part", "1.00")
    expect(robot).not_to_have_attribute("transform", at_end)
    expect(film).to_have_attribute("data-part", "1.00")
    expect(robot).to_have_attribute("transform", at_end)
    assert violations(studio, "help-film") == []


def test_a_picture_is_still_where_motion_is_reduced(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    studio["help"].click()
    to_tab(studio, "blocks")
    film = studio.page.locator("[data-block=turn] [data-testid=help-film]")
    expect(film.locator("g[transform$='rotate(-90)']")).to_have_count(1)
    expect(film.get_by_role("button")).to_have_count(0)
    beep = studio.page.locator("[data-block=beep]")
    expect(beep.get_by_test_id("help-film")).to_have_count(0)
    expect(beep.get_by_role("img")).to_be_visible()


def test_the_search_finds_blocks_tasks_examples_and_keys(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    studio["help"].click()
    expect(studio["help-search"]).to_be_focused()
    studio.page.keyboard.type("caneta")
    expect(studio["help-block"]).to_have_count(2)
    studio["help-search"].fill("repetir")
    expect(studio.page.locator("[data-testid=help-task][data-task=repeat]")).to_be_visible()
    studio["help-search"].fill("copiar")
    expect(studio["help-panel"]).to_contain_text("Ctrl+C")
    studio["help-search"].fill("xyzw")
    expect(studio["help-panel"]).to_contain_text("Nenhum resultado")
    studio["help-search"].fill("floco")
    studio["help-example"].click()
    studio.wait_until_open()
    expect(studio["program-name"]).to_have_value("Floco de neve")


def test_escape_closes_the_help_and_goes_back_to_its_button(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    studio["help"].focus()
    studio.page.keyboard.press("Enter")
    expect(studio["help-search"]).to_be_focused()
    studio.page.keyboard.press("Escape")
    expect(studio["help-panel"]).to_have_count(0)
    expect(studio["help"]).to_be_focused()


def test_the_help_is_read_in_every_language_and_theme(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    studio["help"].click()
    keys = studio.page.locator(".help__keys")
    tabs = {"blocks": studio["help-block"], "keys": keys, "tasks": studio["help-task"]}
    for language, heading in {"en": "Drive and turn", "es": "Avanzar y girar"}.items():
        studio.choose_language(language)
        expect(studio["help-panel"]).to_contain_text(heading)
        for tab, shown in tabs.items():
            to_tab(studio, tab)
            assert cut(studio, shown) == [], (language, tab)
            found = violations(studio, shown, every_theme=language == "en")
            assert found == [], (language, tab)


def test_the_help_leads_to_the_works_of_others_and_back(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    studio["help"].click()
    to_tab(studio, "keys")
    studio["help-notices"].click()
    expect(studio["notices-missing"]).to_contain_text("make package")
    assert violations(studio, "notices-missing", every_theme=False) == []
    studio["notices-back"].click()
    expect(studio["run"]).to_be_visible()
