"""Writes a document as Python text, one line for each command, in the forms of `forms.py`."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pinel_desktop.program.conditions import parse_condition
from pinel_desktop.program.python_text.comments import comment_text
from pinel_desktop.program.python_text.forms import ASK, COMMANDS, NOT, Parameter
from pinel_desktop.program.python_text.names import python_name
from pinel_desktop.program.python_text.write_expressions import (
    Signatures,
    call_text,
    expression_text,
    number_text,
    string_literal,
)


@dataclass(frozen=True, slots=True)
class TextLine:
    """The content of a line: a command, or the head of a function."""

    pointer: str
    block: str | None = None


@dataclass(frozen=True, slots=True)
class PythonText:
    """A program as Python text; `lines` has the command of each line, counted from 1."""

    text: str
    lines: Mapping[int, TextLine]


def write_python(document: Mapping[str, Any]) -> PythonText:
    """The Python text of a document in its normal form (`ParseResult.document`)."""
    functions = document.get("functions", [])
    signatures = {function["name"]: function.get("parameters", []) for function in functions}
    writer = _Writer(signatures)
    if document.get("name"):
        writer.write(_docstring(document["name"]), 0)
    for i, function in enumerate(functions):
        writer.gap(2)
        writer.function(function, f"/functions/{i}")
    writer.gap(2 if functions else 1)
    writer.commands(document["commands"], "/commands", 0)
    return PythonText("".join(f"{line}\n" for line in writer.text()), writer.lines)


def _docstring(name: str) -> str:
    quoted = string_literal(name)
    plain = quoted == f'"{name}"' and name.strip() == name
    return f'"""{name}"""' if plain else quoted


class _Writer:
    def __init__(self, signatures: Signatures) -> None:
        self._signatures = signatures
        self._text: list[str] = []
        self.lines: dict[int, TextLine] = {}

    def text(self) -> list[str]:
        """The lines, without empty ones at the end."""
        while self._text and not self._text[-1]:
            self._text.pop()
        return self._text

    def write(self, text: str, depth: int) -> None:
        self._text.append("    " * depth + text)

    def gap(self, n_lines: int) -> None:
        """Writes empty lines, except at the beginning of the text."""
        self._text += [""] * (n_lines if self._text else 0)

    def function(self, function: Mapping[str, Any], pointer: str) -> None:
        parameters = function.get("parameters", [])
        names = ", ".join(python_name(name) for name in parameters)
        heading = f"def {python_name(function['name'])}({names}):"
        self._begin(function, heading, pointer, 0)
        assigned = dict.fromkeys(_assigned(function["commands"]))
        shared = [python_name(name) for name in assigned if name not in parameters]
        if shared:
            self.write(f"global {', '.join(shared)}", 1)
        self._body(function["commands"], f"{pointer}/commands", 1, empty=not shared)

    def commands(self, commands: Sequence[Mapping[str, Any]], pointer: str, depth: int) -> None:
        for i, command in enumerate(commands):
            self._command(command, f"{pointer}/{i}", depth)

    def _body(
        self, commands: Sequence[Mapping[str, Any]], pointer: str, depth: int, *, empty: bool = True
    ) -> None:
        self.commands(commands, pointer, depth)
        if empty and not commands:
            self.write("pass", depth)

    def _begin(self, command: Mapping[str, Any], text: str, pointer: str, depth: int) -> None:
        """Writes the comment and the first line of a command."""
        comment = command.get("comment")
        for line in () if comment is None else comment.split("\n"):
            self.write(f"# {comment_text(line)}" if line else "#", depth)
        self.write(text, depth)
        self.lines[len(self._text)] = TextLine(pointer, command.get("block"))

    def _command(self, command: Mapping[str, Any], pointer: str, depth: int) -> None:
        self._begin(command, self._heading(command), pointer, depth)
        if "commands" in command:
            self._body(command["commands"], f"{pointer}/commands", depth + 1)
        for i, branch in enumerate(command.get("elif", ())):
            self.write(f"elif {self._condition(branch)}:", depth)
            self._body(branch["commands"], f"{pointer}/elif/{i}/commands", depth + 1)
        if command.get("else"):
            self.write("else:", depth)
            self.commands(command["else"], f"{pointer}/else", depth + 1)

    def _heading(self, command: Mapping[str, Any]) -> str:
        action = command["action"]
        form = COMMANDS.get(action)
        if form is not None:
            given = (self._argument(command, parameter) for parameter in form.parameters)
            return f"robot.{action}({', '.join(text for text in given if text)})"
        return str(getattr(self, f"_{action}")(command))

    def _expression(self, value: Any, min_precedence: int = 0) -> str:
        return expression_text(value, self._signatures, min_precedence)

    def _condition(self, command: Mapping[str, Any], min_precedence: int = 0) -> str:
        condition = command["condition"]
        tree = parse_condition(condition) if isinstance(condition, str) else condition
        return self._expression(tree, min_precedence)

    def _argument(self, command: Mapping[str, Any], parameter: Parameter) -> str:
        value = command.get(parameter.name)
        value = parameter.written_as if value is None else value
        if value is None or value is parameter.default:
            return ""
        if parameter.name == "condition":
            return self._condition(command)
        text = expression_text(value, self._signatures, metres=parameter.metres)
        return f"{parameter.name}={text}" if parameter.keyword else text

    def _ask(self, command: Mapping[str, Any]) -> str:
        question = self._expression(command[ASK.parameters[0].name])
        return f"{python_name(command['variable'])} = robot.ask({question})"

    def _set_variable(self, command: Mapping[str, Any]) -> str:
        return f"{python_name(command['name'])} = {self._expression(command['value'])}"

    def _change_variable(self, command: Mapping[str, Any]) -> str:
        name, by = python_name(command["name"]), command["by"]
        if isinstance(by, int | float) and by < 0:
            return f"{name} -= {number_text(-by)}"
        return f"{name} += {self._expression(by)}"

    def _append(self, command: Mapping[str, Any]) -> str:
        return f"{python_name(command['list'])}.append({self._expression(command['value'])})"

    def _replace_item(self, command: Mapping[str, Any]) -> str:
        given = (self._expression(command[key]) for key in ("position", "value"))
        return f"{python_name(command['list'])}.replace_item({', '.join(given)})"

    def _repeat(self, command: Mapping[str, Any]) -> str:
        return f"for _ in range({self._expression(command['times'])}):"

    def _for(self, command: Mapping[str, Any]) -> str:
        bounds = [command["from"], command["to"]]
        by = command.get("by", 1)
        if isinstance(by, dict) or by != 1:
            bounds.append(by)
        steps = ", ".join(self._expression(bound) for bound in bounds)
        return f"for {python_name(command['variable'])} in steps({steps}):"

    def _forever(self, _command: Mapping[str, Any]) -> str:
        return "while True:"

    def _while(self, command: Mapping[str, Any]) -> str:
        return f"while {self._condition(command)}:"

    def _until(self, command: Mapping[str, Any]) -> str:
        return f"while not {self._condition(command, NOT)}:"

    def _conditional_execution(self, command: Mapping[str, Any]) -> str:
        return f"if {self._condition(command)}:"

    def _break(self, _command: Mapping[str, Any]) -> str:
        return "break"

    def _continue(self, _command: Mapping[str, Any]) -> str:
        return "continue"

    def _call(self, command: Mapping[str, Any]) -> str:
        return call_text(command["function"], command.get("arguments", {}), self._signatures)

    def _return(self, command: Mapping[str, Any]) -> str:
        value = command.get("value")
        return "return" if value is None else f"return {self._expression(value)}"


_ASSIGNS = {
    "set_variable": "name",
    "change_variable": "name",
    "ask": "variable",
    "for": "variable",
}


def _assigned(commands: Sequence[Mapping[str, Any]]) -> Iterator[str]:
    """Names of the variables that the commands assign, in order."""
    for command in commands:
        key = _ASSIGNS.get(command["action"])
        if key is not None:
            yield command[key]
        yield from _assigned(command.get("commands", ()))
        for branch in command.get("elif", ()):
            yield from _assigned(branch["commands"])
        yield from _assigned(command.get("else", ()))
