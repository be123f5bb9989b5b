"""How this program starts itself again, for the parts that run in processes of their own."""

import sys


def own_command(*arguments: str) -> list[str]:
    """The packaged program itself, or this Python with the package."""
    if getattr(sys, "frozen", False):
        return [sys.executable, *arguments]
    return [sys.executable, "-m", "pinel_desktop", *arguments]
