"""All screens of the program, and how each is reached."""

from collections.abc import Callable
from typing import Any, NamedTuple

from playwright.sync_api import Error

from scripts.screenshots import pupils, real_robot
from scripts.screenshots.camera import Photographer
from scripts.screenshots.lesson import CALIBRATED, TRIED, Past
from scripts.screenshots.programs import SQUARE
from scripts.screenshots.pupils import Seed
from tests.e2e.past_lesson import workspace_of

MISSION = {"world": "empty_room", "speed": 10, "activity": "square"}


class School(NamedTuple):
    """The data of all screens, and the page that shows them."""

    camera: Photographer
    seeded: Seed
    past: Past


Reach = Callable[[School], object]


def photograph(school: School, screens: dict[str, Reach], wanted: tuple[str, ...]) -> None:
    """Takes each screen whose name begins with one of `wanted`; one that is not reached is noted as a fault."""
    camera = school.camera
    for name, reach in screens.items():
        if not name.startswith(wanted):
            continue
        try:
            camera.page.reload()
            reach(school)
            camera.round(name)
        except Error as error:
            camera.note(f"{name}: not reached: {error.message.splitlines()[0]}")
        camera.page.unroute_all()
        camera.page.emulate_media(media="screen")
        camera.end_tour()
        camera.stop()


def at(address: str, shows: str) -> Reach:
    """A screen with an address, complete when it shows an element."""

    def reach(school: School) -> None:
        camera, past = school.camera, school.past
        camera.go(f"#/{address.format(seeded=school.seeded, past=past)}")
        camera.of(shows).first.wait_for()
        camera.page.wait_for_timeout(400)

    return reach


def then(reach: Reach, *presses: str) -> Reach:
    """A screen, after elements were pressed: test ids, or selectors."""

    def further(school: School) -> None:
        reach(school)
        for press in presses:
            css = press if "[" in press else f"[data-testid={press}]"
            school.camera.page.locator(css).first.click()

    return further


def _program(name: str) -> Reach:
    return lambda school: school.camera.open_program(school.seeded.programs[name])


def _running(name: str) -> Reach:
    def reach(school: School) -> None:
        _program(name)(school)
        school.camera.press_run()
        school.camera.wait_for_phase("running")
        school.camera.page.wait_for_timeout(3_000)

    return reach


def _debug(school: School) -> None:
    """A run that waits before its second block, with the controls of the highest level."""
    _program("Estrela")(school)
    camera = school.camera
    camera.of("level").select_option("3")
    for _ in range(2):
        camera.press("step")
        camera.wait_for_phase("paused")


def _mission(blocks: dict[str, Any]) -> Reach:
    """A run of the mission of the square that has ended."""

    def reach(school: School) -> None:
        camera, seeded = school.camera, school.seeded
        program = pupils.save(camera, seeded.group, "Missão", blocks, MISSION)
        camera.open_program(program)
        camera.press_run()
        camera.wait_for_phase("finished", "failed")
        camera.page.locator(
            "[data-testid=mission-done], [data-testid=advice-block]"
        ).first.wait_for()
        camera.page.wait_for_timeout(2_500)  # the celebration

    return reach


def _sign(school: School) -> None:
    _program("Letra B")(school)
    school.camera.press_run()
    hand(school)


def hand(school: School) -> None:
    """Waits until the webcam shows a hand."""
    page = school.camera.page
    page.locator("[data-testid=camera-picture][data-state=on]").wait_for()
    page.locator(".skeleton__hand").first.wait_for()


def _practice(school: School) -> None:
    school.camera.go("#/practice")
    hand(school)


def _world(school: School) -> None:
    _program("Estrela")(school)
    school.camera.of("world").select_option("empty_room")
    school.camera.press("world-change")


def _furnished(school: School) -> None:
    _world(school)
    camera = school.camera
    camera.of("world-begin").select_option("furnished_room")
    camera.page.locator("[data-testid=world-thing][data-kind=box]").nth(2).focus()


def _world_fault(school: School) -> None:
    _furnished(school)
    for axis in ("x", "y"):  # counted from the start
        school.camera.of(f"world-{axis}").fill("0")
    school.camera.of("world-fault-note").wait_for()


def _robots(school: School) -> None:
    """All 50 robots have driven."""
    _program("Até a esquina")(school)
    camera = school.camera
    camera.of("level").select_option("3")
    camera.press("cloud")
    camera.page.locator("[data-testid=cloud-line][data-state=over]").wait_for(timeout=60_000)


def _calibrated(school: School) -> None:
    _program("Triângulo")(school)
    camera = school.camera
    camera.of("level").select_option("3")
    camera.of("robot-model").select_option(label=CALIBRATED)


def _example(name: str) -> Reach:
    def reach(school: School) -> None:
        _EXAMPLES(school)
        camera = school.camera
        camera.page.locator(f"[data-testid=example-card][data-example={name}]").click()
        camera.of("run").wait_for()

    return reach


def _board(school: School) -> None:
    """The board game waits for the sign of X."""
    _example("board_game")(school)
    school.camera.press_run()
    school.camera.of("capture").wait_for()


