"""Fuzzing of the document reader with mutated programs, for a given time. The seed is printed."""

import json
import math
import random
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.program.reading import read_document
from tests.in_time import in_time
from tests.program.test_language import AREA, COMMANDS, WAVE, document
from tests.program.test_reading import resolve

pytestmark = [pytest.mark.fuzz, pytest.mark.timeout(900)]

PROGRAMS = Path(__file__).parents[1] / "programs"
MAX_READ_S = 5.0  # a document of 1 MiB takes a tenth of a second; more is a way to stop a server
# One more mutation at most doubles it, which this test can still write; the bound of the reader is far below.
DEEP = 300
INVALID_VALUES: list[Any] = [
    None, True, -1, 0, 1.5, math.nan, math.inf, -0.0, 10**400, 1e308, "", "x" * 20_000, "\ud800", "result", [], {},
    [[]], [{}], {"op": "+", "args": []}, {"op": [], "args": {}}, {"var": {}}, {"var": ""}, {"call": "area"},
    {"sensor": {}}, {"sensor": "sonar", "index": {"var": "x"}}, {"gesture": None}, {"action": "stop"}, {"action": []},
    "__import__('os').system('x')", "not " * 50 + "1 < 2",
]  # fmt: skip


def seeds() -> list[Any]:
    files = [path for path in PROGRAMS.glob("*.json") if not path.stem.endswith(".values")]
    return [*(json.loads(path.read_text("utf-8")) for path in files), document(*COMMANDS)]


def places(value: Any) -> list[tuple[Any, Any]]:
    """Every (container, key) in a document."""
    found, waiting = [], [value]
    while waiting:
        here = waiting.pop()
        keys = range(len(here)) if isinstance(here, list) else list(here)
        for key in keys:
            found.append((here, key))
            if isinstance(here[key], dict | list):
                waiting.append(here[key])
    return found


def replace(value: Any, chance: random.Random) -> None:
    container, key = chance.choice(places(value))
    container[key] = json.loads(json.dumps(chance.choice(INVALID_VALUES)))


def remove(value: Any, chance: random.Random) -> None:
    container, key = chance.choice(places(value))
    del container[key]


def transplant(value: Any, chance: random.Random) -> None:
    (container, key), (other, theirs) = chance.choices(places(value), k=2)
    container[key] = json.loads(json.dumps(other[theirs]))


def rename(value: Any, chance: random.Random) -> None:
    objects = [(container, key) for container, key in places(value) if isinstance(container, dict)]
    if objects:
        container, key = chance.choice(objects)
        names = ["action", "commands", "op", "args", "var", "x/~y", "", "else", "elif", "functions"]
        container[chance.choice(names)] = container.pop(key)


def nest(value: Any, chance: random.Random) -> None:
    container, key = chance.choice(places(value))
    for _ in range(chance.choice([1, 3, 70, 100])):
        container[key] = chance.choice(
            [
                [container[key]],
                {"op": "not", "args": [container[key]]},
                {"action": "forever", "commands": [container[key]]},
            ]
        )


MUTATIONS: list[Callable[[Any, random.Random], None]] = [replace, remove, transplant, rename, nest]


def mutated(chance: random.Random) -> Any:
    value = json.loads(json.dumps(chance.choice(seeds())))
    if isinstance(value, dict):
        value.setdefault("functions", [AREA, WAVE])
        value = json.loads(json.dumps(value))
    for _ in range(chance.choice([1, 1, 2, 5])):
        if places(value) and depth(value) < DEEP:
            chance.choice(MUTATIONS)(value, chance)
    return value


def depth(value: Any) -> int:
    """How many lists and objects stand inside one another."""
    levels, here = 0, [value]
    while here:
        levels += 1
        inside = (one.values() if isinstance(one, dict) else one for one in here)
        here = [one for some in inside for one in some if isinstance(one, dict | list)]
    return levels


def check(source: Any, parsed: Any) -> None:
    started = time.monotonic()
    reading = read_document(source)
    assert in_time(time.monotonic() - started, MAX_READ_S)
    assert (reading.program is None) == bool(reading.faults)
    for fault in reading.faults:
        json.dumps([fault.pointer, fault.block, fault.params], ensure_ascii=False).encode("utf-8")
        if parsed is not None:
            resolve(parsed, fault.pointer)
    if reading.document is not None:
        assert read_document(reading.document).document == reading.document


def test_mutated_documents_are_programs_or_have_faults_with_places(fuzz_s: float) -> None:
    seed = random.SystemRandom().getrandbits(32)
    chance = random.Random(seed)
    ending, count = time.monotonic() + fuzz_s, 0
    while time.monotonic() < ending:
        value = mutated(chance)
        try:
            check(value, value)
            text = json.dumps(value)
            check(text, json.loads(text))
            spoilt = bytearray(text.encode())
            for _ in range(chance.choice([1, 2, 10])):
                spoilt[chance.randrange(len(spoilt))] = chance.randrange(256)
            check(bytes(spoilt), None)
        except BaseException:
            print(f"seed {seed}, document {count}: {json.dumps(value)[:2000]}")
            raise
        count += 1
    print(f"{count} documents, seed {seed}")
    assert count > 0
