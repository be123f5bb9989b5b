"""In narrow windows the studio cuts nothing, no control covers another, and the program stays in view."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.blocks import box_of
from tests.e2e.layout_faults import layout_faults
from tests.e2e.made_program import enter_made_group
from tests.e2e.past_lesson import Step
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(240)]

SIZES = [(683, 768), (800, 1280), (1024, 768)]
PATH: list[Step] = [("move_forward", -1), ("turn", 90)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def resize(studio: Studio, size: tuple[int, int], shows: str = "editor") -> None:
    studio.page.set_viewport_size({"width": size[0], "height": size[1]})
    studio.wait_for_screen(shows)


def expect_sound(studio: Studio, state: str, shows: str = "editor") -> None:
    """Checks the studio as it is, in each size and two languages; the program's name may be shortened."""
    found: dict[str, list[str]] = {}
    for language in ("pt-BR", "fr"):
        studio.choose_language(language)
        for size in SIZES:
            resize(studio, size, shows)
            if faults := [one for one in layout_faults(studio.page) if "program-name" not in one]:
                found[f"{state}, {language}, {size}"] = faults
    assert found == {}


def test_at_a_zoom_of_200_percent_the_studio_has_no_faults_of_layout(studio: Studio) -> None:
    enter_made_group(studio, PATH, activity="square")
    expect_sound(studio, "mission")
    studio["step"].click()
    studio.wait_for_phase("paused")
    expect_sound(studio, "paused before a block")
    studio["plots-toggle"].click()
    expect(studio["plots"]).to_be_visible()
    expect_sound(studio, "plots")
    studio["plots-toggle"].click()
    studio["stop"].click()
    studio.wait_for_phase("stopped")
    studio["help"].click()
    expect(studio["help-search"]).to_be_visible()
    expect_sound(studio, "help")


def test_without_a_mission_world_and_robot_are_chosen_in_a_narrow_window(studio: Studio) -> None:
    enter_made_group(studio, PATH)
    expect_sound(studio, "free")
    resize(studio, SIZES[0])
    icon = box_of(studio["world-change"].locator(".icon"))
    assert icon["width"] > 16
    studio["world-change"].click()
    expect(studio["world-begin"]).to_be_visible()
    expect_sound(studio, "world editor", "world-begin")


def test_a_narrower_window_leaves_the_start_of_the_program_in_view(studio: Studio) -> None:
    enter_made_group(studio, PATH)
    studio.choose_level(1)
    expect(studio.page.locator(".blocklyToolboxFlyout")).to_be_visible()
    resize(studio, SIZES[0])
    expect(studio.page.locator(".blocklyToolboxFlyout")).to_be_hidden()
    toolbox = box_of(studio.page.locator(".blocklyToolbox"))
    assert box_of(studio.blocks.start())["x"] > toolbox["x"] + toolbox["width"]


def test_a_bubble_moves_with_the_edge_of_a_narrower_window(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 60)], speed=10)
    studio.run()
    studio.wait_for_phase("failed")
    bubble = studio.blocks.fault_text()
    expect(bubble).to_be_visible()
    block = box_of(studio.blocks.by_text("andar para frente"))
    assert box_of(bubble)["x"] > block["x"] + block["width"]
    resize(studio, SIZES[-1])
    edge = box_of(studio["splitter"])["x"]
    studio.eventually(lambda: box_of(bubble)["x"] + box_of(bubble)["width"] < edge, True)
