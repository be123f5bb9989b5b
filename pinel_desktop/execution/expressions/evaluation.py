"""Evaluation of expressions while a program runs.

An expression is compiled once per run. A short expression without calls becomes one function, which computes the
value at once. Function calls may contain motion, and an expression may be a megabyte long: such expressions become
generators, which yield `Invoke` and `Preempt`. Evaluated parts are counted in `n_evaluated` and are work like
commands.
"""

from collections.abc import Callable, Generator, Mapping, Sequence
from typing import Any, NamedTuple

from pinel_desktop.execution.expressions.operators import Compute, comparison, computations
from pinel_desktop.execution.expressions.parameters import Bounds
from pinel_desktop.execution.expressions.requests import (
    Evaluation,
    EvaluationContext,
    Invoke,
    Preempt,
)
from pinel_desktop.execution.expressions.sensing import cost, reader
from pinel_desktop.execution.expressions.values import Value, literal
from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.program.expressions import (
    READINGS,
    FunctionCall,
    GestureResult,
    NumberShown,
    Operation,
    SensorReading,
    Variable,
)
from pinel_desktop.program.sensors import SENSORS

Simple = Callable[[], Value]

# takes less than a millisecond, except with texts of thousands of letters
_MAX_PARTS_AT_ONCE = 500
_JOINED = ("and", "or")
_COMPARISONS = ("==", "!=", "<", "<=", ">", ">=")
# expression parts that take about as long as copying a list
_MAYBE_LISTS = 10  # their length is unknown at compile time
_ITEM_WORK = {"==": 0.25, "!=": 0.25, "contains": 1.0, "position_of": 1.0, "join": 4.0}
_SEARCHES = ("contains", "position_of")


class Compiled(NamedTuple):
    """A compiled expression.

    Attributes:
        weight: number of its parts, a measure of work.
        simple: computes the value at once; None where that is not possible.
        steps: evaluates in steps; used where `simple` is None.
    """

    weight: int
    simple: Simple | None
    steps: Callable[[], Evaluation] | None = None


