"""Making an activity: what its sample solution does, as numbers to choose checks from, and a trial of its checks."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from pinel_desktop.activities.checking import STEP_LIMIT, check_program, spec_of
from pinel_desktop.activities.checks import gap_of
from pinel_desktop.activities.commands import nesting_of
from pinel_desktop.activities.drawing import Points
from pinel_desktop.activities.evidence import Evidence, LogWriter
from pinel_desktop.activities.faults import world_of
from pinel_desktop.activities.model import Activity
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.control import RunControl
from pinel_desktop.program.reading import Reading, read_document
from pinel_desktop.robot import Preset
from pinel_desktop.runs.start import start
from sim.world import world_from_document

_EMPTY: Mapping[str, Any] = {"pinel_ir": 1, "name": "", "functions": [], "commands": []}
_STEP_M = 0.02
_MOST_POINTS, _MOST_LINES = 500, 100  # of a template (check_kinds.py)

Who = Literal["solution", "empty"]
Template = list[list[tuple[float, float]]]


@dataclass(frozen=True, slots=True)
class Sample:
    """What a sample solution does under the ideal robot; lengths in m, angles in degrees, start frame.

    Attributes:
        finished: it ended by itself and without a failure.
        touched: it touched something.
        turned_deg, net_deg: all turning without and with sign (positive: left).
        zones: zones visited, in order; `end_zone` the one at the end, "" outside.
        gap_m: between the first and the last point drawn; None where nothing was drawn.
        template: what the pen drew, or the path where it drew nothing; None where that is too much for a check.
    """

    finished: bool
    touched: bool
    end_x_m: float
    end_y_m: float
    heading_deg: float
    path_m: float
    turned_deg: float
    net_deg: float
    time_s: float
    n_blocks: int
    n_nested: int
    n_marks: int
    zones: tuple[str, ...]
    end_zone: str
    said: tuple[str, ...]
    gap_m: float | None
    template: Template | None


def sample_of(activity: Activity, solution: Reading) -> Sample:
    """Runs a program without faults in the activity's first case and measures what it does.

    Raises:
        PinelError: what `world_of` raises.
    """
    assert solution.document is not None
    case, writer, control = activity.cases[0], LogWriter(), RunControl()
    last_tick = round(activity.limit_s * TICK_HZ)

    def observe(tick: int, event: Any) -> None:
        writer.observe(tick, event)
        if tick >= last_tick:
            control.stop()

    start(spec_of(activity, case, solution), observe, control, step_limit=STEP_LIMIT)
    world = world_from_document(world_of(activity, case))
    return _measured(Evidence(solution.document, world, writer.log()))


def _measured(evidence: Evidence) -> Sample:
    x, y, yaw = evidence.end
    turned, net = np.degrees(evidence.turned_rad)
    return Sample(
        finished=evidence.log.ended["state"] == "finished",
        touched=evidence.touch_tick is not None,
        end_x_m=_rounded(x),
        end_y_m=_rounded(y),
        heading_deg=_rounded(float(np.degrees(np.arctan2(np.sin(yaw), np.cos(yaw)))), 0),
        path_m=_rounded(evidence.path_m),
        turned_deg=_rounded(float(turned), 0),
        net_deg=_rounded(float(net), 0),
        time_s=_rounded(evidence.duration_s, 1),
        n_blocks=len(evidence.commands),
        n_nested=nesting_of(evidence.commands),
        n_marks=len(evidence.marks),
        zones=evidence.zones,
        end_zone=evidence.end_zone,
        said=evidence.said,
        gap_m=None if (gap := gap_of(evidence)) is None else _rounded(gap),
        template=_template(evidence),
    )


def _rounded(value: float, digits: int = 2) -> float:
    return round(value, digits) + 0.0  # no -0.0


def _template(evidence: Evidence) -> Template | None:
    """Lines of points 2 cm apart, each of at most as many points as a check may have."""
    trails = [one.line for one in evidence.trails] or [evidence.log.poses[:, :2]]
    lines = [line for trail in trails for line in _cut(_thinned(trail))]
    return lines if 0 < len(lines) <= _MOST_LINES else None


def _thinned(trail: Points) -> list[tuple[float, float]]:
    kept = [trail[0]]
    for point in trail:
        if np.hypot(*(point - kept[-1])) >= _STEP_M:
            kept.append(point)
    if np.hypot(*(trail[-1] - kept[-1])) > 0.0:
        kept.append(trail[-1])
    return [(_rounded(float(x), 3), _rounded(float(y), 3)) for x, y in kept]


def _cut(line: list[tuple[float, float]]) -> Iterator[list[tuple[float, float]]]:
    """The line in pieces that share their ends; a single point is none."""
    for first in range(0, len(line) - 1, _MOST_POINTS - 1):
        yield line[first : first + _MOST_POINTS]


@dataclass(frozen=True, slots=True)
class Trial:
    """What the checks said of one program under one robot.

    Attributes:
        preset: `ideal`, or `realistic` with the pose of a camera.
        words: why it does not pass, by language; empty where it passes.
    """

    program: Who
    preset: Preset
    passed: bool
    words: Mapping[str, str]

    @property
    def is_right(self) -> bool:
        """The solution must pass, the program without commands must not."""
        return self.passed == (self.program == "solution")


def trials(activity: Activity, presets: tuple[Preset, ...] = ("ideal", "realistic")) -> list[Trial]:
    """Checks the activity's own solution and a program without commands, under each robot.

    Raises:
        PinelError: what `world_of` raises.
    """
    programs: dict[Who, Mapping[str, Any]] = {
        "solution": activity.solution or _EMPTY,
        "empty": _EMPTY,
    }
    return [
        _trial(activity, who, document, preset)
        for preset in presets
        for who, document in programs.items()
    ]


def _trial(activity: Activity, who: Who, document: Mapping[str, Any], preset: Preset) -> Trial:
    tried = activity.model_copy(update={"preset": preset, "feedback": "pose"})
    report = check_program(tried, read_document(dict(document)))
    words = report.advice.words if report.advice else {}
    return Trial(who, preset, report.passed, words)
