"""An activity sets world, start pose and robot; the group reads the task and is notified of the pass."""

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.axe import violations
from tests.e2e.blocks import begin_mission, box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_classes import PIN, open_lesson, prepare, to_part
from tests.e2e.test_layout import cut
from tests.e2e.test_tour import do_step, expect_step

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

POLL_INTERVAL_MS = 15_000  # interval at which the page detects a lesson that the teacher opened
MOVE = "andar para frente"


def sign_in_with(studio: Studio) -> None:
    studio["teacher-link"].click()
    studio["pin"].fill(PIN)
    studio["sign-in"].click()


def put_move(studio: Studio, distance: str) -> None:
    """Begins the mission with one move."""
    begin_mission(studio.page)
    expect(studio["mission-sheet"]).to_have_count(0)
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", MOVE, blocks.below(blocks.start()))
    blocks.type_into(blocks.by_text(MOVE), distance)
    studio.eventually(lambda: studio.values("distance"), [float(distance.replace(",", "."))])


def test_the_group_stands_in_the_world_of_the_lesson(
    studio: Studio, open_studio: OpenStudio
) -> None:
    prepare(studio)
    to_part(studio, "lessons")
    open_lesson(studio, "Sair do labirinto", "maze")
    studio["sign-out"].click()
    pupils = open_studio()
    pupils.enter_group("Os Tatus")
    expect(pupils["mission"]).to_contain_text("labirinto", ignore_case=True)
    expect(pupils["world-locked"]).to_contain_text("Labirinto")
    expect(pupils["world"]).to_have_count(0)
    put_move(pupils, "1")
    pupils.hurry()
    pupils.run()
    pupils.wait_for_phase("finished")
    group = pupils.api("/groups")["groups"][0]["id"]
    (run,) = pupils.api(f"/groups/{group}/runs")["runs"]
    assert (run["world"], run["activity"]) == ("maze", "maze")
    expect(pupils["status-line"]).to_contain_text("Ainda não", timeout=RUN_MS)


def test_a_mission_that_the_teacher_opens_later_is_offered(
    studio: Studio, open_studio: OpenStudio
) -> None:
    prepare(studio)
    studio["sign-out"].click()
    studio.page.clock.install()
    studio.enter_group("Os Tatus")
    expect(studio["lesson-mission"]).to_have_count(0)
    teacher = open_studio()
    sign_in_with(teacher)
    to_part(teacher, "lessons")
    open_lesson(teacher, "Sair do labirinto", "maze")
    studio.page.clock.fast_forward(POLL_INTERVAL_MS)
    expect(studio["lesson-mission"]).to_be_visible()
    studio["lesson-mission"].click()
    expect(studio["world-locked"]).to_contain_text("Labirinto")
    expect(studio["lesson-mission"]).to_have_count(0)


def test_a_group_that_has_passed_the_mission_of_the_lesson_goes_on_without_its_banner(
    studio: Studio,
) -> None:
    prepare(studio)
    to_part(studio, "lessons")
    open_lesson(studio, "Primeira aula", "to_the_bakery")
    studio["sign-out"].click()
    studio.enter_group("Os Tatus")
    put_move(studio, "2")
    studio["open-activities"].click()
    studio.page.locator("[data-testid=activity-card][data-activity=bread_and_back]").click()
    expect(studio["lesson-mission"]).to_be_visible()
    studio["lesson-mission"].click()
    studio.wait_until_open()
    studio.blocks.type_into(studio.blocks.by_text(MOVE), "3")
    studio.hurry()
    studio.run()
    expect(studio["mission-done"]).to_be_visible(timeout=RUN_MS)
    studio["mission-next"].click()
    expect(studio["mission"]).to_contain_text("Pão e volta")
    studio.wait_for_screen("mission-sheet")
    expect(studio["lesson-mission"]).to_have_count(0)


