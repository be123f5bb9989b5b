"""The recording of hands from which a sign is to be learnt, on the app's side."""

import time
from collections.abc import Callable

_TIMEOUT_S = 15.0  # without a hand at rest, or without a movement


class SampleRecording:
    """Collects samples until there are enough.

    Args:
        n_samples: how many are wanted.
        on_samples: as in `Camera.record`.
        on_stop: as in `Camera.record`.
    """

    def __init__(
        self,
        n_samples: int,
        on_samples: Callable[[tuple[bytes, ...]], None],
        on_stop: Callable[[], None],
    ) -> None:
        self.on_samples, self.on_stop = on_samples, on_stop
        self._n_samples = n_samples
        self._samples: tuple[bytes, ...] = ()
        self._added_s = time.monotonic()

    @property
    def is_complete(self) -> bool:
        return len(self._samples) >= self._n_samples

    @property
    def is_given_up(self) -> bool:
        """Nothing was recorded for too long."""
        return time.monotonic() - self._added_s > _TIMEOUT_S

    def add(self, sample: bytes) -> tuple[bytes, ...]:
        """Adds one; returns all."""
        self._samples = (*self._samples, sample)
        self._added_s = time.monotonic()
        return self._samples
