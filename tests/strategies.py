"""Random valid programs over the whole language, as document data, to be executed.

Distances are short and loops end, so that a run takes seconds of robot time. Variables mostly have the type that their
names say, so that most runs get far; some fail.
"""

from functools import cache
from typing import Any

from hypothesis import strategies as st

from pinel_desktop.program.sensors import SENSORS, Sensor

Document = dict[str, Any]
Strategy = st.SearchStrategy[Any]

_TURNS = "turns"  # counts the iterations of loops that might not end
_MAX_ITERATIONS = 12
NUMBERS = st.one_of(
    st.integers(-3, 3), st.floats(-2, 2), st.sampled_from([0, 0.5, -1, 90, 1e300, 1e-9])
)
TEXTS = st.sampled_from(["", "A", "b", "olá", "3", "\u00e9\u0301", "x" * 300])
LETTERS = st.sampled_from(["A", "B", "b", ""])
LISTS = st.lists(st.one_of(NUMBERS, TEXTS, st.booleans()), max_size=4)
NUMBER_NAMES = st.sampled_from(["n", "m", "lado maior"])
ANY_NAMES = st.sampled_from(["n", "m", "lado maior", "t", "l", "yes", "unset"])


def _op(name: str, *args: Any) -> Document:
    return {"op": name, "args": list(args)}


def _computed(number: Any) -> Any:
    """The number as an expression, whose range only a run can check."""
    return number if isinstance(number, dict) else _op("+", number, 0)


def _node(key: str, value: Strategy, **more: Strategy) -> Strategy:
    return st.fixed_dictionaries({key: value, **more})


def readings(gives: str, computed: Strategy | None = None) -> Strategy:
    """Readings of sensors of a value type; numeric arguments are literals, or from `computed` if given."""
    return st.one_of([_reading(one, computed) for one in SENSORS.values() if one.gives == gives])


def _reading(sensor: Sensor, computed: Strategy | None) -> Strategy:
    argument = sensor.argument
    if argument is None:
        return st.just({"sensor": sensor.name})
    if argument.choices:
        asked: Strategy = st.sampled_from(argument.choices)
    elif argument.whole:
        asked = st.integers(int(argument.low), int(argument.high))
    else:
        asked = st.floats(argument.low, argument.high)
    if computed is not None and not argument.choices:
        asked = st.one_of(asked, computed)
    return _node("sensor", st.just(sensor.name), **{argument.name: asked})


