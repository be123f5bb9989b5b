"""`pinel run FILE`: executes a program in this process and prints its result (docs/program-document.md)."""

import contextlib
import json
from collections.abc import Sequence
from typing import Any

import click

from pinel_desktop import __version__
from pinel_desktop.camera.client import CameraState
from pinel_desktop.camera.inputs import WRONG_RECOGNIZER, WRONG_SOURCE, CameraInputs
from pinel_desktop.commands.batch.robot_parameters import chosen_parameters
from pinel_desktop.commands.options import chosen_database, database_option, recognizer_option
from pinel_desktop.commands.printing import metric_lines, print_problem
from pinel_desktop.commands.program_file import location_of, read_file
from pinel_desktop.commands.recording import Recording, open_recording
from pinel_desktop.commands.robots.real_robot import (
    ROBOT_OPTIONS,
    announce_waiting,
    chosen_robot,
    robot_options,
    stopped_by_signals,
)
from pinel_desktop.commands.typed_inputs import input_options, typed_answers, typed_gestures
from pinel_desktop.commands.world_file import ChosenWorld, WorldFileError, choose_world
from pinel_desktop.errors import PinelError
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.execution.summary import faulty_object, run_object, unbegun_object
from pinel_desktop.gestures.letters import LANDMARKS
from pinel_desktop.links import LINK_NAMES
from pinel_desktop.messages import describe, explain, language_of_system
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.reading import ParseResult
from pinel_desktop.robot import FEEDBACKS, PIONEER_3DX, PRESETS, ROBOTS, SimulationConfig
from pinel_desktop.robot.robot_profile import ROOM, RobotProfile
from pinel_desktop.runs.plotting import Curves, draw, plot_format
from pinel_desktop.runs.record import record_of
from pinel_desktop.runs.robot_checks import missing_on_model, missing_on_real_robots
from pinel_desktop.runs.spec import RunInputs, RunSpec
from pinel_desktop.runs.start import all_of, start
from storage import RunStart

_MAX_VALUE_LENGTH = 200  # of a variable in the text output; --json has the full value
_FINISHED, _NOT_FINISHED, _INVALID = 0, 1, 2
_INVALID_REASONS = (
    "invalid_program",
    "invalid_world",
    "unknown_world",
    "plot_ending",
    "plot_missing",
    "robot_record_invalid",
    "robot_record_range",
    "robot_setting_unclear",
    "bridge_option_unclear",
    "bridge_option_alone",
    "unknown_robot_parameter",
    "robot_parameter_range",
    "robot_parameter_unclear",
    "robot_parameters_ideal",
    *WRONG_SOURCE,
)


