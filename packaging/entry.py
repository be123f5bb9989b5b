"""Entry point of the packaged program."""

import multiprocessing
import os
import sys


def _restore_library_path() -> None:
    """Restores LD_LIBRARY_PATH, because the bootloader has set it to the package's libraries.

    This process has already read the variable. WebKit's helper processes and browsers need the system's libraries.
    """
    original = os.environ.pop("LD_LIBRARY_PATH_ORIG", None)
    os.environ.pop("LD_LIBRARY_PATH", None)
    if original:
        os.environ["LD_LIBRARY_PATH"] = original


if sys.platform == "linux":
    _restore_library_path()

from pinel_desktop.__main__ import main  # noqa: E402 - after the environment is restored

# worker processes of multiprocessing start here too; in them this call does not return
multiprocessing.freeze_support()

main()
