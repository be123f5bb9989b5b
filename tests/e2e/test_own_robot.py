"""The robot of a group: its colour, pattern and name on the floor, what it says there, and its celebration."""

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_exchange import PIN, at_the_files, save_bundle
from tests.e2e.test_missions import put_move
from tests.e2e.test_show import newest_run
from tests.e2e.watch import Watch
from tests.e2e.world_board import WorldBoard

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

PLUM, PLUM_RGB = "#a03561", (160, 53, 97)
BLUE_RGB = (31, 111, 139)  # the first colour, which a new group has unless it chooses another
RED_RGB = (155, 28, 31)  # a robot without a group
CONFETTI_RGB = (244, 200, 29)
HULL_PIXELS = 60  # of the robot at its smallest, beside pattern, deck and wheels

# Number of pixels of the floor with nearly this colour. Reads a copy, as Chromium warns of reading the floor often.
_PIXELS = """([wanted, canvas]) => {
  const floor = document.querySelector(canvas);
  if (!floor) return 0;
  const copy = new OffscreenCanvas(floor.width, floor.height).getContext('2d', { willReadFrequently: true });
  copy.drawImage(floor, 0, 0);
  const { data } = copy.getImageData(0, 0, floor.width, floor.height);
  let count = 0;
  for (let at = 0; at < data.length; at += 4) {
    if (wanted.every((value, part) => Math.abs(value - data[at + part]) < 6)) count++;
  }
  return count;
}"""
# Records the texts that the page draws on canvases, with their times.
_RECORD_TEXTS = """() => {
  window.drawn = [];
  const { fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
    window.drawn.push(text);
    return fillText.call(this, text, ...place);
  };
}"""
# Whether a text was drawn since the record was emptied.
_DRAWN = "(text) => window.drawn.some((one) => one.includes(text))"


def pixels(
    studio: Studio, colour: tuple[int, int, int], canvas: str = "[data-testid=scene]"
) -> int:
    return int(studio.page.evaluate(_PIXELS, [list(colour), canvas]))


def value_of(studio: Studio, test_id: str, value: str) -> Any:
    return studio.page.locator(f'[data-testid="{test_id}"][data-value="{value}"]')


def choose_robot(studio: Studio, name: str) -> None:
    studio["choose-robot"].click()
    value_of(studio, "group-color", PLUM).click()
    value_of(studio, "robot-pattern", "dots").click()
    studio["robot-name"].fill(name)
    studio.page.keyboard.press("Escape")
    expect(studio["robot-fields"]).to_have_count(0)


def robot_is_plum(studio: Studio) -> None:
    studio.eventually(lambda: pixels(studio, PLUM_RGB) > HULL_PIXELS, True)
    assert pixels(studio, BLUE_RGB) == pixels(studio, RED_RGB) == 0


def test_a_group_chooses_its_robot_which_is_the_same_later_and_on_another_pc(
    open_studio: OpenStudio, open_pc: OpenStudio, app: AppProcess, watch: Watch, tmp_path: Path
) -> None:
    studio = open_studio()
    studio["suggest-name"].click()
    expect(studio["group-name"]).to_have_value("Botos")
    studio["choose-robot"].click()
    assert violations(studio, "robot-fields") == []
    studio.page.keyboard.press("Escape")
    choose_robot(studio, "Faísca")
    studio["create-group"].click()
    studio.wait_until_open()
    robot_is_plum(studio)
    (group,) = studio.api("/groups")["groups"]
    robot = {"color": PLUM, "robot_name": "Faísca", "robot_pattern": "dots"}
    assert group.items() >= robot.items()
    watch.settle(studio.page)
    studio.page.context.close()

    app.stop()
    app.start()
    studio = open_studio()
    studio["group-card"].click()
    studio.wait_until_open()
    robot_is_plum(studio)
    studio.send("PUT", "/teacher/pin", {"pin": PIN})
    save_bundle(studio, tmp_path)

    other = open_pc()
    at_the_files(other, tmp_path)
    other["merge-files"].click()
    expect(other["merge-results"].get_by_role("listitem")).to_have_count(1)
    assert other.api("/groups")["groups"][0].items() >= robot.items()
    other["home"].click()
    other["group-card"].click()
    other.wait_until_open()
    robot_is_plum(other)


