"""Hands events to every open page. A page that reads too slowly loses events that are `lossy`, never others."""

import threading
from collections import deque
from types import TracebackType
from typing import Any

from pinel_desktop.events.types import LOSSY

Event = dict[str, Any]

CAPACITY = 600  # lossy events waiting for one reader: telemetry of 20 s
_LIMIT = 20_000  # events of other kinds; a reader that far behind is gone and is cut off


class Subscription:
    """One reader's queue. Use as a context manager, or call `close`."""

    def __init__(self, hub: "Hub", capacity: int) -> None:
        self._hub = hub
        self._capacity = capacity
        self._waiting: deque[Event] = deque()
        self._n_lossy = 0
        self._changed = threading.Condition()
        self._closed = False

    @property
    def closed(self) -> bool:
        """True once the hub is closed or the reader was cut off, and nothing is left to read."""
        with self._changed:
            return self._closed and not self._waiting

    def put(self, event: Event) -> None:
        """Adds an event; where too many lossy events wait, the oldest of them is dropped."""
        with self._changed:
            if not self._closed:
                self._drop_surplus(event)
            if not self._closed:
                self._waiting.append(event)
            self._changed.notify()

    def get(self, timeout_s: float) -> Event | None:
        """The next event, or None when nothing came in time or the queue was closed."""
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or self._closed, timeout_s)
            if not self._waiting:
                return None
            event = self._waiting.popleft()
            self._n_lossy -= _is_lossy(event)
            return event

    def close(self) -> None:
        """Wakes the reader; what waits may still be read."""
        self._hub.unsubscribe(self)
        with self._changed:
            self._closed = True
            self._changed.notify_all()

    def __enter__(self) -> "Subscription":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _drop_surplus(self, event: Event) -> None:
        self._n_lossy += _is_lossy(event)
        if self._n_lossy > self._capacity:
            self._waiting.remove(next(filter(_is_lossy, self._waiting)))
            self._n_lossy -= 1
        if len(self._waiting) >= _LIMIT:
            self._closed = True
            self._waiting.clear()


class Hub:
    """Thread-safe; `publish` never waits for a reader."""

    def __init__(self, capacity: int = CAPACITY) -> None:
        self._capacity = capacity
        self._readers: tuple[Subscription, ...] = ()
        self._lock = threading.Lock()
        self._closed = False

    def subscribe(self) -> Subscription:
        """A queue that gets every event published from now on."""
        reader = Subscription(self, self._capacity)
        with self._lock:
            if not self._closed:
                self._readers += (reader,)
                return reader
        reader.close()
        return reader

    def has_readers(self) -> bool:
        """Whether any page is open."""
        return bool(self._readers)

    def publish(self, event: Event) -> None:
        """Hands the event to every reader; readers must not change it."""
        for reader in self._readers:
            reader.put(event)

    def unsubscribe(self, reader: Subscription) -> None:
        """Takes a reader out."""
        with self._lock:
            self._readers = tuple(other for other in self._readers if other is not reader)

    def close(self) -> None:
        """Ends every subscription, now and later."""
        with self._lock:
            self._closed = True
            readers = self._readers
        for reader in readers:
            reader.close()


def _is_lossy(event: Event) -> bool:
    return event.get("type") in LOSSY
