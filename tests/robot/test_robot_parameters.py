"""Parameters of the simulated robot: bounds, record, and what an ordinary robot's record lacks."""

import json
from dataclasses import fields
from typing import Any

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import (
    RobotParameters,
    SimulationConfig,
    robot_parameters_from,
    simulation_config_from,
)
from pinel_desktop.robot.robot_parameters import BOUNDS
from sim.realistic import Realism


def test_each_parameter_has_bounds_and_is_one_of_the_simulator() -> None:
    names = [field.name for field in fields(RobotParameters)]
    assert list(BOUNDS) == names
    assert set(names) == {field.name for field in fields(Realism)}


def test_no_wheel_rolls_backwards_at_the_bounds() -> None:
    """The noise of a wheel is at most 3.47 standard deviations (`sim.noise`)."""
    mean, sd, noise = (
        BOUNDS[name][1] for name in ("wheel_bias_left", "wheel_bias_sd", "wheel_noise")
    )
    assert 1.0 - mean - 3.47 * (sd + noise) > 0.0


@pytest.mark.parametrize("value", [0.0, 5, -0.3, float("nan"), float("inf"), "0.3", None, True])
def test_absurd_value_is_named_with_its_bounds(value: object) -> None:
    with pytest.raises(PinelError) as caught:
        robot_parameters_from({"track_m": value})
    assert caught.value.code == "robot_parameter_range"
    assert (caught.value.params["low"], caught.value.params["high"]) == BOUNDS["track_m"]


def test_unknown_parameter_is_named_with_those_that_exist() -> None:
    with pytest.raises(PinelError) as caught:
        robot_parameters_from({"wings": 2})
    assert caught.value.code == "unknown_robot_parameter"
    assert caught.value.params["allowed"] == list(BOUNDS)


def test_ideal_robot_takes_no_parameters() -> None:
    with pytest.raises(PinelError) as caught:
        SimulationConfig(parameters=RobotParameters(track_m=0.3))
    assert caught.value.code == "robot_parameters_ideal"


def test_record_of_an_ordinary_robot_is_as_it_always_was() -> None:
    ordinary = SimulationConfig(preset="realistic").as_parameters()
    assert ordinary == {"model": "pioneer_3dx", "preset": "realistic", "feedback": "pose"}
    assert simulation_config_from(ordinary) == SimulationConfig(preset="realistic")
    assert simulation_config_from({}) == SimulationConfig()


def test_record_gives_the_same_parameters_again() -> None:
    parameters = robot_parameters_from({"track_m": 0.1 + 0.2, "lag_s": 1})
    setting = SimulationConfig(preset="realistic", parameters=parameters)
    record = json.loads(json.dumps(setting.as_parameters()))
    assert record["robot_parameters"] == {"track_m": 0.1 + 0.2, "lag_s": 1.0}
    assert simulation_config_from(record) == setting


@pytest.mark.parametrize(
    "changed",
    [
        {"robot_parameters": {"track_m": 9}},
        {"robot_parameters": {"wings": 1}},
        {"robot_parameters": 3},
        {"robot_parameters": ["track_m"]},
        {"robot_parameters": {"track_m": 0.3}, "preset": "ideal"},
    ],
)
def test_record_with_impossible_parameters_is_damaged(changed: dict[str, Any]) -> None:
    with pytest.raises(PinelError) as caught:
        simulation_config_from({"preset": "realistic", **changed})
    assert caught.value.code == "run_damaged"
