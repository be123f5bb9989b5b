"""A day at a school: two PCs with their apps and real engines, lessons, a teacher, pupils who answer, power cuts.

`write_files.py` keeps what is left of it. All is done over HTTP and by commands, as the page and a person do it.
"""

import json
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psutil

from tests.compatibility.kept_files import (
    DATABASE,
    FILES,
    PIN,
    PROGRAMS,
    SAMPLES,
    bring_program,
    pinel,
)
from tests.e2e.app_process import AppProcess
from tests.web.browser import Browser, Stream

SCHOOL = Path(tempfile.gettempdir()) / "pinel-school"  # its paths are kept in the database
FIRST, SECOND, STICK = SCHOOL / "first", SCHOOL / "second", SCHOOL / "stick"
TAKEN = STICK / "quadrado.pinel"
FAST = 10.0
OWN_WORLD = {
    "pinel_world": 1,
    "name": "own",
    "title": "A nossa sala",
    "size_m": [4, 3],
    "start": {"x_m": -1.5, "y_m": 0, "heading_deg": 0},
    "walls": [{"from": [-2, 1], "to": [2, 1]}],
    "boxes": [{"center": [0, 0], "size": [0.3, 0.3], "movable": True, "mass_kg": 1}],
    "zones": [{"name": "nosso lugar", "center": [-0.5, 0], "size": [0.6, 1]}],
    "floor": [{"color": "green", "center": [-0.5, 0], "radius": 0.3}],
}
Act = tuple[str, str, Any]  # an event, what is asked of the run when it is heard of, with what


def blocks(name: str) -> dict[str, Any]:
    """Workspace and document of a program, as the page sends them."""
    own = FILES / "blocks" / f"{name}.json"
    source = own if own.exists() else SAMPLES / "blocks" / f"{name}.json"
    content: dict[str, Any] = json.loads(source.read_text("utf-8"))
    return content


def block_ids(content: Any, action: str) -> list[str]:
    """Ids of the blocks of an action, in their order."""
    if isinstance(content, list):
        return [found for item in content for found in block_ids(item, action)]
    if not isinstance(content, dict):
        return []
    here = [content["block"]] if content.get("action") == action else []
    return here + [found for item in content.values() for found in block_ids(item, action)]


class Desk:
    """Somebody at a PC: asks the app and wants it done."""

    def __init__(self, browser: Browser) -> None:
        self.browser = browser

    def do(self, method: str, path: str, data: Any = None) -> Any:
        answer = self.browser.send(method, f"/api/{path}", data)
        assert answer.status == 200, (method, path, answer.body)
        return answer.data

    def group(self, name: str, classroom: str | None) -> str:
        group = self.do("POST", "groups", {"name": name, "classroom_id": classroom})
        return str(group["id"])

    def program(self, group: str, name: str) -> str:
        return str(self.do("POST", f"groups/{group}/programs", {"name": name})["id"])

    def save(self, program: str, content: dict[str, Any], **options: Any) -> str:
        saved = self.do("POST", f"programs/{program}/versions", {**content, **options})
        return str(saved["id"])

    def run(self, version: str, *acts: Act, until: str = "run_ended", **options: Any) -> str:
        """Runs a version to its end; each act waits for its event."""
        with self.running(version, **options) as (run, stream):
            for event, what, data in acts:
                wait_for(stream, event)
                method = "PUT" if what in ("speed", "look", "breakpoints") else "POST"
                self.do(method, f"runs/{run}/{what}", data)
            wait_for(stream, until)
        return run

    @contextmanager
    def running(self, version: str, **options: Any) -> Iterator[tuple[str, Stream]]:
        body = {"version_id": version, "world": "empty_room", "speed": FAST, **options}
        with self.browser.stream() as stream:
            assert stream.next()["type"] == "hello"
            yield str(self.do("POST", "runs", body)["id"]), stream


def wait_for(stream: Stream, wanted: str) -> None:
    """Waits for an event of a type, a `run_state` by its state, or telemetry of a tick; for nothing with ""."""
    if not wanted:
        return
    kind, _, tick = wanted.partition(" ")
    for event in stream.events():
        if kind in (event["type"], event.get("state")) and event.get("tick", 0) >= int(tick or 0):
            return
    raise AssertionError(f"the stream ended before {wanted}")


@contextmanager
def app_on(home: Path) -> Iterator[tuple[AppProcess, Desk]]:
    """The app on a folder, until it is stopped or was killed."""
    home.mkdir(parents=True, exist_ok=True)
    app = AppProcess(home)
    desk = Desk(Browser.signed_in(app.start()))
    if desk.do("GET", "teacher")["has_pin"]:
        desk.do("POST", "teacher/enter", {"pin": PIN})
    else:
        desk.do("PUT", "teacher/pin", {"pin": PIN})
    while desk.do("GET", "status")["engine"] != "ready":
        time.sleep(0.1)
    try:
        yield app, desk
    finally:
        app.stop()


