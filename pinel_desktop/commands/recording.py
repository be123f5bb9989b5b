"""Records a run of the command line in the database."""

from pathlib import Path

from pinel_desktop.commands.database import require_location
from pinel_desktop.commands.printing import print_problem
from pinel_desktop.errors import PinelError
from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import Event
from pinel_desktop.events.types import RECORDED, URGENT
from storage import RunRecorder, RunStart, Store, StoreError, open_store


class Recording:
    """Records a run in the database. Errors are printed and do not end the run."""

    def __init__(self, store: Store, language: str) -> None:
        self._store, self._language = store, language
        self._recorder: RunRecorder | None = None
        self._stamp = EventSequencer("")
        self._start: RunStart | None = None

    def expect(self, start: RunStart) -> None:
        """Records the run from its first event; a run that cannot start leaves no record."""
        self._start = start

    def observe(self, tick: int, event: Event) -> None:
        if self._start is not None:
            self._begin(self._start)
            self._start = None
        if self._recorder is not None:
            self._recorder(self._stamp.wire(tick, event))

    def _begin(self, start: RunStart) -> None:
        try:
            self._stamp = EventSequencer(self._store.runs.begin(start).id)
        except StoreError as error:
            print_problem(error, self._language, place="pinel")
            return
        self._recorder = RunRecorder(self._store, recorded=RECORDED, urgent=URGENT)

    def close(self) -> str | None:
        """Finishes writing. Returns the run's id, None if it could not be recorded."""
        problem = self._recorder.problem if self._recorder else None
        self._store.close()
        if problem is not None:
            print_problem(problem, self._language, place="pinel")
        return self._stamp.run if self._recorder and problem is None else None


def open_recording(database: Path, language: str) -> Recording | None:
    try:
        require_location(database)
        store = open_store(database)
    except (PinelError, StoreError) as error:
        print_problem(error, language, place="pinel")
        return None
    if store.notice is not None:
        print_problem(store.notice, language, place="pinel")
    return Recording(store, language)
