"""The guided first drive: its steps, a usable page meanwhile, and leaving it at any time."""

import itertools

import pytest
from playwright.sync_api import Locator, expect

from pinel_desktop.messages import LANGUAGES
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.blocks import box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_keyboard import Keys
from tests.e2e.test_layout import cut
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

SHOW_AFTER_MS = 20_000


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def begin(studio: Studio) -> str:
    """Creates a group at the first step; returns its name."""
    name = studio.unique("Os Tatus")
    studio.enter_group(name, level=None, tour=True)
    return name


def expect_step(studio: Studio, step: str) -> None:
    expect(studio["tour"]).to_have_attribute("data-step", step, timeout=RUN_MS)


def covers(one: Locator, other: Locator) -> bool:
    a, b = box_of(one), box_of(other)
    return (
        a["x"] < b["x"] + b["width"]
        and b["x"] < a["x"] + a["width"]
        and a["y"] < b["y"] + b["height"]
        and b["y"] < a["y"] + a["height"]
    )


def test_a_new_group_drives_by_doing_each_step(studio: Studio) -> None:
    begin(studio)
    blocks = studio.blocks
    expect_step(studio, "hello")
    expect(studio["tour-go"]).to_be_focused()
    studio["tour-go"].click()
    expect_step(studio, "move")
    expect(studio["tour"]).to_contain_text(
        "Arrastem “andar para frente” para baixo de “quando rodar”."
    )
    expect(studio["tour-ring"]).to_have_count(2)
    assert not covers(studio["tour"], blocks.start())
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    expect_step(studio, "run")
    expect(studio["tour"]).to_contain_text("Apertem Rodar.")
    assert not covers(studio["tour"], studio["run"])
    studio.run()
    expect_step(studio, "watch")
    assert not covers(studio["tour"], studio["scene"])
    expect_step(studio, "turn")
    blocks.drag_from_toolbox("motion", "girar", blocks.below(blocks.by_text("andar para frente")))
    expect_step(studio, "again")
    studio.hurry()
    studio.run()
    expect_step(studio, "end")
    assert not covers(studio["tour"], studio["stop"])
    studio["tour-mission"].click()
    studio.wait_until_open()
    expect(studio["mission"]).to_contain_text("Até a padaria")
    expect(studio["tour"]).to_have_count(0)


def test_another_block_is_fine_and_a_click_will_do(studio: Studio) -> None:
    begin(studio)
    studio["tour-go"].click()
    studio.blocks.click_in_toolbox("motion", "girar")
    expect_step(studio, "run")
    expect(studio["tour"]).to_contain_text("Também serve. Rodem e vejam.")
    studio.run()
    expect_step(studio, "watch")
    expect(studio["tour"]).not_to_contain_text("1 m")


def do_step(studio: Studio, step: str) -> None:
    """Completes a step in the fewest clicks."""
    expect_step(studio, step)
    match step:
        case "hello":
            studio["tour-go"].click()
        case "move":
            studio.blocks.click_in_toolbox("motion", "andar para frente")
        case "turn":
            studio.blocks.click_in_toolbox("motion", "girar")
        case "run" | "again":
            studio.run()


STEPS = ("hello", "move", "run", "watch", "turn", "again", "end")


@pytest.mark.parametrize("last", STEPS)
def test_it_can_be_left_at_every_step_and_does_not_come_back(
    studio: Studio, watch: Watch, last: str
) -> None:
    name = begin(studio)
    n_done = STEPS.index(last)
    if last != "watch":
        studio.hurry()
    for step in STEPS[:n_done]:
        if step != "watch":  # completed by the run
            do_step(studio, step)
    expect_step(studio, last)
    watch.settle(studio.page)  # a step's setting may arrive after the next step's setting
    studio["tour-free" if last == "end" else "tour-skip"].click()
    expect(studio["tour"]).to_have_count(0)
    built = ["move_forward", "turn"][: (n_done > 1) + (n_done > 4)]
    studio.eventually(studio.actions, built)
    watch.settle(studio.page)  # the server has stored that the tour was left
    studio.page.reload()
    studio.wait_until_open()
    studio["home"].click()
    studio["group-card"].filter(has=studio.page.get_by_text(name, exact=True)).click()
    studio.wait_until_open()
    studio["help"].click()  # help has the texts of the tour
    expect(studio["help-tour"]).to_be_visible()
    expect(studio["tour"]).to_have_count(0)


def test_a_page_that_is_loaded_again_in_the_middle_goes_on(studio: Studio, watch: Watch) -> None:
    begin(studio)
    for step, reached in itertools.pairwise(STEPS):
        watch.settle(studio.page)
        do_step(studio, step)
        expect_step(studio, reached)
        if reached == "watch":
            studio.hurry()
            continue  # its run may be over before the page is loaded
        studio.wait_until_saved()
        watch.settle(studio.page)
        studio.page.reload()
        studio.wait_until_open()
    expect_step(studio, "end")
    studio["tour-free"].click()
    studio.eventually(studio.actions, ["move_forward", "turn"])


