"""One class from end to end: a real robot that turns less, measured, calibrated, and chosen by the next group."""

import pytest
from playwright.sync_api import expect

from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_classes import open_lesson, prepare, to_part
from tests.e2e.test_real_robot import FAST_IN_A_HALL, check_off, set_up, sign_in_from_home
from tests.links.aurora import Aurora, free_port

pytestmark = [pytest.mark.e2e, pytest.mark.nightly, pytest.mark.timeout(600)]

TURNS = 0.97  # of what its odometry reports
LESS_DEG = 360 * (1 - TURNS)
SQUARE = "for i in range(4):\n    robot.move_forward(1)\n    robot.turn({turn})\n"
NAME = "Pioneer da sala 3"


def drive_and_measure(
    studio: Studio, port: int, program: str, heading_deg: float, *, is_first: bool = False
) -> None:
    """Runs a program on the robot, and types where it stands afterwards."""
    write_program(studio, program)
    aurora = Aurora(port, "--turns", str(TURNS))
    try:
        studio["run"].click()
        if is_first:
            check_off(studio)
        studio.wait_for_phase("running")
        studio.wait_for_phase("finished")
        assert aurora.has_ended(RUN_MS / 1000)
        place = dict(zip(("forward", "sideways"), aurora.positions[-1], strict=True))
    finally:
        aurora.close()
    studio["tape-open"].click()
    for name, metres in place.items():
        studio[f"tape-{name}"].fill(f"{abs(100 * metres):.0f}")
        side = f"[data-testid=tape-{name}-side][data-value={str(metres < 0).lower()}]"
        studio.page.locator(side).click()
    studio["heading"].fill(f"{heading_deg:.1f}".replace(".", ","))
    studio["tape-save"].click()
    expect(studio["tape-form"]).to_have_count(0)
    studio["tape-skip"].click()


def test_three_runs_of_a_group_become_the_robot_of_the_next_one(studio: Studio) -> None:
    port = free_port()
    prepare(studio)
    to_part(studio, "lessons")
    open_lesson(studio, "Robô de verdade")
    set_up(studio, port, FAST_IN_A_HALL)
    studio["sign-out"].click()

    studio.enter_group("Os Tatus")
    studio["robot-choice"].select_option("bridge")
    drive_and_measure(studio, port, "robot.move_forward(2)\n", 0.0, is_first=True)
    drive_and_measure(studio, port, SQUARE.format(turn=90), -LESS_DEG)
    drive_and_measure(studio, port, SQUARE.format(turn=-90), LESS_DEG)
    expect(studio["prediction-line"]).to_contain_text("a menos em cada “girar 90°”")

    sign_in_from_home(studio)
    to_part(studio, "robot")
    expect(studio["real-run"]).to_have_count(3)
    for run in studio["real-run"].all():
        run.get_by_role("checkbox").check()
    studio["calibrate"].click()
    result = studio["calibration-result"]
    expect(result).to_contain_text(f"ele gira {LESS_DEG:.1f}° a menos".replace(".", ","))
    studio["calibration-name"].fill(NAME)
    studio["calibration-save"].click()
    expect(studio["calibrated-robot"]).to_contain_text(NAME)
    studio["sign-out"].click()

    studio.enter_group("Os Botos")
    write_program(studio, SQUARE.format(turn=90))
    studio["robot-model"].select_option(label=NAME)
    studio.run_to_the_end()
    expect(studio["status-line"]).to_contain_text("O robô pensa que voltou à partida")
    expect(studio["prediction-line"]).to_have_count(0)  # that of the other group's run
    studio["cloud"].click()
    expect(studio["cloud-line"]).to_have_attribute("data-state", "over", timeout=RUN_MS)
