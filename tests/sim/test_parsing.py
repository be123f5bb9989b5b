"""Reading world documents: each fault at its place, and nothing ever raised."""

import json
import math
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sim.parsing import WorldParseResult, read_world
from sim.world import list_worlds

RADIUS_M = 0.25
BOX: dict[str, Any] = {"center": [2, 0], "size": [0.4, 0.4]}
PUSHED: dict[str, Any] = {**BOX, "movable": True}
DISC: dict[str, Any] = {"center": [0, 0], "radius": 0.5}
CROSS = [{"from": [-1, 1], "to": [1, 1]}, {"from": [0, 0.5], "to": [0, 1.5]}]


def world(**parts: Any) -> dict[str, Any]:
    """A room of 6 by 4 m without walls, with those parts."""
    return {
        "pinel_world": 1,
        "name": "own",
        "title": "A nossa sala",
        "size_m": [6, 4],
        "start": {"x_m": 0, "y_m": 0, "heading_deg": 0},
        "walls": [],
        **parts,
    }


def read(source: Any) -> WorldParseResult:
    return read_world(source, robot_radius_m=RADIUS_M)


def faults(source: Any) -> list[tuple[str, str]]:
    return [(fault.code, fault.pointer) for fault in read(source).faults]


def wall(*points: float) -> dict[str, Any]:
    return {"from": list(points[:2]), "to": list(points[2:])}


@pytest.mark.parametrize("document", list_worlds(), ids=lambda d: d["name"])
def test_every_world_that_ships_is_read_without_faults(document: dict[str, Any]) -> None:
    assert read(document).faults == ()


def test_a_document_is_read_into_walls_boxes_zones_and_paint() -> None:
    reading = read(
        world(
            title={"pt-BR": "Sala", "fr": "Salle"},
            walls=[wall(-1, 1, 1, 1)],
            boxes=[{**BOX, "heading_deg": 90, "movable": True, "mass_kg": 3}],
            zones=[{"name": "A", **DISC}],
            floor=[{"color": "red", **BOX}],
        )
    )
    assert reading.faults == ()
    assert reading.world is not None
    assert reading.world.walls[0].end == (1.0, 1.0)
    assert (reading.world.boxes[0].movable, reading.world.boxes[0].mass_kg) == (True, 3.0)
    assert [zone.name for zone in reading.world.zones] == ["A"]
    assert [paint.color for paint in reading.world.floor] == ["red"]


def test_the_normal_form_fills_in_what_was_left_out_and_reads_as_itself() -> None:
    short = world(boxes=[BOX], zones=None)
    normal = read(short).document
    assert normal is not None
    assert normal["boxes"][0] == {**BOX, "heading_deg": 0.0, "movable": False, "mass_kg": 2.0}
    assert (normal["zones"], normal["floor"]) == ([], [])
    assert json.dumps(read(normal).document) == json.dumps(normal)


def test_the_normal_form_has_a_look_only_where_one_is_given() -> None:
    plain = read(world(boxes=[BOX], prints=[], ground=None)).document
    assert plain is not None
    assert not {"prints", "ground"} & plain.keys()
    assert "kind" not in plain["boxes"][0]
    appearance = {"ground": "town", "prints": [{"kind": "rug", **BOX, "heading_deg": 0.0}]}
    dressed = read(world(boxes=[{**BOX, "kind": "table"}], **appearance)).document
    assert dressed is not None
    assert {key: dressed[key] for key in appearance} == appearance
    assert dressed["boxes"][0]["kind"] == "table"
    assert list(dressed)[-2:] == ["ground", "prints"]


def test_what_is_null_is_as_if_it_were_absent() -> None:
    area = {"name": "A", "center": [0, 0], "size": [1, 1], "radius": None}
    assert read(world(zones=[area], boxes=[{**BOX, "mass_kg": None}])).faults == ()


