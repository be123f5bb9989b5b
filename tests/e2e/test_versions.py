"""A group's work is never lost: undo after a restart, the version history, the bin, and the teacher's notes."""

import re
import shutil
from contextlib import closing

import pytest
from playwright.sync_api import Locator, expect

from storage.sqlite import sqlite3
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.made_program import enter_made_group
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

MOVE = "andar para frente"


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def enter(studio: Studio) -> str:
    """Creates a group; returns its name."""
    name = studio.unique("Os Tatus")
    studio.enter_group(name)
    return name


def enter_made(studio: Studio, *metres: float, speed: float = 1.0) -> str:
    """Creates a group whose one block got each of these distances, each in a version of its own; returns its name."""
    enter_made_group(studio, *[[("move_forward", one)] for one in metres], speed=speed)
    return str(studio.api("/groups")["groups"][0]["name"])


def card(studio: Studio, name: str) -> Locator:
    return studio["group-card"].filter(has=studio.page.get_by_text(name, exact=True))


def group_of(studio: Studio) -> str:
    return str(studio.api(f"/programs/{studio.program_id}")["group_id"])


def build(studio: Studio, *distances: str) -> None:
    """Builds one block and changes its distance repeatedly, each change in a version of its own."""
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", MOVE, blocks.below(blocks.start()))
    studio.eventually(studio.actions, ["move_forward"])
    for distance in distances:
        set_distance(studio, distance)


def set_distance(studio: Studio, distance: str) -> None:
    studio.blocks.type_into(studio.blocks.by_text(MOVE), distance)
    studio.eventually(lambda: studio.values("distance"), [float(distance.replace(",", "."))])


def test_undo_goes_on_after_the_app_was_closed(
    studio: Studio, open_studio: OpenStudio, app: AppProcess, watch: Watch
) -> None:
    watch.expect("Failed to load resource")  # the open page sends requests to the stopped server
    name = enter(studio)
    build(studio, "0,7", "2")
    app.stop()
    expect(studio["gone"]).to_be_visible()

    app.start()
    reopened = open_studio()
    card(reopened, name).click()
    reopened.wait_until_open()
    reopened["undo"].click()
    reopened.eventually(lambda: reopened.values("distance"), [0.7])
    expect(reopened.blocks.by_text(MOVE)).to_contain_text("0,7")
    reopened["redo"].click()
    reopened.eventually(lambda: reopened.values("distance"), [2])

    reopened["undo"].click()
    reopened.eventually(lambda: reopened.values("distance"), [0.7])
    reopened.blocks.select(reopened.blocks.start())
    reopened.page.keyboard.press("Control+z")
    reopened.eventually(lambda: reopened.values("distance"), [1])
    reopened["undo"].click()
    reopened.eventually(lambda: len(reopened.commands()), 0)
    reopened["undo"].click()  # nothing is left to undo
    for distance in (1, 0.7, 2):
        reopened["redo"].click()
        reopened.eventually(lambda: reopened.values("distance"), [distance])


def test_what_was_undone_is_not_gone_through_again_after_a_restart(
    studio: Studio, open_studio: OpenStudio
) -> None:
    name = enter(studio)
    build(studio, "0,7", "2")
    studio["undo"].click()
    studio.eventually(lambda: studio.values("distance"), [0.7])

    reopened = open_studio()
    card(reopened, name).click()
    reopened.wait_until_open()
    reopened["undo"].click()
    reopened.eventually(lambda: reopened.values("distance"), [1])


def open_history(studio: Studio) -> None:
    studio["open-history"].click()
    expect(studio["version-shown"]).to_be_visible()


def numbers(studio: Studio) -> list[str]:
    """Returns the number of the shown version, and the number of the active step in the list."""
    shown = studio["version-shown"].get_attribute("data-number") or ""
    current = studio.page.locator('[data-testid=version-step][aria-current="true"]')
    return [shown, current.get_attribute("data-number") or ""]


