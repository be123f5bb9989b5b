"""Runs for the teacher: the list, a replay, two runs side by side, and notes about them."""

import re
import time
from typing import Any

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.blocks import box_of
from tests.e2e.past_lesson import Step, document_of, workspace_of
from tests.e2e.review_school import PIN, Past, Teacher
from tests.e2e.test_layout import cut
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

# window, and least room of the floor of one of two runs
SCREENS_AND_FLOORS = (
    ((1366, 768), (370, 340)),
    ((1024, 768), (460, 240)),
    ((683, 768), (290, 190)),
)


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


def test_a_note_is_written_at_the_replay_and_reaches_the_group(teacher: Teacher) -> None:
    run = _begin_note(teacher, 0, "Quanto falta até a parede?")
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
    day = teacher.filter("day")
    day.fill("31/02/2026")
    day.press("Enter")
    expect(teacher.page.get_by_role("alert")).to_have_text("Escreva o dia assim: 18/11/2026.")
    expect(runs).to_have_count(3)
    day.fill("18/11/26")
    day.press("Enter")
    expect(teacher["history-empty"]).to_be_visible()
    expect(day).to_have_value("18/11/2026")
    expect(teacher.page.get_by_role("alert")).to_have_count(0)
    teacher.page.get_by_role("button", name="Limpar filtros").click()
    expect(runs).to_have_count(3)
    expect(teacher["history-place"].first).to_have_text("Sala vazia · Quadrados e desvios")
    teacher.filter("lesson").select_option(teacher.past.lesson)
    teacher.filter("world").select_option("empty_room")
    expect(runs).to_have_count(3)
    teacher.filter("world").select_option("maze")
    expect(teacher["history-empty"]).to_be_visible()
    teacher.filter("world").select_option("")
    teacher.filter("lesson").select_option(teacher.past.empty)
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
    teacher.studio.wait_for_screen("compare-open")
    refreshed_at = teacher["review-refresh"].get_attribute("data-at") or ""
    teacher["review-refresh"].click()
    expect(teacher["review-refresh"]).not_to_have_attribute("data-at", refreshed_at)
    expect(choose.nth(1)).to_be_checked()
    teacher["compare-open"].click()
    sides = teacher["compare-side"]
    expect(sides).to_have_count(2)
    # both paths are in one world: on one floor, which is larger than two
    expect(teacher["scene"]).to_have_count(1)
    slider = teacher["replay-slider"]
    # a square takes longer than the run that was stopped after a second
    teacher.studio.eventually(lambda: int(slider.get_attribute("max") or 0) > 300, True)
    slider.fill("20")
    expect(sides.nth(0)).to_have_attribute("data-tick", "20")
    expect(sides.nth(1)).to_have_attribute("data-tick", "20")
    slider.fill("300")
    teacher.studio.eventually(
        lambda: {int(side.get_attribute("data-tick") or 0) for side in sides.all()}, {30, 300}
    )
    expect(teacher.page.locator("[data-testid=compare-side][data-phase=stopped]")).to_have_count(1)
    teacher["replay-speed"].select_option("16")
    teacher["replay-play"].click()
    expect(teacher.page.locator("[data-phase=finished][data-testid=compare-side]")).to_have_count(1)
    teacher.page.locator("[data-testid=compare-view][data-value=apart]").click()
    expect(teacher["scene"]).to_have_count(2)
    for (width, height), least in SCREENS_AND_FLOORS:
        teacher.page.set_viewport_size({"width": width, "height": height})
        teacher.studio.wait_for_screen("compare-page")
        floor = box_of(teacher["scene"].first)
        assert (floor["width"] > least[0], floor["height"] > least[1]) == (True, True), floor


def test_blocks_that_differ_are_marked_on_both_sides_and_read_in_words(teacher: Teacher) -> None:
    crashed, stopped, passed = teacher.past.runs
    teacher.go(f"compare/{crashed}/{passed}")
    first, second = _sides(teacher)
    expect(first.locator(".pinelSign")).to_have_count(1)
    expect(second.locator(".pinelSign")).to_have_count(7)
    difference = teacher["difference"]
    expect(difference).to_have_attribute("data-kind", "changed")
    expect(difference).to_contain_text("andar para frente 9 m → andar para frente 1 m")
    expect(difference).to_contain_text("1 de 7")
    for side in (first, second):
        expect(side.locator(".pinelRunning")).to_have_count(1)
    teacher["difference-next"].click()
    expect(difference).to_have_attribute("data-kind", "added")
    expect(difference).to_contain_text("2 de 7")
    expect(first.locator(".pinelRunning")).to_have_count(0)
    for place in ("apart", "together"):
        teacher.page.locator(f"[data-testid=compare-view][data-value={place}]").click()
        expect(second.locator(".pinelSign")).to_have_count(7)
        teacher.studio.wait_for_screen("compare-side")
        for side in (first, second):
            box = box_of(side.locator(".injectionDiv"))
            assert box["height"] >= 350, f"{place}: room for ten blocks"
        assert cut(teacher.studio, "compare-side") == [], place
        assert violations(teacher.studio, "compare-side") == [], place
    _assert_sides_are_level(first, second)

    teacher.go(f"compare/{crashed}/{stopped}")
    expect(teacher.page.get_by_text("Os blocos das duas são iguais.")).to_be_visible()
    expect(teacher.page.locator(".pinelSign")).to_have_count(0)