def test_it_begins_again_from_the_help_in_an_empty_program(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    studio.blocks.click_in_toolbox("motion", "girar")
    studio.eventually(studio.actions, ["turn"])
    before = studio.program_id
    studio["help"].click()
    studio["help-tour"].click()
    expect_step(studio, "hello")
    assert studio.program_id != before
    assert studio.actions() == []
    studio["open-work"].click()
    studio["program-card"].first.click()
    studio.wait_until_open()
    expect(studio["tour"]).to_have_count(0)


def test_it_is_done_by_keyboard(studio: Studio) -> None:
    press = studio.page.keyboard.press
    studio["group-name"].fill(studio.unique("Os Tatus"))
    press("Enter")
    expect(studio["tour-go"]).to_be_focused()
    press("Enter")
    expect(studio["tour"]).to_be_focused()
    expect(studio["tour"].get_by_role("status")).to_contain_text("Arrastem")
    for _ in range(20):
        if studio.page.locator(".blocklyToolbox :focus").count():
            break
        press("Tab")
    keys = Keys(studio)
    keys.press("ArrowDown", "ArrowRight")
    keys.walk_to("andar para frente", "ArrowDown")
    keys.press("Enter")
    expect_step(studio, "run")
    expect(studio["run"]).to_be_enabled()
    studio["run"].focus()
    press("Enter")
    expect_step(studio, "turn")
    studio["tour-skip"].focus()
    press("Escape")
    expect(studio["tour"]).to_have_count(0)


def test_a_group_of_a_lesson_with_an_activity_begins_with_that(open_pc: OpenStudio) -> None:
    studio = open_pc()
    studio.send("PUT", "/teacher/pin", {"pin": "2468"})
    classroom = studio.send("POST", "/classrooms", {"name": "5º A"})["id"]
    lesson = {"title": "Quadrados", "activity": "square"}
    studio.send("POST", f"/classrooms/{classroom}/lessons", lesson)
    studio.page.reload()
    studio["class-chip"].filter(has_text="5º A").click()
    studio["group-name"].fill("Os Tatus")
    studio["create-group"].click()
    studio.wait_until_open()
    expect(studio["mission"]).to_be_visible()
    studio["help"].click()
    expect(studio["help-tour"]).to_be_visible()
    expect(studio["tour"]).to_have_count(0)


def test_in_a_narrow_window_it_covers_neither_the_block_nor_the_program(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(viewport={"width": 1024, "height": 768})
    begin(studio)
    blocks = studio.blocks
    studio["tour-go"].click()
    expect_step(studio, "move")
    expect(studio["tour-ring"]).to_have_count(1)
    assert not covers(studio["tour"], blocks.in_flyout("andar para frente"))
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    studio.hurry()
    do_step(studio, "run")
    expect_step(studio, "turn")
    expect(studio["tour-ring"]).to_have_count(2)  # the category and the program
    assert not covers(studio["tour"], blocks.category("motion"))
    assert not covers(studio["tour"], blocks.by_text("andar para frente"))
    assert cut(studio, "tour") == []


def test_after_a_while_each_step_can_be_shown(studio: Studio) -> None:
    clock = studio.page.clock
    clock.install()
    studio.page.reload()
    begin(studio)
    studio["tour-go"].click()
    expect(studio["tour-show"]).to_have_count(0)
    clock.fast_forward(SHOW_AFTER_MS)
    studio["tour-show"].click()
    expect_step(studio, "run")
    studio.eventually(studio.actions, ["move_forward"])
    clock.fast_forward(SHOW_AFTER_MS)
    studio["tour-show"].click()
    expect_step(studio, "turn")


def test_a_hand_shows_the_drag_unless_motion_is_reduced(open_studio: OpenStudio) -> None:
    moving = open_studio(reduced_motion="no-preference")
    begin(moving)
    moving["tour-go"].click()
    expect(moving.page.locator(".tour__hand")).to_be_visible()
    still = open_studio()
    begin(still)
    still["tour-go"].click()
    expect(still["tour-ring"]).to_have_count(2)
    expect(still.page.locator(".tour__hand")).not_to_be_visible()


def test_it_is_read_in_every_language_and_theme(studio: Studio) -> None:
    begin(studio)
    expect_read(studio)
    studio["tour-go"].click()
    expect(studio["tour-ring"]).to_have_count(2)
    expect_read(studio, is_whole=True)


def expect_read(studio: Studio, *, is_whole: bool = False) -> None:
    """Checks names in every language and contrast in every theme; with `is_whole`, also that no text is cut off."""
    for language in LANGUAGES:
        studio.choose_language(language)
        found = violations(studio, "tour", every_theme=language == LANGUAGES[0])
        assert found == [], language
        if is_whole:
            assert cut(studio, "tour") == [], language
