"""Converts statements of Python's syntax tree to commands of a document."""

import ast
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

from pinel_desktop.program.limits import MAX_NESTING
from pinel_desktop.program.python_text.diagnostics import Diagnostics, Positioned
from pinel_desktop.program.python_text.forms import ASK, COMMANDS, FUNCTIONS, SENSOR_CALLS
from pinel_desktop.program.python_text.names import program_name
from pinel_desktop.program.python_text.read_expressions import (
    PLACEHOLDER,
    ExpressionReader,
    is_call_of_robot,
    is_robot,
)
from pinel_desktop.program.python_text.read_loops import loop_of_for
from pinel_desktop.program.python_text.scanning import TextPosition

_Command = dict[str, Any]
_CHANGES: dict[type[ast.operator], str] = {
    ast.Mult: "*",
    ast.Div: "/",
    ast.Mod: "%",
    ast.Pow: "**",
}


# commands that are methods of a list: their other parameters, in order, and an example for messages
_LIST_COMMANDS: dict[str, tuple[tuple[str, ...], str]] = {
    "append": (("value",), "my_list.append(1)"),
    "replace_item": (("position", "value"), "my_list.replace_item(1, 7)"),
}


@dataclass(slots=True)
class _Scope:
    """The enclosing function; `function` is None in the program itself."""

    function: str | None = None
    parameters: frozenset[str] = frozenset()
    shared: set[str] = field(default_factory=set)


