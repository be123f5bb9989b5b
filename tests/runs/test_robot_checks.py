"""What a program asks of a robot model that the model lacks, before its run."""

from dataclasses import replace
from typing import Any

import pytest

from pinel_desktop.robot import PIONEER_3DX, SMALL_ROBOT, RobotModel
from pinel_desktop.runs.robot_checks import missing_on_model

BLIND = replace(PIONEER_3DX, sonars=(), laser=None, has_bumper=False, distance_sonars={})


def reads(**sensor: Any) -> dict[str, Any]:
    return {"commands": [{"action": "say", "block": "b", "text": sensor}]}


@pytest.mark.parametrize(
    ("robot", "sensor"),
    [
        (BLIND, {"sensor": "sonar", "index": 0}),
        (BLIND, {"sensor": "sonar", "index": {"var": "n"}}),
        (BLIND, {"sensor": "lidar", "angle": 0}),
        (BLIND, {"sensor": "bumper"}),
        (BLIND, {"sensor": "distance", "direction": "front"}),
        (SMALL_ROBOT, {"sensor": "distance", "direction": "back"}),
        (SMALL_ROBOT, {"sensor": "sonar", "index": 3}),
        (SMALL_ROBOT, {"sensor": "lidar", "angle": 0}),
    ],
)
def test_a_sensor_that_the_robot_lacks_is_a_fault_at_its_block(
    robot: RobotModel, sensor: dict[str, Any]
) -> None:
    (fault,) = missing_on_model(reads(**sensor), robot)
    assert (fault.code, fault.block, fault.pointer) == ("sensor_missing", "b", "/commands/0/text")
    assert fault.params == {"sensor": sensor["sensor"]}


@pytest.mark.parametrize(
    ("robot", "sensor"),
    [
        (PIONEER_3DX, {"sensor": "sonar", "index": 15}),
        (PIONEER_3DX, {"sensor": "sonar", "index": {"var": "n"}}),
        (PIONEER_3DX, {"sensor": "lidar", "angle": -90}),
        (SMALL_ROBOT, {"sensor": "distance", "direction": "left"}),
        (SMALL_ROBOT, {"sensor": "sonar", "index": 2}),
        (BLIND, {"sensor": "floor"}),
        (BLIND, {"sensor": "heading"}),
    ],
)
def test_a_sensor_that_it_has_is_none(robot: RobotModel, sensor: dict[str, Any]) -> None:
    assert missing_on_model(reads(**sensor), robot) == []


def test_an_angle_outside_of_the_scanners_field_is_a_fault() -> None:
    (fault,) = missing_on_model(reads(sensor="lidar", angle=91), PIONEER_3DX)
    assert (fault.code, fault.pointer) == ("angle_out_of_range", "/commands/0/text/angle")
    assert fault.params == {"value": 91, "min": -90, "max": 90}
