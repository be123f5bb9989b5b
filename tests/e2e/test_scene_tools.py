"""Tools of the floor: start pose, return to the start, ruler, protractor, sensors, follow, picture."""

from functools import partial
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, Response, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.blocks import box_of
from tests.e2e.made_program import enter_made_group
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

_PNG = b"\x89PNG\r\n\x1a\n"


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def named(studio: Studio, test_id: str, name: str) -> Locator:
    return studio.page.locator(f'[data-testid="{test_id}"][data-name="{name}"]')


def last_run(studio: Studio) -> Any:
    group = studio.api("/groups")["groups"][0]["id"]
    run = studio.api(f"/groups/{group}/runs?limit=1")["runs"][0]["id"]
    return studio.api(f"/runs/{run}")


def drag(studio: Studio, begin: tuple[float, float], end: tuple[float, float]) -> None:
    """Drags from one point of the floor to another, each as fractions of its width and height."""
    box = box_of(studio["scene"])
    places = [(box["x"] + box["width"] * x, box["y"] + box["height"] * y) for x, y in (begin, end)]
    mouse = studio.page.mouse
    mouse.move(*places[0])
    mouse.down()
    mouse.move(*places[1], steps=5)
    mouse.up()


def robot_place(studio: Studio) -> tuple[float, float]:
    """Position of the drawn robot, the only object in its group's colour, as fractions of the floor's size."""
    owner = studio.api(f"/programs/{studio.program_id}")["group_id"]
    groups = studio.api("/groups")["groups"]
    color = next(group["color"] for group in groups if group["id"] == owner)
    found = studio.page.evaluate(
        """(wanted) => {
            const canvas = document.querySelector('[data-testid=scene]');
            const {width, height} = canvas;
            const {data} = canvas.getContext('2d').getImageData(0, 0, width, height);
            let [sumX, sumY, count] = [0, 0, 0];
            for (let at = 0; at < data.length; at += 4) {
                if (wanted.some((value, part) => Math.abs(value - data[at + part]) > 6)) continue;
                sumX += (at / 4) % width;
                sumY += Math.floor(at / 4 / width);
                count++;
            }
            return [sumX / count / width, sumY / count / height];
        }""",
        list(bytes.fromhex(color[1:])),
    )
    return (found[0], found[1])


def test_a_start_set_by_keys_is_where_the_robot_begins(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 0.2)])
    studio["scene"].focus()
    for key in ("ArrowRight", "ArrowRight", "ArrowUp", ","):
        studio.page.keyboard.press(key)
    studio.hurry()
    studio.run()
    studio.wait_for_phase("finished")
    start = last_run(studio)["world_document"]["start"]
    assert start == {"x_m": 0.2, "y_m": 0.1, "heading_deg": 15.0}
    studio.expect_number("pose-x", pytest.approx(0.2, abs=0.02))

    studio["start-again"].click()
    studio.wait_for_phase("idle")
    studio.expect_number("pose-x", 0)
    studio["start-again"].click()
    expect(studio["start-again"]).to_be_disabled()
    studio.run()
    studio.wait_for_phase("finished")
    assert last_run(studio)["world_document"]["start"]["x_m"] == 0


def test_the_robot_is_dragged_to_another_start(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 0.2)])
    x, y = robot_place(studio)
    drag(studio, (x, y), (x + 0.2, y + 0.1))
    expect(studio["start-again"]).to_be_enabled()
    studio.hurry()
    studio.run()
    studio.wait_for_phase("finished")
    start = last_run(studio)["world_document"]["start"]
    assert start["x_m"] > 0.3
    assert start["y_m"] < -0.1
    assert start["heading_deg"] == 0
    for value in (start["x_m"], start["y_m"]):
        assert value * 10 == pytest.approx(round(value * 10))


def test_a_click_on_the_robot_changes_nothing(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 0.2)])
    place = robot_place(studio)
    drag(studio, place, place)
    expect(studio["start-again"]).to_be_disabled()


def test_the_ruler_measures_and_is_put_away(studio: Studio) -> None:
    studio.enter_new_group()
    studio["scene-tools"].click()
    named(studio, "measure-tool", "ruler").click()
    drag(studio, (0.2, 0.5), (0.5, 0.5))
    studio.eventually(lambda: studio.number("measure") > 0.5, True)
    studio.page.keyboard.press("Escape")
    expect(studio["measure"]).to_have_count(0)
    expect(named(studio, "measure-tool", "ruler")).to_have_attribute("aria-pressed", "false")


