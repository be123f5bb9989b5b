"""What sensors give a program, in the simulator and on links that lack them."""

import math
from typing import Any

import pytest

from pinel_desktop.events.model import Event, Telemetry
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links import open_link
from pinel_desktop.links.sim import SimLink
from pinel_desktop.program.reading import read_document
from pinel_desktop.program.sensors import SENSORS
from pinel_desktop.robot import Sensors, SimulationConfig
from sim.world import list_worlds

WALL, HULL = 3.99, 0.2225


def sonar(index: Any) -> dict[str, Any]:
    return {"sensor": "sonar", "index": index}


def distance(direction: str) -> dict[str, Any]:
    return {"sensor": "distance", "direction": direction}


def measure(sensor: str) -> dict[str, Any]:
    return {"sensor": sensor}


def forward(metres: float) -> dict[str, Any]:
    return {"action": "move_forward", "distance": metres}


def turn(angle: float) -> dict[str, Any]:
    return {"action": "turn", "angle": angle}


@pytest.mark.parametrize(
    ("index", "metres"),
    [
        (0, WALL - HULL),
        (3, WALL / math.cos(math.radians(10)) - HULL),
        (4, WALL / math.cos(math.radians(10)) - HULL),
        (2, WALL / math.cos(math.radians(30)) - HULL),
        (12, WALL / math.cos(math.radians(10)) - HULL),
        (1, WALL / math.cos(math.radians(40)) - HULL),
    ],
)
def test_sonar_measures_from_the_hull_along_its_direction(
    index: int, metres: float, value_of: Any
) -> None:
    assert value_of(sonar(index)) == pytest.approx(metres, abs=1e-3)


def test_sonar_gives_5_where_nothing_is_near(value_of: Any) -> None:
    far = [value_of(sonar(index), turn(45)) for index in range(16)]
    assert max(far) == 5.0
    assert all(0 < metres <= 5 for metres in far)


def test_sonars_on_the_left_see_the_left(value_of: Any) -> None:
    to_the_left = turn(90), forward(2), turn(-90)
    assert value_of(sonar(0), *to_the_left) == pytest.approx(WALL - HULL - 2, abs=1e-3)
    assert value_of(sonar(7), *to_the_left) == 5.0
    assert value_of(distance("left"), *to_the_left) == pytest.approx(WALL - HULL - 2, abs=1e-3)


@pytest.mark.parametrize(
    ("direction", "angle"), [("front", 0), ("left", -90), ("back", 180), ("right", 90)]
)
def test_distance_looks_where_its_name_says(direction: str, angle: float, value_of: Any) -> None:
    ahead = forward(2), turn(angle)
    near = [value_of(distance(name), *ahead) for name in ("front", "left", "right", "back")]
    assert min(near) == value_of(distance(direction), *ahead)
    assert near.count(min(near)) == 1
    beyond = 1.99 / math.cos(math.radians(10)) - HULL
    assert min(near) == pytest.approx(
        beyond if direction in ("front", "back") else 1.99 - HULL, abs=2e-3
    )


def corridor(width: float, length: float) -> dict[str, Any]:
    """The robot stands in its middle and looks along it, `length` metres from its end."""
    sides = [{"from": [-9, y], "to": [length, y]} for y in (width / 2, -width / 2)]
    end = {"from": [length, -width / 2], "to": [length, width / 2]}
    start = {"x_m": 0, "y_m": 0, "heading_deg": 0}
    return {"name": "w", "start": start, "walls": [*sides, end]}


@pytest.mark.parametrize(("direction", "angle"), [("front", 0), ("back", 180)])
def test_distance_along_a_corridor_is_that_to_its_end(
    direction: str, angle: float, value_of: Any
) -> None:
    ahead = value_of(distance(direction), turn(angle), world=corridor(2.4, 7))
    assert ahead == 5.0
    ahead = value_of(distance(direction), turn(angle), world=corridor(2.4, 4))
    assert ahead == pytest.approx(4 / math.cos(math.radians(10)) - HULL, abs=0.02)


def test_distance_in_a_narrow_corridor_tells_no_more_than_is_known(value_of: Any) -> None:
    """Beams along the way meet its sides before its end, which may be nearer than their range."""
    ahead = value_of(distance("front"), world=corridor(1.0, 4))
    assert ahead == pytest.approx(0.5 / math.sin(math.radians(10)) - HULL, abs=0.1)
    assert ahead < 4 - HULL


@pytest.mark.parametrize("angle", range(-80, 81, 10))
@pytest.mark.parametrize("preset", ["ideal", "realistic"])
def test_a_robot_that_stops_by_distance_does_not_touch_a_wall_met_at_any_angle(
    angle: int, preset: Any
) -> None:
    """The wall crosses the way 4 m ahead."""
    away = math.radians(angle)
    x, y = 30 * math.sin(away), 30 * math.cos(away)
    start = {"x_m": 0, "y_m": 0, "heading_deg": 0}
    world = {"name": "w", "start": start, "walls": [{"from": [4 + x, -y], "to": [4 - x, y]}]}
    near = {"op": "<", "args": [distance("front"), 0.3]}
    steps = {"action": "until", "condition": near, "commands": [forward(0.1)]}
    program = read_document({"pinel_ir": 1, "name": "", "commands": [steps]}).program
    assert program is not None
    touched = []

    def observe(_: int, event: Event) -> None:
        if isinstance(event, Telemetry):
            touched.append(event.bumper)

    link = open_link("sim", world=world, setting=SimulationConfig(preset=preset))
    result = execute(program, link, RunOptions(observer=observe))
    assert result.ended.state == "finished"
    assert not any(touched)
    assert result.telemetry.path_length_m() > 0.5


