"""Distributes the preview pictures of the camera process to all viewers."""

import threading
from collections.abc import Iterator


class Preview:
    """The newest picture, and the number of viewers that wait for the next one."""

    def __init__(self, closing: threading.Event) -> None:
        self._closing = closing
        self._changed = threading.Condition()
        self._picture, self._number, self._n_watching = b"", 0, 0

    def enter(self) -> bool:
        """Adds a viewer; returns whether there is any viewer, always True."""
        with self._changed:
            self._n_watching += 1
            return True

    def leave(self) -> bool:
        """Removes a viewer; returns whether any viewer remains."""
        with self._changed:
            self._n_watching -= 1
            return self._n_watching > 0

    def show(self, picture: bytes) -> None:
        with self._changed:
            self._picture, self._number = picture, self._number + 1
            self._changed.notify_all()

    def notify_closing(self) -> None:
        """Wakes all waiting viewers, so that they end with the app."""
        with self._changed:
            self._changed.notify_all()

    def pictures(self, timeout_s: float) -> Iterator[bytes]:
        """Yields each new picture until none arrives for `timeout_s` or the app ends."""
        number, picture = self._next(self._number, timeout_s)
        while picture is not None:
            yield picture
            number, picture = self._next(number, timeout_s)

    def _next(self, last_number: int, timeout_s: float) -> tuple[int, bytes | None]:
        """Waits for a newer picture than `last_number`; returns its number and the picture.

        On a timeout, and when the app ends, the picture is None.
        """
        with self._changed:
            self._changed.wait_for(
                lambda: self._number != last_number or self._closing.is_set(), timeout_s
            )
            is_new = self._number != last_number and not self._closing.is_set()
            return self._number, self._picture if is_new else None
