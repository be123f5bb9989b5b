"""Runs: begin one, steer it, read recorded ones back."""

import json

from flask import Response
from pydantic import ValidationError

from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe
from pinel_desktop.robot import Setting
from pinel_desktop.web.answers import answer, faults_in_words
from pinel_desktop.web.api import answers, resource
from pinel_desktop.web.api.programs import version_model
from pinel_desktop.web.errors import InvalidProgramError
from pinel_desktop.web.models import Empty, IdPath
from pinel_desktop.web.models.runs import (
    Breakpoints,
    CaptureAnswer,
    Evaluated,
    ExpressionToEvaluate,
    Look,
    NewRun,
    QuestionAnswer,
    Run,
    RunEvents,
    RunList,
    RunPage,
    RunSpeed,
    RunWithVersion,
    Step,
)
from pinel_desktop.web.models.worlds import Start, World
from pinel_desktop.web.services import Services, services
from storage import RunLine, RunRow, RunStart, VersionRow

api = resource("runs", "Runs: live and recorded.", __name__)

_LINK = "sim"
_OWN = "own"
_OCTETS = {
    "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}}
}


@api.get("/groups/<id>/runs", responses=answers(RunList, 404))
def list_runs(path: IdPath, query: RunPage) -> Response:
    """Runs of a group, newest first, a page at a time."""
    store = services().store
    store.groups.get(path.id)
    rows = store.runs.of_group(path.id, before=query.before, limit=query.limit)
    after = rows[-1].id if len(rows) == query.limit else None
    return answer(RunList(runs=[run_model(row) for row in rows], next=after))


@api.post("/runs", responses=answers(Run, 404, 409, 503, 507))
def begin_run(body: NewRun) -> Response:
    """Begins a live run of a version."""
    parts = services()
    version = parts.store.versions.get(body.version_id)
    document = _runnable(version, parts)
    start = _start(version, body, parts)
    if parts.engine.live_run is not None:
        raise PinelError("run_in_progress")
    row = parts.store.runs.begin(start)
    try:
        debugging = body.model_dump(
            include={"breakpoints", "speed", "paused"}, exclude_defaults=True
        )
        parts.engine.run(
            row.id,
            document,
            world=start.world_document,
            seed=start.seed,
            link=_LINK,
            setting=start.parameters,
            debugging=debugging,
        )
    except PinelError:
        parts.store.runs.discard(row.id)
        raise
    return answer(run_model(row))


def _runnable(version: VersionRow, parts: Services) -> dict[str, object]:
    if version.document is None:
        raise InvalidProgramError(faults_in_words(version.faults, parts.preferences.language))
    return version.document


def _start(version: VersionRow, body: NewRun, parts: Services) -> RunStart:
    world = _world(version, body.world, parts)
    if body.start:
        world = _moved(world, body.start, body.model, parts)
    return RunStart(
        version_id=version.id,
        link=_LINK,
        world=body.world,
        world_document=world,
        seed=body.seed or 0,
        app_version=parts.app_version,
        parameters=_setting(body).as_parameters(),
    )


def _setting(body: NewRun) -> Setting:
    setting = Setting(body.model, body.preset, body.feedback)
    _ = setting.robot  # an unknown one is refused before anything is kept
    return setting


def _moved(
    world: dict[str, object], start: Start, robot: str, parts: Services
) -> dict[str, object]:
    """The world with another start; the error is the first thing that is wrong with that. The rest was kept before."""
    moved = {**world, "start": start.model_dump()}
    _, faults = parts.read_world(moved, robot=robot)
    for fault in faults:
        if fault.pointer.startswith("/start"):
            raise PinelError(fault.code, **fault.params)
    return moved


def _world(version: VersionRow, name: str, parts: Services) -> dict[str, object]:
    if name == _OWN:
        if version.world is None:
            raise PinelError("world_missing")
        return version.world
    for world in parts.worlds:
        if world["name"] == name:
            return world
    raise PinelError("unknown_world", value=name, allowed=[world["name"] for world in parts.worlds])


@api.post("/runs/<id>/pause", responses=answers(Empty, 404, 409))
def pause_run(path: IdPath) -> Response:
    """Makes the live run wait."""
    services().engine.pause(_known(path.id))
    return answer(Empty())


@api.post("/runs/<id>/resume", responses=answers(Empty, 404, 409))
def resume_run(path: IdPath) -> Response:
    """Lets the live run go on."""
    services().engine.resume(_known(path.id))
    return answer(Empty())


@api.post("/runs/<id>/stop", responses=answers(Empty, 404, 409))
def stop_run(path: IdPath) -> Response:
    """Stops the robot and ends the live run."""
    services().engine.stop(_known(path.id))
    return answer(Empty())


