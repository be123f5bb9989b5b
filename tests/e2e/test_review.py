"""What the teacher sees after class: the lesson, its runs, two of them side by side, notes, paper and table."""

import csv
import io
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.past_lesson import SQUARE, PastLesson, past_lesson
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

PIN = "314159"
LONG_NAME = "Tatus da Silva Xavier e o Robô Que Não Parava na Parede"
A4_PX = 794 - 2 * 45  # at 96 dpi, less the margins


class Past(NamedTuple):
    """What is in the file; groups by name, runs in the order of the line."""

    lesson: str
    empty: str
    group: str
    runs: list[str]


def _play(lesson: PastLesson) -> Past:
    """Two groups: one tries, fails, stops and repairs, the other only builds."""
    lesson.at(2)
    bees = lesson.group("Abelhas")
    bees.edit(("turn", 90))
    lesson.at(5)
    tatus = lesson.group(LONG_NAME)
    tatus.edit(("move_forward", 1))
    lesson.at(5.5)
    tatus.edit(("move_forward", 9), ("turn", 90))
    lesson.at(6)
    crashed = tatus.run()
    tatus.judged(crashed, passed=False)
    lesson.at(7)
    stopped = tatus.run(stop_at_s=1.0)
    tatus.judged(stopped, passed=False)
    lesson.at(20)
    tatus.edit(*SQUARE)
    lesson.at(21)
    passed = tatus.run()
    tatus.judged(passed, passed=True)
    lesson.at(22)
    store = lesson.store
    empty = store.lessons.open(store.classrooms.create("8º A").id, "Vazia").id
    return Past(lesson.lesson, empty, tatus.id, [crashed, stopped, passed])


class Teacher:
    """The teacher's page, its door open."""

    def __init__(self, studio: Studio, past: Past) -> None:
        self.studio, self.page, self.past = studio, studio.page, past

    def __getitem__(self, test_id: str) -> Locator:
        return self.studio[test_id]

    def go(self, place: str) -> None:
        self.page.goto(f"{self.page.url.split('#')[0]}#/{place}")

    def open_lesson(self) -> None:
        self.go(f"lesson/{self.past.lesson}")
        expect(self["review-group"]).to_have_count(2)

    def row(self, name: str) -> Locator:
        return self.page.locator(f"[data-testid=review-group][data-name='{name}']")

    def marks(self, name: str) -> list[str]:
        marks = self.row(name).get_by_test_id("review-mark").all()
        return [
            one.get_attribute("data-outcome") or one.get_attribute("data-kind") or ""
            for one in marks
        ]

    def filter(self, name: str) -> Locator:
        return self.page.locator(f"[data-testid=history-filter][data-name={name}]")


@pytest.fixture(scope="module")
def school(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[AppProcess, Past]]:
    """The app on a file with a lesson that is over."""
    home = tmp_path_factory.mktemp("school")
    with past_lesson(home) as lesson:
        past = _play(lesson)
    app = AppProcess(home)
    app.start()
    yield app, past
    app.stop()


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


@pytest.fixture
def teacher(open_studio: OpenStudio, school: tuple[AppProcess, Past]) -> Teacher:
    studio = open_studio()
    expect(studio["group-card"].first).to_be_visible()
    _call(studio, "PUT" if not studio.api("/teacher")["has_pin"] else "POST")
    return Teacher(studio, school[1])


def _call(studio: Studio, method: str) -> None:
    """Chooses the PIN, or gives it."""
    place = "/api/teacher/pin" if method == "PUT" else "/api/teacher/enter"
    studio.page.evaluate(
        """async ([method, place, body]) => {
            const headers = {"Content-Type": "application/json"};
            await fetch(place, {method, headers, body});
        }""",
        [method, place, json.dumps({"pin": PIN})],
    )


def test_a_lesson_asks_for_the_pin_first(teacher: Teacher, open_studio: OpenStudio) -> None:
    other = Teacher(open_studio(), teacher.past)
    expect(other["group-card"].first).to_be_visible()
    other.page.context.clear_cookies(name=re.compile("_teacher$"))
    other.go(f"lesson/{teacher.past.lesson}")
    expect(other["pin"]).to_be_visible()
    expect(other["lesson-page"]).to_have_count(0)
    other["pin"].fill(PIN)
    other["enter-door"].click()
    expect(other["review-group"]).to_have_count(2)


