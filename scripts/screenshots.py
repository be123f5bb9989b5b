"""Takes a picture of every screen of the page from the real app, at several sizes, themes and languages.

    python scripts/screenshots.py FOLDER            every screen, for looking at
    python scripts/screenshots.py FOLDER --quick    Portuguese, light, 1366 x 768 only
    python scripts/screenshots.py docs/images --readme   the pictures of the README

The app runs on a throw-away data folder with groups, programs and runs made for the pictures.
"""

import argparse
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from playwright.sync_api import Browser, Page, sync_playwright

CHROMIUM = shutil.which("chromium-headless-shell") or "/usr/bin/chromium"
ARGUMENTS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
SIZES = {"1366x768": (1366, 768), "1024x768": (1024, 768), "1920x1080": (1920, 1080)}
THEMES = ("light", "dark", "contrast")
LANGUAGES = ("pt-BR", "en", "es")
PIN = "314159"

Block = dict[str, Any]


class Look(NamedTuple):
    """How one round of pictures looks."""

    size: str
    theme: str
    language: str

    @property
    def name(self) -> str:
        return f"{self.size}-{self.theme}-{self.language}"


QUICK = [Look("1366x768", "light", "pt-BR")]
ALL = [
    *(Look(size, "light", "pt-BR") for size in SIZES),
    *(Look("1366x768", theme, "pt-BR") for theme in THEMES[1:]),
    *(Look("1366x768", "light", language) for language in LANGUAGES[1:]),
    Look("1024x768", "contrast", "es"),
    Look("1920x1080", "dark", "en"),
]


def chain(*blocks: Block) -> Block:
    """Blocks one below the other, as Blockly keeps them."""
    first, *others = blocks
    return {**first, "next": {"block": chain(*others)}} if others else first


def forward(distance: float) -> Block:
    return {"type": "move_forward", "fields": {"DISTANCE": distance}}


def turn(angle: float, direction: str = "LEFT") -> Block:
    return {"type": "turn", "fields": {"DIRECTION": direction, "ANGLE": angle}}


def repeat(times: int, *blocks: Block) -> Block:
    return {
        "type": "repeat",
        "fields": {"TIMES": times},
        "inputs": {"DO": {"block": chain(*blocks)}},
    }


def sign(timeout: int) -> Block:
    return {"type": "classify_gestures", "fields": {"TIMEOUT": timeout}}


def when_sign(letter: str, *blocks: Block) -> Block:
    compare = {
        "type": "compare",
        "fields": {"OPERATOR": "=="},
        "inputs": {
            "A": {"block": {"type": "gesture_result"}},
            "B": {"block": {"type": "text_letter", "fields": {"TEXT": letter}}},
        },
    }
    inputs = {"CONDITION": {"block": compare}, "THEN": {"block": chain(*blocks)}}
    return {"type": "if", "inputs": inputs}


def wait(seconds: float) -> Block:
    return {"type": "wait", "fields": {"SECONDS": seconds}}


def workspace(*blocks: Block) -> dict[str, Any]:
    start: Block = {"type": "program_start", "x": 40, "y": 40}
    start["next"] = {"block": chain(*blocks)}
    return {"blocks": {"languageVersion": 0, "blocks": [start]}}


SQUARE = workspace(repeat(4, forward(1), turn(90)))
TRIANGLE = workspace(repeat(3, forward(1.5), turn(120)), wait(1))
STAR = workspace(repeat(5, forward(1.6), turn(144, "RIGHT")))
WALL = workspace(turn(90), forward(1.2), turn(90, "RIGHT"), forward(9))
SIGNS = workspace(sign(30), when_sign("B", repeat(4, forward(1), turn(90))), forward(0.5))
FAULTY = workspace(forward(1), {"type": "if", "inputs": {"THEN": {"block": turn(90)}}}, turn(45))


@contextmanager
def application(home: Path) -> Iterator[str]:
    """The app on its own data folder; gives the address that opens the page once."""
    command = [sys.executable, "-m", "pinel_desktop", "serve", "--port", "0"]
    environment = {**os.environ, "PINEL_HOME": str(home)}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as process:
        try:
            yield address_in(process)
        finally:
            process.send_signal(signal.SIGINT)
            process.wait(10)


def address_in(process: "subprocess.Popen[str]") -> str:
    assert process.stdout is not None
    for line in process.stdout:
        if found := re.search(r"http://\S+", line):
            return found[0]
    raise SystemExit("the app printed no address")