def test_a_group_steps_through_its_versions_names_one_and_goes_on_from_it(studio: Studio) -> None:
    enter(studio)
    build(studio, "0,7", "2")
    open_history(studio)
    page = studio.page
    studio.eventually(lambda: numbers(studio), ["3", "3"])
    expect(studio["version-step"]).to_have_count(1)  # a burst of edits is one entry
    expect(studio["version-go-on"]).to_be_disabled()

    page.keyboard.press("ArrowLeft")
    studio.eventually(lambda: numbers(studio)[0], "2")
    expect(studio["version-blocks"]).to_contain_text("0,7")
    expect(page.locator(".pinelChanged")).to_have_count(1)  # the value that this version changed
    studio["version-unfold"].click()
    expect(studio["version-step"]).to_have_count(4)
    studio["version-older"].click()
    studio.eventually(lambda: numbers(studio), ["1", "1"])
    studio["version-slider"].fill("1")
    studio.eventually(lambda: numbers(studio), ["2", "2"])

    studio["version-rename"].click()
    studio["version-name"].fill("anda certo")
    studio["version-keep-name"].click()
    expect(studio["version-shown"]).to_contain_text("anda certo")
    expect(page.locator('[data-testid=version-step][data-number="2"]')).to_contain_text(
        "anda certo"
    )
    program = re.search(r"#/versions/([^/]+)", page.url)
    assert program
    line = studio.api(f"/programs/{program[1]}/versions")["versions"]
    assert [one["label"] for one in line] == ["", "anda certo", ""]

    studio["version-go-on"].click()
    studio.wait_until_open()
    expect(studio.blocks.by_text(MOVE)).to_contain_text("0,7")
    assert studio.values("distance") == [0.7]
    line = studio.api(f"/programs/{studio.program_id}/versions")["versions"]
    assert [one["number"] for one in line] == [4, 3, 2, 1]
    assert line[0]["parent_id"] == line[2]["id"]
    studio["undo"].click()  # goes back from the version that was continued
    studio.eventually(lambda: studio.values("distance"), [1])


def test_who_went_on_from_an_old_version_can_go_back_to_the_one_that_was_left(
    studio: Studio,
) -> None:
    enter_made(studio, 1, 0.7, 2)
    open_history(studio)
    studio.page.keyboard.press("Home")
    studio.eventually(lambda: numbers(studio)[0], "1")
    studio["version-go-on"].click()
    studio.wait_until_open()
    expect(studio.page.get_by_text("Estes são os blocos da versão 1.")).to_be_visible()
    studio["version-return"].click()
    expect(studio["version-return"]).to_have_count(0)
    studio.eventually(lambda: studio.values("distance"), [2])
    line = studio.api(f"/programs/{studio.program_id}/versions")["versions"]
    assert [one["number"] for one in line] == [5, 4, 3, 2, 1]
    assert line[0]["parent_id"] == line[2]["id"]
    studio["redo"].click()
    studio.eventually(lambda: studio.values("distance"), [1])


def test_the_keyboard_stays_where_it_was_after_a_version_got_its_name(studio: Studio) -> None:
    enter_made(studio, 1)
    open_history(studio)
    for leave in ("Enter", "Escape"):
        studio["version-rename"].press("Enter")
        studio["version-name"].fill("anda certo")
        studio.page.keyboard.press(leave)
        expect(studio["version-rename"]).to_be_focused()


def test_two_versions_are_compared_block_by_block(studio: Studio) -> None:
    one, two = [("move_forward", 1.0)], [("move_forward", 2.0), ("turn", 90.0)]
    enter_made_group(studio, one, two)
    open_history(studio)
    page = studio.page
    page.keyboard.press("Home")
    studio.eventually(lambda: numbers(studio)[0], "1")
    studio["version-compare"].click()

    expect(studio["difference"]).to_have_count(2)
    changed, added = studio["difference"].first, studio["difference"].last
    expect(changed).to_have_attribute("data-kind", "changed")
    expect(changed).to_contain_text(f"{MOVE} 1 m → {MOVE} 2 m")
    expect(added).to_have_attribute("data-kind", "added")
    expect(added).to_contain_text("girar à esquerda 90°")
    expect(page.locator(".pinelChanged")).to_have_count(2)
    expect(page.locator(".pinelAdded")).to_have_count(1)

    page.keyboard.press("ArrowDown")
    expect(changed).to_have_attribute("aria-current", "true")
    expect(page.locator(".pinelRunning")).to_have_count(2)
    page.keyboard.press("ArrowDown")
    expect(added).to_have_attribute("aria-current", "true")
    expect(page.locator(".pinelRunning")).to_have_count(1)
    studio["difference-previous"].click()
    expect(changed).to_have_attribute("aria-current", "true")

    studio.choose_language("en")
    expect(added).to_contain_text("turn left 90°")
    expect(page.locator(".pinelAdded")).to_have_count(1)
    after = page.locator('[data-testid=difference-side][data-side="after"]')
    after.select_option(index=0)
    expect(studio["difference-count"]).to_be_visible()