def test_groups_of_a_class_differ_without_choosing(studio: Studio) -> None:
    for name in ("Botos", "Araras", "Onças"):
        studio["group-name"].fill(name)
        studio["create-group"].click()
        studio.wait_until_open()
        studio["home"].click()
        expect(studio["group-card"].filter(has_text=name)).to_be_visible()
    groups = studio.api("/groups")["groups"]
    for column in ("color", "picture", "robot_pattern"):
        assert len({group[column] for group in groups}) == 3
    studio["suggest-name"].click()
    expect(studio["group-name"]).to_have_value("Tatus")


def test_a_robot_gets_another_name_and_pattern_at_the_head_of_the_group_s_work(
    studio: Studio,
) -> None:
    studio.enter_group("Os Tatus")
    studio["open-work"].click()
    studio["group-edit"].click()
    value_of(studio, "robot-pattern", "star").click()
    studio["robot-name"].fill("Relâmpago Azul-Marinho do Nono Ano 🤖 do Turno da Manhã ✨✨✨✨")
    expect(studio["robot-name-shown"]).to_contain_text("Relâmpago")
    assert violations(studio, "group-save") == []
    studio["group-save"].click()
    expect(studio["group-edit"]).to_be_visible()
    (group,) = studio.api("/groups")["groups"]
    assert group["robot_pattern"] == "star"
    assert group["robot_name"].startswith("Relâmpago Azul-Marinho")


def test_what_the_robot_says_after_a_beep_is_in_its_bubble_also_in_the_replay(
    studio: Studio,
) -> None:
    studio.enter_group("Os Tatus")
    studio.page.evaluate(_RECORD_TEXTS)
    write_program(studio, 'robot.beep()\nrobot.say("Cheguei")\nrobot.move_forward(1)\n')
    studio.run()
    studio.page.wait_for_function(_DRAWN, arg="Cheguei")
    studio.page.evaluate("window.drawn.length = 0")
    # each frame draws the bubble, and no other words, while the beep still sounds
    studio.page.wait_for_function(_DRAWN, arg="Cheguei")
    assert not studio.page.evaluate(_DRAWN, "Apito")
    expect(studio["talk-line"].last).to_contain_text("Cheguei")
    studio.page.evaluate("window.drawn.length = 0")
    studio.wait_for_phase("finished")
    studio.page.wait_for_function(_DRAWN, arg="Os Tatus")  # its name, where the bubble was
    studio.page.evaluate("run => { location.hash = `#/run/${run}` }", newest_run(studio))
    studio["replay-play"].click()
    studio.page.evaluate("window.drawn.length = 0")
    studio.page.wait_for_function(_DRAWN, arg="Cheguei")


def test_a_solved_mission_is_celebrated_on_the_floor_for_two_seconds(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(reduced_motion="reduce")
    studio.enter_group("Os Tatus")
    studio["open-activities"].click()
    studio.page.locator("[data-testid=activity-card][data-activity=pushing]").click()
    studio.wait_until_open()
    put_move(studio, "5,6")
    studio.choose_level(2)
    studio["speed"].select_option("10")
    assert pixels(studio, CONFETTI_RGB) == 0
    studio.run()
    celebrating = studio.page.locator("[data-testid=scene][data-celebrating]")
    expect(celebrating).to_have_count(1, timeout=RUN_MS)
    studio.eventually(lambda: pixels(studio, CONFETTI_RGB) > 0, True)
    expect(studio["mission-done"]).to_be_visible()
    expect(celebrating).to_have_count(0)
    studio.eventually(lambda: pixels(studio, CONFETTI_RGB), 0)


def test_the_world_editor_shows_the_robot_of_the_group(studio: Studio) -> None:
    choose_robot(studio, "Faísca")
    studio.enter_group("Tatus")
    board = WorldBoard(studio)
    board.open()
    canvas = ".world-editor .scene__canvas"
    studio.eventually(lambda: pixels(studio, PLUM_RGB, canvas) > HULL_PIXELS, True)
    assert pixels(studio, RED_RGB, canvas) == 0
