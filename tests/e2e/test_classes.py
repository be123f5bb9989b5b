"""Classes, groups by their pictures, the first set-up, and the teacher's sign-in."""

import pytest
from playwright.sync_api import Locator, Route, expect

from pinel_desktop.messages import LANGUAGES
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.blocks import box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import Studio
from tests.e2e.test_layout import cut
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

PIN = "314159"
LONG = "Grupo com um nome muito comprido que não cabe em linha alguma"[:60]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


@pytest.fixture
def first_day(open_pc: OpenStudio) -> Studio:
    """The page of a PC with an empty database."""
    return open_pc()


def prepare(studio: Studio, classroom: str = "9º A") -> None:
    """Does the teacher's first set-up."""
    studio["prepare"].click()
    studio["pin"].fill(PIN)
    studio["pin-again"].fill(PIN)
    studio["class-name"].fill(classroom)
    studio["prepare-done"].click()
    expect(studio["new-group-name"]).to_be_visible()


def to_part(studio: Studio, part: str) -> None:
    link = studio.page.locator(f"[data-testid=teacher-part][data-part={part}]")
    link.click()
    expect(link).to_have_attribute("aria-current", "page")


def open_lesson(studio: Studio, title: str, activity: str = "") -> None:
    studio["lesson-title"].wait_for(state="attached")
    if not studio["lesson-title"].is_visible():  # another is open
        studio["open-another"].click()
    studio["lesson-title"].fill(title)
    if activity:
        studio["lesson-activity"].select_option(activity)
    studio["open-lesson"].click()
    expect(studio["lesson-now"]).to_contain_text(title)


def open_class(studio: Studio, part: str = "classes", *, named: str = "9º A") -> str:
    """Opens the teacher's part with a new class of this test selected; returns the class's name."""
    studio.open_teacher_part(PIN)
    name = studio.unique(named)
    made = studio.send("POST", "/classrooms", {"name": name})
    studio.send("PUT", "/settings/page", {"name": "pinel_class", "value": made["id"]})
    studio.page.goto(f"{studio.origin}/#/teacher/{part}")
    studio.page.reload()  # the open page does not know the new class
    expect(studio["class-chip"].and_(studio.page.locator("[aria-pressed=true]"))).to_have_text(name)
    return name


def sign_in(studio: Studio) -> None:
    studio["teacher-link"].click()
    studio["pin"].fill(PIN)
    studio["sign-in"].click()


def test_the_first_day_of_a_teacher(first_day: Studio) -> None:
    studio = first_day
    expect(studio["group-name"]).to_be_visible()
    studio["prepare"].click()
    studio["pin"].fill("31")
    studio["prepare-done"].click()
    expect(studio.page.get_by_role("alert")).to_contain_text("de 4 a 12 algarismos")
    studio["pin"].fill(PIN)
    studio["pin-again"].fill("271828")
    studio["class-name"].fill("9º A")
    studio["prepare-done"].click()
    expect(studio.page.get_by_role("alert")).to_contain_text("não são iguais")
    studio["pin-again"].fill(PIN)
    studio["computer-name"].fill("PC 7")
    studio["prepare-done"].click()
    expect(studio.page.get_by_role("heading", name="9º A")).to_be_visible()
    expect(studio["sign-out"]).to_be_visible()
    assert studio.api("/computer")["name"] == "PC 7"
    assert studio.api("/teacher") == {"has_pin": True, "is_open": True}
    studio["sign-out"].click()
    expect(studio["class-chip"]).to_have_text(["9º A"])
    expect(studio["sign-out"]).to_have_count(0)
    assert studio.api("/teacher")["is_open"] is False


def test_pupils_begin_without_a_teacher(first_day: Studio) -> None:
    studio = first_day
    studio.enter_group("Os Tatus")
    expect(studio["lesson-chip"]).to_have_count(0)
    studio["home"].click()
    expect(studio["group-card"]).to_have_count(1)
    expect(studio["class-chip"]).to_have_count(0)
    expect(studio["teacher-link"]).to_be_visible()


