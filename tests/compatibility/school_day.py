"""A day at a school: two PCs with apps and real engines, lessons, a teacher, answers of pupils, power cuts.

Everything is done over HTTP and by commands. `write_files.py` stores the resulting files.
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

from tests.compatibility.archived_files import (
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

SCHOOL = Path(tempfile.gettempdir()) / "pinel-school"  # its paths are stored in the database
FIRST, SECOND, STICK = SCHOOL / "first", SCHOOL / "second", SCHOOL / "stick"
PROGRAM_FILE = STICK / "quadrado.pinel"
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
Act = tuple[str, str, Any]  # event, then the live command that follows it and what it carries


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


class PcClient:
    """A client of the app; every request must succeed."""

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
                self.do("POST", f"runs/{run}/commands", {"do": what, **(data or {})})
            wait_for(stream, until)
        return run

    @contextmanager
    def running(self, version: str, **options: Any) -> Iterator[tuple[str, Stream]]:
        body = {"version_id": version, "world": "empty_room", "speed": FAST, **options}
        with self.browser.stream() as stream:
            assert stream.next()["type"] == "hello"
            yield str(self.do("POST", "runs", body)["id"]), stream


def wait_for(stream: Stream, expected: str) -> None:
    """Waits for an event of a type, a `run_state` by its state, or telemetry of a tick; for nothing with ""."""
    if not expected:
        return
    kind, _, tick = expected.partition(" ")
    for event in stream.events():
        if kind in (event["type"], event.get("state")) and event.get("tick", 0) >= int(tick or 0):
            return
    raise AssertionError(f"the stream ended before {expected}")


@contextmanager
def app_on(home: Path) -> Iterator[tuple[AppProcess, PcClient]]:
    """The app on a folder, until it is stopped or was killed."""
    home.mkdir(parents=True, exist_ok=True)
    app = AppProcess(home)
    client = PcClient(Browser.signed_in(app.start()))
    if client.do("GET", "teacher")["has_pin"]:
        client.do("POST", "teacher/enter", {"pin": PIN})
    else:
        client.do("PUT", "teacher/pin", {"pin": PIN})
    while client.do("GET", "status")["engine"] != "ready":
        time.sleep(0.1)
    try:
        yield app, client
    finally:
        app.stop()


def morning() -> None:
    """Lessons at the first PC, which end when the power is cut."""
    with app_on(FIRST) as (app, client):
        client.do("PUT", "settings", {"language": "pt-BR"})
        client.do("PATCH", "computer", {"name": "PC da janela"})
        client.do("PUT", "folders/shared", {"path": str(STICK)})
        names = ("6º A", "7º B")
        sixth, seventh = (client.do("POST", "classrooms", {"name": name})["id"] for name in names)
        square(client, sixth)
        conversation(client, sixth)
        debugging(client, sixth)
        pushing(client, seventh)
        for name in ("Some daqui", "Some lá"):
            program = client.program(client.group(name, seventh), "Curva")
            client.run(client.save(program, blocks("half_turns")))
        alone = client.group("Os de fora", None)
        drawing = client.program(alone, "Partida")
        client.run(client.save(drawing, blocks("tic_tac_toe")), world="tic_tac_toe")
        while not list((FIRST / "backups").glob("*.db")):
            time.sleep(0.5)
        cut_off = client.save(client.program(alone, "Sem luz"), blocks("square"))
        kill_in_a_run(app, client, cut_off)


def square(client: PcClient, classroom: str) -> None:
    """A lesson with an activity, and every kind of version."""
    opening = {"title": "O quadrado", "activity": "square"}
    lesson = client.do("POST", f"classrooms/{classroom}/lessons", opening)
    group = client.group("Os Robôs", classroom)
    program = client.program(group, "Qadrado")
    client.do("PATCH", f"programs/{program}", {"name": "Quadrado"})
    wrong = client.save(program, blocks("triangle"))
    client.run(wrong, until="judged")
    faulty = blocks("triangle")
    faulty["document"]["commands"][0]["times"] = -3
    client.save(program, faulty)
    right = client.save(program, blocks("square"), parent_id=wrong)
    client.run(right, until="judged")
    client.do("PUT", f"versions/{right}/label", {"text": "Ficou quadrado!"})
    client.save(program, blocks("nested_repeat"))
    client.save(program, blocks("square"), parent_id=right)
    thrown = client.program(group, "Rascunho")
    client.save(thrown, blocks("half_turns"))
    client.do("DELETE", f"programs/{thrown}")
    own = client.save(client.program(group, "Na sala"), blocks("there_and_back"), world=OWN_WORLD)
    start = {"x_m": -1.2, "y_m": 0.1, "heading_deg": 0}
    client.run(own, until="judged", world="own", start=start)
    client.do("PATCH", f"lessons/{lesson['id']}", {"closed": True})


def conversation(client: PcClient, classroom: str) -> None:
    """Answers, captures and their absence, in a lesson that opens automatically."""
    group = client.group("Duas Vozes", classroom)
    version = client.save(client.program(group, "Conversa"), blocks("conversation"))
    sign = ("capture_started", "answer_capture", {"result": "B"})
    faster = ("gesture_result", "speed", {"factor": FAST})
    name, three, none = (("asked", "answer", {"value": v}) for v in ("Ana Souza", "3", "0"))
    client.run(version, sign, faster, name, three, speed=1.0, world="tic_tac_toe")
    client.run(version, name, none)  # no sign in time; division by zero
    client.run(version, sign, ("asked", "stop", None), speed=1.0)
    every = client.save(client.program(group, "Tudo"), blocks("every_command"))
    eleven = ("asked", "answer", {"value": "11"})
    client.run(every, name, eleven, world="furnished_room", seed=5)


def debugging(client: PcClient, classroom: str) -> None:
    """Pauses, steps, breakpoints, speeds, subscribed sensors."""
    content = blocks("stairs")
    turns = block_ids(content["document"], "turn")
    version = client.save(client.program(client.group("Passos", classroom), "Escada"), content)
    subscribe = ("running", "subscribe", {"sensors": ["sonar", "lidar"]})
    pause, resume = ("telemetry 20", "pause", None), ("paused", "resume", None)
    faster = ("running", "speed", {"factor": FAST})
    client.run(version, subscribe, pause, resume, faster, speed=1.0)
    steps = [("paused", "step", {"mode": mode}) for mode in ("into", "over", "into", "out")]
    no_more: Act = ("paused", "breakpoints", {"blocks": []})
    at_once = ("", "resume", None)
    client.run(version, *steps, no_more, at_once, paused=True, breakpoints=turns[:1])
    client.run(version, pause, ("paused", "stop", None), speed=1.0)
    client.run(version, ("telemetry 40", "stop", None), speed=0.5)


def pushing(client: PcClient, classroom: str) -> None:
    """An automatically opened lesson joined to one of the teacher's; boxes, noise, a wall, the other robot."""
    group = client.group("Faísca", classroom)
    version = client.save(client.program(group, "Empurrar"), blocks("push_the_boxes"))
    lesson = client.do("GET", f"classrooms/{classroom}/lesson")["lesson"]["id"]
    client.run(version, world="pushing", preset="realistic", feedback="odometry", seed=7)
    whole = client.do("POST", f"classrooms/{classroom}/lessons", {"title": "As caixas"})["id"]
    client.do("PATCH", f"lessons/{lesson}", {"part_of": whole})
    wall = client.save(client.program(group, "Parede"), blocks("into_the_wall"))
    client.run(wall, model="small_robot", preset="realistic", seed=3)