class _Language:
    """Strategies for one scope of a program; `functions` (name -> parameters) may be called there."""

    def __init__(self, functions: dict[str, tuple[str, ...]], parameters: tuple[str, ...]) -> None:
        self.functions = functions
        own = [st.sampled_from(parameters)] if parameters else []
        self.names = st.one_of(NUMBER_NAMES, *own)
        calls = [self._call(name, "call") for name in functions]
        self.numbers = st.recursive(
            st.one_of(
                NUMBERS, self.names.map(lambda name: {"var": name}), readings("number"), *calls
            ),
            self._calculations,
            max_leaves=4,
        )
        self.values = st.one_of(
            self.numbers,
            self.texts(),
            self.lists(),
            self.conditions(),
            ANY_NAMES.map(lambda n: {"var": n}),
        )

    def _calculations(self, inner: Strategy) -> Strategy:
        two = st.sampled_from(["+", "-", "*", "/", "%", "**"])
        one = st.sampled_from(["abs", "round", "sqrt", "sin", "cos", "tan"])
        many = st.sampled_from(["min", "max"])
        return st.one_of(
            st.builds(_op, two, inner, inner),
            st.builds(_op, one, inner),
            st.builds(
                lambda op, args: _op(op, *args), many, st.lists(inner, min_size=1, max_size=3)
            ),
            st.builds(_op, st.just("random_int"), st.integers(-5, 5), st.integers(-5, 5)),
            st.builds(_op, st.just("length"), st.one_of(self.texts(), self.lists())),
            st.builds(_op, st.just("item"), self.lists(), st.integers(0, 3)),
            st.builds(_op, st.just("position_of"), self.lists(), st.one_of(NUMBERS, self.texts())),
            readings("number", inner.map(_computed)),
        )

    def texts(self) -> Strategy:
        joined = st.lists(st.one_of(TEXTS, NUMBERS), min_size=1, max_size=3)
        return st.one_of(
            TEXTS,
            joined.map(lambda args: _op("join", *args)),
            st.just({"gesture": "result"}),
            readings("text"),
            st.just({"var": "t"}),
        )

    def lists(self) -> Strategy:
        return st.one_of(LISTS, st.just({"var": "l"}))

    def conditions(self) -> Strategy:
        simple = st.one_of(
            st.booleans(),
            readings("boolean"),
            st.just({"var": "yes"}),
            st.builds(_op, st.sampled_from(["<", "<=", ">", ">="]), self.numbers, self.numbers),
            st.builds(_op, st.sampled_from(["==", "!="]), self.texts(), self.texts()),
            st.builds(_op, st.sampled_from(["==", "!="]), self.numbers, self.texts()),
            st.builds(_op, st.just("contains"), self.lists(), st.one_of(NUMBERS, self.texts())),
        )
        return st.recursive(
            simple,
            lambda inner: st.one_of(
                st.builds(
                    lambda op, args: _op(op, *args),
                    st.sampled_from(["and", "or"]),
                    st.lists(inner, min_size=2, max_size=3),
                ),
                st.builds(_op, st.just("not"), inner),
            ),
            max_leaves=3,
        )

    def _call(self, name: str, key: str) -> Strategy:
        arguments = st.fixed_dictionaries(dict.fromkeys(self.functions[name], NUMBERS))
        return _node(key, st.just(name), arguments=arguments)

    def leaves(self) -> Strategy:
        number = self.numbers
        calls = [
            self._call(name, "function").map(lambda call: {"action": "call", **call})
            for name in self.functions
        ]
        return st.one_of(
            *_motions(number), *_plain_commands(self.texts()), *self._settings(), *calls
        )

    def _settings(self) -> list[Strategy]:
        return [
            _command("set_variable", name=self.names, value=self.numbers),
            _command("set_variable", name=ANY_NAMES, value=self.values),
            _command("change_variable", name=self.names, by=self.numbers),
            _command("append", list=st.just("l"), value=self.values),
            _command(
                "replace_item",
                list=st.just("l"),
                position=st.one_of(st.integers(1, 3), self.numbers.map(_computed)),
                value=self.values,
            ),
            _command("say", text=self.values),
            _command("wait_until", condition=self.conditions(), timeout=st.floats(0.01, 1)),
        ]

    def commands(self, *, in_function: bool = False) -> Strategy:
        """A body: a list of commands."""
        jumps = [_command("return", value=self.values)] if in_function else []
        leaves = st.one_of(self.leaves(), *jumps)
        return st.lists(
            st.recursive(leaves, self._containers, max_leaves=6), min_size=1, max_size=6
        )

    def _containers(self, inner: Strategy) -> Strategy:
        body = st.lists(inner, max_size=3)
        jump = st.sampled_from([[], [{"action": "break"}], [{"action": "continue"}]])
        looped = st.builds(lambda commands, end: commands + end, body, jump)
        guarded = looped.map(lambda commands: [*_guard(), *commands])
        condition = self.conditions()
        branches = st.lists(_node("condition", condition, commands=body), max_size=2)
        return st.one_of(
            _command(
                "repeat",
                times=st.one_of(st.integers(0, 3), self.names.map(lambda n: {"var": n})),
                commands=guarded,
            ),
            _command("while", condition=condition, commands=guarded),
            _command("until", condition=condition, commands=guarded),
            _command("forever", commands=guarded),
            _for(self.numbers, self.names, guarded),
            st.builds(
                lambda first, elif_, else_: {**first, "elif": elif_, "else": else_},
                _command("conditional_execution", condition=condition, commands=body),
                branches,
                body,
            ),
        )


def _guard() -> list[Document]:
    many = _op(">", {"var": _TURNS}, _MAX_ITERATIONS)
    return [
        {"action": "change_variable", "name": _TURNS, "by": 1},
        {"action": "conditional_execution", "condition": many, "commands": [{"action": "break"}]},
    ]


