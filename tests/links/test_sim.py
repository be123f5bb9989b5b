import math
from pathlib import Path

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links import LINK_NAMES, open_link
from pinel_desktop.robot import PIONEER_3DX
from tests.links.link_contract import LinkContract


class TestSimLink(LinkContract):
    link = "sim"


@pytest.mark.parametrize("name", LINK_NAMES)
def test_every_backend_is_held_to_the_contract(name: str) -> None:
    tests = Path(__file__).with_name(f"test_{name}.py").read_text("utf-8")
    contract = "LinkContract" if name == "sim" else "RealLinkContract"
    assert f'({contract}):\n    link = "{name}"\n' in tests


def test_unknown_world_and_unknown_link_are_errors_that_list_what_there_is() -> None:
    with pytest.raises(PinelError) as world:
        open_link("sim", world="nowhere")
    with pytest.raises(PinelError) as link:
        open_link("teleporter", world="empty_room")
    assert (world.value.code, link.value.code) == ("unknown_world", "unknown_link")
    assert link.value.params["allowed"] == list(LINK_NAMES)


def test_simulator_has_every_sensor() -> None:
    sensors = open_link("sim", world="tic_tac_toe").sensors
    assert sensors.sonar(0) == sensors.sonar(15) == pytest.approx(1.99 - PIONEER_3DX.radius_m)
    assert sensors.lidar(0.0) == pytest.approx(5.49)
    plain = [sensors.reader(name)() for name in ("bumper", "floor", "cell")]
    assert plain == [False, "green", ""]


def test_robot_record_knows_sixteen_sonars_in_four_directions() -> None:
    assert len(PIONEER_3DX.sonars) == 16
    directions = PIONEER_3DX.distance_sonars
    assert sorted(index for indices in directions.values() for index in indices) == list(range(16))
    for direction, degrees in (("front", 0), ("left", 90), ("right", -90), ("back", 180)):
        angles = [PIONEER_3DX.sonars[index].angle_rad for index in directions[direction]]  # type: ignore[index]
        off = [abs(math.remainder(angle - math.radians(degrees), math.tau)) for angle in angles]
        assert max(off) <= math.radians(41)
