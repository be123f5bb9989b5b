"""The difference between a real robot's run and its prediction: by step, at the end, and of the whole path.

Both runs are compared at the same moments of the program: at the start and the end of each step, and in between at the
same part of it. So a real robot, which answers later and settles longer, is not compared with a place ahead of it.
"""

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from statistics import fmean, pstdev
from typing import Any, Literal

import numpy as np

from pinel_desktop.runs.measured import Measured, Source
from pinel_desktop.runs.prediction import Path, Prediction, Step

Kind = Literal["turn", "move"]

# a difference below is not worth a word
MIN_TURN_DEG, MIN_MOVE_M = 1.0, 0.02
# a step of which the prediction turns or moves less is no turn, or no move
_A_TURN_DEG, _A_MOVE_M = 3.0, 0.03
_TURN_M = 0.2  # way of a wheel per radian, about
_STANDSTILL_M = 0.01
_AVERAGED_TICKS = 2  # around a step's end, for measurements with noise


@dataclass(frozen=True, slots=True)
class StepDifference:
    """A step of the real run beside the predicted one.

    Attributes:
        block, action, amount: as in the event `block_started`.
        tick: tick of the real run at which it started.
        predicted_turned_deg, predicted_moved_m: predicted turn, counterclockwise; predicted distance from its start to
            its end.
        turned_deg, moved_m: what was measured, the distance in the predicted direction; None where the source saw
            nothing.
    """

    block: str | None
    action: str
    amount: float | None
    tick: int
    predicted_turned_deg: float
    predicted_moved_m: float
    turned_deg: float | None
    moved_m: float | None

    @property
    def command(self) -> tuple[str, object]:
        """What executions have in common that can be expected to differ alike."""
        return self.action, self.block if self.amount is None else round(self.amount, 2)

    def more(self, kind: Kind) -> float | None:
        """Returns how much more the robot turned (degrees) or moved (m) than predicted; None for another kind."""
        if kind == "turn":
            predicted, measured = self.predicted_turned_deg, self.turned_deg
        else:
            predicted, measured = self.predicted_moved_m, self.moved_m
        if measured is None or abs(predicted) < (_A_TURN_DEG if kind == "turn" else _A_MOVE_M):
            return None
        return math.copysign(1.0, predicted) * (measured - predicted)

    def predicted(self, kind: Kind) -> float:
        """Returns the size of the predicted turn (degrees) or distance (m)."""
        return abs(self.predicted_turned_deg if kind == "turn" else self.predicted_moved_m)


@dataclass(frozen=True, slots=True)
class EndDifference:
    """Where the robot stood at the end, from where the prediction ends.

    Attributes:
        distance_m: distance between the two places.
        heading_deg: measured heading minus predicted heading, counterclockwise.
    """

    source: Source
    distance_m: float
    heading_deg: float


@dataclass(frozen=True, slots=True)
class Finding:
    """A difference that is worth a sentence.

    Attributes:
        how: `each` time the step ran, `once` in one execution of it, or on `average` of all turns, of which only the
            sum is known.
        difference: how much more the robot turned (degrees) or moved (m) than predicted; negative: less.
        n: number of executions.
        block, action, amount, tick: of the step, of several its first execution.
    """

    kind: Kind
    how: Literal["each", "once", "average"]
    source: Source
    difference: float
    n: int
    block: str | None
    action: str
    amount: float | None
    tick: int


@dataclass(frozen=True, slots=True)
class Difference:
    """A run beside its prediction.

    Attributes:
        source: source of the poses that were compared along the way.
        is_whole: whether `at_end` is after the whole run, and the prediction did the same steps.
        ate_m: absolute trajectory error: root mean square of the distances between the two paths (Sturm et al., A
            Benchmark for the Evaluation of RGB-D SLAM Systems, IROS 2012). They are aligned at the start, not over the
            whole path. None if less than two poses can be compared.
        parted: block at which the real run did another step than the prediction; "" for a step without a block, None
            if it never did.
    """

    source: Source
    steps: list[StepDifference]
    at_end: EndDifference | None
    is_whole: bool
    ate_m: float | None
    parted: str | None
    findings: list[Finding]

    @classmethod
    def from_message(cls, message: Mapping[str, Any]) -> "Difference":
        """Reads a difference from plain JSON data (`dataclasses.asdict`)."""
        steps = [StepDifference(**step) for step in message["steps"]]
        at_end = message["at_end"] and EndDifference(**message["at_end"])
        findings = [Finding(**finding) for finding in message["findings"]]
        return cls(**{**message, "steps": steps, "at_end": at_end, "findings": findings})


