"""Faults of an activity: violations of its schema, and checks that no program could pass in its world."""

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from pinel_desktop.activities.checks.base import CheckBase
from pinel_desktop.activities.model import (
    FORMAT_1,
    NUMBER_FACTS,
    TEXT_FACTS,
    Activity,
    Case,
    Diagnosis,
)
from pinel_desktop.activities.wording import blocks_named
from pinel_desktop.errors import PinelError
from pinel_desktop.messages.content import titled
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.model import action_names
from pinel_desktop.program.pointers import pointer
from pinel_desktop.program.reading import read_document
from pinel_desktop.program.translation import WRONG_TYPE, path_of_error
from pinel_desktop.robot import ROBOTS
from pinel_desktop.worlds import read_own_world
from sim.world import WorldError, world_document, world_from_document

Path = tuple[str | int, ...]
Params = dict[str, object]


class ActivityError(PinelError):
    """Raised for an activity that cannot be used; `faults` lists all its faults."""

    def __init__(self, path: str, faults: tuple[Fault, ...]) -> None:
        super().__init__("activity_invalid", path=path, count=len(faults))
        self.faults = faults


def world_of(activity: Activity, case: Case | None = None) -> dict[str, Any]:
    """Returns the world document of an activity, with the start of one of its cases.

    Raises PinelError `unknown_world`, or the first fault of a world document inside the activity.
    """
    document, faults = _world(activity)
    if document is None:
        raise PinelError(faults[0].code, **faults[0].params)
    return document if case is None else _started_from(document, case)


def _started_from(document: dict[str, Any], case: Case) -> dict[str, Any]:
    return document if case.start is None else {**document, "start": case.start.model_dump()}


def require_fulfillable(activity: Activity) -> None:
    """Raises ActivityError if no program could pass the activity."""
    if faults := semantic_faults(activity):
        raise ActivityError(activity.name, faults)


def schema_faults(document: Any, error: ValidationError) -> tuple[Fault, ...]:
    """Converts pydantic's errors to faults with JSON pointers, at most one for each place."""
    found: dict[Path, Fault] = {}
    for one in error.errors(include_url=False):
        path = path_of_error(document, one)
        code, params = _code_and_params(one, path)
        place = (*path, str(params["name"])) if code == "missing_parameter" else path
        found.setdefault(place, Fault(code, pointer(path), None, params))
    return tuple(found.values())


def _code_and_params(error: ErrorDetails, path: Path) -> tuple[str, Params]:
    kind = error["type"]
    name = next((part for part in reversed(path) if isinstance(part, str)), "")
    if kind in ("model_type", "model_attributes_type"):
        return "wrong_type_object", {"name": name}
    if kind in WRONG_TYPE:
        return f"wrong_type_{WRONG_TYPE[kind]}", {"name": name}
    return _KINDS.get(kind, _other_error)(error, name)


def _other_error(error: ErrorDetails, name: str) -> tuple[str, Params]:
    value = error["input"]
    shown = value if isinstance(value, str | int | float) else type(value).__name__
    return "activity_value_wrong", {"name": name, "value": shown}


def _limit(code: str, limit: str) -> Callable[[ErrorDetails, str], tuple[str, Params]]:
    which = "min" if code.endswith("small") else "max"
    return lambda error, name: (
        code,
        {"name": name, "value": error["input"], which: error["ctx"][limit]},
    )


_KINDS: dict[str, Callable[[ErrorDetails, str], tuple[str, Params]]] = {
    "missing": lambda error, _: ("missing_parameter", {"name": str(error["loc"][-1])}),
    "union_tag_not_found": lambda _error, _: ("missing_parameter", {"name": "check"}),
    "union_tag_invalid": lambda error, _: (
        "unknown_check",
        {"value": error["ctx"]["tag"], "allowed": error["ctx"]["expected_tags"].replace("'", "")},
    ),
    "extra_forbidden": lambda error, _: ("activity_unknown_key", {"name": str(error["loc"][-1])}),
    "finite_number": lambda _error, name: ("not_finite", {"name": name}),
    "string_unicode": lambda _error, name: ("text_not_unicode", {"name": name}),
    "greater_than": _limit("activity_value_too_small", "gt"),
    "greater_than_equal": _limit("activity_value_too_small", "ge"),
    "less_than": _limit("activity_value_too_large", "lt"),
    "less_than_equal": _limit("activity_value_too_large", "le"),
    "string_too_long": lambda error, name: (
        "text_too_long",
        {"name": name, "value": len(error["input"]), "max": error["ctx"]["max_length"]},
    ),
}