def test_the_ruler_is_laid_by_keys_from_the_robot(studio: Studio) -> None:
    studio.enter_new_group()
    studio["scene-tools"].click()
    named(studio, "measure-tool", "ruler").click()
    studio["scene"].focus()
    keyboard = studio.page.keyboard
    keyboard.press("Enter")
    for _ in range(5):
        keyboard.press("ArrowRight")
    keyboard.press("Enter")
    expect(studio["measure"]).to_have_attribute("data-value", "0.500")
    expect(studio["measure"]).to_have_text("0,50\u00a0m")


def test_the_protractor_tells_how_far_to_turn(studio: Studio) -> None:
    studio.enter_new_group()
    studio["scene-tools"].click()
    named(studio, "measure-tool", "protractor").click()
    studio["scene"].focus()
    keyboard = studio.page.keyboard
    for keys in ((), ("ArrowRight",) * 4, ("ArrowLeft",) * 4 + ("ArrowUp",) * 3):
        for key in keys:
            keyboard.press(key)
        keyboard.press("Enter")
    expect(studio["measure"]).to_have_attribute("data-value", "90.000")
    expect(studio["measure"]).to_have_text("90° à esquerda")


def test_following_ends_when_the_floor_is_moved(studio: Studio) -> None:
    studio.enter_new_group()
    studio["scene-tools"].click()
    follow = studio["follow"]
    follow.click()
    expect(follow).to_have_attribute("aria-pressed", "true")
    drag(studio, (0.2, 0.8), (0.3, 0.85))
    expect(follow).to_have_attribute("aria-pressed", "false")


@pytest.mark.parametrize("ring", ["sonar", "lidar"])
def test_sensors_are_drawn_before_and_after_a_run(studio: Studio, ring: str) -> None:
    enter_made_group(studio, [("move_forward", 0.2)], speed=10)
    studio["world"].select_option("furnished_room")
    studio["scene-tools"].click()
    studio.wait_for_screen(named(studio, "ring", ring))

    def is_as(before: str) -> bool:
        return studio.floor_picture() == before

    for phase in ("idle", "finished"):
        without = studio.floor_picture()
        named(studio, "ring", ring).click()
        studio.eventually(partial(is_as, without), False)
        named(studio, "ring", ring).click()
        studio.eventually(partial(is_as, without), True)
        if phase == "idle":
            studio.run()
            studio.wait_for_phase("finished")
            studio.wait_for_screen("past-run")


def test_sonar_is_asked_for_and_seen(studio: Studio) -> None:
    def is_subscription(response: Response) -> bool:
        request = response.request
        return request.url.endswith("/commands") and "subscribe" in (request.post_data or "")

    enter_made_group(studio, [("move_forward", 3)])
    studio["scene-tools"].click()
    named(studio, "ring", "sonar").click()
    with studio.page.expect_response(is_subscription) as asked:
        studio.run()
    assert asked.value.request.post_data_json == {"do": "subscribe", "sensors": ["sonar"]}
    # the response, because Stop may overtake a request
    with studio.page.expect_response(is_subscription) as ended:
        named(studio, "ring", "sonar").click()
    assert ended.value.request.post_data_json == {"do": "subscribe", "sensors": []}
    studio["stop"].click()
    studio.wait_for_phase("stopped")


def test_a_run_is_as_true_to_life_as_was_chosen(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 0.2)])
    studio["lifelike"].select_option("wheels")
    with studio.page.expect_request(
        lambda request: request.url.endswith("/api/runs") and request.method == "POST"
    ) as request_info:
        studio.run()
    body: Any = request_info.value.post_data_json
    assert (body["preset"], body["feedback"]) == ("realistic", "odometry")
    studio.wait_for_phase("finished")


def test_the_floor_is_saved_as_a_picture(studio: Studio) -> None:
    studio.enter_new_group()
    studio["scene-tools"].click()
    with studio.page.expect_download() as download:
        studio["scene-picture"].click()
    assert download.value.suggested_filename == "programa-1.png"
    assert Path(download.value.path()).read_bytes().startswith(_PNG)
