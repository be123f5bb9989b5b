"""Publishes events to every open page (publish/subscribe). A page that reads too slowly loses only `lossy` events."""

import threading
from collections import deque
from types import TracebackType
from typing import Any

from pinel_desktop.events.types import LOSSY

Event = dict[str, Any]

CAPACITY = 600  # lossy events in the queue of one reader: telemetry of 20 s
_LIMIT = 20_000  # events in the queue; a reader that far behind has disappeared and is unsubscribed


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
        """True once the subscription has ended and its queue is empty."""
        with self._changed:
            return self._closed and not self._waiting

    def put(self, event: Event) -> None:
        """Queues an event. If the queue holds too many lossy events, drops the oldest lossy event."""
        with self._changed:
            if not self._closed:
                self._drop_surplus(event)
            if not self._closed:
                self._waiting.append(event)
            self._changed.notify()

    def get(self, timeout_s: float) -> Event | None:
        """Returns the next event, or None after `timeout_s` or once the subscription has ended."""
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or self._closed, timeout_s)
            if not self._waiting:
                return None
            event = self._waiting.popleft()
            self._n_lossy -= _is_lossy(event)
            return event

    def close(self) -> None:
        """Ends the subscription and wakes the reader, which may still read the queued events."""
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
    """Publishes events to subscriptions; thread-safe. `publish` never waits for a reader.

    Attributes:
        first_reader: set once a page is or was open.
    """

    def __init__(self, capacity: int = CAPACITY) -> None:
        self.first_reader = threading.Event()
        self._capacity = capacity
        self._readers: tuple[Subscription, ...] = ()
        self._lock = threading.Lock()
        self._closed = False

    def subscribe(self) -> Subscription:
        """Returns a new subscription, which receives every event from now on."""
        reader = Subscription(self, self._capacity)
        self.first_reader.set()
        with self._lock:
            if not self._closed:
                self._readers += (reader,)
                return reader
        reader.close()
        return reader

    def has_readers(self) -> bool:
        """Returns whether any page is open."""
        return bool(self._readers)

    def publish(self, event: Event) -> None:
        """Queues the event for every reader; readers must not change it."""
        for reader in self._readers:
            reader.put(event)

    def unsubscribe(self, reader: Subscription) -> None:
        """Removes a subscription."""
        with self._lock:
            self._readers = tuple(other for other in self._readers if other is not reader)

    def close(self) -> None:
        """Ends all subscriptions; later ones end at once."""
        with self._lock:
            self._closed = True
            readers = self._readers
        for reader in readers:
            reader.close()


def _is_lossy(event: Event) -> bool:
    return event.get("type") in LOSSY
