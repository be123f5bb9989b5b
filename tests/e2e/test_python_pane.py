"""The program as Python: read beside the blocks, written, and converted to blocks."""

import re

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.python_pane import edit_python, open_python, write_program
from tests.e2e.studio import RUN_MS, Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

SQUARE = """def lado(tamanho):
    robot.move_forward(tamanho)
    robot.turn(90)


for _ in range(4):
    lado(0.5)
"""


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def test_the_text_follows_the_blocks(studio: Studio) -> None:
    studio.enter_new_group()
    blocks = studio.blocks
    open_python(studio)
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    expect(studio["python-text"]).to_contain_text("robot.move_forward(1.0)")
    blocks.type_into(blocks.by_text("andar para frente"), "2,5")
    expect(studio["python-text"]).to_contain_text("robot.move_forward(2.5)")


def test_the_line_that_runs_is_lit(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, "robot.wait(2)\nrobot.move_forward(3)\n")
    open_python(studio)
    expect(studio["python-text"]).to_contain_text("robot.move_forward(3.0)")
    lines = studio["python-text"].locator(".code__text").inner_text().splitlines()
    places = [
        str(1 + next(at for at, line in enumerate(lines) if call in line))
        for call in ("robot.wait", "robot.move_forward")
    ]
    studio.run()
    for place in places:
        expect(studio["python-text"]).to_have_attribute("data-lit", place, timeout=RUN_MS)
    studio["stop"].click()
    studio.wait_for_phase("stopped")
    expect(studio["python-text"]).to_have_attribute("data-lit", "")


def test_a_text_becomes_blocks_and_the_blocks_before_can_come_back(studio: Studio) -> None:
    studio.enter_new_group()
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "parar", blocks.below(blocks.start()))
    studio.eventually(studio.actions, ["stop"])

    edit_python(studio, SQUARE)
    expect(studio["python-state"]).to_have_attribute("data-state", "fine")
    studio["python-put"].click()
    expect(blocks.by_text("definir")).to_contain_text("lado")
    studio.eventually(studio.actions, ["repeat"])
    expect(studio["python-text"]).to_contain_text("lado(0.5)")

    studio["swap-back"].click()
    studio.eventually(studio.actions, ["stop"])
    studio["swap-back"].click()
    studio.eventually(studio.actions, ["repeat"])
    studio.page.reload()
    studio.wait_until_open()
    expect(blocks.by_text("definir")).to_contain_text("lado")


def test_the_name_in_the_text_is_the_name_of_the_program(studio: Studio) -> None:
    studio.enter_new_group()
    edit_python(studio, '"""Meu quadrado"""\n\nrobot.stop()\n')
    studio["python-put"].click()
    expect(studio["program-name"]).to_have_value("Meu quadrado")
    studio.eventually(lambda: str((studio.document() or {}).get("name")), "Meu quadrado")
    studio.eventually(lambda: studio.api(f"/programs/{studio.program_id}")["name"], "Meu quadrado")


def test_the_other_form_of_the_text_is_a_tab_away(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, "robot.stop()\n")
    open_python(studio)
    tab = studio["text-tab"].and_(studio.page.locator('[data-tab="python"]'))
    tab.focus()
    studio.page.keyboard.press("ArrowRight")
    expect(studio["ir-json"]).to_contain_text('"action": "stop"')
    studio.page.keyboard.press("ArrowLeft")
    expect(studio["python-text"]).to_contain_text("robot.stop()")


def test_every_fault_says_where_it_is_and_a_click_goes_there(studio: Studio) -> None:
    studio.enter_new_group()
    edit_python(studio, "robot.stop()\nrobot.fly(1)\nimport os\n")
    faults = studio["python-fault"]
    expect(faults).to_have_count(2)
    expect(studio["python-put"]).to_be_disabled()
    expect(studio["python-state"]).to_have_attribute("data-state", "faulty")
    studio.expect_each(faults, "data-line", ["2", "3"])
    expect(faults.first).to_contain_text(re.compile(r"Linha 2, coluna \d+"))

    faults.last.click()
    expect(studio["python-editor"]).to_be_focused()
    studio.page.keyboard.press("End")
    studio.page.keyboard.press("Shift+Home")
    studio.page.keyboard.type("robot.beep()")
    expect(faults).to_have_count(1)
    studio["python-editor"].fill("robot.stop()\n")
    expect(studio["python-state"]).to_have_attribute("data-state", "fine")


def test_leaving_changes_nothing(studio: Studio) -> None:
    studio.enter_new_group()
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "parar", blocks.below(blocks.start()))
    studio.eventually(studio.actions, ["stop"])
    edit_python(studio, "robot.beep()\n")
    studio["python-leave"].click()
    expect(studio["python-text"]).to_contain_text("robot.stop()")
    assert studio.actions() == ["stop"]


def test_typing_indents_and_the_keyboard_can_leave(studio: Studio) -> None:
    studio.enter_new_group()
    edit_python(studio, "")
    editor, keyboard = studio["python-editor"], studio.page.keyboard
    editor.focus()
    keyboard.type("while True:")
    keyboard.press("Enter")
    keyboard.type("robot.stop()")
    keyboard.press("Enter")
    keyboard.press("Shift+Tab")
    keyboard.type("robot.beep()")
    expect(editor).to_have_value("while True:\n    robot.stop()\nrobot.beep()")
    keyboard.press("Home")
    keyboard.press("Tab")
    expect(editor).to_have_value("while True:\n    robot.stop()\n    robot.beep()")
    keyboard.press("Control+z")
    expect(editor).to_have_value("while True:\n    robot.stop()\nrobot.beep()")

    keyboard.press("Escape")
    keyboard.press("Tab")
    expect(editor).not_to_be_focused()
    editor.focus()
    expect(studio["python-state"]).to_have_attribute("data-state", "fine")
    keyboard.press("Control+Enter")
    studio.eventually(studio.actions, ["forever", "beep"])


def test_what_is_written_is_not_lost_by_a_click_elsewhere(studio: Studio) -> None:
    studio.enter_new_group()
    edit_python(studio, "robot.stop()")
    expect(studio["ir-toggle"]).to_be_disabled()
    studio.blocks.start().click()
    expect(studio["python-editor"]).to_have_value("robot.stop()")


def test_faults_are_in_the_language_of_the_page(studio: Studio) -> None:
    studio.enter_new_group()
    edit_python(studio, "import os\n")
    expect(studio["python-fault"]).to_contain_text("Linha 1")
    studio.choose_language("en")
    expect(studio["python-fault"]).to_contain_text("Line 1")
    expect(studio["python-fault"]).not_to_contain_text("Não")
    studio.choose_language("pt-BR")


def test_more_commands_than_blocks_can_show_are_refused_in_words_and_kept(studio: Studio) -> None:
    studio.enter_new_group()
    # few lines: Chromium inserts a text of many lines slowly
    text = ("robot.beep(); " * 18 + "robot.beep()\n") * 79
    edit_python(studio, text)
    expect(studio["python-state"]).to_have_attribute("data-state", "fine", timeout=30_000)
    studio["python-put"].click()
    expect(studio.page.get_by_text("O programa tem 1501 comandos")).to_be_visible()
    expect(studio["python-editor"]).to_have_value(text)
