"""Notices on blocks: the program runs, but probably not as intended."""

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.axe import violations
from tests.e2e.python_pane import write_program
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

NEVER_RED = """
while not robot.floor == "vermelho":
    robot.move_forward(0.1)
if robot.cell == "Casa":
    robot.say("oi")
"""


def noticed(studio: Studio) -> Locator:
    return studio.page.locator(".blocklyBlockCanvas .pinelNotice")


def test_a_comparison_that_is_never_true_is_said_at_its_block(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, NEVER_RED)
    expect(noticed(studio)).to_have_count(2)
    noticed(studio).first.locator("> .blocklyWarningIcon").click()
    bubble = studio.blocks.fault_text()
    expect(bubble).to_contain_text("nunca é igual")
    expect(bubble).to_contain_text("Troquem o texto pelo bloco de cor")
    assert violations(studio, bubble) == []

    studio["world"].select_option("tic_tac_toe")
    noticed(studio).last.locator("> .blocklyWarningIcon").click()
    expect(studio.blocks.fault_text().last).to_contain_text("Os lugares dele são:")

    write_program(studio, NEVER_RED.replace("vermelho", "red").replace("Casa", "A"))
    expect(noticed(studio)).to_have_count(0)