class Photographer:
    """Leads one page through the app and takes its pictures."""

    def __init__(self, browser: Browser, address: str, folder: Path) -> None:
        self.context = browser.new_context(viewport={"width": 1366, "height": 768})
        self.page: Page = self.context.new_page()
        self.page.on("pageerror", lambda error: print(f"page error: {error}", file=sys.stderr))
        self.page.goto(address)
        self.origin = re.sub(r"(http://[^/]+).*", r"\1", address)
        self.folder = folder
        self.look = QUICK[0]

    def wear(self, look: Look) -> None:
        self.look = look
        width, height = SIZES[look.size]
        self.page.set_viewport_size({"width": width, "height": height})
        self.context.add_cookies([{"name": "pinel_theme", "value": look.theme, "url": self.origin}])
        self.page.reload()
        self.of("language").select_option(look.language)
        self.page.wait_for_timeout(300)

    def of(self, test_id: str) -> Any:
        return self.page.get_by_test_id(test_id)

    def take(self, name: str) -> None:
        self.page.mouse.move(2, 2)
        self.page.wait_for_timeout(350)
        self.page.screenshot(path=self.folder / f"{name}.png")

    def round(self, name: str) -> None:
        self.take(f"{self.look.name}-{name}")

    def call(self, method: str, path: str, body: object = None) -> Any:
        return self.page.evaluate(
            """async ([method, path, body]) => {
                const headers = {"Content-Type": "application/json"};
                const init = body ? {method, headers, body: JSON.stringify(body)} : {method};
                return (await fetch(path, init)).json();
            }""",
            [method, path, body],
        )

    def go(self, hash_: str) -> None:
        self.page.goto(f"{self.origin}/{hash_}")

    def open_program(self, program: str) -> None:
        self.go(f"#/program/{program}")
        self.page.locator(".blocklyBlockCanvas .blocklyDraggable").first.wait_for()
        self.page.wait_for_timeout(400)

    def press_run(self) -> None:
        self.page.locator("[data-testid=run][data-does=run]:enabled").click()

    def wait_for_phase(self, *phases: str) -> None:
        selector = ", ".join(f"[data-testid=scene][data-phase={phase}]" for phase in phases)
        self.page.locator(selector).wait_for(timeout=60_000)


class Seed(NamedTuple):
    """What was made for the pictures."""

    group: str
    empty: str
    programs: dict[str, str]
    run: str


def seed(camera: Photographer) -> Seed:
    """A class with its lesson, groups, programs and runs."""
    camera.call("PUT", "/api/teacher/pin", {"pin": PIN})
    classroom = camera.call("POST", "/api/classrooms", {"name": "9º A"})["id"]
    lesson = {"title": "Quadrados", "activity": "square"}
    camera.call("POST", f"/api/classrooms/{classroom}/lessons", lesson)
    camera.call("POST", "/api/teacher/leave")
    for name in ("Os Parafusos", "Equipe Beta", "Meninas do Robô", "Curto-circuito"):
        camera.call("POST", "/api/groups", {"name": name, "classroom_id": classroom})
    wanted = {"name": "Turma dos Quadrados", "classroom_id": classroom}
    group = camera.call("POST", "/api/groups", wanted)["id"]
    programs = {
        name: save(camera, group, name, blocks)
        for name, blocks in {
            "Quadrado": SQUARE,
            "Triângulo": TRIANGLE,
            "Estrela": STAR,
            "Até a parede": WALL,
            "Letra B": SIGNS,
            "Com um erro": FAULTY,
        }.items()
    }
    for name, seconds in {
        "Triângulo": 60,
        "Estrela": 3,
        "Até a parede": 60,
        "Quadrado": 60,
    }.items():
        drive(camera, programs[name], seconds)
    runs = camera.call("GET", f"/api/groups/{group}/runs?limit=1")["runs"]
    empty = camera.call("POST", f"/api/groups/{group}/programs", {"name": "Programa 7"})["id"]
    return Seed(group, empty, programs, runs[0]["id"])


def save(camera: Photographer, group: str, name: str, blocks: dict[str, Any]) -> str:
    """Opened once in the editor, which makes the document that the robot gets."""
    program: str = camera.call("POST", f"/api/groups/{group}/programs", {"name": name})["id"]
    content = {"workspace": blocks, "document": None}
    camera.call("POST", f"/api/programs/{program}/versions", content)
    return program


def drive(camera: Photographer, program: str, seconds: int) -> None:
    """Runs a program to its end, or stops it after some seconds."""
    camera.open_program(program)
    camera.press_run()
    camera.wait_for_phase("running")
    if seconds < 60:
        camera.page.wait_for_timeout(seconds * 1000)
        camera.of("stop").click()
    camera.wait_for_phase("finished", "stopped", "failed")


