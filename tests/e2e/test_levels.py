"""Number of blocks in the toolbox at each level."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.python_pane import write_program
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def test_a_new_group_begins_with_the_first_steps(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    expect(studio["level"]).to_have_value("1")
    expect(studio.blocks.category("motion")).to_be_visible()
    expect(studio.blocks.category("functions")).to_have_count(0)


def test_a_level_is_chosen_and_remembered_for_the_group(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    group = studio.api("/groups")["groups"][0]["name"]
    studio.choose_level(3)
    expect(studio.blocks.category("functions")).to_be_visible()
    studio.page.reload()
    studio.wait_until_open()
    expect(studio["level"]).to_have_value("3")
    expect(studio.blocks.category("functions")).to_be_visible()

    studio["home"].click()
    studio.enter_new_group("As Capivaras", level=None)
    expect(studio["level"]).to_have_value("1")
    expect(studio.blocks.category("functions")).to_have_count(0)
    studio["home"].click()
    studio["group-card"].filter(has_text=group).click()
    studio.wait_until_open()
    expect(studio["level"]).to_have_value("3")


def test_a_program_above_the_first_steps_opens_in_its_level(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    write_program(studio, "for k in range(1, 5):\n    robot.move_forward(k / 10)\n")
    studio.eventually(studio.actions, ["for"])
    studio.page.reload()
    studio.wait_until_open()
    expect(studio["level"]).to_have_value("2")


def test_a_program_above_the_level_stays_whole(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, "def f():\n    robot.stop()\n\n\nf()\n")
    studio.eventually(studio.actions, ["call"])
    studio["level"].select_option("1")
    studio.page.reload()
    studio.wait_until_open()
    expect(studio.blocks.by_text("definir")).to_be_visible()
    assert studio.actions() == ["call"]
