"""The process of a Pioneer double, and a program of `pinel run` that drives it."""

import json
import math
import subprocess
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
_OPTIONS = ("--robot", "dds", "--json", "--no-store", "--seed", "1")
_SETTINGS = ('peers=["127.0.0.1"]', "room.width_m=6", "max_v_mps=0.5", "max_omega_dps=90")


class Double:
    """A Pioneer double (`tests/links/pioneer_double.py`) in a process of its own.

    Attributes:
        path_length_m: how far it really drove, once it has ended.
    """

    path_length_m = math.nan

    def __init__(self, domain: int, seed: int = 0) -> None:
        self._domain = domain
        self.process = subprocess.Popen(
            [sys.executable, "-m", "tests.links.pioneer_double", str(domain), str(seed)],
            cwd=ROOT,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert self.process.stdout is not None
        assert self.process.stdout.readline() == "ready\n"

    def run(self, program: Path) -> dict[str, Any]:
        """The result of `pinel run PROGRAM --robot dds --json`."""
        settings = (f"domain={self._domain}", *_SETTINGS)
        options = [text for each in settings for text in ("--robot-setting", each)]
        done = subprocess.run(
            [sys.executable, "-m", "pinel_desktop", "run", str(program), *_OPTIONS, *options],
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=False,
            timeout=200,
        )
        assert done.stdout, done.stderr
        result: dict[str, Any] = json.loads(done.stdout)
        return result

    def closing_error_m(self) -> float:
        """Ends the robot; how far from its start it really stands."""
        end = json.loads(self.process.communicate(timeout=20)[0])
        self.path_length_m = float(end["way_m"])
        return math.hypot(end["x_m"], end["y_m"])

    def close(self) -> None:
        """Ends the process, whatever it does."""
        self.process.kill()
        self.process.communicate()
