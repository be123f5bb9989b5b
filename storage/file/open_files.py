"""Renames and deletes files that another process may have open for a moment, such as a virus scanner.

Windows refuses both with PermissionError while a file is open. Other systems refuse neither.
"""

import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path

# 0.9 s altogether
_PAUSES_S = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5) if sys.platform == "win32" else ()


def replace(source: Path, target: Path) -> None:
    """Renames a file; it replaces a file of that name. Raises OSError."""
    retry(lambda: source.replace(target))


def delete(path: Path, *, missing_ok: bool = False) -> None:
    """Deletes a file. Raises OSError; FileNotFoundError only without `missing_ok`."""
    retry(lambda: path.unlink(missing_ok))


def retry(
    action: Callable[[], object],
    pauses_s: Sequence[float] = _PAUSES_S,
    sleep: Callable[[float], None] = time.sleep,
) -> None:
    """Runs an action; after a PermissionError again after each pause. Raises the last error."""
    for pause_s in pauses_s:
        try:
            action()
        except PermissionError:
            sleep(pause_s)
        else:
            return
    action()
