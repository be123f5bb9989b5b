"""Semantic checks across models: types of expressions, functions and their arguments, jumps, names of variables.

They work on the raw document, even with other faults, so that all faults are reported at once. Malformed parts are
ignored here and reported by the models.
"""

from dataclasses import dataclass, field, replace
from typing import Any

from pinel_desktop.program.expression_checks import ExpressionChecker
from pinel_desktop.program.functions import parameters_of, signatures
from pinel_desktop.program.limits import MAX_COMMANDS, MAX_NESTING, MAX_VARIABLES
from pinel_desktop.program.pointers import MAX_PATH, Path, PathFault
from pinel_desktop.program.signatures import COMMAND_SIGNATURES, CommandSignature


@dataclass(frozen=True, slots=True)
class _Context:
    """The context of a command."""

    in_function: bool = False
    in_loop: bool = False


@dataclass(slots=True)
class SemanticCheck:
    """Result of the semantic checks.

    Attributes:
        faults: faults, in no order.
        warnings: findings about valid parts that are hardly intended, in no order.
        is_large: True if there may be too many commands or levels; `shape.check_shape` decides.
        n_keys: number of keys in all objects; in a malformed document possibly fewer, never more.
    """

    faults: list[PathFault] = field(default_factory=list)
    warnings: list[PathFault] = field(default_factory=list)
    is_large: bool = False
    n_keys: int = 0


def check_semantics(document: dict[str, Any]) -> SemanticCheck:
    """Checks a `pinel_ir` document, down to the maximum depth of a document."""
    checker = _Checker(document)
    checker.run()
    return SemanticCheck(checker.found, checker.warnings, checker.is_large, checker.n_keys)


class _Checker:
    def __init__(self, document: dict[str, Any]) -> None:
        self._document = document
        self._variables: set[str] = set()
        self._n_commands = 0
        self._n_keys = len(document)
        self._deepest = 0
        functions = document.get("functions")
        self._functions = functions if isinstance(functions, list) else []
        self._signatures, self.found = signatures(self._functions)
        self._expressions = ExpressionChecker(self._signatures, self._variables, self.found)

    @property
    def warnings(self) -> list[PathFault]:
        return self._expressions.warnings

    @property
    def is_large(self) -> bool:
        deepest = max(self._deepest, self._expressions.deepest)
        return self._n_commands > MAX_COMMANDS or deepest >= MAX_NESTING

    @property
    def n_keys(self) -> int:
        return self._n_keys + self._expressions.n_keys

    def run(self) -> None:
        """Adds the findings to `found`."""
        functions = self._functions
        for i, function in enumerate(functions):
            if isinstance(function, dict):
                self._n_keys += len(function)
                body, path = function.get("commands"), ("functions", i, "commands")
                self._expressions.parameters = parameters_of(function)
                self._commands(body, path, _Context(in_function=True))
        self._expressions.parameters = ()
        self._commands(self._document.get("commands"), ("commands",), _Context())
        if len(self._variables) > MAX_VARIABLES:
            params: dict[str, object] = {"value": len(self._variables), "max": MAX_VARIABLES}
            self.found.append(("too_many_variables", (), params))

    def _commands(self, commands: Any, path: Path, context: _Context) -> None:
        if commands.__class__ is not list:
            return
        self._n_commands += len(commands)
        expressions = self._expressions
        note, check, is_obviously_valid = (
            expressions.name,
            expressions.check,
            expressions.is_obviously_valid,
        )
        n_keys = 0
        near = len(path) < MAX_NESTING // 2  # farther in, only `check` measures the depth
        for i, command in enumerate(commands):
            if command.__class__ is not dict:
                continue
            action = command.get("action")
            signature = COMMAND_SIGNATURES.get(action) if action.__class__ is str else None
            if signature is None:
                continue
            n_keys += len(command)
            if not signature.is_simple:
                self._command(command, signature, (*path, i), context)
                continue
            for key in signature.variables:
                note(command.get(key))
            for key, expected in signature.expressions:  # mostly literals, which the models check
                value = command.get(key)
                if value.__class__ is dict and not (near and is_obviously_valid(value, expected)):
                    check(value, (*path, i, key), expected)
        self._n_keys += n_keys

    def _command(
        self, command: dict[str, Any], signature: CommandSignature, path: Path, context: _Context
    ) -> None:
        self._deepest = max(self._deepest, len(path))
        if len(path) > MAX_PATH:
            return
        for key, expected in signature.expressions:
            value = command.get(key)
            if value.__class__ is dict or key == "condition":
                self._expressions.check(value, (*path, key), expected)
        for key in signature.variables:
            self._expressions.name(command.get(key))
        if signature.role is not None:
            self._role(command, signature.role, path, context)
        if signature.bodies:
            inside = replace(context, in_loop=True) if signature.role == "loop" else context
            for key in signature.bodies:
                self._commands(command.get(key), (*path, key), inside)
            self._branches(command.get("elif"), (*path, "elif"), inside)

    def _branches(self, branches: Any, path: Path, context: _Context) -> None:
        for i, branch in enumerate(branches if isinstance(branches, list) else ()):
            if isinstance(branch, dict):
                self._n_keys += len(branch)
                condition = branch.get("condition")
                self._expressions.check(condition, (*path, i, "condition"), "boolean")
                self._commands(branch.get("commands"), (*path, i, "commands"), context)

    def _role(self, command: dict[str, Any], role: str, path: Path, context: _Context) -> None:
        if role == "jump" and not context.in_loop:
            self.found.append((f"{command['action']}_outside_loop", path, {}))
        elif role == "return" and not context.in_function:
            self.found.append(("return_outside_function", path, {}))
        elif role == "call":
            arguments = command.get("arguments", {})
            self._expressions.call(command.get("function"), arguments, path, "function")
