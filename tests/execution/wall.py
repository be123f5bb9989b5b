"""Simulated wall time, advanced by tests."""

from collections.abc import Callable

from pinel_desktop.execution.clock import WallTime


class Wall:
    """Time advances on `sleep`; actions scheduled with `at` run when it passes them."""

    def __init__(self, start_s: float = 100.0) -> None:
        self._start_s = self._now_s = start_s
        self._plans: list[tuple[float, Callable[[], None]]] = []
        self.time = WallTime(lambda: self._now_s, self.sleep)

    @property
    def passed_s(self) -> float:
        return self._now_s - self._start_s

    def at(self, seconds: float, act: Callable[[], None]) -> None:
        self._plans.append((seconds, act))

    def sleep(self, seconds: float) -> None:
        self._now_s += seconds
        due = [plan for plan in self._plans if plan[0] <= self.passed_s]
        self._plans = [plan for plan in self._plans if plan not in due]
        for _, act in due:
            act()
