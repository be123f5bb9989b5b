"""The command of this program as a person types it: with the package, in the portable version, in a source folder."""

import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

_NAME = "pinel"


def command_name() -> str:
    """Returns `pinel` if a terminal finds this program under that name, else its path, quoted for a terminal."""
    program = _program()
    if program is None:
        return f"{quoted(sys.executable)} -m pinel_desktop"
    found = shutil.which(_NAME)
    if found and os.path.realpath(found) == os.path.realpath(program):
        return _NAME
    return quoted(str(program))


def _program() -> Path | None:
    """Returns the packaged program, or the script beside this Python; None if there is neither."""
    if getattr(sys, "frozen", False):
        return Path(sys.executable)
    script = Path(shutil.which(_NAME, path=str(Path(sys.executable).parent)) or "")
    return script if script.is_file() else None


def quoted(path: str) -> str:
    """Returns a path as a person types it in a terminal of this PC."""
    return subprocess.list2cmdline([path]) if sys.platform == "win32" else shlex.quote(path)
