"""Signatures of the functions in a raw document, and faults of duplicate names."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pinel_desktop.program.limits import MAX_NESTING
from pinel_desktop.program.pointers import Finding
from pinel_desktop.program.signatures import COMMAND_SIGNATURES


@dataclass(frozen=True, slots=True)
class Signature:
    """The parameters of a function, and whether it returns a value."""

    parameters: tuple[str, ...]
    gives_value: bool


def signatures(functions: list[Any]) -> tuple[dict[str, Signature], list[Finding]]:
    """The functions by name, the first of each name; and findings for duplicate names."""
    known: dict[str, Signature] = {}
    duplicates: list[Finding] = []
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
                duplicates.append(
                    ("duplicate_parameter", path, {"value": parameter, "function": name})
                )
        if name in known:
            duplicates.append(("duplicate_function", ("functions", i, "name"), {"value": name}))
            continue
        known[name] = Signature(parameters, _gives_value(function.get("commands")))
    return known, duplicates


def parameters_of(function: dict[str, Any]) -> tuple[str, ...]:
    """The parameters of a function that are valid names."""
    given = function.get("parameters")
    return tuple(p for p in given if isinstance(p, str)) if isinstance(given, list) else ()


def _gives_value(commands: Any) -> bool:
    return any(
        command.get("action") == "return" and command.get("value") is not None
        for command in _within(commands)
    )


def _within(commands: Any, depth: int = 0) -> Iterator[dict[str, Any]]:
    """Yields all commands of a body, down to the maximum depth of a document."""
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
