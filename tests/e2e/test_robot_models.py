"""The TurtleBot3 Burger, chosen by clicks instead of the Pioneer."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.python_pane import write_program
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

TURTLEBOT = "turtlebot3_burger"
READS_SONAR = "robot.move_forward(0.2)\nrobot.say(robot.sonar(0))\n"
READS_LASER = "robot.move_forward(0.2)\nrobot.say(robot.lidar(180) < 3.5)\n"


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def test_the_turtlebot_drives_and_is_the_robot_of_its_run(studio: Studio) -> None:
    studio.enter_new_group()
    expect(studio["robot-model"]).to_have_value("pioneer_3dx")
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    blocks.type_into(blocks.by_text("andar para frente"), "0,3")
    studio["robot-model"].select_option(label="TurtleBot3 Burger")
    studio.run_to_the_end()
    studio.wait_for_phase("finished")
    studio.expect_number("pose-x", pytest.approx(0.3, abs=1e-4))

    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    (run,) = studio.api(f"/groups/{group}/runs")["runs"]
    assert run["model"] == TURTLEBOT
    assert run["duration_s"] > 0.3 / 0.22  # a Pioneer would be faster
    studio.page.reload()
    studio.wait_until_open()
    expect(studio["robot-model"]).to_have_value(TURTLEBOT)


def test_a_block_that_reads_a_sonar_is_marked_before_the_turtlebot_moves(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("(UNPROCESSABLE ENTITY)")
    studio.enter_new_group()
    write_program(studio, READS_SONAR)
    studio["robot-model"].select_option(label="TurtleBot3 Burger")
    studio["run"].click()
    expect(studio.blocks.faulty()).to_have_count(1)
    expect(studio.blocks.fault_text()).to_contain_text("não tem o sensor")
    studio.wait_for_phase("idle")

    studio["robot-model"].select_option(label="Pioneer 3-DX")
    studio["speed"].select_option("10")
    studio.run_to_the_end()
    studio.wait_for_phase("finished")
    expect(studio.blocks.faulty()).to_have_count(0)


def test_the_scanner_of_the_turtlebot_sees_behind_it_that_of_the_pioneer_does_not(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("(UNPROCESSABLE ENTITY)")
    studio.enter_new_group()
    write_program(studio, READS_LASER)
    studio["speed"].select_option("10")
    studio["run"].click()
    expect(studio.blocks.fault_text()).to_contain_text("O ângulo 180 está fora")
    studio["robot-model"].select_option(label="TurtleBot3 Burger")
    studio.run_to_the_end()
    studio.wait_for_phase("finished")
