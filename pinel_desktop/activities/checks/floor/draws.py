from collections.abc import Iterator
from functools import cache
from typing import Annotated, Any, Literal, Self

import numpy as np
from pydantic import Field

from pinel_desktop.activities.checks.base import (
    MAX_ITEMS,
    CheckBase,
    CheckResult,
    Metres,
    Name,
    RealRobotTolerance,
    centimetres,
    rounded,
    text,
)
from pinel_desktop.activities.drawing import Fit, Freedom, Points, Sampled, best_fit, sampled
from pinel_desktop.activities.evidence import Evidence

_MAX_POINTS = 500
_STEP_M = 0.02  # between the points of a template that a solution provides
PROGRESS = "measured_drawing"

Point = Annotated[list[Metres], Field(min_length=2, max_length=2)]
Line = Annotated[list[Point], Field(min_length=2, max_length=_MAX_POINTS)]


class Draws(CheckBase):
    """The drawing of the pen, or the path (`of`: `trail`, `path`), matches the `template`, lines of points in
    m: no point of one is farther than `tolerance` (0.06) from the other. `scale`, `rotate` and `move` (true)
    make size, direction and place free, `mirror` (false) accepts the mirrored figure, too. `figure` names the
    figure if several are right.
    """

    requires = None
    form = (centimetres("tolerance", 2, 100),)
    check: Literal["draws"]
    template: Annotated[list[Line], Field(min_length=1, max_length=MAX_ITEMS)]
    tolerance: Annotated[float, Field(gt=0, le=10)] = 0.06
    scale: bool = True
    rotate: bool = True
    move: bool = True
    mirror: bool = False
    of: Literal["trail", "path"] = "trail"
    figure: Name | None = None

    def evaluate(self, evidence: Evidence) -> CheckResult:
        drawing = self.drawing(evidence)
        if not len(drawing.points) or evidence.path_m <= 0.02:
            return nothing_drawn(evidence, self.tolerance)
        fit = self.fit(drawing)
        is_extra = fit.extra_m >= fit.missing_m
        motion = evidence.motion_at(int(drawing.indices[fit.worst])) if is_extra else None
        figure, off = "draws" if self.of == "trail" else "way", "extra" if is_extra else "missing"
        return CheckResult(
            passed=fit.off_m <= self.tolerance,
            measured=fit.off_m,
            target=self.tolerance,
            pointer=motion.pointer if motion else None,
            code=f"check_{figure}_{off}",
            values={"off_m": fit.off_m / fit.scale},
            progress=PROGRESS,
        )

    def criterion(self, language: str) -> str:
        return text(f"criterion_draws_{self.of}", language)

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        of = "trail" if solution.trails else "path"
        template = _template_of(solution)
        more = {"tolerance": 0.06, "scale": False, "of": of}
        return {"template": template, **more} if 0 < len(template) <= MAX_ITEMS else None

    def with_tolerance(self, tolerance: RealRobotTolerance) -> Self:
        return self.model_copy(update={"tolerance": max(self.tolerance, tolerance.move_m)})

    def drawing(self, evidence: Evidence) -> Sampled:
        """Returns the points to compare with the template."""
        return evidence.trail_points if self.of == "trail" else evidence.path_points

    def fit(self, drawing: Sampled, *, mirrored: bool = False) -> Fit:
        """Returns the fit of a drawing; if `mirrored`, to the mirrored template only."""
        template = _points(tuple(tuple(tuple(point) for point in line) for line in self.template))
        if mirrored:
            template = template * (1.0, -1.0)
        free = Freedom(self.scale, self.rotate, self.move, self.mirror and not mirrored)
        return best_fit(template, drawing.points, free)


def nothing_drawn(evidence: Evidence, target: float) -> CheckResult:
    """Returns the failed result for a robot that did not drive or left no line."""
    if evidence.path_m <= 0.02:
        return CheckResult(False, 0.0, target, None, "check_no_motion")
    first = next(
        (one for one in evidence.started_commands if one.action not in ("turn", "pen")), None
    )
    pointer, values = first.pointer if first else None, {"path_m": evidence.path_m}
    return CheckResult(False, 0.0, target, pointer, "check_no_trail", values)


@cache
def _points(lines: tuple[tuple[tuple[float, ...], ...], ...]) -> Points:
    return sampled([np.array(line) for line in lines]).points


def _template_of(solution: Evidence) -> list[list[list[float]]]:
    """Returns the drawing of a solution, else its path: lines of at most as many points as a template may have."""
    trails = [one.line for one in solution.trails] or [solution.log.poses[:, :2]]
    return [line for trail in trails for line in _cut(_thinned(trail))]


def _thinned(trail: Points) -> list[list[float]]:
    thinned = [trail[0]]
    for point in trail:
        if np.hypot(*(point - thinned[-1])) >= _STEP_M:
            thinned.append(point)
    if np.hypot(*(trail[-1] - thinned[-1])) > 0.0:
        thinned.append(trail[-1])
    return [[rounded(float(value), 3) for value in point] for point in thinned]


def _cut(line: list[list[float]]) -> Iterator[list[list[float]]]:
    """Splits a line into pieces that share their end points; a single point gives no piece."""
    for first in range(0, len(line) - 1, _MAX_POINTS - 1):
        yield line[first : first + _MAX_POINTS]
