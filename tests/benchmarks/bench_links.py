"""The DDS link on this PC's loopback: round trip, Stop, and the square on a realistic double.

Bounds of times may be exceeded by what a bare sleeper of the same run is late.
"""

import contextlib
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from statistics import median

from pinel_desktop.errors import PinelError
from pinel_desktop.links.dds.transport import DdsTransport
from pinel_desktop.links.transport import Localised, Odometry
from pinel_desktop.robot import PIONEER_3DX, STANDSTILL, Twist2D
from pinel_desktop.runs.spec import RunSpec
from tests.links.dds_domains import local_profile, own_domain
from tests.links.dds_peer import DdsPeer
from tests.links.double_process import ROOT, Double
from tests.links.real_link_contract import FAR, LiveRun

ROUND_TRIPS = 500
STOPS = 10
SEEDS = 10
AT_ONCE = 5
SQUARE = ROOT / "tests" / "programs" / "square.json"


def percentile(values: list[float], part: float) -> float:
    return sorted(values)[round(part * (len(values) - 1))]


@contextlib.contextmanager
def sleeper(period_s: float) -> Iterator[list[float]]:
    """Times (s) between the wakings of a thread that only sleeps, meanwhile."""
    gaps: list[float] = []
    ending = threading.Event()

    def work() -> None:
        last_s = time.monotonic()
        while not ending.wait(period_s):
            now_s = time.monotonic()
            gaps.append(now_s - last_s)
            last_s = now_s

    thread = threading.Thread(target=work)
    thread.start()
    yield gaps
    ending.set()
    thread.join()


class Echoed:
    """A receiver that notes when each answer came, by the velocity that it answers."""

    def __init__(self) -> None:
        self.at_s: dict[float, float] = {}
        self.came = threading.Event()

    def on_odometry(self, odometry: Odometry) -> None:
        self.at_s.setdefault(odometry.x_m, time.perf_counter())
        self.came.set()

    def on_holder(self, name: str | None) -> None:
        pass

    def on_localised(self, localised: Localised) -> None:
        raise AssertionError("this robot has no localisation")

    def on_battery(self, level: float) -> None:
        del level

    def on_problem(self, problem: PinelError) -> None:
        raise problem


def test_round_trip_on_loopback() -> None:
    with own_domain() as domain:
        echo = subprocess.Popen(
            [sys.executable, "-m", "tests.links.dds_echo", str(domain)],
            cwd=ROOT,
            stdout=subprocess.PIPE,
        )
        assert echo.stdout is not None
        echo.stdout.readline()
        try:
            with sleeper(0.01) as gaps:
                trips = round_trips(domain)
        finally:
            echo.kill()
            echo.communicate()
    middle_s, p99_s = median(trips), percentile(trips, 0.99)
    late_s = percentile(gaps, 0.99) - 0.01
    print(f"Twist to Odometry: median {middle_s * 1e3:.2f} ms, p99 {p99_s * 1e3:.2f} ms")
    print(f"  a bare sleeper of the same run: p99 {late_s * 1e3:.2f} ms late")
    assert middle_s < 0.002
    assert p99_s < 0.010 + late_s


def round_trips(domain: int) -> list[float]:
    receiver = Echoed()
    transport = DdsTransport(local_profile(domain), PIONEER_3DX)
    with contextlib.closing(transport):
        transport.open(receiver, lambda: False)
        return [round_trip(transport, receiver, number) for number in range(1, ROUND_TRIPS + 1)]


def round_trip(transport: DdsTransport, receiver: Echoed, number: int) -> float:
    """The answers to the zeros of the opening may still be on their way: only that to `number` counts."""
    start_s = time.perf_counter()
    transport.send(Twist2D(float(number), 0.0))
    while number not in receiver.at_s:
        receiver.came.clear()
        assert number in receiver.at_s or receiver.came.wait(2.0)
    time.sleep(0.02)
    return receiver.at_s[float(number)] - start_s


def test_stop_reaches_the_robot_at_once() -> None:
    with sleeper(0.01) as gaps:
        late = [stopped_after_s() for _ in range(STOPS)]
    p95_s, sleeper_s = percentile(late, 0.95), percentile(gaps, 0.95) - 0.01
    print(f"Stop to the first zero: median {median(late) * 1e3:.0f} ms, p95 {p95_s * 1e3:.0f} ms")
    assert p95_s < 0.1 + sleeper_s


def stopped_after_s() -> float:
    with own_domain() as domain, contextlib.closing(DdsPeer(domain)) as robot:
        record = local_profile(domain)
        run = LiveRun(RunSpec(FAR, "empty_room", link="dds", robot=record))
        run.thread.start()
        while not any(twist.v_mps > 0.1 for _, twist in robot.received[-1:]):
            time.sleep(0.01)
        stopped_s = time.monotonic()
        run.control.stop()
        run.result()
        zeros = [at_s for at_s, twist in robot.received if at_s > stopped_s and twist == STANDSTILL]
        return zeros[0] - stopped_s


def test_the_square_closes_on_a_realistic_robot() -> None:
    with ThreadPoolExecutor(AT_ONCE) as workers:
        errors = list(workers.map(closing_error_m, range(SEEDS)))
    p95_m = percentile(errors, 0.95)
    print(
        f"closing error of {SEEDS} seeds: median {median(errors) * 1e3:.1f} mm, p95 {p95_m * 1e3:.1f}"
    )
    assert p95_m <= 0.005


def closing_error_m(seed: int) -> float:
    with own_domain() as domain, contextlib.closing(Double(domain, seed)) as double:
        result = double.run(Path(SQUARE))
        assert result["state"] == "finished", result
        return double.closing_error_m()
