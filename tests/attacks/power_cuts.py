"""A PC whose power goes while PINEL reads a damaged file."""

import subprocess
import sys
from pathlib import Path

_CUT = """
import os, sys
from pathlib import Path
from storage.salvage import salvage
salvage.recover_rows = lambda *_: os._exit(9)
path = Path(sys.argv[1])
salvage.salvage_into(path, path.with_name("made.db"), "")
"""


def power_cut_while_read(path: Path) -> None:
    """What lies in the folder of the file afterwards is what a power cut leaves."""
    ended = subprocess.run([sys.executable, "-c", _CUT, str(path)], check=False)
    assert ended.returncode == 9
    assert any(one.is_dir() for one in path.parent.iterdir())