@pytest.mark.parametrize(
    ("source", "code"),
    [
        ([], "not_a_world"),
        (7, "not_a_world"),
        (None, "not_a_world"),
        ("[1, 2]", "not_a_world"),
        ("{", "world_syntax"),
        (b"\xff", "world_syntax"),
        ("[" * 100_000, "world_syntax"),
        ("1" * 100_000, "world_syntax"),
        ('{"name": "' + "x" * 300_000 + '"}', "world_too_large"),
    ],
    ids=lambda value: repr(value)[:20],
)
def test_what_is_no_world_at_all_is_one_fault(source: Any, code: str) -> None:
    assert faults(source) == [(code, "")]


@pytest.mark.parametrize(
    ("parts", "code", "pointer"),
    [
        ({"pinel_world": 2}, "world_version_unknown", "/pinel_world"),
        ({"pinel_world": None}, "missing_parameter", ""),
        ({"walls": None}, "missing_parameter", ""),
        ({"colour": "red"}, "world_unknown_key", "/colour"),
        ({"a/b": 1}, "world_unknown_key", "/a~1b"),
        ({"name": "A sala"}, "world_name_invalid", "/name"),
        ({"name": 7}, "wrong_type_text", "/name"),
        ({"title": 7}, "world_title_invalid", "/title"),
        ({"title": "x" * 61}, "text_too_long", "/title"),
        ({"title": "  "}, "world_text_blank", "/title"),
        ({"title": "\ud800"}, "text_not_unicode", "/title"),
        ({"title": {"en": "Room", "es": "Sala"}}, "missing_parameter", "/title"),
        (
            {"title": {"pt-BR": "Sala", "en": "Room", "es": "Sala", "PT_br": "Sala"}},
            "world_unknown_key",
            "/title/PT_br",
        ),
        (
            {"title": {"pt-BR": "Sala", "en": "x" * 61, "es": "Sala"}},
            "text_too_long",
            "/title/en",
        ),
        ({"size_m": [0.5, 4]}, "world_value_too_small", "/size_m/0"),
        ({"size_m": [6, 51]}, "world_value_too_large", "/size_m/1"),
        ({"size_m": [6]}, "world_not_a_pair", "/size_m"),
        ({"size_m": "6x4"}, "wrong_type_list", "/size_m"),
        ({"start": [0, 0, 0]}, "world_not_an_object", "/start"),
        ({"start": {"x_m": 0, "y_m": 0}}, "missing_parameter", "/start"),
        (
            {"start": {"x_m": math.nan, "y_m": 0, "heading_deg": 0}},
            "not_finite",
            "/start/x_m",
        ),
        (
            {"start": {"x_m": 0, "y_m": 0, "heading_deg": 361}},
            "world_value_too_large",
            "/start/heading_deg",
        ),
        (
            {"start": {"x_m": "0", "y_m": 0, "heading_deg": 0}},
            "wrong_type_number",
            "/start/x_m",
        ),
        (
            {"start": {"x_m": True, "y_m": 0, "heading_deg": 0}},
            "wrong_type_number",
            "/start/x_m",
        ),
        ({"start": {"x_m": 2.8, "y_m": 0, "heading_deg": 0}}, "start_off_floor", "/start"),
        ({"walls": {}}, "wrong_type_list", "/walls"),
        ({"pinel_world": 10**400}, "world_value_wrong", "/pinel_world"),
        ({"pinel_world": True}, "world_version_unknown", "/pinel_world"),
        ({5: 1}, "world_unknown_key", ""),
        ({"\ud800": 1}, "world_unknown_key", ""),
        ({"walls": [[0, 0, 1, 1]]}, "world_not_an_object", "/walls/0"),
        ({"walls": [{"from": [1, 1]}]}, "missing_parameter", "/walls/0"),
        ({"walls": [wall(1, 1, math.inf, 1)]}, "not_finite", "/walls/0/to/0"),
        ({"walls": [wall(1, 1, 1, 1)]}, "wall_too_short", "/walls/0"),
        ({"walls": [wall(1, 1, 3.1, 1)]}, "wall_off_floor", "/walls/0"),
        ({"walls": [wall(1, 1, 1e300, 1)]}, "world_value_too_large", "/walls/0/to/0"),
        ({"walls": CROSS}, "walls_cross", "/walls/1"),
        ({"walls": [wall(1, 1, 2, 1), wall(-1, 0, 1, 0)]}, "start_in_wall", "/start"),
        ({"walls": [wall(-1, 0.255, 1, 0.255)]}, "start_in_wall", "/start"),
        ({"boxes": [{**BOX, "size": [0.01, 1]}]}, "world_value_too_small", "/boxes/0/size/0"),
        ({"boxes": [{**BOX, "center": [2.9, 0]}]}, "box_off_floor", "/boxes/0"),
        ({"boxes": [{**BOX, "movable": 1}]}, "wrong_type_boolean", "/boxes/0/movable"),
        ({"boxes": [{**BOX, "mass_kg": 0}]}, "world_value_too_small", "/boxes/0/mass_kg"),
        ({"boxes": [{**BOX, "mass_kg": 101}]}, "world_value_too_large", "/boxes/0/mass_kg"),
        (
            {"boxes": [{**BOX, "mass_kg": 0.2}, {**BOX, "size": [0.02, 9.9]}]},
            "box_off_floor",
            "/boxes/1",
        ),
        ({"boxes": [{**PUSHED, "mass_kg": 0.4}]}, "box_mass_wrong", "/boxes/0/mass_kg"),
        ({"boxes": [{**PUSHED, "mass_kg": 20.5}]}, "box_mass_wrong", "/boxes/0/mass_kg"),
        ({"boxes": [{**PUSHED, "size": [0.5, 0.04]}]}, "box_too_thin", "/boxes/0/size"),
        ({"boxes": [{**BOX, "center": [0, 0]}]}, "start_in_box", "/start"),
        ({"boxes": [{**BOX, "center": [0.449, 0]}]}, "start_in_box", "/start"),
        ({"zones": [{"name": "", **DISC}]}, "world_text_blank", "/zones/0/name"),
        ({"zones": [{"name": "x" * 65, **DISC}]}, "text_too_long", "/zones/0/name"),
        ({"zones": [{"name": "A", "center": [0, 0]}]}, "missing_parameter", "/zones/0"),
        ({"zones": [{"name": "A", **BOX, **DISC}]}, "world_unknown_key", "/zones/0/size"),
        ({"zones": [{"name": "A", **DISC}] * 2}, "duplicate_zone", "/zones/1/name"),
        (
            {"zones": [{"name": "A", "center": [2.6, 0], "radius": 0.5}]},
            "zone_off_floor",
            "/zones/0",
        ),
        ({"floor": [{"color": "pink", **DISC}]}, "unknown_color", "/floor/0/color"),
        ({"floor": [{"color": [], **DISC}]}, "unknown_color", "/floor/0/color"),
        (
            {"floor": [{"color": "red", "center": [0, 1.9], "size": [1, 1]}]},
            "paint_off_floor",
            "/floor/0",
        ),
        ({"walls": [wall(1, 1, 2, 1)] * 501}, "too_many_walls", "/walls"),
        ({"boxes": [BOX] * 201}, "too_many_boxes", "/boxes"),
        ({"zones": [{"name": "A", **DISC}] * 201}, "too_many_zones", "/zones"),
        ({"floor": [{"color": "red", **DISC}] * 201}, "too_many_paints", "/floor"),
        ({"ground": "moon"}, "unknown_appearance", "/ground"),
        ({"ground": ["town"]}, "unknown_appearance", "/ground"),
        ({"boxes": [{**BOX, "kind": "sofa"}]}, "unknown_appearance", "/boxes/0/kind"),
        ({"prints": [{"kind": "river", **BOX}]}, "unknown_appearance", "/prints/0/kind"),
        ({"prints": [{"kind": "rug", "color": "pink", **BOX}]}, "unknown_color", "/prints/0/color"),
        ({"prints": [{"kind": "rug", **BOX}] * 201}, "too_many_prints", "/prints"),
    ],
    ids=lambda value: str(value)[:40] if isinstance(value, str) else "",
)
def test_a_fault_is_told_at_its_place(parts: dict[Any, Any], code: str, pointer: str) -> None:
    assert faults({**world(), **parts}) == [(code, pointer)]


