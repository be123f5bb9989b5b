"""Grades the runs of lessons with an activity.

The run that the group saw is judged where it was a case of the activity; the other cases are run in the simulator
afterwards, on a thread of their own, which takes a fraction of a second. It passes if it finished and all cases pass.
"""

import contextlib
import logging
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import Judged
from pinel_desktop.messages import describe
from pinel_desktop.robot import setting_from
from storage import RunRow, Store, StoreError

if TYPE_CHECKING:
    from pinel_desktop.activities import Activity, RecordedRun, Report

_log = logging.getLogger(__name__)


class Grader:
    """Grades ended runs one after the other on a thread; must be closed.

    Args:
        settle: waits until everything recorded of a run is in the store.
        publish: sends an event to the page.
    """

    def __init__(
        self,
        store: Store,
        settle: Callable[[], None],
        publish: Callable[[dict[str, Any]], None],
        language: Callable[[], str],
    ) -> None:
        self._store, self._settle, self._publish = store, settle, publish
        self._language = language
        self._worker = ThreadPoolExecutor(1, thread_name_prefix="grader")

    def grade(self, run_id: str) -> None:
        """Queues a run that has ended; does nothing for a run without an activity."""
        with contextlib.suppress(
            RuntimeError
        ):  # the app is closing: `catch_up` of the next start grades it
            self._worker.submit(self._grade, run_id)

    def catch_up(self) -> None:
        """Queues the runs that were not yet graded when the app was closed."""
        with contextlib.suppress(StoreError):
            for run_id in self._store.checks.pending():
                self.grade(run_id)

    def close(self) -> None:
        """Drops the queue, which `catch_up` of the next start restores."""
        self._worker.shutdown(cancel_futures=True)

    def _grade(self, run_id: str) -> None:
        try:
            self._settle()
            run = self._store.runs.get(run_id)
            if run.activity is None or run.passed is not None or run.state == "running":
                return
            activity = self._activity(run.activity)
            report = self._report(activity, run)
            passed = run.state == "finished" and report.passed
            kept = {"cases": [asdict(case) for case in report.cases]}
            self._store.checks.record(run_id, passed, kept)
            missing = None if passed else self._missing(activity, run.world, report)
            self._publish(Judged(run_id, passed, missing).flat())
        except (PinelError, StoreError) as error:  # an activity of a newer release; a full disk
            _log.warning("run %s was not graded: %s", run_id, error)

    def _missing(self, activity: "Activity", world: str, report: "Report") -> str | None:
        """What to tell the group; None if the program passes. Where its run was in another world, that comes first: it
        has not seen what the checks are about.
        """
        from pinel_desktop.activities import world_title  # noqa: PLC0415 - heavy

        title = world_title(activity, self._language())
        if title is not None and world != activity.world and not report.passed:
            return describe("check_other_world", {"world": title}, self._language()).message
        return report.advice.words[self._language()] if report.advice else None

    @staticmethod
    def _activity(name: str) -> "Activity":
        from pinel_desktop.activities import shipped_activity  # noqa: PLC0415 - heavy

        return shipped_activity(name)

    def _report(self, activity: "Activity", run: RunRow) -> "Report":
        from pinel_desktop.activities import check_program  # noqa: PLC0415 - heavy
        from pinel_desktop.program.reading import read_document  # noqa: PLC0415

        document = self._store.versions.get(run.version_id).document if run.version_id else None
        recorded = self._recorded(activity, run)
        return check_program(activity, read_document(document or {}), recorded=recorded)

    def _recorded(self, activity: "Activity", run: RunRow) -> "RecordedRun | None":
        """The run that the group saw, where it was a case of the activity and its record is whole."""
        from pinel_desktop.activities import RecordedRun, RunLog, case_of_run  # noqa: PLC0415 - heavy

        telemetry = self._store.runs.telemetry(run.id)
        log = RunLog.of_columns(telemetry.column, self._store.runs.events(run.id))
        if run.link != "sim" or run.state == "stopped" or len(telemetry.rows) == 0:
            return None
        case = case_of_run(activity, run.world_document, setting_from(run.parameters), log)
        return None if case is None else RecordedRun(log, case)
