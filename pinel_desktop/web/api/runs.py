"""Runs: start, command, list, read events and telemetry."""

import contextlib
import json
from collections.abc import Sequence
from typing import TYPE_CHECKING

from flask import Response
from pydantic import ValidationError

from pinel_desktop.engine.commands import Command, LiveCommand, SetBreakpoints, SetSpeed, Step
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, explain
from pinel_desktop.robot import RobotModel, SimulationConfig
from pinel_desktop.robot.robot_profile import ROOM
from pinel_desktop.runs.record import record_of
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.school.calibrated_robots import PREDICTOR, calibrated_setting, predictor_of
from pinel_desktop.school.grading import NOT_JUDGED, start_info_of
from pinel_desktop.school.own_activities import known_activity
from pinel_desktop.web.api import OCTETS, WRITES, Resource, responses
from pinel_desktop.web.api.activities import world_name
from pinel_desktop.web.api.programs import version_model
from pinel_desktop.web.errors import InvalidProgramError
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.runs import (
    CloudInputs,
    CommandAnswer,
    NewRun,
    Run,
    RunEvents,
    RunList,
    RunPage,
    RunWithVersion,
)
from pinel_desktop.web.models.worlds import Start, World
from pinel_desktop.web.responses import describe_faults, json_response
from pinel_desktop.web.services import Services, read_world, services
from storage import CALIBRATED_ROBOT, SIMULATOR, RunRow, RunSummary, StoreError, VersionRow

if TYPE_CHECKING:
    from pinel_desktop.activities import Activity
    from pinel_desktop.program.faults import Fault
    from pinel_desktop.runs.fixed_inputs import FixedInputs

api = Resource("runs", "Runs: live and recorded.", __name__)

_OWN = "own"
# it is unknown whether the engine received the command
_UNCERTAIN = ("engine_silent", "stop_unconfirmed", "real_stop_unconfirmed")


@api.get("/groups/<id>/runs", responses=responses(RunList, "group_not_found"))
def list_runs(path: IdPath, query: RunPage) -> Response:
    """Runs of a group, newest first, a page at a time."""
    store = services().store
    store.groups.get(path.id)
    rows = store.runs.of_group(path.id, before=query.before, limit=query.limit)
    after = rows[-1].id if len(rows) == query.limit else None
    return json_response(RunList(runs=[run_model(row) for row in rows], next=after))


@api.post(
    "/runs",
    responses=responses(
        Run,
        "version_not_found",
        "run_in_progress",
        "robot_held_by_keys",
        "engine_not_ready",
        "engine_silent",
        "invalid_program",
        "unknown_world",
        "world_missing",
        "unknown_link",
        "robot_not_set_up",
        "calibrated_robot_not_found",
        "calibrated_robot_deleted",
        "cloud_needs_inputs",
        *WRITES,
    ),
)
def begin_run(body: NewRun) -> Response:
    """Starts a live run of a version.

    A version that is to solve an activity gets world, start and robot from the activity, whatever the request names. If
    the robot does not fit at the start pose, the request is refused with 422 and the reason, such as `start_in_wall`. A
    real robot drives in its room, whatever the request names; whether its run can be judged depends on the activity.
    """
    parts = services()
    version = parts.store.versions.get(body.version_id)
    activity = activity_of(version)
    staged = in_case(activity, body.cloud.case) if activity and body.cloud else activity
    spec = spec_for(version, staged, body, parts)
    inputs = cloud_inputs(spec.document, staged, body.cloud, parts) if body.cloud else None
    if parts.engine.live_run is not None:
        raise PinelError("run_in_progress")
    record = record_of(
        spec,
        world_name=_world_name(spec, activity, body),
        app_version=parts.app_version,
        version_id=version.id,
        activity=activity.name if activity else None,
        more=_for_people(spec, body, parts),
    )
    row = parts.store.runs.begin(record)
    _use_signs_of(row.group_id, parts)
    if not body.cloud:
        _prepare_judge(row, activity, version, parts)
    try:
        parts.engine.run(row.id, spec, _first_commands(body), inputs)
    except PinelError:
        parts.store.runs.discard(row.id)
        raise
    if spec.robot:
        parts.overhead.begin(row.id)
        parts.localisation.begin(row.id, spec.robot)
        if parts.engine.live_run != row.id:  # it ended before they followed it
            for source in (parts.overhead, parts.localisation):
                source.observe({"run": row.id, "type": "run_ended"})
    return json_response(run_model(row))


def _use_signs_of(group_id: str | None, parts: Services) -> None:
    """Loads the signs of the group's class into the camera. If they cannot be read, the run starts all the same."""
    with contextlib.suppress(StoreError):
        parts.signs.use(group_id and parts.store.groups.get(group_id).classroom_id)


def _prepare_judge(
    row: RunRow, activity: "Activity | None", version: VersionRow, parts: Services
) -> None:
    """Sends activity and document of a started run to the judge; nothing if this release cannot use the activity."""
    if row.activity is None:
        return
    # else the lesson's activity
    given = activity if activity and activity.name == row.activity else None
    with contextlib.suppress(PinelError):
        parts.prepare_judge(row.id, start_info_of(parts.store, row, given, version.document))


