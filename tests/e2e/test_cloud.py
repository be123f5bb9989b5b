"""50 robots at once: how firm a program is, seen on the floor and said in a sentence."""

from typing import Any

import pytest
from playwright.sync_api import Position, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.made_program import enter_made_group
from tests.e2e.past_lesson import SQUARE, Step
from tests.e2e.python_pane import write_program
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(240)]

# each turn adds an error, which the next stretch makes larger
WEAK: list[Step] = [("move_forward", 2), ("turn", 90), ("move_forward", 2)]
INTO_THE_WALL: list[Step] = [("move_forward", 1), ("move_forward", 6)]
WAIT_MS = 60_000


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def drive_50(studio: Studio) -> int:
    """Asks for 50 robots, waits for the last; returns how many do it."""
    studio["cloud"].click()
    line = studio["cloud-line"]
    expect(line).to_have_attribute("data-state", "over", timeout=WAIT_MS)
    expect(line).to_have_attribute("data-arrived", "50")
    return int(line.get_attribute("data-good") or -1)


def shorten_both(studio: Studio) -> None:
    """Shortens both moves; the block of the first one holds all others."""
    moves = studio.blocks.all().filter(has_text="andar para frente")
    studio.blocks.type_into(moves.first, "0,5")
    studio.blocks.type_into(moves.last, "0,5")


def test_a_group_makes_its_program_firmer_and_sees_the_count_rise(studio: Studio) -> None:
    enter_made_group(studio, WEAK)
    weak = drive_50(studio)
    assert 10 < weak < 40
    expect(studio["cloud-text"]).to_contain_text(f"{weak} de 50 robôs param a menos de 10 cm")

    shorten_both(studio)
    expect(studio["cloud-line"]).to_have_attribute("data-state", "stale")
    expect(studio["cloud-text"]).to_contain_text(f"O programa mudou. Antes: {weak} de 50.")
    expect(studio["cloud-see"]).to_have_count(0)

    firm = drive_50(studio)
    assert firm > weak
    expect(studio["cloud-text"]).to_contain_text(f"Antes: {weak}, agora: {firm}.")
    studio["cloud-close"].click()
    expect(studio["cloud-line"]).to_have_count(0)


def test_the_block_that_drives_into_the_wall_is_named_and_marked(studio: Studio) -> None:
    enter_made_group(studio, INTO_THE_WALL)
    assert drive_50(studio) == 0
    expect(studio["cloud-text"]).to_contain_text("50 batem em algo em “andar para frente 6 m”.")
    marked = studio.page.locator(".pinelAdvice")
    expect(marked).to_have_count(1)
    expect(marked).to_contain_text("6")


def test_one_of_the_robots_drives_as_a_run_of_its_own_by_the_list_and_by_a_click_on_its_path(
    studio: Studio,
) -> None:
    enter_made_group(studio, [("move_forward", 1)], speed=10)
    drive_50(studio)
    studio["cloud-see"].select_option("7")
    studio.wait_for_phase("finished")
    # all paths begin at the robot's start and end 1 m ahead of it
    studio["scene"].click(position=middle_of_the_path(studio))
    studio.eventually(lambda: [run["state"] for run in runs_of(studio)], ["finished", "finished"])
    clicked, chosen = runs_of(studio)
    assert chosen["seed"] == 7
    assert 1 <= clicked["seed"] <= 50
    assert chosen["closing_error_m"] != clicked["closing_error_m"] or clicked["seed"] == 7


def runs_of(studio: Studio) -> list[dict[str, Any]]:
    """The runs of the group, newest first."""
    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    runs: list[dict[str, Any]] = studio.api(f"/groups/{group}/runs")["runs"]
    return runs


def middle_of_the_path(studio: Studio) -> Position:
    """A point of the canvas between start and end, where neither robot nor start is."""
    found: Position = studio.page.evaluate(
        """() => {
            const canvas = document.querySelector('[data-testid=scene]');
            const { width, height } = canvas.getBoundingClientRect();
            const ratio = canvas.width / width;
            const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            const style = getComputedStyle(document.documentElement);
            const hex = style.getPropertyValue('--floor-path').match(/[0-9a-f]{2}/gi);
            const path = hex.map((one) => parseInt(one, 16));
            const found = [];
            for (let at = 0; at < data.length; at += 4) {
                const off = path.map((value, i) => Math.abs(data[at + i] - value));
                const pixel = at / 4;
                const place = [pixel % canvas.width, Math.floor(pixel / canvas.width)];
                if (off[0] + off[1] + off[2] < 12) found.push(place);
            }
            found.sort((one, other) => one[0] - other[0]);
            const [x, y] = found[Math.floor(found.length / 2)];
            return { x: x / ratio, y: y / ratio };
        }"""
    )
    return found


def test_stop_ends_the_robots_under_way(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, "while True:\n    robot.wait(1)\n")
    studio["cloud"].click()
    line = studio["cloud-line"]
    expect(line).to_have_attribute("data-state", "under-way")
    studio["stop"].click()
    expect(line).to_have_attribute("data-state", "over", timeout=WAIT_MS)
    expect(line).not_to_have_attribute("data-arrived", "50")


def test_a_program_that_asks_needs_one_run_whose_answers_the_robots_use(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("(CONFLICT)")
    studio.enter_new_group()
    write_program(studio, 'd = robot.ask("Quanto?")\nrobot.move_forward(d)\n')
    studio["speed"].select_option("10")
    studio["cloud"].click()
    expect(studio["problem"]).to_contain_text("usam as respostas da última rodada")
    studio.run()
    studio["answer"].fill("0,5")
    studio["answer"].press("Enter")
    studio.wait_for_phase("finished")
    assert drive_50(studio) == 50
    studio["cloud-see"].select_option("7")
    studio.eventually(lambda: [run["state"] for run in runs_of(studio)], ["finished", "finished"])
    assert runs_of(studio)[0]["seed"] == 7  # nobody was asked again


def test_in_a_mission_with_several_starts_they_drive_from_the_one_that_is_chosen(
    studio: Studio,
) -> None:
    enter_made_group(studio, [("move_forward", 1)], speed=10, activity="stop_before_wall")
    drive_50(studio)
    line = studio["cloud-text"]
    expect(line).to_contain_text("Com a partida de sempre:")
    studio["cloud-case"].select_option("2")
    expect(line).to_contain_text("Com a partida 1,75 m", timeout=WAIT_MS)
    expect(studio["cloud-case"]).to_have_value("2")
    expect(line).not_to_contain_text("Antes:")
    studio["cloud-see"].select_option("3")
    studio.eventually(lambda: [run["state"] for run in runs_of(studio)], ["finished"])
    (run,) = runs_of(studio)
    assert studio.api(f"/runs/{run['id']}")["world_document"]["start"]["x_m"] == -1.25


def test_a_mission_counts_who_passes_it_and_does_not_judge_a_robot_that_is_watched(
    studio: Studio,
) -> None:
    enter_made_group(studio, SQUARE, speed=10, activity="square")
    passing = drive_50(studio)
    assert 0 < passing < 50
    expect(studio["cloud-text"]).to_contain_text(f"{passing} de 50 robôs cumprem a missão.")
    studio["cloud-see"].select_option("3")
    studio.wait_for_phase("finished")
    (run,) = runs_of(studio)
    studio.eventually(lambda: studio.api(f"/runs/{run['id']}")["not_judged"] is not None, True)
    assert studio.api(f"/runs/{run['id']}")["passed"] is None
