"""The judge process: reads requests, judges one program after the other, writes verdicts."""

import logging
from collections.abc import Mapping
from dataclasses import asdict
from functools import lru_cache
from typing import BinaryIO

from pinel_desktop.activities import (
    Activity,
    CheckStatus,
    LiveEvaluation,
    RecordedRun,
    Report,
    RunLog,
    RunLogBuilder,
    case_of_real_run,
    case_of_run,
    check_program,
    input_text,
    judging_blockers,
    path_of,
    tolerance_of,
    world_title,
)
from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import JudgedCase
from pinel_desktop.judge.messages import (
    JudgeRequest,
    ObservedRun,
    PredictionRequest,
    RunStartInfo,
    RunUpdate,
    Verdict,
)
from pinel_desktop.judge.prediction import predicted_run
from pinel_desktop.messages import describe
from pinel_desktop.processes.messages import (
    PING,
    PONG,
    Message,
    read_messages,
    response,
    write_message,
)
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import simulation_config_from
from pinel_desktop.robot.robot_profile import ROOM

# enough for an animation of a few seconds
N_PATH_POSES = 120

_log = logging.getLogger(__name__)


class Judge:
    """Reads requests from one pipe and writes verdicts to another, until the first pipe ends."""

    def __init__(self, requests: BinaryIO, verdicts: BinaryIO) -> None:
        self._requests, self._verdicts = requests, verdicts
        self._evaluator = LiveRunEvaluator()

    def serve(self) -> None:
        """Serves until the input pipe ends."""
        write_message(self._verdicts, {"type": "judge_ready"})
        for message in read_messages(self._requests):
            answer = PONG if message == PING else _respond(message, self._evaluator)
            write_message(self._verdicts, answer)


class LiveRunEvaluator:
    """Collects the events of the live run, of which there is never more than one, and evaluates its checks."""

    def __init__(self) -> None:
        self._run = ""
        self._evaluation: LiveEvaluation | None = None
        self._writer = RunLogBuilder()

    def update(self, run_update: RunUpdate) -> list[CheckStatus] | None:
        """Adds new events; returns the status of each check.

        Returns None if the checks do not apply to the run, or its start is unknown.

        Raises:
            PinelError: any error of `LiveEvaluation`.
        """
        if run_update.start_info is not None:
            self._begin(run_update.run, run_update.start_info)
        if run_update.run != self._run or self._evaluation is None:
            return None
        for event in run_update.events:
            self._writer.add_event(event)
        return self._evaluation.evaluate(self._writer.log(), run_update.language)

    def _begin(self, run: str, start_info: RunStartInfo) -> None:
        evaluation = LiveEvaluation(
            _read(start_info.activity),
            start_info.document,
            start_info.world,
            simulation_config_from(start_info.parameters),
            tolerance_of(start_info.parameters),
        )
        self._run, self._writer = run, RunLogBuilder()
        self._evaluation = evaluation if evaluation.applies else None


def _respond(message: Message, evaluator: LiveRunEvaluator) -> Message:
    number = message["request"]
    try:
        if "follow" in message:
            lines = evaluator.update(RunUpdate.from_message(message))
            return response(number, None if lines is None else [asdict(line) for line in lines])
        if "predict" in message:
            return response(number, asdict(predicted_run(PredictionRequest.from_message(message))))
        return response(number, asdict(verdict_on(JudgeRequest.from_message(message))))
    except PinelError as error:
        return response(number, error=error)
    except Exception as error:
        # a file of another PC may have any content; the judge must continue with the next program
        _log.exception("question %s has no answer", number)
        detail = f"{type(error).__name__}: {error}"
        return response(number, error=PinelError("internal_error", detail=detail))


@lru_cache(maxsize=4)
def _read(activity: str) -> Activity:
    """Parses an activity; cached, because the check list of a run and its verdict both need it."""
    return Activity.model_validate_json(activity)


def verdict_on(request: JudgeRequest) -> Verdict:
    """Judges a program case by case.

    If the observed run is a case of the activity, judges this case by the run. Executes the other cases in the
    simulator. Judges a run on a real robot by its own telemetry, or not at all.

    Raises:
        PinelError: any error of `check_program`, `case_of_run` and `judging_blockers`.
    """
    activity = _read(request.activity)
    recorded_run = _recorded(activity, request.observed) if request.observed else None
    if request.observed and tolerance_of(request.observed.parameters):
        found = judging_blockers(activity)
        reason = found[0].missing if found else None if recorded_run else "inputs"
        if reason is not None:
            return Verdict(None, None, [], not_judged=reason)
    logs: dict[int, RunLog] = {}
    reading = read_document(dict(request.document))
    report = check_program(activity, reading, recorded=recorded_run, on_run=logs.__setitem__)
    missing, block = (None, None) if report.passed else _missing(activity, request, report)
    cases = [asdict(case) for case in report.cases]
    tried = _tried(activity, report, logs, request.language)
    return Verdict(report.passed, missing, cases, block, tried)


def _tried(
    activity: Activity, report: Report, logs: Mapping[int, RunLog], language: str
) -> list[JudgedCase]:
    """Returns each tried case with its result; an empty list if the activity has one case only."""
    if len(activity.cases) == 1:
        return []
    return [
        JudgedCase(
            given=input_text(activity.cases, one.case, language),
            seen=one.recorded,
            passed=one.passed,
            path=[] if one.recorded else path_of(activity, one.case, logs[one.case], N_PATH_POSES),
        )
        for one in report.cases
    ]


def _recorded(activity: Activity, observed: ObservedRun) -> RecordedRun | None:
    log = RunLog.of_columns(lambda name: observed.columns[name], observed.events)
    tolerance = tolerance_of(observed.parameters)
    if tolerance is None:
        case = case_of_run(
            activity, observed.world, simulation_config_from(observed.parameters), log
        )
    else:
        case = case_of_real_run(activity, log)
    return None if case is None else RecordedRun(log, case, tolerance)


def _missing(
    activity: Activity, request: JudgeRequest, report: Report
) -> tuple[str | None, str | None]:
    """Returns the text for the group, and the id of the block that the text is about.

    A run in the wrong world has priority, because the checks are about a world that the group did not use.
    """
    language, title = request.language, world_title(activity, request.language)
    is_other_world = request.world not in (activity.world, ROOM)
    if title is not None and is_other_world:
        return describe("check_other_world", {"world": title}, language).message, None
    return (report.advice.words[language], report.advice.block) if report.advice else (None, None)