def _board_question(school: School) -> None:
    _board(school)
    school.camera.page.locator("[data-testid=capture-letter][data-letter=A]").click()
    school.camera.of("question-text").wait_for(timeout=60_000)


def _real_run(school: School) -> None:
    real_robot.drive(school.camera, school.seeded)


def _real_tape(school: School) -> None:
    _real_run(school)
    real_robot.measure(school.camera)


def _real_replay(school: School) -> None:
    """The newest run, and no real robot for the screens after it."""
    camera = school.camera
    real_robot.forget(camera)
    runs = camera.call("GET", f"/api/groups/{school.seeded.group}/runs?limit=1")["runs"]
    at(f"run/{runs[0]['id']}", "replay-slider")(school)
    camera.press("prediction-toggle")


def _late(reach: Reach) -> Reach:
    """A replay shortly before its end."""

    def further(school: School) -> None:
        reach(school)
        slider = school.camera.of("replay-slider")
        slider.fill(str(int(int(slider.get_attribute("max")) * 0.9)))

    return further


def _solid(reach: Reach) -> Reach:
    def further(school: School) -> None:
        reach(school)
        school.camera.page.locator('[data-testid=floor-view][data-value="true"]').first.click()
        school.camera.of("scene-3d").first.wait_for()
        school.camera.page.wait_for_timeout(2_000)

    return further


def _flat(school: School) -> None:
    """Leaves the floor in 3D, which every later screen would show."""
    _program("Quadrado")(school)
    school.camera.page.locator('[data-testid=floor-view][data-value="false"]').first.click()


def _lost(school: School) -> None:
    """The server no longer answers."""
    at("work/{seeded.group}", "program-card")(school)
    school.camera.page.route("**/api/**", lambda route: route.abort())
    school.camera.press("open-activities")


_START = at("", "group-card")
WORK = at("work/{seeded.group}", "program-card")
_REPLAY = at("run/{past.runs[1]}", "replay-slider")
_EXAMPLES = then(at("activities/{seeded.group}", "example-card"), "to-examples")

PUPILS: dict[str, Reach] = {
    "start": _START,
    "start-new": then(_START, "create-group"),
    "group": WORK,
    "group-edit": then(WORK, "group-edit"),
    "group-runs": at("work/{past.group}", "run-card"),
    "album": at("album/{past.group}", "album-place"),
    "album-empty": at("album/{seeded.group}", "album-place"),
    "activities": at("activities/{seeded.group}", "activity-card"),
    "examples": _EXAMPLES,
    "tour": then(
        lambda school: school.camera.open_program(school.seeded.empty), "help", "help-tour"
    ),
    "tour-move": then(
        lambda school: school.camera.open_program(school.seeded.empty),
        "help",
        "help-tour",
        "tour-go",
    ),
    "studio-empty": lambda school: school.camera.open_program(school.seeded.empty),
    "studio-program": _program("Quadrado"),
    "studio-running": _running("Estrela"),
    "studio-debug": _debug,
    "studio-text": then(_program("Quadrado"), "ir-toggle"),
    "studio-plots": then(_running("Quadrado"), "plots-toggle"),
    "studio-tools": then(_program("Quadrado"), "scene-tools"),
    "studio-fault": then(_program("Com um erro"), "[data-does=run]"),
    "studio-help": then(_program("Quadrado"), "help"),
    "mission-sheet": then(at("activities/{seeded.group}", "activity-card"), "activity-card"),
    "mission-failed": _mission(workspace_of(TRIED)),
    "mission-passed": _mission(SQUARE),
    "mission-short": _mission(workspace_of([("move_forward", 1)])),
    "cloud": _robots,
    "calibrated": _calibrated,
    "sign": _sign,
    "board": _board,
    "board-question": _board_question,
    "practice": _practice,
    "practice-game": then(_practice, "[data-testid=practice-mode] >> nth=1"),
    "world": _world,
    "world-full": _furnished,
    "world-fault": _world_fault,
    "replay": _REPLAY,
    "replay-failed": at("run/{past.runs[0]}", "replay-slider"),
    "versions": at("versions/{past.program}", "version-shown"),
    "differences": at(
        "differences/{past.program}/{past.versions[0]}/{past.versions[1]}", "difference"
    ),
    "3d-replay": then(_solid(_REPLAY), "[data-testid=floor-camera][data-value=orbit]"),
    "3d-path": _solid(_late(_REPLAY)),
    "3d-studio": _solid(_program("Quadrado")),
    "3d-eye": then(_solid(_late(_REPLAY)), "[data-testid=floor-camera][data-value=eye]"),
    "flat": _flat,
    "real": lambda school: real_robot.choose(school.camera, school.seeded),
    "real-check": then(
        lambda school: real_robot.choose(school.camera, school.seeded), "[data-does=run]"
    ),
    "real-asked": _real_run,
    "real-tape": _real_tape,
    "real-told": then(_real_tape, "tape-save"),
    "real-replay": _real_replay,
    "manuals": at("manuals", "manuals"),
    "manual": at("manuals/teacher", "manual-section"),
    "notices": at("notices", "notices-back"),
    "error-program": at("program/none", "not-loaded"),
    "error-lost": _lost,
}
