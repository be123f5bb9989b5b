"""Grades the runs of lessons with an activity.

If the run that the group watched was a case of the activity, the judge evaluates its record. The judge's process then
runs the other cases in the simulator. A run passes if it finished and all cases pass. A finished run on a real robot is
judged by the robot's measurements if the activity allows that. Otherwise it is not judged.
"""

import contextlib
import logging
import threading
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import Judged
from pinel_desktop.messages import describe
from pinel_desktop.school.own_activities import known_activity
from storage import SIMULATOR, RunRow, Store, StoreError

if TYPE_CHECKING:
    from pinel_desktop.activities import Activity
    from pinel_desktop.judge.client import JudgeClient
    from pinel_desktop.judge.messages import JudgeRequest, ObservedRun, RunStartInfo, Verdict

_log = logging.getLogger(__name__)
NOT_JUDGED = "not_judged"  # parameter of a run that the group only watches: why it is not judged


class Grader:
    """Grades ended runs one after the other on a thread. Must be closed, which ends the judge.

    Args:
        settle: waits until everything recorded of a run is in the store.
        publish: sends an event to the page.
        judge: returns the verdicts; None is a judge with a process of its own.
    """

    def __init__(
        self,
        store: Store,
        settle: Callable[[], None],
        publish: Callable[[dict[str, Any]], None],
        language: Callable[[], str],
        judge: "JudgeClient | None" = None,
    ) -> None:
        self._store, self._settle, self._publish = store, settle, publish
        self._language, self._judge = language, judge
        self._worker = ThreadPoolExecutor(1, thread_name_prefix="grader")
        self._start_info: dict[str, RunStartInfo] = {}  # of the live run, by its id
        self._lock = threading.Lock()
        self._is_closed = False

    @property
    def judge(self) -> "JudgeClient":
        """The client of the judge, whose process starts with the first request or with `prepare`.

        Raises PinelError `judge_lost` if the first request comes after `close`.
        """
        from pinel_desktop.judge.client import JudgeClient  # noqa: PLC0415 - not needed to start

        with self._lock:
            if self._judge is None:
                if self._is_closed:
                    raise PinelError("judge_lost")
                self._judge = JudgeClient()
            return self._judge

    def prepare(self, run_id: str, start_info: "RunStartInfo") -> None:
        """Stores the live run's data for the judge, and starts the judge, so that it is warm when the run ends."""
        self._start_info = {run_id: start_info}
        self.judge.start()

    def grade(self, run_id: str) -> None:
        """Queues a run that has ended; does nothing for a run without an activity."""
        # the app is closing: `catch_up` grades the run at the next start
        with contextlib.suppress(RuntimeError):
            self._worker.submit(self._grade, run_id)

    def catch_up(self) -> None:
        """Queues the runs that were not graded before the app was closed."""
        with contextlib.suppress(StoreError):
            for run_id in self._store.grading_results.pending():
                self.grade(run_id)

    def close(self) -> None:
        """Drops the queue; `catch_up` restores it at the next start."""
        self._worker.shutdown(wait=False, cancel_futures=True)
        with self._lock:
            self._is_closed = True
        if self._judge is not None:
            self._judge.close()
        self._worker.shutdown()

    def _grade(self, run_id: str) -> None:
        try:
            self._settle()
            run = self._store.runs.get(run_id)
            if run.activity is None or run.state == "running" or run.unconfirmed:
                return
            if run.passed is not None or run.check_report is not None:
                return
            verdict = self.verdict_on(run)
            self._store.grading_results.record(run_id, verdict.passed, _report(run, verdict))
            self._publish(self._judged(run, verdict).to_wire())
        except (PinelError, StoreError) as error:  # an activity of a newer release, or a full disk
            _log.warning("run %s was not graded: %s", run_id, error)
            if isinstance(error, PinelError) and error.code == "judge_lost":
                text = describe(error.code, {}, self._language())
                self._publish(Judged(run_id, False, f"{text.message} {text.remedy}").to_wire())

    def verdict_on(self, run: RunRow) -> "Verdict":
        """Returns the judge's verdict on a run from its record. Raises PinelError, StoreError."""
        from pinel_desktop.judge.messages import Verdict  # noqa: PLC0415 - heavy

        if isinstance(reason := run.parameters.get(NOT_JUDGED), str):
            return Verdict(None, None, [], not_judged=reason)
        if run.link == SIMULATOR:
            verdict = self._verdict(self._judge_request(run))
            return replace(verdict, passed=run.state == "finished" and verdict.passed)
        if run.state != "finished":
            return Verdict(None, None, [], not_judged=run.state)
        question = self._judge_request(run)
        if question.observed is None:
            return Verdict(None, None, [], not_judged="record")
        return self._verdict(question)

    def _judged(self, run: RunRow, verdict: "Verdict") -> Judged:
        from pinel_desktop.activities import not_judged_text  # noqa: PLC0415 - heavy

        why = verdict.not_judged
        return Judged(
            run.id,
            verdict.passed,
            verdict.missing,
            verdict.block,
            verdict.tried,
            by_robot=run.link != SIMULATOR and verdict.passed is not None,
            not_judged=not_judged_text(why, self._language()) if why else None,
        )

    def _verdict(self, question: "JudgeRequest") -> "Verdict":
        """Asks the judge; once more if its process exits or hangs, because the PC may have been short of memory."""
        try:
            return self.judge.judge(question)
        except PinelError as error:
            if error.code != "judge_lost":
                raise
            return self.judge.judge(question)

    def _judge_request(self, run: RunRow) -> "JudgeRequest":
        from pinel_desktop.judge.messages import JudgeRequest  # noqa: PLC0415 - heavy

        start_info = self._start_info.get(run.id) or start_info_of(self._store, run)
        return JudgeRequest(
            activity=start_info.activity,
            document=start_info.document,
            world=run.world,
            observed=self._observed_run(run),
            language=self._language(),
        )

    def _observed_run(self, run: RunRow) -> "ObservedRun | None":
        """Returns the recorded run for the judge; None if the run was stopped or has no telemetry."""
        from pinel_desktop.activities.run_log import COLUMNS  # noqa: PLC0415 - heavy
        from pinel_desktop.judge.messages import ObservedRun  # noqa: PLC0415 - heavy

        telemetry = self._store.runs.telemetry(run.id)
        if run.state == "stopped" or len(telemetry.rows) == 0:
            return None
        return ObservedRun(
            world=run.world_document,
            parameters=run.parameters,
            columns={name: telemetry.column(name) for name in COLUMNS},
            events=tuple(self._store.runs.events(run.id)),
        )


def start_info_of(
    store: Store,
    run: RunRow,
    activity: "Activity | None" = None,
    document: Mapping[str, Any] | None = None,
) -> "RunStartInfo":
    """Returns the data of a run that the judge needs. Reads activity and document from the store if they are None.

    Raises:
        PinelError: as `known_activity`.
    """
    from pinel_desktop.judge.messages import RunStartInfo  # noqa: PLC0415 - heavy

    activity = activity or known_activity(store, run.activity or "")
    if document is None and run.version_id:
        document = store.versions.get(run.version_id).document
    return RunStartInfo(
        activity.model_dump_json(), document or {}, run.world_document, run.parameters
    )


def _report(run: RunRow, verdict: "Verdict") -> dict[str, Any]:
    """Returns the stored report: the cases, and for a real run whether its measurements were judged, or why not."""
    report: dict[str, Any] = {"cases": verdict.cases}
    if verdict.not_judged:
        return {**report, "not_judged": verdict.not_judged}
    return report if run.link == SIMULATOR else {**report, "by": "robot"}