def test_each_group_is_a_line_of_what_it_did(teacher: Teacher) -> None:
    teacher.open_lesson()
    names = [row.get_attribute("data-name") for row in teacher["review-group"].all()]
    assert names == ["Abelhas", LONG_NAME]
    assert teacher.marks("Abelhas") == ["edit"]
    assert teacher.marks(LONG_NAME) == ["edit", "failed", "stopped", "edit", "passed"]
    row = teacher.row(LONG_NAME)
    repaired = row.locator("[data-repairs]")
    expect(repaired).to_have_attribute("data-outcome", "passed")
    places = [one.bounding_box() for one in row.get_by_test_id("review-mark").all()]
    lefts = [place["x"] for place in places if place]
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
    figure = teacher.row("Abelhas").locator("[data-testid=review-figure]").first
    figure.focus()
    expect(teacher.page.get_by_role("tooltip")).to_contain_text("Conta cada mudança")
    figure.press("Escape")
    expect(teacher.page.get_by_role("tooltip")).to_have_count(0)


def test_a_mark_says_what_it_is_and_opens_its_replay(teacher: Teacher) -> None:
    teacher.open_lesson()
    marks = teacher.row(LONG_NAME).get_by_test_id("review-mark")
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
    expect(runs.first).to_contain_text("Rodada 1: um erro interrompeu")
    repair = row.get_by_test_id("review-repair")
    expect(repair).to_have_count(1)
    expect(repair).to_contain_text("rodada 2")
    expect(row.get_by_test_id("review-detail")).to_contain_text("andar para frente 4")
    row.get_by_test_id("review-open").click()
    expect(runs).to_have_count(0)


def test_lines_on_the_clock_have_the_time_on_the_wall(teacher: Teacher) -> None:
    teacher.open_lesson()
    row = teacher.row(LONG_NAME)
    first = row.get_by_test_id("review-mark").first
    own = first.bounding_box()
    teacher.page.locator("[data-testid=lesson-time][data-value=clock]").click()
    common = first.bounding_box()
    assert own is not None
    assert common is not None
    assert common["x"] > own["x"] + 20  # the other group began three minutes before
    expect(row.locator(".line__tick text").first).to_have_text(re.compile(r"^\d\d:\d\d$"))


def test_a_lesson_without_work_says_so(teacher: Teacher) -> None:
    teacher.go(f"lesson/{teacher.past.empty}")
    expect(teacher["lesson-empty"]).to_be_visible()


def test_a_note_is_written_at_the_replay_and_reaches_the_group(teacher: Teacher) -> None:
    teacher.open_lesson()
    run = teacher.past.runs[0]
    teacher.go(f"run/{run}")
    teacher["note-open"].click()
    teacher["note-text"].fill("Quanto falta até a parede?")
    expect(teacher["note"]).to_have_attribute("data-state", "changed")
    teacher["note-save"].click()
    expect(teacher["note"]).to_have_attribute("data-state", "saved")
    notes = teacher.studio.api(f"/groups/{teacher.past.group}/notes?unseen=true")["notes"]
    assert [(note["run_id"], note["text"]) for note in notes] == [
        (run, "Quanto falta até a parede?")
    ]
    teacher["note-text"].fill("Meçam até a parede.")
    teacher["note-save"].click()
    expect(teacher["note"]).to_have_attribute("data-state", "saved")
    notes = teacher.studio.api(f"/groups/{teacher.past.group}/notes")["notes"]
    assert [note["text"] for note in notes] == ["Meçam até a parede."]


def test_pupils_cannot_write_notes(teacher: Teacher) -> None:
    teacher.page.context.clear_cookies(name=re.compile("_teacher$"))
    teacher.go(f"run/{teacher.past.runs[0]}")
    expect(teacher["replay-slider"]).to_be_visible()
    expect(teacher["note-open"]).to_have_count(0)
    expect(teacher["note-text"]).to_have_count(0)


def test_runs_are_chosen_by_what_they_were(teacher: Teacher) -> None:
    teacher.go("runs")
    runs = teacher["history-run"]
    expect(runs).to_have_count(3)
    teacher.filter("outcome").select_option("failed")
    expect(runs).to_have_count(1)
    expect(runs).to_have_attribute("data-outcome", "failed")
    teacher.filter("outcome").select_option("")
    teacher.filter("group").select_option(label="Abelhas")
    expect(teacher["history-empty"]).to_be_visible()
    teacher.filter("group").select_option("")
    teacher.filter("day").fill("2026-11-18")
    expect(teacher["history-empty"]).to_be_visible()
    teacher.page.get_by_role("button", name="Limpar filtros").click()
    expect(runs).to_have_count(3)
    teacher.filter("activity").select_option("square")
    expect(runs).to_have_count(3)
    teacher.filter("activity").select_option("maze")
    expect(teacher["history-empty"]).to_be_visible()
    teacher.page.get_by_role("button", name="Limpar filtros").click()