def test_two_pcs_that_went_on_from_one_version_are_shown_side_by_side(
    studio: Studio, open_studio: OpenStudio, app: AppProcess, watch: Watch
) -> None:
    watch.expect("Failed to load resource")
    name = enter_made(studio, 1, 2)
    program = studio.program_id
    app.stop()
    with closing(sqlite3.connect(app.database)) as db, db:
        db.execute("UPDATE computers SET name = 'PC 3'")
        db.execute("INSERT INTO computers (id, name, changed_at) VALUES ('other', 'PC 7', '')")
        columns = [row[1] for row in db.execute("PRAGMA table_info(versions)")]
        rest = [name for name in columns if name not in ("id", "computer_id")]
        db.execute(
            f"INSERT INTO versions (id, computer_id, {', '.join(rest)})"
            f" SELECT substr(id, 1, 24) || 'ffffffffffff', 'other', {', '.join(rest)} FROM versions"
            " WHERE number = 2 AND program_id = ?",
            (program,),
        )
    app.start()
    reopened = open_studio()
    card(reopened, name).click()
    expect(reopened.page.get_by_text("PC 3 também continuou este programa")).to_be_visible()
    reopened["elsewhere"].click()
    expect(reopened["difference-count"]).to_have_text("0 diferenças")
    reopened.page.go_back()
    reopened.wait_until_open()
    expect(reopened["elsewhere"]).to_have_count(0)  # the notice was read
    reopened.page.goto(f"{app.origin}#/versions/{program}")
    expect(reopened["version-fork"]).to_contain_text("2 computadores")
    expect(reopened["version-branch"]).to_have_count(2)
    expect(reopened["version-branch"].locator("h3")).to_have_text(["PC 3", "PC 7"])
    reopened["version-compare-fork"].click()
    expect(reopened["difference-count"]).to_have_text("0 diferenças")


def test_a_program_goes_into_the_bin_and_comes_back(studio: Studio) -> None:
    enter_made(studio, 1, speed=10)
    studio.run()
    studio.wait_for_phase("finished")
    studio["open-work"].click()
    expect(studio["program-card"]).to_have_count(1)
    studio["throw-away"].click()
    expect(studio["program-card"]).to_have_count(0)
    expect(studio["run-card"]).to_have_count(1)  # runs stay
    studio["throw-back"].click()
    expect(studio["program-card"]).to_have_count(1)

    studio["throw-away"].click()
    studio.page.reload()
    studio["bin"].click()
    expect(studio["bin-program"]).to_contain_text("Programa 1")
    studio["take-back"].click()
    expect(studio["program-card"]).to_have_count(1)
    expect(studio["bin"]).to_have_count(0)


def test_a_double_click_makes_one_program(studio: Studio) -> None:
    studio.enter_new_group()
    programs = f"/groups/{group_of(studio)}/programs"
    studio["open-work"].click()
    studio["new-program"].dblclick()
    studio.wait_until_open()
    expect(studio["program-name"]).to_have_value("Programa 2")
    names = [one["name"] for one in studio.api(programs)["programs"]]
    assert names == ["Programa 2", "Programa 1"]

    studio.send("POST", "/groups", {"name": (name := studio.unique("As Emas"))})
    studio["home"].click()
    card(studio, name).dblclick()
    studio.wait_until_open()
    [emas] = [one for one in studio.api("/groups")["groups"] if one["name"] == name]
    assert emas["n_programs"] == 1


def test_runs_are_chosen_by_how_they_ended(studio: Studio) -> None:
    enter_made(studio, 1, speed=10)
    studio.run()
    studio.wait_for_phase("finished")
    studio["speed"].select_option("1")
    set_distance(studio, "50")
    studio.run()
    studio.wait_for_phase("running")
    studio["stop"].click()
    studio.wait_for_phase("stopped")
    studio["open-work"].click()
    expect(studio["run-card"]).to_have_count(2)
    choose = studio.page.locator
    choose('[data-testid=run-filter][data-outcome="stopped"]').click()
    expect(studio["run-card"]).to_have_count(1)
    expect(studio["run-card"]).to_have_attribute("data-state", "stopped")
    choose('[data-testid=run-filter][data-outcome="failed"]').click()
    expect(studio["run-card"]).to_have_count(0)
    choose('[data-testid=run-filter][data-outcome="all"]').click()
    expect(studio["run-card"]).to_have_count(2)


