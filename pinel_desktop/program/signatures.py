"""Data for the semantic checks of each command, derived from the models."""

from dataclasses import dataclass, field
from typing import Any, Literal, get_args, get_origin

from pinel_desktop.program.base import Model, annotations
from pinel_desktop.program.command import action_of
from pinel_desktop.program.expressions import READINGS, ParameterSpec
from pinel_desktop.program.model import COMMANDS
from pinel_desktop.program.operators import ValueType

# required type of a parameter's expression; None is any type
ExpectedType = ValueType | None
_NAMES_OF_VARIABLES = ("name", "variable", "list")


@dataclass(slots=True)
class CommandSignature:
    """The checked keys of a command.

    Attributes:
        expressions: parameters with an expression, each with its required type.
        variables: keys whose values name variables.
        bodies: keys with lists of commands.
        is_simple: True if the command has only expressions and names, and no condition, which may need parsing.
    """

    expressions: list[tuple[str, ExpectedType]] = field(default_factory=list)
    variables: list[str] = field(default_factory=list)
    bodies: list[str] = field(default_factory=list)
    role: Literal["loop", "jump", "call", "return"] | None = None
    is_simple: bool = False


def parameter_spec(annotation: Any) -> ParameterSpec | None:
    """The `ParameterSpec` annotation of a parameter; None without one."""
    for part in (annotation, *getattr(annotation, "__args__", ())):
        for mark in getattr(part, "__metadata__", ()):
            if isinstance(mark, ParameterSpec):
                return mark
    return None


def choices_of(annotation: Any) -> tuple[str, ...]:
    """The allowed literal texts of a parameter; empty if it is not a choice."""
    for part in (annotation, *get_args(annotation)):
        if get_origin(part) is Literal:
            return get_args(part)
    return ()


def _signature(model: type[Model]) -> CommandSignature:
    signature = CommandSignature()
    for key, annotation in annotations(model).items():
        spec = parameter_spec(annotation)
        if spec is not None:
            signature.expressions.append((key, spec.type))
        elif key in ("condition", "value", "text"):
            signature.expressions.append((key, "boolean" if key == "condition" else None))
        elif key in _NAMES_OF_VARIABLES:
            signature.variables.append(key)
        elif key in ("commands", "else"):
            signature.bodies.append(key)
    return signature


def _signatures() -> dict[str, CommandSignature]:
    signatures = {action_of(model): _signature(model) for model in COMMANDS}
    # the original's spellings
    signatures["classificar_gestos"] = signatures["classify_gestures"]
    signatures["set_gesture_result"].expressions += [("resultado", "text")]
    for action in ("repeat", "while", "until", "for", "forever"):
        signatures[action].role = "loop"
    for action in ("break", "continue"):
        signatures[action].role = "jump"
    signatures["call"].role = "call"
    signatures["return"].role = "return"
    for signature in signatures.values():
        conditions = any(key == "condition" for key, _ in signature.expressions)
        signature.is_simple = not (signature.bodies or signature.role or conditions)
    return signatures


def _parameter_specs() -> dict[tuple[str, str], ParameterSpec]:
    models: list[tuple[str, type[Model]]] = [(action_of(model), model) for model in COMMANDS]
    models += READINGS.items()
    found = (
        (kind, key, parameter_spec(annotation))
        for kind, model in models
        for key, annotation in annotations(model).items()
    )
    return {(kind, key): spec for kind, key, spec in found if spec is not None}


COMMAND_SIGNATURES = _signatures()
PARAMETER_SPECS = _parameter_specs()  # (action or sensor, parameter) -> its bounds


def range_code(name: str, spec: ParameterSpec) -> str:
    """Error code for a value of the parameter outside its bounds, on reading and in a run."""
    if spec.le is None:
        return f"{name}_not_positive"
    return "sonar_out_of_range" if name == "index" else f"{name}_out_of_range"
