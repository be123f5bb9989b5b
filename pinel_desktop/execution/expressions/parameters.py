"""Run-time checks of parameters: types and ranges of the document models, codes of the reader's faults."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from pinel_desktop.execution.expressions.values import Value, fold_case, plain
from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.program.expressions import ParameterSpec
from pinel_desktop.program.signatures import PARAMETER_SPECS, range_code

# model attributes whose name in the document differs
_KEYS = {"from_": "from"}


@dataclass(frozen=True, slots=True)
class Bounds:
    """Bounds of a numeric parameter, for values that only a run computes."""

    name: str
    spec: ParameterSpec

    @staticmethod
    @cache
    def of(kind: str, name: str) -> Bounds:
        """The bounds of a parameter of an action or a sensor."""
        return Bounds(name, PARAMETER_SPECS[kind, name])

    def narrowed(self, max_abs: float) -> Bounds:
        """Returns the bounds with the limits -max_abs and max_abs."""
        return Bounds(self.name, replace(self.spec, ge=-max_abs, le=max_abs))

    def checked(self, value: Value) -> float:
        """Returns the value if it is a number within the bounds. Raises RunFailureError."""
        spec = self.spec
        if not isinstance(value, float):
            raise RunFailureError("wrong_type_number", name=self.name)
        if spec.whole and not value.is_integer():
            raise RunFailureError("wrong_type_whole_number", name=self.name)
        if (
            (spec.ge is not None and value < spec.ge)
            or (spec.gt is not None and value <= spec.gt)
            or (spec.le is not None and value > spec.le)
        ):
            low = spec.ge if spec.gt is None else spec.gt
            raise RunFailureError(range_code(self.name, spec), value=value, min=low, max=spec.le)
        return value

    def text(self, value: Value) -> str:
        """Returns the value if it is a text. Raises RunFailureError `wrong_type_text`."""
        if self.spec.choices:
            return self._choice(value)
        if not isinstance(value, str):
            raise RunFailureError("wrong_type_text", name=self.name)
        return value

    def _choice(self, value: Value) -> str:
        """Returns the choice that equals the value; ignores case. Raises RunFailureError, such as `symbol_unknown`."""
        for choice in self.spec.choices:
            if fold_case(value) == fold_case(choice):
                return choice
        raise RunFailureError(f"{self.name}_unknown", value=plain(value))


def checked(bounds: Bounds | None, value: Value) -> Value:
    """Checks the value of a parameter; without bounds any value passes. Raises RunFailureError."""
    if bounds is None:
        return value
    return bounds.text(value) if bounds.spec.type == "text" else bounds.checked(value)


def bounds_of(command: Any, attribute: str) -> Bounds | None:
    """The bounds of a command's parameter; None where any value is allowed."""
    key = _KEYS.get(attribute, attribute)
    return Bounds.of(command.action, key) if (command.action, key) in PARAMETER_SPECS else None
