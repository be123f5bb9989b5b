"""A group's first lesson: a square of three blocks, run, stored and replayed."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]


def test_a_group_drags_a_square_and_sees_the_robot_drive_it(studio: Studio) -> None:
    studio.enter_group("Os Tatus", level=None)
    studio.build_square(side="0,3")

    [loop] = studio.commands()
    assert loop["action"] == "repeat"
    assert loop["times"] == 4
    move, turn = loop["commands"]
    assert (move["action"], move["distance"]) == ("move_forward", 0.3)
    assert (turn["action"], turn["angle"]) == ("turn", 90)

    studio.wait_for_screen("scene")
    floor_before = studio["scene"].screenshot()
    studio.run()
    active = studio.blocks.running()
    expect(active).to_have_attribute("data-id", move["block"], timeout=RUN_MS)
    expect(active).to_have_attribute("data-id", turn["block"], timeout=RUN_MS)
    expect(studio["status-line"]).to_contain_text("Girando")
    studio.wait_for_phase("finished")

    expect(active).to_have_count(0)
    for axis in ("pose-x", "pose-y"):
        studio.expect_number(axis, pytest.approx(0, abs=0.001))
    # the robot is at its start pose again, so the difference on the floor is its path
    studio.eventually(lambda: studio["scene"].screenshot() != floor_before, True)
    [run] = studio.api(f"/groups/{_group_of(studio)}/runs")["runs"]
    assert run["state"] == "finished"
    assert run["closing_error_m"] < 1e-4
    assert run["path_length_m"] == pytest.approx(1.2, abs=0.01)


def test_a_program_and_its_run_are_there_the_next_day(
    studio: Studio, open_studio: OpenStudio, app: AppProcess
) -> None:
    studio.enter_group("Os Tatus")
    studio.build_square(side="0,3")
    [loop] = studio.commands()
    studio["speed"].select_option("10")
    studio.run()
    studio.wait_for_phase("finished")
    studio.page.context.close()

    app.stop()
    app.start()
    reopened = open_studio()
    reopened["group-card"].filter(has_text="Os Tatus").click()
    reopened.wait_until_open()
    assert reopened.commands() == [loop]

    reopened["open-work"].click()
    card = reopened["run-card"]
    expect(card).to_have_count(1)
    expect(card).to_have_attribute("data-state", "finished")
    card.click()

    move, turn = loop["commands"]
    slider = reopened["replay-slider"]
    expect(slider).to_be_visible()
    ticks = _first_ticks(reopened)
    slider.fill(str(ticks[turn["block"]] + 1))
    expect(reopened.blocks.running()).to_have_attribute("data-id", turn["block"])
    reopened.expect_number("pose-x", pytest.approx(0.3, abs=0.01))
    slider.fill(str(ticks[move["block"]] + 1))
    expect(reopened.blocks.running()).to_have_attribute("data-id", move["block"])
    reopened.eventually(lambda: reopened.number("pose-x") < 0.05, True)


def test_the_link_of_a_second_start_opens_the_same_app(
    studio: Studio, open_studio: OpenStudio, app: AppProcess, watch: Watch
) -> None:
    watch.expect("(UNAUTHORIZED)")  # response for the address that was used before
    studio.enter_group("Os Tatus")
    other = open_studio(app.fresh_link())
    expect(other["group-card"]).to_have_count(1)
    used = open_studio(app.link)
    expect(used.page.get_by_role("heading")).to_be_visible()
    expect(used["group-card"]).to_have_count(0)


def _group_of(studio: Studio) -> str:
    return str(studio.api(f"/programs/{studio.program_id}")["group_id"])


def _first_ticks(studio: Studio) -> dict[str, int]:
    """Returns the tick of the first start of each block in the shown run."""
    run = studio.page.url.rsplit("/", 1)[-1]
    ticks: dict[str, int] = {}
    for event in studio.api(f"/runs/{run}/events")["events"]:
        if event["type"] == "block_started" and event["block"]:
            ticks.setdefault(event["block"], event["tick"])
    return ticks
