"""World, robot setting and speed belong to a program: they persist, and do not affect other programs."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

SETTINGS = ("world", "lifelike", "speed")


def expect_chosen(studio: Studio, *values: str) -> None:
    for name, value in zip(SETTINGS, values, strict=True):
        expect(studio[name]).to_have_value(value)


def test_what_was_chosen_for_a_program_is_there_tomorrow_and_nowhere_else(
    studio: Studio, open_studio: OpenStudio, app: AppProcess, watch: Watch
) -> None:
    watch.expect("Failed to load resource")  # the open page sends requests to the stopped server
    studio.enter_group("Os Tatus")
    at_first = ("empty_room", "ideal", "1")
    expect_chosen(studio, *at_first)
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    studio.eventually(studio.actions, ["move_forward"])
    now = ("maze", "camera", "2")
    for name, value in zip(SETTINGS, now, strict=True):
        studio[name].select_option(value)
    expect_chosen(studio, *now)
    studio.wait_until_saved()

    app.stop()
    expect(studio["gone"]).to_be_visible()
    app.start()
    reopened = open_studio()
    reopened.enter_group("Robôs")
    expect_chosen(reopened, *at_first)
    reopened.page.goto(f"{reopened.origin}/#/")
    reopened["group-card"].filter(has_text="Os Tatus").click()
    reopened.wait_until_open()
    reopened.choose_level(3)  # this window has no choice of the group
    expect_chosen(reopened, *now)
    reopened.run()
    reopened.wait_for_phase("finished")
    (run,) = reopened.api(f"/groups/{reopened.api('/groups')['groups'][0]['id']}/runs")["runs"]
    assert run["world"] == "maze"


def test_the_history_and_the_comparison_name_the_world(studio: Studio) -> None:
    studio.enter_new_group()
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    studio.eventually(studio.actions, ["move_forward"])
    studio.wait_until_saved()
    program, page = studio.program_id, studio.page
    studio["world"].select_option("maze")
    studio.eventually(
        lambda: studio.api(f"/programs/{program}")["version"]["setup"]["world"], "maze"
    )
    first, last = reversed(studio.api(f"/programs/{program}/versions")["versions"][:2])
    page.goto(f"{studio.origin}/#/versions/{program}")
    expect(studio["version-step"].last).to_contain_text("1 mudança")
    expect(studio["version-step"].last).to_contain_text("Mundo: Labirinto")
    page.goto(f"{studio.origin}/#/differences/{program}/{first['id']}/{last['id']}")
    expect(studio["setup-differences"]).to_have_text("MundoSala vazia → Labirinto")
    expect(studio["difference-count"]).to_have_text("1 diferença")
