"""The tape measure: after a run on a real robot the group says where it truly stands; replay and review tell it."""

import pytest
from playwright.sync_api import expect

from tests.e2e.axe import violations
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_classes import prepare
from tests.e2e.test_layout import cut
from tests.e2e.test_real_robot import build_move, check_off, client, set_up, sign_in_from_home
from tests.e2e.watch import Watch
from tests.links.aurora import free_port

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(300)]

MEASURED = "Medido com a fita: 52 cm à frente, 3 cm à direita, virado 15° para a esquerda."


def drive(studio: Studio, port: int, *, first: bool) -> None:
    """Half a metre ahead on the double of a robot."""
    with client(port) as aurora:
        studio["run"].click()
        if first:
            check_off(studio)
        studio.wait_for_phase("finished")
        assert aurora.has_ended(RUN_MS / 1000)


def test_a_group_measures_the_end_of_a_run_and_the_replay_shows_it(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("422")
    port = free_port()
    prepare(studio)
    set_up(studio, port)
    studio["sign-out"].click()
    studio.enter_group("Os Tatus")
    build_move(studio, "0,5")
    studio["robot-choice"].select_option("bridge")
    drive(studio, port, first=True)

    expect(studio["after-run"]).to_be_visible()
    studio["tape-skip"].click()
    expect(studio["after-run"]).to_have_count(0)
    drive(studio, port, first=False)
    studio["tape-open"].click()
    measure(studio)
    expect(studio["after-run"]).to_contain_text(MEASURED)
    expect(studio["after-run"]).to_contain_text("O robô acreditava estar")
    replayed(studio)


def measure(studio: Studio) -> None:
    """Types what the tape says; a place outside of the room is refused in words."""
    form = studio["tape-form"]
    expect(studio["tape-save"]).to_be_disabled()
    studio["tape-forward"].fill("muito")
    expect(form.get_by_role("alert")).to_contain_text("um número de 0 a 5000")
    studio["tape-forward"].fill("1000")
    studio["tape-sideways"].fill("3")
    studio.page.locator("[data-testid=tape-sideways-side][data-value=true]").click()
    studio["turn-left"].click()
    studio["tape-save"].click()
    expect(form.get_by_role("alert")).to_contain_text("fora da sala")
    assert violations(studio, "tape-form") == []
    assert cut(studio, "tape-form") == []
    studio.page.set_viewport_size({"width": 683, "height": 768})
    assert form.evaluate("(one) => one.scrollWidth <= one.clientWidth"), "both sides are in reach"
    studio.page.set_viewport_size({"width": 1366, "height": 768})
    studio["tape-forward"].fill("52")
    studio["tape-save"].click()
    expect(form).to_have_count(0)


def replayed(studio: Studio) -> None:
    """The teacher sees it in the replay of the run, and measures the other run there."""
    sign_in_from_home(studio)
    measured, skipped = studio.api("/runs")["runs"]
    studio.page.goto(f"{studio.origin}/#/run/{measured['id']}")
    expect(studio["truth-line"]).to_contain_text(MEASURED)
    studio.page.goto(f"{studio.origin}/#/run/{skipped['id']}")
    expect(studio["tape-open"]).to_have_text("Medir com a fita")
    expect(studio["truth-line"]).to_have_count(0)
    studio["tape-open"].click()
    studio["tape-forward"].fill("52")
    studio["tape-sideways"].fill("0")
    studio["tape-save"].click()
    expect(studio["truth-line"]).to_contain_text("52 cm à frente, virado para a frente")
    studio["tape-open"].click()
    studio["tape-remove"].click()
    expect(studio["truth-line"]).to_have_count(0)
