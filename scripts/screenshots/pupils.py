"""Screenshots of the pupils' screens and of the teacher's sign-in."""

from typing import Any, NamedTuple

from scripts.screenshots.camera import PIN, Photographer
from scripts.screenshots.programs import FAULTY, SIGNS, SQUARE, STAR, TRIANGLE, WALL


class Seed(NamedTuple):
    """The generated data."""

    group: str
    empty: str
    programs: dict[str, str]
    run: str


def seed(camera: Photographer) -> Seed:
    """Creates a class with a lesson, groups, programs and runs."""
    camera.call("PUT", "/api/teacher/pin", {"pin": PIN})
    classroom = camera.call("POST", "/api/classrooms", {"name": "9º A"})["id"]
    lesson = {"title": "Quadrados", "activity": "square"}
    camera.call("POST", f"/api/classrooms/{classroom}/lessons", lesson)
    camera.call("POST", "/api/teacher/leave")
    for name in ("Os Parafusos", "Equipe Beta", "Meninas do Robô", "Curto-circuito"):
        camera.call("POST", "/api/groups", {"name": name, "classroom_id": classroom})
    new_group = {"name": "Turma dos Quadrados", "classroom_id": classroom}
    group = camera.call("POST", "/api/groups", new_group)["id"]
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
    """Stores a program and opens it in the editor once, which generates its document."""
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
    """Takes every screen in the current settings."""
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
    practice(camera)
    world_editor(camera, seeded.programs["Estrela"])
    camera.go(f"#/work/{seeded.group}")
    camera.of("run-card").first.wait_for()
    camera.round("work")
    camera.go(f"#/album/{seeded.group}")
    camera.of("album-place").first.wait_for()
    camera.round("album")
    replay(camera, seeded.run)
    camera.round("replay")
    teacher(camera)


def teacher(camera: Photographer) -> None:
    """Takes the teacher's sign-in, and each of the teacher's screens."""
    camera.go("#/teacher")
    camera.of("pin").wait_for()
    camera.round("teacher-door")
    camera.of("pin").fill(PIN)
    camera.of("sign-in").click()
    camera.of("lesson-row").first.wait_for()
    camera.round("teacher-lessons")
    for part in ("classes", "computer"):
        camera.page.locator(f"[data-testid=teacher-part][data-part={part}]").click()
        camera.round(f"teacher-{part}")
    camera.of("sign-out").click()
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
    wait_for_hand(camera)
    camera.round("studio-sign")
    camera.of("stop").click()
    camera.wait_for_phase("stopped")


def practice(camera: Photographer) -> None:
    camera.go("#/practice")
    wait_for_hand(camera)
    camera.round("practice")


def wait_for_hand(camera: Photographer) -> None:
    """Waits until the webcam shows a hand."""
    camera.page.locator("[data-testid=camera-picture][data-state=on]").wait_for()
    camera.page.locator(".skeleton__hand").first.wait_for()


def world_editor(camera: Photographer, program: str) -> None:
    """Takes the world editor: empty, filled, and with a fault."""
    camera.open_program(program)
    camera.of("world").select_option("empty_room")
    camera.of("world-change").click()
    camera.round("world-empty")
    camera.of("world-begin").select_option("furnished_room")
    boxes = camera.page.locator("[data-testid=world-thing][data-kind=box]")
    boxes.nth(2).focus()
    camera.round("world-full")
    for axis in ("x", "y"):  # counted from the start
        camera.of(f"world-{axis}").fill("0")
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
    """Takes the pictures of README and manual: start, studio, replay, floor in 3D, album."""
    camera.go("#/")
    camera.of("group-card").first.wait_for()
    camera.page.wait_for_timeout(500)
    camera.save("start")
    camera.open_program(seeded.programs["Quadrado"])
    camera.press_run()
    camera.page.wait_for_timeout(9_000)
    camera.save("studio")
    camera.wait_for_phase("finished")
    replay(camera, seeded.run)
    camera.save("replay")
    camera.page.locator('[data-testid="floor-view"][data-value="true"]').click()
    camera.of("scene-3d").wait_for()
    camera.page.wait_for_timeout(3_000)
    camera.save("floor-3d")
    camera.of("open-album").click()
    camera.of("album-count").wait_for()
    camera.save("album")
