"""The lesson of two hours (docs/lesson.pt-BR.md) by clicks: five groups on three PCs, and their teacher.

`--pictures FOLDER` saves a picture of each step, for docs/teacher.pt-BR.md.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_camera import CAMERA_MS, RECORDINGS
from tests.e2e.test_classes import PIN, to_part
from tests.e2e.test_examples import open_example
from tests.e2e.test_lesson_day import CHECKED_MS, at_the_stick, merge_all, prepare, save_on

pytestmark = [pytest.mark.e2e, pytest.mark.nightly, pytest.mark.timeout(600)]

GROUPS = ("Araras", "Botos", "Corujas", "Dourados", "Emas")
MOVE, TURN, PEN = "andar para frente", "girar", "abaixar a caneta"

T = (
    "robot.pen(down=True)\nrobot.move_forward(1.2)\nrobot.pen(down=False)\nrobot.move_backward(0.6)\n"
    "robot.turn(-90)\nrobot.pen(down=True)\nrobot.move_forward(2.0)\n"
)
A = "robot.pen(down=True)\nfor _ in range(3):\n    robot.move_forward(1.0)\n    robot.turn({})\n"
NO_PEN = "robot.move_forward(2.0)\nrobot.turn(90)\nrobot.move_forward(1.0)\n"
READ = "robot.classify_gestures(timeout=30)\n"
MOVE_IF_B = 'if robot.gesture_result == "B":\n    robot.move_forward(1.0)\n'


@dataclass
class Pictures:
    """Saves pictures of the steps, in order; without a folder, none."""

    folder: Path | None
    photographed: set[str] = field(default_factory=set)

    def photograph(self, studio: Studio, step: str, shows: str | Locator) -> None:
        """Saves the first picture of each step."""
        studio.wait_for_screen(shows)
        if self.folder is not None and step not in self.photographed:
            self.photographed.add(step)
            self.folder.mkdir(parents=True, exist_ok=True)
            studio.page.screenshot(path=self.folder / f"lesson-{step}.png")


@pytest.fixture
def pictures(request: pytest.FixtureRequest) -> Pictures:
    folder = request.config.getoption("--pictures")
    return Pictures(Path(folder) if folder else None)


@pytest.fixture
def pcs(open_pc: OpenStudio) -> list[Studio]:
    """Three PCs with an empty database each, all with a camera that shows B; the first is the teacher's."""
    return [open_pc("--camera", str(RECORDINGS / "b.npz")) for _ in range(3)]


def test_two_hours_of_five_groups(pcs: list[Studio], tmp_path: Path, pictures: Pictures) -> None:
    mine, second, third = pcs
    seats = dict(zip(GROUPS, (mine, mine, second, second, third), strict=True))

    before_the_lesson(mine, stick := tmp_path / "pendrive", pictures)
    what_does_a_robot_obey(mine, pictures)
    the_alphabet(mine, pictures)
    for activity, works in LESSON.items():
        open_on_all(pcs, activity, stick, pictures)
        for name, work in works.items():
            with_group(seats[name], name, work, pictures)

    for number, pc in enumerate((second, third), 2):
        first_pin(pc, f"PC {number}")
        save_on(pc, stick)
    merge_all(as_teacher(mine), stick)
    all_is_checked(mine)
    the_last_eight_minutes(mine, pictures)


def before_the_lesson(pc: Studio, stick: Path, pictures: Pictures) -> None:
    """Prepares the class with its groups, the camera, the plan and its cards."""
    stick.mkdir()
    prepare(pc, "Mesa da professora")
    for name in GROUPS:
        pc["new-group-name"].fill(name)
        pc["make-group"].click()
        expect(pc["class-group"].filter(has_text=name)).to_be_visible()
    to_part(pc, "camera")
    expect(pc["camera-ready"]).to_have_attribute("data-ready", "true", timeout=CAMERA_MS)
    pictures.photograph(pc, "camera", "camera-ready")
    to_part(pc, "plan")
    expect(pc["plan-step"]).to_have_count(8)
    pictures.photograph(pc, "plan", "plan-step")
    pc["plan-cards"].click()
    expect(pc["card"].first).to_be_visible()
    pictures.photograph(pc, "cards", "card")
    pc.page.go_back()
    at_the_stick(pc, stick)
    pc["sign-out"].click()


def all_is_checked(pc: Studio) -> None:
    """Waits until this PC has repeated the runs of the other PCs, so that their passes count."""
    expect(pc["unconfirmed"]).to_be_visible()
    expect(pc["unconfirmed"]).to_have_count(0, timeout=CHECKED_MS)