def _runnable(version: VersionRow, parts: Services) -> dict[str, object]:
    if version.document is None:
        raise InvalidProgramError(describe_faults(version.faults, parts.settings.language))
    return version.document


def spec_for(
    version: VersionRow, activity: "Activity | None", body: NewRun, parts: Services
) -> RunSpec:
    """Returns the spec of a live run. Raises what `begin_run` declares."""
    document = _runnable(version, parts)
    if body.robot != SIMULATOR:
        return _real_spec(document, body, parts)
    if activity:
        world, setting = _stage(activity)
        if body.cloud:
            setting = SimulationConfig(setting.model, body.preset, body.feedback)
    else:
        world, setting = _world(version, body.world, parts), _setting(body, parts)
        if body.start:
            world = _moved(world, body.start, setting.model, parts)
    _refuse(_missing_on(setting.robot, document), parts)
    return RunSpec(document, world, setting=setting, seed=body.seed or 0, pace="live")


def _missing_on(robot: RobotModel, document: object) -> "Sequence[Fault]":
    from pinel_desktop.runs.robot_checks import missing_on_model  # noqa: PLC0415 - heavy

    return missing_on_model(document, robot)


def _refuse(faults: "Sequence[Fault]", parts: Services) -> None:
    if faults:
        raise InvalidProgramError(describe_faults(faults, parts.settings.language))


def _real_spec(document: dict[str, object], body: NewRun, parts: Services) -> RunSpec:
    from pinel_desktop.runs.robot_checks import missing_on_real_robots  # noqa: PLC0415 - heavy

    profile = parts.robots.profile(body.robot)
    _refuse(missing_on_real_robots(document), parts)
    if body.slow:
        profile = profile.slowed()
    world = profile.room.as_world()
    seed = body.seed or 0
    return RunSpec(document, world, link=body.robot, robot=profile, seed=seed, pace="live")


def _world_name(spec: RunSpec, activity: "Activity | None", body: NewRun) -> str:
    if spec.robot:
        return ROOM
    return world_name(activity) if activity else body.world


def activity_of(version: VersionRow) -> "Activity | None":
    """Returns the activity that a version is to solve; None without one, or if this release cannot use it."""
    name = (version.setup or {}).get("activity")
    if name is None:
        return None
    with contextlib.suppress(PinelError):
        return known_activity(services().store, name)
    return None


def in_case(activity: "Activity", number: int) -> "Activity":
    """Returns an activity with one of its cases only; the last one if a teacher has deleted cases meanwhile."""
    case = activity.cases[min(number, len(activity.cases)) - 1]
    return activity.model_copy(update={"cases": [case]})


def cloud_inputs(
    document: object, activity: "Activity | None", cloud: CloudInputs, parts: Services
) -> "FixedInputs":
    """Returns what the robots of a cloud read. Raises what `inputs_of` raises; StoreError `run_not_found`."""
    from pinel_desktop.cloud.inputs import inputs_of  # noqa: PLC0415 - heavy

    assert isinstance(document, dict)
    run_id = cloud.run_id
    recorded = (lambda: parts.store.runs.events(run_id)) if run_id else None
    return inputs_of(document, activity, recorded)


def _stage(activity: "Activity") -> tuple[dict[str, object], SimulationConfig]:
    """Returns world and robot setting of all runs of an activity in its first case, whatever the request names."""
    from pinel_desktop.activities import world_of  # noqa: PLC0415 - heavy

    setting = SimulationConfig(activity.model, activity.preset, activity.feedback)
    return world_of(activity, activity.cases[0]), setting


def _first_commands(body: NewRun) -> list[Command]:
    commands: list[Command] = [SetBreakpoints(blocks=body.breakpoints), SetSpeed(factor=body.speed)]
    return [*commands, Step(mode="into")] if body.paused else commands


def _setting(body: NewRun, parts: Services) -> SimulationConfig:
    if body.calibrated_robot:
        return calibrated_setting(parts.store, body.calibrated_robot)
    setting = SimulationConfig(body.model, body.preset, body.feedback)
    _ = setting.robot  # raises unknown_robot before anything is stored
    return setting


def _for_people(spec: RunSpec, body: NewRun, parts: Services) -> dict[str, object]:
    """Returns what a record says besides the spec.

    That is why nobody judges the run, the name of its calibrated robot, the robot that predicts a real one's run.
    """
    more: dict[str, object] = {NOT_JUDGED: "cloud"} if body.cloud else {}
    if spec.robot and (by := predictor_of(parts.store, body.calibrated_robot, spec.robot)):
        more[PREDICTOR] = by
    if body.calibrated_robot and spec.setting.parameters.changes:
        robot = parts.store.calibrated_robots.get(body.calibrated_robot)
        more[CALIBRATED_ROBOT] = robot.title
    return more