def difference(
    prediction: Prediction,
    measured: Measured,
    steps: Sequence[Step],
    *,
    is_whole: bool,
    tolerance: tuple[float, float],
) -> Difference:
    """Compares a run with its prediction.

    Args:
        steps: the steps of the real run.
        is_whole: whether the real run came to its end.
        tolerance: goal tolerances of the robot, in m and degrees.
    """
    matched = _matched(prediction.steps, steps)
    parted = _parted(prediction.steps, steps)
    path = measured.path
    predicted = _predicted_for(measured.source, prediction)
    found = [_step_difference(ours, theirs, predicted, path) for ours, theirs in matched]
    is_same = is_whole and not (prediction.awaits_input or prediction.is_cut)
    is_same = is_same and len(matched) == len(prediction.steps) == len(steps)
    at_end = _at_end(prediction, measured, path, matched, is_same=is_same)
    findings = _findings(found, measured.source, tolerance)
    if is_same and at_end and at_end.source != measured.source == "odometry":
        sigma_deg = math.degrees(measured.end_sigma_rad)
        findings = [*_on_average(found, at_end, sigma_deg, tolerance), *findings]
    return Difference(
        measured.source,
        found,
        at_end,
        is_same,
        _ate(predicted, measured, matched),
        parted,
        findings,
    )


def _predicted_for(source: Source, prediction: Prediction) -> Path:
    """Returns what is predicted of the poses of a source: a calibrated robot's odometry misses its errors, too."""
    return prediction.odometry if source == "odometry" else prediction.path


_Matched = list[tuple[Step, Step]]  # a predicted and a real step, both with their ends


def _matched(predicted: Sequence[Step], real: Sequence[Step]) -> _Matched:
    pairs: _Matched = []
    for ours, theirs in zip(predicted, real, strict=False):
        if ours.pointer != theirs.pointer or ours.end is None or theirs.end is None:
            break
        pairs.append((ours, theirs))
    return pairs


def _parted(predicted: Sequence[Step], real: Sequence[Step]) -> str | None:
    for ours, theirs in zip(predicted, real, strict=False):
        if ours.pointer != theirs.pointer:
            return theirs.block or ""
    return None


def _pose_at(path: Path, tick: int) -> Path:
    """The mean pose around a tick; NaN if it is unknown."""
    around = path[max(0, tick - _AVERAGED_TICKS) : tick + _AVERAGED_TICKS + 1]
    known = around[~np.isnan(around[:, 0])]
    return known.mean(axis=0) if len(known) else np.full(3, np.nan)


def _step_difference(ours: Step, theirs: Step, predicted: Path, path: Path) -> StepDifference:
    assert ours.end is not None
    assert theirs.end is not None
    way = _way(_at(predicted, ours.start), _at(predicted, ours.end))
    real = _way(_pose_at(path, theirs.start), _pose_at(path, theirs.end))
    length = math.hypot(way[0], way[1])
    along = (way[0] * real[0] + way[1] * real[1]) / length if length else 0.0
    sign = -1.0 if way[0] < 0 else 1.0
    turned = math.degrees(real[2])
    return StepDifference(
        theirs.block,
        theirs.action,
        theirs.amount,
        theirs.start,
        math.degrees(way[2]),
        sign * length,
        None if math.isnan(turned) else turned,
        None if math.isnan(along) else sign * along,
    )


def _at(path: Path, tick: int) -> Path:
    pose: Path = path[min(tick, len(path) - 1)]
    return pose


def _way(start: Path, end: Path) -> tuple[float, float, float]:
    """Returns the end in the robot's frame at the start."""
    cos, sin = math.cos(start[2]), math.sin(start[2])
    dx, dy = end[0] - start[0], end[1] - start[1]
    return float(cos * dx + sin * dy), float(cos * dy - sin * dx), float(end[2] - start[2])


def _ate(predicted: Path, measured: Measured, matched: _Matched) -> float | None:
    """The error over all ticks of the matched steps, each beside the prediction at the same part of the step."""
    off: list[Path] = []
    for ours, theirs in matched:
        ticks = np.arange(theirs.start, min((theirs.end or 0) + 1, len(measured.path)))
        ours_ticks = np.arange(ours.start, (ours.end or 0) + 1)
        own_part, part = _parts(predicted[ours_ticks]), _parts(measured.odometry[ticks])
        beside = [np.interp(part, own_part, predicted[ours_ticks, column]) for column in (0, 1)]
        off.append(np.hypot(*(measured.path[ticks, :2].T - beside)))
    distances = np.concatenate(off) if off else np.zeros(0)
    known = distances[~np.isnan(distances)]
    return float(np.sqrt(np.mean(known**2))) if len(known) > 1 else None