def test_distance_at_the_wall_is_nothing_and_never_negative(value_of: Any) -> None:
    drive = {"action": "drive", "linear": 0.6, "angular": 0}
    at_the_wall = value_of(distance("front"), drive, {"action": "wait", "seconds": 10})
    assert 0 <= at_the_wall < 0.02


def test_lidar_measures_from_the_centre(value_of: Any) -> None:
    assert value_of({"sensor": "lidar", "angle": 0}) == pytest.approx(WALL, abs=1e-6)
    assert value_of({"sensor": "lidar", "angle": -60}) == pytest.approx(
        WALL / math.cos(math.radians(30)), abs=1e-6
    )
    assert value_of({"sensor": "lidar", "angle": 90}, forward(1)) == pytest.approx(WALL, abs=1e-3)


def test_place_and_heading_are_in_the_start_frame(value_of: Any) -> None:
    route = forward(1), turn(90), forward(0.5), turn(90)
    for world in ("empty_room", "tic_tac_toe"):
        assert value_of(measure("x"), *route, world=world) == pytest.approx(1, abs=1e-3)
        assert value_of(measure("y"), *route, world=world) == pytest.approx(0.5, abs=1e-3)
    assert value_of(measure("heading"), turn(-90)) == pytest.approx(-90, abs=0.01)
    assert -180 < value_of(measure("heading"), turn(180)) <= 180


def test_compass_knows_the_map_whatever_the_start(value_of: Any) -> None:
    room = {one["name"]: one for one in list_worlds()}["empty_room"]
    for start_deg in (0, 90, -135):
        turned = {**room, "start": {**room["start"], "heading_deg": start_deg}}
        for left_deg in (0, 90, -90):
            map_heading_deg = 90 - start_deg - left_deg
            measured = value_of(measure("compass"), turn(left_deg), world=turned)
            assert measured == pytest.approx(180 - (180 - map_heading_deg) % 360, abs=0.01)


def test_time_is_seconds_since_the_run_began(value_of: Any) -> None:
    assert value_of(measure("time")) == 0
    assert value_of(measure("time"), {"action": "wait", "seconds": 1.5}) == 1.5


def test_bumper_feels_the_wall(value_of: Any) -> None:
    drive = {"action": "drive", "linear": 0.6, "angular": 0}
    assert value_of(measure("bumper")) is False
    assert value_of(measure("bumper"), drive, {"action": "wait", "seconds": 9}) is True


def test_cells_of_the_board_are_those_of_the_dissertation(execute_commands: Any) -> None:
    read = {"action": "say", "text": measure("cell")}
    paint = {"action": "say", "text": measure("floor")}
    row = [forward(1), read]
    back = [turn(180), forward(2), turn(90), forward(1), turn(90), read]
    result, _ = execute_commands(
        read,
        paint,
        *row,
        paint,
        *row,
        *row,
        *back,
        *row,
        *row,
        *back,
        *row,
        *row,
        world="tic_tac_toe",
    )
    assert result.ended.state == "finished"
    assert result.shown_texts == ["", "green", "A", "yellow", *"BCDEFGIL"]


def test_world_without_zones_and_paint_is_white_and_has_no_cells(value_of: Any) -> None:
    assert value_of(measure("cell")) == ""
    assert value_of(measure("floor")) == "white"


class Blind(SimLink):
    """A robot that moves and senses nothing."""

    def __init__(self) -> None:
        super().__init__(world="empty_room", setting=SimulationConfig(), seed=0)
        self.sensors = Sensors()


@pytest.mark.parametrize(
    "expression",
    [
        sonar(0),
        distance("front"),
        {"sensor": "lidar", "angle": 0},
        measure("bumper"),
        measure("floor"),
        measure("cell"),
        measure("compass"),
    ],
    ids=lambda expression: expression["sensor"],
)
def test_sensor_that_the_link_lacks_fails_the_run_at_the_block(expression: Any) -> None:
    program = read_document(
        [{"action": "set_variable", "name": "v", "value": expression, "block": "b"}]
    ).program
    assert program is not None
    ended = execute(program, Blind()).ended
    name = "sonar" if expression["sensor"] == "distance" else expression["sensor"]
    assert (ended.reason, ended.params, ended.block) == ("sensor_missing", {"sensor": name}, "b")


def test_what_is_read_does_not_change_the_telemetry(execute_commands: Any) -> None:
    def run(expression: Any) -> str:
        read = {"action": "set_variable", "name": "v", "value": expression}
        result, _ = execute_commands(read, forward(1), read, turn(90), read)
        digest: str = result.ended.telemetry_sha256
        return digest

    digests = {run(expression) for expression in (0, sonar(0), distance("back"), measure("bumper"))}
    assert len(digests) == 1


def test_every_sensor_of_the_language_gives_its_type_within_its_range(value_of: Any) -> None:
    for sensor in SENSORS.values():
        asked = {sensor.argument.name: sensor.argument.start} if sensor.argument else {}
        value = value_of({"sensor": sensor.name, **asked})
        assert sensor.is_possible(float(value) if sensor.gives == "number" else value)
