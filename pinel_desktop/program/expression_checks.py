"""Static checks of expressions: types, as far as they are known before the run, and calls."""

from typing import Any

from pinel_desktop.program.conditions import ConditionError, parse_condition
from pinel_desktop.program.functions import Signature
from pinel_desktop.program.operators import EQUALITY, OPERATORS, ORDER, Operator, ValueType
from pinel_desktop.program.pointers import MAX_PATH, Path, PathFault
from pinel_desktop.program.sensors import SENSORS

Type = ValueType | None  # None: known only in the run

_LITERALS: dict[type, ValueType] = {
    bool: "boolean",
    int: "number",
    float: "number",
    str: "text",
    list: "list",
}
_OPERANDS = {"number": "not_number", "boolean": "not_boolean", "list": "not_list"}


class ExpressionChecker:
    """Checks the expressions of one document. Adds findings to `found`, and names of variables to `variables`.

    Attributes:
        warnings: findings about valid expressions that are hardly intended.
        deepest: length of the longest path to an expression.
        n_keys: number of keys in the objects visited.
        parameters: parameters of the enclosing function, which are not variables.
    """

    def __init__(
        self, signatures: dict[str, Signature], variables: set[str], faults: list[PathFault]
    ) -> None:
        self._signatures, self._variables, self._faults = signatures, variables, faults
        self.warnings: list[PathFault] = []
        self.deepest = self.n_keys = 0
        self.parameters: tuple[str, ...] = ()

    def check(self, value: Any, path: Path, expected: Type) -> None:
        """Checks an expression against the type of its parameter. Literals are checked by the models."""
        if expected == "boolean":
            self._condition(value, path)
            return
        found = self._type(value, path)
        if expected is not None and found is not None and found != expected:
            self._add(f"wrong_type_{expected}", path, name=str(path[-1]))

    def is_obviously_valid(self, value: dict[str, Any], expected: Type) -> bool:
        """Fast path for most expressions: True for a well-typed operation on literals and variables.

        Records the variables. For all other expressions it returns False, and `check` must decide.
        """
        name, args = value.get("op"), value.get("args")
        if name.__class__ is not str or args.__class__ is not list:
            return False
        operator = OPERATORS.get(name)
        if (
            operator is None
            or operator.common_type is None
            or expected not in (None, operator.gives)
        ):
            return False
        count, common_type = len(args), operator.common_type
        if count < operator.n_min or (operator.n_max is not None and count > operator.n_max):
            return False
        n_keys = len(value)
        for argument in args:
            if argument.__class__ is dict:
                n_keys += len(argument)
                variable = argument.get("var")
                if variable.__class__ is not str or "op" in argument:
                    return False
                if variable not in self.parameters:
                    self._variables.add(variable)
            elif _LITERALS.get(argument.__class__) != common_type:
                return False
        self.n_keys += n_keys
        return True

    def name(self, value: Any) -> None:
        """Records the name of a variable."""
        if isinstance(value, str) and value not in self.parameters:
            self._variables.add(value)

    def call(self, function: Any, arguments: Any, path: Path, key: str) -> Signature | None:
        """Checks a call with its arguments; returns the signature of the function, None if it is unknown."""
        given = arguments if isinstance(arguments, dict) else {}
        self.n_keys += len(given)
        for name, argument in given.items():
            self._type(argument, (*path, "arguments", name))
        if not isinstance(function, str):
            return None
        signature = self._signatures.get(function)
        if signature is None:
            known = sorted(self._signatures)
            self._add("unknown_function", (*path, key), value=function, allowed=known)
            return None
        for name in signature.parameters:
            if name not in given:
                self._add("missing_argument", path, function=function, name=name)
        for name in given:
            if name not in signature.parameters:
                place = (*path, "arguments", name)
                self._add("unknown_argument", place, function=function, name=name)
        return signature

    def _add(self, code: str, path: Path, **params: object) -> None:
        self._faults.append((code, path, params))

    def _condition(self, value: Any, path: Path) -> None:
        if isinstance(value, str):
            try:
                tree = parse_condition(value)
            except ConditionError:
                return  # reported by the models
            inside: list[PathFault] = []
            found = ExpressionChecker(self._signatures, self._variables, inside)._type(tree, ())
            self._faults += [(code, path, params) for code, _, params in inside]
        else:
            found = self._type(value, path)
        if found not in (None, "boolean"):
            self._add("condition_not_boolean", path)

    def _type(self, value: Any, path: Path) -> Type:
        if value.__class__ is not dict:
            return _LITERALS.get(type(value))
        self.deepest = max(self.deepest, len(path))
        if len(path) > MAX_PATH:
            return None
        self.n_keys += len(value)
        if "op" in value:
            return self._operation(value, path)
        if "var" in value:
            self.name(value["var"])
            return None
        if "gesture" in value:
            return "number" if value["gesture"] == "number" else "text"
        if "call" in value:
            signature = self.call(value["call"], value.get("arguments"), path, "call")
            if signature is not None and not signature.gives_value:
                self._add("function_without_value", (*path, "call"), value=value["call"])
            return None
        return self._sensor(value, path)

    def _sensor(self, value: dict[str, Any], path: Path) -> Type:
        name = value.get("sensor")
        sensor = SENSORS.get(name) if isinstance(name, str) else None
        if sensor is None:
            return None
        if sensor.argument is not None and isinstance(value.get(sensor.argument.name), dict):
            key = sensor.argument.name
            self.check(value[key], (*path, key), "number")
        return sensor.gives

    def _operation(self, value: dict[str, Any], path: Path) -> Type:
        name, args = value["op"], value.get("args")
        if not isinstance(name, str) or not isinstance(args, list):
            return None
        types = [
            self._type(argument, (*path, "args", i))
            if argument.__class__ is dict
            else _LITERALS.get(argument.__class__)
            for i, argument in enumerate(args)
        ]
        operator = OPERATORS.get(name)
        if operator is None:
            self._add("unknown_operator", path, value=name, allowed=list(OPERATORS))
            return None
        if operator.fits(types):
            return operator.gives  # the usual case
        if not operator.accepts(len(args)):
            code = "wrong_argument_count" if operator.n_max is not None else "too_few_arguments"
            self._add(code, path, operator=name, value=len(args), min=operator.n_min)
        else:
            self._operands(name, operator, types, path)
            if operator is EQUALITY:
                self._equality(args, path)
        return operator.gives

    def _operands(self, name: str, operator: Operator, types: list[Type], path: Path) -> None:
        """Reports the first argument of a wrong type."""
        for i, found in enumerate(types):
            if found is None:
                continue
            expected = operator.type_at(i)
            if expected is not None and found != expected:
                self._add(_OPERANDS[expected], path, operator=name)
                return
        if operator is ORDER and not _comparable(types):
            self._add("not_comparable", path, operator=name)
        elif name == "length" and types[0] in ("number", "boolean"):
            self._add("not_text_or_list", path, operator=name)

    def _equality(self, args: list[Any], path: Path) -> None:
        """Warns of a comparison of a sensor with a text that the sensor never gives."""
        for i, (value, other) in enumerate((args, args[::-1])):
            name = other.get("sensor") if isinstance(other, dict) else None
            sensor = SENSORS.get(name) if isinstance(name, str) else None
            if sensor is None or not sensor.texts or not isinstance(value, str):
                continue
            if value not in sensor.texts:
                self.warnings.append((f"never_{name}", (*path, "args", i), {"value": value}))


def _comparable(types: list[Type]) -> bool:
    left, right = types
    if "boolean" in types or "list" in types:
        return False
    return left is None or right is None or left == right
