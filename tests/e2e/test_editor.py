"""The workspace in the page: fields, loose blocks, undo, copies, trash, languages, themes."""

from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.blocks import box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.finger import Finger
from tests.e2e.made_program import enter_made_group
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

HINT = ".pinelStartHint"


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


@pytest.fixture
def one_move(studio: Studio) -> Studio:
    """A program of one block."""
    enter_made_group(studio, [("move_forward", 1)])
    return studio


@pytest.fixture
def dragged_move(studio: Studio) -> Studio:
    """A program of one block that was dragged into it."""
    studio.enter_new_group()
    blocks = studio.blocks
    expect(studio.page.locator(HINT)).to_be_visible()
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    expect_distances(studio, 1)
    return studio


def expect_distances(studio: Studio, *metres: float) -> None:
    studio.eventually(lambda: studio.values("distance"), list(metres))


def test_the_hint_goes_with_the_first_block(dragged_move: Studio) -> None:
    expect(dragged_move.page.locator(HINT)).to_have_count(0)
    expect_distances(dragged_move, 1)


def test_half_a_metre_is_typed_as_pupils_write_it(one_move: Studio) -> None:
    move = one_move.blocks.by_text("andar para frente")
    for typed, stored, shown in (("0,5", 0.5, "0,5"), ("2.25", 2.25, "2,25"), ("7", 7, "7")):
        one_move.blocks.type_into(move, typed)
        expect_distances(one_move, stored)
        expect(move).to_contain_text(shown)


def test_a_field_says_beside_it_why_it_refuses_a_number(one_move: Studio) -> None:
    blocks = one_move.blocks
    move, note = blocks.by_text("andar para frente"), one_move["field-note"]
    for typed, stored, note_text in (
        ("abc", 1, "“abc” não é um número. Ficou 1."),
        ("99999", 100, "“99999” não vale aqui: só de 0 a 100. Ficou 100."),
        ("-1", 0, "“-1” não vale aqui: só de 0 a 100. Ficou 0."),
        ("  ", 0, "Falta um número. Ficou 0."),
    ):
        blocks.type_into(move, typed)
        expect(note).to_have_text(note_text)
        expect(one_move.page.locator("#blocklyAriaAnnounce")).to_contain_text(note_text)
        field, box = box_of(move.locator(".blocklyInputField")), box_of(note)
        assert 0 < box["y"] - (field["y"] + field["height"]) < 20, note_text
        expect_distances(one_move, stored)

        blocks.type_into(move, "2")
        expect(note, note_text).to_have_count(0)
        expect_distances(one_move, 2)


def test_a_note_at_a_field_goes_by_itself(one_move: Studio) -> None:
    one_move.page.clock.install()
    blocks = one_move.blocks
    blocks.type_into(blocks.by_text("andar para frente"), "-1")
    expect(one_move["field-note"]).to_be_visible()
    one_move.page.clock.run_for(8000)
    expect(one_move["field-note"]).to_have_count(0)


def test_a_right_turn_is_a_negative_angle(one_move: Studio) -> None:
    blocks = one_move.blocks
    blocks.drag_from_toolbox("motion", "girar", blocks.below(blocks.by_text("andar para frente")))
    blocks.choose(blocks.by_text("girar"), "direita")
    one_move.eventually(lambda: one_move.values("angle"), [None, -90])


def test_a_loose_block_is_dimmed_and_does_not_run(one_move: Studio) -> None:
    blocks = one_move.blocks
    move = blocks.by_text("andar para frente")
    blocks.drag_from_toolbox("motion", "parar", blocks.beside(move))
    expect(blocks.loose()).to_have_count(1)
    one_move.eventually(one_move.actions, ["move_forward"])

    blocks.drag(blocks.by_text("parar"), blocks.below(move))
    expect(blocks.loose()).to_have_count(0)
    one_move.eventually(one_move.actions, ["move_forward", "stop"])


