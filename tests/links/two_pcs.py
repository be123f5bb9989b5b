"""PCs that begin to drive one robot at the same time: `pinel run` in processes that share no lock file."""

import contextlib
import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from pinel_desktop.robot import STANDSTILL, Twist2D

ROOT = Path(__file__).parents[2]
_RUN = ("-m", "pinel_desktop", "run", "--json", "--no-store")
# Until it is stopped: a PC that starts late still meets the one that drives.
FOR_EVER = [{"action": "forever", "commands": [{"action": "turn", "angle": 90}]}]
_ENDS_WITHIN_S = 90.0
# Until a second driver is known, and has sent its last zeros.
AN_INSTANT_S = 0.5


class ReceivedVelocity(NamedTuple):
    """A velocity that reached the robot: when (s, monotonic), which, and from whom."""

    at_s: float
    twist: Twist2D
    sender: Any


class Pc:
    """A `pinel run` on what is a PC of its own for it: no folder is shared with others.

    Args:
        folder: for its program and temporary files.
        options: of `pinel run`, such as the robot.
    """

    def __init__(
        self, folder: Path, options: Sequence[str], environment: dict[str, str] | None = None
    ) -> None:
        folder.mkdir(parents=True)
        self._is_stopped = False
        program = folder / "for_ever.json"
        program.write_text(json.dumps(FOR_EVER), "utf-8")
        self.process = subprocess.Popen(
            [sys.executable, *_RUN, str(program), *options],
            cwd=ROOT,
            env={**os.environ, **(environment or {}), "TMPDIR": str(folder), "TEMP": str(folder)},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def has_ended(self) -> bool:
        return self.process.poll() is not None

    def stop(self) -> None:
        """As Ctrl+C does; nothing where it has ended."""
        self._is_stopped = True
        self.process.terminate()

    def result(self) -> dict[str, Any]:
        """How the run ended; `stopped` where it was stopped before it could tell."""
        out, errors = self.process.communicate(timeout=_ENDS_WITHIN_S)
        assert out or self._is_stopped, errors
        ended: dict[str, Any] = json.loads(out or '{"state": "stopped", "reason": null}')
        return ended

    def close(self) -> None:
        self.process.kill()
        self.process.communicate()


def race(
    folder: Path,
    options: Sequence[str],
    received: Sequence[tuple[Any, ...]],
    head_start_s: float = 0.0,
    **environment: str,
) -> list[dict[str, Any]]:
    """The results of two PCs of which the second begins `head_start_s` later; when one gives up, the other is stopped.

    Args:
        received: what the robot hears, as it comes: times, velocities.
    """
    with contextlib.ExitStack() as ending:
        pcs = []
        for number in range(2):
            pcs.append(Pc(folder / str(number), options, environment))
            ending.callback(pcs[-1].close)
            time.sleep(head_start_s)
        _wait(lambda: any(pc.has_ended() for pc in pcs), "both drive the robot")
        for pc in pcs:
            pc.stop()
        results = [pc.result() for pc in pcs]
        _wait(lambda: not received or received[-1][1] == STANDSTILL, "the robot drives on")
        return results


def _wait(is_so: Callable[[], bool], otherwise: str) -> None:
    due_s = time.monotonic() + _ENDS_WITHIN_S
    while not is_so():
        assert time.monotonic() < due_s, otherwise
        time.sleep(0.01)


def both_drove_for_s(received: list[ReceivedVelocity]) -> float:
    """For how long velocities of more than one sender came."""
    moving = [one for one in received if one.twist != STANDSTILL]
    spans = {
        sender: [one.at_s for one in moving if one.sender == sender]
        for sender in {one.sender for one in moving}
    }
    if len(spans) < 2:
        return 0.0
    return max(0.0, min(max(at) for at in spans.values()) - max(min(at) for at in spans.values()))


def require_one_driver(
    results: list[dict[str, Any]], received: list[ReceivedVelocity], holder: str
) -> None:
    """Never two drove, and who gave up was told who drives: `holder` is part of that name."""
    assert both_drove_for_s(received) < AN_INSTANT_S
    refused = [result for result in results if result["state"] != "stopped"]
    assert refused, results
    assert {result["reason"] for result in refused} == {"robot_held"}, results
    assert all(holder in result["message"] for result in refused)
