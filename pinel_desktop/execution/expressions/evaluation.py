"""The values of expressions while a program runs.

An expression is compiled once a run. Short ones without calls become one function, which computes the value at once.
Calls may contain motion, and an expression may be a megabyte long: those become generators, which ask the stack to
run a function, or yield `Preempt`. What was evaluated is counted in `n_evaluated` and is work like commands.
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
    Operation,
    Reading,
    Variable,
)
from pinel_desktop.program.sensors import SENSORS

Simple = Callable[[], Value]

_LONGEST_AT_ONCE = (
    500  # parts; takes less than a millisecond for all but texts of thousands of letters
)
_JOINED = ("and", "or")
_COMPARISONS = ("==", "!=", "<", "<=", ">", ">=")
# parts of an expression that take about as long as a list
_MAYBE_LISTS = 10  # nobody knows beforehand how long they are
_ITEM_WORK = {"==": 0.25, "!=": 0.25, "join": 4.0}


class Compiled(NamedTuple):
    """An expression ready to be evaluated.

    Attributes:
        weight: how many parts it has, which is how much work it is.
        simple: computes the value at once; None where that is not possible.
        steps: computes it with whatever it has to ask for, where `simple` is None.
    """

    weight: int
    simple: Simple | None
    steps: Callable[[], Evaluation] | None = None


class Evaluator:
    """Compiles the expressions of one run, each once."""

    def __init__(self, context: EvaluationContext) -> None:
        self._context = context
        self._compute = computations(context.random)
        self._last_preempted = 0
        # by identity: the document is there as long as the run, and is frozen
        self._compiled: dict[int, Compiled] = {}
        self._compilers: dict[type, Callable[[Any], Compiled]] = {
            Operation: self._operation,
            Variable: self._variable,
            GestureResult: lambda _: Compiled(1, lambda: self._context.gesture_result),
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
        """Evaluates the arguments of a call, in their order."""
        values: dict[str, Value] = {}
        for name, argument in arguments.items():
            values[name] = self._own((yield from self.evaluated(self.compiled(argument))))
        return values

    def evaluated(self, part: Compiled) -> Evaluation:
        """Evaluates a compiled expression, and preempts after much work."""
        if part.steps is not None:
            return (yield from part.steps())
        assert part.simple is not None
        value = part.simple()
        context = self._context
        context.n_evaluated += part.weight
        if context.n_evaluated > self._last_preempted + _LONGEST_AT_ONCE:
            self._last_preempted = context.n_evaluated
            yield Preempt.TAKEN
        return value

    def _own(self, value: Value) -> Value:
        """A value that no later `append` changes."""
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
        if len(simple) < len(args) or weight > _LONGEST_AT_ONCE:
            return Compiled(weight, None, self._in_steps(node.op, compute, node.args))
        joined = _joined(node.op, simple) if node.op in _JOINED else _applied(compute, simple)
        return Compiled(weight, joined)

    def _computation(self, node: Operation) -> tuple[Compute, int]:
        """What an operation computes from the values of its arguments, and how much work that alone is."""
        op = node.op
        if op in _COMPARISONS:
            of_gesture = any(isinstance(arg, GestureResult) for arg in node.args)
            compute = comparison(op, of_gesture=of_gesture)
        else:
            compute = self._compute.get(op, _nothing)
        if op == "join" or (op in _ITEM_WORK and not any(map(_is_plain, node.args))):
            return self._counted(compute, _ITEM_WORK[op]), 1 + _MAYBE_LISTS
        return compute, 1

    def _counted(self, compute: Compute, work: float) -> Compute:
        """The same function, which counts the items of lists as work."""

        def counted(*values: Value) -> Value:
            for value in values:
                if value.__class__ is list:
                    self._context.n_evaluated += int(len(value) * work)
            return compute(*values)

        return counted

    def _in_steps(self, op: str, compute: Compute, args: Sequence[Any]) -> Callable[[], Evaluation]:
        """The long way; arguments are compiled when they are met, as compiling them is work too."""

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

    def _sensor(self, node: Reading) -> Compiled:
        name = node.sensor
        read, argument = reader(self._context, name), SENSORS[name].argument
        if argument is None:
            return Compiled(cost(self._context, name, None), read)
        asked = getattr(node, argument.name)
        weight = cost(self._context, name, asked)
        if argument.choices:
            return Compiled(weight, lambda: read(asked))
        bounds = Bounds.of(name, argument.name)
        return self._measured(lambda value: read(bounds.checked(value)), asked, weight)

    def _measured(self, measure: Compute, asked: Any, cost_of_reading: int) -> Compiled:
        """What a sensor measures that is asked a number."""
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
    """Whether there is so much in an operation that compiling it takes its time; stops counting there."""
    count, waiting = 0, [node]
    while waiting and count <= _LONGEST_AT_ONCE:
        args = waiting.pop().args
        count += len(args)
        waiting += [arg for arg in args if isinstance(arg, Operation)]
    return count > _LONGEST_AT_ONCE


def _is_plain(expression: Any) -> bool:
    """Whether it is a literal that is quickly compared."""
    return expression.__class__ in (bool, float, str)


def _nothing(*_values: Value) -> Value:
    """What `and` and `or` would compute from values; they take them one by one."""
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
