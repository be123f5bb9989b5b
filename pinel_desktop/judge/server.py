"""The judge's process: reads questions, judges one program after the other, writes verdicts."""

import logging
from dataclasses import asdict
from typing import BinaryIO

from pinel_desktop.activities import (
    Activity,
    RecordedRun,
    Report,
    RunLog,
    case_of_run,
    check_program,
    world_title,
)
from pinel_desktop.errors import PinelError
from pinel_desktop.judge.messages import Question, SeenRun, Verdict
from pinel_desktop.messages import describe
from pinel_desktop.processes.messages import Message, read_messages, write_message
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import setting_from

_log = logging.getLogger(__name__)


class Judge:
    """Answers the questions of one pipe with verdicts on another, until the first one ends."""

    def __init__(self, questions: BinaryIO, verdicts: BinaryIO) -> None:
        self._questions, self._verdicts = questions, verdicts

    def serve(self) -> None:
        """Works until the questions end."""
        write_message(self._verdicts, {"type": "judge_ready"})
        for message in read_messages(self._questions):
            write_message(self._verdicts, _answer(message))


def _answer(message: Message) -> Message:
    number = message["question"]
    try:
        verdict = verdict_on(Question.from_message(message))
    except PinelError as error:
        return {"type": "refused", "question": number, "code": error.code, "params": error.params}
    except Exception as error:
        # a file of another PC may hold anything; the next program must still be judged
        _log.exception("question %s has no answer", number)
        params = {"detail": f"{type(error).__name__}: {error}"}
        return {"type": "refused", "question": number, "code": "internal_error", "params": params}
    return {"type": "verdict", "question": number, **asdict(verdict)}


def verdict_on(question: Question) -> Verdict:
    """Judges a program: the run that was seen where it was a case of the activity, the other cases in the simulator.

    Raises:
        PinelError: what `check_program` and `case_of_run` raise.
    """
    activity = Activity.model_validate(question.activity)
    seen = _recorded(activity, question.seen) if question.seen else None
    report = check_program(activity, read_document(dict(question.document)), recorded=seen)
    missing = None if report.passed else _missing(activity, question, report)
    return Verdict(report.passed, missing, [asdict(case) for case in report.cases])


def _recorded(activity: Activity, seen: SeenRun) -> RecordedRun | None:
    log = RunLog.of_columns(lambda name: seen.columns[name], seen.events)
    case = case_of_run(activity, seen.world, setting_from(seen.parameters), log)
    return None if case is None else RecordedRun(log, case)


def _missing(activity: Activity, question: Question, report: Report) -> str | None:
    """What to tell the group. A run in another world comes first: the group has not seen what the checks are about."""
    language, title = question.language, world_title(activity, question.language)
    if title is not None and question.world != activity.world:
        return describe("check_other_world", {"world": title}, language).message
    return report.advice.words[language] if report.advice else None
