"""How many blocks the toolbox offers."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.python_pane import write_program
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def test_a_level_is_chosen_and_remembered(studio: Studio) -> None:
    studio.enter_new_group()
    expect(studio.blocks.category("functions")).to_be_visible()
    studio["level"].select_option("1")
    expect(studio.blocks.category("functions")).to_have_count(0)
    expect(studio.blocks.category("motion")).to_be_visible()
    studio.page.reload()
    studio.wait_until_open()
    expect(studio["level"]).to_have_value("1")
    expect(studio.blocks.category("functions")).to_have_count(0)


def test_a_program_above_the_level_stays_whole(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, "def f():\n    robot.stop()\n\n\nf()\n")
    studio.eventually(studio.actions, ["call"])
    studio["level"].select_option("1")
    studio.page.reload()
    studio.wait_until_open()
    expect(studio.blocks.by_words("definir")).to_be_visible()
    assert studio.actions() == ["call"]
