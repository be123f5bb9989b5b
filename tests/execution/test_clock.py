import pytest

from pinel_desktop.events.model import Event, Telemetry
from pinel_desktop.execution.clock import TICK_S, LiveClock, WallTime
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import Preset, SimulationConfig


class FakeTime:
    def __init__(self) -> None:
        self.now = 100.0
        self.slept: list[float] = []

    def sleep(self, seconds: float) -> None:
        self.slept.append(seconds)
        self.now += seconds


def test_lateness_of_one_tick_does_not_add_up() -> None:
    time = FakeTime()
    clock = LiveClock(WallTime(lambda: time.now, time.sleep))
    for late in (0.0, 0.010, 0.0, 0.005, 0.0):
        clock.wait_for_tick()
        time.now += late
    clock.wait_for_tick()
    assert time.now == pytest.approx(100.0 + 5 * TICK_S)


def test_after_a_freeze_it_goes_on_from_now() -> None:
    time = FakeTime()
    clock = LiveClock(WallTime(lambda: time.now, time.sleep))
    clock.wait_for_tick()
    time.now += 10.0
    clock.wait_for_tick()
    assert time.now == 110.0
    clock.wait_for_tick()
    assert time.now == pytest.approx(110.0 + TICK_S)


def test_ticks_come_as_much_faster_as_somebody_wants() -> None:
    time = FakeTime()
    speed = [2.0]
    clock = LiveClock(WallTime(lambda: time.now, time.sleep), speed=lambda: speed[0])
    for _ in range(3):
        clock.wait_for_tick()
    assert time.now == pytest.approx(100.0 + 2 * TICK_S / 2)
    speed[0] = 0.5
    clock.wait_for_tick()
    assert time.now == pytest.approx(100.0 + TICK_S + 2 * TICK_S)


def test_another_speed_holds_at_once_also_within_a_slow_tick() -> None:
    time, speed = FakeTime(), [0.1]

    def hurry(seconds: float) -> None:
        time.sleep(seconds)
        speed[0] = 1.0

    clock = LiveClock(WallTime(lambda: time.now, hurry), speed=lambda: speed[0])
    clock.wait_for_tick()
    clock.wait_for_tick()
    assert time.now == pytest.approx(100.0 + TICK_S)


@pytest.mark.parametrize("speed", [0.1, 0.5, 1.0, 10.0])
@pytest.mark.parametrize("preset", ["ideal", "realistic"])
@pytest.mark.parametrize("paused", [False, True])
def test_stop_takes_no_longer_in_slow_motion(speed: float, preset: Preset, paused: bool) -> None:
    time, control, commands = FakeTime(), RunControl(), []
    control.set_speed(speed)
    requested_s: list[float] = []

    def observe(tick: int, event: Event) -> None:
        if type(event) is Telemetry:
            if tick == 60:
                if paused:
                    control.pause()
                else:
                    control.stop()
                requested_s.append(time.now)
            if tick == 61 and paused:  # in the middle of coming to rest
                control.stop()
                requested_s[0] = time.now
            if control.stop_requested and len(requested_s) == 1 and tick > 60 + paused:
                commands.append((event.command_v_mps, event.command_omega_radps))

    drive = {"action": "drive", "linear": 1.2, "angular": 60}
    commands_of_run = [
        {"action": "set_speed", "linear": 1.2, "angular": 100},
        drive,
        {"action": "wait", "seconds": 600},
    ]
    program = read_document(commands_of_run).program
    assert program is not None
    link = open_link("sim", world="empty_room", setting=SimulationConfig(preset=preset))
    clock = LiveClock(WallTime(lambda: time.now, time.sleep), speed=lambda: control.pace)
    options = RunOptions(observer=observe, clock=clock, control=control)
    ended = execute(program, link, options).ended
    assert ended.state == "stopped"
    # wheels with inertia take a while from 1.2 m/s
    assert time.now - requested_s[0] < (0.2 if preset == "ideal" else 0.6)
    assert set(commands) == {(0.0, 0.0)}
