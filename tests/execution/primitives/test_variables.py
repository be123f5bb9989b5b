"""Variables and lists, and the limits of both."""

from typing import Any

import pytest

from pinel_desktop.execution.expressions.variables import Variables
from pinel_desktop.execution.failure import RunFailureError


def put(name: str, value: Any) -> dict[str, Any]:
    return {"action": "set_variable", "name": name, "value": value, "block": f"put {name}"}


def change(name: str, by: Any) -> dict[str, Any]:
    return {"action": "change_variable", "name": name, "by": by, "block": f"change {name}"}


def append(name: str, value: Any) -> dict[str, Any]:
    return {"action": "append", "list": name, "value": value, "block": f"append {name}"}


def var(name: str) -> dict[str, Any]:
    return {"var": name}


def repeat(times: int, *commands: Any) -> dict[str, Any]:
    return {"action": "repeat", "times": times, "commands": list(commands)}


def reason(result: Any) -> tuple[str, Any, str]:
    return result.ended.reason, result.ended.params, result.ended.block


def test_variables_hold_every_kind_of_value(execute_commands: Any) -> None:
    result, _ = execute_commands(
        put("número de voltas", 3),
        put("t", "ação"),
        put("b", True),
        put("l", [1, "a", False, 0.5]),
        put("c", var("l")),
    )
    assert result.variables == {
        "número de voltas": 3,
        "t": "ação",
        "b": True,
        "l": [1, "a", False, 0.5],
        "c": [1, "a", False, 0.5],
    }


def test_list_belongs_to_one_name(execute_commands: Any) -> None:
    result, _ = execute_commands(put("a", [1]), put("b", var("a")), append("a", 2), append("b", 3))
    assert result.variables == {"a": [1, 2], "b": [1, 3]}


def test_literal_list_is_new_each_time_it_is_met(execute_commands: Any) -> None:
    result, _ = execute_commands(repeat(3, put("a", [1]), append("a", 2)))
    assert result.variables == {"a": [1, 2]}


def test_changing_needs_a_number(execute_commands: Any) -> None:
    assert reason(execute_commands(change("n", 1))[0]) == (
        "unset_variable",
        {"name": "n"},
        "change n",
    )
    assert reason(execute_commands(put("n", "1"), change("n", 1))[0]) == (
        "wrong_type_number",
        {"name": "n"},
        "change n",
    )
    assert reason(execute_commands(put("n", 1), put("t", "1"), change("n", var("t")))[0]) == (
        "wrong_type_number",
        {"name": "by"},
        "change n",
    )
    assert reason(execute_commands(put("n", 1.7e308), change("n", 1.7e308))[0])[0] == (
        "not_finite_result"
    )


def test_appending_needs_a_list_and_something_that_is_none(execute_commands: Any) -> None:
    assert reason(execute_commands(append("l", 1))[0])[:2] == ("unset_variable", {"name": "l"})
    assert reason(execute_commands(put("l", 1), append("l", 1))[0])[:2] == (
        "wrong_type_list",
        {"name": "l"},
    )
    assert reason(execute_commands(put("l", []), append("l", var("l")))[0])[:2] == (
        "list_in_list",
        {"name": "l"},
    )


def test_list_of_10_000_is_full(execute_commands: Any) -> None:
    fill = put("l", []), repeat(10_000, append("l", 1))
    result, _ = execute_commands(*fill)
    assert (result.ended.state, len(result.variables["l"])) == ("finished", 10_000)
    result, _ = execute_commands(*fill, append("l", 1))
    assert reason(result) == ("list_too_long", {"value": 10_001, "max": 10_000}, "append l")


def test_texts_and_lists_altogether_have_a_limit(execute_commands: Any) -> None:
    long_text = put("t", "x" * 10_000)
    lists = [put(f"l{i}", []) for i in range(2)]
    result, _ = execute_commands(
        long_text, *lists, *[repeat(500, append(f"l{i}", var("t"))) for i in range(2)]
    )
    assert reason(result) == ("memory_full", {"max": 10_000_000}, "append l1")


def test_what_is_overwritten_makes_room(execute_commands: Any) -> None:
    long_text = put("t", "x" * 10_000)
    result, _ = execute_commands(
        long_text, repeat(20, put("l", []), repeat(400, append("l", var("t"))))
    )
    assert result.ended.state == "finished"


def test_thousand_variables_fit_and_no_more() -> None:
    # a document that names more is a fault on reading: only the variables themselves can be asked
    variables = Variables()
    for i in range(1_000):
        variables.set(f"v{i}", float(i))
    variables.set("v0", 1.0)
    with pytest.raises(RunFailureError, match="too_many_variables"):
        variables.set("one more", 1.0)


def test_variable_may_change_its_type(execute_commands: Any) -> None:
    result, _ = execute_commands(put("a", 1), put("a", "text"), put("a", [2]))
    assert result.variables == {"a": [2]}


def replace(name: str, position: Any, value: Any) -> dict[str, Any]:
    command = {"action": "replace_item", "list": name, "position": position, "value": value}
    return {**command, "block": f"replace {name}"}


def test_item_is_replaced_and_the_others_stay(execute_commands: Any) -> None:
    result, _ = execute_commands(
        put("a", [1, "b", True]),
        put("b", var("a")),
        replace("a", 1, "x"),
        replace("a", {"op": "length", "args": [var("a")]}, 0.5),
    )
    assert result.variables == {"a": ["x", "b", 0.5], "b": [1, "b", True]}


def test_replacing_in_a_function_changes_its_own_list(execute_commands: Any) -> None:
    own = {"name": "f", "parameters": ["a"], "commands": [replace("a", 1, 2)]}
    call = {"action": "call", "function": "f", "arguments": {"a": var("a")}}
    result, _ = execute_commands(put("a", [1]), call, functions=[own])
    assert result.variables == {"a": [1]}


@pytest.mark.parametrize(
    ("items", "position", "value", "code", "params"),
    [
        ([1, 2], 3, 0, "index_out_of_range", {"value": 3, "min": 1, "max": 2}),
        ([1, 2], var("zero"), 0, "position_out_of_range", {"value": 0, "min": 1, "max": 10_000}),
        ([1, 2], var("half"), 0, "wrong_type_whole_number", {"name": "position"}),
        ([1, 2], var("text"), 0, "wrong_type_number", {"name": "position"}),
        ([], 1, 0, "list_empty", {"operator": "replace_item"}),
        ("ab", 1, 0, "wrong_type_list", {"name": "l"}),
        ([1], 1, [2], "list_in_list", {"name": "l"}),
    ],
)
def test_replacing_needs_an_item_that_is_there(
    items: Any, position: Any, value: Any, code: str, params: Any, execute_commands: Any
) -> None:
    result, _ = execute_commands(
        put("zero", 0),
        put("half", 1.5),
        put("text", "1"),
        put("l", items),
        replace("l", position, value),
    )
    assert reason(result) == (code, params, "replace l")
    assert result.variables["l"] == items


def test_replaced_texts_make_room_and_take_it(execute_commands: Any) -> None:
    full = [put("t", "x" * 10_000), put("l", []), repeat(998, append("l", var("t")))]
    result, _ = execute_commands(*full, repeat(50, replace("l", 1, "y"), replace("l", 1, var("t"))))
    assert result.ended.state == "finished"
    result, _ = execute_commands(
        *full, append("l", "a"), append("l", "b"), replace("l", 999, var("t"))
    )
    assert reason(result)[0] == "memory_full"
