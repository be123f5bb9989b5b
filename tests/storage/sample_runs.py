"""Events of runs as the engine sends them, for tests."""

import math
from collections.abc import Iterator
from typing import Any


def sample(run: str, tick: int, **fields: Any) -> dict[str, Any]:
    """A telemetry event of a robot that drives along x at 0.3 m/s."""
    return {
        "v": 1,
        "type": "telemetry",
        "run": run,
        "seq": tick,
        "tick": tick,
        "x_m": 0.01 * tick,
        "y_m": 0.0,
        "yaw_rad": 0.0,
        "v_mps": 0.3,
        "omega_radps": 0.0,
        "command_v_mps": 0.3,
        "command_omega_radps": 0.0,
        "goal_x_m": 0.01 * tick + 0.001,
        "goal_y_m": 0.0,
        "goal_yaw_rad": 0.0,
        "done": 0.01 * tick,
        "bumper": False,
        **fields,
    }


def block_started(run: str, seq: int, tick: int = 0) -> dict[str, Any]:
    return {
        "v": 1,
        "type": "block_started",
        "run": run,
        "seq": seq,
        "tick": tick,
        "block": "kL0p",
        "pointer": "/commands/0",
        "action": "move_forward",
        "amount": 1.0,
    }


def ended(run: str, seq: int, tick: int, **fields: Any) -> dict[str, Any]:
    return {
        "v": 1,
        "type": "run_ended",
        "run": run,
        "seq": seq,
        "tick": tick,
        "state": "finished",
        "reason": None,
        "params": {},
        "block": None,
        "n_executed": 8,
        "duration_s": tick / 30,
        "path_length_m": 4.0,
        "closing_error_m": 0.00005,
        "pose": {"x_m": 0.0, "y_m": 0.0, "yaw_rad": 0.0},
        "telemetry_sha256": "ab" * 32,
        "estimated_closing_error_m": 0.00002,
        **fields,
    }


def square(run: str, laps: int = 1) -> Iterator[dict[str, Any]]:
    """Telemetry of a 1 m square at 0.6 m/s with smooth starts, and turns of 1 s in its corners."""
    tick, x, y, yaw = 0, 0.0, 0.0, 0.0
    for _ in range(4 * laps):
        for step in range(60):
            speed = 0.5 * (1 - math.cos(2 * math.pi * step / 60))
            x += speed * math.cos(yaw) / 30
            y += speed * math.sin(yaw) / 30
            yield sample(run, tick, x_m=x, y_m=y, yaw_rad=yaw, v_mps=speed, done=step / 60)
            tick += 1
        for step in range(30):
            rate = math.pi / 2 * (1 - math.cos(2 * math.pi * step / 30))
            yaw += rate / 30
            yield sample(run, tick, x_m=x, y_m=y, yaw_rad=yaw, omega_radps=rate, done=3.0 * step)
            tick += 1
