"""Writes expressions of a document as Python text, with the fewest parentheses that preserve the tree."""

import re
from collections.abc import Mapping, Sequence
from typing import Any

from pinel_desktop.program.python_text.forms import (
    AND,
    ATOM,
    CAPTURED,
    COMPARISON,
    NOT,
    OR,
    POWER,
    PRECEDENCE,
    SENSOR_CALLS,
    SIGN,
)
from pinel_desktop.program.python_text.names import python_name

_CAPTURED_NAMES = {what: name for name, what in CAPTURED.items()}
# parameters of functions, by name of the function
Signatures = Mapping[str, Sequence[str]]
_MAX_WHOLE = 1e16  # larger doubles are written with an exponent
_SIMPLE = re.compile(r"-?[\w.]+")


def string_literal(value: str) -> str:
    """A string literal on one line, with the kind of quotes that needs fewer backslashes."""
    escaped = repr(f"'\"{value}")[4:-1].replace("\\'", "'")
    if '"' in value and "'" not in value:
        return f"'{escaped}'"
    return '"' + escaped.replace('"', '\\"') + '"'


def number_text(value: float, *, metres: bool = False) -> str:
    """The shortest text of a double that reads back equal; whole numbers have a decimal point only for metres."""
    whole = float(value).is_integer() and abs(value) < _MAX_WHOLE
    if not whole or str(value) == "-0.0":
        return repr(float(value)).replace("e+", "e")
    return f"{int(value)}.0" if metres else str(int(value))


def expression_text(
    value: Any, signatures: Signatures, min_precedence: int = OR, *, metres: bool = False
) -> str:
    """An expression as text, in parentheses if its precedence is below `min_precedence`."""
    text, binds = _Writer(signatures).write(value, metres=metres)
    return text if binds >= min_precedence else f"({text})"


def call_text(function: str, arguments: Mapping[str, Any], signatures: Signatures) -> str:
    """A call of a function of the program, with the arguments in the order of the parameters."""
    parameters = signatures.get(function, ())
    if set(parameters) == set(arguments):
        given = [expression_text(arguments[name], signatures) for name in parameters]
    else:
        given = [
            f"{python_name(name)}={expression_text(argument, signatures)}"
            for name, argument in arguments.items()
        ]
    return f"{python_name(function)}({', '.join(given)})"


class _Writer:
    """Writes expressions as (text, precedence)."""

    def __init__(self, signatures: Signatures) -> None:
        self._signatures = signatures

    def write(self, value: Any, *, metres: bool = False) -> tuple[str, int]:
        if isinstance(value, bool):
            return str(value), ATOM
        if isinstance(value, int | float):
            text = number_text(value, metres=metres)
            return text, SIGN if text.startswith("-") else ATOM
        if isinstance(value, str):
            return string_literal(value), ATOM
        if isinstance(value, list):
            return f"[{', '.join(self._at(item, OR) for item in value)}]", ATOM
        return self._node(value)

    def _at(self, value: Any, min_precedence: int) -> str:
        text, binds = self.write(value)
        return text if binds >= min_precedence else f"({text})"

    def _node(self, node: Mapping[str, Any]) -> tuple[str, int]:
        if "op" in node:
            return self._operation(node["op"], node["args"])
        if "var" in node:
            return python_name(node["var"]), ATOM
        if "gesture" in node:
            return f"robot.{_CAPTURED_NAMES[node['gesture']]}", ATOM
        if "call" in node:
            return call_text(node["call"], node.get("arguments", {}), self._signatures), ATOM
        return self._sensor(node), ATOM

    def _sensor(self, node: Mapping[str, Any]) -> str:
        name = node["sensor"]
        form = SENSOR_CALLS.get(name)
        if form is None:
            return f"robot.{name}"
        return f"robot.{name}({self._at(node[form.parameters[0].name], OR)})"

    def _operation(self, name: str, args: Sequence[Any]) -> tuple[str, int]:
        binds = PRECEDENCE.get(name)
        if binds is None:
            return f"{name}({', '.join(self._at(argument, OR) for argument in args)})", ATOM
        if binds == NOT:
            return f"not {self._at(args[0], NOT)}", NOT
        if binds == POWER:
            return self._power(args), POWER
        # left-associative: only the left operand may have the same precedence
        first = binds + (binds in (OR, AND, COMPARISON))
        parts = [self._at(args[0], first), *(self._at(part, binds + 1) for part in args[1:])]
        return f" {name} ".join(parts), binds

    def _power(self, args: Sequence[Any]) -> str:
        """Powers are right-associative, and a sign on the left has lower precedence."""
        left, right = self._at(args[0], ATOM), self._at(args[1], SIGN)
        simple = _SIMPLE.fullmatch(left) and _SIMPLE.fullmatch(right)
        return f"{left}**{right}" if simple else f"{left} ** {right}"
