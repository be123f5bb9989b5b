"""Reading the largest world there may be, beside what its JSON and its models alone take."""

import json
import math
import statistics
import time
from collections.abc import Callable
from typing import Any

import pytest

from sim.document import MAX_AREAS, MAX_BOXES, MAX_WALLS, WorldDocument
from sim.parsing import read_world

RADIUS_M = 0.2225
PAIRS = 15
MAX_RATIO = 15.0

Document = dict[str, Any]


def max_size_world(walls: list[Document]) -> Document:
    """As many of everything as a document may hold; all boxes can be pushed."""
    places = [(-24 + i % 25 * 1.9, -23 + i // 25 * 2) for i in range(MAX_BOXES)]
    return {
        "pinel_world": 1,
        "name": "largest",
        "title": "A maior de todas",
        "size_m": [50, 50],
        "start": {"x_m": 0, "y_m": 24, "heading_deg": 0},
        "walls": walls,
        "boxes": [
            {"center": [x, y], "size": [0.3, 0.3], "heading_deg": 30, "movable": True, "mass_kg": 2}
            for x, y in places
        ],
        "zones": [
            {"name": f"Z{i}", "center": [x, y], "size": [1, 1], "heading_deg": 0}
            for i, (x, y) in enumerate(places[:MAX_AREAS])
        ],
        "floor": [{"color": "red", "center": [x, y], "radius": 0.5} for x, y in places[:MAX_AREAS]],
    }


def rows() -> list[Document]:
    """Walls beside and behind each other, none across another."""
    return [
        {"from": [x, y], "to": [x + 1.2, y]}
        for x, y in ((-24 + i % 25 * 1.9, -24 + i // 25 * 2) for i in range(MAX_WALLS))
    ]


def star() -> list[Document]:
    """Every wall across every other."""
    ends = [
        (20 * math.cos(i * math.pi / MAX_WALLS), 20 * math.sin(i * math.pi / MAX_WALLS))
        for i in range(MAX_WALLS)
    ]
    return [{"from": [x, y], "to": [-x, -y]} for x, y in ends]


def seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


@pytest.mark.parametrize(
    ("name", "walls", "n_faults"), [("sound", rows(), 0), ("star", star(), 100)]
)
def test_reading_costs_at_most_fifteen_times_json_and_models(
    name: str, walls: list[Document], n_faults: int
) -> None:
    text = json.dumps(max_size_world(walls))
    assert len(read_world(text, robot_radius_m=RADIUS_M).faults) == n_faults
    pairs = [
        (
            seconds(lambda: WorldDocument.model_validate(json.loads(text))),
            seconds(lambda: read_world(text, robot_radius_m=RADIUS_M)),
        )
        for _ in range(PAIRS)
    ]
    bare, ours = (statistics.median(side) for side in zip(*pairs, strict=True))
    print(
        f"\n{MAX_WALLS} walls ({name}, {len(text) / 1e3:.0f} kB): json.loads and pydantic {bare * 1e3:.1f} ms, "
        f"reading with all faults {ours * 1e3:.1f} ms, ratio {ours / bare:.1f}, at most {MAX_RATIO}"
    )
    assert ours / bare <= MAX_RATIO
