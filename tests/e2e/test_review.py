"""The review of a lesson for the teacher: its page, its print and its table."""

import csv
import io
import re
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, expect

from storage.sqlite import sqlite3
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.blocks import box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.review_school import LONG_NAME, PIN, Past, Teacher, sign_in

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

A4_PX = 794 - 2 * 45  # at 96 dpi, less the margins


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


def test_a_lesson_asks_for_the_pin_first(teacher: Teacher, open_studio: OpenStudio) -> None:
    other = Teacher(open_studio(), teacher.past)
    expect(other["group-card"].first).to_be_visible()
    other.page.context.clear_cookies(name=re.compile("_teacher$"))
    other.go(f"lesson/{teacher.past.lesson}")
    expect(other["pin"]).to_be_visible()
    expect(other["lesson-page"]).to_have_count(0)
    other["pin"].fill(PIN)
    other["sign-in"].click()
    expect(other["review-group"]).to_have_count(2)


def test_each_group_is_a_line_of_what_it_did(teacher: Teacher) -> None:
    teacher.open_lesson()
    teacher.studio.expect_each(teacher["review-group"], "data-name", ["Abelhas", LONG_NAME])
    row = teacher.row(LONG_NAME)
    teacher.studio.wait_for_screen(row)
    assert teacher.marks("Abelhas") == ["edit"]
    assert teacher.marks(LONG_NAME) == ["edit", "failed", "stopped", "edit", "passed"]
    repaired = row.locator("[data-repairs]")
    expect(repaired).to_have_attribute("data-outcome", "passed")
    lefts = [box_of(one)["x"] for one in row.get_by_test_id("review-entry").all()]
    assert lefts == sorted(lefts)
    figures = {
        one.get_attribute("data-name"): one.get_attribute("data-value")
        for one in row.get_by_test_id("review-figure").all()
    }
    assert figures["n_edits"] == "3"
    assert (figures["n_runs"], figures["n_failed"]) == ("3", "1")
    assert figures["time_to_first_run_s"] == "60"
    assert figures["attempts_until_passed"] == "3"


def test_a_number_says_what_it_counts(teacher: Teacher) -> None:
    teacher.open_lesson()
    teacher.row("Abelhas").get_by_test_id("review-open").click()
    figure = teacher.row("Abelhas").locator("[data-testid=review-figure]").first
    figure.focus()
    expect(teacher.page.get_by_role("tooltip")).to_contain_text("Conta cada mudança")
    figure.press("Escape")
    expect(teacher.page.get_by_role("tooltip")).to_have_count(0)


def test_a_mark_says_what_it_is_and_opens_its_replay(teacher: Teacher) -> None:
    teacher.open_lesson()
    marks = teacher.row(LONG_NAME).get_by_test_id("review-entry")
    marks.first.focus()
    marks.first.press("ArrowRight")
    expect(marks.nth(1)).to_be_focused()
    tip = teacher.page.get_by_role("tooltip")
    expect(tip).to_contain_text("Rodada 1")
    expect(tip).to_contain_text("bateu em algo")
    marks.nth(1).press("End")
    expect(tip).to_contain_text("Rodada 3: cumpriu a atividade")
    expect(tip).to_contain_text("trocaram 9 por 1")
    marks.nth(4).press("Enter")
    expect(teacher.page).to_have_url(re.compile(f"#/run/{teacher.past.runs[2]}$"))
    expect(teacher["replay-slider"]).to_be_visible()


def test_edits_open_what_they_changed(teacher: Teacher) -> None:
    teacher.open_lesson()
    edits = teacher.row(LONG_NAME).locator("[data-kind=edit]")
    expect(edits.nth(1)).to_have_attribute("href", re.compile("^#/differences/.+/.+/.+"))
    expect(edits.first).to_have_attribute("href", re.compile("^#/versions/.+/.+"))


