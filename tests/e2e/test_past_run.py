"""The time strip of the ended run below the floor: pose, block and values at a chosen time."""

import re

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.blocks import box_of
from tests.e2e.made_program import enter_made_group
from tests.e2e.past_lesson import Step
from tests.e2e.studio import Studio
from tests.e2e.test_layout import cut

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

_SIZES = [(1366, 768), (1024, 768)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


SHORT: list[Step] = [("move_forward", 0.5), ("turn", 90)]
# at speed 1, long enough for a Stop whose request is late
LONG: list[Step] = [("move_forward", 2), ("turn", 180), ("move_forward", 2), ("turn", 180)]


def drive(studio: Studio, steps: list[Step] = SHORT) -> None:
    """Executes a run to its end."""
    enter_made_group(studio, steps, speed=10)
    studio.run()
    studio.wait_for_phase("finished")
    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    (run,) = studio.api(f"/groups/{group}/runs")["runs"]
    # the last samples and the announcement for screen readers follow the end
    end = round(run["duration_s"] * 30)
    expect(studio["past-run-slider"]).to_have_attribute("max", str(end))
    expect(studio["status-line"].get_by_role("status")).to_contain_text("O programa terminou")


def press(slider: Locator, part: float) -> None:
    box = box_of(slider)
    slider.page.mouse.click(box["x"] + part * box["width"], box["y"] + box["height"] / 2)


def test_a_press_shows_the_moment_on_the_floor_in_the_blocks_and_in_words(studio: Studio) -> None:
    drive(studio)
    requests: list[str] = []
    studio.page.on("request", lambda request: requests.append(request.url))
    slider, status = studio["past-run-slider"], studio["status-line"]
    studio.wait_for_screen("past-run-slider")
    end_text, end_floor = status.inner_text(), studio.floor_picture()
    end = int(slider.get_attribute("max") or 0)
    expect(slider).to_have_js_property("value", str(end))
    expect(studio.blocks.running()).to_have_count(0)

    press(slider, 0.3)
    expect(studio.blocks.running()).to_contain_text("andar para frente")
    expect(status).to_contain_text("Andando:")
    studio.expect_number("pose-x", pytest.approx(0.25, abs=0.15))
    studio.expect_number("elapsed", pytest.approx(0.3 * end / 30, abs=0.3))
    studio.eventually(lambda: studio.floor_picture() != end_floor, True)

    press(slider, 0.9)
    expect(studio.blocks.running()).to_contain_text("girar")
    expect(status).to_contain_text("Girando")
    studio.eventually(lambda: studio.number("pose-heading") > 10, True)

    studio.page.keyboard.press("Escape")
    expect(studio.blocks.running()).to_have_count(0)
    expect(status).to_have_text(end_text, use_inner_text=True)
    studio.eventually(studio.floor_picture, end_floor)
    # some seconds after its opening a program has the processes of the 50 robots started
    asked = [url for url in requests if "/api/" in url and not url.endswith("/clouds/ready")]
    assert asked == []


def test_arrow_keys_go_from_block_to_block_and_leaving_goes_back_to_the_end(studio: Studio) -> None:
    drive(studio)
    slider = studio["past-run-slider"]
    slider.focus()
    slider.press("ArrowLeft")
    expect(studio.blocks.running()).to_contain_text("girar")
    expect(studio["status-line"]).to_contain_text("0° de 90°")
    slider.press("ArrowLeft")
    expect(studio.blocks.running()).to_contain_text("andar para frente")
    studio.expect_number("pose-x", pytest.approx(0, abs=0.02))
    slider.press("ArrowRight")
    expect(studio.blocks.running()).to_contain_text("girar")

    studio.blocks.by_text("andar para frente").click(position={"x": 20, "y": 20})
    expect(studio.blocks.running()).to_have_count(0)
    expect(studio["status-line"]).to_have_attribute("data-tone", "done")
    studio.expect_number("pose-x", pytest.approx(0.5, abs=0.001))


def test_a_block_that_is_gone_is_lit_nowhere_and_the_moment_is_shown_all_the_same(
    studio: Studio,
) -> None:
    drive(studio)
    studio.blocks.by_text("girar").click(position={"x": 20, "y": 20})
    studio.page.keyboard.press("Delete")
    studio.eventually(studio.actions, ["move_forward"])
    press(studio["past-run-slider"], 0.85)
    expect(studio["status-line"]).to_contain_text("Girando")
    expect(studio.blocks.running()).to_have_count(0)
    press(studio["past-run-slider"], 0.2)
    expect(studio.blocks.running()).to_contain_text("andar para frente")


def test_run_leaves_the_moment_and_the_strip_waits_for_the_end(studio: Studio) -> None:
    drive(studio, LONG)
    studio["speed"].select_option("1")
    press(studio["past-run-slider"], 0.3)
    expect(studio.blocks.running()).to_have_count(1)
    floor = box_of(studio["scene"])
    studio.run()
    studio.wait_for_phase("running")
    expect(studio["past-run-slider"]).to_have_count(0)
    assert box_of(studio["scene"]) == floor
    studio["stop"].click()
    studio.wait_for_phase("stopped")
    expect(studio["past-run-slider"]).to_be_visible()
    assert box_of(studio["scene"]) == floor
    studio["start-again"].click()
    expect(studio["past-run"]).to_have_count(0)


def test_a_failed_run_shows_where_it_failed_and_its_replay_is_one_press_away(
    studio: Studio,
) -> None:
    enter_made_group(studio, [("move_forward", 9)], speed=10)
    studio.run()
    studio.wait_for_phase("failed")
    press(studio["past-run-slider"], 0.5)
    expect(studio["status-line"]).to_contain_text("Andando:")
    studio["past-run-replay"].click()
    expect(studio["replay-slider"]).to_be_visible()
    expect(studio.page).to_have_url(re.compile("#/run/"))


def test_a_press_on_a_plot_shows_its_moment(studio: Studio) -> None:
    drive(studio)
    studio["plots-toggle"].click()
    studio.page.locator('[data-testid=plot-tab][data-figure="position"]').click()
    # the tab replaces the plot of the path
    box = box_of(studio.page.locator('[data-testid="plot"][data-figure="position"] .u-over'))
    studio.page.mouse.click(box["x"] + 0.2 * box["width"], box["y"] + box["height"] / 2)
    expect(studio.blocks.running()).to_contain_text("andar para frente")
    studio.eventually(lambda: studio.number("pose-x") < 0.4, True)


def test_it_fits_below_floor_plots_and_text_and_axe_has_no_complaint(studio: Studio) -> None:
    drive(studio)
    press(studio["past-run-slider"], 0.3)
    for opener, shown in (
        (None, "past-run"),
        ("plots-toggle", "plot"),
        ("ir-toggle", "python-text"),
    ):
        if opener:
            studio[opener].click()
        for width, height in _SIZES:
            layout = f"{shown}, {width} x {height}"
            studio.page.set_viewport_size({"width": width, "height": height})
            studio.wait_for_screen(shown)
            strip, floor = (box_of(studio[name]) for name in ("past-run", "scene"))
            assert strip["y"] + strip["height"] <= height - 60, layout
            assert floor["height"] > 100, layout
            assert [one for one in cut(studio, shown) if "program-name" not in one] == [], layout
            assert violations(studio, shown, every_theme=width == _SIZES[0][0]) == [], layout
