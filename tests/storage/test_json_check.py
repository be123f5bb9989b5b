"""Deep JSON is judged as Python's parser would judge it, had it room."""

import json
import math
import sys
import threading
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from storage.json_check import is_object, parsed

ANY = st.recursive(
    st.none() | st.booleans() | st.floats(allow_nan=False, allow_infinity=False) | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
)
DEEP = '{"deep":' * 450 + "0" + "}" * 450


def in_column(n_blocks: int) -> str:
    """A workspace with blocks one below the other, as Blockly writes it."""
    block = '{"type":"wait","next":{"block":'
    return '{"blocks":' + block * n_blocks + "null" + "}}" * n_blocks + "}"


@given(st.dictionaries(st.text(), ANY, max_size=4), st.sampled_from([None, 1]))
def test_what_python_writes_is_let_in(value: dict[str, object], indent: int | None) -> None:
    text = json.dumps({"a": value}, indent=indent)
    assert is_object(text)
    assert is_object(f'{{"a": {text}, "b": {DEEP}}}')


@given(ANY, st.data())
def test_what_python_does_not_read_is_not(value: object, data: st.DataObject) -> None:
    text = json.dumps({"a": value})
    place = data.draw(st.integers(0, len(text) - 1))
    broken = (
        text[:place]
        + data.draw(st.sampled_from(['"', "{", "]", ",", ":", "x", ""]))
        + text[place + 1 :]
    )
    assert is_object(f'{{"a": {broken}, "b": {DEEP}}}') is _reads(f'{{"a": {broken}, "b": 0}}')


def _reads(text: str) -> bool:
    try:
        return isinstance(json.loads(text, parse_float=_finite), dict)
    except ValueError:
        return False


def _finite(digits: str) -> float:
    """A number too large for a double is not let in: no other reader agrees on what it is."""
    if math.isinf(float(digits)):
        raise ValueError(digits)
    return float(digits)


@pytest.mark.parametrize(
    "text", ["[1]", "1", "{", "", '{"a":1}}', '{"a":1} x', '{"a":NaN}', '{"a":1e999}', "{'a':1}"]
)
def test_other_texts_are_no_object(text: str) -> None:
    assert not is_object(text)


def test_a_program_of_two_thousand_blocks_in_a_column_is_let_in() -> None:
    text = in_column(2000)
    assert is_object(text)
    assert parsed(text) is None
    assert _with_room(lambda: json.loads(text))


def test_what_even_the_server_has_no_room_for_is_not() -> None:
    assert not is_object(in_column(5000))


def _with_room(read: Callable[[], object]) -> bool:
    """As the web server reads it."""
    found: list[object] = []
    before, size = sys.getrecursionlimit(), threading.stack_size(16 * 2**20)
    sys.setrecursionlimit(10_000)
    try:
        thread = threading.Thread(target=lambda: found.append(read()))
        thread.start()
        thread.join()
    finally:
        sys.setrecursionlimit(before)
        threading.stack_size(size)
    return bool(found)
