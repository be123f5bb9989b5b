"""Work on a thread of its own, of which only the newest result counts."""

import threading
from collections.abc import Callable
from typing import Generic, TypeVar

Result = TypeVar("Result")


class LatestJob(Generic[Result]):
    """Starts jobs, each on its thread; the result of a job is dropped if a newer one has started.

    Args:
        name: name of the threads.
        notify: called on the thread of a job when its result can be fetched with `pop_result`.
    """

    def __init__(self, name: str, notify: Callable[[], None] = lambda: None) -> None:
        self._name, self._notify = name, notify
        self._lock = threading.Lock()
        self._n_started = 0
        self._result: Result | None = None
        self._is_busy = False

    @property
    def is_busy(self) -> bool:
        """Whether a job runs, or its result was not fetched."""
        return self._is_busy

    def start(self, work: Callable[[], Result]) -> None:
        """Starts a job; `work` raises nothing."""
        with self._lock:
            self._n_started += 1
            self._is_busy = True
            number = self._n_started
        threading.Thread(
            target=self._run, args=(number, work), name=self._name, daemon=True
        ).start()

    def pop_result(self) -> Result | None:
        """Returns the result of the newest job, once; None without one."""
        with self._lock:
            result, self._result = self._result, None
            self._is_busy = self._is_busy and result is None
            return result

    def _run(self, number: int, work: Callable[[], Result]) -> None:
        result = work()
        with self._lock:
            if number == self._n_started:
                self._result = result
        self._notify()