def test_a_condition_takes_the_place_of_the_one_on_offer(studio: Studio) -> None:
    studio.enter_new_group()
    blocks = studio.blocks
    blocks.click_in_toolbox("flow", "repetir até que")
    expect(blocks.by_text("repetir até que")).to_contain_text("bateu em algo")
    blocks.click_in_toolbox("sensing", "há marca aqui")
    studio.eventually(lambda: studio.values("condition"), [{"sensor": "has_mark"}])
    expect(blocks.loose()).to_have_count(0)
    studio.page.keyboard.press("Delete")
    expect(blocks.by_text("repetir até que")).to_contain_text("bateu em algo")
    studio.eventually(lambda: studio.values("condition"), [{"sensor": "bumper"}])


def test_undo_and_redo(dragged_move: Studio) -> None:
    blocks = dragged_move.blocks
    blocks.type_into(blocks.by_text("andar para frente"), "3")
    dragged_move["undo"].click()
    expect_distances(dragged_move, 1)
    dragged_move["redo"].click()
    expect_distances(dragged_move, 3)
    dragged_move["undo"].click()
    dragged_move["undo"].click()
    expect(blocks.all()).to_have_count(1)
    expect_distances(dragged_move)


def test_a_copy_has_an_id_of_its_own(one_move: Studio) -> None:
    blocks = one_move.blocks
    blocks.select(blocks.by_text("andar para frente"))
    one_move.page.keyboard.press("Control+c")
    one_move.page.keyboard.press("Control+v")
    expect(blocks.all()).to_have_count(3)
    ids = {block.get_attribute("data-id") for block in blocks.all().all()}
    assert len(ids) == 3


def test_the_start_can_neither_be_deleted_nor_copied(one_move: Studio) -> None:
    blocks = one_move.blocks
    blocks.select(blocks.start())
    for keys in ("Delete", "Control+c", "Control+v", "Control+x"):
        one_move.page.keyboard.press(keys)
    expect_distances(one_move, 1)
    expect(blocks.all()).to_have_count(2)


def test_the_trash_gives_back(one_move: Studio) -> None:
    blocks = one_move.blocks
    move = blocks.by_text("andar para frente")
    blocks.type_into(move, "4")
    blocks.select(move)
    one_move.page.keyboard.press("Delete")
    expect(blocks.all()).to_have_count(1)
    one_move.page.locator(".blocklyTrash").click()
    given_back = one_move.page.locator(
        ".blocklyTrashcanFlyout .blocklyDraggable:not(.blocklyShadow)"
    )
    expect(given_back).to_contain_text("4")


def test_the_trash_closes_by_its_button_by_escape_and_by_a_press_outside(
    one_move: Studio,
) -> None:
    blocks, page = one_move.blocks, one_move.page
    blocks.select(blocks.by_text("andar para frente"))
    page.keyboard.press("Delete")
    expect(blocks.all()).to_have_count(1)
    contents = page.locator(".blocklyTrashcanFlyout")
    closings: tuple[Callable[[], Any], ...] = (
        one_move["trash-close"].click,
        lambda: page.keyboard.press("Escape"),
        one_move["scene"].click,
        blocks.category("motion").click,
    )
    for close in closings:
        page.locator(".blocklyTrash").click()
        expect(contents).to_be_visible()
        close()
        expect(contents).to_be_hidden()
        expect(one_move["trash-close"]).to_be_hidden()
    page.keyboard.press("Escape")
    page.locator(".blocklyTrash").click()
    expect(contents).to_be_visible()
    lost = contents.locator(".blocklyDraggable:not(.blocklyShadow)").first
    blocks.drag(lost, blocks.below(blocks.start()))
    expect_distances(one_move, 1)
    expect(contents).to_be_hidden()


@pytest.fixture
def stack(studio: Studio) -> Studio:
    """A program of three blocks, one below the other."""
    enter_made_group(studio, [("move_forward", 1), ("turn", 90), ("wait", 2)])
    return studio


def outline(commands: list[dict[str, Any]]) -> list[Any]:
    """The actions, and those inside a block as a list behind it."""
    parts = [[one["action"], outline(one.get("commands", []))] for one in commands]
    return [part for pair in parts for part in pair if part]


