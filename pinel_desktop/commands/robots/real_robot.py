"""Real robots on the command line: options, robot profile, and stopping the run at a signal."""

import contextlib
import json
import signal
from collections.abc import Callable, Iterator
from typing import Any

import click

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.control import RunControl
from pinel_desktop.messages import describe
from pinel_desktop.robot.robot_profile import PROFILES, BridgeProfile, RobotProfile, profile_from

# the options of `chosen_robot`
ROBOT_OPTIONS = ("robot", "robot_settings", "bridge", "bridge_key")
_BRIDGE = BridgeProfile.link


def robot_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Adds the options for the connection to a real robot."""
    for add in (
        click.option(
            "--bridge-key",
            metavar="KEY",
            help="What each request to the bridge must bring, in the header X-PINEL-Key or as ?key=KEY.",
        ),
        click.option(
            "--bridge",
            metavar="HOST:PORT",
            help="Where the bridge listens for the program of the robot; with --robot bridge.",
        ),
        click.option(
            "--robot-setting",
            "robot_settings",
            metavar="NAME=VALUE",
            multiple=True,
            help="How a real robot is reached and what it may do, such as domain=5 or room.width_m=6 (docs/robots.md).",
        ),
    ):
        command = add(command)
    return command


def chosen_robot(
    robot: str, robot_settings: tuple[str, ...], bridge: str | None, bridge_key: str | None
) -> RobotProfile | None:
    """Returns the profile of a real robot; None for the simulator.

    Args:
        robot: name of the link.
        robot_settings: `NAME=VALUE`, as typed; a dot separates nested names, as in `room.width_m`.
        bridge: `HOST:PORT` of the bridge, an IPv6 address in brackets.

    Raises:
        PinelError: `robot_setting_unclear`, `bridge_option_unclear`, `bridge_option_alone`; any error of
            `profile_from`.
    """
    fields: dict[str, Any] = {"link": robot}
    for typed in robot_settings:
        _set(fields, typed)
    if bridge is not None or bridge_key is not None:
        if robot != _BRIDGE:
            raise PinelError("bridge_option_alone")
        fields |= _address(bridge) | ({} if bridge_key is None else {"key": bridge_key})
    return profile_from(fields) if robot in PROFILES else None


def _set(fields: dict[str, Any], typed: str) -> None:
    name, equals, value = typed.partition("=")
    if not equals:
        raise PinelError("robot_setting_unclear", value=typed)
    inner, parts = fields, name.strip().split(".")
    for part in parts[:-1]:
        inner = inner.setdefault(part, {})
        if not isinstance(inner, dict):
            raise PinelError("robot_record_invalid", field=name, value=value)
    inner[parts[-1]] = _value(value)


def _address(typed: str | None) -> dict[str, Any]:
    if typed is None:
        return {}
    host, _, port = typed.rpartition(":")
    if not host or not (port.isascii() and port.isdigit()):
        raise PinelError("bridge_option_unclear", value=typed)
    return {"host": host.removeprefix("[").removesuffix("]"), "port": int(port)}


def _value(typed: str) -> Any:
    """Parses a value as JSON, such as a number or a list; returns the text if it is no JSON."""
    try:
        return json.loads(typed)
    except ValueError:
        return typed


@contextlib.contextmanager
def stopped_by_signals(robot: RobotProfile | None, control: RunControl) -> Iterator[None]:
    """Makes Ctrl+C and SIGTERM stop a real robot. By default they would end the process while the robot drives on."""
    if robot is None:
        yield
        return
    numbers = (signal.SIGINT, signal.SIGTERM)
    before = {
        number: signal.signal(number, lambda number, frame: control.stop()) for number in numbers
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def announce_waiting(robot: RobotProfile | None, language: str) -> None:
    """Prints on standard error at which address the bridge waits for its client."""
    if isinstance(robot, BridgeProfile):
        values = {"host": robot.url_host, "port": robot.port, "seconds": robot.wait_s}
        click.echo(describe("bridge_waiting", values, language).line, err=True)