def morning() -> None:
    """Lessons at the first PC, which end when the power is cut."""
    with app_on(FIRST) as (app, desk):
        desk.do("PUT", "settings", {"language": "pt-BR"})
        desk.do("PATCH", "computer", {"name": "PC da janela"})
        desk.do("PUT", "folders/shared", {"path": str(STICK)})
        names = ("6º A", "7º B")
        sixth, seventh = (desk.do("POST", "classrooms", {"name": name})["id"] for name in names)
        square(desk, sixth)
        conversation(desk, sixth)
        debugging(desk, sixth)
        pushing(desk, seventh)
        for name in ("Some daqui", "Some lá"):
            program = desk.program(desk.group(name, seventh), "Curva")
            desk.run(desk.save(program, blocks("half_turns")))
        alone = desk.group("Os de fora", None)
        drawing = desk.program(alone, "Partida")
        desk.run(desk.save(drawing, blocks("tic_tac_toe")), world="tic_tac_toe")
        while not list((FIRST / "backups").glob("*.db")):
            time.sleep(0.5)
        cut_off = desk.save(desk.program(alone, "Sem luz"), blocks("square"))
        kill_in_a_run(app, desk, cut_off)


def square(desk: Desk, classroom: str) -> None:
    """A lesson with an activity, and every kind of version."""
    opening = {"title": "O quadrado", "activity": "square"}
    lesson = desk.do("POST", f"classrooms/{classroom}/lessons", opening)
    group = desk.group("Os Robôs", classroom)
    program = desk.program(group, "Qadrado")
    desk.do("PATCH", f"programs/{program}", {"name": "Quadrado"})
    wrong = desk.save(program, blocks("triangle"))
    desk.run(wrong, until="judged")
    faulty = blocks("triangle")
    faulty["document"]["commands"][0]["times"] = -3
    desk.save(program, faulty)
    right = desk.save(program, blocks("square"), parent_id=wrong)
    desk.run(right, until="judged")
    desk.do("PUT", f"versions/{right}/label", {"text": "Ficou quadrado!"})
    desk.save(program, blocks("nested_repeat"))
    desk.save(program, blocks("square"), parent_id=right)
    thrown = desk.program(group, "Rascunho")
    desk.save(thrown, blocks("half_turns"))
    desk.do("DELETE", f"programs/{thrown}")
    own = desk.save(desk.program(group, "Na sala"), blocks("there_and_back"), world=OWN_WORLD)
    start = {"x_m": -1.2, "y_m": 0.1, "heading_deg": 0}
    desk.run(own, until="judged", world="own", start=start)
    desk.do("PATCH", f"lessons/{lesson['id']}", {"closed": True})


def conversation(desk: Desk, classroom: str) -> None:
    """What people do while a program waits for them, in a lesson that opens by itself."""
    group = desk.group("Duas Vozes", classroom)
    version = desk.save(desk.program(group, "Conversa"), blocks("conversation"))
    sign = ("capture_started", "capture", {"result": "B"})
    faster = ("gesture_result", "speed", {"factor": FAST})
    name, three, none = (("asked", "answer", {"value": v}) for v in ("Ana Souza", "3", "0"))
    desk.run(version, sign, faster, name, three, speed=1.0, world="tic_tac_toe")
    desk.run(version, name, none)  # no sign in time; division by zero
    desk.run(version, sign, ("asked", "stop", None), speed=1.0)
    every = desk.save(desk.program(group, "Tudo"), blocks("every_command"))
    eleven = ("asked", "answer", {"value": "11"})
    desk.run(every, name, eleven, world="furnished_room", seed=5)


def debugging(desk: Desk, classroom: str) -> None:
    """Pauses, steps, breakpoints, another speed, sensors that were watched."""
    content = blocks("stairs")
    turns = block_ids(content["document"], "turn")
    version = desk.save(desk.program(desk.group("Passos", classroom), "Escada"), content)
    look = ("running", "look", {"sensors": ["sonar", "lidar"]})
    pause, go_on = ("telemetry 20", "pause", None), ("paused", "resume", None)
    faster = ("running", "speed", {"factor": FAST})
    desk.run(version, look, pause, go_on, faster, speed=1.0)
    steps = [("paused", "step", {"mode": mode}) for mode in ("into", "over", "into", "out")]
    no_more: Act = ("paused", "breakpoints", {"blocks": []})
    at_once = ("", "resume", None)
    desk.run(version, *steps, no_more, at_once, paused=True, breakpoints=turns[:1])
    desk.run(version, pause, ("paused", "stop", None), speed=1.0)
    desk.run(version, ("telemetry 40", "stop", None), speed=0.5)


