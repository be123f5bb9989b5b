"""Diagnoses a run that does not pass: computes facts of the run, and finds the activity's first diagnosis that fits."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from pinel_desktop.activities.checks.base import CheckBase, place_text
from pinel_desktop.activities.checks.floor.closed import gap_of
from pinel_desktop.activities.checks.floor.draws import Draws
from pinel_desktop.activities.checks.floor.pushed import Pushed
from pinel_desktop.activities.checks.floor.symmetric import Symmetric, axes_of
from pinel_desktop.activities.checks.movement.ends_at import EndsAt
from pinel_desktop.activities.checks.movement.ends_in import EndsIn
from pinel_desktop.activities.checks.run.any_of import AnyOf
from pinel_desktop.activities.commands import Command, nesting_of
from pinel_desktop.activities.drawing import Fit
from pinel_desktop.activities.evidence import Evidence, StartedCommand
from pinel_desktop.activities.model import Case, Diagnosis, ExpectedFact, Start
from pinel_desktop.activities.wording import TextByLanguage, interpolate
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.messages import LANGUAGES, catalogue, describe

Fact = float | str | None
_ROUNDING = {"m": 0.005, "deg": 0.5, "s": 0.05}


@dataclass(frozen=True, slots=True)
class Advice:
    """Advice to a group about a run that does not pass: one message, with the block to look at.

    Attributes:
        words: the message by language.
        block, pointer: id of the block and JSON pointer of its command; None without one.
        diagnosis: index of the diagnosis in the activity; None for the message of a check.
    """

    words: TextByLanguage
    block: str | None
    pointer: str | None
    diagnosis: int | None = None


class Facts:
    """The facts of one run by name; each is computed on first access."""

    def __init__(
        self, evidence: Evidence, cases: Sequence[Case], number: int, checks: Sequence[CheckBase]
    ) -> None:
        self._evidence, self._cases, self._number = evidence, cases, number
        self._checks = list(_flat(checks))
        self._known: dict[str, Fact] = {}

    def __getitem__(self, name: str) -> Fact:
        if name not in self._known:
            self._known[name] = self._work_out(name)
        return self._known[name]

    def _work_out(self, name: str) -> Fact:
        if name[:2] == "n_":
            return sum(one.action == name[2:] for one in self._evidence.commands)
        if name[:2] == "x_":
            return self._evidence.n_started(name[2:])
        return _FACTS[name](self) if name in _FACTS else None

    def input(self) -> str:
        """Returns the inputs that the case gives to the program."""
        case = self._cases[self._number - 1]
        return ", ".join([*case.gestures, *case.answers])

    def to_goal_m(self) -> float | None:
        """Returns the distance (m) of the end from the goal; None if no check has such a goal."""
        x, y, _ = self._evidence.end
        for check in self._checks:
            if isinstance(check, EndsAt):
                return math.hypot(x - check.x_m, y - check.y_m)
            if isinstance(check, EndsIn):
                center = self._evidence.zone_center(check.zone)
                goal = self._evidence.to_start(*center) if center else (x, y)
                return math.hypot(x - goal[0], y - goal[1])
        return None

    def stopped_motion(self) -> StartedCommand | None:
        """Returns the motion that did not reach its goal, else the motion that touched something."""
        running, tick = self._evidence.running, self._evidence.touch_tick
        if running is not None and running.amount is not None:
            return running
        return self._evidence.motion_at(tick) if tick is not None else None

    def amount(self) -> float | None:
        motion = self.stopped_motion()
        return None if motion is None or motion.amount is None else abs(motion.amount)

    def done(self) -> float | None:
        motion = self.stopped_motion()
        if motion is None:
            return None
        until = motion.ended if motion.ended is not None else len(self._evidence.log.done) - 1
        part = self._evidence.log.done[motion.tick + 1 : until + 1]
        return float(max(abs(part.max()), abs(part.min()))) if len(part) else 0.0

    @cached_property
    def drawn(self) -> tuple[Fit, str] | None:
        """The fit to the nearest template, and the template's name."""
        return self._nearest(mirrored=False)

    @cached_property
    def drawn_mirrored(self) -> tuple[Fit, str] | None:
        """The fit to the nearest mirrored template, and the template's name."""
        return self._nearest(mirrored=True)

    def _nearest(self, *, mirrored: bool) -> tuple[Fit, str] | None:
        found: list[tuple[Fit, str]] = []
        for check in self.templates():
            drawing = check.drawing(self._evidence)
            if len(drawing.points):
                found.append((check.fit(drawing, mirrored=mirrored), check.figure or ""))
        return min(found, key=lambda one: one[0].off_m, default=None)

    def box(self) -> tuple[float, float] | None:
        """Returns how far the activity's box was pushed, and how far its centre is from its zone's centre, in m."""
        pushed = next((one for one in self._checks if isinstance(one, Pushed)), None)
        center = self._evidence.zone_center(pushed.zone) if pushed else None
        if pushed is None or center is None or pushed.box not in self._evidence.boxes:
            return None
        begin, end = self._evidence.world.boxes[pushed.box].center, self._evidence.boxes[pushed.box]
        return math.dist(begin, end), math.dist(end, center)

    def axes(self) -> float | None:
        symmetric = next((one for one in self._checks if isinstance(one, Symmetric)), None)
        return axes_of(self._evidence, symmetric.tolerance if symmetric else 0.06)

    def templates(self) -> list[Draws]:
        return [check for check in self._checks if isinstance(check, Draws)]

    @property
    def cases(self) -> Sequence[Case]:
        return self._cases

    @property
    def evidence(self) -> Evidence:
        return self._evidence

    @property
    def case_number(self) -> int:
        return self._number


