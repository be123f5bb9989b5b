"""Reading and validating a document of 20,000 commands, beside parsing its JSON with the standard library."""

import json
import statistics
import time
from collections.abc import Callable
from typing import Any

import pytest

from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.reading import read_document

N_COMMANDS = 20_000
PAIRS = 15
MAX_RATIO = 5.0
# a text with " :" in it: only a second look at each object tells that no key is there twice
MAX_RATIO_WITH_KEY_CHECK = 8.0

MOVES: list[dict[str, Any]] = [
    {"action": "move_forward", "distance": 1.5},
    {"action": "turn", "angle": -90},
]
MIXED: list[dict[str, Any]] = [
    *MOVES,
    {"action": "say", "text": "hi"},
    {"action": "beep"},
    {"action": "turn", "angle": {"op": "/", "args": [{"var": "a"}, 2]}},
]


def document(commands: list[dict[str, Any]], name: str = "long") -> bytes:
    some = [commands[i % len(commands)] | {"block": f"{i:x}"} for i in range(N_COMMANDS)]
    text = json.dumps({"pinel_ir": 1, "name": name, "commands": some}, separators=(",", ":"))
    assert len(text) <= MAX_BYTES
    return text.encode()


def seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


@pytest.mark.parametrize(("name", "commands"), [("moves", MOVES), ("mixed", MIXED)])
@pytest.mark.parametrize(
    ("called", "max_ratio"), [("long", MAX_RATIO), ("a : b", MAX_RATIO_WITH_KEY_CHECK)]
)
def test_reading_costs_at_most_five_times_parsing(
    name: str, commands: list[dict[str, Any]], called: str, max_ratio: float
) -> None:
    text = document(commands, called)
    assert read_document(text).program is not None
    pairs = [
        (seconds(lambda: json.loads(text)), seconds(lambda: read_document(text)))
        for _ in range(PAIRS)
    ]
    bare, ours = (statistics.median(side) for side in zip(*pairs, strict=True))
    ratio = ours / bare
    print(
        f"\n{N_COMMANDS} commands ({name}, {called!r}, {len(text) / 1e6:.2f} MB): json.loads {bare * 1e3:.1f} ms, "
        f"reading {ours * 1e3:.1f} ms, ratio {ratio:.1f}, at most {max_ratio}"
    )
    assert ratio <= max_ratio