def test_crossing_walls_are_both_named_counted_as_people_count() -> None:
    (fault,) = read(world(walls=[wall(-1, -1, 1, -1), *CROSS])).faults
    assert fault.params == {"wall": 3, "other": 2, "other_pointer": "/walls/1"}


@pytest.mark.parametrize(
    "second",
    [
        wall(1, 1, 1, -1),  # a corner
        wall(0, 1, 0, 2),  # a T
        wall(0, 0.995, 0, 2),  # a T drawn a little too far
        wall(1, 1, 2, 1),  # one line in two pieces
        wall(-1, 1.2, 1, 1.2),  # side by side
        wall(0, 1.1, 0, 2),  # near
    ],
)
def test_walls_that_meet_do_not_cross(second: dict[str, Any]) -> None:
    assert faults(world(walls=[wall(-1, 1, 1, 1), second])) == []


@pytest.mark.parametrize(
    ("boxes", "walls", "found"),
    [
        ([{**BOX, "movable": True}], [wall(2, -1, 2, 1)], [("box_in_wall", "/boxes/0")]),
        # walls are 2 cm thick
        ([{**BOX, "movable": True}], [wall(2.2, -1, 2.2, 1)], [("box_in_wall", "/boxes/0")]),
        ([{**BOX, "movable": True}], [wall(2.208, -1, 2.208, 1)], [("box_in_wall", "/boxes/0")]),
        ([{**BOX, "movable": True}], [wall(2.21, -1, 2.21, 1)], []),
        ([{**BOX, "movable": True}], [wall(2.208, 0, 2.8, 0)], [("box_in_wall", "/boxes/0")]),
        ([{**BOX, "movable": True}], [wall(2.21, 0, 2.8, 0)], []),
        ([BOX], [wall(2, -1, 2, 1)], []),
        ([{**BOX, "movable": True}, BOX], [], [("box_in_box", "/boxes/0")]),
        ([{**BOX, "movable": True}] * 2, [], [("box_in_box", "/boxes/1")]),
        ([BOX, BOX], [], []),
        # the corner of a turned box reaches past its half side
        (
            [{**BOX, "movable": True, "heading_deg": 45}],
            [wall(1.75, -1, 1.75, 1)],
            [("box_in_wall", "/boxes/0")],
        ),
        ([{**BOX, "movable": True, "heading_deg": 45}], [wall(1.7, -1, 1.7, 1)], []),
    ],
)
def test_a_box_to_push_stands_in_nothing(boxes: Any, walls: Any, found: Any) -> None:
    assert faults(world(boxes=boxes, walls=walls)) == found