def test_groups_pick_a_picture_and_know_themselves_by_it(studio: Studio) -> None:
    open_class(studio)
    studio["sign-out"].click()
    studio.page.locator("[data-testid=picture][data-name=turtle]").click()
    studio.enter_group("Tartarugas")
    group = studio.api("/groups")["groups"][0]
    assert (group["picture"], group["classroom_id"] is not None) == ("turtle", True)
    studio["home"].click()
    expect(studio["group-card"]).to_have_attribute("data-picture", "turtle")

    studio["choose-picture"].click()
    used = studio.page.locator("[data-testid=picture][data-name=turtle]")
    expect(used.get_by_role("radio")).to_have_accessible_name("tartaruga (outro grupo já tem)")
    studio.page.keyboard.press("ArrowRight")
    studio.page.keyboard.press("Enter")
    expect(used).to_have_count(0)
    expect(studio["choose-picture"]).to_be_focused()
    studio["choose-picture"].click()
    studio.page.locator("[data-testid=picture][data-name=moon]").click()
    expect(used).to_have_count(0)
    studio.enter_group("Luas")
    assert studio.api("/groups")["groups"][0]["picture"] == "moon"


def test_a_group_changes_how_it_looks(studio: Studio) -> None:
    studio.enter_new_group()
    studio["open-work"].click()
    studio["group-edit"].click()
    studio["group-name"].fill("As Capivaras")
    studio.page.locator("[data-testid=picture][data-name=rabbit]").click()
    studio.page.locator("[data-testid=group-color]").nth(3).click()
    studio["group-save"].click()
    expect(studio["header-group"]).to_contain_text("As Capivaras")
    group = studio.api("/groups")["groups"][0]
    assert (group["name"], group["picture"], group["color"]) == (
        "As Capivaras",
        "rabbit",
        "#2e7d4f",
    )


def test_the_door_says_what_is_wrong_and_how_long_to_wait(first_day: Studio, watch: Watch) -> None:
    studio = first_day
    watch.expect("(FORBIDDEN)")
    watch.expect("(TOO MANY REQUESTS)")
    prepare(studio)
    studio["sign-out"].click()
    studio["teacher-link"].click()
    forgotten = studio.page.get_by_text("Esqueceu o PIN?")
    expect(forgotten).not_to_contain_text("comando")
    expect(studio["pin-forgotten"]).to_have_attribute("href", "#/manuals/teacher")
    for _ in range(5):
        studio["pin"].fill("0000")
        studio["sign-in"].click()
        expect(studio.page.get_by_role("alert")).to_contain_text("O PIN não está certo")
        expect(studio["pin"]).to_have_value("")
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    expect(studio["pin-wait"]).to_contain_text("Espere 2")  # 29 seconds, and fewer
    expect(studio["sign-in"]).to_be_disabled()
    expect(studio["teacher-part"]).to_have_count(0)


def test_pupils_see_the_lesson_that_the_teacher_opened(
    studio: Studio, open_studio: OpenStudio
) -> None:
    open_class(studio, "lessons")
    open_lesson(studio, "Quadrados", "square")
    studio["sign-out"].click()
    studio.enter_group("Os Tatus")
    expect(studio["lesson-chip"]).to_contain_text("Quadrados")
    expect(studio["lesson-chip"]).to_contain_text("Um quadrado de 1 m")
    studio["show-goal"].click()
    expect(studio["lesson-goal"]).to_contain_text("Um quadrado de 1 m")
    expect(studio["lesson-goal"].locator("svg .goal__line")).to_be_in_viewport()
    assert violations(studio, "lesson-goal") == []
    studio.page.keyboard.press("Escape")
    expect(studio["lesson-goal"]).to_have_count(0)

    teacher = open_studio()
    sign_in(teacher)
    teacher["close-lesson"].click()
    expect(teacher["lesson-now"]).to_have_count(0)
    studio.page.reload()
    studio.wait_until_open()
    expect(studio["lesson-chip"]).to_have_count(0)


def test_the_teacher_sees_the_goal_of_an_activity_before_opening_it(studio: Studio) -> None:
    open_class(studio, "lessons")
    expect(studio["lesson-goal"]).to_have_count(0)
    studio["lesson-activity"].select_option("b_or_a")
    expect(studio["lesson-goal"].locator(".goal__letter")).to_have_text(["B", "A"])
    assert violations(studio, "lesson-goal") == []


