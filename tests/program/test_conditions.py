import pytest
from hypothesis import given
from hypothesis import strategies as st

from pinel_desktop.program.conditions import ConditionError, parse_condition
from pinel_desktop.program.limits import MAX_TEXT

RESULT = {"gesture": "result"}


def equals(value: object) -> dict[str, object]:
    return {"op": "==", "args": [RESULT, value]}


@pytest.mark.parametrize(
    ("text", "tree"),
    [
        ('result == "B"', equals("B")),
        ("resultado=='B'", equals("B")),
        ("'A' != result", {"op": "!=", "args": ["A", RESULT]}),
        ("1 <= 2.5", {"op": "<=", "args": [1.0, 2.5]}),
        ("-1 < .5", {"op": "<", "args": [-1.0, 0.5]}),
        ("not result == 'A'", {"op": "not", "args": [equals("A")]}),
        ("!(result == 'A')", {"op": "not", "args": [equals("A")]}),
        (
            "result == 'A' or result == 'B' and result == 'C'",
            {"op": "or", "args": [equals("A"), {"op": "and", "args": [equals("B"), equals("C")]}]},
        ),
        (
            "(result == 'A' || result == 'B') && result == 'C'",
            {"op": "and", "args": [{"op": "or", "args": [equals("A"), equals("B")]}, equals("C")]},
        ),
        ("result == 'it is \"B\"'", equals('it is "B"')),
        ("result == 'ção'", equals("ção")),
    ],
)
def test_conditions_of_the_original_become_trees(text: str, tree: object) -> None:
    assert parse_condition(text) == tree


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("__import__('os')", 1),
        ("result.__class__ == 'B'", 1),
        ("result = 'B'", 8),
        ("result == 'A' == 'B'", 15),
        ("result == B", 11),
        ("result == 'B", 11),
        ("result == 'B''", 14),
        ("result == “B”", 11),
        ("réult == 'B'", 1),
        ("result == 'B';", 14),
        ("result == 1e5", 11),
        ("result == lambda", 11),
        ("", 1),
        ("(result == 'B'", 15),
        ("result == 'B')", 14),
        ("and", 1),
        ("result\n== 'B'", 7),
        ("１ == 1", 1),
    ],
)
def test_anything_else_is_an_error_that_names_the_place(text: str, position: int) -> None:
    with pytest.raises(ConditionError) as caught:
        parse_condition(text)
    assert caught.value.position == position


def test_endless_parentheses_and_texts_are_errors_not_crashes() -> None:
    for text in (
        "(" * 9000,
        "not " * 2000 + "1 == 1",
        "1" * (MAX_TEXT + 1),
        "'" + "a" * 10**6 + "'",
    ):
        with pytest.raises(ConditionError):
            parse_condition(text)


@given(st.text(max_size=60))
def test_no_text_raises_anything_but_a_condition_error(text: str) -> None:
    position = 1
    try:
        parse_condition(text)
    except ConditionError as error:
        position = error.position
    assert 1 <= position <= len(text) + 1