def _command(action: str, **parameters: Strategy) -> Strategy:
    return st.fixed_dictionaries({"action": st.just(action), **parameters})


def _for(number: Strategy, names: Strategy, body: Strategy) -> Strategy:
    loop = _command("for", variable=names, to=number, by=number, commands=body)
    return st.builds(lambda command, start: {**command, "from": start}, loop, number)


def _motions(number: Strategy) -> list[Strategy]:
    metres, computed = st.floats(0, 1), number.map(_computed)
    place = st.floats(-1, 1)
    return [
        _command("move_forward", distance=st.one_of(metres, computed)),
        _command("move_backward", distance=metres),
        _command("turn", angle=st.one_of(st.floats(-400, 400), computed)),
        _command("arc", radius=place, angle=st.floats(-200, 200)),
        _command("go_to", x=place, y=place, avoid=st.sampled_from([False, False, False, True])),
        _command("drive", linear=st.one_of(st.floats(-1, 1), number), angular=st.floats(-90, 90)),
        _command("set_speed", linear=st.floats(0.1, 1.3)),
        _command("set_speed", linear=st.floats(0.1, 1), angular=st.floats(20, 320)),
        st.just({"action": "stop"}),
    ]


def _plain_commands(texts: Strategy) -> list[Strategy]:
    colors = st.sampled_from(["black", "red", "white"])
    return [
        _command("wait", seconds=st.floats(0, 1)),
        _command("pen", down=st.booleans(), color=colors),
        _command("mark", symbol=st.sampled_from(["X", "O", {"var": "t"}, {"sensor": "mark_here"}])),
        _command("go_to_place", place=st.one_of(texts, st.sampled_from(["A", "i"]))),
        st.just({"action": "beep"}),
        _command("ask", question=TEXTS, variable=NUMBER_NAMES),
        _command("classify_gestures", timeout=st.floats(0.01, 1)),
        _command("read_number", timeout=st.floats(0.01, 1)),
        _command("set_gesture_result", result=texts),
    ]


_BEGINNING: list[Document] = [
    {"action": "set_variable", "name": name, "value": value}
    for name, value in {
        _TURNS: 0,
        "n": 2,
        "m": 0.5,
        "lado maior": 1,
        "t": "A",
        "l": [1, "a", True],
        "yes": True,
    }.items()
]
# recursive; the depth depends on the argument
_RECURSIVE: Document = {
    "name": "deep",
    "parameters": ["p"],
    "commands": [
        {
            "action": "conditional_execution",
            "condition": _op("<=", {"var": "p"}, 0),
            "commands": [{"action": "return", "value": 0}],
        },
        {
            "action": "return",
            "value": _op(
                "+", 1, {"call": "deep", "arguments": {"p": _op("-", {"var": "p"}, 0.01)}}
            ),
        },
    ],
}


_FUNCTIONS: list[list[tuple[str, tuple[str, ...]]]] = [
    [],
    [("f", ())],
    [("f", ("p",)), ("área total", ("p", "n"))],
]


@cache  # building strategies takes longer than drawing from them
def _bodies(
    functions: tuple[tuple[str, tuple[str, ...]], ...],
    parameters: tuple[str, ...],
    *,
    in_function: bool,
) -> Strategy:
    return _Language(dict(functions), parameters).commands(in_function=in_function)


@st.composite
def programs(draw: st.DrawFn) -> Document:
    """A valid document whose run ends within a few minutes of robot time."""
    functions = [_RECURSIVE]
    known: dict[str, tuple[str, ...]] = {"deep": ("p",)}
    for name, parameters in draw(st.sampled_from(_FUNCTIONS)):
        body = draw(_bodies(tuple(known.items()), parameters, in_function=True))
        last = {"action": "return", "value": draw(NUMBERS)}
        functions.append({"name": name, "parameters": [*parameters], "commands": [*body, last]})
        known = {**known, name: parameters}
    commands = draw(_bodies(tuple(known.items()), (), in_function=False))
    return {
        "pinel_ir": 1,
        "name": "random",
        "functions": functions,
        "commands": [*_BEGINNING, *commands],
    }
