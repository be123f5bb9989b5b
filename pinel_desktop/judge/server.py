"""The judge's process: reads questions, judges one program after the other, writes verdicts."""

import logging
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
    tolerance_of,
    world_title,
)
from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import JudgedCase
from pinel_desktop.judge.messages import JudgeRequest, ObservedRun, RunStartInfo, RunUpdate, Verdict
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

_log = logging.getLogger(__name__)


class Judge:
    """Answers the questions of one pipe with verdicts on another, until the first one ends."""

    def __init__(self, requests: BinaryIO, verdicts: BinaryIO) -> None:
        self._requests, self._verdicts = requests, verdicts
        self._evaluator = LiveRunEvaluator()

    def serve(self) -> None:
        """Works until the questions end."""
        write_message(self._verdicts, {"type": "judge_ready"})
        for message in read_messages(self._requests):
            answer = PONG if message == PING else _respond(message, self._evaluator)
            write_message(self._verdicts, answer)


class LiveRunEvaluator:
    """The run that goes on, with all that it has told; there is never more than one."""

    def __init__(self) -> None:
        self._run = ""
        self._evaluation: LiveEvaluation | None = None
        self._writer = RunLogBuilder()

    def update(self, run_update: RunUpdate) -> list[CheckStatus] | None:
        """Status of each check of its activity; None where they are not about it, or its beginning is unknown.

        Raises:
            PinelError: what `LiveEvaluation` raises.
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
        return response(number, asdict(verdict_on(JudgeRequest.from_message(message))))
    except PinelError as error:
        return response(number, error=error)
    except Exception as error:
        # a file of another PC may hold anything; the next program must still be judged
        _log.exception("question %s has no answer", number)
        detail = f"{type(error).__name__}: {error}"
        return response(number, error=PinelError("internal_error", detail=detail))


@lru_cache(maxsize=4)
def _read(activity: str) -> Activity:
    """An activity, which is read once for the check list of a run and its verdict."""
    return Activity.model_validate_json(activity)


def verdict_on(request: JudgeRequest) -> Verdict:
    """Judges a program: the run that was seen where it was a case of the activity, the other cases in the simulator.

    A run on a real robot is judged by its own telemetry, or not at all.

    Raises:
        PinelError: what `check_program`, `case_of_run` and `judging_blockers` raise.
    """
    activity = _read(request.activity)
    recorded_run = _recorded(activity, request.observed) if request.observed else None
    if request.observed and tolerance_of(request.observed.parameters):
        found = judging_blockers(activity)
        reason = found[0].missing if found else None if recorded_run else "inputs"
        if reason is not None:
            return Verdict(None, None, [], not_judged=reason)
    report = check_program(activity, read_document(dict(request.document)), recorded=recorded_run)
    missing, block = (None, None) if report.passed else _missing(activity, request, report)
    cases = [asdict(case) for case in report.cases]
    tried = _tried(activity, report, request.language)
    return Verdict(report.passed, missing, cases, block, tried)


def _tried(activity: Activity, report: Report, language: str) -> list[JudgedCase]:
    """What was tried, where an activity has several cases."""
    if len(activity.cases) == 1:
        return []
    given = [input_text(case, language) for case in activity.cases]
    return [
        JudgedCase(given=given[one.case - 1], seen=one.recorded, passed=one.passed)
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
    """What to tell the group, and the block to look at.

    A run in another world comes first: the group has not seen what the checks are about.
    """
    language, title = request.language, world_title(activity, request.language)
    is_other_world = request.world not in (activity.world, ROOM)
    if title is not None and is_other_world:
        return describe("check_other_world", {"world": title}, language).message, None
    return (report.advice.words[language], report.advice.block) if report.advice else (None, None)
