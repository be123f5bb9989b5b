"""Real robots on the command line: the record of one, and the end of its run by a signal."""

import contextlib
import json
import signal
from collections.abc import Iterator, Mapping
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.control import RunControl
from pinel_desktop.robot.record import RECORDS, RobotRecord, record_from


def chosen_robot(link: str, settings: Mapping[str, str]) -> RobotRecord | None:
    """The record of a real robot with these settings; None for the simulator.

    Args:
        settings: fields and their values, as typed; a part of the room has the name `room.width_m`.

    Raises:
        PinelError: what `record_from` raises.
    """
    if link not in RECORDS:
        return None
    fields: dict[str, Any] = {"link": link}
    for name, typed in settings.items():
        inner, parts = fields, name.split(".")
        for part in parts[:-1]:
            inner = inner.setdefault(part, {})
            if not isinstance(inner, dict):
                raise PinelError("robot_record_invalid", field=name, value=typed)
        inner[parts[-1]] = _value(typed)
    return record_from(fields)


def _value(typed: str) -> Any:
    """A number or a list, where it is one; else the text."""
    try:
        return json.loads(typed)
    except ValueError:
        return typed


@contextlib.contextmanager
def stopped_by_signals(control: RunControl) -> Iterator[None]:
    """Ctrl+C and SIGTERM stop the robot; without this they would end the process, and the robot would drive on."""
    numbers = (signal.SIGINT, signal.SIGTERM)
    before = {
        number: signal.signal(number, lambda number, frame: control.stop()) for number in numbers
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