def _parts(path: Path) -> Path:
    """How much of its way a robot has come at each pose of a step, 0 to 1; of its time where it does not move."""
    x, y, yaw = np.abs(np.diff(path, axis=0)).T
    come = np.concatenate([[0.0], np.cumsum(np.hypot(x, y) + _TURN_M * yaw)])
    if come[-1] < _STANDSTILL_M:
        come = np.arange(len(path), dtype=np.float64)
    parts: Path = come / max(come[-1], 1.0e-9)
    return parts


def _at_end(
    prediction: Prediction, measured: Measured, path: Path, matched: _Matched, *, is_same: bool
) -> EndDifference | None:
    """The difference after the run; of a run that did not come to its end, after its last step."""
    if is_same and measured.end is not None:
        source, end = measured.end_source or measured.source, np.array(measured.end)
        predicted = _predicted_for(source, prediction)[-1]
    elif is_same and len(path):
        source, end = measured.source, _pose_at(path, len(path) - 1)
        predicted = _predicted_for(source, prediction)[-1]
    elif matched:
        ours, theirs = matched[-1]
        source, end = measured.source, _pose_at(path, theirs.end or 0)
        predicted = _at(_predicted_for(source, prediction), ours.end or 0)
    else:
        return None
    off = end - predicted
    if np.isnan(off).any():
        return None
    return EndDifference(source, math.hypot(off[0], off[1]), math.degrees(off[2]))


def _findings(
    steps: Iterable[StepDifference], source: Source, tolerance: tuple[float, float]
) -> list[Finding]:
    """The differences worth a sentence, the largest first; of each kind of step one."""
    found: list[tuple[float, Finding]] = []
    for kind in ("turn", "move"):
        limit = _limit(kind, tolerance)
        groups: dict[object, list[tuple[StepDifference, float]]] = defaultdict(list)
        for step in steps:
            if (more := step.more(kind)) is not None:
                groups[step.command].append((step, more))
        for members in groups.values():
            how, step, more = _of_group(members, limit)
            if abs(more) >= limit:
                n = len(members) if how == "each" else 1
                finding = Finding(
                    kind, how, source, more, n, step.block, step.action, step.amount, step.tick
                )
                found.append((abs(more) / limit, finding))
    found.sort(key=lambda one: -one[0])
    return [finding for _, finding in found]


def _of_group(
    members: list[tuple[StepDifference, float]], limit: float
) -> tuple[Literal["each", "once"], StepDifference, float]:
    """Returns what executions of one command have in common: their mean if they agree, else the largest difference."""
    differences = [more for _, more in members]
    mean = fmean(differences)
    if len(members) > 1 and (pstdev(differences) <= max(abs(mean) / 2, limit / 2)):
        return "each", members[0][0], mean
    step, more = max(members, key=lambda one: abs(one[1]))
    return "once", step, more


def _on_average(
    steps: Sequence[StepDifference],
    end: EndDifference,
    sigma_deg: float,
    tolerance: tuple[float, float],
) -> list[Finding]:
    """Shares the difference of the heading at the end among the turns, if all turned in one direction."""
    turns = [step for step in steps if step.more("turn") is not None]
    predicted = [step.predicted_turned_deg for step in turns]
    if not turns or len({value > 0 for value in predicted}) > 1:
        return []
    more = math.copysign(1.0, predicted[0]) * end.heading_deg / len(turns)
    if abs(more) < max(_limit("turn", tolerance), 2.0 * sigma_deg / len(turns)):
        return []  # no more than the source may be wrong by
    first = turns[0]
    is_one_command = len({step.command for step in turns}) == 1
    return [
        Finding(
            "turn",
            "average",
            end.source,
            more,
            len(turns),
            first.block if is_one_command else None,
            first.action,
            first.amount,
            first.tick,
        )
    ]


def _limit(kind: Kind, tolerance: tuple[float, float]) -> float:
    """The least difference worth a word: the robot's own goal tolerances are no fault."""
    move_m, turn_deg = tolerance
    return max(MIN_TURN_DEG, turn_deg) if kind == "turn" else max(MIN_MOVE_M, move_m)
