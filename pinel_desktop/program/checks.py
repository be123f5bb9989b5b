"""What no single model can know: types of expressions, functions and their arguments, jumps, names of variables.

Works on the document as it was given, whatever else is wrong with it, so that all faults come at once: what is
malformed is passed over here, and reported by the models.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from pinel_desktop.program.expression_checks import Expressions
from pinel_desktop.program.functions import Signature, signatures
from pinel_desktop.program.limits import MAX_VARIABLES
from pinel_desktop.program.places import Path
from pinel_desktop.program.plans import PLANS, Plan

# (code, path, params)
Finding = tuple[str, Path, dict[str, object]]


@dataclass(frozen=True, slots=True)
class _Around:
    """What is around a command."""

    in_function: bool = False
    in_loop: bool = False


def check_meaning(document: Any) -> list[Finding]:
    """Findings in a `pinel_ir` document that has the shape of one."""
    return list(_Checker(document).findings()) if isinstance(document, dict) else []


class _Checker:
    def __init__(self, document: dict[str, Any]) -> None:
        self._document = document
        self._variables: set[str] = set()
        self._signatures: dict[str, Signature] = {}
        self._found: list[Finding] = []
        self._expressions = Expressions(self._signatures, self._variables, self._found)

    def findings(self) -> Iterator[Finding]:
        functions = self._document.get("functions")
        functions = functions if isinstance(functions, list) else []
        known, doubled = signatures(functions)
        self._signatures.update(known)
        yield from doubled
        for i, function in enumerate(functions):
            if isinstance(function, dict):
                body, path = function.get("commands"), ("functions", i, "commands")
                self._commands(body, path, _Around(in_function=True))
        self._commands(self._document.get("commands"), ("commands",), _Around())
        yield from self._found
        if len(self._variables) > MAX_VARIABLES:
            params: dict[str, object] = {"value": len(self._variables), "max": MAX_VARIABLES}
            yield "too_many_variables", (), params

    def _commands(self, commands: Any, path: Path, around: _Around) -> None:
        if commands.__class__ is not list:
            return
        for i, command in enumerate(commands):
            if command.__class__ is not dict:
                continue
            action = command.get("action")
            plan = PLANS.get(action) if action.__class__ is str else None
            if plan is not None:
                self._command(command, plan, (*path, i), around)

    def _command(self, command: dict[str, Any], plan: Plan, path: Path, around: _Around) -> None:
        for key, wanted in plan.expressions:
            value = command.get(key)
            kind = value.__class__
            if kind is dict or key == "condition":
                self._expressions.check(value, (*path, key), wanted)
        for key in plan.variables:
            self._expressions.name(command.get(key))
        if plan.role is not None:
            self._role(command, plan.role, path, around)
        if plan.bodies:
            inside = replace(around, in_loop=True) if plan.role == "loop" else around
            for key in plan.bodies:
                self._commands(command.get(key), (*path, key), inside)
            self._branches(command.get("elif"), (*path, "elif"), inside)

    def _branches(self, branches: Any, path: Path, around: _Around) -> None:
        for i, branch in enumerate(branches if isinstance(branches, list) else ()):
            if isinstance(branch, dict):
                condition = branch.get("condition")
                self._expressions.check(condition, (*path, i, "condition"), "boolean")
                self._commands(branch.get("commands"), (*path, i, "commands"), around)

    def _role(self, command: dict[str, Any], role: str, path: Path, around: _Around) -> None:
        if role == "jump" and not around.in_loop:
            self._found.append((f"{command['action']}_outside_loop", path, {}))
        elif role == "return" and not around.in_function:
            self._found.append(("return_outside_function", path, {}))
        elif role == "call":
            arguments = command.get("arguments", {})
            self._expressions.call(command.get("function"), arguments, path, "function")
