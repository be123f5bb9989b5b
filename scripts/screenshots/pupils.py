"""Groups with programs and runs, and the pupils' pictures of README and manual."""

from typing import Any, NamedTuple

from scripts.screenshots.camera import PIN, Photographer
from scripts.screenshots.programs import FAULTY, SIGNS, SQUARE, STAR, TRIANGLE, WALL, WEAK


class Seed(NamedTuple):
    """The generated data."""

    group: str
    empty: str
    programs: dict[str, str]


def seed(camera: Photographer) -> Seed:
    """Creates a class with a lesson, groups and programs."""
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
            "Até a esquina": WEAK,
        }.items()
    }
    empty = camera.call("POST", f"/api/groups/{group}/programs", {"name": "Programa 7"})["id"]
    return Seed(group, empty, programs)


def save(
    camera: Photographer,
    group: str,
    name: str,
    blocks: dict[str, Any],
    setup: dict[str, Any] | None = None,
) -> str:
    """Stores a program; the editor generates its document when it is opened."""
    program: str = camera.call("POST", f"/api/groups/{group}/programs", {"name": name})["id"]
    content = {"workspace": blocks, "document": None, "setup": setup}
    camera.call("POST", f"/api/programs/{program}/versions", content)
    return program


def drive_all(camera: Photographer, seeded: Seed) -> str:
    """Runs some programs; returns the last run."""
    for name, seconds in {
        "Triângulo": 60,
        "Estrela": 3,
        "Até a parede": 60,
        "Quadrado": 60,
    }.items():
        drive(camera, seeded.programs[name], seconds)
    runs = camera.call("GET", f"/api/groups/{seeded.group}/runs?limit=1")["runs"]
    last: str = runs[0]["id"]
    return last


def drive(camera: Photographer, program: str, seconds: int) -> None:
    """Runs a program to its end, or stops it after some seconds."""
    camera.open_program(program)
    camera.press_run()
    camera.wait_for_phase("running")
    if seconds < 60:
        camera.page.wait_for_timeout(seconds * 1000)
        camera.of("stop").click()
    camera.wait_for_phase("finished", "stopped", "failed")


def replay(camera: Photographer, run: str) -> None:
    camera.go(f"#/run/{run}")
    slider = camera.of("replay-slider")
    slider.wait_for()
    camera.page.locator(".blocklyBlockCanvas [data-id]").first.wait_for()
    tick = int(int(slider.get_attribute("max")) * 0.68)
    slider.fill(str(tick))


def readme(camera: Photographer, seeded: Seed) -> None:
    """Takes the pictures of README and manual: start, studio, replay, a saved picture, floor in 3D, album."""
    run = drive_all(camera, seeded)
    camera.go("#/")
    camera.of("group-card").first.wait_for()
    camera.page.wait_for_timeout(500)
    camera.save("start")
    camera.open_program(seeded.programs["Quadrado"])
    camera.press_run()
    camera.page.wait_for_timeout(9_000)
    camera.save("studio")
    camera.wait_for_phase("finished")
    replay(camera, run)
    camera.save("replay")
    camera.press("run-image")
    with camera.page.expect_download() as download:
        camera.press("save-run-picture")
    download.value.save_as(camera.folder / "run-image.png")
    camera.page.locator('[data-testid="floor-view"][data-value="true"]').click()
    camera.of("scene-3d").wait_for()
    camera.page.wait_for_timeout(3_000)
    camera.save("floor-3d")
    camera.of("open-album").click()
    camera.of("album-count").wait_for()
    camera.save("album")
