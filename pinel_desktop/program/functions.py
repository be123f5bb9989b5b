"""The functions of a document as it was given: their parameters, whether they return a value, doubled names."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pinel_desktop.program.limits import MAX_NESTING
from pinel_desktop.program.pointers import Finding
from pinel_desktop.program.signatures import COMMAND_SIGNATURES


@dataclass(frozen=True, slots=True)
class Signature:
    """What a call must know of a function."""

    parameters: tuple[str, ...]
    gives_value: bool


def signatures(functions: list[Any]) -> tuple[dict[str, Signature], list[Finding]]:
    """The functions by name, the first of each name; and faults of names that are there twice."""
    known: dict[str, Signature] = {}
    doubled: list[Finding] = []
    for i, function in enumerate(functions):
        name = function.get("name") if isinstance(function, dict) else None
        if not isinstance(name, str):
            continue
        parameters = parameters_of(function)
        given = function.get("parameters")
        for j, parameter in enumerate(parameters):
            if parameter in parameters[:j]:
                path = (
                    "functions",
                    i,
                    "parameters",
                    given.index(parameter, given.index(parameter) + 1),
                )
                doubled.append(
                    ("duplicate_parameter", path, {"value": parameter, "function": name})
                )
        if name in known:
            doubled.append(("duplicate_function", ("functions", i, "name"), {"value": name}))
            continue
        known[name] = Signature(parameters, _gives_value(function.get("commands")))
    return known, doubled


def parameters_of(function: dict[str, Any]) -> tuple[str, ...]:
    """Those of its parameters that can be names."""
    given = function.get("parameters")
    return tuple(p for p in given if isinstance(p, str)) if isinstance(given, list) else ()


def _gives_value(commands: Any) -> bool:
    return any(
        command.get("action") == "return" and command.get("value") is not None
        for command in _within(commands)
    )


def _within(commands: Any, depth: int = 0) -> Iterator[dict[str, Any]]:
    """All commands of a body, as deep as a document may be."""
    if depth > MAX_NESTING:
        return
    for command in commands if isinstance(commands, list) else ():
        if not isinstance(command, dict):
            continue
        yield command
        action = command.get("action")
        signature = COMMAND_SIGNATURES.get(action) if isinstance(action, str) else None
        for key in signature.bodies if signature else ():
            yield from _within(command.get(key), depth + 1)
        branches = command.get("elif")
        for branch in branches if isinstance(branches, list) else ():
            body = branch.get("commands") if isinstance(branch, dict) else None
            yield from _within(body, depth + 1)