@api.post("/runs/<id>/step", responses=answers(Empty, 404, 409))
def step_run(path: IdPath, body: Step) -> Response:
    """Lets the paused run go on to the next block."""
    services().engine.step(_known(path.id), body.mode)
    return answer(Empty())


@api.put("/runs/<id>/breakpoints", responses=answers(Empty, 404, 409))
def set_breakpoints(path: IdPath, body: Breakpoints) -> Response:
    """Says before which blocks the live run pauses."""
    services().engine.set_breakpoints(_known(path.id), body.blocks)
    return answer(Empty())


@api.put("/runs/<id>/speed", responses=answers(Empty, 404, 409))
def set_speed(path: IdPath, body: RunSpeed) -> Response:
    """Slow motion or fast forward, in the simulator."""
    services().engine.set_speed(_known(path.id), body.factor)
    return answer(Empty())


@api.put("/runs/<id>/look", responses=answers(Empty, 404, 409))
def look_around(path: IdPath, body: Look) -> Response:
    """Says which sensors' measurements the stream is to tell from now on."""
    services().engine.look(_known(path.id), body.sensors)
    return answer(Empty())


@api.post("/runs/<id>/evaluate", responses=answers(Evaluated, 404, 409, 413))
def evaluate_expression(path: IdPath, body: ExpressionToEvaluate) -> Response:
    """The value of an expression while the live run is paused."""
    parts = services()
    run_id = _known(path.id)
    try:
        return answer(Evaluated(value=parts.engine.evaluate(run_id, body.expression), problem=None))
    except PinelError as error:
        if error.code == "run_not_live":
            raise
        words = describe(error.code, error.params, parts.preferences.language)
        return answer(Evaluated(value=None, problem=words.message))


@api.post("/runs/<id>/capture", responses=answers(Empty, 404, 409))
def answer_capture(path: IdPath, body: CaptureAnswer) -> Response:
    """Answers the capture that the live run waits for."""
    services().engine.answer_capture(_known(path.id), body.result)
    return answer(Empty())


@api.post("/runs/<id>/answer", responses=answers(Empty, 404, 409))
def answer_question(path: IdPath, body: QuestionAnswer) -> Response:
    """Answers the question that the live run waits for."""
    services().engine.answer_question(_known(path.id), body.value)
    return answer(Empty())


def _known(run_id: str) -> str:
    """The id, if there is such a run: an unknown one is another error than one that has ended."""
    return services().store.runs.get(run_id).id


@api.get("/runs/<id>", responses=answers(RunWithVersion, 404))
def get_run(path: IdPath) -> Response:
    """A run with the version and the world it ran in."""
    store = services().store
    row = store.runs.get(path.id)
    version = store.versions.get(row.version_id) if row.version_id else None
    run = run_model(row)
    return answer(
        RunWithVersion(
            **{name: getattr(run, name) for name in Run.model_fields},
            version=version_model(version) if version else None,
            world_document=_world_of(row),
        )
    )


def _world_of(row: RunRow) -> World:
    try:
        return World.model_validate(row.world_document)
    except ValidationError as error:
        raise PinelError("run_damaged", part="world_document") from error


@api.get("/runs/<id>/events", responses=answers(RunEvents, 404))
def get_run_events(path: IdPath) -> Response:
    """Events of a run without telemetry, as they were on the stream."""
    _keep_up(path.id)
    events = services().store.runs.events(path.id)
    return Response(
        json.dumps({"events": events}, separators=(",", ":")), mimetype="application/json"
    )


@api.get("/runs/<id>/telemetry", responses=answers(_OCTETS, 404))
def get_run_telemetry(path: IdPath) -> Response:
    """Telemetry of a run: length of the header (uint32), header (JSON), float32 columns; all little-endian."""
    _keep_up(path.id)
    return Response(
        services().store.runs.telemetry(path.id).to_wire(), mimetype="application/octet-stream"
    )


def _keep_up(run_id: str) -> None:
    """A page that comes in the middle of a run is told everything up to now."""
    parts = services()
    if parts.engine.live_run == run_id:
        parts.keep_up()


def run_model(row: RunRow | RunLine) -> Run:
    """A run as it is answered, its reason in the words of the language."""
    language = services().preferences.language
    words = describe(row.reason, row.params, language) if row.reason else None
    fields = {
        name: getattr(row, name) for name in Run.model_fields if name not in ("message", "remedy")
    }
    return Run(
        **fields, message=words.message if words else None, remedy=words.remedy if words else None
    )