def test_a_lesson_that_is_opened_while_a_group_works_is_shown_before_its_run_is_judged(
    studio: Studio, open_studio: OpenStudio
) -> None:
    open_class(studio)
    studio["sign-out"].click()
    studio.enter_group("Os Tatus", level=None)
    studio.blocks.click_in_flyout("girar")
    expect(studio["lesson-chip"]).to_have_count(0)

    teacher = open_studio()
    sign_in(teacher)
    open_lesson(teacher, "Quadrados", "square")
    studio["run"].click()
    expect(studio["lesson-chip"]).to_contain_text("Um quadrado de 1 m")


def test_lessons_are_joined_and_taken_apart(studio: Studio) -> None:
    open_class(studio, "lessons")
    open_lesson(studio, "Quadrados")
    open_lesson(studio, "Quadrados de novo")
    expect(studio["lesson-row"]).to_have_count(2)
    expect(studio["lesson-join"]).to_be_disabled()
    for place in range(2):
        studio["lesson-pick"].nth(place).check()
    studio["lesson-join"].click()
    expect(studio["lesson-apart"]).to_have_count(1)
    expect(studio["lesson-link"]).to_have_count(1)
    expect(studio["lesson-row"].first).to_contain_text("Quadrados")
    studio["lesson-apart"].click()
    expect(studio["lesson-link"]).to_have_count(2)
    studio["lesson-link"].first.click()
    expect(studio["lesson-page"]).to_be_visible()


def test_an_opened_lesson_leads_to_its_review_and_folds_its_form(studio: Studio) -> None:
    open_class(studio, "lessons")
    open_lesson(studio, "Quadrados")
    expect(studio["lesson-title"]).to_be_hidden()
    review = studio["lesson-now-review"]
    expect(review).to_be_focused()
    expect(studio.page.get_by_text("Ver a aula", exact=True)).to_have_count(1)
    expect(studio.page.locator(".button--run:visible")).to_have_count(1)
    assert violations(studio, "lesson-now") == []
    studio["open-another"].click()
    expect(studio["lesson-title"]).to_be_visible()
    expect(review).to_be_in_viewport(ratio=1)
    review.click()
    expect(studio["lesson-page"]).to_be_visible()


def test_no_control_of_a_lesson_moves_when_the_folders_of_sticks_are_known(studio: Studio) -> None:
    """Else a click can miss: the link to a lesson moved away under the pointer."""
    open_class(studio, "lessons")
    open_lesson(studio, "Quadrados")
    held: list[Route] = []

    def hold(route: Route) -> None:
        held.append(route)

    studio.page.route("**/api/folders", hold)
    to_part(studio, "classes")
    to_part(studio, "lessons")
    studio["lesson-file-save"].wait_for()
    before = studio["lesson-link"].bounding_box()
    with studio.page.expect_response("**/api/folders"):
        for route in held:
            route.continue_()
    studio.page.wait_for_timeout(300)
    assert held
    assert studio["lesson-link"].bounding_box() == before


def test_a_group_is_moved_to_another_class(studio: Studio) -> None:
    old, new = open_class(studio), studio.unique("9º B")
    studio["new-group-name"].fill("Os Tatus")
    studio["make-group"].click()
    expect(studio["class-group"]).to_have_count(1)
    studio["new-class"].fill(new)
    studio["make-class"].click()
    expect(studio.page.get_by_role("heading", name=new)).to_be_visible()
    expect(studio["class-group"]).to_have_count(0)
    chip(studio, old).click()
    studio["move-group"].select_option(label=new)
    expect(studio.page.get_by_text(f"Os Tatus agora está em {new}.")).to_be_visible()
    expect(studio["class-group"]).to_have_count(0)
    chip(studio, new).click()
    studio["group-rename"].click()
    studio["name-field"].fill("As Onças")
    studio.page.keyboard.press("Enter")
    expect(studio["class-group"]).to_contain_text("As Onças")


def chip(studio: Studio, classroom: str) -> Locator:
    return studio["class-chip"].get_by_text(classroom, exact=True)


