"""Commands compiled for execution: the primitive, and the evaluation of its parameters."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import Any

from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.execution.expressions.parameters import bounds_of, checked
from pinel_desktop.execution.expressions.values import Value
from pinel_desktop.execution.inputs import NO_NUMBER
from pinel_desktop.execution.primitives import TABLE, Primitive
from pinel_desktop.execution.requests import Invoke, Preempt, Routine
from pinel_desktop.program.base import Model
from pinel_desktop.program.expressions import NumberShown

Values = tuple[Value | None, ...]


@dataclass(frozen=True, slots=True)
class CompiledCommand:
    """A command ready for execution; compiled when first executed.

    Attributes:
        primitive: the implementation.
        values: computes all parameter values at once; None where that is not possible.
        in_steps: evaluates the parameters in steps and then runs the command; used where `values` is None.
    """

    primitive: Primitive
    values: Callable[[], Values] | None
    in_steps: Callable[[], Routine] | None = None


class _Parameter:
    """One parameter of one command; an omitted parameter is None in `command`."""

    def __init__(self, command: Any, name: str, context: RunContext) -> None:
        expression = getattr(command, name)
        self._bounds = bounds_of(command, name)
        self._evaluator = context.evaluator
        self._compiled = None if expression is None else self._evaluator.compiled(expression)
        self._is_number_shown = isinstance(expression, NumberShown)
        self.is_constant = not isinstance(expression, Model)
        self.weight = self._compiled.weight if self._compiled else 0

    @property
    def is_simple(self) -> bool:
        return self._compiled is None or self._compiled.simple is not None

    def value(self) -> Value | None:
        """The value of a simple parameter. Raises RunFailureError."""
        if self._compiled is None or self._compiled.simple is None:
            return None
        value = self._compiled.simple()
        try:
            return checked(self._bounds, value)
        except RunFailureError as failure:
            if self._is_number_shown and value == NO_NUMBER:
                # names the cause: "-1 is out of range" would not tell a pupil where the -1 comes from
                raise RunFailureError("no_number_shown") from failure
            raise

    def in_steps(self) -> Generator[Invoke | Preempt, Value | None, Value | None]:
        if self._compiled is None:
            return None
        return checked(self._bounds, (yield from self._evaluator.evaluated(self._compiled)))


def compile_command(command: Any, context: RunContext) -> CompiledCommand:
    """The compiled form of a command of the program."""
    primitive = TABLE[command.action]
    parameters = [_Parameter(command, name, context) for name in primitive.parameters]
    if all(parameter.is_constant for parameter in parameters):
        constant = tuple([parameter.value() for parameter in parameters])
        return CompiledCommand(primitive, lambda: constant)
    if all(parameter.is_simple for parameter in parameters):
        return CompiledCommand(primitive, _at_once(parameters, context))
    return CompiledCommand(primitive, None, _in_steps(primitive, command, parameters, context))


def _at_once(parameters: list[_Parameter], context: RunContext) -> Callable[[], Values]:
    weight = sum([parameter.weight for parameter in parameters])

    def values() -> Values:
        context.n_evaluated += weight
        return tuple([parameter.value() for parameter in parameters])

    return values


def _in_steps(
    primitive: Primitive, command: Any, parameters: list[_Parameter], context: RunContext
) -> Callable[[], Routine]:
    def in_steps() -> Routine:
        values: list[Value | None] = []
        for parameter in parameters:
            values.append((yield from parameter.in_steps()))
        if primitive.instant is not None:
            return primitive.instant(context, command, *values)
        assert primitive.routine is not None
        return (yield from primitive.routine(context, command, *values))

    return in_steps