@pytest.mark.parametrize(("text", "action"), [("repetir", "repeat"), ("para sempre", "forever")])
def test_a_loop_dropped_on_a_stack_takes_up_the_blocks_below(
    stack: Studio, text: str, action: str
) -> None:
    blocks = stack.blocks
    blocks.drag_from_toolbox("flow", text, blocks.below(blocks.by_text("andar para frente")))
    wrapped = ["move_forward", action, ["turn", "wait"]]
    stack.eventually(lambda: outline(stack.commands()), wrapped)
    stack["undo"].click()
    stack.eventually(stack.actions, ["move_forward", "turn", "wait"])
    assert stack.stacks() == 1
    stack["redo"].click()
    stack.eventually(lambda: outline(stack.commands()), wrapped)


def test_a_loop_dragged_past_a_stack_leaves_it_as_it_was(stack: Studio) -> None:
    blocks, page = stack.blocks, stack.page
    blocks.open_category("flow")
    loop = box_of(blocks.in_flyout("repetir").locator("> .blocklyPath"))
    place = blocks.below(blocks.by_text("andar para frente"))()
    page.mouse.move(loop["x"] + 20, loop["y"] + 26)
    page.mouse.down()
    page.mouse.move(place.x + 20, place.y + 26, steps=6)
    page.mouse.move(place.x + 23, place.y + 26)
    marker = page.locator(".blocklyInsertionMarker")
    expect(marker.filter(has_text="girar")).to_have_count(1)
    page.mouse.move(place.x + 300, place.y + 220, steps=6)
    expect(marker).to_have_count(0)
    page.mouse.up()
    expect(blocks.loose()).to_have_count(1)
    stack.eventually(stack.actions, ["move_forward", "turn", "wait"])


def test_another_language_says_the_same_program(one_move: Studio) -> None:
    blocks = one_move.blocks
    blocks.type_into(blocks.by_text("andar para frente"), "0,5")
    expect_distances(one_move, 0.5)
    before = one_move.commands()
    for language, block_text, category in (
        ("en", "move forward", "Motion"),
        ("es", "avanzar", "Movimiento"),
        ("pt-BR", "andar para frente", "Movimento"),
    ):
        one_move.choose_language(language)
        expect(blocks.by_id(before[0]["block"])).to_contain_text(block_text)
        expect(blocks.category("motion")).to_contain_text(category)
        assert one_move.commands() == before
    one_move["undo"].click()
    expect_distances(one_move, 1)


def test_every_look_keeps_the_program(one_move: Studio) -> None:
    before = one_move.commands()
    themes = set()
    for _ in range(3):
        theme = one_move["theme"].get_attribute("data-theme") or ""
        themes.add(theme)
        one_move["theme"].click()
        expect(one_move["theme"]).not_to_have_attribute("data-theme", theme)
        expect(one_move.blocks.by_id(before[0]["block"])).to_be_visible()
    assert themes == {"light", "dark", "contrast"}
    assert one_move.commands() == before


def test_the_menu_of_a_block_speaks_the_language_of_the_page(one_move: Studio) -> None:
    blocks = one_move.blocks
    menu = one_move.page.locator(".blocklyContextMenu")
    blocks.by_text("andar para frente").locator("> .blocklyPath").first.click(
        button="right", position={"x": 5, "y": 40}
    )
    expect(menu).to_contain_text("Duplicar")
    menu.locator(".blocklyMenuItem", has_text="Apagar bloco").click()
    expect_distances(one_move)
    one_move.page.keyboard.press("Control+z")
    expect_distances(one_move, 1)


def test_a_finger_drags_as_well_as_a_mouse(open_studio: OpenStudio) -> None:
    studio = open_studio(has_touch=True)
    studio.enter_new_group()
    blocks = studio.blocks
    blocks.category("motion").tap()
    outline = blocks.in_flyout("andar para frente").locator("> .blocklyPath")
    finger = Finger(studio.page)
    finger.drag(outline, blocks.below(blocks.start())())
    expect_distances(studio, 1)