def semantic_faults(activity: Activity) -> tuple[Fault, ...]:
    """Returns faults beyond the schema: unknown robots, zones, boxes, commands; crossed limits; missing checks."""
    faults: list[Fault] = []
    if activity.model not in ROBOTS:
        params: Params = {"value": activity.model, "allowed": list(ROBOTS)}
        return (Fault("unknown_robot", "/model", None, params),)
    document, found = _world(activity)
    faults += found
    faults += _keys_of_format_2(activity)
    world = world_from_document(document) if document else None
    for place, check in _checks(activity):
        for path, code, params in check.faults(world):
            faults.append(Fault(code, pointer((*place, *path)), None, params))
    faults += _nothing_to_check(activity)
    if document is not None:
        faults += _starts(activity, document)
    faults += _unknown_actions(("blocks",), activity.blocks or [])
    faults += _hints(activity)
    for i, diagnosis in enumerate(activity.diagnoses):
        faults += _faults_of_diagnosis(("diagnoses", i), diagnosis)
    if activity.solution is not None:
        found = list(read_document(activity.solution).faults)
        faults += [Fault(f.code, f"/solution{f.pointer}", None, f.params) for f in found]
    return tuple(faults)


def _keys_of_format_2(activity: Activity) -> Iterator[Fault]:
    """Yields a fault for each key of an activity of format 1 that only format 2 has."""
    if activity.pinel_activity != 1:
        return
    for name in sorted(activity.model_fields_set - FORMAT_1):
        yield Fault("activity_unknown_key", pointer((name,)), None, {"name": name})
    for i, case in enumerate(activity.cases):
        if "start" in case.model_fields_set:
            place = pointer(("cases", i, "start"))
            yield Fault("activity_unknown_key", place, None, {"name": "start"})


def _starts(activity: Activity, document: dict[str, Any]) -> Iterator[Fault]:
    """Yields the faults of starts at which the robot does not fit."""
    for i, case in enumerate(activity.cases):
        if case.start is not None:
            _, faults = read_own_world(_started_from(document, case), robot=activity.model)
            for fault in faults:
                place = pointer(("cases", i, *fault.pointer.split("/")[1:]))
                yield Fault(fault.code, place, None, fault.params)


def _unknown_actions(place: Path, names: Iterable[str]) -> Iterator[Fault]:
    allowed = action_names()
    for i, name in enumerate(names):
        if name not in allowed:
            params: Params = {"value": name, "allowed": allowed}
            yield Fault("unknown_action", pointer((*place, i)), None, params)


def _hints(activity: Activity) -> Iterator[Fault]:
    """Yields a fault for each hint that names a block which the activity does not offer."""
    if activity.blocks is None:
        return
    for i, hint in enumerate(activity.hints):
        for action, name in blocks_named(hint.model_dump(by_alias=True)).items():
            if action not in activity.blocks:
                params: Params = {"hint": i + 1, "block": name, "value": action}
                yield Fault("activity_hint_block", pointer(("hints", i)), None, params)


def _faults_of_diagnosis(place: Path, diagnosis: Diagnosis) -> Iterator[Fault]:
    for fact, expected in diagnosis.when.items():
        here = pointer((*place, "when", fact))
        if not _is_fact(fact):
            allowed: Params = {"value": fact, "allowed": sorted(NUMBER_FACTS | TEXT_FACTS)}
            yield Fault("activity_unknown_fact", here, None, allowed)
        elif isinstance(expected, str) != (fact in TEXT_FACTS):
            kind = "text" if fact in TEXT_FACTS else "number"
            yield Fault(f"wrong_type_{kind}", here, None, {"name": fact})
    if diagnosis.block is not None and not _is_block(diagnosis.block):
        params: Params = {"name": "block", "value": diagnosis.block}
        yield Fault("activity_value_wrong", pointer((*place, "block")), None, params)
    if (diagnosis.say is None) == (diagnosis.general is None):
        yield Fault("activity_diagnosis_words", pointer(place), None, {})


def _is_fact(name: str) -> bool:
    of_action = name[:2] in ("n_", "x_") and name[2:] in action_names()
    return of_action or name in NUMBER_FACTS or name in TEXT_FACTS


def _is_block(which: str) -> bool:
    place, _, action = which.partition(" ")
    if place in ("first", "last"):
        return action in action_names()
    return which in ("touching", "running", "moving", "worst")


def _world(activity: Activity) -> tuple[dict[str, Any] | None, list[Fault]]:
    world = activity.world
    if isinstance(world, str):
        try:
            return titled(world_document(world)), []
        except WorldError as error:
            return None, [Fault(error.code, "/world", None, error.params)]
    document, faults = read_own_world(world, robot=activity.model)
    return document, [Fault(f.code, f"/world{f.pointer}", None, f.params) for f in faults]


def _checks(activity: Activity) -> Iterator[tuple[Path, CheckBase]]:
    for i, case in enumerate(activity.cases):
        for j, check in enumerate(case.checks):
            yield ("cases", i, "checks", j), check
    for i, check in enumerate(activity.checks):
        yield ("checks", i), check


def _nothing_to_check(activity: Activity) -> Iterator[Fault]:
    """Yields a fault for each case without any check, which every program would pass."""
    if activity.checks:
        return
    for i, case in enumerate(activity.cases):
        if not case.checks:
            yield Fault("activity_without_checks", pointer(("cases", i)), None, {"case": i + 1})
