"""The part that all links of real robots share, over a transport in memory."""

import math
import os
import time
from dataclasses import replace
from pathlib import Path
from random import Random
from typing import Any
from unittest.mock import ANY

import pytest

from pinel_desktop import links
from pinel_desktop.errors import PinelError
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.links.odometry import OdometryFilter, yaw_of
from pinel_desktop.links.real import RealLink, real_link
from pinel_desktop.links.transport import Odometry
from pinel_desktop.robot import SimulationConfig, Twist2D
from pinel_desktop.robot.robot_profile import BridgeProfile, RobotProfile, Room, profile_from
from pinel_desktop.runs.record import record_of
from pinel_desktop.runs.spec import RunSpec, spec_from
from pinel_desktop.worlds import read_own_world
from tests.links.real_link_contract import Peer, RealLinkContract
from tests.links.unicycle import MemoryTransport, Unicycle

pytestmark = pytest.mark.waits

ROOM = Room(width_m=20.0, depth_m=20.0)
# a robot of its own: other tests drive theirs at the same time
FAST = BridgeProfile(host=f"memory-{os.getpid()}", max_v_mps=1.2, max_omega_dps=300.0, room=ROOM)


class TestMemoryLink(RealLinkContract):
    link = "memory"

    @pytest.fixture(autouse=True)
    def _installed(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setitem(links._BACKENDS, "memory", (__name__, "memory_link"))

    def start_peer(self) -> tuple[Peer, RobotProfile]:
        global _robot  # noqa: PLW0603 - `open_link` finds a backend by its name in a module
        _robot = Unicycle()
        return _robot, FAST


_robot = Unicycle()


def memory_link(
    *, world: Any, setting: SimulationConfig, seed: int, robot: RobotProfile | None
) -> RealLink:
    return real_link(lambda record: MemoryTransport(_robot), setting, robot)


def message(x_m: float = 0.0, yaw_rad: float = 0.0, **more: Any) -> Odometry:
    values: dict[str, Any] = {"v_mps": 0.0, "omega_radps": 0.0, **more}
    return Odometry(x_m, 0.0, yaw_rad, **values)


@pytest.mark.parametrize(
    "wrong",
    [
        message(math.nan),
        message(math.inf),
        message(1e30),
        message(yaw_rad=math.nan),
        message(v_mps=math.nan),
        message(v_mps=1e6),
        message(omega_radps=-math.inf),
        message(stamp_s=math.nan),
    ],
)
def test_impossible_odometry_is_passed_over(wrong: Odometry) -> None:
    checked = OdometryFilter()
    checked.add(message(1.0), 0.0)
    checked.add(wrong, 0.1)
    assert checked.state is not None
    assert (checked.state.pose.x_m, checked.n_invalid, checked.arrived_s) == (1.0, 1, 0.0)


def test_a_robot_that_reports_nonsense_only_is_named() -> None:
    link = real_link(
        lambda record: MemoryTransport(Unicycle(x_m=math.nan)), SimulationConfig(), FAST
    )
    with pytest.raises(PinelError) as raised:
        link.connect()
    link.close()
    assert raised.value.code == "odometry_invalid"


def test_a_robot_that_reports_nonsense_for_a_second_is_named_and_silent_it_is_lost() -> None:
    link = memory_link(world=None, setting=SimulationConfig(), seed=0, robot=FAST)
    link.on_odometry(message(1.0))
    link.on_odometry(message(math.nan))
    assert link.read().pose.x_m == 1.0
    link._odometry.arrived_s -= 5.0
    link.on_odometry(message(math.nan))
    with pytest.raises(PinelError) as invalid:
        link.read()
    assert (invalid.value.code, invalid.value.params) == ("odometry_invalid", {"count": 2})
    link._odometry.invalid_s -= 5.0
    with pytest.raises(PinelError, match="link_lost"):
        link.read()


def test_messages_out_of_order_are_passed_over_until_the_clock_has_been_set_back() -> None:
    checked = OdometryFilter()
    checked.add(message(1.0, stamp_s=10.0), 0.0)
    checked.add(message(0.9, stamp_s=9.9), 0.1)
    assert (checked.arrived_s, checked.n_late) == (0.0, 1)
    checked.add(message(1.1, stamp_s=5.0), 0.5)
    assert checked.arrived_s == 0.5


@pytest.mark.parametrize("jump", [message(1.51), message(1.0, math.pi)])
def test_a_jump_is_a_lost_reference(jump: Odometry) -> None:
    checked = OdometryFilter()
    checked.add(message(1.0), 0.0)
    with pytest.raises(PinelError) as lost:
        checked.add(jump, 0.1)
    assert lost.value.code == "reference_lost"


def test_another_frame_is_another_odometry() -> None:
    checked = OdometryFilter()
    checked.add(message(frame="odom"), 0.0)
    with pytest.raises(PinelError) as changed:
        checked.add(message(frame="map"), 0.1)
    assert changed.value.params == {"before": "odom", "now": "map"}


def test_the_velocity_of_a_robot_that_tells_its_pose_only_is_that_of_its_poses() -> None:
    checked = OdometryFilter()
    checked.add(message(1.0, v_mps=None, omega_radps=None), 0.0)
    checked.add(message(1.03, 0.1, v_mps=None, omega_radps=None), 0.1)
    assert checked.state is not None
    assert checked.state.twist == pytest.approx((0.3, 1.0))


def driven(checked: OdometryFilter, times_s: list[float], late_s: list[float]) -> list[Twist2D]:
    """The velocities told of a robot at 0.3 m/s whose poses of these times arrive late."""
    velocities = []
    for at_s, by_s in zip(times_s, late_s, strict=True):
        checked.add(message(0.3 * at_s, v_mps=None, omega_radps=None), at_s + by_s)
        assert checked.state is not None
        velocities.append(checked.state.twist)
    return velocities


def test_poses_that_come_early_and_late_tell_a_calm_velocity() -> None:
    late = Random(1)
    times_s = [tick / 30 for tick in range(300)]
    velocities = driven(OdometryFilter(), times_s, [late.uniform(0.0, 0.01) for _ in times_s])
    assert all(abs(twist.v_mps - 0.3) < 0.035 for twist in velocities[4:])


def test_a_thousand_poses_a_second_tell_the_velocity() -> None:
    times_s = [tick / 1000 for tick in range(500)]
    velocities = driven(OdometryFilter(), times_s, [0.0] * len(times_s))
    assert velocities[-1] == pytest.approx((0.3, 0.0))


def test_a_robot_that_stands_is_known_to_stand_within_five_of_its_poses() -> None:
    checked = OdometryFilter()
    driven(checked, [tick / 30 for tick in range(30)], [0.0] * 30)
    for tick in range(30, 35):
        checked.add(message(0.3 * 29 / 30, v_mps=None, omega_radps=None), tick / 30)
    assert checked.state is not None
    assert checked.state.twist == (0.0, 0.0)


def test_yaw_of_quaternions() -> None:
    half = math.radians(60.0) / 2
    assert yaw_of(0.0, 0.0, math.sin(half), math.cos(half)) == pytest.approx(math.radians(60.0))
    assert yaw_of(0.0, 0.0, 2 * math.sin(half), 2 * math.cos(half)) == pytest.approx(2 * half)
    assert math.isnan(yaw_of(0.0, 0.0, 0.0, 0.0))
    assert math.isnan(yaw_of(math.nan, 0.0, 0.0, 1.0))


def test_a_silent_robot_is_not_driven_on_even_if_nobody_reads_it() -> None:
    robot = Unicycle()
    link = real_link(lambda record: MemoryTransport(robot), SimulationConfig(), FAST)
    link.connect()
    robot.is_mute = True
    due_s = time.monotonic() + 20.0
    while robot.standstill_since_s() is None or len(robot.received) < 30:
        assert time.monotonic() < due_s, "the robot drives on"
        link.command(Twist2D(0.2, 0.0))
        time.sleep(0.02)
    link.close()
    assert Twist2D(0.2, 0.0) in {twist for _, twist in robot.received}


def test_messages_that_waited_while_the_pc_paused_are_taken_before_the_robot_counts_as_lost(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """As after a second without the processor: the reading thread comes first, or the thread that hears."""
    link = memory_link(world=None, setting=SimulationConfig(), seed=0, robot=FAST)
    link.on_odometry(message(1.0))
    link._odometry.arrived_s -= 5.0
    with monkeypatch.context() as hearing:
        hearing.setattr(time, "sleep", lambda seconds: link.on_odometry(message(2.0)))
        assert link.read().pose.x_m == 2.0
    link._odometry.arrived_s -= 5.0
    with pytest.raises(PinelError, match="link_lost"):
        link.read()


def test_a_second_problem_does_not_hide_the_first() -> None:
    link = real_link(lambda record: MemoryTransport(Unicycle()), SimulationConfig(), FAST)
    link.on_problem(PinelError("reference_lost", distance=1.0))
    link.on_problem(PinelError("link_lost"))
    with pytest.raises(PinelError) as problem:
        link.read()
    assert problem.value.code == "reference_lost"


def test_a_link_without_a_record_says_that_the_robot_is_to_be_set_up() -> None:
    with pytest.raises(PinelError) as missing:
        real_link(lambda record: MemoryTransport(Unicycle()), SimulationConfig(), None)
    assert missing.value.code == "robot_not_set_up"


@pytest.mark.parametrize(
    ("fields", "field", "value"),
    [
        ({"command_topic": "cmd vel"}, "command_topic", "cmd vel"),
        ({"peers": ["a b"]}, "peers.0", "a b"),
        ({"colour": "red"}, "colour", "red"),
    ],
)
def test_a_wrong_record_names_field_and_value(
    fields: dict[str, Any], field: str, value: Any
) -> None:
    with pytest.raises(PinelError) as wrong:
        profile_from({"link": "dds", **fields})
    assert wrong.value.code == "robot_record_invalid"
    assert wrong.value.params["field"] == field
    assert repr(wrong.value.params["value"]) == repr(value)


@pytest.mark.parametrize(
    ("fields", "field", "value", "low", "high"),
    [
        ({"domain": 233}, "domain", 233, 0, 232),
        ({"domain": 1.5}, "domain", 1.5, 0, 232),
        ({"max_v_mps": math.nan}, "max_v_mps", math.nan, 0.05, 1.2),
        ({"max_v_mps": "fast"}, "max_v_mps", "fast", 0.05, 1.2),
        ({"room": {"width_m": 0.2}}, "room.width_m", 0.2, 1, 50),
    ],
)
def test_a_number_out_of_its_range_is_told_with_the_range(
    fields: dict[str, Any], field: str, value: Any, low: float, high: float
) -> None:
    with pytest.raises(PinelError) as wrong:
        profile_from({"link": "dds", **fields})
    assert wrong.value.code == "robot_record_range"
    expected = {"field": field, "value": value, "low": low, "high": high}
    assert {name: repr(one) for name, one in wrong.value.params.items()} == {
        name: repr(float(one) if name in ("low", "high") else one) for name, one in expected.items()
    }


def test_a_slow_robot_has_half_the_speeds_but_not_less_than_the_least() -> None:
    slow = profile_from({"link": "bridge", "max_v_mps": 0.3, "max_omega_dps": 8.0}).slowed()
    assert (slow.max_v_mps, slow.max_omega_dps) == (0.15, 5.0)
    assert profile_from(slow.as_message()) == slow


def test_a_record_comes_back_from_its_message() -> None:
    record = profile_from({"link": "dds", "namespace": "p3dx", "peers": ["10.0.0.2"]})
    assert profile_from(record.as_message()) == record
    with pytest.raises(PinelError):
        profile_from({"link": "sim"})


def test_the_record_limits_the_robot() -> None:
    link = real_link(
        lambda record: MemoryTransport(Unicycle()), SimulationConfig(), BridgeProfile()
    )
    assert Twist2D(link._max_v, link._max_omega) == Twist2D(0.3, math.radians(60.0))


def test_two_runs_never_drive_one_robot() -> None:
    first, second = (
        real_link(lambda record: MemoryTransport(Unicycle()), SimulationConfig(), FAST)
        for _ in range(2)
    )
    first.connect()
    with pytest.raises(PinelError) as busy:
        second.connect()
    second.close()
    first.close()
    assert (busy.value.code, busy.value.params) == ("robot_busy_here", {"address": FAST.address})
    third = real_link(lambda record: MemoryTransport(Unicycle()), SimulationConfig(), FAST)
    third.connect()
    third.close()


def test_the_room_is_a_world_without_faults() -> None:
    room = Room(width_m=5.0, depth_m=3.0, x_m=-1.0, heading_deg=90.0)
    world, faults = read_own_world(room.as_world())
    assert faults == []
    assert world is not None
    assert world["size_m"] == [5.0, 3.0]


def test_a_run_keeps_the_record_of_its_robot_without_the_key() -> None:
    record = BridgeProfile(key="secret")
    spec = RunSpec({}, record.room.as_world(), link="bridge", robot=record)
    run_record = record_of(spec, world_name="room", app_version="1", version_id="v")
    assert run_record.link == "bridge"
    assert run_record.parameters["robot"]["max_v_mps"] == 0.3
    assert "secret" not in str(run_record)
    assert spec_from(spec.as_message(), ScriptedInputs()) == replace(spec, inputs=ANY)


@pytest.mark.skipif(os.name != "posix", reason="Windows has a temporary folder for each account")
def test_every_account_of_the_pc_may_drive_the_robot(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    link = real_link(lambda record: MemoryTransport(Unicycle()), SimulationConfig(), FAST)
    link.connect()
    (lock,) = tmp_path.iterdir()
    assert lock.stat().st_mode & 0o777 == 0o666
    link.close()
    assert list(tmp_path.iterdir()) == []
