"""Files of PyTorch as detectors: what they contain is never executed. PyTorch is in the environment of `make bench`."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PEERS = ROOT / "build" / "peers"

pytestmark = [
    pytest.mark.nightly,
    pytest.mark.skipif(
        not (PEERS / ".ready-detector").exists(),
        reason="PyTorch or ultralytics could not be installed into build/peers",
    ),
]


def test_a_pickle_is_opened_only_if_it_holds_layers_and_nothing_of_it_is_executed(
    tmp_path: Path,
) -> None:
    (installed,) = PEERS.glob("lib/python*/site-packages")
    done = subprocess.run(
        [sys.executable, "-m", "tests.gestures.pt_files", str(tmp_path), str(installed)],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    found = json.loads(done.stdout.splitlines()[-1])
    assert found["executed"] is False
    assert found["codes"] == {
        "usable": "A B",
        "command": "detector_pickle_refused",
        "hidden": "detector_pickle_refused",
        "pickle": "detector_unreadable",
        "segment": "detector_task_wrong",
        "nameless": "detector_names_missing",
        "layer": "detector_names_missing",
        "tensor": "detector_unreadable",
        "truncated": "detector_unreadable",
        "text": "detector_unreadable",
    }
