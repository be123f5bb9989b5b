"""Overview of a lesson for the teacher: who has passed, who needs help, the commonest mistake, and opened hints."""

from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.past_lesson import SQUARE, PastLesson, Step, school_after
from tests.e2e.review_school import Past, Teacher

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

WALL: list[Step] = [("move_forward", 9)]
SETUP: dict[str, Any] = {"world": "empty_room", "activity": "square"}


def play(lesson: PastLesson) -> Past:
    """Writes two groups that need help, one that is still working, and one that has passed."""
    runs: list[str] = []
    for place, (name, tries) in enumerate(
        (
            ("Quatis", [SQUARE]),
            ("Grupo 10", [WALL, WALL, WALL]),
            ("Araras", [WALL]),
            ("Grupo 2", [WALL, WALL, WALL]),
        )
    ):
        group = lesson.group(name)
        for index, steps in enumerate(tries):
            lesson.at(1 + place / 2 + 4 * index)
            group.edit(*steps, setup=SETUP | {"n_hints": index})
            runs.append(group.run())
            group.judged(runs[-1], passed=steps is SQUARE)
    return Past(lesson.lesson, "", group.id, runs)


@pytest.fixture(scope="module")
def school(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[AppProcess, Past]]:
    """The app on a database with this lesson."""
    with school_after(tmp_path_factory.mktemp("overview"), play) as found:
        yield found


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


def test_groups_that_need_help_come_first_and_no_part_is_a_ranking(teacher: Teacher) -> None:
    teacher.go(f"lesson/{teacher.past.lesson}")
    expect(teacher["review-group"]).to_have_count(4)
    rows = teacher["review-group"]
    teacher.studio.expect_each(rows, "data-need", ["help", "help", "working", "passed"])
    teacher.studio.expect_each(rows, "data-name", ["Grupo 2", "Grupo 10", "Araras", "Quatis"])
    parts = teacher["lesson-page"].locator("section[data-need] > h2")
    expect(parts).to_have_text(["Precisam de ajuda", "Estão trabalhando", "Cumpriram a atividade"])
    sentences = teacher["review-sentence"]
    expect(sentences).to_have_text(
        [
            *["3 batidas seguidas em “andar para frente 9 m”."] * 2,
            "Uma batida em “andar para frente 9 m”.",
            "Cumpriu a atividade na primeira tentativa.",
        ]
    )
    figures = rows.first.get_by_test_id("review-figure")
    expect(figures.first).to_be_hidden()
    rows.first.get_by_test_id("review-open").click()
    expect(figures.first).to_be_visible()
    assert violations(teacher.studio, "review-group") == []


def test_the_summary_leads_to_the_runs_of_a_group_and_to_the_commonest_fault(
    teacher: Teacher,
) -> None:
    teacher.go(f"lesson/{teacher.past.lesson}")
    summary = teacher["lesson-summary"]
    expect(summary).to_contain_text("Cumpriram a atividade: 1 de 4")
    expect(summary).to_contain_text("O que mais fez rodadas pararem (3 grupos)")
    expect(teacher["lesson-stuck"]).to_have_text(["Grupo 2", "Grupo 10"])
    teacher["lesson-stuck"].nth(1).click()
    row = teacher.row("Grupo 10")
    expect(row.get_by_test_id("review-open")).to_be_focused()
    expect(row.get_by_test_id("review-run")).to_have_count(3)
    summary.get_by_role("link", name="Rever").click()
    expect(teacher.page).to_have_url(f"{teacher.studio.origin}/#/run/{teacher.past.runs[-1]}")


def test_the_hints_that_a_group_read_are_shown(teacher: Teacher) -> None:
    teacher.go(f"lesson/{teacher.past.lesson}")
    row = teacher.row("Grupo 2")
    teacher.studio.wait_for_screen(row)  # a group that needs help may be expanded already
    if row.get_by_test_id("review-open").get_attribute("aria-expanded") == "false":
        row.get_by_test_id("review-open").click()
    row.locator("[data-testid=review-figure][data-name=n_hints]").focus()
    expect(teacher.page.get_by_role("tooltip")).to_contain_text("as dicas 1 e 2")
    expect(row.get_by_test_id("review-hints")).to_contain_text("Quantos cantos o quadrado tem?")
    expect(row.get_by_test_id("review-hints").get_by_role("listitem")).to_have_count(2)
    teacher.go(f"compare/{teacher.past.runs[-3]}/{teacher.past.runs[-1]}")
    expect(teacher["compare-hints"]).to_contain_text(
        ["nenhuma dica lida", "as dicas 1 e 2"], use_inner_text=False
    )
