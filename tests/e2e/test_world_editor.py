"""A group draws the world for its robot."""

import json
from pathlib import Path

import pytest
from playwright.sync_api import expect

from pinel_desktop.messages import LANGUAGES
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.blocks import box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.finger import Finger
from tests.e2e.studio import Studio
from tests.e2e.test_layout import cut
from tests.e2e.test_running import add_move
from tests.e2e.world_board import WorldBoard

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


@pytest.fixture
def board(studio: Studio) -> WorldBoard:
    studio.enter_new_group()
    board = WorldBoard(studio)
    board.open()
    return board


def test_the_robot_drives_over_a_print_and_stops_at_a_thing(
    studio: Studio, board: WorldBoard
) -> None:
    board["ground"].select_option("town")
    board.choose("print")
    board["print-kind"].select_option("street")
    board.drag((0.5, -0.4), (2, 0.4))
    board.eventually(lambda: board.stored("prints", "kind"), ["street"])
    board.choose("box")
    board["box-kind"].select_option("tree")
    board.drag((2.5, -0.4), (3, 0.4))
    board.eventually(lambda: board.stored("boxes", "kind"), ["tree"])
    assert board.world()["ground"] == "town"
    board.done()

    add_move(studio, "3")
    studio["speed"].select_option("10")
    studio.run()
    studio.wait_for_phase("failed")
    studio.expect_number("pose-x", pytest.approx(2.25, abs=0.25))


def test_a_wall_that_was_drawn_is_in_the_robots_way(studio: Studio, board: WorldBoard) -> None:
    board.choose("wall")
    board.drag((1, -1), (1, 1))
    board.eventually(board.inner_walls, [[[1, -1], [1, 1]]])
    board.done()
    expect(studio["world"]).to_have_value("own")

    add_move(studio, "3")
    studio["speed"].select_option("10")
    studio.run()
    studio.wait_for_phase("failed")
    studio.expect_number("pose-x", pytest.approx(0.75, abs=0.25))

    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    [run] = studio.api(f"/groups/{group}/runs")["runs"]
    assert (run["world"], run["reason"]) == ("own", "blocked")
    assert len(studio.api(f"/runs/{run['id']}")["world_document"]["walls"]) == 5

    studio.page.reload()
    studio.wait_until_open()
    expect(studio["world"]).to_have_value("own")
    board.open()
    expect(board.world_object("wall", 4)).to_have_count(1)


def test_things_are_drawn_moved_turned_and_typed_exactly(board: WorldBoard) -> None:
    board.choose("box")
    board.drag((1, 1), (2, 2))
    board.eventually(lambda: board.stored("boxes", "center"), [[1.5, 1.5]])
    board.choose("select")
    board.drag((1.5, 1.5), (-1.5, 1.5))
    board.eventually(lambda: board.stored("boxes", "center"), [[-1.5, 1.5]])
    turn = box_of(board.handle("turn").locator("circle").last)
    grip = type(board.at(0, 0))(turn["x"] + turn["width"] / 2, turn["y"] + turn["height"] / 2)
    board.pull(grip, board.at(-1.5, 3))
    board.eventually(lambda: board.stored("boxes", "heading_deg"), [90])
    board.number("width").fill("0,75")
    board.eventually(lambda: board.stored("boxes", "size"), [[0.75, 1]])
    board["movable"].last.click()
    board.eventually(lambda: board.stored("boxes", "movable"), [True])

    board.number("width").fill("99")
    expect(board["panel"]).to_contain_text("Escrevam um número de 0,05 a 50.")
    assert board.stored("boxes", "size") == [[0.75, 1]]


def test_a_place_has_the_numbers_that_blocks_use_for_it(studio: Studio, board: WorldBoard) -> None:
    """The start looks along the edge of the floor; the zone lies 2 m ahead of it and 1 m to its right."""
    board.world_object("start").click()
    for name, value in {"x": "-3", "y": "-2", "heading": "90"}.items():
        board.number(name).fill(value)
    expect(board["panel"]).to_contain_text("Só a partida conta do meio do chão")
    board.choose("zone")
    board.drag((-2.5, -0.5), (-1.5, 0.5))
    board.eventually(lambda: board.stored("zones", "center"), [[-2, 0]])
    expect(board.number("x")).to_have_value("2")
    expect(board.number("y")).to_have_value("-1")
    expect(board.number("heading")).to_have_value("-90")
    board.number("x").fill("3")
    board.number("heading").fill("0")
    board.eventually(lambda: board.stored("zones", "center"), [[-2, 1]])
    board.eventually(lambda: board.stored("zones", "heading_deg"), [90])


