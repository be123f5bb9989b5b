"""Differences of two versions, block by block."""

import copy
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pinel_desktop.school.review import Change, Counts, Difference, blocks_in_use, difference
from tests.school.review.sketches import Body, Drawing, Sketch, move, start, workspace_of

JSON = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(), st.floats(allow_nan=False), st.text()),
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.dictionaries(
            st.sampled_from(
                ["blocks", "block", "shadow", "next", "inputs", "fields", "id", "type"]
            ),
            inner,
            max_size=4,
        ),
    ),
    max_leaves=30,
)


def ids(marks: Any) -> list[str]:
    return [mark.block for mark in marks]


def compared(before: list[Body], after: list[Body]) -> Difference:
    return difference(workspace_of(*before), workspace_of(*after))


@settings(deadline=None)
@given(st.randoms(use_true_random=False), st.integers(0, 12))
def test_random_edits_are_found_exactly(random: Random, n_edits: int) -> None:
    drawing = Drawing(random)
    before = drawing.saved()
    for _ in range(n_edits):
        drawing.edit()
    after = drawing.saved()
    found = difference(before, after)
    assert set(ids(found.added)) == drawing.added
    assert set(ids(found.removed)) == drawing.removed
    assert set(ids(found.changed)) == drawing.changed
    assert set(ids(found.moved)) == drawing.moved
    assert difference(after, copy.deepcopy(after)) == Difference()


@settings(deadline=None)
@given(st.randoms(use_true_random=False))
def test_the_way_back_mirrors_the_way_there(random: Random) -> None:
    drawing = Drawing(random)
    before = drawing.saved()
    for _ in range(random.randrange(10)):
        drawing.edit()
    for body in drawing.bodies():  # changes the order too, where several results are correct
        rest = body[body is drawing.stacks[0] :]
        random.shuffle(rest)
        body[len(body) - len(rest) :] = rest
    after = drawing.saved()
    there, back = difference(before, after), difference(after, before)
    assert set(there.added) == set(back.removed)
    assert set(there.removed) == set(back.added)
    assert set(there.moved) == set(back.moved)
    turned = {
        (
            block.block,
            Change(one.name, one.after, one.before).name,
            repr(one.after),
            repr(one.before),
        )
        for block in back.changed
        for one in block.what
    }
    assert turned == {
        (block.block, one.name, repr(one.before), repr(one.after))
        for block in there.changed
        for one in block.what
    }


@given(JSON, JSON)
def test_odd_workspaces_never_raise(before: Any, after: Any) -> None:
    difference({"blocks": {"blocks": [before]}}, {"blocks": {"blocks": after}})
    difference(before, after)
    blocks_in_use({"blocks": {"blocks": [before, after]}})


@pytest.mark.parametrize(
    "not_a_workspace", [None, {}, [], 7, {"blocks": None}, {"blocks": {"blocks": [None, 3]}}]
)
def test_what_holds_no_blocks_is_empty(not_a_workspace: Any) -> None:
    assert difference(not_a_workspace, not_a_workspace) == Difference()
    assert ids(difference(not_a_workspace, workspace_of([start(), move()])).added) == ["m"]


def test_a_program_nested_ten_thousand_deep_is_compared() -> None:
    def nested(metres: float) -> Any:
        state: Any = {"type": "move_forward", "id": "m", "fields": {"METRES": metres}}
        for depth in range(10_000):
            kind = {"next": {"block": state}} if depth % 2 else {"inputs": {"DO": {"block": state}}}
            state = {"type": "repeat", "id": f"r{depth}", **kind}
        return {"blocks": {"blocks": [state]}}

    (changed,) = difference(nested(1), nested(2)).changed
    assert (changed.block, changed.what) == ("m", (Change("METRES", 1, 2),))


def test_a_number_in_a_shadow_is_a_value_of_its_block() -> None:
    found = compared([[start(), move(metres=1)]], [[start(), move(metres=0.5)]])
    assert found.summary == Counts(changed=1)
    assert found.changed[0].what == (Change("DISTANCE", 1, 0.5),)