def first_pin(pc: Studio, name: str) -> None:
    """Sets the first PIN on a PC that the lesson file prepared."""
    pc["home"].click()
    pc["teacher-link"].click()
    pc["pin"].fill(PIN)
    pc["pin-again"].fill(PIN)
    pc["computer-name"].fill(name)
    pc["prepare-done"].click()
    expect(pc["teacher-part"].first).to_be_visible()


def what_does_a_robot_obey(pc: Studio, pictures: Pictures) -> None:
    """0-15 min: the teacher shows the example with the vacuum cleaner."""
    to_group(pc, "Araras")
    open_example(pc, "vacuum_cleaner")
    pc["speed"].select_option("10")
    pc.run()
    pc.wait_for_phase("running")
    expect(pc["pose-x"]).not_to_have_attribute("data-value", "0.0000")
    pictures.photograph(pc, "vacuum", "scene")
    pc["stop"].click()
    pc.wait_for_phase("stopped")


def the_alphabet(pc: Studio, pictures: Pictures) -> None:
    """15-25 min: shows large letters to imitate."""
    pc["home"].click()
    pc["practice"].click()
    expect(pc["practice-sign"].first).to_be_visible()
    expect(pc["camera-picture"]).to_have_attribute("data-state", "on", timeout=CAMERA_MS)
    assert violations(pc, "camera-picture") == []
    expect(pc.page.locator(".skeleton__hand").first).to_be_visible(timeout=CAMERA_MS)
    pictures.photograph(pc, "alphabet", "practice-sign")


def open_on_all(pcs: list[Studio], activity: str, stick: Path, pictures: Pictures) -> None:
    """Opens the activity by a button of the plan, and on the other PCs by the lesson file, without a PIN."""
    mine, *others = pcs
    as_teacher(mine)
    to_part(mine, "plan")
    button = mine["plan-open"].and_(mine.page.locator(f"[data-name={activity}]"))
    button.click()
    expect(button).to_have_attribute("aria-pressed", "true")
    to_part(mine, "lessons")
    with mine.page.expect_download() as download:
        mine["lesson-file-save"].click()
    file = stick.parent / download.value.suggested_filename
    download.value.save_as(file)
    pictures.photograph(mine, "file", "lesson-now")
    mine["sign-out"].click()
    for pc in others:
        pc["home"].click()
        pc["lesson-file-open"].set_input_files(file)
        expect(pc["group-card"]).to_have_count(len(GROUPS))


def as_teacher(pc: Studio) -> Studio:
    pc["home"].click()
    pc["teacher-link"].click()
    expect(pc["pin"].or_(pc["teacher-part"]).first).to_be_visible()
    if pc["pin"].count():
        pc["pin"].fill(PIN)
        pc["sign-in"].click()
    expect(pc["teacher-part"].first).to_be_visible()
    return pc


def to_group(pc: Studio, name: str) -> None:
    pc["home"].click()
    pc["group-card"].filter(has_text=name).click()
    pc.wait_until_open()


Work = Callable[[Studio, Pictures], None]


def with_group(pc: Studio, name: str, work: Work, pictures: Pictures) -> None:
    """A group selects itself by its picture, works, and leaves."""
    to_group(pc, name)
    expect(pc["mission"]).to_be_visible()
    if name != GROUPS[0]:  # only the first group runs in real time
        pc.choose_level(2)
        pc["speed"].select_option("10")
    work(pc, pictures)
    pc.wait_until_saved()


def append(pc: Studio, *steps: tuple[str, str]) -> None:
    """Clicks blocks of the flyout, which are appended, and types their numbers."""
    for text, value in steps:
        pc.blocks.click_in_toolbox("show" if text == PEN else "motion", text)
        if text != PEN:
            pc.blocks.type_into(pc.blocks.by_text(text), value)


def passed(pc: Studio) -> None:
    pc.run_to_the_end()
    expect(pc["mission-done"]).to_be_visible(timeout=RUN_MS)


def expect_not_passed(pc: Studio, text: str) -> None:
    """Checks that the run did not pass, and the text why."""
    pc.run_to_the_end()
    expect(pc["status-line"]).to_contain_text("Ainda não", timeout=RUN_MS)
    expect(pc["status-line"]).to_contain_text(text)


def corner_at_once(pc: Studio, pictures: Pictures) -> None:
    pictures.photograph(pc, "mission", "mission")
    append(pc, (MOVE, "3"), (TURN, "90"), (MOVE, "3"))
    passed(pc)
    pictures.photograph(pc, "done", "mission-done")