class Statements:
    """Reads the statements of one text; `elifs` are the places where an `if` of the tree is an `elif`."""

    def __init__(
        self, diagnostics: Diagnostics, expressions: ExpressionReader, elifs: set[TextPosition]
    ) -> None:
        self._diagnostics, self._expressions, self._elifs = diagnostics, expressions, elifs
        self._scope = _Scope()
        self._parent: _Command | None = None  # the command whose body is being read
        self._depth = 0

    def program(self, statements: Sequence[ast.stmt]) -> list[_Command]:
        """The commands outside of functions."""
        return self._body(statements, "/commands")

    def function(self, node: ast.FunctionDef, pointer: str) -> _Command:
        """Reads a function with its commands."""
        self._diagnostics.nodes[pointer] = node
        self._diagnostics.line(node, pointer)
        arguments = node.args
        if _has_more_than_names(node):
            self._diagnostics.fault(node, "python_parameters", name=node.name)
        parameters = []
        for i, argument in enumerate(arguments.args):
            self._diagnostics.nodes[f"{pointer}/parameters/{i}"] = argument
            parameters.append(self._expressions.name(argument, argument.arg))
        name = self._expressions.name(node, node.name)
        function: _Command = {"name": name, "parameters": parameters, "commands": []}
        last = arguments.args[-1].lineno if arguments.args else node.lineno
        self._diagnostics.anchor(node, last, function)
        self._scope = _Scope(node.name, frozenset(parameters), _shared(node))
        body = self._docstring(node.body, function)
        function["commands"] = self._inside(function, body, f"{pointer}/commands")
        self._scope = _Scope()
        return function

    def _docstring(self, body: list[ast.stmt], function: _Command) -> list[ast.stmt]:
        text = docstring_of(body)
        if text is None:
            return body
        function["comment"] = text
        return body[1:]

    def _inside(
        self, parent: _Command, statements: Sequence[ast.stmt], pointer: str
    ) -> list[_Command]:
        """The commands of a body."""
        outer, self._parent = self._parent, parent
        commands = self._body(statements, pointer)
        self._parent = outer
        return commands

    def _body(self, statements: Sequence[ast.stmt], pointer: str) -> list[_Command]:
        commands: list[_Command] = []
        open_if: _Command | None = None  # an `if` whose `elif` may follow
        if self._is_too_deep(statements):
            return commands
        self._depth += 1
        self._expressions.depth += 1
        for node in statements:
            place = f"{pointer}/{len(commands)}"
            if isinstance(node, ast.If) and self._diagnostics.position(node) in self._elifs:
                open_if = self._elif(node, open_if, f"{pointer}/{max(len(commands) - 1, 0)}")
                continue
            command = self._read(node, place)
            open_if = command if isinstance(node, ast.If) and not node.orelse else None
            if command is not None:
                commands.append(command)
                self._diagnostics.line(node, place)
        self._depth -= 1
        self._expressions.depth -= 1
        return commands

    def _is_too_deep(self, statements: Sequence[ast.stmt]) -> bool:
        if self._depth <= MAX_NESTING + 1 or not statements:
            return self._diagnostics.is_full
        self._diagnostics.fault(statements[0], "nesting_too_deep", max=MAX_NESTING)
        return True

    def _read(self, node: ast.stmt, pointer: str) -> _Command | None:
        """Reads a command; None if the statement is not a command or cannot be read."""
        if self._diagnostics.is_full:
            return None
        self._diagnostics.nodes[pointer] = node
        reader: Callable[[Any, str], _Command | None] | None = getattr(
            self, f"_{type(node).__name__}", None
        )
        if reader is None:
            self._diagnostics.fault(node, _code_of(node), name=_keyword_of(node))
            return None
        return reader(node, pointer)

    def _fault(self, node: Positioned, code: str, **params: object) -> _Command | None:
        """Records a fault; returns None in place of the command."""
        self._diagnostics.fault(node, code, **params)
        return None

    def _simple(self, node: ast.stmt, command: _Command) -> _Command:
        self._diagnostics.anchor(node, node.end_lineno or node.lineno, command)
        return command

    def condition(self, node: ast.expr, pointer: str) -> Any:
        """Reads a condition. A text is not a condition here, although documents may have such strings."""
        value = self._expressions.read(node, pointer)
        if isinstance(value, str):
            self._fault(node, "python_condition_text")
            return PLACEHOLDER
        return value

    def assigned(self, node: Positioned, name: str) -> str:
        """The name of an assigned variable, which a function must have declared with `global`."""
        scope = self._scope
        found = self._expressions.name(node, name)
        if scope.function and found not in scope.parameters and found not in scope.shared:
            scope.shared.add(found)  # report it once
            self._fault(node, "python_global_missing", name=name, function=scope.function)
        return found

    # simple statements, named as `ast` names them

    def _Pass(self, node: ast.Pass, _pointer: str) -> None:  # noqa: N802
        self._diagnostics.anchor(node, node.lineno, self._parent)

    def _Global(self, node: ast.Global, _pointer: str) -> None:  # noqa: N802
        for name in node.names:
            if program_name(name) in self._scope.parameters:
                function = self._scope.function
                self._fault(node, "python_global_parameter", name=name, function=function)

    def _Break(self, node: ast.Break, _pointer: str) -> _Command:  # noqa: N802
        return self._simple(node, {"action": "break"})

    def _Continue(self, node: ast.Continue, _pointer: str) -> _Command:  # noqa: N802
        return self._simple(node, {"action": "continue"})

    def _Return(self, node: ast.Return, pointer: str) -> _Command:  # noqa: N802
        command: _Command = {"action": "return"}
        if node.value is not None and not _is_none(node.value):
            command["value"] = self._expressions.read(node.value, f"{pointer}/value")
        return self._simple(node, command)

    def _Assign(self, node: ast.Assign, pointer: str) -> _Command | None:  # noqa: N802
        target = node.targets[0]
        if len(node.targets) > 1 or not isinstance(target, ast.Name):
            return self._fault(target, "python_assignment")
        name = self.assigned(target, target.id)
        if is_call_of_robot(node.value) and node.value.func.attr == "ask":  # type: ignore[attr-defined]
            return self._ask(node, name, pointer)
        self._diagnostics.nodes[f"{pointer}/name"] = target
        value = self._expressions.read(node.value, f"{pointer}/value")
        return self._simple(node, {"action": "set_variable", "name": name, "value": value})

    def _ask(self, node: ast.Assign, variable: str, pointer: str) -> _Command | None:
        self._diagnostics.nodes[f"{pointer}/variable"] = node.targets[0]
        assert isinstance(node.value, ast.Call)
        bound = self._expressions.bind(node.value, ASK.parameters, "robot.ask", ASK.example)
        if bound is None:
            return None
        question = self._expressions.read(bound["question"], f"{pointer}/question")
        return self._simple(node, {"action": "ask", "question": question, "variable": variable})

    def _AugAssign(self, node: ast.AugAssign, pointer: str) -> _Command | None:  # noqa: N802
        if not isinstance(node.target, ast.Name):
            return self._fault(node.target, "python_assignment")
        name = self.assigned(node.target, node.target.id)
        self._diagnostics.nodes[f"{pointer}/name"] = node.target
        operator = _CHANGES.get(type(node.op))
        if operator is not None:
            by = self._expressions.read(node.value, f"{pointer}/value/args/1")
            value = {"op": operator, "args": [{"var": name}, by]}
            return self._simple(node, {"action": "set_variable", "name": name, "value": value})
        if not isinstance(node.op, ast.Add | ast.Sub):
            return self._fault(node, "python_operator", value="+= -=")
        by = self._expressions.read(node.value, f"{pointer}/by")
        if isinstance(node.op, ast.Sub):
            is_number = isinstance(by, int | float) and not isinstance(by, bool)
            by = -by if is_number else {"op": "-", "args": [0, by]}
        return self._simple(node, {"action": "change_variable", "name": name, "by": by})

    def _Expr(self, node: ast.Expr, pointer: str) -> _Command | None:  # noqa: N802
        call = node.value
        if not isinstance(call, ast.Call):
            return self._without_effect(node)
        function = call.func
        if is_call_of_robot(call):
            command = self._robot(call, pointer)
        elif isinstance(function, ast.Attribute) and function.attr in _LIST_COMMANDS:
            command = self._list_command(call, function, pointer)
        elif isinstance(function, ast.Name) and function.id not in FUNCTIONS:
            found = self._expressions.call_of_function(call, pointer)
            command = found and {"action": "call", "function": found[0], "arguments": found[1]}
        else:
            read = self._expressions.read(call, pointer)
            return None if read is PLACEHOLDER else self._fault(node, "python_no_effect")
        return command and self._simple(node, command)

    def _without_effect(self, node: ast.Expr) -> _Command | None:
        value = node.value
        if isinstance(value, ast.Attribute) and is_robot(value.value) and value.attr in COMMANDS:
            return self._fault(node, "python_parentheses", value=value.attr)
        return self._fault(node, "python_no_effect")

    def _robot(self, call: ast.Call, pointer: str) -> _Command | None:
        assert isinstance(call.func, ast.Attribute)
        action = call.func.attr
        form = COMMANDS.get(action)
        if form is None:
            return self._no_command(call.func)
        bound = self._expressions.bind(call, form.parameters, f"robot.{action}", form.example)
        if bound is None:
            return None
        command: _Command = {"action": action}
        for parameter in form.parameters:
            node, place = bound.get(parameter.name), f"{pointer}/{parameter.name}"
            if node is None:
                continue
            if parameter.literal is not None:
                value = self._expressions.literal(node, parameter, place)
                value = parameter.placeholder if value is None else value
            elif parameter.name == "condition":
                value = self.condition(node, place)
            else:
                value = self._expressions.read(node, place)
            if value is not None:
                command[parameter.name] = value
        return command

    def _no_command(self, function: ast.Attribute) -> _Command | None:
        if function.attr == "ask":
            return self._fault(function, "python_ask")
        if function.attr in SENSOR_CALLS:
            return self._fault(function, "python_no_effect")
        self._expressions.unknown_robot(function, COMMANDS)
        return None

    def _list_command(
        self, call: ast.Call, function: ast.Attribute, pointer: str
    ) -> _Command | None:
        parameters, example = _LIST_COMMANDS[function.attr]
        has_all = len(call.args) == len(parameters) and not call.keywords
        if not has_all or not isinstance(function.value, ast.Name):
            return self._fault(call, "python_arguments", name=function.attr, example=example)
        self._diagnostics.nodes[f"{pointer}/list"] = function.value
        name = self._expressions.name(function.value, function.value.id)
        command: _Command = {"action": function.attr, "list": name}
        for parameter, argument in zip(parameters, call.args, strict=True):
            command[parameter] = self._expressions.read(argument, f"{pointer}/{parameter}")
        return command

    # statements with a body

    def _While(self, node: ast.While, pointer: str) -> _Command:  # noqa: N802
        command: _Command = {"action": "while"}
        condition, place = node.test, f"{pointer}/condition"
        if isinstance(condition, ast.Constant) and condition.value is True:
            command["action"] = "forever"
        elif isinstance(condition, ast.UnaryOp) and isinstance(condition.op, ast.Not):
            command["action"] = "until"
            command["condition"] = self.condition(condition.operand, place)
        else:
            command["condition"] = self.condition(condition, place)
        return self._loop(node, condition, command, pointer)

    def _For(self, node: ast.For, pointer: str) -> _Command:  # noqa: N802
        command = loop_of_for(node, self, self._expressions, pointer)
        if command is None:
            self._fault(node, "python_for")
            command = {"action": "repeat", "times": 1}
        return self._loop(node, node.iter, command, pointer)

    def _loop(
        self, node: ast.For | ast.While, heading: ast.expr, command: _Command, pointer: str
    ) -> _Command:
        self._diagnostics.anchor(node, heading.end_lineno or node.lineno, command)
        command["commands"] = self._inside(command, node.body, f"{pointer}/commands")
        if node.orelse:
            self._fault(node.orelse[0], "python_loop_else")
        return command

    def _If(self, node: ast.If, pointer: str) -> _Command:  # noqa: N802
        command: _Command = {"action": "conditional_execution"}
        self._diagnostics.anchor(node, node.test.end_lineno or node.lineno, command)
        command["condition"] = self.condition(node.test, f"{pointer}/condition")
        command["commands"] = self._inside(command, node.body, f"{pointer}/commands")
        self._else(node, command, pointer)
        return command

    def _elif(self, node: ast.If, command: _Command | None, pointer: str) -> _Command | None:
        """Adds a branch; returns the command if another one may follow."""
        if command is None:
            self._fault(node, "python_elif")
            return None
        branches = command.setdefault("elif", [])
        place = f"{pointer}/elif/{len(branches)}"
        self._diagnostics.nodes[place] = node
        condition = self.condition(node.test, f"{place}/condition")
        commands = self._inside(command, node.body, f"{place}/commands")
        branches.append({"condition": condition, "commands": commands})
        self._else(node, command, pointer)
        return None if node.orelse else command

    def _else(self, node: ast.If, command: _Command, pointer: str) -> None:
        commands = self._inside(command, node.orelse, f"{pointer}/else")
        if commands:
            command["else"] = commands


