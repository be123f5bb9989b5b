import pytest

from pinel_desktop.execution.clock import TICK_S, LiveClock


class FakeTime:
    def __init__(self) -> None:
        self.now = 100.0
        self.slept: list[float] = []

    def sleep(self, seconds: float) -> None:
        self.slept.append(seconds)
        self.now += seconds


def test_lateness_of_one_tick_does_not_add_up() -> None:
    time = FakeTime()
    clock = LiveClock(lambda: time.now, time.sleep)
    for late in (0.0, 0.010, 0.0, 0.005, 0.0):
        clock.wait_for_tick()
        time.now += late
    clock.wait_for_tick()
    assert time.now == pytest.approx(100.0 + 5 * TICK_S)


def test_after_a_freeze_it_goes_on_from_now() -> None:
    time = FakeTime()
    clock = LiveClock(lambda: time.now, time.sleep)
    clock.wait_for_tick()
    time.now += 10.0
    clock.wait_for_tick()
    assert time.now == 110.0
    clock.wait_for_tick()
    assert time.now == pytest.approx(110.0 + TICK_S)


def test_ticks_come_as_much_faster_as_somebody_wants() -> None:
    time = FakeTime()
    speed = [2.0]
    clock = LiveClock(lambda: time.now, time.sleep, speed=lambda: speed[0])
    for _ in range(3):
        clock.wait_for_tick()
    assert time.now == pytest.approx(100.0 + 2 * TICK_S / 2)
    speed[0] = 0.5
    clock.wait_for_tick()
    assert time.now == pytest.approx(100.0 + TICK_S + 2 * TICK_S)