def test_the_class_last_chosen_on_this_pc_is_shown_again(studio: Studio) -> None:
    chosen = studio["class-chip"].and_(studio.page.locator("[aria-pressed=true]"))
    old, new = open_class(studio), studio.unique("9º B")
    studio["new-class"].fill(new)
    studio["make-class"].click()
    expect(chosen).to_have_text(new)
    studio["sign-out"].click()
    expect(studio["teacher-link"]).to_be_visible()
    expect(chosen).to_have_text(new)
    chip(studio, old).click()
    studio.page.reload()
    expect(chosen).to_have_text(old)


def test_what_was_typed_stays_when_the_door_shuts(studio: Studio, watch: Watch) -> None:
    watch.expect("(FORBIDDEN)")
    open_class(studio)
    new = studio.unique("9º C")
    studio["new-class"].fill(new)
    studio.send("POST", "/teacher/leave", {})  # as after half an hour without use
    studio["make-class"].click()
    expect(studio["pin"]).to_be_visible()
    expect(studio["class-chip"].first).to_be_hidden()
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    expect(studio.page.get_by_role("heading", name=new)).to_be_visible()


def test_what_is_wrong_leaves_the_heading_whole(studio: Studio) -> None:
    open_class(studio, "lessons")
    heading = studio.page.get_by_role("heading", level=2).first
    studio.wait_for_screen("open-lesson")
    before = box_of(heading)
    studio["open-lesson"].click()
    alert = box_of(studio.page.get_by_role("alert"))
    assert box_of(heading) == before
    assert 30 < alert["height"] < 45


def test_it_is_time_to_swap(studio: Studio) -> None:
    open_class(studio)
    to_part(studio, "computer")
    studio.page.locator("[data-setting=pinel_turns][data-value='5']").click()
    studio["sign-out"].click()
    studio.page.clock.install()
    studio.enter_group("Os Tatus")
    expect(studio["turns"]).to_have_count(0)
    studio.page.clock.fast_forward("05:01")
    expect(studio["turns"]).to_contain_text("Hora de trocar!")
    studio["turns-done"].click()
    expect(studio["turns"]).to_have_count(0)


def test_every_part_has_names_and_contrast(first_day: Studio) -> None:
    studio = first_day
    found: dict[str, list[str]] = {}

    def check(screen: str, shows: str) -> None:
        found[screen] = violations(studio, shows)

    studio["prepare"].click()
    check("first day", "pin-again")
    studio.page.go_back()
    prepare(studio)
    studio["new-group-name"].fill("Os Tatus")
    studio["make-group"].click()
    check("classes", "class-group")
    to_part(studio, "computer")
    check("this PC", "computer-name")
    to_part(studio, "lessons")
    open_lesson(studio, "Quadrados", "square")
    check("lessons", "lesson-now")
    studio["sign-out"].click()
    check("groups", "group-card")
    studio["choose-picture"].click()
    check("pictures", "picture")
    studio["teacher-link"].click()
    check("sign-in", "pin")
    assert {screen: one for screen, one in found.items() if one} == {}


def test_twelve_groups_with_long_names_are_not_cut(studio: Studio) -> None:
    name = open_class(studio)
    [classroom] = [one for one in studio.api("/classrooms")["classrooms"] if one["name"] == name]
    for number in range(12):
        group = {"name": f"{number} {LONG}"[:60], "classroom_id": classroom["id"]}
        studio.send("POST", "/groups", group)
    parts = {"lessons": "open-lesson", "computer": "computer-name", "classes": "class-group"}
    for part, shown in parts.items():
        to_part(studio, part)
        expect_uncut(studio, shown)
    expect(studio["class-group"]).to_have_count(12)
    studio["sign-out"].click()
    expect(studio["group-card"]).to_have_count(11)
    expect_uncut(studio, "group-card")


def expect_uncut(studio: Studio, shown: str) -> None:
    """Checks in every language and in windows of two widths that no text is cut off."""
    for language in LANGUAGES:
        studio.choose_language(language)
        for width in (1366, 1024):
            studio.page.set_viewport_size({"width": width, "height": 768})
            assert cut(studio, shown) == [], f"{shown}, {language}, {width} wide"
