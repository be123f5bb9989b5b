"""The page during a run: speech, questions, variables, marks, trails and beeps."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

# Number of pixels of the floor with nearly this colour.
_PIXELS = """(wanted) => {
  const canvas = document.querySelector('[data-testid=scene]');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let at = 0; at < data.length; at += 4) {
    if (wanted.every((value, part) => Math.abs(value - data[at + part]) < 6)) count++;
  }
  return count;
}"""
# Records in the page whether more pixels were ever drawn: a check from outside may come too late.
_WATCH_PIXELS = f"""([wanted, most]) => {{
  window.wasSeen = false;
  const pixels = {_PIXELS};
  const look = () => {{
    window.wasSeen = pixels(wanted) > most;
    if (!window.wasSeen) requestAnimationFrame(look);
  }};
  look();
}}"""
RED, GREEN = (215, 40, 31), (35, 154, 69)
MARK_X, MARK_O = (122, 31, 162), (179, 71, 0)
YELLOW_FLOOR = (244, 200, 29)
INK = (33, 31, 27)
# pixels of the symbol of a beep; the robot itself has some pixels of this colour
SIGN_PIXELS = 2000

# The tones that the page has started.
_COUNT_TONES = """() => {
  window.tones = 0;
  const { start } = AudioScheduledSourceNode.prototype;
  AudioScheduledSourceNode.prototype.start = function (...when) {
    window.tones++;
    return start.apply(this, when);
  };
}"""


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def pixels(studio: Studio, colour: tuple[int, int, int]) -> int:
    return int(studio.page.evaluate(_PIXELS, list(colour)))


def tones(studio: Studio) -> int:
    return int(studio.page.evaluate("window.tones"))


def newest_run(studio: Studio) -> str:
    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    return str(studio.api(f"/groups/{group}/runs?limit=1")["runs"][0]["id"])


def recorded_events(studio: Studio) -> list[str]:
    """Returns the types of the newest run's events on the server's disk."""
    events = studio.api(f"/runs/{newest_run(studio)}/events")["events"]
    return [event["type"] for event in events]


def run_to_the_end(studio: Studio) -> None:
    studio.run()
    studio.wait_for_phase("finished")


def test_what_the_robot_says_is_listed_with_the_newest_in_sight(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(
        studio, 'for n in steps(1, 30):\n    robot.say(join("volta ", n))\nrobot.wait(600)\n'
    )
    expect(studio["talk"]).to_have_count(0)
    studio.run()
    expect(studio["talk-line"]).to_have_count(30, timeout=RUN_MS)
    expect(studio["talk-line"].last).to_contain_text("volta 30")
    expect(studio["talk-line"].last).to_be_in_viewport()
    expect(studio["status-line"]).to_contain_text("Diz: “volta 30”")
    studio["stop"].click()
    studio.wait_for_phase("stopped")
    expect(studio["talk-line"]).to_have_count(30)


def test_a_question_waits_for_its_answer(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(
        studio, 'lado = robot.ask("Quantos metros?")\nrobot.move_forward(lado)\nrobot.wait(1)\n'
    )
    studio.run()
    expect(studio["question-text"]).to_have_text("Quantos metros?", timeout=RUN_MS)
    expect(studio["status-line"]).to_contain_text("Esperando a resposta")
    expect(studio["answer"]).to_be_focused()
    expect(studio["send-answer"]).to_be_disabled()
    studio.page.keyboard.type("0,25")
    studio.page.keyboard.press("Enter")
    expect(studio["question"]).to_have_count(0)
    expect(studio["watch-value"]).to_have_text("0,25")
    studio.wait_for_phase("finished")
    studio.expect_number("pose-x", pytest.approx(0.25, abs=0.002))
    studio.expect_each(studio["talk-line"], "data-kind", ["asked", "answered"])


def test_only_pages_of_the_program_answer_its_question(
    studio: Studio, open_studio: OpenStudio
) -> None:
    studio.enter_new_group()
    write_program(studio, 'n = robot.ask("Quantos?")\n')
    other, same = open_studio(), open_studio()
    other.enter_new_group()
    same.page.goto(studio.page.url)
    same.wait_until_open()

    studio.run()
    expect(same["question"]).to_be_visible(timeout=RUN_MS)
    expect(studio["question"]).to_be_visible()
    other.wait_for_phase("running")
    expect(other["question"]).to_have_count(0)
    same["answer"].fill("três")
    same["send-answer"].click()
    studio.wait_for_phase("finished")
    expect(studio["question"]).to_have_count(0)
    expect(studio["talk-line"].last).to_contain_text("três")


def test_stop_closes_a_question(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, 'n = robot.ask("Quantos?")\n')
    studio.run()
    expect(studio["question"]).to_be_visible(timeout=RUN_MS)
    studio["stop"].click()
    studio.wait_for_phase("stopped")
    expect(studio["question"]).to_have_count(0)


def test_variables_are_watched_as_they_change(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(
        studio,
        'nome = "Ana"\nlista = [1, 2.5]\nfor n in steps(1, 3):\n    robot.wait(2)\n',
    )
    studio.run()
    count = studio["watch-value"].and_(studio.page.locator('[data-name="n"]'))
    for value in ("1", "2", "3"):
        expect(count).to_have_text(value, timeout=RUN_MS)
    expect(studio["watch-value"].nth(0)).to_have_text("“Ana”")
    expect(studio["watch-value"].nth(1)).to_have_text("[1; 2,5]")
    studio["stop"].click()
    studio.wait_for_phase("stopped")


def test_trails_and_marks_are_on_the_floor_live_and_replayed(studio: Studio, watch: Watch) -> None:
    watch.expect("willReadFrequently")  # warning about reading pixels, which only this test does
    studio.enter_new_group()
    write_program(
        studio,
        'robot.pen(True, "red")\nrobot.move_forward(0.6)\nrobot.mark("X")\n'
        'robot.pen(False)\nrobot.move_forward(0.6)\nrobot.mark("O")\n'
        'robot.pen(True, "green")\nrobot.move_forward(0.6)\n',
    )
    drawn = (RED, GREEN, MARK_X, MARK_O)
    assert [pixels(studio, colour) for colour in drawn] == [0, 0, 0, 0]
    studio.hurry()
    run_to_the_end(studio)
    studio.eventually(lambda: min(pixels(studio, colour) for colour in drawn) > 30, True)

    studio.page.goto(f"{studio.page.url.split('#')[0]}#/run/{newest_run(studio)}")
    slider = studio["replay-slider"]
    expect(slider).to_be_visible()
    studio.eventually(lambda: pixels(studio, RED), 0)
    slider.fill(slider.get_attribute("max") or "")
    studio.eventually(lambda: min(pixels(studio, colour) for colour in drawn) > 30, True)
    slider.fill("0")
    studio.eventually(lambda: [pixels(studio, colour) for colour in drawn], [0, 0, 0, 0])


def test_painted_floors_are_drawn(studio: Studio, watch: Watch) -> None:
    watch.expect("willReadFrequently")
    studio.enter_new_group()
    assert pixels(studio, YELLOW_FLOOR) == 0
    studio["world"].select_option("tic_tac_toe")
    studio.eventually(lambda: pixels(studio, YELLOW_FLOOR) > 10_000, True)


def test_beeps_are_heard_unless_somebody_wants_silence(studio: Studio) -> None:
    studio.page.evaluate(_COUNT_TONES)
    studio.enter_new_group()
    # sounds besides the beep are off until somebody wants them
    expect(studio["mute"]).to_have_attribute("data-muted", "true")
    write_program(studio, "robot.beep()\nrobot.wait(1)\nrobot.beep()\n")
    run_to_the_end(studio)
    studio.eventually(lambda: tones(studio), 2)

    studio["mute"].click()
    expect(studio["mute"]).to_have_attribute("data-muted", "true")
    run_to_the_end(studio)
    assert tones(studio) == 2
    studio.page.reload()
    expect(studio["mute"]).to_have_attribute("data-muted", "true")


def test_a_beep_is_seen_at_the_robot_also_without_sound_and_motion(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("willReadFrequently")
    studio.page.emulate_media(reduced_motion="reduce")
    studio.enter_new_group()
    write_program(
        studio,
        "robot.wait(0.5)\nfor n in steps(1, 3):\n    robot.beep()\n    robot.wait(0.3)\n"
        "robot.wait(2.5)\n",
    )
    studio["mute"].click()
    calm = pixels(studio, INK)
    studio.page.evaluate(_WATCH_PIXELS, [list(INK), calm + SIGN_PIXELS])
    studio.run()
    expect(studio["status-line"]).to_contain_text("Apito × 3", timeout=RUN_MS)
    expect(studio["talk-line"]).to_have_count(1)
    expect(studio["talk-line"]).to_contain_text("Apito × 3")
    studio.wait_for_phase("finished")
    assert studio.page.evaluate("window.wasSeen")
    studio.eventually(lambda: pixels(studio, INK) < calm + SIGN_PIXELS, True)

    studio.page.evaluate("run => { location.hash = `#/run/${run}` }", newest_run(studio))
    slider = studio["replay-slider"]
    for tick, is_shown in (("20", True), ("5", False), ("80", False), ("20", True)):
        slider.fill(tick)
        studio.eventually(lambda: pixels(studio, INK) > calm + SIGN_PIXELS, is_shown)
    studio.page.wait_for_timeout(1500)  # longer than the symbol of a beep shows
    assert pixels(studio, INK) > calm + SIGN_PIXELS  # visible while this time of the run is shown


def test_a_replay_beeps_unless_it_hurries(studio: Studio) -> None:
    studio.page.evaluate(_COUNT_TONES)
    studio.enter_new_group()
    write_program(studio, "robot.wait(0.3)\nrobot.beep()\nrobot.wait(1)\nrobot.beep()\n")
    run_to_the_end(studio)
    studio.page.evaluate("run => { location.hash = `#/run/${run}` }", newest_run(studio))
    for speed, n_tones in (("1", 4), ("16", 4)):
        studio["replay-speed"].select_option(speed)
        studio["replay-play"].click()
        slider = studio["replay-slider"]
        expect(slider).to_have_value(slider.get_attribute("max") or "")
        studio.eventually(lambda: tones(studio), n_tones)


def test_a_page_reloaded_in_the_middle_of_a_run_knows_what_was_said(studio: Studio) -> None:
    studio.enter_new_group()
    write_program(studio, 'n = 4\nrobot.say("Olá")\nresposta = robot.ask("E agora?")\n')
    studio.run()
    expect(studio["question"]).to_be_visible(timeout=RUN_MS)
    studio.eventually(lambda: "asked" in recorded_events(studio), True)
    studio.page.reload()
    expect(studio["question-text"]).to_have_text("E agora?")
    studio["answer"].fill("fim")
    studio["send-answer"].click()
    studio.wait_for_phase("finished")
    studio.expect_each(studio["talk-line"], "data-kind", ["said", "asked", "answered"])
    expect(studio["watch-value"]).to_have_text(["4", "“fim”"])
