"""Versions of everything that decides the numbers of a run: two processes with equal ones give equal runs."""

import platform
import sys
from functools import cache
from importlib import metadata

from pinel_desktop import __version__
from pinel_desktop.execution.semantics import CURRENT

_LIBRARIES = ("numpy", "pymunk")


@cache
def versions() -> dict[str, str]:
    """Returns the versions of this process by name."""
    return {
        "pinel": __version__,
        "semantics": str(CURRENT),
        "python": f"{sys.version_info.major}.{sys.version_info.minor}",
        "system": f"{sys.platform} {platform.machine()}",
        **{name: metadata.version(name) for name in _LIBRARIES},
    }
