"""Converts expressions of Python's syntax tree to expressions of a document."""

import ast
import math
from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from itertools import pairwise
from typing import Any

from pinel_desktop.program.limits import MAX_NESTING
from pinel_desktop.program.python_text.diagnostics import Diagnostics, Positioned
from pinel_desktop.program.python_text.forms import (
    CAPTURED,
    COMMANDS,
    EQUIVALENTS,
    FUNCTIONS,
    MEASURES,
    RESERVED,
    SENSOR_CALLS,
    Parameter,
)
from pinel_desktop.program.python_text.names import program_name, python_name

# replaces an expression that cannot be read, so that the rest can be checked
PLACEHOLDER = {"var": "x"}
_MAX_WHOLE = 2**53
_BINARY: dict[type[ast.operator], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.Mod: "%",
    ast.Pow: "**",
}
_COMPARISONS: dict[type[ast.cmpop], str] = {
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
}
_SIGNS: dict[type[ast.AST], str] = {
    ast.FloorDiv: "//",
    ast.MatMult: "@",
    ast.BitAnd: "&",
    ast.BitOr: "|",
    ast.BitXor: "^",
    ast.LShift: "<<",
    ast.RShift: ">>",
    ast.Invert: "~",
    ast.Is: "is",
    ast.IsNot: "is not",
    ast.In: "in",
    ast.NotIn: "not in",
}
_SENSORS = (*SENSOR_CALLS, *MEASURES, *CAPTURED)
_FAULTS: dict[type[ast.expr], str] = {
    ast.JoinedStr: "python_format_text",
    ast.Subscript: "python_index",
    ast.IfExp: "python_choice",
}