def neighbours() -> str:
    """Exports the work of another PC to a stick."""
    with app_on(SECOND) as (_, client):
        client.do("PATCH", "computer", {"name": "PC da porta"})
        eighth = client.do("POST", "classrooms", {"name": "8º C"})["id"]
        program = client.program(client.group("Vizinhos", eighth), "Ida e volta")
        client.run(client.save(program, blocks("there_and_back")))
        return str(client.do("POST", "bundles", {"folder": str(STICK)})["path"])


def noon(stick: str) -> str:
    """The teacher at the first PC: notes, permanent deletion, a lost engine, exports."""
    with app_on(FIRST) as (app, client):
        client.do("POST", "bundles/merge", {"paths": [stick]})
        runs = {
            run["program_name"]: run["id"] for run in client.do("GET", "runs?limit=200")["runs"]
        }
        texts = {"Quadrado": "Muito bem!\nE um triângulo?", "Escada": "Está quase.", "Parede": "?"}
        for name, text in texts.items():
            texts[name] = client.do("POST", f"runs/{runs[name]}/notes", {"text": text})["id"]
        client.do("POST", f"notes/{texts['Quadrado']}/seen")
        client.do("DELETE", f"notes/{texts['Parede']}")
        groups = {group["name"]: group["id"] for group in client.do("GET", "groups")["groups"]}
        client.do("DELETE", f"groups/{groups['Some daqui']}")
        lost = client.program(groups["Os de fora"], "Sem motor")
        with client.running(client.save(lost, blocks("square")), speed=1.0) as (_, stream):
            wait_for(stream, "telemetry 110")
            kill_engine(app)
            wait_for(stream, "run_ended")
        programs = client.do("GET", f"groups/{groups['Os Robôs']}/programs")["programs"]
        (program,) = [one["id"] for one in programs if one["name"] == "Quadrado"]
        PROGRAM_FILE.write_bytes(client.browser.get(f"/api/programs/{program}/file").body)
        return str(client.do("POST", "bundles", {"folder": str(STICK)})["path"])


