"""What is to be checked of each command beyond its own model, taken from the models."""

from dataclasses import dataclass, field
from typing import Any, Literal

from pinel_desktop.program.base import Model, annotations
from pinel_desktop.program.expressions import Lidar, Sonar, Takes
from pinel_desktop.program.model import COMMANDS, action_of
from pinel_desktop.program.operators import ValueType

# the type that a parameter's expression must have; None is any
Wanted = ValueType | None
_NAMES_OF_VARIABLES = ("name", "variable", "list")


@dataclass(slots=True)
class Plan:
    """Parameters with an expression, keys that name variables, keys of bodies.

    Attributes:
        is_simple: whether there are only expressions and names, and no condition, which may be a text to be parsed.
    """

    expressions: list[tuple[str, Wanted]] = field(default_factory=list)
    variables: list[str] = field(default_factory=list)
    bodies: list[str] = field(default_factory=list)
    role: Literal["loop", "jump", "call", "return"] | None = None
    is_simple: bool = False


def takes_of(annotation: Any) -> Takes | None:
    """The mark on a parameter that takes a literal within bounds, or an expression."""
    for part in (annotation, *getattr(annotation, "__args__", ())):
        for mark in getattr(part, "__metadata__", ()):
            if isinstance(mark, Takes):
                return mark
    return None


def _plan(model: type[Model]) -> Plan:
    plan = Plan()
    for key, annotation in annotations(model).items():
        takes = takes_of(annotation)
        if takes is not None:
            plan.expressions.append((key, takes.type))
        elif key in ("condition", "value", "text"):
            plan.expressions.append((key, "boolean" if key == "condition" else None))
        elif key in _NAMES_OF_VARIABLES:
            plan.variables.append(key)
        elif key in ("commands", "else"):
            plan.bodies.append(key)
    return plan


def _plans() -> dict[str, Plan]:
    plans = {action_of(model): _plan(model) for model in COMMANDS}
    # the original's spellings
    plans["classificar_gestos"] = plans["classify_gestures"]
    plans["set_gesture_result"].expressions += [("resultado", "text")]
    for action in ("repeat", "while", "until", "for", "forever"):
        plans[action].role = "loop"
    for action in ("break", "continue"):
        plans[action].role = "jump"
    plans["call"].role = "call"
    plans["return"].role = "return"
    for plan in plans.values():
        conditions = any(key == "condition" for key, _ in plan.expressions)
        plan.is_simple = not (plan.bodies or plan.role or conditions)
    return plans


def _takes() -> dict[tuple[str, str], Takes]:
    models: list[tuple[str, type[Model]]] = [(action_of(model), model) for model in COMMANDS]
    models += [("sonar", Sonar), ("lidar", Lidar)]
    found = (
        (kind, key, takes_of(annotation))
        for kind, model in models
        for key, annotation in annotations(model).items()
    )
    return {(kind, key): takes for kind, key, takes in found if takes is not None}


PLANS = _plans()
TAKES = _takes()  # (action or sensor, parameter) -> its bounds
