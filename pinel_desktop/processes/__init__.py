"""Supervised processes of this program: start, messages, probes, restart and end."""

import sys


def own_command(*arguments: str) -> list[str]:
    """Returns a command line of this program: the packaged program itself, or this Python with the package."""
    if getattr(sys, "frozen", False):
        return [sys.executable, *arguments]
    return [sys.executable, "-m", "pinel_desktop", *arguments]