def test_two_runs_are_seen_side_by_side_on_one_clock(teacher: Teacher) -> None:
    teacher.go("runs")
    choose = teacher["compare-choose"]
    choose.nth(0).check()
    expect(teacher["compare-open"]).to_have_count(0)
    choose.nth(1).check()
    seen_at = teacher["review-refresh"].get_attribute("data-at") or ""
    teacher["review-refresh"].click()
    expect(teacher["review-refresh"]).not_to_have_attribute("data-at", seen_at)
    expect(choose.nth(1)).to_be_checked()
    teacher["compare-open"].click()
    sides = teacher["compare-side"]
    expect(sides).to_have_count(2)
    slider = teacher["replay-slider"]
    passed_ticks = int(slider.get_attribute("max") or 0)
    assert passed_ticks > 300  # a square takes longer than what was stopped after a second
    slider.fill("20")
    expect(sides.nth(0)).to_have_attribute("data-tick", "20")
    expect(sides.nth(1)).to_have_attribute("data-tick", "20")
    slider.fill("300")
    ticks = {int(side.get_attribute("data-tick") or 0) for side in sides.all()}
    assert ticks == {30, 300}
    expect(teacher.page.locator("[data-testid=compare-side][data-phase=stopped]")).to_have_count(1)
    teacher["replay-speed"].select_option("16")
    teacher["replay-play"].click()
    expect(teacher.page.locator("[data-phase=finished][data-testid=compare-side]")).to_have_count(1)
    teacher.page.locator("[data-testid=compare-view][data-value=together]").click()
    expect(teacher["scene"]).to_have_count(1)


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
    for gone in ("lesson-print", "lesson-table", "lesson-time", "home"):
        expect(teacher[gone].first).to_be_hidden()
    expect(teacher["lesson-explained"]).to_contain_text("Impresso em")
    assert _not_whole(teacher.row(LONG_NAME)) == []
    line = teacher.row(LONG_NAME).locator(".line").bounding_box()
    assert line is not None
    assert line["width"] < A4_PX
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
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
    teacher["review-mark"].nth(2).focus()
    found["lesson"] = violations(teacher.studio)
    teacher.go("runs")
    teacher["compare-choose"].nth(0).check()
    teacher["compare-choose"].nth(1).check()
    found["runs"] = violations(teacher.studio)
    teacher["compare-open"].click()
    expect(teacher["compare-side"]).to_have_count(2)
    found["side by side"] = violations(teacher.studio)
    teacher.go(f"run/{teacher.past.runs[1]}")
    teacher["note-open"].click()
    found["note"] = violations(teacher.studio)
    assert {screen: one for screen, one in found.items() if one} == {}


def test_a_note_that_was_not_left_is_there_still_and_says_so(teacher: Teacher) -> None:
    teacher.open_lesson()
    run = teacher.past.runs[1]
    teacher.go(f"run/{run}")
    teacher["note-open"].click()
    teacher["note-text"].fill("Por que pararam?")
    expect(teacher["note"]).to_contain_text("Ainda não entregue")
    teacher["back-to-review"].click()
    expect(teacher["lesson-page"]).to_be_visible()
    teacher.go(f"run/{run}")
    expect(teacher["note-text"]).to_have_value("Por que pararam?")
    expect(teacher["note"]).to_have_attribute("data-state", "changed")
    teacher.page.get_by_role("button", name="Fechar", exact=True).click()
    expect(teacher["note-open"]).to_contain_text("ainda não entregue")
    teacher["note-open"].click()
    teacher["note-text"].fill("")
    teacher.page.reload()
    expect(teacher["note-open"]).not_to_contain_text("ainda não entregue")