def test_a_group_reads_what_its_teacher_wrote(studio: Studio, open_studio: OpenStudio) -> None:
    name = enter(studio)
    build(studio)
    studio.hurry()
    studio.run()
    studio.wait_for_phase("finished")
    [run] = studio.api(f"/groups/{group_of(studio)}/runs")["runs"]
    write_note(open_studio(), run["id"])

    studio["home"].click()
    card(studio, name).click()
    expect(studio["note-card"]).to_contain_text("Por que 90°?")
    studio["note-run"].click()
    expect(studio["replay-play"]).to_be_visible()
    expect(studio["note-card"]).to_contain_text("Por que 90°?")
    studio["open-work"].click()
    studio["note-seen"].click()
    expect(studio["note-card"]).to_have_count(0)

    studio["home"].click()
    card(studio, name).click()
    studio.wait_until_open()


def write_note(teacher: Studio, run: str) -> None:
    teacher.open_teacher_part("314159")
    teacher.send("POST", f"/runs/{run}/notes", {"text": "Por que 90°?"})


def test_history_bin_and_letters_have_names_and_contrast(studio: Studio) -> None:
    name = enter(studio)
    found: dict[str, list[str]] = {}
    open_page = studio.page.goto
    origin = studio.page.url.split("#")[0]
    open_page(f"{origin}#/versions/{studio.program_id}")
    empty = studio.page.locator(".versions__empty")
    found["no versions"] = violations(studio, empty)
    open_page(f"{origin}#/")
    card(studio, name).click()
    studio.wait_until_open()
    build(studio, "2")
    studio.hurry()
    studio.run()
    studio.wait_for_phase("finished")
    [run] = studio.api(f"/groups/{group_of(studio)}/runs")["runs"]
    write_note(studio, run["id"])

    open_history(studio)
    found["versions"] = violations(studio, "version-shown")
    # the blocks fit
    expect(studio.page.locator(".blocklyScrollbarHandle:visible")).to_have_count(0)
    studio["version-compare"].click()
    expect(studio["difference"]).to_have_count(1)
    studio["difference"].click()
    found["differences"] = violations(studio, "difference")
    studio["open-work"].click()
    expect(studio["note-card"]).to_be_visible()
    studio["throw-away"].click()
    studio["bin"].click()
    expect(studio["take-back"]).to_be_visible()
    found["work"] = violations(studio, "take-back")
    studio["note-run"].click()
    expect(studio["note-card"]).to_be_visible()
    found["replay"] = violations(studio, "replay-play")
    assert {screen: one for screen, one in found.items() if one} == {}


def test_where_the_disk_damaged_the_newest_version_the_last_sound_one_is_opened_by_one_button(
    studio: Studio, open_studio: OpenStudio, app: AppProcess, watch: Watch
) -> None:
    watch.expect("Failed to load resource")
    name = enter_made(studio, 1, 2)
    program = studio.program_id
    app.stop()
    shutil.rmtree(app.database.parent / "backups", ignore_errors=True)  # a backup would repair it
    with closing(sqlite3.connect(app.database)) as db, db:
        db.execute(
            "UPDATE versions SET workspace = '{' WHERE number = 2 AND program_id = ?", (program,)
        )
    app.start()
    reopened = open_studio()
    card(reopened, name).click()
    expect(reopened["open-sound-version"]).to_contain_text("Abrir a última versão sem defeito")
    reopened["open-sound-version"].click()
    reopened.wait_until_open()
    expect(reopened.blocks.by_text(MOVE)).to_contain_text("1")
    reopened.blocks.type_into(reopened.blocks.by_text(MOVE), "3")
    address = f"{reopened.origin}/api/programs/{reopened.program_id}"
    reopened.eventually(lambda: reopened.page.context.request.get(address).ok, True)
    assert reopened.values("distance") == [3]