def photograph(camera: Photographer, seeded: Seed) -> None:
    """Every screen in the look that is on."""
    camera.go("#/")
    camera.of("group-card").first.wait_for()
    camera.page.wait_for_timeout(500)
    camera.round("start")
    camera.open_program(seeded.empty)
    camera.round("studio-empty")
    studio_running(camera, seeded.programs["Quadrado"])
    camera.open_program(seeded.programs["Com um erro"])
    camera.press_run()
    camera.of("fault").first.wait_for()
    camera.round("studio-fault")
    studio_sign(camera, seeded.programs["Letra B"])
    world_editor(camera, seeded.programs["Estrela"])
    camera.go(f"#/work/{seeded.group}")
    camera.of("run-card").first.wait_for()
    camera.round("work")
    replay(camera, seeded.run)
    camera.round("replay")
    teacher(camera)


def teacher(camera: Photographer) -> None:
    """The door, and each part behind it."""
    camera.go("#/teacher")
    camera.of("pin").wait_for()
    camera.round("teacher-door")
    camera.of("pin").fill(PIN)
    camera.of("enter-door").click()
    camera.of("lesson-row").first.wait_for()
    camera.round("teacher-lessons")
    for part in ("classes", "computer"):
        camera.page.locator(f"[data-testid=teacher-part][data-part={part}]").click()
        camera.round(f"teacher-{part}")
    camera.of("leave-door").click()
    camera.of("group-card").first.wait_for()


def studio_running(camera: Photographer, program: str) -> None:
    camera.open_program(program)
    camera.press_run()
    camera.page.wait_for_timeout(7_300)
    camera.round("studio-running")
    camera.of("run").click()
    camera.wait_for_phase("paused")
    camera.of("ir-toggle").click()
    camera.round("studio-paused-text")
    camera.of("ir-toggle").click()
    camera.of("stop").click()
    camera.wait_for_phase("stopped")
    camera.round("studio-stopped")


def studio_sign(camera: Photographer, program: str) -> None:
    camera.open_program(program)
    camera.press_run()
    camera.of("capture").wait_for()
    camera.round("studio-sign")
    camera.of("stop").click()
    camera.wait_for_phase("stopped")


def world_editor(camera: Photographer, program: str) -> None:
    """The group's own world: empty, full, and with a fault."""
    camera.open_program(program)
    camera.of("world").select_option("empty_room")
    camera.of("world-change").click()
    camera.round("world-empty")
    camera.of("world-begin").select_option("furnished_room")
    boxes = camera.page.locator("[data-testid=world-thing][data-kind=box]")
    boxes.nth(2).focus()
    camera.round("world-full")
    for axis in ("x", "y"):
        here = camera.page.locator("[data-testid=world-thing][data-kind=start]")
        here.focus()
        value = camera.of(f"world-{axis}").input_value()
        boxes.nth(2).focus()
        camera.of(f"world-{axis}").fill(value)
    camera.of("world-fault-note").wait_for()
    camera.round("world-fault")
    for _ in range(3):
        camera.of("world-undo").click()
    camera.of("world-done").click()


def replay(camera: Photographer, run: str) -> None:
    camera.go(f"#/run/{run}")
    slider = camera.of("replay-slider")
    slider.wait_for()
    camera.page.locator(".blocklyBlockCanvas [data-id]").first.wait_for()
    tick = int(int(slider.get_attribute("max")) * 0.68)
    slider.fill(str(tick))


def readme(camera: Photographer, seeded: Seed) -> None:
    """The three pictures of the README."""
    camera.go("#/")
    camera.of("group-card").first.wait_for()
    camera.page.wait_for_timeout(500)
    camera.take("start")
    camera.open_program(seeded.programs["Quadrado"])
    camera.press_run()
    camera.page.wait_for_timeout(9_000)
    camera.take("studio")
    camera.wait_for_phase("finished")
    replay(camera, seeded.run)
    camera.take("replay")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--quick", action="store_true", help="one size, theme and language")
    parser.add_argument("--readme", action="store_true", help="start, studio and replay only")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    with (
        tempfile.TemporaryDirectory() as home,
        application(Path(home)) as address,
        sync_playwright() as playwright,
    ):
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        camera = Photographer(browser, address, arguments.folder)
        camera.of("group-name").wait_for()
        if not arguments.readme:
            camera.round("first-start")
        seeded = seed(camera)
        if arguments.readme:
            readme(camera, seeded)
        else:
            for look in QUICK if arguments.quick else ALL:
                camera.wear(look)
                photograph(camera, seeded)
        browser.close()


if __name__ == "__main__":
    main()