def _assert_sides_are_level(first: Locator, second: Locator) -> None:
    """Both sentences are whole, the blocks begin at one height, and two blocks need no scroll bars."""
    assert len({box_of(side.locator(".injectionDiv"))["y"] for side in (first, second)}) == 1
    assert box_of(first.locator(".compare__program"))["width"] > 80
    sentence = first.locator(".status__text")
    assert sentence.evaluate("(one) => one.scrollHeight <= one.clientHeight + 1")
    expect(first.locator(".blocklyScrollbarHandle:visible")).to_have_count(0)


def test_a_note_that_was_not_left_is_there_still_and_says_so(teacher: Teacher) -> None:
    run = _begin_note(teacher, 1, "Por que pararam?")
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
    run = _begin_note(teacher, 1, "O que aconteceu aqui?")
    teacher.page.evaluate("() => fetch('/api/teacher/leave', {method: 'POST'})")
    teacher["note-save"].click()
    expect(teacher["pin"]).to_be_focused()
    expect(teacher["note-text"]).to_be_hidden()
    teacher["pin"].fill(PIN)
    teacher["sign-in"].click()
    expect(teacher["note-text"]).to_have_value("O que aconteceu aqui?")
    expect(teacher["note"]).to_have_attribute("data-state", "saved")
    assert [note["text"] for note in _notes(teacher, run)] == ["O que aconteceu aqui?"]


def test_a_note_is_taken_back_by_two_presses(teacher: Teacher) -> None:
    run = _begin_note(teacher, 2, "Muito bem!")
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
    outlined = teacher.page.locator(".pinelAdviceRing")
    teacher.go(f"run/{crashed}")
    expect(outlined).to_have_count(1)
    expect(teacher.page.locator(".blocklyTextBubble")).to_contain_text("mudem a distância")
    teacher["replay-slider"].press("Home")
    expect(outlined).to_have_count(0)

    teacher.go(f"compare/{crashed}/{stopped}")
    expect(outlined).to_have_count(1)
    stop = teacher["compare-side"].last
    expect(stop).to_contain_text("O grupo parou o robô.")
    expect(stop).not_to_contain_text("Rodar")


def test_a_replay_has_no_palette_after_a_change_of_the_theme(teacher: Teacher) -> None:
    teacher.go(f"run/{teacher.past.runs[2]}")
    teacher.studio.wait_for_screen("replay-slider")
    for theme in ("dark", "contrast", "light"):
        expect(teacher.page.locator(".blocklyToolbox")).to_be_hidden()
        teacher["theme"].click()
        expect(teacher.page.locator("html")).to_have_attribute("data-theme", theme)
        teacher.studio.wait_for_screen("replay-slider")
    expect(teacher.page.locator(".blocklyToolbox")).to_be_hidden()


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


def test_the_first_difference_of_long_programs_is_in_view_on_both_sides(teacher: Teacher) -> None:
    runs = _long_runs(teacher)
    teacher.go(f"compare/{runs[0]}/{runs[1]}")
    expect(teacher["difference"]).to_have_attribute("data-kind", "added")
    for side, block in zip(_sides(teacher), ("turn29", "wait0"), strict=True):
        outline = side.locator(f'[data-id="{block}"] > .blocklyPath')
        teacher.studio.wait_for_screen(outline)
        frame, place = side.locator(".injectionDiv").bounding_box(), outline.bounding_box()
        assert frame is not None
        assert place is not None
        assert frame["y"] <= place["y"]
        assert place["y"] + 20 <= frame["y"] + frame["height"], f"{block} is in view"


def _sides(teacher: Teacher) -> list[Locator]:
    sides = teacher["compare-side"]
    expect(sides).to_have_count(2)
    return [sides.first, sides.last]


def _long_runs(teacher: Teacher) -> list[str]:
    """Executes two runs of one program of thirty turns; the second waits after them."""
    name = {"name": f"Longo {time.monotonic()}"}
    program = teacher.studio.send("POST", f"/groups/{teacher.past.group}/programs", name)["id"]
    turns: list[Step] = [("turn", 1)] * 30
    runs = []
    for steps in (turns, [*turns, ("wait", 1)]):
        content = {"workspace": workspace_of(steps), "document": document_of(steps)}
        version = teacher.studio.send("POST", f"/programs/{program}/versions", content)
        begin = {"version_id": version["id"], "world": "empty_room", "speed": 10}
        run = teacher.studio.send("POST", "/runs", begin)["id"]
        runs.append(run)
        teacher.studio.eventually(
            lambda: teacher.studio.api(f"/runs/{runs[-1]}")["state"], "finished"
        )
    return runs


def _notes(teacher: Teacher, run: str) -> list[dict[str, Any]]:
    notes: list[dict[str, Any]] = teacher.studio.api(f"/runs/{run}/notes")["notes"]
    return notes


def _begin_note(teacher: Teacher, n: int, text: str) -> str:
    """Types a note at the replay of the lesson's n-th run, counted from 0; returns the run's id."""
    teacher.open_lesson()
    run = teacher.past.runs[n]
    teacher.go(f"run/{run}")
    teacher["note-open"].click()
    teacher["note-text"].fill(text)
    return run