class Evaluator:
    """Compiles and evaluates the expressions of one run."""

    def __init__(self, context: EvaluationContext) -> None:
        self._context = context
        self._compute = computations(context.random)
        self._last_preempted = 0
        # keyed by identity: the document is frozen and outlives the run
        self._compiled: dict[int, Compiled] = {}
        self._compilers: dict[type, Callable[[Any], Compiled]] = {
            Operation: self._operation,
            Variable: self._variable,
            GestureResult: lambda _: Compiled(1, lambda: self._context.gesture_result),
            NumberShown: lambda _: Compiled(1, lambda: float(self._context.number_shown)),
            FunctionCall: self._call,
            **dict.fromkeys(READINGS.values(), self._sensor),
        }

    def compiled(self, expression: Any) -> Compiled:
        """The compiled form of an expression of the program."""
        compiler = self._compilers.get(expression.__class__)
        if compiler is None:
            return self._literal(expression)
        found = self._compiled.get(id(expression))
        if found is None:
            found = self._compiled[id(expression)] = compiler(expression)
        return found

    def value(self, expression: Any) -> Evaluation:
        """Evaluates an expression: `value = yield from evaluator.value(expression)`. Raises RunFailureError."""
        return self.evaluated(self.compiled(expression))

    def truth(self, condition: Any) -> Evaluation:
        """Evaluates a condition. Raises RunFailureError, also `condition_not_boolean`."""
        value = yield from self.evaluated(self.compiled(condition))
        if not isinstance(value, bool):
            raise RunFailureError("condition_not_boolean")
        return value

    def arguments(
        self, arguments: Mapping[str, Any]
    ) -> Generator[Invoke | Preempt, Value | None, dict[str, Value]]:
        """Evaluates the arguments of a call, in order."""
        values: dict[str, Value] = {}
        for name, argument in arguments.items():
            values[name] = self._own((yield from self.evaluated(self.compiled(argument))))
        return values

    def evaluated(self, part: Compiled) -> Evaluation:
        """Evaluates a compiled expression; preempts after much work."""
        if part.steps is not None:
            return (yield from part.steps())
        assert part.simple is not None
        value = part.simple()
        context = self._context
        context.n_evaluated += part.weight
        if context.n_evaluated > self._last_preempted + _MAX_PARTS_AT_ONCE:
            self._last_preempted = context.n_evaluated
            yield Preempt.YIELD
        return value

    def _own(self, value: Value) -> Value:
        """A copy of a list, so that no later `append` changes it; other values as they are."""
        if isinstance(value, list):
            self._context.n_evaluated += len(value) // 2
            return value.copy()
        return value

    def _literal(self, expression: Any) -> Compiled:
        value = literal(expression)
        return Compiled(1, lambda: value)

    def _variable(self, node: Variable) -> Compiled:
        variables, name = self._context.variables, node.var
        return Compiled(1, lambda: variables.get(name))

    def _operation(self, node: Operation) -> Compiled:
        compute, weight = self._computation(node)
        if _is_long(node):
            return Compiled(weight, None, self._in_steps(node.op, compute, node.args))
        args = [self.compiled(arg) for arg in node.args]
        weight += sum(arg.weight for arg in args)
        simple = [arg.simple for arg in args if arg.simple is not None]
        if len(simple) < len(args) or weight > _MAX_PARTS_AT_ONCE:
            return Compiled(weight, None, self._in_steps(node.op, compute, node.args))
        joined = _joined(node.op, simple) if node.op in _JOINED else _applied(compute, simple)
        return Compiled(weight, joined)

    def _computation(self, node: Operation) -> tuple[Compute, int]:
        """The function of an operation on its arguments' values, and its own weight."""
        op = node.op
        if op in _COMPARISONS:
            of_gesture = any(isinstance(arg, GestureResult) for arg in node.args)
            compute = comparison(op, of_gesture=of_gesture)
        else:
            compute = self._compute.get(op, _nothing)
        if op in ("join", *_SEARCHES) or (op in _ITEM_WORK and not any(map(_is_plain, node.args))):
            return self._counted(compute, _ITEM_WORK[op]), 1 + _MAYBE_LISTS
        return compute, 1

    def _counted(self, compute: Compute, work: float) -> Compute:
        """Wraps a function: list items count as work."""

        def counted(*values: Value) -> Value:
            for value in values:
                if value.__class__ is list:
                    self._context.n_evaluated += int(len(value) * work)
            return compute(*values)

        return counted

    def _in_steps(self, op: str, compute: Compute, args: Sequence[Any]) -> Callable[[], Evaluation]:
        """Evaluation in steps; arguments are compiled when reached, as compiling is work too."""

        def steps() -> Evaluation:
            values: list[Value] = []
            for arg in args:
                values.append(self._own((yield from self.value(arg))))
            return compute(*values)

        def short_circuit() -> Evaluation:
            ends_it = op == "or"
            for arg in args:
                if _boolean(op, (yield from self.value(arg))) is ends_it:
                    return ends_it
            return not ends_it

        return short_circuit if op in _JOINED else steps

    def _sensor(self, node: SensorReading) -> Compiled:
        name = node.sensor
        read, argument = reader(self._context, name), SENSORS[name].argument
        if argument is None:
            return Compiled(cost(self._context, name, None), read)
        asked = getattr(node, argument.name)
        weight = cost(self._context, name, asked)
        if argument.choices:
            return Compiled(weight, lambda: read(asked))
        bounds, laser = Bounds.of(name, argument.name), self._context.robot.laser
        if name == "lidar" and laser:
            bounds = bounds.narrowed(laser.field_deg / 2)
        return self._measured(lambda value: read(bounds.checked(value)), asked, weight)

    def _measured(self, measure: Compute, asked: Any, cost_of_reading: int) -> Compiled:
        """Reading of a sensor with a numeric argument."""
        weight, simple, _ = self.compiled(asked)
        weight += cost_of_reading
        if simple is None:
            return Compiled(weight, None, self._in_steps("", measure, [asked]))
        return Compiled(weight, _applied(measure, [simple]))

    def _call(self, node: FunctionCall) -> Compiled:
        def steps() -> Evaluation:
            values = yield from self.arguments(node.arguments)
            result = yield Invoke(node.call, values)
            if result is None:
                raise RunFailureError("function_gave_nothing", function=node.call)
            return result

        return Compiled(1, None, steps)


def _is_long(node: Operation) -> bool:
    """Whether an operation has so many parts that compiling it takes noticeable time; stops counting at the limit."""
    count, waiting = 0, [node]
    while waiting and count <= _MAX_PARTS_AT_ONCE:
        args = waiting.pop().args
        count += len(args)
        waiting += [arg for arg in args if isinstance(arg, Operation)]
    return count > _MAX_PARTS_AT_ONCE


def _is_plain(expression: Any) -> bool:
    """Whether an expression is a literal that is quick to compare."""
    return expression.__class__ in (bool, float, str)


def _nothing(*_values: Value) -> Value:
    """Placeholder: `and` and `or` evaluate their arguments one by one."""
    raise NotImplementedError


def _applied(compute: Compute, args: list[Simple]) -> Simple:
    if len(args) == 1:
        (only,) = args
        return lambda: compute(only())
    if len(args) == 2:
        left, right = args
        return lambda: compute(left(), right())
    return lambda: compute(*[arg() for arg in args])


def _joined(op: str, args: list[Simple]) -> Simple:
    ends_it = op == "or"

    def joined() -> Value:
        for arg in args:
            if _boolean(op, arg()) is ends_it:
                return ends_it
        return not ends_it

    return joined


def _boolean(op: str, value: Value) -> bool:
    if not isinstance(value, bool):
        raise RunFailureError("not_boolean", operator=op)
    return value