def test_a_new_group_of_a_lesson_drives_once_in_its_mission(studio: Studio) -> None:
    studio.open_teacher_part("314159")
    name = studio.unique("9º A")
    classroom = studio.send("POST", "/classrooms", {"name": name})["id"]
    lesson = {"title": "", "activity": "square"}
    studio.send("POST", f"/classrooms/{classroom}/lessons", lesson)
    studio.send("POST", "/teacher/leave", {})
    studio.page.reload()
    studio["class-chip"].filter(has_text=name).click()
    studio.enter_group(studio.unique("Os Tatus"), level=None, tour=True)
    expect(studio["mission-sheet"]).to_be_visible()
    expect(studio["tour"]).to_have_count(0)
    studio["mission-start"].click()
    do_step(studio, "hello")
    do_step(studio, "move")
    do_step(studio, "run")
    expect_step(studio, "end")
    expect(studio["tour"]).to_contain_text("o que falta para a missão?")
    studio.wait_for_screen("tour")
    balloon, verdict = box_of(studio["tour"]), box_of(studio["status-line"])
    assert balloon["y"] >= verdict["y"] + verdict["height"]
    studio["mission-fold"].click()
    expect(studio["tour"]).to_have_count(0)
    studio["mission-fold"].click()
    studio["tour-free"].click()
    expect(studio["tour"]).to_have_count(0)
    assert studio.actions() == ["move_forward"]


def test_a_group_chooses_a_mission_solves_it_and_goes_on(studio: Studio) -> None:
    studio.enter_group("Os Tatus")
    studio["open-activities"].click()
    card = studio.page.locator("[data-testid=activity-card][data-activity=pushing]")
    expect(card).to_have_attribute("data-state", "new")
    card.click()
    studio.wait_until_open()
    put_move(studio, "5,6")
    studio.choose_level(2)
    studio["speed"].select_option("10")
    studio.run()
    expect(studio["mission-done"]).to_be_visible(timeout=RUN_MS)
    assert violations(studio, "mission-done") == []
    studio["open-activities"].click()
    expect(card).to_have_attribute("data-state", "passed")
    assert violations(studio, "activity-card") == []
    assert cut(studio, "activity-card") == []


def hints(studio: Studio) -> Locator:
    return studio["mission"].get_by_role("list", name="Dicas").get_by_role("listitem")


def test_hints_are_opened_one_by_one_and_stay_open(studio: Studio) -> None:
    studio.enter_group("Os Tatus")
    group = studio.api("/groups")["groups"][0]["id"]
    studio.send("POST", f"/groups/{group}/activities", {"activity": "square"})
    studio["open-activities"].click()
    studio.page.locator("[data-testid=activity-card][data-activity=square]").click()
    studio.wait_until_open()
    program = studio.program_id
    n_hints = len(studio.api("/activities/square")["hints"])
    for n in range(1, n_hints + 1):
        studio["mission-hint"].click()
        expect(hints(studio)).to_have_count(n)
    expect(studio["mission-hint"]).to_have_count(0)
    assert cut(studio, "mission") == []
    studio.eventually(
        lambda: studio.api(f"/programs/{program}")["version"]["setup"]["n_hints"], n_hints
    )
    studio.page.reload()
    expect(hints(studio)).to_have_count(n_hints)
    studio["mission-fold"].click()
    expect(hints(studio)).to_have_count(0)


def categories(studio: Studio) -> Locator:
    return studio.page.locator("[data-testid^=toolbox-]:not([data-testid=toolbox-search])")


def begin(studio: Studio, activity: str) -> None:
    studio["open-activities"].click()
    studio.page.locator(f"[data-testid=activity-card][data-activity={activity}]").click()
    studio.wait_until_open()


def test_a_mission_offers_its_blocks_until_the_group_chooses_a_level_which_is_kept(
    studio: Studio,
) -> None:
    studio.enter_group("Os Tatus", level=None)
    begin(studio, "to_the_bakery")
    expect(studio["level"]).to_have_value("mission")
    expect(categories(studio)).to_have_text(["Movimento"])
    expect(studio.blocks.in_flyout("andar para trás")).to_be_visible()
    expect(studio.blocks.in_flyout("girar")).to_have_count(0)
    assert violations(studio, "mission") == []
    assert cut(studio, "mission") == []
    studio["toolbox-search"].fill("girar")
    expect(studio.page.locator(".blocklyFlyout:visible")).to_contain_text("em outro nível")
    studio["level"].select_option("1")
    expect(categories(studio)).to_have_count(5)
    studio.page.reload()
    studio.wait_until_open()
    expect(studio["level"]).to_have_value("1")

    begin(studio, "bread_and_back")
    expect(studio["level"]).to_have_value("mission")
    begin(studio, "to_the_bakery")
    expect(studio["level"]).to_have_value("1")
    studio["level"].select_option("mission")
    expect(categories(studio)).to_have_count(1)
