"""Signatures of the functions in a raw document, and faults of duplicate names."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pinel_desktop.program.limits import MAX_NESTING, MAX_PARAMETERS
from pinel_desktop.program.pointers import Path, PathFault
from pinel_desktop.program.signatures import COMMAND_SIGNATURES


@dataclass(frozen=True, slots=True)
class Signature:
    """The parameters of a function, and whether it returns a value."""

    parameters: tuple[str, ...]
    gives_value: bool


def signatures(functions: list[Any]) -> tuple[dict[str, Signature], list[PathFault]]:
    """The functions by name, the first of each name; and findings for duplicate names and too many parameters."""
    known: dict[str, Signature] = {}
    faults: list[PathFault] = []
    for i, function in enumerate(functions):
        name = function.get("name") if isinstance(function, dict) else None
        if not isinstance(name, str):
            continue
        parameters = parameters_of(function)
        faults += _parameter_faults(("functions", i, "parameters"), function, name)
        if name in known:
            faults.append(("duplicate_function", ("functions", i, "name"), {"value": name}))
            continue
        known[name] = Signature(parameters, _gives_value(function.get("commands")))
    return known, faults


def _parameter_faults(path: Path, function: dict[str, Any], name: str) -> Iterator[PathFault]:
    given = function.get("parameters")
    if not isinstance(given, list):
        return
    if len(given) > MAX_PARAMETERS:
        yield (
            "too_many_parameters",
            path,
            {"function": name, "value": len(given), "max": MAX_PARAMETERS},
        )
        return
    known = set()
    for j, parameter in enumerate(given):
        if isinstance(parameter, str) and parameter in known:
            yield "duplicate_parameter", (*path, j), {"value": parameter, "function": name}
        if isinstance(parameter, str):
            known.add(parameter)


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