def _flat(checks: Sequence[CheckBase]) -> Iterator[CheckBase]:
    for check in checks:
        yield check
        if isinstance(check, AnyOf):
            yield from _flat(check.checks)


def _drawn(of: Callable[[Fit], float], *, mirrored: bool = False) -> Callable[[Facts], Fact]:
    """Makes a fact from a distance of the nearest template, in the drawing's metres."""

    def fact(facts: Facts) -> Fact:
        found = facts.drawn_mirrored if mirrored else facts.drawn
        return None if found is None else of(found[0]) / found[0].scale

    return fact


def _figure(*, mirrored: bool) -> Callable[[Facts], Fact]:
    def fact(facts: Facts) -> Fact:
        found = facts.drawn_mirrored if mirrored else facts.drawn
        return None if found is None else found[1]

    return fact


def _box(index: int) -> Callable[[Facts], Fact]:
    def fact(facts: Facts) -> Fact:
        found = facts.box()
        return None if found is None else found[index]

    return fact


def _mark(name: str) -> Callable[[Facts], Fact]:
    def fact(facts: Facts) -> Fact:
        marks = facts.evidence.marks
        return float(marks[0][name]) if marks else None

    return fact


_FACTS: dict[str, Callable[[Facts], Fact]] = {
    "gap_m": lambda facts: gap_of(facts.evidence),
    "turned_deg": lambda facts: math.degrees(facts.evidence.turned_rad[0]),
    "net_deg": lambda facts: math.degrees(facts.evidence.turned_rad[1]),
    "path_m": lambda facts: facts.evidence.path_m,
    "time_s": lambda facts: facts.evidence.duration_s,
    "end_x": lambda facts: facts.evidence.end[0],
    "end_y": lambda facts: facts.evidence.end[1],
    "from_start_m": lambda facts: math.hypot(*facts.evidence.end[:2]),
    "to_goal_m": Facts.to_goal_m,
    "blocks": lambda facts: len(facts.evidence.commands),
    "nesting": lambda facts: nesting_of(facts.evidence.commands),
    "reason": lambda facts: str(facts.evidence.log.ended.get("reason") or ""),
    "done": Facts.done,
    "amount": Facts.amount,
    "zones": lambda facts: ", ".join(facts.evidence.zones),
    "end_zone": lambda facts: facts.evidence.end_zone,
    "missing_m": _drawn(lambda fit: fit.missing_m),
    "extra_m": _drawn(lambda fit: fit.extra_m),
    "mirror_m": _drawn(lambda fit: fit.off_m, mirrored=True),
    "nearest": _figure(mirrored=False),
    "mirrored": _figure(mirrored=True),
    "pushed_m": _box(0),
    "box_left_m": _box(1),
    "axes": Facts.axes,
    "marks": lambda facts: len(facts.evidence.marks),
    "mark_x": _mark("x_m"),
    "mark_y": _mark("y_m"),
    "case": lambda facts: facts.case_number,
    "input": Facts.input,
}


def fits(diagnosis: Diagnosis, facts: Facts) -> bool:
    """Returns whether the facts of a run meet all conditions of a diagnosis."""
    return all(_is(name, facts[name], expected) for name, expected in diagnosis.when.items())


def _is(name: str, fact: Fact, expected: ExpectedFact) -> bool:
    if fact is None:
        return False
    if isinstance(expected, str):
        return _visits(str(fact), expected) if name == "zones" else fact == expected
    assert not isinstance(fact, str)
    if isinstance(expected, list):
        return expected[0] <= fact <= expected[1]
    unit = name.rpartition("_")[2]
    tolerance = 0.01 if name in ("end_x", "end_y", "mark_x", "mark_y", "done") else 1e-6
    return abs(fact - expected) <= _ROUNDING.get(unit, tolerance)


