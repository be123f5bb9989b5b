"""Sweeps the controller's gains one at a time, over all closed figures driven by a realistic robot.

    .venv/bin/python scripts/sweep_gains.py

Prints for each value the distance and the heading error at the end (95th percentile over seeds and figures), the
cross-track error (root mean square) and the change of the commanded speed from tick to tick (root mean square). Marks
the value in use. docs/control.md explains the choice.
"""

import itertools
import math
from pathlib import Path
from typing import NamedTuple

from pinel_desktop.control import SLIPPING_GAINS, Gains
from pinel_desktop.events.model import Event, Telemetry
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import SimulationConfig

PROGRAMS = Path(__file__).parents[1] / "tests" / "programs"
FIGURES = ("square", "triangle", "lemniscate")
SEEDS = range(10)
REALISTIC = SimulationConfig(preset="realistic", feedback="pose")
VALUES = {
    "along": (1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0),
    "across": (2.0, 4.0, 8.0, 12.0, 16.0),
    "yaw": (2.0, 3.0, 4.0, 5.0, 6.0, 8.0),
    "integral": (0.0, 2.0, 5.0, 10.0, 20.0, 40.0),
}


class Quality(NamedTuple):
    """Errors of one run at its end and along its path."""

    end_m: float
    heading_rad: float
    cross_track_m: float
    speed_change_mps: float


def drive(figure: str, gains: Gains, seed: int) -> Quality:
    program = read_document((PROGRAMS / f"{figure}.json").read_bytes()).program
    assert program is not None
    link = open_link("sim", world="empty_room", setting=REALISTIC, seed=seed)
    ticks: list[Telemetry] = []

    def observe(_tick: int, event: Event) -> None:
        if isinstance(event, Telemetry):
            ticks.append(event)

    result = execute(program, link, RunOptions(observer=observe, seed=seed, gains=gains))
    if result.ended.state != "finished" or not ticks:
        return Quality(math.inf, math.inf, math.inf, math.inf)
    last = ticks[-1]
    return Quality(
        math.hypot(_true(last.true_x_m), _true(last.true_y_m)),
        abs(_true(last.true_yaw_rad)),
        _rms([_cross_track(tick) for tick in ticks]),
        _rms([b.command_v_mps - a.command_v_mps for a, b in itertools.pairwise(ticks)]),
    )


def _true(value: float | None) -> float:
    assert value is not None  # a simulator always has the true pose
    return value


def _cross_track(tick: Telemetry) -> float:
    dx, dy = _true(tick.true_x_m) - tick.goal_x_m, _true(tick.true_y_m) - tick.goal_y_m
    return math.cos(tick.goal_yaw_rad) * dy - math.sin(tick.goal_yaw_rad) * dx


def _rms(values: list[float]) -> float:
    return math.sqrt(sum(value * value for value in values) / len(values))


def _p95(values: list[float]) -> float:
    return sorted(values)[math.ceil(0.95 * len(values)) - 1]


def main() -> None:
    print(f"{'':<16}{'end, p95':>12}{'heading, p95':>14}{'cross, rms':>13}{'change, rms':>15}")
    for name, values in VALUES.items():
        for value in values:
            gains = SLIPPING_GAINS._replace(**{name: value})
            runs = [drive(figure, gains, seed) for figure in FIGURES for seed in SEEDS]
            end, heading = (_p95([run[i] for run in runs]) for i in (0, 1))
            cross_track, change = (_rms([run[i] for run in runs]) for i in (2, 3))
            mark = " *" if gains == SLIPPING_GAINS else ""
            print(
                f"{name:<8}{value:6.1f}{mark:<2}{end * 1e3:9.2f} mm{math.degrees(heading):11.3f} deg"
                f"{cross_track * 1e3:10.2f} mm{change * 1e3:10.2f} mm/s"
            )


if __name__ == "__main__":
    main()
