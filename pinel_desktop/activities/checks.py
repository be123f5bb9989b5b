"""Evaluation of checks after a run: one function for each kind of check."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

import numpy as np

from pinel_desktop.activities import check_kinds as kinds
from pinel_desktop.activities.commands import MOTIONS, nesting_of
from pinel_desktop.activities.drawing import (
    Fit,
    Freedom,
    Points,
    Sampled,
    axes_of_symmetry,
    best_fit,
    fine_step_m,
    sampled,
)
from pinel_desktop.activities.evidence import Evidence
from pinel_desktop.runs.spec import CUT_OFF

_DRIVES = tuple(MOTIONS - {"turn"})
Value = float | str | None
_DRAWN = ("check_draws_extra", "check_draws_missing", "check_way_extra", "check_way_missing")


@dataclass(frozen=True, slots=True)
class Finding:
    """What a check found.

    Attributes:
        measured, target: what was measured, and what it should be: m, degrees, s, a number or a name.
        pointer: JSON pointer of the command to look at, or None.
        code: the words where it does not hold; `values` fill them.
        is_lost: whether nothing that the run still does can make it hold.
    """

    holds: bool
    measured: Value
    target: Value
    pointer: str | None
    code: str
    values: dict[str, Any] = field(default_factory=dict)
    is_lost: bool = False


def find(check: Any, evidence: Evidence) -> Finding:
    """Evaluates a check of an activity."""
    return _CHECKS[type(check)](check, evidence)


def _finished(_check: kinds.Finished, evidence: Evidence) -> Finding:
    ended = evidence.log.ended
    state, reason = str(ended["state"]), ended.get("reason")
    values = dict(ended.get("params") or {})
    is_at_block = state != "finished" and reason not in CUT_OFF
    pointer = evidence.running.pointer if evidence.running and is_at_block else None
    code = str(reason) if reason else "check_finished"
    return Finding(state == "finished", state, "finished", pointer, code, values)


def _ends_at(check: kinds.EndsAt, evidence: Evidence) -> Finding:
    x, y, _ = evidence.end
    off = math.hypot(x - check.x_m, y - check.y_m)
    at_start = math.hypot(check.x_m, check.y_m) <= check.within_m
    code = "check_ends_at_start" if at_start else "check_ends_at"
    return Finding(off <= check.within_m, off, 0.0, _last_motion(evidence), code, {"off_m": off})


def _ends_heading(check: kinds.EndsHeading, evidence: Evidence) -> Finding:
    heading = math.degrees(math.remainder(evidence.end[2], math.tau))
    holds = abs(math.remainder(heading - check.heading_deg, 360.0)) <= check.within_deg
    values = {"measured_deg": heading, "target_deg": check.heading_deg}
    pointer = _last_begun(evidence, "turn", "arc")
    return Finding(holds, heading, check.heading_deg, pointer, "check_ends_heading", values)


def _ends_in(check: kinds.EndsIn, evidence: Evidence) -> Finding:
    x, y = (float(value) for value in evidence.in_world[-1])
    off = _from_zone(evidence, check.zone, x, y)
    holds = evidence.end_zone == check.zone
    values = {"off_m": off, "zone": check.zone}
    return Finding(
        holds, evidence.end_zone, check.zone, _last_motion(evidence), "check_ends_in", values
    )


def _visits(check: kinds.Visits, evidence: Evidence) -> Finding:
    zones = list(evidence.zones)
    missing = [zone for zone in check.zones if zone not in zones]
    if check.ordered:
        rest = iter(zones)
        missing = [zone for zone in check.zones if zone not in rest]
    visited = [zone for zone in zones if zone in check.zones]
    code = "check_visits" if visited else "check_visits_none"
    values = {"visited": visited, "zone": missing[0] if missing else ""}
    target = ", ".join(check.zones)
    pointer = _last_motion(evidence)
    return Finding(not missing, ", ".join(zones), target, pointer, code, values)


def _touches_nothing(_check: kinds.TouchesNothing, evidence: Evidence) -> Finding:
    tick = evidence.touch_tick
    if tick is None:
        return Finding(True, None, None, None, "check_touches_nothing")
    motion = evidence.motion_at(tick)
    at_s = tick / 30
    pointer = motion.pointer if motion else None
    values = {"at_s": at_s}
    return Finding(False, at_s, None, pointer, "check_touches_nothing", values, is_lost=True)


def _pushed(check: kinds.Pushed, evidence: Evidence) -> Finding:
    place = evidence.boxes.get(check.box)
    zone = evidence.zone_at(*place) if place else ""
    off = _from_zone(evidence, check.zone, *place) if place else 0.0
    values = {"off_m": off, "zone": check.zone}
    pointer = _last_motion(evidence)
    return Finding(zone == check.zone, zone, check.zone, pointer, "check_pushed", values)


def _uses(check: kinds.Uses, evidence: Evidence) -> Finding:
    found = [one for one in evidence.commands if one.action == check.action]
    n = len(found)
    too_many = n > check.at_most
    target = check.at_most if too_many else check.at_least
    values: dict[str, Any] = {"name": check.action, "measured": n, "target": target}
    code = "check_uses_too_many" if too_many else "check_uses" if n else "check_uses_none"
    pointer = found[-1].pointer if too_many else None
    holds = check.at_least <= n <= check.at_most
    return Finding(holds, n, target, pointer, code, values, is_lost=not holds)


def _marks(check: kinds.Marks, evidence: Evidence) -> Finding:
    marks = [one for one in evidence.marks if one["symbol"] == check.symbol]
    places = evidence.to_world(
        np.array([(one["x_m"], one["y_m"]) for one in marks], dtype=float).reshape(-1, 2)
    )
    zones = [evidence.zone_at(float(x), float(y)) for x, y in places]
    values = {"symbol": check.symbol, "zone": check.zone}
    pointer = _last_begun(evidence, "mark")
    measured = ", ".join(zones)
    return Finding(check.zone in zones, measured, check.zone, pointer, "check_marks", values)


def _says(check: kinds.Says, evidence: Evidence) -> Finding:
    wanted = check.text.casefold()
    holds = any(wanted in text.casefold() for text in evidence.said)
    last = evidence.said[-1] if evidence.said else ""
    pointer = _last_begun(evidence, "say")
    return Finding(holds, last, check.text, pointer, "check_says", {"text": check.text})


def _path_length(check: kinds.PathLength, evidence: Evidence) -> Finding:
    length = evidence.path_m
    is_long = length > check.at_most_m
    target = check.at_most_m if is_long else check.at_least_m
    stands = is_long and target < 0.1
    code = "check_path_length_still" if stands else "check_path_length"
    if is_long and not stands:
        code = "check_path_length_long"
    values = {"measured_m": length, "target_m": target}
    holds = check.at_least_m <= length <= check.at_most_m
    pointer = _last_begun(evidence, *_DRIVES) or _last_motion(evidence)
    return Finding(holds, length, target, pointer, code, values, is_lost=is_long)


def _draws(check: kinds.Draws, evidence: Evidence) -> Finding:
    drawing = drawing_of(check, evidence)
    if not len(drawing.points) or evidence.path_m <= 0.02:
        return _nothing_drawn(evidence, check.tolerance)
    fit = fit_of(check, drawing)
    is_extra = fit.extra_m >= fit.missing_m
    tick = int(drawing.places[fit.worst])
    motion = evidence.motion_at(tick) if is_extra else None
    code = f"check_{'draws' if check.of == 'trail' else 'way'}_{'extra' if is_extra else 'missing'}"
    values = {"off_m": fit.off_m / fit.scale}
    pointer = motion.pointer if motion else None
    return Finding(fit.off_m <= check.tolerance, fit.off_m, check.tolerance, pointer, code, values)


def drawing_of(check: kinds.Draws, evidence: Evidence) -> Sampled:
    """The points that a template is compared with."""
    return evidence.trail_points if check.of == "trail" else evidence.path_points


def fit_of(check: kinds.Draws, drawing: Sampled, *, mirrored: bool = False) -> Fit:
    """The fit of a drawing; `mirrored` to the mirrored template only."""
    template = _template(tuple(tuple(tuple(point) for point in line) for line in check.template))
    if mirrored:
        template = template * (1.0, -1.0)
    free = Freedom(check.scale, check.rotate, check.move, check.mirror and not mirrored)
    return best_fit(template, drawing.points, free)


@cache
def _template(lines: tuple[tuple[tuple[float, ...], ...], ...]) -> Points:
    return sampled([np.array(line) for line in lines]).points


def _closed(check: kinds.Closed, evidence: Evidence) -> Finding:
    gap = gap_of(evidence)
    if gap is None:
        return _nothing_drawn(evidence, check.within_m)
    values = {"gap_m": gap}
    pointer = _last_motion(evidence)
    return Finding(gap <= check.within_m, gap, 0.0, pointer, "check_closed", values)


def gap_of(evidence: Evidence) -> float | None:
    """Distance of the first from the last point that the pen drew; None where it drew nothing."""
    if not evidence.trails:
        return None
    (x0, y0), (x1, y1) = evidence.trails[0].line[0], evidence.trails[-1].line[-1]
    return math.hypot(x1 - x0, y1 - y0)


def _symmetric(check: kinds.Symmetric, evidence: Evidence) -> Finding:
    if not evidence.trails:
        return _nothing_drawn(evidence, check.axes)
    axes = axes_of(evidence, check.tolerance)
    values = {"measured": axes, "target": check.axes}
    return Finding(axes >= check.axes, axes, check.axes, None, "check_symmetric", values)


def axes_of(evidence: Evidence, tolerance: float) -> int:
    """Number of mirror axes of what the pen drew."""
    step_m = fine_step_m(evidence.trail_points.points)
    fine = sampled([one.line for one in evidence.trails], step_m=step_m)
    return axes_of_symmetry(fine.points, tolerance)


def _nothing_drawn(evidence: Evidence, target: float) -> Finding:
    if evidence.path_m <= 0.02:
        return Finding(False, 0.0, target, None, "check_no_motion")
    first = next((one for one in evidence.begun if one.action not in ("turn", "pen")), None)
    pointer = first.pointer if first else None
    return Finding(False, 0.0, target, pointer, "check_no_trail", {"path_m": evidence.path_m})


def _turned_total(check: kinds.TurnedTotal, evidence: Evidence) -> Finding:
    total, net = (math.degrees(one) for one in evidence.turned_rad)
    pointer = _last_begun(evidence, "turn", "arc")
    if not check.at_least_deg <= total <= check.at_most_deg:
        is_much = total > check.at_most_deg
        target = check.at_most_deg if is_much else check.at_least_deg
        values = {"measured_deg": total, "target_deg": target}
        code = "check_turned_total_much" if is_much else "check_turned_total"
        return Finding(False, total, target, pointer, code, values, is_lost=is_much)
    if check.net_deg is None or abs(net - check.net_deg) <= check.net_within:
        values = {"measured_deg": total, "target_deg": check.at_least_deg}
        return Finding(True, total, check.at_least_deg, None, "check_turned_total", values)
    values = {"measured_deg": net, "target_deg": check.net_deg}
    return Finding(False, net, check.net_deg, pointer, "check_turned_total_net", values)


def _block_count(check: kinds.BlockCount, evidence: Evidence) -> Finding:
    n = len(evidence.commands)
    values = {"measured": n, "target": check.at_most}
    is_lost = n > check.at_most
    return Finding(
        not is_lost, n, check.at_most, None, "check_block_count", values, is_lost=is_lost
    )


def _nesting(check: kinds.Nesting, evidence: Evidence) -> Finding:
    depth = nesting_of(evidence.commands)
    values = {"measured": depth, "target": check.at_least}
    is_lost = depth < check.at_least
    return Finding(
        not is_lost, depth, check.at_least, None, "check_nesting", values, is_lost=is_lost
    )


def _executed(check: kinds.Executed, evidence: Evidence) -> Finding:
    n = evidence.n_begun(check.action)
    values: dict[str, Any] = {"name": check.action, "measured": n, "target": check.n}
    there = next((one for one in evidence.commands if one.action == check.action), None)
    pointer = there.pointer if there else None
    is_lost = n > check.n
    return Finding(n == check.n, n, check.n, pointer, "check_executed", values, is_lost=is_lost)


def _mark_count(check: kinds.MarkCount, evidence: Evidence) -> Finding:
    n = len(evidence.marks)
    values = {"measured": n, "target": check.n}
    pointer = _last_begun(evidence, "mark")
    is_lost = n > check.n
    return Finding(n == check.n, n, check.n, pointer, "check_mark_count", values, is_lost=is_lost)


def _time(check: kinds.Time, evidence: Evidence) -> Finding:
    taken = evidence.duration_s
    values = {"measured_s": taken, "target_s": check.at_most_s}
    is_lost = taken > check.at_most_s
    return Finding(not is_lost, taken, check.at_most_s, None, "check_time", values, is_lost=is_lost)


def _any_of(check: kinds.AnyOf, evidence: Evidence) -> Finding:
    """The first that holds, else the nearest drawing, else the first."""
    best: Finding | None = None
    is_lost = True
    for one in check.checks:
        found = find(one, evidence)
        if found.holds:
            return found
        is_lost = is_lost and found.is_lost
        if best is None or _is_nearer(found, best):
            best = found
    assert best is not None
    return replace(best, is_lost=is_lost)


def _is_nearer(found: Finding, other: Finding) -> bool:
    if found.code not in _DRAWN or other.code not in _DRAWN:
        return False
    assert isinstance(found.measured, float)
    assert isinstance(other.measured, float)
    return found.measured < other.measured


_CHECKS: dict[type, Callable[[Any, Evidence], Finding]] = {
    kinds.Finished: _finished,
    kinds.EndsAt: _ends_at,
    kinds.EndsHeading: _ends_heading,
    kinds.EndsIn: _ends_in,
    kinds.Visits: _visits,
    kinds.TouchesNothing: _touches_nothing,
    kinds.Pushed: _pushed,
    kinds.Uses: _uses,
    kinds.Marks: _marks,
    kinds.Says: _says,
    kinds.PathLength: _path_length,
    kinds.Draws: _draws,
    kinds.Closed: _closed,
    kinds.Symmetric: _symmetric,
    kinds.TurnedTotal: _turned_total,
    kinds.BlockCount: _block_count,
    kinds.Nesting: _nesting,
    kinds.Executed: _executed,
    kinds.MarkCount: _mark_count,
    kinds.Time: _time,
    kinds.AnyOf: _any_of,
}


def _last_motion(evidence: Evidence) -> str | None:
    motion = evidence.last_motion
    return motion.pointer if motion else None


def _last_begun(evidence: Evidence, *actions: str) -> str | None:
    found = [one.pointer for one in evidence.begun if one.action in actions]
    return found[-1] if found else None


def _from_zone(evidence: Evidence, name: str, x_m: float, y_m: float) -> float:
    """Distance of a point in the world's frame from the centre of a zone."""
    center = zone_center(evidence, name)
    return math.hypot(x_m - center[0], y_m - center[1]) if center else 0.0


def zone_center(evidence: Evidence, name: str) -> tuple[float, float] | None:
    """Centre of a zone in the world's frame; None where the world has none of that name."""
    for zone in evidence.world.zones:
        if zone.name == name:
            center: tuple[float, float] = zone.shape.center
            return center
    return None
