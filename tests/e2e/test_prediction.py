"""A real robot's run over its prediction: a ghost while it drives, two paths and the difference by block afterwards."""

import contextlib
from collections.abc import Iterator

import pytest
from playwright.sync_api import expect

from tests.e2e.axe import violations
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_classes import prepare
from tests.e2e.test_layout import cut
from tests.e2e.test_real_robot import FAST_IN_A_HALL, check_off, set_up
from tests.links.aurora import Aurora, free_port

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(300)]

LESS_DEG = 3.1


@contextlib.contextmanager
def turning_less(port: int) -> Iterator[Aurora]:
    """A double that turns less than its wheels report."""
    aurora = Aurora(port, "--turns", str(1 - LESS_DEG / 90))
    try:
        yield aurora
    finally:
        aurora.close()


def test_group_sees_its_robot_beside_the_prediction_and_how_much_less_it_turns(
    studio: Studio,
) -> None:
    port = free_port()
    prepare(studio)
    set_up(studio, port, FAST_IN_A_HALL)
    studio["sign-out"].click()
    studio.enter_group("Os Tatus")
    studio.build_square("1")
    expect(studio["prediction-switch"]).to_have_count(0)  # the simulator needs none
    studio["robot-choice"].select_option("bridge")
    expect(studio["prediction-switch"]).to_have_attribute("aria-pressed", "true")
    with turning_less(port) as aurora:
        studio["run"].click()
        check_off(studio)
        studio.wait_for_phase("running")
        expect(studio["scene"]).to_have_attribute("data-ghost", "true", timeout=RUN_MS)
        studio["prediction-switch"].click()
        expect(studio["scene"]).not_to_have_attribute("data-ghost", "true")
        studio["prediction-switch"].click()
        studio.wait_for_phase("finished")
        assert aurora.has_ended(RUN_MS / 1000)
        x_m, y_m = aurora.positions[-1]
    line = studio["prediction-line"]
    expect(line).to_contain_text(
        "Previsto e real: O robô fez o que estava previsto, pela odometria"
    )
    assert violations(studio, "prediction-line") == []
    assert cut(studio, "prediction-line") == []
    measure(studio, x_m, y_m)
    replayed(studio)


def measure(studio: Studio, x_m: float, y_m: float) -> None:
    """Types where the robot stands, by tape measure; the sentence follows."""
    studio["tape-open"].click()
    for name, metres in {"forward": x_m, "sideways": y_m}.items():
        studio[f"tape-{name}"].fill(f"{abs(100 * metres):.0f}")
        side = f"[data-testid=tape-{name}-side][data-value={str(metres < 0).lower()}]"
        studio.page.locator(side).click()
    studio["heading"].fill(f"{-4 * LESS_DEG:.1f}".replace(".", ","))
    studio["tape-save"].click()
    expect(studio["prediction-line"]).to_contain_text("a menos em cada “girar 90°”, em média")
    studio["tape-skip"].click()


def newest_run(studio: Studio) -> str:
    group = studio.api("/groups")["groups"][0]["id"]
    return str(studio.api(f"/groups/{group}/runs")["runs"][0]["id"])


def replayed(studio: Studio) -> None:
    """The teacher reads in words what the tape measure shows, with the block marked."""
    studio.page.goto(f"{studio.origin}/#/run/{newest_run(studio)}")
    expect(studio["prediction-line"]).to_contain_text("pela fita")
    studio["prediction-toggle"].click()
    panel = studio["prediction"]
    expect(panel).to_contain_text("em cada “girar 90°”, em média, pela fita")
    words = panel.inner_text()
    said = words.partition("girou ")[2].partition("°")[0]
    assert float(said.replace(",", ".")) == pytest.approx(LESS_DEG, abs=0.3)
    assert "a menos" in words
    expect(studio["prediction-end"]).to_contain_text("pela fita")
    expect(studio["prediction-ate"]).to_contain_text("pela odometria")
    marked = panel.locator("[data-testid=prediction-row][data-marked=true]")
    expect(marked).to_contain_text("girar 90°")
    expect(marked).to_contain_text("4×")
    expect(marked).to_contain_text("pela fita")
    assert violations(studio, "prediction") == []
    assert cut(studio, "prediction") == []
    studio["replay-slider"].press("End")
    turn = studio.page.locator(".blocklyWorkspace .pinelAdvice")
    expect(turn).to_have_count(1)
    expect(turn).to_contain_text("girar")
    studio["prediction-toggle"].click()
    expect(panel).to_have_count(0)
    studio["prediction-switch"].click()
    expect(studio["scene"]).not_to_have_attribute("data-ghost", "true")
