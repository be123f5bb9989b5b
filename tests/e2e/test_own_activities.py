"""A teacher makes an activity and opens a lesson with it. One file prepares another PC, where a group solves it."""

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_lesson_day import prepare
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(300)]

TITLE = "Até a porta"
TWO_METRES = "robot.move_forward(2)\n"


@pytest.fixture
def pcs(open_pc: OpenStudio) -> list[Studio]:
    """The teacher's PC and a PC of the lab, with an empty database each."""
    return [open_pc(), open_pc()]


def test_an_activity_of_the_teacher_is_solved_on_another_pc(
    pcs: list[Studio], watch: Watch, tmp_path: Path
) -> None:
    mine, lab = pcs
    watch.expect("/api/own-activities")  # an activity that an empty program passes is refused
    prepare(mine, "Mesa da professora")
    mine["new-group-name"].fill("Tatus")
    mine["make-group"].click()
    expect(mine["class-group"].filter(has_text="Tatus")).to_be_visible()
    build_solution(mine)
    make_activity(mine)
    open_its_lesson(mine)
    file = saved_file(mine, tmp_path)
    open_on(lab, file)
    solve(lab)


def part_of_teacher(pc: Studio, name: str) -> None:
    pc.page.goto(f"{pc.origin}/#/teacher/{name}")
    expect(pc["teacher-part"].first).to_be_visible()


def build_solution(pc: Studio) -> None:
    """The teacher builds the solution in the studio; pupils do not meet it."""
    part_of_teacher(pc, "activities")
    pc["making-new"].click()
    pc["making-build"].click()
    pc.wait_until_open()
    expect(pc["header-group"]).to_contain_text("Soluções")
    expect(pc["tour"]).to_have_count(0)  # it is for pupils
    write_program(pc, TWO_METRES)
    pc["home"].click()
    expect(pc["group-card"]).to_have_count(1)
    expect(pc["group-card"]).to_contain_text("Tatus")


def make_activity(pc: Studio) -> None:
    part_of_teacher(pc, "activities")
    pc["making-new"].click()
    pc["making-save"].click()
    expect(pc["making-form"]).to_contain_text("Escolha primeiro o programa")
    expect(pc["making-group"].locator("option:checked")).to_have_text("Meus programas")
    pc["making-program"].select_option(index=1)
    ends = pc["making-check"].and_(pc.page.locator("[data-kind=ends_at]"))
    expect(ends).to_be_visible()
    pc["making-title"].fill(TITLE)
    pc["making-story"].fill("A porta fica 2 m à frente. Parem em frente dela.")
    pc["making-hint"].first.fill("Usem “repetir até que”.")
    expect(pc["making-notice"]).to_contain_text("repetir até que")
    pc["making-hint"].first.fill("Contem os quadros do chão.")
    expect(pc["making-notice"]).to_have_count(0)

    pc["making-try"].click()  # an empty program passes, because there is no check
    expect(pc["making-trials"]).to_have_attribute("data-right", "false")
    pc["making-save"].click()
    expect(pc.page.get_by_role("alert")).to_contain_text("Experimentar")
    ends.get_by_role("checkbox").check()
    ends.get_by_test_id("making-number").fill("15")
    pc["making-try"].click()
    expect(pc["making-trials"]).to_have_attribute("data-right", "true")
    expect(pc["making-trials"]).to_contain_text("robô realista")
    assert violations(pc, "making-trials") == []
    pc["making-save"].click()
    expect(pc["making-row"]).to_contain_text(TITLE)

    pc["making-delete"].click()
    expect(pc["making-row"]).to_have_count(0)
    pc["making-undo"].click()
    pc["making-edit"].click()
    expect(pc["making-title"]).to_have_value(TITLE)
    expect(ends.get_by_test_id("making-number")).to_have_value("15")
    pc["making-minutes"].fill("5")
    pc["making-save"].click()
    expect(pc["making-row"]).to_contain_text(TITLE)
    assert violations(pc, "making-row") == []


def open_its_lesson(pc: Studio) -> None:
    """Opens a lesson without a title, which gets the title of the activity."""
    part_of_teacher(pc, "lessons")
    pc["preset-level"].select_option("2")
    expect(pc["preset-saved"]).to_have_text("Salvo.")
    pc["preset-swap"].select_option("10")
    pc["lesson-activity"].select_option(label=TITLE)
    pc["open-lesson"].click()
    expect(pc["lesson-now"]).to_contain_text(TITLE)
    assert violations(pc, "lesson-now") == []


def saved_file(pc: Studio, folder: Path) -> Path:
    with pc.page.expect_download() as download:
        pc["lesson-file-save"].click()
    path = folder / download.value.suggested_filename
    download.value.save_as(path)
    assert path.name == "ate-a-porta.pinel"
    return path


def open_on(pc: Studio, file: Path) -> None:
    """Opens the file on the first screen of a PC without a PIN; opening it again changes nothing."""
    for _ in range(2):
        pc["lesson-file-open"].set_input_files(file)
        expect(pc["lesson-opened"]).to_contain_text(TITLE)
        expect(pc["group-card"]).to_have_count(1)


def solve(pc: Studio) -> None:
    pc["group-card"].filter(has_text="Tatus").click()
    pc.wait_until_open()
    expect(pc["lesson-chip"]).to_contain_text(TITLE)
    expect(pc["mission"]).to_contain_text("A porta fica 2 m à frente")
    expect(pc["mission"]).to_contain_text("Terminar 2 m à frente da partida")
    pc.choose_level(3)
    pc["speed"].select_option("10")
    write_program(pc, "robot.move_forward(1)\n")
    pc["run"].click()
    expect(pc["status-line"]).to_contain_text("O robô parou a 1 m do lugar certo", timeout=RUN_MS)
    write_program(pc, TWO_METRES)
    pc["run"].click()
    expect(pc["mission-done"]).to_be_visible(timeout=RUN_MS)
