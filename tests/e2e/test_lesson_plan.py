"""The plan of a lesson: opens its activities for a class, is printed and saved, and has cards to cut out."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.past_lesson import PastLesson, school_after
from tests.e2e.review_school import Past, Teacher
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]


def play(lesson: PastLesson) -> Past:
    """Writes a class with a group, whose lesson is over."""
    group = lesson.group("Araras")
    group.edit(("move_forward", 1))
    lesson.store.lessons.close(lesson.lesson)
    return Past(lesson.lesson, "", group.id, [])


@pytest.fixture(scope="module")
def school(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[AppProcess, Past]]:
    """The app on a database with this class."""
    with school_after(tmp_path_factory.mktemp("plan"), play) as found:
        yield found


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


def activity_of_class(studio: Studio) -> list[str | None]:
    (classroom,) = studio.api("/classrooms")["classrooms"]
    lesson = studio.api(f"/classrooms/{classroom['id']}/lesson")["lesson"]
    return [lesson["title"], lesson["activity"]]


def test_the_plan_opens_its_activities_for_the_class_in_one_lesson(teacher: Teacher) -> None:
    teacher.go("teacher/plan")
    expect(teacher["plan-step"]).to_have_count(8)
    assert violations(teacher.studio, "plan-step") == []
    assert _on_paper(teacher, "dark") == ["rgb(255, 255, 255)", "rgb(0, 0, 0)"]
    opens = teacher["plan-open"]
    expect(opens).to_have_text(
        [
            "Abrir 1.3 Virar a esquina para a turma",
            "Abrir 2.6 A letra do grupo para a turma",
            "Abrir 3.1 Só com o B para a turma",
        ]
    )
    opens.first.click()
    expect(opens.first).to_have_attribute("aria-pressed", "true")
    assert activity_of_class(teacher.studio) == ["Aula de duas horas", "around_the_corner"]
    opens.nth(1).focus()
    opens.nth(1).press("Enter")
    expect(opens.nth(1)).to_have_attribute("aria-pressed", "true")
    expect(opens.first).to_have_attribute("aria-pressed", "false")
    assert activity_of_class(teacher.studio) == ["Aula de duas horas", "letter"]


def _on_paper(teacher: Teacher, theme: str) -> list[str]:
    """The colours of paper and ink while the page has a theme."""
    teacher["theme"].click()
    expect(teacher.page.locator("html")).to_have_attribute("data-theme", theme)
    teacher.page.emulate_media(media="print")
    colours: list[str] = teacher.page.evaluate(
        "[getComputedStyle(document.body).backgroundColor, getComputedStyle(document.body).color]"
    )
    teacher.page.emulate_media(media="screen")
    return colours


def test_cards_are_real_blocks_with_blanks_and_fit_on_paper(teacher: Teacher) -> None:
    teacher.go("teacher/plan")
    teacher["plan-cards"].click()
    cards = teacher["card"]
    expect(cards).to_have_count(36)
    assert violations(teacher.studio, "card") == []
    turn = teacher.page.locator("[data-testid=card][data-name='turn RIGHT']").first
    expect(turn).to_contain_text("direita")
    expect(turn).not_to_contain_text("90")
    branch = teacher.page.locator("[data-testid=card][data-name=if]").first
    expect(branch.locator("image:visible")).to_have_count(1)  # its icon, and no plus to press
    teacher["cards-copies"].select_option("1")
    teacher["cards-list"].select_option("letters")
    expect(cards).to_have_count(6)
    teacher["cards-list"].select_option("level3")
    expect(teacher.page.locator("[data-testid=card][data-name=function_def]")).to_have_count(1)
    teacher.page.emulate_media(media="print")
    expect(teacher["header"].or_(teacher["cards-print"]).first).not_to_be_visible()
    widest = cards.evaluate_all("all => Math.max(...all.map((one) => one.offsetWidth))")
    assert widest <= 210 / 25.4 * 96 - 2 * 45  # A4 without margins
    teacher.page.emulate_media(media="screen")


@pytest.mark.parametrize(("place", "save", "shown_text"), [
    ("teacher/plan", "plan-save", "Com alunos surdos"),
    ("cards", "cards-save", "andar para frente"),
])  # fmt: skip
def test_a_saved_page_opens_without_the_app(
    teacher: Teacher, browser: Browser, tmp_path: Path, place: str, save: str, shown_text: str
) -> None:
    teacher.go(place)
    expect(teacher.page.get_by_text(shown_text).first).to_be_visible()
    with teacher.page.expect_download() as download:
        teacher[save].click()
    file = tmp_path / download.value.suggested_filename
    download.value.save_as(file)
    assert file.suffix == ".html"
    alone = browser.new_page(offline=True)
    asked: list[str] = []
    alone.on("request", lambda request: asked.append(request.url))
    alone.goto(file.as_uri())
    expect(alone.get_by_text(shown_text).first).to_be_visible()
    expect(alone.get_by_role("button")).to_have_count(0)
    assert [url for url in asked if not url.startswith(("file:", "data:"))] == []
    alone.close()