def test_a_note_waits_for_the_pin_when_the_door_has_shut(teacher: Teacher, watch: Watch) -> None:
    watch.expect("(FORBIDDEN)")
    teacher.open_lesson()
    run = teacher.past.runs[1]
    teacher.go(f"run/{run}")
    teacher["note-open"].click()
    teacher["note-text"].fill("O que aconteceu aqui?")
    teacher.page.evaluate("() => fetch('/api/teacher/leave', {method: 'POST'})")
    teacher["note-save"].click()
    expect(teacher["pin"]).to_be_focused()
    expect(teacher["note-text"]).to_be_hidden()
    teacher["pin"].fill(PIN)
    teacher["enter-door"].click()
    expect(teacher["note-text"]).to_have_value("O que aconteceu aqui?")
    expect(teacher["note"]).to_have_attribute("data-state", "saved")
    assert [note["text"] for note in _notes(teacher, run)] == ["O que aconteceu aqui?"]


def test_a_note_is_taken_back_by_two_presses(teacher: Teacher) -> None:
    teacher.open_lesson()
    run = teacher.past.runs[2]
    teacher.go(f"run/{run}")
    teacher["note-open"].click()
    teacher["note-text"].fill("Muito bem!")
    teacher["note-save"].click()
    expect(teacher["note"]).to_have_attribute("data-state", "saved")
    teacher["note-delete"].click()
    expect(teacher.page.get_by_role("button", name="Não apagar")).to_be_focused()
    assert len(_notes(teacher, run)) == 1
    teacher["note-delete-sure"].click()
    expect(teacher["note"]).to_contain_text("O recado foi apagado.")
    expect(teacher["note-text"]).to_have_value("")
    expect(teacher["note-text"]).to_be_focused()
    assert _notes(teacher, run) == []


def test_a_replay_outlines_the_block_that_failed_and_speaks_of_no_button_that_is_not_there(
    teacher: Teacher,
) -> None:
    crashed, stopped, _ = teacher.past.runs
    outlined = teacher.page.locator(".pinelFaultRing")
    teacher.go(f"run/{crashed}")
    expect(teacher["replay-slider"]).to_be_visible()
    expect(outlined).to_have_count(0)
    teacher["replay-slider"].press("End")
    expect(outlined).to_have_count(1)
    expect(teacher.page.locator(".status__more").first).to_contain_text("mudem a distância")
    teacher["replay-slider"].press("Home")
    expect(outlined).to_have_count(0)

    teacher.go(f"compare/{crashed}/{stopped}")
    teacher["replay-slider"].press("End")
    expect(outlined).to_have_count(1)
    stop = teacher["compare-side"].last
    expect(stop).to_contain_text("O grupo parou o robô.")
    expect(stop).not_to_contain_text("Rodar")


def test_from_a_mark_the_teacher_goes_back_to_the_lesson_as_it_was(teacher: Teacher) -> None:
    teacher.open_lesson()
    teacher.page.locator("[data-testid=lesson-time][data-value=clock]").click()
    row = teacher.row(LONG_NAME)
    row.get_by_test_id("review-open").click()
    teacher["review-run"].first.scroll_into_view_if_needed()
    teacher.page.wait_for_timeout(200)
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


def test_from_a_run_of_the_list_the_teacher_goes_back_to_it_but_no_pupil_does(
    teacher: Teacher,
) -> None:
    teacher.go("runs")
    teacher.filter("outcome").select_option("failed")
    expect(teacher["history-run"]).to_have_count(1)
    teacher["history-run"].get_by_role("link").click()
    expect(teacher["back-to-review"]).to_contain_text("Voltar às rodadas")
    teacher["back-to-review"].click()
    expect(teacher.filter("outcome")).to_have_value("failed")
    teacher.filter("outcome").select_option("")

    teacher.go("")
    teacher["group-card"].filter(has_text="Abelhas").click()
    teacher.studio.wait_until_open()
    teacher.go(f"run/{teacher.past.runs[0]}")
    expect(teacher["replay-slider"]).to_be_visible()
    expect(teacher["back-to-review"]).to_have_count(0)


def _notes(teacher: Teacher, run: str) -> list[dict[str, Any]]:
    notes: list[dict[str, Any]] = teacher.studio.api(f"/runs/{run}/notes")["notes"]
    return notes


def _scrolled(teacher: Teacher) -> float:
    return float(teacher["lesson-page"].evaluate("one => one.scrollTop"))


def _not_whole(row: Locator) -> list[str]:
    """What paper would have to be pulled wider or pointed at for."""
    parts = row.locator(".group-row__who :is(.group-row__name > span, .chips)").all()
    cut = "e => e.scrollWidth > e.clientWidth + 1 || e.scrollHeight > e.clientHeight + 1"
    return [part.inner_text() for part in parts if part.evaluate(cut)]
