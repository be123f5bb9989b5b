"""The window's navigation policy, which allows its own page only, and its size. PURE."""

from dataclasses import dataclass
from typing import Literal
from urllib.parse import urlsplit

Verdict = Literal["show", "save", "refuse"]

SMALLEST = (1024, 640)
LARGEST = (1600, 1000)
# on screens up to this size, such as 1366 x 768, the window is maximised
_MAXIMIZE_UP_TO = (1440, 900)


@dataclass(frozen=True, slots=True)
class Size:
    """Width, height and minimum size of the window in pixels, and whether it is maximised."""

    width: int
    height: int
    smallest: tuple[int, int]
    maximized: bool


def may_open(address: str, own: str) -> bool:
    """True if `address` has the scheme, host and port of `own`."""
    try:
        there, here = urlsplit(address), urlsplit(own)
        return (there.scheme, there.hostname, there.port) == (here.scheme, here.hostname, here.port)
    except ValueError:
        return False


def verdict_on(address: str, own: str) -> Verdict:
    """What to do with a navigation to `address`: show the page, save files created by it, refuse all else."""
    if address == "about:blank" or may_open(address, own):
        return "show"
    scheme, _, made_by = address.partition(":")
    return "save" if scheme == "blob" and may_open(made_by, own) else "refuse"


def fitted_size(screen_width: int, screen_height: int) -> Size:
    """The window's size on a screen given in pixels: all of a small screen, most of a large one."""
    smallest = (min(SMALLEST[0], screen_width), min(SMALLEST[1], screen_height))
    maximized = screen_width <= _MAXIMIZE_UP_TO[0] or screen_height <= _MAXIMIZE_UP_TO[1]
    if maximized:
        return Size(screen_width, screen_height, smallest, maximized)
    width = min(LARGEST[0], screen_width * 85 // 100)
    height = min(LARGEST[1], screen_height * 85 // 100)
    return Size(width, height, smallest, maximized)