def _moved(
    world: dict[str, object], start: Start, robot: str, parts: Services
) -> dict[str, object]:
    """Returns the world with another start pose. Raises PinelError with the first fault of that pose."""
    moved = {**world, "start": start.model_dump()}
    _, faults = read_world(moved, robot=robot)
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


@api.post(
    "/runs/<id>/commands",
    responses=responses(CommandAnswer, "run_not_found", "run_not_live", *_UNCERTAIN),
)
def command_run(path: IdPath, body: LiveCommand) -> Response:
    """Sends a command to the live run.

    The engine receives the command before the database is read, so that Stop works with a damaged or locked database. A
    Stop is answered when the engine confirms it. After a second without confirmation the error is `stop_unconfirmed`,
    for a real robot `real_stop_unconfirmed`. If the engine does not respond for two seconds, its process is ended, and
    its run with it.
    """
    parts = services()
    try:
        value = parts.engine.command(path.id, body.root)
    except PinelError as error:
        if error.code == "run_not_live":
            raise _why_not_live(path.id, error) from error
        if error.code in _UNCERTAIN:
            raise
        text = explain(error, parts.settings.language)
        return json_response(CommandAnswer(value=None, problem=text.message))
    return json_response(CommandAnswer(value=value, problem=None))


def _why_not_live(run_id: str, error: PinelError) -> PinelError | StoreError:
    """Returns the error `run_not_found` if the database has no such run, else `error`."""
    try:
        services().store.runs.get(run_id)
    except StoreError as unknown:
        if unknown.code == "run_not_found":
            return unknown
    return error


@api.get("/runs/<id>", responses=responses(RunWithVersion, "run_not_found"))
def get_run(path: IdPath) -> Response:
    """A run with its version and world."""
    store = services().store
    row = store.runs.get(path.id)
    version = store.versions.get(row.version_id) if row.version_id else None
    return json_response(
        RunWithVersion.of(
            run_model(row),
            version=version_model(version) if version else None,
            world_document=world_of(row),
            other_computer=store.computers.name_of_other(row.computer_id),
            **_verdict(row),
        )
    )


def _verdict(row: RunRow) -> dict[str, object]:
    """What the judge found: whether it judged a robot's measurements or why not, and what the run lacks."""
    from pinel_desktop.school.review import advice_of_report  # noqa: PLC0415 - heavy

    report = row.check_report or {}
    by_robot = row.link != SIMULATOR and row.passed is not None
    advice = advice_of_report(report) if row.passed is False else None
    return {
        "by_robot": by_robot,
        "not_judged": _why_not_judged(report.get("not_judged")),
        "missing": advice.of(services().settings.language) if advice else None,
        "missing_block": advice.block if advice else None,
    }


def _why_not_judged(why: object) -> str | None:
    if not isinstance(why, str):
        return None
    from pinel_desktop.activities import not_judged_text  # noqa: PLC0415 - heavy

    return not_judged_text(why, services().settings.language)


def world_of(row: RunRow) -> World:
    """Returns the world of a run. Raises PinelError `run_damaged`."""
    try:
        return World.model_validate(row.world_document)
    except ValidationError as error:
        raise PinelError("run_damaged", part="world_document") from error


@api.get("/runs/<id>/events", responses=responses(RunEvents, "run_not_found"))
def get_run_events(path: IdPath) -> Response:
    """Events of a run as on the stream, without telemetry."""
    _flush_recording(path.id)
    events = services().store.runs.events(path.id)
    return Response(
        json.dumps({"events": events}, separators=(",", ":")), mimetype="application/json"
    )


@api.get("/runs/<id>/telemetry", responses=responses(OCTETS, "run_not_found"))
def get_run_telemetry(path: IdPath) -> Response:
    """Telemetry of a run as binary columns, little-endian.

    The length of the header (uint32); the header, JSON padded with spaces to a multiple of 4,
    `{"columns": [...], "rows": N, "rate_hz": 30}`; then one float32 array for each column. The columns are `tick` and
    the fields of the event `telemetry`; NaN is null.
    """
    _flush_recording(path.id)
    return Response(
        services().store.runs.telemetry(path.id).to_wire(), mimetype="application/octet-stream"
    )


def _flush_recording(run_id: str) -> None:
    """Writes pending events of a live run, so that a page opened during the run receives all events."""
    parts = services()
    if parts.engine.live_run == run_id:
        parts.flush_recording()


def run_model(row: RunRow | RunSummary) -> Run:
    """Returns the response for a run, with a message for its reason."""
    parts = services()
    end = (parts.unsaved_end(row.id) if row.state == "running" else None) or {}
    ended = {name: end[name] for name in Run.model_fields if name in end}
    reason, params = ended.get("reason", row.reason), ended.get("params", row.params)
    text = describe(reason, params, parts.settings.language) if reason else None
    texts = {
        "message": text.message if text else None,
        "remedy": text.remedy if text else None,
        "passed": row.counted if isinstance(row, RunRow) else row.passed,
    }
    return Run.of(row, **ended, **texts)
