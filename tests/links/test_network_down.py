"""The network goes away while a real robot drives, and comes back."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.waits

ROOT = Path(__file__).parents[2]
_OWN_NETWORK = ("unshare", "--map-root-user", "--net")


def test_a_network_that_goes_away_loses_the_robot_and_stops_it_when_it_is_back() -> None:
    if (
        shutil.which("unshare") is None
        or subprocess.run([*_OWN_NETWORK, "true"], check=False).returncode
    ):
        pytest.skip("this system lets nobody make a network of their own: none can be taken away")
    done = subprocess.run(
        [*_OWN_NETWORK, sys.executable, "-m", "tests.links.network_down"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=110,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    results = json.loads(done.stdout)
    print(results)
    assert results["link"]["lost_s"] < 3.0
    assert results["link"]["was_driving"], "the double has no watchdog of its own"
    assert results["link"]["stood_s"] < 5.0
    assert results["run"] == {"state": "failed", "reason": "link_lost"}
    assert results["again"] == {"state": "finished", "reason": None}
