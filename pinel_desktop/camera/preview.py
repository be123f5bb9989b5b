"""The pictures that the camera process sends, for all who watch."""

import threading
from collections.abc import Iterator


class Preview:
    """The newest picture and who waits for the next one."""

    def __init__(self, closing: threading.Event) -> None:
        self._closing = closing
        self._changed = threading.Condition()
        self._picture, self._number, self._n_watching = b"", 0, 0

    def enter(self) -> bool:
        """Somebody begins to watch; returns whether anybody does."""
        with self._changed:
            self._n_watching += 1
            return True

    def leave(self) -> bool:
        """Somebody has watched enough; returns whether anybody still watches."""
        with self._changed:
            self._n_watching -= 1
            return self._n_watching > 0

    def show(self, picture: bytes) -> None:
        with self._changed:
            self._picture, self._number = picture, self._number + 1
            self._changed.notify_all()

    def notify_closing(self) -> None:
        """Lets all who wait see that the app ends."""
        with self._changed:
            self._changed.notify_all()

    def pictures(self, timeout_s: float) -> Iterator[bytes]:
        """Each new picture, until none comes for `timeout_s` or the app ends."""
        number, picture = self._next(self._number, timeout_s)
        while picture is not None:
            yield picture
            number, picture = self._next(number, timeout_s)

    def _next(self, last_number: int, timeout_s: float) -> tuple[int, bytes | None]:
        """The picture after the one of that number, and its own number; None where there is none."""
        with self._changed:
            self._changed.wait_for(
                lambda: self._number != last_number or self._closing.is_set(), timeout_s
            )
            is_new = self._number != last_number and not self._closing.is_set()
            return self._number, self._picture if is_new else None
