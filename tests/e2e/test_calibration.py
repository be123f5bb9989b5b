"""A teacher calibrates the real robot from measured runs; a group chooses it in the simulator."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import expect

from storage import open_store
from tests.calibration.hidden_robot import OFFERED
from tests.calibration.recorded_runs import measured_pattern
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.studio import Studio
from tests.e2e.test_classes import prepare, to_part

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

NAME = "Pioneer da sala 3"


@pytest.fixture
def app(tmp_path: Path) -> Iterator[AppProcess]:
    """The app on a folder with UMBmark's runs of a robot with hidden errors, each measured with a tape at its end."""
    app = AppProcess(tmp_path)
    with open_store(app.database) as store:
        measured_pattern(store, OFFERED)
    app.start()
    yield app
    app.stop()


def test_measured_runs_become_a_robot_that_a_group_chooses(studio: Studio) -> None:
    prepare(studio)
    to_part(studio, "robot")
    expect(studio["real-run"]).to_have_count(len(OFFERED))
    # the programs of the pattern need a real robot with its room
    expect(studio["pattern"]).to_contain_text("salve primeiro o robô de verdade")
    expect(studio["calibrate"]).to_be_disabled()
    for run in studio["real-run"].all():
        expect(run).to_contain_text("medida: fita")
        run.get_by_role("checkbox").check()
    studio["calibrate"].click()
    result = studio["calibration-result"]
    expect(result).to_contain_text("A roda esquerda é")
    expect(result).to_contain_text("a menos")
    expect(studio["calibration-held-out"]).to_contain_text("Rodadas previstas pelas outras")
    squares = studio["calibration-squares"]
    expect(squares).to_contain_text("3 quadrados para a esquerda e 3 para a direita")
    expect(squares).to_contain_text("Com o robô calibrado, sobram")
    assert not violations(studio, "calibration-result")
    studio["calibration-name"].fill(NAME)
    studio["calibration-save"].click()
    expect(studio["calibrated-robot"]).to_contain_text(NAME)
    studio["calibrated-delete"].click()
    expect(studio["calibrated-robot"]).to_have_count(0)
    studio["calibrated-undo"].click()
    expect(studio["calibrated-robot"]).to_contain_text(NAME)

    studio["sign-out"].click()
    studio.enter_new_group()
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    blocks.type_into(blocks.by_text("andar para frente"), "0,3")
    studio["robot-model"].select_option(label=NAME)
    expect(studio["lifelike"]).to_have_count(0)
    studio.run_to_the_end()
    studio.wait_for_phase("finished")
    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    (run,) = studio.api(f"/groups/{group}/runs")["runs"]
    assert (run["calibrated_robot"], run["model"]) == (NAME, "pioneer_3dx")
    studio.page.reload()
    studio.wait_until_open()
    expect(studio["robot-model"].locator("option:checked")).to_have_text(NAME)
