"""The clocks of a school PC, for tests."""

from datetime import UTC, datetime, timedelta


class SchoolClock:
    """A wall clock that can be set, and a monotonic one."""

    def __init__(self, start: datetime = datetime(2026, 3, 2, 8, 0, tzinfo=UTC)) -> None:
        self.time = start
        self._uptime_s = 100.0

    def __call__(self) -> datetime:
        return self.time

    def uptime(self) -> float:
        return self._uptime_s

    def passes(self, **amount: float) -> None:
        passed = timedelta(**amount)
        self.time += passed
        self._uptime_s += passed.total_seconds()

    def is_set(self, **amount: float) -> None:
        self.time += timedelta(**amount)
