"""What a group did is on disk before it can think of saving."""

import time

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


def test_an_edit_survives_a_cut_of_power(
    studio: Studio, open_studio: OpenStudio, app: AppProcess, watch: Watch
) -> None:
    watch.expect("Failed to load resource")  # the open page asks for a server that is gone
    studio.enter_group("Os Tatus")
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    blocks.type_into(blocks.by_words("andar para frente"), "0,7")
    blocks.drag_from_toolbox("motion", "parar", blocks.beside(blocks.by_words("andar para frente")))
    studio.eventually(lambda: studio.values("distance"), [0.7])
    studio.eventually(studio.stacks, 2)
    [move] = studio.commands()
    app.kill()
    expect(studio["gone"]).to_be_visible()

    app.start()
    later = open_studio()
    later["group-card"].filter(has_text="Os Tatus").click()
    later.wait_until_open()
    assert later.commands() == [move]
    assert move["distance"] == 0.7
    expect(later.blocks.by_id(move["block"])).to_contain_text("0,7")
    expect(later.blocks.by_words("parar")).to_be_visible()


def test_an_edit_is_on_disk_within_a_second(studio: Studio) -> None:
    studio.enter_group("Os Tatus")
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    studio.eventually(studio.actions, ["move_forward"])
    for distance in ("2", "3"):
        with studio.page.expect_response(lambda answer: answer.url.endswith("/versions")) as saved:
            blocks.type_into(blocks.by_words("andar para frente"), distance)
            typed = time.monotonic()
        assert saved.value.ok
        assert time.monotonic() - typed < 1.0


def test_what_was_typed_last_is_kept_by_who_leaves_at_once(studio: Studio) -> None:
    studio.enter_group("Os Tatus")
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    studio.eventually(studio.actions, ["move_forward"])
    program = f"/programs/{studio.program_id}"

    blocks.by_words("andar para frente").locator(".blocklyInputField").click()
    studio.page.locator(".blocklyHtmlInput").fill("0,9")
    studio.page.evaluate("document.querySelector('[data-testid=open-work]').click()")

    expect(studio["program-card"]).to_be_visible()
    studio.eventually(
        lambda: studio.api(program)["version"]["document"]["commands"][0]["distance"], 0.9
    )


def test_looking_around_makes_no_new_version(studio: Studio) -> None:
    studio.enter_group("Os Tatus")
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    studio.eventually(studio.actions, ["move_forward"])
    studio.wait_until_saved()
    programs = f"/groups/{studio.api(f'/programs/{studio.program_id}')['group_id']}/programs"
    [before] = studio.api(programs)["programs"]

    blocks.select(blocks.start())
    blocks.category("logic").click()
    blocks.category("logic").click()
    studio["editor-zoom-in"].click()
    studio["editor-zoom-to-fit"].click()
    blocks.type_into(blocks.by_words("andar para frente"), "1")
    studio.wait_until_saved()

    [after] = studio.api(programs)["programs"]
    assert after["n_versions"] == before["n_versions"]