def test_places_and_colours_are_kept_for_the_sensors(board: WorldBoard) -> None:
    board.choose("zone")
    board.drag((1, 1), (2, 2))
    board["zone-name"].fill("Casa")
    board.choose("paint")
    board["editor"].locator('.world-tools [data-color="green"]').click()
    board.drag((-2, -2), (-1, -1))
    board["shape"].last.click()
    board.eventually(lambda: board.stored("zones", "name"), ["Casa"])
    board.eventually(lambda: board.stored("floor", "color"), ["green"])
    board.eventually(lambda: board.stored("floor", "radius"), [0.5])


def test_the_keys_do_what_hands_do(studio: Studio, board: WorldBoard) -> None:
    page = studio.page
    board.choose("box")
    board["board"].focus()
    page.keyboard.press("Enter")
    page.keyboard.press("ArrowRight")
    for _ in range(3):
        page.keyboard.press("Shift+ArrowUp")
    board.world_object("start").focus()
    for _ in range(9):
        page.keyboard.press("ArrowLeft")
    board.eventually(lambda: board.stored("boxes", "center"), [[0.1, 0.03]])
    board.eventually(lambda: board.world().get("start", {}).get("x_m"), -0.9)
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+y")
    board.choose("select")
    board.world_object("box").focus()
    page.keyboard.press("Delete")
    board.eventually(lambda: board.stored("boxes", "center"), [])
    page.keyboard.press("Control+z")
    board.eventually(lambda: board.stored("boxes", "center"), [[0.1, 0.03]])


def test_a_finger_draws_too(open_studio: OpenStudio) -> None:
    studio = open_studio(has_touch=True)
    studio.enter_new_group()
    board = WorldBoard(studio)
    board.open()
    board.choose("wall")
    Finger(studio.page).stroke(board.at(-1, 2), board.at(1, 2))
    board.eventually(board.inner_walls, [[[-1, 2], [1, 2]]])


def test_a_fault_is_told_where_it_is_and_nothing_is_lost(studio: Studio, board: WorldBoard) -> None:
    board.choose("box")
    board.drag((1, 1), (2, 2))
    board.eventually(lambda: board.stored("boxes", "center"), [[1.5, 1.5]])
    board.choose("select")
    board.drag((1.5, 1.5), (0.1, 0.1))
    expect(board["fault-note"]).to_contain_text("caixa 1")
    board.expect_faulty(board.world_object("start"))
    expect(studio["saved-mark"]).to_have_attribute("data-state", "refused")
    assert board.stored("boxes", "center") == [[1.5, 1.5]]

    studio.page.reload()
    studio.wait_until_open()
    studio["run"].click()
    board.expect_faulty(board.world_object("start"))
    board.choose("start")
    board.drag((-2, -2), (-2, 0))
    board.expect_faulty(board.world_object("start"), False)
    expect(board["faults"]).to_have_count(0)
    board.eventually(lambda: board.stored("boxes", "center"), [[0.1, 0.1]])
    studio.wait_until_saved()


def test_a_world_goes_into_a_file_and_comes_back(
    studio: Studio, board: WorldBoard, tmp_path: Path
) -> None:
    board["name"].fill("Sala do Zé")
    board.choose("wall")
    board.drag((1, -1), (1, 1))
    board.eventually(board.inner_walls, [[[1, -1], [1, 1]]])
    board.choose("select")
    studio.page.keyboard.press("Escape")
    with studio.page.expect_download() as download:
        board["export"].click()
    assert download.value.suggested_filename == "sala-do-ze.json"
    file = tmp_path / "world.json"
    download.value.save_as(file)

    board["undo"].click()
    board.eventually(board.inner_walls, [])
    board["file"].set_input_files(file)
    board.eventually(board.inner_walls, [[[1, -1], [1, 1]]])
    assert board.world()["title"] == "Sala do Zé"


