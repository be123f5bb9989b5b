"""The whole language by hand: branches, variables, functions, comments, search, levels, and large programs."""

import json
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.blocks import box_of
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

SAVED_BEFORE = Path(__file__).parents[1] / "compatibility/files/blocks/conversation.json"


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


@pytest.fixture
def empty(studio: Studio) -> Studio:
    studio.enter_new_group()
    return studio


def flyout(studio: Studio) -> Locator:
    return studio.page.locator(".blocklyToolboxFlyout .blocklyBlockCanvas > .blocklyDraggable")


def press_on_block(studio: Studio, block: Locator, label: str) -> None:
    """Presses a plus or minus button on a block."""
    before = block.text_content() or ""
    block.locator(f'[aria-label="{label}"]').last.click()
    expect(block).not_to_have_text(before)


def answer(page: Page, text: str) -> None:
    """Types the answer to the open question."""
    field = page.locator("dialog input")
    field.fill(text)
    field.press("Enter")
    expect(page.locator("dialog[open]")).to_have_count(0)


def test_a_block_is_found_by_its_words_without_accents(empty: Studio) -> None:
    blocks = empty.blocks
    empty["toolbox-search"].click()
    empty.page.keyboard.type("TRAS")
    expect(flyout(empty).first).to_contain_text("andar para trás")
    outline = flyout(empty).first.locator("> .blocklyPath")
    blocks._drag(outline, blocks.below(blocks.start()))
    empty.eventually(empty.actions, ["move_backward"])

    empty["toolbox-search"].fill("xyzw")
    expect(empty.page.locator(".blocklyToolboxFlyout")).to_contain_text("Nenhum bloco")
    empty["toolbox-search"].press("Escape")
    expect(empty["toolbox-search"]).to_have_value("")
    # beside an empty search is only a note, which cannot have the focus
    empty["toolbox-search"].press("ArrowRight")
    expect(empty["toolbox-search"]).to_be_focused()
    empty["toolbox-search"].press("ArrowDown")
    expect(empty.page.locator(".blocklyToolboxCategoryContainer:focus")).to_contain_text(
        "Movimento"
    )


def test_an_if_grows_and_shrinks_on_the_block(empty: Studio) -> None:
    blocks = empty.blocks
    blocks.drag_from_toolbox("logic", "se", blocks.below(blocks.start()))
    condition = blocks.by_text("então")
    press_on_block(empty, condition, "Acrescentar um senão")
    press_on_block(empty, condition, "Acrescentar um senão")
    expect(condition).to_contain_text("senão, se")
    blocks.drag_from_toolbox("show", "apitar", blocks.inside(condition, 220))
    empty["undo"].click()
    empty["undo"].click()
    expect(condition).not_to_contain_text("senão, se")
    press_on_block(empty, condition, "Tirar esta parte")
    expect(condition).not_to_contain_text("senão")
    empty.eventually(lambda: [one or [] for one in empty.values("else")], [[]])


def test_a_variable_gets_a_name_and_another(empty: Studio) -> None:
    blocks = empty.blocks
    blocks.drag_from_toolbox("variables", "mudar", blocks.below(blocks.start()))
    blocks.drag_from_toolbox("variables", "somar", blocks.below(blocks.by_text("mudar")))
    blocks.choose(blocks.by_text("mudar"), "Nova variável")
    answer(empty.page, "  lado da casa ")
    empty.eventually(lambda: empty.values("name"), ["lado da casa", "contador"])
    blocks.choose(blocks.by_text("somar"), "lado da casa")
    blocks.choose(blocks.by_text("somar"), "Trocar o nome")
    answer(empty.page, "aresta")
    empty.eventually(lambda: empty.values("name"), ["aresta", "aresta"])
    empty["undo"].click()
    empty.eventually(lambda: empty.values("name"), ["lado da casa", "lado da casa"])
    blocks.choose(blocks.by_text("mudar"), "Nova variável")
    answer(empty.page, "a-b")
    expect(empty.page.locator(".blocklyToast")).to_contain_text("letras, números")


def test_a_function_with_a_value_is_made_and_called(empty: Studio) -> None:
    blocks = empty.blocks
    start = blocks.start()
    blocks.drag_from_toolbox("functions", "definir", blocks.beside(start, 120))
    definition = blocks.by_text("definir")
    blocks.type_into(definition, "lado")
    press_on_block(empty, definition, "Acrescentar um valor à função")
    blocks.type_into(definition, "tamanho", 1)
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(definition))
    blocks.drag_from_toolbox("functions", "tamanho:", blocks.below(start))
    call = blocks.by_text("tamanho:")
    blocks.type_into(call, "0,5")
    empty.eventually(lambda: empty.values("arguments"), [{"tamanho": 0.5}])
    document = empty.document()
    assert document is not None
    function = document["functions"][0]
    assert (function["name"], function["parameters"]) == ("lado", ["tamanho"])
    assert [command["action"] for command in function["commands"]] == ["move_forward"]

    blocks.type_into(definition, "aresta")
    expect(call).to_contain_text("aresta")
    empty.eventually(lambda: empty.values("function"), ["aresta"])


