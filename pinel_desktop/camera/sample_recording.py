"""Recording of the samples that train a taught sign, on the app's side."""

import time
from collections.abc import Callable

_TIMEOUT_S = 15.0  # without a hand at rest, or without a movement


class SampleRecording:
    """Collects samples until there are enough.

    Args:
        n_samples: number of samples to record.
        on_samples: as in `CameraClient.record`.
        on_stop: as in `CameraClient.record`.
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
        """True if no sample was added for `_TIMEOUT_S`."""
        return time.monotonic() - self._added_s > _TIMEOUT_S

    def add(self, sample: bytes) -> tuple[bytes, ...]:
        """Adds a sample; returns all samples."""
        self._samples = (*self._samples, sample)
        self._added_s = time.monotonic()
        return self._samples