@pytest.mark.parametrize(
    ("turned", "room"), [(0, True), (45, False)], ids=["side to the robot", "corner to the robot"]
)
def test_the_start_has_room_beside_a_turned_box(turned: float, room: bool) -> None:
    box = {"center": [0.46, 0], "size": [0.4, 0.4], "heading_deg": turned}
    assert faults(world(boxes=[box])) == ([] if room else [("start_in_box", "/start")])


def test_all_faults_are_told_at_once_in_the_order_of_the_document() -> None:
    document = world(
        floor=[{"color": "pink", **DISC}],
        walls=[wall(1, 1, 1, math.nan), *CROSS],
        size_m=[6, 4],
        title="",
        boxes=[{**BOX, "center": [9, 9]}, 7],
        extra=1,
    )
    del document["pinel_world"]
    assert faults(document) == [
        ("missing_parameter", ""),
        ("world_text_blank", "/title"),
        ("not_finite", "/walls/0/to/1"),
        ("walls_cross", "/walls/2"),
        ("box_off_floor", "/boxes/0"),
        ("world_not_an_object", "/boxes/1"),
        ("unknown_color", "/floor/0/color"),
        ("world_unknown_key", "/extra"),
    ]


def test_of_thousands_of_faults_the_first_hundred_are_told() -> None:
    spokes = [
        wall(1.9 * math.cos(a), 1.9 * math.sin(a), -1.9 * math.cos(a), -1.9 * math.sin(a))
        for a in (i * math.pi / 500 for i in range(500))
    ]
    assert len(faults(world(walls=spokes))) == 100
    assert len(faults({str(n): n for n in range(10_000)})) == 100
    assert faults({str(n): n for n in range(100_000)}) == [("world_too_large", "")]