@pytest.mark.parametrize(
    ("typed", "message"), [("a-b", "letras, números"), ("", "letras, números")]
)
def test_what_is_no_name_is_refused_in_words(empty: Studio, typed: str, message: str) -> None:
    blocks = empty.blocks
    blocks.drag_from_toolbox("functions", "definir", blocks.beside(blocks.start(), 120))
    definition = blocks.by_text("definir")
    blocks.type_into(definition, typed)
    expect(empty.page.locator(".blocklyToast")).to_contain_text(message)
    expect(definition).to_contain_text("função")


def test_a_variable_is_named_by_keyboard(empty: Studio) -> None:
    blocks = empty.blocks
    blocks.drag_from_toolbox("variables", "mudar", blocks.below(blocks.start()))
    blocks.select(blocks.by_text("mudar"))
    keyboard = empty.page.keyboard
    keyboard.press("ArrowRight")
    keyboard.press("Enter")
    expect(empty.page.locator(".blocklyDropDownDiv .blocklyMenu")).to_be_visible()
    keyboard.press("ArrowDown")
    keyboard.press("Enter")
    expect(empty.page.locator("dialog input")).to_be_focused()
    keyboard.type("voltas")
    keyboard.press("Enter")
    empty.eventually(lambda: empty.values("name"), ["voltas"])


def test_a_value_of_the_wrong_kind_does_not_snap(empty: Studio) -> None:
    blocks = empty.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    place = blocks.by_text("andar para frente").locator(".blocklyInputField").first
    box = box_of(place)
    for category, block_text, loose in (("text", "juntar", 1), ("sensing", "tempo", 1)):
        blocks.category(category).click()
        outline = blocks.in_flyout(block_text).locator("> .blocklyPath")
        from_ = box_of(outline)
        mouse = empty.page.mouse
        mouse.move(from_["x"] + 8, from_["y"] + from_["height"] / 2)
        mouse.down()
        mouse.move(box["x"] + 10, box["y"] + box["height"] / 2, steps=6)
        mouse.move(box["x"] + 12, box["y"] + box["height"] / 2)
        mouse.up()
        expect(blocks.loose()).to_have_count(loose)
    empty.eventually(lambda: empty.values("distance"), [{"sensor": "time"}])


def test_what_is_written_on_a_block_is_in_the_document(empty: Studio) -> None:
    blocks = empty.blocks
    blocks.drag_from_toolbox("show", "apitar", blocks.below(blocks.start()))
    blocks.by_text("apitar").locator("> .blocklyPath").first.click(
        button="right", position={"x": 5, "y": 40}
    )
    empty.page.locator(".blocklyContextMenu .blocklyMenuItem", has_text="comentário").click()
    area = empty.page.locator("textarea.blocklyCommentText, textarea").first
    area.fill("avisa que chegou")
    area.press("Escape")
    empty.eventually(lambda: empty.values("comment"), ["avisa que chegou"])


def test_plus_is_pressed_by_keyboard(empty: Studio) -> None:
    blocks = empty.blocks
    blocks.drag_from_toolbox("logic", "se", blocks.below(blocks.start()))
    condition = blocks.by_text("então")
    blocks.select(condition)
    keyboard = empty.page.keyboard
    for _ in range(12):
        focused = empty.page.locator(".blocklyActiveFocus").first.get_attribute("aria-label")
        if focused == "Acrescentar um senão":
            break
        keyboard.press("ArrowRight")
    keyboard.press("Enter")
    expect(condition).to_contain_text("senão")


def test_a_program_that_was_saved_before_opens_and_is_the_same(empty: Studio) -> None:
    saved = json.loads(SAVED_BEFORE.read_text("utf-8"))
    empty.page.evaluate(
        """([program, workspace]) => fetch(`/api/programs/${program}/versions`, {
            method: 'POST',
            headers: { 'Content-Type': 'application/json' },
            body: JSON.stringify({ workspace, document: null }),
        })""",
        [empty.program_id, saved["workspace"]],
    )
    empty.page.reload()
    empty.wait_until_open()
    blocks = empty.blocks
    expect(blocks.by_text("ler sinal")).to_be_visible()
    assert empty.document() is None  # opening a program is no edit

    blocks.type_into(blocks.by_text("ler sinal"), "2,5")
    expected = saved["document"]["commands"]
    assert expected[0]["action"] == "classify_gestures"
    expected[0]["timeout"] = 2.5
    empty.eventually(lambda: without_empty_branches(empty.commands()), expected)


def without_empty_branches(value: Any) -> Any:
    """Removes empty branches of conditionals, which the reader of documents adds."""
    if isinstance(value, list):
        return [without_empty_branches(one) for one in value]
    if not isinstance(value, dict):
        return value
    present = {key: one for key, one in value.items() if one != [] or key not in ("elif", "else")}
    return {key: without_empty_branches(one) for key, one in present.items()}