def corner_to_the_wrong_side(pc: Studio, pictures: Pictures) -> None:
    append(pc, (MOVE, "3"), (TURN, "90"), (MOVE, "3"))
    pc.blocks.choose(pc.blocks.by_text(TURN), "direita")
    expect_not_passed(pc, "de que lado ficou a escola?")
    expect(pc.blocks.fault_text()).to_have_count(1)
    expect(pc.blocks.fault_text()).to_contain_text("onde ele bateu")
    pictures.photograph(pc, "not-yet", "status-line")
    pc["mission-fold"].click()
    pc["mission-hint"].click()
    pc["mission-start"].click()
    pc.blocks.choose(pc.blocks.by_text(TURN), "esquerda")
    pc.eventually(lambda: pc.values("angle"), [None, 90, None])
    passed(pc)


def corner_turns_first(pc: Studio, pictures: Pictures) -> None:
    append(pc, (TURN, "90"), (MOVE, "3"))
    expect_not_passed(pc, "O que ele faz antes?")
    write_program(pc, "robot.move_forward(3.0)\nrobot.turn(90)\nrobot.move_forward(3.0)\n")
    passed(pc)


def corner_without_the_last_move(pc: Studio, pictures: Pictures) -> None:
    append(pc, (MOVE, "3"), (TURN, "90"))
    expect_not_passed(pc, "falta “andar para frente”")


AROUND_THE_CORNER: dict[str, Work] = {
    "Araras": corner_at_once,
    "Botos": corner_to_the_wrong_side,
    "Corujas": corner_turns_first,
    "Dourados": corner_without_the_last_move,
    "Emas": corner_at_once,
}


def writes(program: str) -> Work:
    def work(pc: Studio, pictures: Pictures) -> None:
        write_program(pc, program)
        passed(pc)

    return work


def mirrored_letter(pc: Studio, pictures: Pictures) -> None:
    append(pc, (TURN, "90"))
    pc.blocks.choose(pc.blocks.by_text(TURN), "direita")
    append(pc, (PEN, ""), (MOVE, "2"), (TURN, "90"))
    pc.blocks.choose(pc.blocks.by_text(TURN), "direita")
    append(pc, (MOVE, "1"))
    expect_not_passed(pc, "L no espelho")
    pictures.photograph(pc, "mirrored", "status-line")
    pc.blocks.choose(pc.blocks.by_text(TURN), "esquerda")
    passed(pc)


def open_triangle(pc: Studio, pictures: Pictures) -> None:
    write_program(pc, A.format(60))
    expect_not_passed(pc, "")


def forgotten_pen(pc: Studio, pictures: Pictures) -> None:
    write_program(pc, NO_PEN)
    expect_not_passed(pc, "a caneta começa levantada")


LETTERS: dict[str, Work] = {
    "Araras": mirrored_letter,
    "Botos": writes(T),
    "Corujas": open_triangle,
    "Dourados": writes(A.format(120)),
    "Emas": forgotten_pen,
}


def sign_decides(pc: Studio, pictures: Pictures) -> None:
    write_program(pc, READ + MOVE_IF_B)
    pc.run()
    # the camera may detect the sign before the panel is checked
    sign = pc["capture"].or_(pc["mission-done"])
    expect(sign.first).to_be_visible(timeout=CAMERA_MS)
    pictures.photograph(pc, "sign", sign)
    expect(pc["mission-done"]).to_be_visible(timeout=CAMERA_MS + RUN_MS)


def decides_before_reading(pc: Studio, pictures: Pictures) -> None:
    write_program(pc, MOVE_IF_B + READ)
    expect_not_passed(pc, "antes de")


def drives_always(pc: Studio, pictures: Pictures) -> None:
    write_program(pc, READ + "robot.move_forward(1.0)\n")
    expect_not_passed(pc, "")


SIGNS: dict[str, Work] = {
    "Araras": sign_decides,
    "Botos": decides_before_reading,
    "Corujas": drives_always,
    "Dourados": sign_decides,
    "Emas": sign_decides,
}


LESSON = {"around_the_corner": AROUND_THE_CORNER, "letter": LETTERS, "sign_b": SIGNS}


def the_last_eight_minutes(pc: Studio, pictures: Pictures) -> None:
    """92-100 min: reviews the lesson on the teacher's PC, after the files of the other PCs are merged."""
    to_part(pc, "lessons")
    pc["lesson-row"].filter(has_text="Aula de duas horas").get_by_test_id("lesson-link").click()
    expect(pc["review-group"]).to_have_count(5)
    expect(pc["lesson-summary"]).to_contain_text("3 de 5")
    assert violations(pc, "review-group") == []
    pictures.photograph(pc, "review", "review-group")
