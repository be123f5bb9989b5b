"""Examples, finished programs: a press opens a copy that runs at once and can be changed."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_layout import cut

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def open_example(studio: Studio, name: str) -> None:
    studio["open-activities"].click()
    studio["to-examples"].click()
    card = studio.page.locator(f"[data-testid=example-card][data-example={name}]")
    expect(card).to_be_in_viewport()
    card.click()
    studio.wait_until_open()


def test_an_example_opens_as_a_copy_that_runs_in_its_world(studio: Studio) -> None:
    studio.enter_new_group()
    before = studio.program_id
    open_example(studio, "shy")
    assert studio.program_id != before
    expect(studio["program-name"]).to_have_value("Tímido")
    expect(studio["world"]).to_have_value("obstacles")
    studio["speed"].select_option("10")
    studio.run()
    studio.wait_for_phase("finished")
    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    (run,) = studio.api(f"/groups/{group}/runs")["runs"]
    assert (run["world"], run["state"]) == ("obstacles", "finished")
    assert run["path_length_m"] == pytest.approx(5.4, abs=0.05)


def test_a_copy_has_one_version_until_it_is_changed(studio: Studio) -> None:
    studio.enter_new_group()
    open_example(studio, "dice")
    program = studio.program_id
    studio.hurry()
    studio.run()
    studio.wait_for_phase("finished")
    assert studio.api(f"/programs/{program}")["n_versions"] == 1
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "girar", blocks.below(blocks.start()))
    studio.eventually(lambda: studio.actions()[0], "turn")
    studio["open-activities"].click()
    expect(studio["example-card"]).to_have_count(12)
    studio.page.locator("[data-testid=example-card][data-example=dice]").click()
    studio.wait_until_open()
    assert studio.program_id != program
    assert "turn" not in studio.actions()


def test_the_examples_are_read_in_every_language_and_theme(studio: Studio) -> None:
    studio.enter_new_group()
    studio["open-activities"].click()
    for language, title in {"en": "Examples", "es": "Ejemplos", "pt-BR": "Exemplos"}.items():
        studio.choose_language(language)
        expect(studio["examples"].get_by_role("heading")).to_have_text(title, timeout=RUN_MS)
        studio["to-examples"].click()
        assert cut(studio, "example-card") == [], language
        found = violations(studio, "example-card", every_theme=language == "en")
        assert found == [], language
