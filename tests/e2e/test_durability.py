"""A group's work is on disk without an explicit save."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.made_program import enter_made_group
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def test_an_edit_survives_a_cut_of_power(
    studio: Studio, open_studio: OpenStudio, app: AppProcess, watch: Watch
) -> None:
    watch.expect("Failed to load resource")  # the open page sends requests to the stopped server
    name = studio.unique("Os Tatus")
    studio.enter_group(name)
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    blocks.type_into(blocks.by_text("andar para frente"), "0,7")
    blocks.drag_from_toolbox("motion", "parar", blocks.beside(blocks.by_text("andar para frente")))
    studio.eventually(lambda: studio.values("distance"), [0.7])
    studio.eventually(studio.stacks, 2)
    [move] = studio.commands()
    app.kill()
    expect(studio["gone"]).to_be_visible()

    app.start()
    reopened = open_studio()
    reopened["group-card"].filter(has=reopened.page.get_by_text(name, exact=True)).click()
    reopened.wait_until_open()
    assert reopened.commands() == [move]
    assert move["distance"] == 0.7
    expect(reopened.blocks.by_id(move["block"])).to_contain_text("0,7")
    expect(reopened.blocks.by_text("parar")).to_be_visible()


def test_the_page_lets_less_than_a_second_pass_before_an_edit_is_on_disk(studio: Studio) -> None:
    """By the page's own clock, which a busy PC does not slow down."""
    studio.enter_new_group()
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    studio.eventually(studio.actions, ["move_forward"])
    studio.wait_until_saved()
    clock = studio.page.clock
    clock.install()
    for distance in (2, 3):
        clock.pause_at(studio.page.evaluate("Date.now()") / 1000 + 60)
        with studio.page.expect_response(lambda answer: answer.url.endswith("/versions")) as saved:
            blocks.type_into(blocks.by_text("andar para frente"), str(distance))
            clock.run_for(999)
        assert saved.value.ok
        assert studio.values("distance") == [distance]
        clock.resume()


def test_what_was_typed_last_is_kept_by_who_leaves_at_once(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 1)])
    blocks = studio.blocks
    program = f"/programs/{studio.program_id}"

    blocks.by_text("andar para frente").locator(".blocklyInputField").click()
    studio.page.locator(".blocklyHtmlInput").fill("0,9")
    studio.page.evaluate("document.querySelector('[data-testid=open-work]').click()")

    expect(studio["program-card"]).to_be_visible()
    studio.eventually(
        lambda: studio.api(program)["version"]["document"]["commands"][0]["distance"], 0.9
    )


def two_windows(studio: Studio, open_studio: OpenStudio) -> Studio:
    """The open program in a second window too."""
    enter_made_group(studio, [("move_forward", 1)])
    other = open_studio()
    other.page.goto(studio.page.url)
    other.wait_until_open()
    return other


def set_distance(studio: Studio, distance: str) -> None:
    studio.page.bring_to_front()
    studio.blocks.type_into(studio.blocks.by_text("andar para frente"), distance)
    studio.eventually(lambda: studio.values("distance"), [float(distance)])


def test_two_windows_with_one_program_know_of_each_other_and_history_tells_who_changed_what(
    studio: Studio, open_studio: OpenStudio
) -> None:
    other = two_windows(studio, open_studio)
    set_distance(studio, "2")
    expect(other["other-window"]).to_have_text("Abrir a mais nova")
    set_distance(other, "3")
    expect(studio["other-window"]).to_have_text("Abrir a mais nova")
    expect(other["other-window"]).to_have_text("Ver a outra versão")

    line = studio.api(f"/programs/{studio.program_id}/versions")["versions"]
    first = line[-1]["id"]
    assert [one["parent_id"] for one in line] == [first, first, None]

    studio.page.bring_to_front()
    studio["other-window"].click()
    expect(studio.blocks.by_text("andar para frente")).to_contain_text("3")
    expect(studio["other-window"]).to_have_count(0)
    set_distance(studio, "4")
    expect(other["other-window"]).to_have_text("Abrir a mais nova")
    assert studio.api(f"/programs/{studio.program_id}/versions")["versions"][1:] == line


def test_who_goes_on_after_another_window_finds_its_version_in_the_history(
    studio: Studio, open_studio: OpenStudio
) -> None:
    other = two_windows(studio, open_studio)
    set_distance(studio, "2")
    set_distance(other, "3")
    expect(other["other-window"]).to_have_text("Ver a outra versão")
    other["other-window"].click()
    expect(other["version-shown"]).to_have_attribute("data-number", "2")
    expect(other["version-blocks"]).to_contain_text("2")


def test_a_program_that_is_thrown_away_in_another_window_says_so_and_can_be_taken_back(
    studio: Studio, open_studio: OpenStudio
) -> None:
    other = two_windows(studio, open_studio)
    other["open-work"].click()
    other["throw-away"].click()
    expect(studio["take-back"]).to_be_visible()
    studio.page.bring_to_front()
    studio["take-back"].click()
    expect(studio["take-back"]).to_have_count(0)
    assert studio.api(f"/programs/{studio.program_id}")["deleted_at"] is None


def test_a_save_tells_that_the_program_is_in_the_bin(studio: Studio, watch: Watch) -> None:
    # the stream that would report the deletion to the window
    watch.expect("Failed to load resource")
    studio.enter_new_group()
    studio.page.route("**/api/stream", lambda route: route.abort())
    studio.page.reload()
    studio.wait_until_open()
    studio.send("DELETE", f"/programs/{studio.program_id}")
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    expect(studio["take-back"]).to_be_visible()


def test_looking_around_makes_no_new_version(studio: Studio) -> None:
    studio.enter_new_group()
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
    blocks.type_into(blocks.by_text("andar para frente"), "1")
    studio.wait_until_saved()

    [after] = studio.api(programs)["programs"]
    assert after["n_versions"] == before["n_versions"]