def test_a_group_opens_to_its_runs_in_words(teacher: Teacher) -> None:
    teacher.open_lesson()
    row = teacher.row(LONG_NAME)
    row.get_by_test_id("review-open").click()
    runs = row.get_by_test_id("review-run")
    expect(runs).to_have_count(3)
    expect(runs.first).to_contain_text("Rodada 1: parou antes do fim")
    repair = row.get_by_test_id("review-repair")
    expect(repair).to_have_count(1)
    expect(repair).to_contain_text("rodada 2")
    expect(row.get_by_test_id("review-detail")).to_contain_text("andar para frente 4")
    row.get_by_test_id("review-open").click()
    expect(runs).to_have_count(0)


def test_lines_on_the_clock_have_the_time_on_the_wall(teacher: Teacher) -> None:
    teacher.open_lesson()
    row = teacher.row(LONG_NAME)
    first = row.get_by_test_id("review-entry").first
    teacher.studio.wait_for_screen(first)
    own = box_of(first)["x"]
    teacher.page.locator("[data-testid=lesson-time][data-value=clock]").click()
    # the other group started three minutes before
    teacher.studio.eventually(lambda: box_of(first)["x"] > own + 20, True)
    expect(row.locator(".line__tick text").first).to_have_text(re.compile(r"^\d\d:\d\d$"))


def test_a_lesson_without_work_says_so(teacher: Teacher) -> None:
    teacher.go(f"lesson/{teacher.past.empty}")
    expect(teacher["lesson-empty"]).to_be_visible()


def test_the_table_is_saved(teacher: Teacher) -> None:
    teacher.open_lesson()
    with teacher.page.expect_download() as download:
        teacher["lesson-table"].click()
    assert download.value.suggested_filename == "quadrados-e-desvios.csv"
    text = Path(download.value.path()).read_text("utf-8-sig")
    header, *rows = csv.reader(io.StringIO(text), delimiter=";")
    assert header[0] == "Grupo"
    assert [row[0] for row in rows] == ["Abelhas", *[LONG_NAME] * 5]


def test_the_report_on_paper_has_no_buttons_and_says_what_it_counts(teacher: Teacher) -> None:
    teacher.open_lesson()
    page = teacher.page
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    for hidden in ("lesson-print", "lesson-table", "lesson-time", "home"):
        expect(teacher[hidden].first).to_be_hidden()
    expect(teacher["lesson-summary"].get_by_role("link")).to_have_count(0)
    expect(teacher["lesson-explained"]).to_contain_text("Impresso em")
    assert _not_whole(teacher.row(LONG_NAME)) == []
    assert box_of(teacher.row(LONG_NAME).locator(".line"))["width"] < A4_PX
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    page.set_viewport_size({"width": A4_PX, "height": 1000})
    assert page.evaluate("document.documentElement.scrollWidth") <= A4_PX, "no number is cut"
    # without its colour, the number of a chip says nothing
    words = page.locator(".chip--small > .visually-hidden").first
    expect(words).to_have_text(re.compile("blocos? em uso"))
    assert box_of(words)["width"] > 40
    pages = re.findall(rb"/Type\s*/Page\b", page.pdf(prefer_css_page_size=True))
    assert len(pages) == 1
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    page.emulate_media(media="screen")
    expect(teacher["lesson-print"]).to_be_visible()


def test_many_pages_of_paper_hold_whole_groups(teacher: Teacher) -> None:
    teacher.open_lesson()
    inside: Any = teacher.page.evaluate(
        """() => [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules])
            .filter((rule) => rule.media?.mediaText === 'print')
            .flatMap((rule) => [...rule.cssRules])
            .filter((rule) => rule.selectorText === '.group-row')
            .map((rule) => rule.style.breakInside)"""
    )
    assert "avoid" in inside