def pushing(desk: Desk, classroom: str) -> None:
    """A lesson that opened by itself and is joined to one of the teacher's; boxes, noise, a wall, the other robot."""
    group = desk.group("Faísca", classroom)
    version = desk.save(desk.program(group, "Empurrar"), blocks("push_the_boxes"))
    lesson = desk.do("GET", f"classrooms/{classroom}/lesson")["lesson"]["id"]
    desk.run(version, world="pushing", preset="realistic", feedback="odometry", seed=7)
    whole = desk.do("POST", f"classrooms/{classroom}/lessons", {"title": "As caixas"})["id"]
    desk.do("PATCH", f"lessons/{lesson}", {"part_of": whole})
    wall = desk.save(desk.program(group, "Parede"), blocks("into_the_wall"))
    desk.run(wall, model="small_robot", preset="realistic", seed=3)


def neighbours() -> str:
    """Work of another PC, on a stick."""
    with app_on(SECOND) as (_, desk):
        desk.do("PATCH", "computer", {"name": "PC da porta"})
        eighth = desk.do("POST", "classrooms", {"name": "8º C"})["id"]
        program = desk.program(desk.group("Vizinhos", eighth), "Ida e volta")
        desk.run(desk.save(program, blocks("there_and_back")))
        return str(desk.do("POST", "bundles", {"folder": str(STICK)})["path"])


def noon(stick: str) -> str:
    """The teacher at the first PC: notes, what is deleted for good, an engine that is lost, files for others."""
    with app_on(FIRST) as (app, desk):
        desk.do("POST", "bundles/merge", {"paths": [stick]})
        runs = {run["program_name"]: run["id"] for run in desk.do("GET", "runs?limit=200")["runs"]}
        texts = {"Quadrado": "Muito bem!\nE um triângulo?", "Escada": "Está quase.", "Parede": "?"}
        for name, text in texts.items():
            texts[name] = desk.do("POST", f"runs/{runs[name]}/notes", {"text": text})["id"]
        desk.do("POST", f"notes/{texts['Quadrado']}/seen")
        desk.do("DELETE", f"notes/{texts['Parede']}")
        groups = {group["name"]: group["id"] for group in desk.do("GET", "groups")["groups"]}
        desk.do("DELETE", f"groups/{groups['Some daqui']}")
        lost = desk.program(groups["Os de fora"], "Sem motor")
        with desk.running(desk.save(lost, blocks("square")), speed=1.0) as (_, stream):
            wait_for(stream, "telemetry 110")
            kill_engine(app)
            wait_for(stream, "run_ended")
        taken = desk.do("GET", f"groups/{groups['Os Robôs']}/programs")["programs"]
        (program,) = [one["id"] for one in taken if one["name"] == "Quadrado"]
        TAKEN.write_bytes(desk.browser.get(f"/api/programs/{program}/file").body)
        return str(desk.do("POST", "bundles", {"folder": str(STICK)})["path"])


def kill_engine(app: AppProcess) -> None:
    assert app._process is not None
    (engine,) = psutil.Process(app._process.pid).children()
    engine.kill()


def elsewhere(stick: str) -> None:
    """A group goes on at the second PC, where a group is deleted for good."""
    with app_on(SECOND) as (_, desk):
        brought = bring_program(desk.browser, TAKEN.read_bytes())
        version = desk.save(brought["program_id"], blocks("slalom"))
        desk.run(version, world="slalom")
        desk.do("POST", "bundles/merge", {"paths": [stick]})
        groups = {group["name"]: group["id"] for group in desk.do("GET", "groups")["groups"]}
        desk.do("DELETE", f"groups/{groups['Some lá']}")


def evening() -> None:
    """The first PC again: the same group goes on there too, runs of the command line, and one that has not ended."""
    with app_on(FIRST) as (_, desk):
        (group,) = [g for g in desk.do("GET", "groups")["groups"] if g["name"] == "Os Robôs"]
        programs = desk.do("GET", f"groups/{group['id']}/programs")["programs"]
        (program,) = [one["id"] for one in programs if one["name"] == "Quadrado"]
        version = desk.save(program, blocks("triangle"))
        desk.run(version)
    keep = ("--db", FIRST / DATABASE, "run")
    answers = ("--gestures", "B,", "--answers", "Ana,11", "--world", "furnished_room")
    pinel(*keep, PROGRAMS / "every_command.py", *answers)
    pinel(*keep, PROGRAMS / "original.json", "--gestures", "C", "--preset", "realistic")
    pinel(*keep, PROGRAMS / "conversation.py", "--answers", "Ana")  # one is missing
    with app_on(FIRST) as (app, desk):
        kill_in_a_run(app, desk, version)


def kill_in_a_run(app: AppProcess, desk: Desk, version: str) -> None:
    """The power is cut when some seconds of the run are on disk."""
    with desk.running(version, speed=1.0) as (_, stream):
        wait_for(stream, "telemetry 100")
        app.kill()


def play() -> None:
    """The whole day; the folders FIRST, SECOND and STICK hold what is left of it."""
    shutil.rmtree(SCHOOL, ignore_errors=True)
    STICK.mkdir(parents=True)
    morning()
    elsewhere(noon(neighbours()))
    evening()