def test_a_block_over_a_shadow_is_added_and_nothing_else() -> None:
    covered = move(metres=5)
    covered.inside["DISTANCE"] = Sketch("v", "get_variable")
    there = compared([[start(), move()]], [[start(), covered]])
    assert (there.summary, ids(there.added)) == (Counts(added=1), ["v"])
    back = compared([[start(), covered]], [[start(), move()]])
    assert (back.summary, ids(back.removed)) == (Counts(removed=1), ["v"])


def test_true_is_not_one() -> None:
    one, other = Sketch("a", "say", {"TEXT": 1}), Sketch("a", "say", {"TEXT": True})
    assert compared([[one]], [[other]]).summary == Counts(changed=1)
    assert compared([[one]], [[Sketch("a", "say", {"TEXT": 1.0})]]).summary == Counts()


def test_an_inserted_block_moves_nobody() -> None:
    before = [start(), move("a"), move("b"), move("c")]
    after = [before[0], move("n"), *before[1:]]
    assert compared([before], [after]).summary == Counts(added=1)
    assert compared([after], [before]).summary == Counts(removed=1)


def test_a_block_that_passes_two_others_is_the_one_that_moved() -> None:
    a, b, c, d = (move(name) for name in "abcd")
    found = compared([[start(), a, b, c, d]], [[start(), b, c, d, a]])
    assert ids(found.moved) == ["a"]


def test_blocks_that_are_wrapped_into_a_loop_have_moved() -> None:
    a, b, c = (move(name) for name in "abc")
    loop = Sketch("r", "repeat", bodies={"DO": [a, b]})
    found = compared([[start(), a, b, c]], [[start(), loop, c]])
    assert (ids(found.added), ids(found.moved)) == (["r"], ["a", "b"])


def test_the_other_socket_of_the_same_block_is_another_place() -> None:
    value = Sketch("v", "get_variable")
    one = Sketch("s", "sum", numbers={"A": 1, "B": 1}, inside={"A": value})
    other = Sketch("s", "sum", numbers={"A": 1, "B": 1}, inside={"B": value})
    assert compared([[one]], [[other]]).summary == Counts(moved=1)


def test_loose_stacks_lie_anywhere_on_the_sheet() -> None:
    first, second = [move("a"), move("b")], [move("c"), move("d")]
    assert compared([[start()], first, second], [second, [start()], first]).summary == Counts()
    assert compared([[start()], first], [[start()], [move("n"), *first]]).summary == Counts(added=1)
    assert ids(compared([first, second], [[*first, second[1]], second[:1]]).moved) == ["d"]


def test_what_was_pulled_off_the_program_has_moved_and_is_not_changed() -> None:
    before = workspace_of([start("old name"), move("a"), move("b")])
    after = workspace_of([start()], [move("a"), move("b")])
    state = after["blocks"]["blocks"][1]
    state["disabledReasons"] = state["next"]["block"]["disabledReasons"] = ["pinel_loose"]
    assert difference(before, after).summary == Counts(moved=2)
    assert blocks_in_use(after).loose == {"move_forward": 2}


def test_another_type_shape_comment_or_switch_is_a_change() -> None:
    before = Sketch("i", "if", shape={"elif": 1})
    after = Sketch("i", "if_else", shape={"elif": 2, "else": True}, comment="oi", off=True)
    (changed,) = compared([[before]], [[after]]).changed
    assert set(changed.what) == {
        Change("type", "if", "if_else"),
        Change("extraState.elif", 1, 2),
        Change("extraState.else", None, True),
        Change("comment", None, "oi"),
        Change("disabled", None, True),
    }


def test_blocks_in_use_are_counted_by_type_without_start_and_shadows() -> None:
    loop = Sketch("r", "repeat", numbers={"TIMES": 4}, bodies={"DO": [move("a"), move("b")]})
    function = Sketch("f", "function_def")
    use = blocks_in_use(workspace_of([start(), loop], [function, move("c")], [move("d")]))
    assert use.attached == {"function_def": 1, "move_forward": 3, "repeat": 1}
    assert use.loose == {"move_forward": 1}