def test_screens_of_the_review_have_names_and_contrast(teacher: Teacher) -> None:
    found: dict[str, list[str]] = {}
    teacher.open_lesson()
    teacher["review-open"].nth(1).click()
    expect(teacher["review-run"].first).to_be_visible()
    teacher["review-entry"].nth(2).focus()
    found["lesson"] = violations(teacher.studio, "review-run")
    teacher.go("runs")
    teacher["compare-choose"].nth(0).check()
    teacher["compare-choose"].nth(1).check()
    found["runs"] = violations(teacher.studio, "compare-open")
    teacher["compare-open"].click()
    expect(teacher["compare-side"]).to_have_count(2)
    found["side by side"] = violations(teacher.studio, "compare-side")
    teacher.go(f"run/{teacher.past.runs[1]}")
    teacher["note-open"].click()
    found["note"] = violations(teacher.studio, "note-text")
    assert {screen: one for screen, one in found.items() if one} == {}


def test_from_a_mark_the_teacher_goes_back_to_the_lesson_as_it_was(teacher: Teacher) -> None:
    teacher.open_lesson()
    teacher.page.locator("[data-testid=lesson-time][data-value=clock]").click()
    row = teacher.row(LONG_NAME)
    row.get_by_test_id("review-open").click()
    teacher.studio.wait_for_screen("review-run")
    teacher["review-run"].first.scroll_into_view_if_needed()
    left_at = _scrolled(teacher)
    teacher["review-run"].first.get_by_role("link", name="Rever").click()
    expect(teacher["replay-slider"]).to_be_visible()
    teacher["back-to-review"].click()
    expect(teacher["review-detail"]).to_be_visible()
    clock = teacher.page.locator("[data-testid=lesson-time][data-value=clock]")
    expect(clock).to_have_attribute("aria-pressed", "true")
    teacher.studio.eventually(lambda: _scrolled(teacher), left_at)

    teacher["review-run"].last.get_by_role("link").first.click()
    expect(teacher["compare-page"]).to_be_visible()
    teacher.page.get_by_role("link", name="Voltar à aula").click()
    mark = row.locator("[data-kind=edit]").last
    mark.focus()
    mark.press("Enter")
    expect(teacher["difference-count"]).to_be_visible()
    teacher.page.get_by_role("link", name="Histórico").click()
    expect(teacher["version-shown"]).to_be_visible()
    expect(teacher["version-back"]).to_have_count(0)
    teacher["back-to-review"].click()
    expect(teacher["lesson-page"]).to_be_visible()


def _scrolled(teacher: Teacher) -> float:
    return float(teacher["lesson-page"].evaluate("one => one.scrollTop"))


def _not_whole(row: Locator) -> list[str]:
    """Returns texts of a row that are cut off, and so could not be read on paper."""
    expect(row).to_be_visible()
    parts = row.locator(".group-row__who :is(.group-row__name > span, .chips)").all()
    cut = "e => e.scrollWidth > e.clientWidth + 1 || e.scrollHeight > e.clientHeight + 1"
    return [part.inner_text() for part in parts if part.evaluate(cut)]


def test_a_run_that_cannot_be_repeated_counts_once_the_teacher_accepts_it(
    app: AppProcess, school: tuple[AppProcess, Past], open_studio: OpenStudio
) -> None:
    passed = school[1].runs[-1]
    app.stop()
    with closing(sqlite3.connect(app.database)) as db, db:
        db.execute(f"INSERT INTO unconfirmed_runs VALUES ('{passed}', NULL, '', 'not_repeatable')")
    app.start()
    studio = open_studio()
    sign_in(studio)
    teacher = Teacher(studio, school[1])
    teacher.open_lesson()
    teacher.row(LONG_NAME).get_by_test_id("review-open").click()
    run = teacher.row(LONG_NAME).get_by_test_id("review-run").last
    expect(run).to_have_attribute("data-outcome", "finished")
    expect(teacher["lesson-summary"]).to_contain_text("1 rodada não pode ser repetida aqui")
    teacher["accept-run"].click()
    expect(run).to_have_attribute("data-outcome", "passed")
    expect(teacher["accept-run"]).to_have_count(0)
    expect(teacher["lesson-summary"]).to_contain_text("1 de 2")