def test_a_file_that_holds_no_world_says_why(board: WorldBoard, tmp_path: Path) -> None:
    file = tmp_path / "world.json"
    for text in ("{", json.dumps([1]), json.dumps({"pinel_world": 1}), " " * 300_000):
        file.write_text(text, encoding="utf-8")
        board["file"].set_input_files(file)
        expect(board["refused"]).to_contain_text("O arquivo não foi aberto.")
        board["refused"].get_by_role("button").click()
    assert not board.is_own()


def test_a_file_with_a_fault_is_opened_to_be_mended(board: WorldBoard, tmp_path: Path) -> None:
    file = tmp_path / "world.json"
    world = {
        "pinel_world": 1,
        "name": "from_elsewhere",
        "title": "De fora",
        "size_m": [8, 8],
        "start": {"x_m": 0, "y_m": 0, "heading_deg": 0},
        "walls": [],
        "boxes": [{"center": [0, 0], "size": [1, 1], "heading_deg": 0}],
    }
    file.write_text(json.dumps(world), encoding="utf-8")
    board["file"].set_input_files(file)
    board.expect_faulty(board.world_object("start"))
    board.choose("select")
    board.world_object("box").focus()
    board["delete"].click()
    board.eventually(lambda: board.world().get("title"), "De fora")


def test_the_own_world_stays_with_the_program_and_comes_back_when_deleted(
    studio: Studio, board: WorldBoard
) -> None:
    board["begin"].select_option("obstacles")
    board.eventually(lambda: len(board.stored("boxes", "center")), 3)
    board.done()
    studio["world"].select_option("empty_room")
    studio["world"].select_option("own")
    board.open()
    board["forget"].click()
    expect(board["editor"]).to_have_count(0)
    board.eventually(board.is_own, False)
    expect(studio["world"].locator('option[value="own"]')).to_have_count(0)
    board["bring-back"].click()
    board.eventually(lambda: len(board.stored("boxes", "center")), 3)
    expect(studio["world"]).to_have_value("own")


def test_looking_at_a_world_that_ships_makes_none(studio: Studio, board: WorldBoard) -> None:
    board.choose("wall")
    board.done()
    studio.wait_until_saved()
    assert not board.is_own()
    expect(studio["world"]).to_have_value("empty_room")


def test_changing_a_world_that_ships_can_be_undone_to_the_own_one(
    studio: Studio, board: WorldBoard
) -> None:
    board["begin"].select_option("obstacles")
    board.eventually(lambda: len(board.stored("boxes", "center")), 3)
    board.done()
    studio["world"].select_option("empty_room")
    board.open()
    expect(board["own-instead"]).to_be_visible()
    board.choose("box")
    board.drag((1, 1), (2, 2))
    board.eventually(lambda: len(board.stored("boxes", "center")), 1)
    board["undo"].click()
    board["undo"].click()
    board.eventually(lambda: len(board.stored("boxes", "center")), 3)


def test_it_has_names_and_contrast(studio: Studio, board: WorldBoard) -> None:
    assert violations(studio, "world-editor") == [], "the world"
    board.choose("box")
    board.drag((-0.5, -0.5), (0.5, 0.5))
    expect(board["fault-note"]).to_be_visible()
    assert violations(studio, "world-fault-note") == [], "a box with a fault"
    board.choose("paint")
    board.drag((1, 1), (2, 2))
    expect(board.world_object("paint")).to_have_count(1)
    assert violations(studio, "world-editor") == [], "a colour"


def test_no_words_are_cut(studio: Studio, board: WorldBoard) -> None:
    expect_uncut(studio, "the world")
    n_objects = board["thing"].count()
    for tool in ("wall", "box", "zone", "paint", "start"):
        board.choose(tool)
        if tool != "start":
            n_objects += 1
            board.drag((1, 1), (2, 2))
            expect(board["thing"]).to_have_count(n_objects)
        expect_uncut(studio, tool)


def expect_uncut(studio: Studio, shown: str) -> None:
    """Checks in every language and in windows of two widths that no text is cut off."""
    for language in LANGUAGES:
        studio.choose_language(language)
        for width in (1024, 1366):
            studio.page.set_viewport_size({"width": width, "height": 768})
            assert cut(studio, "world-editor") == [], f"{shown}, {language}, {width} wide"
