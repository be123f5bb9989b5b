"""Where the packaged program starts."""

import multiprocessing
import os
import sys


def _give_children_the_system_s_libraries() -> None:
    """Undoes what the bootloader did to LD_LIBRARY_PATH.

    It points at the libraries of the package. This process has read it; WebKit's helpers and the browsers that
    we start belong to the system and must find the system's own.
    """
    original = os.environ.pop("LD_LIBRARY_PATH_ORIG", None)
    os.environ.pop("LD_LIBRARY_PATH", None)
    if original:
        os.environ["LD_LIBRARY_PATH"] = original


if sys.platform == "linux":
    _give_children_the_system_s_libraries()

from pinel_desktop.__main__ import main  # noqa: E402 - after the environment is in order

# a process that checks programs beside others starts here too, and goes its own way
multiprocessing.freeze_support()

main()