@click.command()
@click.argument("file", metavar="FILE")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.option(
    "--robot",
    type=click.Choice(LINK_NAMES),
    default="sim",
    show_default=True,
    help="What is to be driven.",
)
@robot_options
@click.option(
    "--world",
    metavar="NAME|FILE",
    default="empty_room",
    show_default=True,
    help="World of the simulator: the name of one that ships, or a file with a world document.",
)
@click.option(
    "--model",
    type=click.Choice(list(ROBOTS)),
    default=PIONEER_3DX.name,
    show_default=True,
    help="Robot in the simulator.",
)
@click.option(
    "--preset",
    type=click.Choice(PRESETS),
    default="ideal",
    show_default=True,
    help="Noise, slip and latency of the simulator.",
)
@click.option(
    "--feedback",
    type=click.Choice(FEEDBACKS),
    default="pose",
    show_default=True,
    help="How the robot knows where it is: a camera sees it, to about 1 mm and 0.1 degrees, or it counts on its "
    "wheels, which slip. An ideal robot knows it exactly.",
)
@click.option(
    "--set",
    "parameters",
    metavar="NAME=VALUE",
    multiple=True,
    help="A parameter of the realistic robot, such as track_m=0.33 (docs/sweep.md); the robot itself does not know it.",
)
@click.option(
    "--pace",
    type=click.Choice(["live", "max"]),
    default="max",
    show_default=True,
    help="As fast as the robot would be, or as fast as this PC is.",
)
@click.option(
    "--seed",
    type=click.IntRange(0, 2**53 - 1),
    default=0,
    show_default=True,
    help="Seed of the run's random numbers.",
)
@click.option(
    "--camera",
    metavar="SOURCE",
    help="Who answers captures: the number of a webcam (0 is the first), a video file, a folder of pictures.",
)
@recognizer_option
@input_options
@click.option(
    "--plot",
    type=click.Path(dir_okay=False),
    help="Plot path, position, heading and control signals to a file (.png, .svg, .pdf).",
)
@click.option("--no-store", is_flag=True, help="Do not record the run.")
@database_option
@click.pass_context
def command(
    ctx: click.Context, /, file: str, as_json: bool, no_store: bool, **options: Any
) -> None:
    """Run a program and print its result.

    FILE is a program document or a bare list of commands, as JSON, or Python text; - is standard input. Exit status:
    0 finished, 1 failed or stopped, 2 the program or the world has faults or cannot be read, the camera is missing,
    or no plot can be drawn.
    """
    language = language_of_system()
    wrong = _wrong_plot(options["plot"])
    reading = read_file(file)
    faults = reading.faults or _faults_on(options["robot"], options["model"], reading)
    if faults:
        summary = _faulty(faults, language)
    elif wrong is not None:
        summary = _start_failure_object(wrong, language)
    else:
        for warning in reading.warnings:
            print_problem(warning, language, place=warning.pointer)
        recording = None if no_store else open_recording(chosen_database(ctx), language)
        summary = _run(reading, recording, language, **options)
    click.echo(
        json.dumps(summary, ensure_ascii=False) if as_json else "\n".join(_lines(summary, language))
    )
    ctx.exit(_status(summary))


def _wrong_plot(file: str | None) -> PinelError | None:
    """Checks `--plot` before the run; returns its error, None if a plot can be drawn."""
    if file is not None:
        try:
            plot_format(file)
        except PinelError as error:
            return error
    return None


def _status(summary: dict[str, Any]) -> int:
    reason = summary["reason"]
    if reason in _INVALID_REASONS or (reason or "").startswith(WRONG_RECOGNIZER):
        return _INVALID
    return _FINISHED if summary["state"] == "finished" else _NOT_FINISHED


def _faults_on(link: str, model: str, reading: ParseResult) -> Sequence[Fault]:
    """Returns a fault for each sensor reading of the program that this robot cannot provide."""
    if link == "sim":
        return missing_on_model(reading.document, ROBOTS[model])
    return missing_on_real_robots(reading.document)


def _faulty(faults: Sequence[Fault], language: str) -> dict[str, Any]:
    return faulty_object(
        [_fault_object(fault, language) for fault in faults],
        describe("invalid_program", {"count": len(faults)}, language).message,
    )


def _fault_object(fault: Fault, language: str) -> dict[str, Any]:
    text = explain(fault, language)
    return {
        "code": fault.code,
        "pointer": fault.pointer,
        "block": fault.block,
        "message": text.message,
        "remedy": text.full_remedy,
        "params": fault.params,
    }


def _run(
    reading: ParseResult, recording: Recording | None, language: str, **options: Any
) -> dict[str, Any]:
    curves = Curves() if options["plot"] else None
    try:
        robot = chosen_robot(**{name: options[name] for name in ROBOT_OPTIONS})
        world = _world(robot, options)
        control = RunControl()
        with _inputs(options, language) as inputs, stopped_by_signals(robot, control):
            spec = _spec(reading, world, robot, options, inputs)
            if recording is not None:
                recording.expect(_record(spec, world, options))
            announce_waiting(robot, language)
            observers = (part.observe for part in (recording, curves) if part is not None)
            result = start(spec, all_of(*observers), control)
    except PinelError as error:
        return _start_failure_object(error, language)
    ended = result.ended
    if curves is not None:
        _draw(curves, options["plot"], reading.program.name if reading.program else "", language)
    message = describe(ended.reason, ended.params, language).line if ended.reason else None
    run_id = recording.close() if recording else None
    return run_object(result, run_id, message)


