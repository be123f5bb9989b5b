"""ONNX Runtime's telemetry is off: it would write a device id to the home folder, and may send usage data."""

import os
import subprocess
import sys
from pathlib import Path

_RECOGNISE = (
    "from pinel_desktop.gestures.recognition import LandmarkRecognizer; LandmarkRecognizer()"
)


def test_loading_the_networks_writes_nothing_into_the_home_folder(tmp_path: Path) -> None:
    given = {name: value for name, value in os.environ.items() if not name.startswith("XDG_")}
    subprocess.run(
        [sys.executable, "-c", _RECOGNISE], env=given | {"HOME": str(tmp_path)}, check=True
    )
    assert list(tmp_path.rglob("*")) == []
