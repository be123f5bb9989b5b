"""Random valid programs over the whole language, as document data, and their normal form for comparison."""

import json
from typing import Any

from hypothesis import strategies as st

from pinel_desktop.program.python_text.forms import RESERVED
from pinel_desktop.program.reading import read_document
from tests.strategies import readings

Document = dict[str, Any]

_LETTERS = st.characters(categories=["L", "M", "Nd"], include_characters="_ ")
_UNUSUAL = [
    "minha área",
    "2nd side",
    "a__b",
    "_",
    "_2",
    "x_u5f_y",
    "a_ b",
    "ª",
    "e\u0301",
    "passo 1",
]
NAMES = st.one_of(
    st.sampled_from(["x", "y", "side", "lado", "i"]),
    st.sampled_from(
        [*_UNUSUAL, *sorted(RESERVED), *(f"{reserved}_" for reserved in sorted(RESERVED))]
    ),
    st.text(_LETTERS, min_size=1, max_size=8).filter(lambda name: name == name.strip(" ")),
)
TEXTS = st.text(st.characters(exclude_categories=["Cs"]), max_size=12)
NUMBERS = st.one_of(
    st.integers(-20, 20),
    st.floats(allow_nan=False, allow_infinity=False),
    st.sampled_from([0.1, -0.0, 1e16, 1e-7, 2.5, 1e300, 123456789012]),
)
_BLOCK = st.one_of(st.none(), st.text("abc#?", min_size=1, max_size=4))
_COMMENT = st.one_of(st.none(), TEXTS, st.sampled_from(["one\ntwo", "", "\\x41", " x ", "\\", "#"]))


def _op(name: str, *parts: Any) -> Document:
    return {"op": name, "args": list(parts)}


