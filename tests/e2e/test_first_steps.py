"""The first five minutes: blocks beside the workspace, appended by a click, a tap or Enter."""

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.blocks import box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

ROOM_PX = 340  # of the workspace beside the open flyout: a turn inside a loop is 310 px wide


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


@pytest.fixture
def beginners(studio: Studio) -> Studio:
    studio.enter_new_group(level=None)
    return studio


def announcement(studio: Studio) -> Locator:
    """The element whose text a screen reader announces."""
    return studio.page.locator("#blocklyAriaAnnounce")


def inside(studio: Studio) -> list[list[str]]:
    return [[inner["action"] for inner in loop.get("commands", [])] for loop in studio.commands()]


def test_the_blocks_stay_open_beside_a_workspace_with_room(beginners: Studio) -> None:
    studio = beginners
    flyout = studio.page.locator(".blocklyToolboxFlyout")
    expect(flyout).to_be_visible()
    for category in ("motion", "flow", "logic", "gestures", "show", "show"):
        studio.blocks.category(category).click()
        expect(flyout).to_be_visible()
        right = box_of(flyout)["x"] + box_of(flyout)["width"]
        blocks = flyout.locator(".blocklyBlockCanvas > .blocklyDraggable > .blocklyPath")
        for block in blocks.all():
            box = block.bounding_box()
            assert box is not None
            assert box["x"] + box["width"] < right, "a block is cut off"
    pane = box_of(studio["editor"])
    assert pane["x"] + pane["width"] - right >= ROOM_PX
    assert box_of(studio.blocks.start())["x"] > right
    studio.blocks.select(studio.blocks.start())
    expect(flyout).to_be_visible()
    studio["level"].select_option("2")
    expect(flyout).to_be_hidden()


def test_a_click_appends_in_the_loop_that_is_selected_else_at_the_end(beginners: Studio) -> None:
    studio, blocks = beginners, beginners.blocks
    studio.wait_for_screen("editor")
    start = box_of(blocks.start())
    blocks.click_in_toolbox("motion", "andar para frente")
    expect(announcement(studio)).to_contain_text(
        "“andar para frente 1 m” entrou no fim do programa."
    )
    blocks.click_in_toolbox("flow", "repetir")
    blocks.click_in_toolbox("motion", "girar")
    expect(announcement(studio)).to_contain_text("entrou dentro de “repetir 4 vezes”.")
    assert (box_of(blocks.start())["x"], box_of(blocks.start())["y"]) == (start["x"], start["y"])
    studio.eventually(studio.actions, ["move_forward", "repeat"])
    studio.eventually(lambda: inside(studio), [[], ["turn"]])

    blocks.select(blocks.start())
    blocks.click_in_flyout("parar")
    studio.eventually(studio.actions, ["move_forward", "repeat", "stop"])
    blocks.select(blocks.by_text("girar"))
    blocks.click_in_flyout("andar para trás")
    studio.eventually(lambda: inside(studio), [[], ["turn", "move_backward"], []])

    studio["undo"].click()
    studio.eventually(lambda: inside(studio), [[], ["turn"], []])
    studio["undo"].click()
    studio.eventually(studio.actions, ["move_forward", "repeat"])


def test_a_value_goes_where_it_fits_or_lies_loose(beginners: Studio) -> None:
    studio, blocks = beginners, beginners.blocks
    blocks.click_in_toolbox("logic", "se")
    blocks.click_in_flyout("sinal lido")
    expected = {"op": "==", "args": [{"gesture": "result"}, "B"]}
    studio.eventually(lambda: studio.values("condition"), [expected])
    blocks.select(blocks.start())
    blocks.click_in_toolbox("gestures", "sinal lido")
    expect(blocks.loose()).to_have_count(1)
    expect(announcement(studio)).to_contain_text("ficou solto")


def test_what_is_appended_below_a_long_program_is_brought_into_view(beginners: Studio) -> None:
    studio, blocks = beginners, beginners.blocks
    for _ in range(14):
        blocks.click_in_flyout("girar")
    last, trash = (
        blocks.all().last.locator("> .blocklyPath").first,
        studio.page.locator(".blocklyTrash"),
    )

    def is_above_the_trash() -> bool:
        box = last.bounding_box()
        return box is not None and box["y"] + box["height"] <= box_of(trash)["y"]

    studio.eventually(is_above_the_trash, True)


def test_a_tap_appends_as_well(open_studio: OpenStudio) -> None:
    studio = open_studio(has_touch=True)
    studio.enter_new_group(level=None)
    studio.blocks.in_flyout("girar").tap(position={"x": 20, "y": 20})
    studio.eventually(studio.actions, ["turn"])


def test_a_click_appends_in_the_other_levels_and_closes_the_category(studio: Studio) -> None:
    studio.enter_new_group()
    studio.blocks.click_in_toolbox("flow", "repetir para sempre")
    expect(studio.page.locator(".blocklyToolboxFlyout")).to_be_hidden()
    studio.blocks.click_in_toolbox("motion", "andar para frente")
    studio.eventually(lambda: inside(studio), [["move_forward"]])


def test_trash_zoom_and_search_work_beside_the_open_palette(beginners: Studio) -> None:
    studio, blocks = beginners, beginners.blocks
    studio["toolbox-search"].fill("repetir")
    blocks.click_in_flyout("repetir")
    studio.eventually(studio.actions, ["repeat"])
    before = box_of(blocks.by_text("repetir"))["width"]
    flyout_width = box_of(blocks.in_flyout("repetir"))["width"]
    studio["editor-zoom-in"].click()
    assert box_of(blocks.by_text("repetir"))["width"] > before
    assert box_of(blocks.in_flyout("repetir"))["width"] == flyout_width

    blocks.select(blocks.by_text("repetir"))
    studio.page.keyboard.press("Delete")
    expect(blocks.all()).to_have_count(1)
    studio.page.locator(".blocklyTrash").click()
    lost = studio.page.locator(".blocklyTrashcanFlyout .blocklyDraggable:not(.blocklyShadow)")
    lost.first.click(position={"x": 20, "y": 20})
    studio.eventually(studio.actions, ["repeat"])


def test_the_search_knows_what_pupils_say_and_where_a_block_is(beginners: Studio) -> None:
    flyout = beginners.page.locator(".blocklyToolboxFlyout")
    beginners["toolbox-search"].fill("VIRAR")
    expect(beginners.blocks.in_flyout("girar")).to_be_visible()
    beginners["toolbox-search"].fill("parede")
    expect(flyout).to_contain_text("em outro nível")
    beginners["toolbox-search"].fill("xyzw")
    expect(flyout).to_contain_text("Nenhum bloco")


def test_a_new_choice_asks_nothing_about_signs(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    studio.blocks.click_in_toolbox("logic", "se")
    expect(studio.blocks.by_text("se")).to_contain_text("verdadeiro")
    studio.eventually(lambda: studio.values("condition"), [True])
