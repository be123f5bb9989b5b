"""PCs that begin to drive one robot at the same time: `pinel run` in processes that share no lock file."""

import contextlib
import json
import os
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

from pinel_desktop.robot import STANDSTILL, Twist2D

ROOT = Path(__file__).parents[2]
_RUN = ("-m", "pinel_desktop", "run", "--json", "--no-store")
# Longer than a PC waits for another one to leave.
FAR = [{"action": "move_forward", "distance": 1.7}]
# Until a second driver is known, and has sent its last zeros.
AN_INSTANT_S = 0.5


class Heard(NamedTuple):
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
        program = folder / "far.json"
        program.write_text(json.dumps(FAR), "utf-8")
        self.process = subprocess.Popen(
            [sys.executable, *_RUN, str(program), *options],
            cwd=ROOT,
            env={**os.environ, **(environment or {}), "TMPDIR": str(folder), "TEMP": str(folder)},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def result(self) -> dict[str, Any]:
        """How the run ended."""
        out, errors = self.process.communicate(timeout=90)
        assert out, errors
        ended: dict[str, Any] = json.loads(out)
        return ended

    def close(self) -> None:
        self.process.kill()
        self.process.communicate()


def race(
    folder: Path, options: Sequence[str], head_start_s: float = 0.0, **environment: str
) -> list[dict[str, Any]]:
    """The results of two PCs of which the second begins `head_start_s` later."""
    with contextlib.ExitStack() as ending:
        pcs = []
        for number in range(2):
            pcs.append(Pc(folder / str(number), options, environment))
            ending.callback(pcs[-1].close)
            time.sleep(head_start_s)
        return [pc.result() for pc in pcs]


def both_drove_for_s(heard: list[Heard]) -> float:
    """For how long velocities of more than one sender came."""
    moving = [one for one in heard if one.twist != STANDSTILL]
    spans = {
        sender: [one.at_s for one in moving if one.sender == sender]
        for sender in {one.sender for one in moving}
    }
    if len(spans) < 2:
        return 0.0
    return max(0.0, min(max(at) for at in spans.values()) - max(min(at) for at in spans.values()))


def require_one_driver(results: list[dict[str, Any]], heard: list[Heard]) -> None:
    """At most one PC drove to the end, each other was told who does, and the robot stands."""
    assert both_drove_for_s(heard) < AN_INSTANT_S
    refused = [result for result in results if result["state"] != "finished"]
    assert refused, "both drove the robot"
    assert {result["reason"] for result in refused} == {"robot_held"}, results
    assert heard == [] or heard[-1].twist == STANDSTILL
