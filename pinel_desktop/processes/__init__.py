"""Supervised processes of this program: how they are started, talked to, probed, replaced and ended."""

import sys


def own_command(*arguments: str) -> list[str]:
    """The packaged program itself, or this Python with the package."""
    if getattr(sys, "frozen", False):
        return [sys.executable, *arguments]
    return [sys.executable, "-m", "pinel_desktop", *arguments]
