import math
from dataclasses import replace
from pathlib import Path

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links import LINK_NAMES, open_link
from pinel_desktop.messages import LANGUAGES, catalogue, describe
from pinel_desktop.robot import PIONEER_3DX, PRESETS, ROBOTS, Laser, SimulationConfig, Sonar
from pinel_desktop.robot.robot_profile import PROFILES
from tests.links.link_contract import LinkContract


class TestSimLink(LinkContract):
    link = "sim"


@pytest.mark.parametrize("name", LINK_NAMES)
def test_every_backend_is_held_to_the_contract(name: str) -> None:
    tests = Path(__file__).with_name(f"test_{name}.py").read_text("utf-8")
    contract = "RealLinkContract" if name in PROFILES else "LinkContract"
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


def test_sonars_and_scanner_measure_from_their_places(monkeypatch: pytest.MonkeyPatch) -> None:
    """The wall to the left of the start is 1.99 m away, all others further than the scanner sees."""
    sonars = (Sonar(0.1, 0.05, 0.0), Sonar(0.1, 0.05, math.pi / 2))
    laser = Laser(field_deg=360, range_m=3.0, min_m=1.0, x_m=-0.1, y_m=0.2)
    custom = replace(PIONEER_3DX, sonars=sonars, laser=laser)
    monkeypatch.setitem(ROBOTS, PIONEER_3DX.name, custom)
    sensors = open_link("sim", world="tic_tac_toe").sensors
    assert sensors.sonars() == pytest.approx([sensors.sonar(0), sensors.sonar(1)], abs=1e-9)
    assert sensors.sonars() == pytest.approx([5.0, 1.94])  # 5 m is a sonar's range
    assert sensors.lidar(math.pi / 2) == pytest.approx(1.79)
    assert sensors.lidar(-math.pi / 2) == 3.0
    scan = sensors.scan()
    assert len(scan) == 361
    assert (scan[90], scan[180], scan[270]) == pytest.approx((3.0, 3.0, 1.79), abs=2e-3)


def test_what_is_too_near_for_the_scanner_reads_as_the_nearest(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    blind = replace(PIONEER_3DX, laser=Laser(field_deg=180, range_m=3.0, min_m=2.1))
    monkeypatch.setitem(ROBOTS, PIONEER_3DX.name, blind)
    for preset in PRESETS:
        setting = SimulationConfig(preset=preset)
        sensors = open_link("sim", world="tic_tac_toe", setting=setting).sensors
        assert sensors.lidar(math.pi / 2) == pytest.approx(2.1, abs=0.03)
        assert min(sensors.scan()) >= 2.1


def test_a_robot_without_a_bumper_reads_none_but_is_seen_touching(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(ROBOTS, PIONEER_3DX.name, replace(PIONEER_3DX, has_bumper=False))
    link = open_link("sim", world="empty_room")
    with pytest.raises(PinelError) as error:
        link.sensors.reader("bumper")()
    assert error.value.code == "sensor_missing"
    assert link.bumper() is False


@pytest.mark.parametrize("name", PROFILES)
def test_every_kind_of_real_robot_has_a_name_and_a_description_in_every_language(name: str) -> None:
    for language in LANGUAGES:
        text = describe(f"robot_link_{name}", {}, language)
        assert text.message
        assert text.remedy
        assert f"review_robot_{name}" in catalogue(language)