GARBAGE = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.sampled_from([0, 1, -0.3, 2, 10**400, 1e308, math.nan, -math.inf])
    | st.floats()
    | st.text(max_size=5)
    | st.sampled_from(["red", "own", "\ud800"]),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(
            st.sampled_from(
                [
                    "from",
                    "to",
                    "center",
                    "size",
                    "radius",
                    "name",
                    "color",
                    "movable",
                    "x_m",
                    "\ud800",
                ]
            ),
            inner,
            max_size=5,
        )
    ),
    max_leaves=12,
)
KEYS: st.SearchStrategy[Any] = st.sampled_from(
    [*world(), "boxes", "zones", "floor", "other", "\ud800", 7, None]
)
NUMBERS = st.floats(-4, 4) | st.sampled_from([0, 1, 1e-9, math.nan, 10**400])
POINTS = st.lists(NUMBERS, min_size=2, max_size=2)


def shapes(**parts: Any) -> st.SearchStrategy[Any]:
    return st.lists(st.fixed_dictionaries({}, optional=parts) | GARBAGE, max_size=6)


AREAS = {"center": POINTS, "size": POINTS, "radius": NUMBERS, "heading_deg": NUMBERS}
LISTS: dict[str, Callable[[], st.SearchStrategy[Any]]] = {
    "walls": lambda: shapes(**{"from": POINTS, "to": POINTS}),
    "boxes": lambda: shapes(**AREAS, movable=st.booleans(), mass_kg=NUMBERS),
    "zones": lambda: shapes(**AREAS, name=st.text(max_size=3)),
    "floor": lambda: shapes(**AREAS, color=st.sampled_from(["red", "pink"])),
}


# the first draw builds all strategies: on a busy PC that alone is too slow for the health check
@settings(suppress_health_check=[HealthCheck.too_slow])
@given(
    st.dictionaries(KEYS, GARBAGE),
    st.fixed_dictionaries({}, optional={k: v() for k, v in LISTS.items()}),
)
def test_no_garbage_ever_raises(parts: dict[Any, Any], lists: dict[str, Any]) -> None:
    reading = read({**world(), **lists, **parts})
    assert (reading.world is None) == bool(reading.faults)


def test_a_key_that_is_no_text_hides_no_other_fault() -> None:
    found = faults({**world(walls=[{"to": [0, 1]}, wall(1, 1, 1, 1)]), "\ud800": 1, None: 2})
    assert sorted(found) == [
        ("missing_parameter", "/walls/0"),
        ("wall_too_short", "/walls/1"),
        ("world_unknown_key", ""),
        ("world_unknown_key", ""),
    ]


@given(st.binary(max_size=200) | st.text(max_size=200))
def test_no_text_ever_raises(text: str | bytes) -> None:
    assert read(text).faults