def docstring_of(body: Sequence[ast.stmt]) -> str | None:
    """The docstring of a program or function; None without one."""
    first = body[0] if body else None
    if isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant):
        value = first.value.value
        return value if isinstance(value, str) else None
    return None


def _shared(node: ast.FunctionDef) -> set[str]:
    """The variables that a function declares with `global`."""
    found: set[str] = set()
    for part in ast.walk(node):
        if isinstance(part, ast.Global):
            found.update(program_name(name) for name in part.names)
    return found


def _has_more_than_names(node: ast.FunctionDef) -> bool:
    given = node.args
    more = (given.posonlyargs, given.vararg, given.kwonlyargs, given.kwarg, given.defaults)
    diagnostics = (node.decorator_list, node.returns, any(arg.annotation for arg in given.args))
    return any((*more, *diagnostics))


def _is_none(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and node.value is None


_CODES: dict[type[ast.stmt], str] = {
    ast.Import: "python_import",
    ast.ImportFrom: "python_import",
    ast.FunctionDef: "python_function_inside",
    ast.AnnAssign: "python_assignment",
}
_KEYWORDS: dict[type[ast.stmt], str] = {
    ast.ClassDef: "class",
    ast.AsyncFunctionDef: "async",
    ast.AsyncFor: "async",
    ast.AsyncWith: "async",
    ast.Delete: "del",
    ast.Nonlocal: "nonlocal",
}


def _code_of(node: ast.stmt) -> str:
    return _CODES.get(type(node), "python_statement")


def _keyword_of(node: ast.stmt) -> str:
    return _KEYWORDS.get(type(node), type(node).__name__.removesuffix("Star").lower())