def _world(robot: RobotProfile | None, options: dict[str, Any]) -> ChosenWorld:
    """Returns the simulator's world, or the room of a real robot."""
    if robot is not None:
        return ChosenWorld(ROOM, robot.room.as_world())
    return choose_world(options["world"], robot=options["model"])


def _inputs(options: dict[str, Any], language: str) -> contextlib.AbstractContextManager[RunInputs]:
    """Returns the inputs for captures and questions: a camera, as a context manager, or scripted lists."""
    answers = typed_answers(options["answers"])
    if options["camera"] is None:
        return contextlib.nullcontext(ScriptedInputs(typed_gestures(options["gestures"]), answers))

    def print_camera_problem(state: CameraState) -> None:
        if state.problem:
            print_problem(state.problem, language, place="pinel")

    recognizer = options["recognizer"] or LANDMARKS
    return CameraInputs(options["camera"], recognizer, answers, print_camera_problem)


def _spec(
    reading: ParseResult,
    world: ChosenWorld,
    robot: RobotProfile | None,
    options: dict[str, Any],
    inputs: RunInputs,
) -> RunSpec:
    assert reading.document is not None
    return RunSpec(
        document=reading.document,
        world=world.document,
        link=options["robot"],
        robot=robot,
        setting=SimulationConfig(
            options["model"],
            options["preset"],
            options["feedback"],
            chosen_parameters(options["parameters"]),
        ),
        seed=options["seed"],
        inputs=inputs,
        pace=options["pace"],
        program=reading.program,
    )


def _record(spec: RunSpec, world: ChosenWorld, options: dict[str, Any]) -> RunStart:
    inputs = {
        "gestures": typed_gestures(options["gestures"]),
        "answers": typed_answers(options["answers"]),
    }
    more = {"pace": spec.pace, **inputs}
    return record_of(spec, world_name=world.name, app_version=__version__, more=more)


def _draw(curves: Curves, file: str, title: str, language: str) -> None:
    try:
        draw(curves, file, title=title, language=language)
    except PinelError as error:
        print_problem(error, language, place="pinel")


def _start_failure_object(error: PinelError, language: str) -> dict[str, Any]:
    faults = error.faults if isinstance(error, WorldFileError) else ()
    return unbegun_object(
        error.code,
        explain(error, language).line,
        [_fault_object(fault, language) for fault in faults],
    )


def _lines(summary: dict[str, Any], language: str) -> list[str]:
    """Returns the result as lines of text, for output without --json."""
    reason = f" ({summary['reason']})" if summary["reason"] else ""
    lines = [f"state           {summary['state']}{reason}"]
    if summary["message"]:
        lines.append(f"                {summary['message']}")
    for fault in summary["faults"]:
        place = location_of(fault["pointer"], fault["params"], language)
        lines.append(f"fault           {place}: {fault['message']} {fault['remedy']}")
    lines += [f"said            {text}" for text in summary["said"]]
    for mark in summary["marks"]:
        lines.append(
            f"marked          {mark['symbol']} at x {mark['x_m']:.3f} m, y {mark['y_m']:.3f} m"
        )
    if summary["n_beeps"]:
        lines.append(f"beeped          {summary['n_beeps']} times")
    for name, value in summary["variables"].items():
        lines.append(f"variable        {name} = {_short(value)}")
    return lines + metric_lines(summary)


def _short(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= _MAX_VALUE_LENGTH else text[:_MAX_VALUE_LENGTH] + "…"
