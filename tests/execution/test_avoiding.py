"""go_to with avoid, in the real simulator: around what the map shows, and around what only the sensors see."""

from typing import Any

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links.sim import SimLink
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import PIONEER_3DX, Sensors, SimulationConfig
from sim.world import world_document

RADIUS_M = PIONEER_3DX.radius_m


def crate(x: float, y: float, size: float = 0.5) -> dict[str, Any]:
    """A box that is on no map, as it may be pushed about."""
    place = {"center": [x, y], "size": [size, size], "heading_deg": 0}
    return {**place, "movable": True, "mass_kg": 5}


def room(*boxes: dict[str, Any]) -> dict[str, Any]:
    return {**world_document("empty_room"), "boxes": list(boxes)}


class Nearness:
    """The simulator, with how near the robot ever was to something."""

    def __init__(self, world: str | dict[str, Any], sensors: type[Sensors] | None = None) -> None:
        self.link = SimLink(world=world, setting=SimulationConfig(), seed=0)
        if sensors is not None:
            self.link.sensors = sensors()
        self.touched = False
        self._advance = self.link.advance
        self.link.advance = self.advance  # type: ignore[method-assign]

    def advance(self, dt_s: float) -> None:
        self._advance(dt_s)
        self.touched = self.touched or self.link.bumper()


def go(watched: Nearness, *points: tuple[float, float], options: RunOptions | None = None) -> Any:
    commands = [{"action": "go_to", "x": x, "y": y, "avoid": True, "block": "g"} for x, y in points]
    program = read_document({"pinel_ir": 1, "name": "", "commands": commands}).program
    assert program is not None
    return execute(program, watched.link, options).ended


def test_around_what_the_map_shows() -> None:
    watched = Nearness("obstacles")
    ended = go(watched, (6, 4), (0, 0))
    assert ended.state == "finished"
    assert (ended.pose["x_m"], ended.pose["y_m"]) == pytest.approx((0, 0), abs=1e-4)
    assert not watched.touched


def test_around_what_only_the_sensors_see() -> None:
    watched = Nearness(room(crate(1, 0), crate(1.5, 1)))
    ended = go(watched, (3, 0), (0, 0), (2.5, 1.5))
    assert ended.state == "finished"
    assert (ended.pose["x_m"], ended.pose["y_m"]) == pytest.approx((2.5, 1.5), abs=1e-4)
    assert not watched.touched


def test_with_sonars_and_no_map() -> None:
    watched = Nearness(room(crate(1.2, 0.1, 0.8)))
    inner = watched.link.sensors

    class Sonars(Sensors):
        def sonar(self, index: int) -> float:
            return inner.sonar(index)

    watched.link.sensors = Sonars()
    ended = go(watched, (2.6, 0))
    assert ended.state == "finished"
    assert not watched.touched


def test_without_any_sensor_it_keeps_to_the_map() -> None:
    watched = Nearness(room(crate(1, 0)), Sensors)
    ended = go(watched, (0, 2))
    assert ended.state == "finished"


@pytest.mark.parametrize("point", [(1.5, 2.0), (20.0, 0.0)])
def test_where_no_way_leads_it_says_so(point: tuple[float, float]) -> None:
    ended = go(Nearness("obstacles"), point)
    assert (ended.state, ended.reason, ended.block) == ("failed", "no_way", "g")
    assert (ended.params["x"], ended.params["y"]) == point


def test_shut_in_by_things_seen_on_the_way_it_says_so() -> None:
    ring = [crate(1.2 + dx, dy, 0.3) for dx in (-0.6, -0.3, 0, 0.3, 0.6) for dy in (-0.6, 0.6)]
    ring += [crate(1.2 + dx, dy, 0.3) for dx in (-0.6, 0.6) for dy in (-0.3, 0, 0.3)]
    watched = Nearness(room(*ring))
    ended = go(watched, (1.2, 0))
    assert (ended.state, ended.reason) == ("failed", "no_way")
    assert not watched.touched


def test_the_same_run_every_time() -> None:
    hashes = {go(Nearness(room(crate(1, 0))), (3, 0)).telemetry_sha256 for _ in range(2)}
    assert len(hashes) == 1


def test_what_the_start_is_does_not_matter() -> None:
    world = {**world_document("obstacles"), "start": {"x_m": 3.0, "y_m": 2.0, "heading_deg": 180}}
    watched = Nearness(world)
    ended = go(watched, (6, 4))
    assert ended.state == "finished"
    assert not watched.touched


def test_a_missing_sensor_is_still_an_error_elsewhere() -> None:
    with pytest.raises(PinelError):
        Sensors().lidar(0.0)
