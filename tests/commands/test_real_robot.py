"""`pinel run` on a real robot."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from pinel_desktop.commands.robots.real_robot import chosen_robot
from pinel_desktop.errors import PinelError
from pinel_desktop.robot.robot_profile import BridgeProfile
from tests.commands.typed import SQUARE, pinel, run_json
from tests.links.aurora import Aurora, free_port

pytestmark = pytest.mark.waits

# as fast as a Pioneer, so that the test does not take minutes
_FAST = ("--robot-setting", "max_v_mps=1.2", "--robot-setting", "max_omega_dps=300")


@pytest.fixture
def port() -> int:
    return free_port()


@pytest.fixture
def aurora(port: int) -> Iterator[Aurora]:
    double = Aurora(port, "--key", "k3y")
    yield double
    double.close()


def test_the_square_is_driven_over_the_bridge(aurora: Aurora, port: int) -> None:
    bridge = ("--robot", "bridge", "--bridge", f"127.0.0.1:{port}", "--bridge-key", "k3y")
    status, printed = run_json(SQUARE, *bridge, *_FAST)
    assert (status, printed["state"]) == (0, "finished"), printed
    assert printed["n_executed"] == 8
    # the motions end within the tolerances of a real robot: 1 cm and 0.6 degrees each
    assert printed["estimated_closing_error_m"] < 0.05
    assert printed["closing_error_m"] is None  # nobody knows where it truly is
    assert abs(printed["path_length_m"] - 4.0) < 0.1
    assert aurora.has_ended(within_s=10.0)


def test_a_client_with_steps_that_are_always_the_same_is_driven_too(port: int) -> None:
    double = Aurora(port, "--fixed-step")
    try:
        status, printed = run_json(
            SQUARE, "--robot", "bridge", "--bridge", f"127.0.0.1:{port}", *_FAST
        )
    finally:
        double.close()
    assert (status, printed["state"]) == (0, "finished"), printed
    assert printed["estimated_closing_error_m"] < 0.05


def test_it_says_where_it_waits_and_for_how_long(port: int) -> None:
    waiting = ("--bridge", f"127.0.0.1:{port}", "--robot-setting", "wait_s=0.2")
    result = pinel("run", SQUARE, "--robot", "bridge", *waiting, "--json")
    printed = json.loads(result.stdout)
    assert f"http://127.0.0.1:{port}/bridge/ for up to 0.2 s" in result.stderr
    assert (printed["state"], printed["reason"]) == ("failed", "bridge_no_client")
    assert result.exit_code == 1


def test_ctrl_c_ends_the_waiting(port: int, home: Path) -> None:
    waiting = [sys.executable, "-m", "pinel_desktop", "run", SQUARE, "--json"]
    waiting += ["--robot", "bridge", "--bridge", f"127.0.0.1:{port}"]
    with subprocess.Popen(
        waiting,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PINEL_HOME": str(home)},
    ) as process:
        assert process.stderr is not None
        assert str(port) in process.stderr.readline()
        process.send_signal(signal.SIGINT)
        printed, _ = process.communicate(timeout=60)
    assert json.loads(printed)["state"] == "stopped"


@pytest.mark.parametrize(
    ("options", "code"),
    [
        (("--robot", "bridge", "--bridge", "5000"), "bridge_option_unclear"),
        (("--robot", "bridge", "--bridge", "host:"), "bridge_option_unclear"),
        (("--robot", "bridge", "--bridge", "host:99999"), "robot_record_range"),
        (("--robot", "bridge", "--bridge", "a b:5000"), "robot_record_invalid"),
        (("--bridge", "127.0.0.1:5000"), "bridge_option_alone"),
        (("--robot", "bridge", "--robot-setting", "port"), "robot_setting_unclear"),
    ],
)
def test_unclear_options_are_named_before_anything_moves(
    options: tuple[str, ...], code: str
) -> None:
    status, printed = run_json(SQUARE, *options)
    assert (status, printed["reason"]) == (2, code)


def test_addresses_and_keys_are_read_as_typed() -> None:
    assert chosen_robot("bridge", (), "[::1]:6000", "1234") == BridgeProfile(
        host="::1", port=6000, key="1234"
    )
    chosen = chosen_robot("bridge", ("max_v_mps=0.5", "room.width_m=6"), None, None)
    assert isinstance(chosen, BridgeProfile)
    assert (chosen.max_v_mps, chosen.room.width_m, chosen.port) == (0.5, 6.0, 5000)
    assert chosen_robot("sim", (), None, None) is None
    with pytest.raises(PinelError, match="unclear"):
        chosen_robot("sim", ("port",), None, None)