def kill_engine(app: AppProcess) -> None:
    assert app._process is not None
    children = psutil.Process(app._process.pid).children()
    (engine,) = [one for one in children if one.cmdline()[-1] == "engine"]
    engine.kill()


def at_second_pc(stick: str) -> None:
    """A group continues at the second PC, where another group is deleted for good."""
    with app_on(SECOND) as (_, client):
        brought = bring_program(client.browser, PROGRAM_FILE.read_bytes())
        version = client.save(brought["program_id"], blocks("slalom"))
        client.run(version, world="slalom")
        client.do("POST", "bundles/merge", {"paths": [stick]})
        groups = {group["name"]: group["id"] for group in client.do("GET", "groups")["groups"]}
        client.do("DELETE", f"groups/{groups['Some lá']}")


def evening() -> None:
    """The first PC again: the same group continues there, runs of the command line, and an unfinished run."""
    with app_on(FIRST) as (_, client):
        (group,) = [g for g in client.do("GET", "groups")["groups"] if g["name"] == "Os Robôs"]
        programs = client.do("GET", f"groups/{group['id']}/programs")["programs"]
        (program,) = [one["id"] for one in programs if one["name"] == "Quadrado"]
        version = client.save(program, blocks("triangle"))
        client.run(version)
    options = ("--db", FIRST / DATABASE, "run")
    answers = ("--gestures", "B,", "--answers", "Ana,11", "--world", "furnished_room")
    pinel(*options, PROGRAMS / "every_command.py", *answers)
    pinel(*options, PROGRAMS / "original.json", "--gestures", "C", "--preset", "realistic")
    pinel(*options, PROGRAMS / "conversation.py", "--answers", "Ana")  # one is missing
    with app_on(FIRST) as (app, client):
        kill_in_a_run(app, client, version)


def kill_in_a_run(app: AppProcess, client: PcClient, version: str) -> None:
    """Kills the app when some seconds of the run are on disk."""
    with client.running(version, speed=1.0) as (_, stream):
        wait_for(stream, "telemetry 100")
        app.kill()


def play() -> None:
    """The whole day; its files are in the folders FIRST, SECOND and STICK."""
    shutil.rmtree(SCHOOL, ignore_errors=True)
    STICK.mkdir(parents=True)
    morning()
    at_second_pc(noon(neighbours()))
    evening()