class ExpressionReader:
    """Reads expressions; `signatures` has the parameters of the program's functions by name."""

    def __init__(self, diagnostics: Diagnostics, signatures: Mapping[str, Sequence[str]]) -> None:
        self._diagnostics, self._signatures = diagnostics, signatures
        self.depth = 0

    def read(self, node: ast.expr, pointer: str) -> Any:
        """Reads an expression. If it cannot be read, records a fault and returns a placeholder."""
        self._diagnostics.nodes[pointer] = node
        reader = getattr(self, f"_{type(node).__name__}", None)
        if reader is None:
            return self._fault(node, _FAULTS.get(type(node), "python_expression"))
        if self.depth > MAX_NESTING + 2:
            return self._fault(node, "nesting_too_deep", max=MAX_NESTING)
        self.depth += 1
        expression = reader(node, pointer)
        self.depth -= 1
        return expression

    def bind(
        self, call: ast.Call, parameters: Sequence[Parameter], name: str, example: str
    ) -> dict[str, ast.expr] | None:
        """The arguments of a call by parameter; None, with a fault, if they do not match."""
        names = [parameter.name for parameter in parameters]
        bound = dict(zip(names, call.args, strict=False))
        fits = len(call.args) <= len(names)
        for argument in call.keywords:
            given = argument.arg or ""
            fits = fits and given in names and given not in bound
            bound[given] = argument.value
        fits = fits and not any(isinstance(value, ast.Starred) for value in call.args)
        fits = fits and all(p.optional or p.name in bound for p in parameters)
        if fits:
            return bound
        if number := _with_comma(call, len(names)):
            self._diagnostics.fault(call.args[0], "python_decimal_comma", instead=number)
        else:
            self._diagnostics.fault(call, "python_arguments", name=name, example=example)
        return None

    def literal(self, node: ast.expr, parameter: Parameter, pointer: str) -> Any:
        """Reads a literal text, or True or False; None, with a fault, for anything else."""
        self._diagnostics.nodes[pointer] = node
        expected = bool if parameter.literal == "boolean" else str
        if isinstance(node, ast.Constant) and isinstance(node.value, expected):
            return node.value
        self._diagnostics.fault(node, f"python_literal_{parameter.literal}", name=parameter.name)
        return None

    def call_of_function(self, node: ast.Call, pointer: str) -> tuple[str, dict[str, Any]] | None:
        """Name and arguments of a call of a function of the program; None, with a fault, if invalid."""
        assert isinstance(node.func, ast.Name)
        name = program_name(node.func.id)
        parameters = self._signatures.get(name)
        if parameters is None:
            self._unknown_function(node, node.func.id)
            return None
        written = [Parameter(python_name(parameter)) for parameter in parameters]
        example = f"{node.func.id}({', '.join(parameter.name for parameter in written)})"
        bound = self.bind(node, written, node.func.id, example)
        if bound is None:
            return None
        arguments = {
            parameter: self.read(bound[python_name(parameter)], f"{pointer}/arguments/{parameter}")
            for parameter in parameters
        }
        return name, arguments

    def name(self, node: Positioned, name: str) -> str:
        """The program's name for a Python identifier that is assigned."""
        if name in RESERVED:
            self._diagnostics.fault(node, "python_reserved_name", value=name, instead=f"{name}_")
        return program_name(name)

    def unknown_robot(self, node: ast.Attribute, known: Iterable[str]) -> None:
        """Records a fault for an unknown attribute of `robot`, with a suggestion."""
        names = list(known)
        allowed = get_close_matches(node.attr[:64], names, 3) or names
        self._diagnostics.fault(node, "python_unknown_command", value=node.attr, allowed=allowed)

    def _fault(self, node: Positioned, code: str, **params: object) -> Any:
        self._diagnostics.fault(node, code, **params)
        return PLACEHOLDER

    def _unknown_function(self, node: ast.Call, name: str) -> None:
        if name in EQUIVALENTS:
            self._diagnostics.fault(node, "python_instead", value=name, instead=EQUIVALENTS[name])
            return
        known = [*map(python_name, self._signatures), *FUNCTIONS]
        allowed = get_close_matches(name[:64], known, 3) or known
        self._diagnostics.fault(node, "python_unknown_function", value=name, allowed=allowed)

    def _Constant(self, node: ast.Constant, _pointer: str) -> Any:  # noqa: N802 - named as ast names it
        value = node.value
        if isinstance(value, bool | str):
            return value
        if isinstance(value, int | float):
            return self._number(node, value)
        return self._fault(node, "python_value")

    def _number(self, node: ast.expr, value: float) -> Any:
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if math.isinf(number):
            return self._fault(node, "python_number_too_large")
        return value if abs(value) <= _MAX_WHOLE else number

    def _List(self, node: ast.List, pointer: str) -> Any:  # noqa: N802
        items = [self.read(item, f"{pointer}/{i}") for i, item in enumerate(node.elts)]
        for item, read in zip(node.elts, items, strict=True):
            if isinstance(read, dict | list) and read is not PLACEHOLDER:
                return self._fault(item, "python_list_items")
        return [0 if item is PLACEHOLDER else item for item in items]

    def _Name(self, node: ast.Name, _pointer: str) -> Any:  # noqa: N802
        if node.id in RESERVED:
            return self._fault(node, "python_reserved_name", value=node.id, instead=f"{node.id}_")
        return {"var": program_name(node.id)}

    def _UnaryOp(self, node: ast.UnaryOp, pointer: str) -> Any:  # noqa: N802
        if isinstance(node.op, ast.Not):
            return {"op": "not", "args": [self.read(node.operand, f"{pointer}/args/0")]}
        if isinstance(node.op, ast.Invert):
            return self._operator(node, node.op)
        value = self.read(node.operand, f"{pointer}/args/1")
        if isinstance(node.op, ast.UAdd):
            return value
        if isinstance(value, int | float) and not isinstance(value, bool):
            return -value
        return {"op": "-", "args": [0, value]}

    def _BinOp(self, node: ast.BinOp, pointer: str) -> Any:  # noqa: N802
        operator = _BINARY.get(type(node.op))
        if operator is None:
            return self._operator(node, node.op)
        return self._operation(operator, [node.left, node.right], pointer)

    def _BoolOp(self, node: ast.BoolOp, pointer: str) -> Any:  # noqa: N802
        return self._operation(
            "and" if isinstance(node.op, ast.And) else "or", node.values, pointer
        )

    def _Compare(self, node: ast.Compare, pointer: str) -> Any:  # noqa: N802
        if len(node.ops) > 1:
            return self._fault(node, "python_chained_comparison")
        operator = _COMPARISONS.get(type(node.ops[0]))
        if operator is None:
            return self._operator(node, node.ops[0])
        return self._operation(operator, [node.left, node.comparators[0]], pointer)

    def _operation(self, operator: str, args: Sequence[ast.expr], pointer: str) -> Any:
        values = [self.read(arg, f"{pointer}/args/{i}") for i, arg in enumerate(args)]
        return {"op": operator, "args": values}

    def _operator(self, node: ast.expr, operator: ast.AST) -> Any:
        return self._fault(node, "python_operator", value=_SIGNS[type(operator)])

    def _Attribute(self, node: ast.Attribute, _pointer: str) -> Any:  # noqa: N802
        if not is_robot(node.value):
            return self._fault(node, "python_attribute", value=node.attr)
        if node.attr in CAPTURED:
            return {"gesture": CAPTURED[node.attr]}
        if node.attr in MEASURES:
            return {"sensor": node.attr}
        if node.attr in SENSOR_CALLS:
            example = SENSOR_CALLS[node.attr].example
            return self._fault(node, "python_arguments", name=f"robot.{node.attr}", example=example)
        return self._no_sensor(node)

    def _Call(self, node: ast.Call, pointer: str) -> Any:  # noqa: N802
        function = node.func
        if isinstance(function, ast.Attribute) and is_robot(function.value):
            return self._sensor(node, function, pointer)
        if not isinstance(function, ast.Name):
            return self._foreign_call(node)
        if function.id in FUNCTIONS:
            return self._function(node, function.id, pointer)
        call = self.call_of_function(node, pointer)
        return PLACEHOLDER if call is None else {"call": call[0], "arguments": call[1]}

    def _foreign_call(self, node: ast.Call) -> Any:
        """A call of another object's method, such as `random.randint(1, 6)` or `words.append(1)`, as a value."""
        attribute = node.func
        if isinstance(attribute, ast.Attribute) and attribute.attr in EQUIVALENTS:
            instead = EQUIVALENTS[attribute.attr]
            return self._fault(node, "python_instead", value=attribute.attr, instead=instead)
        if isinstance(attribute, ast.Attribute):
            return self._fault(node, "python_attribute", value=attribute.attr)
        return self._fault(node, "python_expression")

    def _function(self, node: ast.Call, name: str, pointer: str) -> Any:
        if node.keywords or any(isinstance(argument, ast.Starred) for argument in node.args):
            example = f"{name}({', '.join('abcdefgh'[: max(1, min(len(node.args), 8))])})"
            return self._fault(node, "python_arguments", name=name, example=example)
        return self._operation(name, node.args, pointer)

    def _sensor(self, node: ast.Call, function: ast.Attribute, pointer: str) -> Any:
        name = function.attr
        if name in MEASURES or name in CAPTURED:
            return self._fault(node, "python_no_parentheses", value=name)
        form = SENSOR_CALLS.get(name)
        if form is None:
            return self._no_sensor(function)
        bound = self.bind(node, form.parameters, f"robot.{name}", form.example)
        if bound is None:
            return PLACEHOLDER
        parameter = form.parameters[0]
        argument, place = bound[parameter.name], f"{pointer}/{parameter.name}"
        if parameter.literal is None:
            return {"sensor": name, parameter.name: self.read(argument, place)}
        value = self.literal(argument, parameter, place)
        return PLACEHOLDER if value is None else {"sensor": name, parameter.name: value}

    def _no_sensor(self, node: ast.Attribute) -> Any:
        if node.attr == "ask":
            return self._fault(node, "python_ask")
        if node.attr in COMMANDS:
            return self._fault(node, "python_command_as_value", value=node.attr)
        self.unknown_robot(node, _SENSORS)
        return PLACEHOLDER


def is_robot(node: ast.expr) -> bool:
    """True if a node is the name `robot`."""
    return isinstance(node, ast.Name) and node.id == "robot"


def is_call_of_robot(node: ast.expr) -> bool:
    """True if a node is `robot.NAME(...)`."""
    return isinstance(node, ast.Call) and (
        isinstance(node.func, ast.Attribute) and is_robot(node.func.value)
    )


def _with_comma(call: ast.Call, n_parameters: int) -> str | None:
    """The number probably meant by `1,5`, if the call has exactly one argument too many."""
    if len(call.args) != n_parameters + 1 or call.keywords:
        return None
    for whole, part in pairwise(call.args):
        if _is_whole_number(part) and _is_whole_number(getattr(whole, "operand", whole)):
            return f"{ast.unparse(whole)}.{ast.unparse(part)}"
    return None


def _is_whole_number(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and type(node.value) is int and node.value < _MAX_WHOLE
