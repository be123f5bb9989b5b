"""A robot that differs from its model: its body moves differently, and it does not know."""

import math

import pytest

from pinel_desktop.links.sim import SimLink
from pinel_desktop.robot import PIONEER_3DX, SimulationConfig, Twist2D, robot_parameters_from
from pinel_desktop.robot.robot_parameters import BOUNDS
from sim.simulator import TICK_S

EXACT = {"wheel_bias_sd": 0.0, "wheel_noise": 0.0}


def link_of(parameters: dict[str, float], seed: int = 0) -> SimLink:
    setting = SimulationConfig(
        preset="realistic", feedback="odometry", parameters=robot_parameters_from(parameters)
    )
    return SimLink(world="empty_room", setting=setting, seed=seed)


def drive(link: SimLink, v_mps: float, omega_radps: float, ticks: int = 60) -> tuple[float, float]:
    """Drives for two seconds, stops, and returns the true and the estimated change: of yaw, or of x if it drove."""
    start = link.read()
    assert start.true_pose is not None
    for twist in [Twist2D(v_mps, omega_radps)] * ticks + [Twist2D()] * 30:
        link.command(twist)
        link.advance(TICK_S)
    end = link.read()
    assert end.true_pose is not None
    true, estimated = end.true_pose.relative_to(start.true_pose), end.pose.relative_to(start.pose)
    return (true.x_m, estimated.x_m) if v_mps else (true.yaw_rad, estimated.yaw_rad)


def test_robot_with_a_greater_track_turns_less_than_it_reports() -> None:
    track = PIONEER_3DX.track_m * 1.1
    true, estimated = drive(link_of({"track_m": track, **EXACT}), 0.0, 0.5)
    assert estimated == pytest.approx(1.0, abs=0.02)
    assert true == pytest.approx(estimated / 1.1, rel=1e-3)


def test_robot_with_greater_wheels_drives_farther_than_it_reports() -> None:
    link = link_of({"wheel_bias_left": 0.02, "wheel_bias_right": 0.02, **EXACT})
    true, estimated = drive(link, 0.3, 0.0)
    assert estimated == pytest.approx(0.6, abs=0.02)
    assert true == pytest.approx(estimated * 1.02, rel=1e-3)


def test_robot_with_one_greater_wheel_turns_while_it_believes_to_drive_straight() -> None:
    link = link_of({"wheel_bias_right": 0.02, **EXACT})
    start = link.read().pose
    drive(link, 0.3, 0.0)
    state = link.read()
    assert state.true_pose is not None
    assert state.true_pose.yaw_rad - start.yaw_rad == pytest.approx(
        0.02 * 0.6 / PIONEER_3DX.track_m, rel=0.05
    )
    assert state.pose.yaw_rad == pytest.approx(start.yaw_rad, abs=1e-9)


def test_mean_bias_moves_the_drawn_one() -> None:
    steady = {"wheel_noise": 0.0}
    drawn, _ = drive(link_of(steady, seed=3), 0.3, 0.0)
    greater = {"wheel_bias_left": 0.1, "wheel_bias_right": 0.1, **steady}
    moved, _ = drive(link_of(greater, seed=3), 0.3, 0.0)
    assert moved / drawn == pytest.approx(1.1, rel=0.01)


def test_robot_controls_by_the_delay_of_the_preset_whatever_its_own() -> None:
    assert link_of({"lag_s": 0.3, "latency_s": 0.2}).command_delay_s == link_of({}).command_delay_s


@pytest.mark.parametrize("name", BOUNDS)
@pytest.mark.parametrize("side", [0, 1])
def test_every_parameter_at_its_bounds_gives_finite_poses(name: str, side: int) -> None:
    link = link_of({name: BOUNDS[name][side]})
    link.command(Twist2D(0.3, 0.5))
    for _ in range(30):
        link.advance(TICK_S)
    state = link.read()
    assert all(
        math.isfinite(value) for value in (*state.pose, *state.twist, *link.sensors.sonars())
    )


def test_parameters_of_the_preset_given_by_name_change_no_bit() -> None:
    plain = link_of({}, seed=5)
    named = link_of({"track_m": PIONEER_3DX.track_m, "lag_s": 0.06}, seed=5)
    for link in (plain, named):
        drive(link, 0.3, 0.4)
    assert plain.read() == named.read()