class Language:
    """Strategies for one program with given functions and parameters."""

    def __init__(self, functions: dict[str, list[str]]) -> None:
        self.functions = functions
        self.numbers = st.deferred(lambda: self._numbers())  # noqa: PLW0108 - hypothesis wants a function
        self.conditions = st.deferred(lambda: self._conditions())  # noqa: PLW0108
        self.values = st.deferred(lambda: self._values())  # noqa: PLW0108
        self.lists = st.lists(st.one_of(NUMBERS, TEXTS, st.booleans()), max_size=4)
        self.variables = NAMES.map(lambda name: {"var": name})
        self._calls = st.one_of([self._call(name, "call") for name in functions] or [st.nothing()])

    def _call(self, name: str, key: str) -> st.SearchStrategy[Document]:
        given = dict.fromkeys(self.functions[name], self.values)
        return st.fixed_dictionaries(
            {key: st.just(name), "arguments": st.fixed_dictionaries(given)}
        )

    def _numbers(self) -> st.SearchStrategy[Any]:
        inner = self.numbers
        two = st.sampled_from(["+", "-", "*", "/", "%", "**", "random_int"])
        one = st.sampled_from(["abs", "round", "sqrt", "sin", "cos", "tan"])
        many = st.sampled_from(["min", "max"])
        return st.one_of(
            NUMBERS,
            self.variables,
            readings("number"),
            readings("number", self.variables),
            st.builds(_op, two, inner, inner),
            st.builds(_op, two, inner, inner),
            st.builds(_op, one, inner),
            st.builds(lambda o, a: _op(o, *a), many, st.lists(inner, min_size=1, max_size=3)),
            st.builds(lambda v: _op("length", v), st.one_of(TEXTS, self.lists, self.variables)),
            st.builds(_op, st.just("item"), st.one_of(self.lists, self.variables), inner),
            st.builds(_op, st.just("position_of"), self.lists, st.one_of(inner, TEXTS)),
        )

    def _conditions(self) -> st.SearchStrategy[Any]:
        inner = self.conditions
        return st.one_of(
            st.booleans(),
            self.variables,
            readings("boolean"),
            st.builds(_op, st.sampled_from(["==", "!="]), self.values, self.values),
            st.builds(_op, st.sampled_from(["<", "<=", ">", ">="]), self.numbers, self.numbers),
            st.builds(_op, st.just("contains"), self.variables, self.values),
            st.builds(lambda c: _op("not", c), inner),
            st.builds(
                lambda o, cs: _op(o, *cs),
                st.sampled_from(["and", "or"]),
                st.lists(inner, min_size=2, max_size=4),
            ),
        )

    def _values(self) -> st.SearchStrategy[Any]:
        return st.one_of(
            self.numbers,
            self.conditions,
            TEXTS,
            self.lists,
            st.just({"gesture": "result"}),
            readings("text"),
            st.lists(self.values, min_size=1, max_size=3).map(lambda parts: _op("join", *parts)),
            self._calls,
        )

    def _or_computed(self, literals: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
        """A number within its bounds, or an expression that is not a literal."""
        return st.one_of(literals, self.numbers.filter(lambda n: isinstance(n, dict)))

    def _command(self, action: str, **parameters: st.SearchStrategy[Any]) -> Any:
        optional = {"block": _BLOCK, "comment": _COMMENT}
        whole = {"action": st.just(action), **parameters, **optional}
        return st.fixed_dictionaries(whole).map(_without_none)

    def simple(self) -> st.SearchStrategy[Document]:
        """Commands without a body that are allowed anywhere."""
        number, texts = self._or_computed, st.one_of(TEXTS, self.variables)
        any_number = st.one_of(NUMBERS, self.numbers.filter(lambda n: isinstance(n, dict)))
        places = number(st.floats(-100, 100))
        seconds = number(st.floats(0.001, 600))
        maybe_seconds = st.one_of(st.none(), seconds)
        colors = st.sampled_from([None, "red", "blue", "black"])
        return st.one_of(
            self._command("move_forward", distance=number(st.floats(0, 100))),
            self._command("move_backward", distance=number(st.integers(0, 100))),
            self._command("turn", angle=number(st.floats(-3600, 3600))),
            self._command("stop"),
            self._command("drive", linear=any_number, angular=any_number),
            self._command("arc", radius=places, angle=number(st.integers(-3600, 3600))),
            self._command("set_speed", linear=number(st.floats(0.01, 2)), angular=st.none()),
            self._command("set_speed", linear=st.none(), angular=number(st.floats(0.01, 2))),
            self._command("set_speed", linear=seconds, angular=seconds),
            self._command("go_to", x=places, y=places, avoid=st.sampled_from([None, True, False])),
            self._command("go_to_place", place=texts, avoid=st.sampled_from([None, True, False])),
            self._command("wait", seconds=seconds),
            self._command("wait_until", condition=self.conditions, timeout=maybe_seconds),
            self._command("pen", down=st.booleans(), color=colors),
            self._command("ask", question=texts, variable=NAMES),
            self._command("mark", symbol=st.one_of(st.sampled_from("XO"), self.variables)),
            self._command("say", text=self.values),
            self._command("beep"),
            self._command("classify_gestures", timeout=maybe_seconds),
            self._command("read_number", timeout=maybe_seconds),
            self._command("set_gesture_result", result=texts),
            self._command("set_variable", name=NAMES, value=self.values),
            self._command("change_variable", name=NAMES, by=any_number),
            self._command("append", list=NAMES, value=self.values),
            self._command(
                "replace_item",
                list=NAMES,
                position=number(st.integers(1, 10_000)),
                value=self.values,
            ),
            *[
                self._call(name, "function").map(lambda call: {"action": "call", **call})
                for name in self.functions
            ],
        )

    def _compound(self, inner: st.SearchStrategy[Any]) -> st.SearchStrategy[Document]:
        jumps = st.sampled_from([{"action": "break"}, {"action": "continue"}])
        bodies = st.lists(inner, max_size=3)
        looped = st.lists(st.one_of(inner, jumps), max_size=3)
        numbers = st.one_of(st.integers(-5, 5), self.numbers.filter(lambda n: isinstance(n, dict)))
        branches = st.lists(
            st.fixed_dictionaries({"condition": self.conditions, "commands": bodies}), max_size=3
        )
        times = self._or_computed(st.integers(0, 100))
        return st.one_of(
            self._command("repeat", times=times, commands=looped),
            self._command("while", condition=self.conditions, commands=looped),
            self._command("until", condition=self.conditions, commands=looped),
            self._command("forever", commands=looped),
            self._command(
                "for",
                variable=NAMES,
                **{"from": numbers, "to": numbers},
                by=st.one_of(st.none(), numbers),
                commands=looped,
            ),
            self._command(
                "conditional_execution",
                condition=self.conditions,
                commands=bodies,
                **{"elif": branches, "else": bodies},
            ),
        )

    def bodies(self, *extra: st.SearchStrategy[Any]) -> st.SearchStrategy[list[Any]]:
        """Lists of commands."""
        leaves = st.one_of(self.simple(), *extra)
        inner: Any = st.deferred(lambda: st.one_of(leaves, leaves, compound))
        compound = self._compound(inner)
        return st.lists(inner, max_size=4)

    def programs(self) -> st.SearchStrategy[Document]:
        """Whole programs. Every function returns a value, so that expressions may call it."""
        value = st.one_of(st.none(), self.values)
        last = self._command("return", value=self.values)
        commands = self.bodies(self._command("return", value=value))
        whole = st.builds(lambda body, end: [*body, end], commands, last)
        functions = [
            st.fixed_dictionaries(
                {
                    "name": st.just(name),
                    "parameters": st.just(parameters),
                    "commands": whole,
                    "comment": _COMMENT,
                }
            ).map(_without_none)
            for name, parameters in self.functions.items()
        ]
        return st.fixed_dictionaries(
            {
                "pinel_ir": st.just(1),
                "name": TEXTS,
                "functions": st.tuples(*functions).map(list),
                "commands": self.bodies(),
            }
        )


def _without_none(command: Document) -> Document:
    return {key: value for key, value in command.items() if value is not None}


_FUNCTIONS: tuple[dict[str, list[str]], ...] = (
    {},
    {"area": ["a", "b"], "stop": []},
    {"if": ["robot"], "minha função": []},
    {"_": ["x", "2nd side", "x_"]},
)


def documents() -> st.SearchStrategy[Document]:
    """Whole programs."""
    return st.one_of([Language(functions).programs() for functions in _FUNCTIONS])


def normal(document: Any) -> Any:
    """Normal form of a document, without block ids and with forms unified that are equal in Python text."""
    read = read_document(document)
    assert read.document is not None, read.faults
    return json.loads(json.dumps(_unified(read.document)))


def _unified(value: Any) -> Any:
    if isinstance(value, list):
        return [_unified(item) for item in value]
    if not isinstance(value, dict):
        return value
    unified = {key: _unified(item) for key, item in value.items() if key != "block"}
    if unified.get("action") == "while":
        condition = unified["condition"]
        if condition is True:
            return {key: item for key, item in unified.items() if key != "condition"} | {
                "action": "forever"
            }
        if isinstance(condition, dict) and condition.get("op") == "not":
            return {**unified, "action": "until", "condition": condition["args"][0]}
    return unified
