"""Every expression that the fast path accepts passes the full check too, and both record the same variables."""

from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from pinel_desktop.program.expression_checks import ExpressionChecker
from pinel_desktop.program.operators import OPERATORS
from pinel_desktop.program.pointers import PathFault

LITERALS = st.one_of(st.integers(-9, 9), st.floats(-9, 9), st.booleans(), st.text(max_size=3))
LEAVES = st.one_of(
    LITERALS,
    st.lists(LITERALS, max_size=3),
    st.none(),
    st.builds(lambda name: {"var": name}, st.one_of(st.sampled_from(["a", "p"]), st.integers())),
    st.just({"sensor": "x"}),
    st.just({"gesture": "result"}),
)
OPERATIONS = st.recursive(
    LEAVES,
    lambda inner: st.builds(
        lambda op, args: {"op": op, "args": args},
        st.one_of(st.sampled_from(sorted(OPERATORS)), st.just("?"), st.just([])),
        st.one_of(st.lists(inner, max_size=4), st.none()),
    ),
    max_leaves=6,
)


def expressions() -> tuple[ExpressionChecker, set[str], list[PathFault]]:
    variables: set[str] = set()
    found: list[PathFault] = []
    made = ExpressionChecker({}, variables, found)
    made.parameters = ("p",)
    return made, variables, found


@given(OPERATIONS, st.sampled_from([None, "number", "boolean", "text", "list"]))
def test_the_quick_look_passes_nothing_that_the_check_does_not(value: Any, expected: Any) -> None:
    if not isinstance(value, dict):
        return
    quick, recorded, _ = expressions()
    if quick.is_obviously_valid(value, expected):
        whole, variables, found = expressions()
        whole.check(value, ("commands", 0, "x"), expected)
        assert found == []
        assert recorded == variables


def test_it_passes_what_most_programs_hold() -> None:
    quick, recorded, _ = expressions()
    half = {"op": "/", "args": [{"var": "a"}, 2]}
    assert quick.is_obviously_valid(half, "number")
    assert quick.is_obviously_valid(half, None)
    assert not quick.is_obviously_valid(half, "text")
    assert not quick.is_obviously_valid({"op": "/", "args": [{"var": "a"}, "2"]}, "number")
    assert recorded == {"a"}
