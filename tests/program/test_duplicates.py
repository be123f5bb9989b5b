"""A key that an object of a document holds twice is a fault, whatever else the text holds and however it is spaced."""

import json
import random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pinel_desktop.activities.reading import read_activity
from pinel_desktop.program.checks import check_semantics
from pinel_desktop.program.duplicates import duplicate_keys, max_keys
from pinel_desktop.program.pointers import pointer
from pinel_desktop.program.reading import read_document
from pinel_desktop.program.sources import read_source
from pinel_desktop.worlds import read_own_world
from tests.strategies import programs

FEW = settings(max_examples=25, deadline=None)  # drawing a program takes longer than reading it
SPACES = ["", "", "", " ", "\n\t", "\r\n  "]


def written(value: Any, chance: random.Random, duplicates: dict[int, str]) -> str:
    """JSON with white space anywhere; the objects in `duplicates` hold the key that is named there once more."""

    def around(sign: str) -> str:
        return f"{chance.choice(SPACES)}{sign}{chance.choice(SPACES)}"

    if isinstance(value, list):
        return f"[{around(',').join(written(one, chance, duplicates) for one in value)}]"
    if not isinstance(value, dict):
        return json.dumps(value, ensure_ascii=chance.random() < 0.5)
    pairs = list(value.items())
    if id(value) in duplicates:
        name = duplicates[id(value)]
        first = chance.randrange(list(value).index(name) + 1)
        pairs.insert(first, (name, chance.choice([None, "a : b", {"action": "stop"}, value[name]])))
    text = (
        f"{json.dumps(key)}{around(':')}{written(one, chance, duplicates)}" for key, one in pairs
    )
    return f"{{{around(',').join(text)}}}"


def objects(value: Any, path: tuple[str | int, ...] = ()) -> list[tuple[str, dict[str, Any]]]:
    inside = value.items() if isinstance(value, dict) else enumerate(value)
    found = [
        one
        for key, part in inside
        if isinstance(part, dict | list)
        for one in objects(part, (*path, key))
    ]
    return [(pointer(path), value), *found] if isinstance(value, dict) else found


def named(document: dict[str, Any], text: str) -> dict[str, Any]:
    """A copy of that name, in which no object stands in two places."""
    copy: dict[str, Any] = json.loads(json.dumps({**document, "name": text}))
    return copy


NAMES = st.sampled_from(
    ["", "a", "a : b", 'said "no": why', "ratio\u00a0: 2", "ção", "机器人", "a\n:"]
)


@FEW
@given(programs(), NAMES, st.randoms(use_true_random=False))
def test_a_document_without_a_key_twice_is_read_however_it_is_written(
    document: dict[str, Any], name: str, chance: random.Random
) -> None:
    document = named(document, name)
    reading = read_document(written(document, chance, {}))
    assert reading.faults == ()
    assert reading.program == read_document(document).program


@FEW
@given(programs(), NAMES, st.randoms(use_true_random=False), st.integers(1, 3))
def test_each_key_that_is_there_twice_is_told_with_its_object(
    document: dict[str, Any], name: str, chance: random.Random, count: int
) -> None:
    document = named(document, name)
    full = [(place, found) for place, found in objects(document) if found]
    chosen = [chance.choice(full) for _ in range(count)]
    duplicates = {id(found): chance.choice(list(found)) for _, found in chosen}
    expected = {(place, duplicates[id(found)]) for place, found in chosen}
    text = written(document, chance, duplicates)
    reading = read_source(text.encode("utf-8", "surrogatepass"))
    reported = [fault for fault in reading.faults if fault.code == "duplicate_key"]
    assert reading.program is None
    assert {(fault.pointer, fault.params["name"]) for fault in reported} == expected
    assert reading.faults == tuple(reported)


@FEW
@given(programs())
def test_the_quick_count_of_keys_is_exact_for_good_programs(document: dict[str, Any]) -> None:
    total = sum(len(found) for _, found in objects(document))
    assert check_semantics(document).n_keys == total == max_keys(json.dumps(document))


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ('{"pinel_ir": 1, "commands": [], "commands": []}', ""),
        ('{"pinel_ir": 1, "commands": [{"action": "stop", "action": "beep", "block": "b"}]}', "/commands/0"),
        ('{"pinel_ir": 1, "commands": [{"action": "stop", "\\u0061ction": "beep"}]}', "/commands/0"),
        ('{"pinel_ir": 1, "commands": [{"action" : "stop", "action": "beep"}], "name": " :"}', "/commands/0"),
        ('[{"action": "stop"}, {"action": "stop", "action": "stop"}]', "/1"),
        ('[{"action": "stop", "status": 1, "status": 2}]', "/0"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("encoding", ["utf-8", "utf-16", "utf-8-sig"])
def test_where_a_key_is_twice(text: str, place: str, encoding: str) -> None:
    reading = read_document(text.encode(encoding))
    assert [(fault.code, fault.pointer) for fault in reading.faults] == [("duplicate_key", place)]


def test_no_letters_of_another_encoding_make_up_for_the_key_that_was_lost() -> None:
    """In UTF-16 the letter U+3A22 is written as a quote and a colon."""
    twice = '{"pinel_ir":1,"name":"\u3a22","commands":[],"commands":[]}'
    for encoding in ("utf-16-le", "utf-16-be", "utf-8"):
        faults = read_document(twice.encode(encoding)).faults
        assert [fault.code for fault in faults] == ["duplicate_key"]


def test_a_key_twice_inside_what_a_bare_list_passes_over_is_passed_over_too() -> None:
    reading = read_document('[{"action": "stop", "status": {"a": 1, "a": 2}}]')
    assert reading.faults == ()
    assert [fault.code for fault in reading.warnings] == ["unknown_key"]


def test_other_faults_are_told_beside_it_in_the_order_of_the_document() -> None:
    wait, stop = '{"action": "wait", "seconds": -1}', '{"action": "stop", "block": 1, "block": "b"}'
    text = f'{{"pinel_ir": 1, "commands": [{wait}, {stop}]}}'
    assert [(fault.code, fault.block) for fault in read_document(text).faults] == [
        ("seconds_out_of_range", None),
        ("duplicate_key", "b"),
    ]


def test_as_many_keys_as_a_document_may_hold_are_looked_at_once_each() -> None:
    many = ",".join(['"a":1'] * 150_000)
    assert [params for _, _, params in duplicate_keys(f"{{{many}}}")] == [{"name": "a"}]


def test_worlds_and_activities_refuse_it_too() -> None:
    world = '{"pinel_world": 1, "start": {"x_m": 0, "x_m": 1}}'
    document, faults = read_own_world(world)
    assert document is None
    assert ("duplicate_key", "/start") in [(fault.code, fault.pointer) for fault in faults]
    activity = '{"name": "a", "checks": [{"check": "finished", "check": "finished"}]}'
    assert ("duplicate_key", "/checks/0") in [
        (fault.code, fault.pointer) for fault in read_activity(activity)[1]
    ]
