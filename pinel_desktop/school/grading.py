"""After a run of a lesson with an activity: whether its program fulfils it.

A run passes when it came to its end and its program holds in every case of the activity, which are run again without
anybody watching. That takes a fraction of a second; it happens on a thread of its own after the run.
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
from storage import Store, StoreError

if TYPE_CHECKING:
    from pinel_desktop.activities import Report

_log = logging.getLogger(__name__)


class Grader:
    """Grades runs that have ended, one after the other; to be closed at the end.

    Args:
        settle: returns when all that is known of a run can be read from the store.
        publish: tells the page what came of a run.
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
        """Grades a run that has just ended, if its lesson has an activity."""
        with contextlib.suppress(RuntimeError):  # the app is closing: the next start does it
            self._worker.submit(self._grade, run_id)

    def catch_up(self) -> None:
        """Grades the runs that were still waiting when the app was closed."""
        with contextlib.suppress(StoreError):
            for run_id in self._store.checks.pending():
                self.grade(run_id)

    def close(self) -> None:
        """Leaves for the next start what has not begun yet."""
        self._worker.shutdown(cancel_futures=True)

    def _grade(self, run_id: str) -> None:
        try:
            self._settle()
            run = self._store.runs.get(run_id)
            if run.activity is None or run.passed is not None or run.state == "running":
                return
            report = self._report(run.activity, run.version_id)
            passed = run.state == "finished" and report.passed
            kept = {"cases": [asdict(case) for case in report.cases]}
            self._store.checks.record(run_id, passed, kept)
            missing = None if passed else self._missing(report)
            self._publish(Judged(run_id, passed, missing).flat())
        except (PinelError, StoreError) as error:  # an activity of a newer release; a full disk
            _log.warning("run %s was not graded: %s", run_id, error)

    def _missing(self, report: "Report") -> str | None:
        """In words the first thing that does not hold, None where all of it does."""
        for case in report.cases:
            if case.reason is not None:
                return describe(case.reason, case.params, self._language()).message
            for check in case.checks:
                if not check.holds:
                    return describe(f"check_{check.kind}", check.params, self._language()).message
        return None

    def _report(self, activity: str, version_id: str | None) -> "Report":
        from pinel_desktop.activities import activity_names, check_program, choose_activity  # noqa: PLC0415 - heavy
        from pinel_desktop.program.reading import read_document  # noqa: PLC0415

        if activity not in activity_names():  # never a file: the name may come from another PC
            raise PinelError("unknown_activity", value=activity, allowed=activity_names())
        document = self._store.versions.get(version_id).document if version_id else None
        return check_program(choose_activity(activity), read_document(document or {}))