def _visits(zones: str, expected: str) -> bool:
    """Returns whether the zones were visited in that order; "" expects no zone at all."""
    if not expected:
        return not zones
    rest = iter(zones.split(", "))
    return all(zone in rest for zone in expected.split(", "))


def advice_of(diagnosis: Diagnosis, index: int, facts: Facts) -> Advice:
    """Returns the advice of a diagnosis that fits."""
    evidence = facts.evidence
    pointer = _pointer(diagnosis.block, facts)
    command = evidence.command_at(pointer) if pointer else None
    texts = {}
    for language in LANGUAGES:
        if diagnosis.say is not None:
            text = diagnosis.say.of(language)
        else:
            text = catalogue(language)[f"diagnosis_{diagnosis.general}"]["message"]
        values = _values(text, diagnosis, facts, command, language)
        texts[language] = interpolate(text, values, language)
    block = command.block if command else None
    return Advice(texts, block, pointer, index)


def _pointer(which: str | None, facts: Facts) -> str | None:
    evidence = facts.evidence
    if which is None:
        return None
    if which == "running":
        return evidence.running.pointer if evidence.running else None
    if which == "touching":
        motion = facts.stopped_motion()
        return motion.pointer if motion else None
    if which == "moving":
        return evidence.last_motion
    if which == "worst":
        return _worst(facts)
    place, _, action = which.partition(" ")
    found = [one.pointer for one in evidence.commands if one.action == action]
    if not found:
        return None
    return found[0] if place == "first" else found[-1]


def _worst(facts: Facts) -> str | None:
    """Returns the command that drew the point farthest from the nearest template."""
    best: tuple[float, str | None] | None = None
    for check in facts.templates():
        drawing = check.drawing(facts.evidence)
        if len(drawing.points):
            fit = check.fit(drawing)
            motion = facts.evidence.motion_at(int(drawing.indices[fit.worst]))
            if best is None or fit.off_m < best[0]:
                best = fit.off_m, motion.pointer if motion else None
    return best[1] if best else None


def _values(
    text: str, diagnosis: Diagnosis, facts: Facts, command: Command | None, language: str
) -> Mapping[str, Any]:
    """Returns the values of the facts that a text names."""
    values: dict[str, Any] = {"parts": diagnosis.parts or 0}
    named = set(_names_in(text))
    for name in _FACTS:
        bare = name.removesuffix("_m").removesuffix("_deg").removesuffix("_s")
        if named & {name, bare, f"{bare}_cm"}:
            values[name] = facts[name]
    for name in named:
        if name[:2] in ("n_", "x_"):
            values[name] = facts[name]
    if "input" in named:
        values["input"] = input_text(facts.cases, facts.case_number, language)
    if command is not None:
        values |= _of_block(command, facts)
    return {name: value for name, value in values.items() if value is not None}


def _names_in(text: str) -> Iterator[str]:
    for part in text.split("{")[1:]:
        yield part.partition("}")[0]


def _of_block(command: Command, facts: Facts) -> dict[str, Any]:
    """Returns the block, its number of repetitions, the time (s) of its first start, and its goal."""
    started = [one for one in facts.evidence.started_commands if one.pointer == command.pointer]
    times = command.data.get("times")
    values: dict[str, Any] = {"block": command}
    if isinstance(times, int | float):
        values["times"] = times
    if started:
        values["at_s"] = started[0].tick / TICK_HZ
        if started[0].amount is not None:
            values["value"] = abs(started[0].amount)
    return values


def input_text(cases: Sequence[Case], number: int, language: str) -> str:
    """Returns what a case gives to the program, as text: signs and answers, or another start.

    Args:
        cases: all cases of the activity; pupils know the start of the first.
        number: number of the case, from 1.
    """
    case = cases[number - 1]
    if case.start is not None:
        place = _moved_start(case.start, cases[0].start or case.start, language)
        code = "diagnosis_start" if place else "diagnosis_same_start"
        return describe(code, {"place": place}, language).message
    given = [*case.gestures, *case.answers]
    none = describe("diagnosis_no_sign", {}, language).message
    return ", ".join(one or none for one in given)


def case_texts(cases: Sequence[Case], language: str) -> list[str]:
    """Returns the text of each case."""
    return [input_text(cases, number, language) for number in range(1, len(cases) + 1)]


def _moved_start(start: Start, first: Start, language: str) -> str:
    """Returns where a start lies, seen from the first case's start; "" if it is the same."""
    heading = math.radians(first.heading_deg)
    dx, dy = start.x_m - first.x_m, start.y_m - first.y_m
    ahead = dx * math.cos(heading) + dy * math.sin(heading)
    left = dy * math.cos(heading) - dx * math.sin(heading)
    return place_text(ahead, left, 0.005, language)
