"""Where the window may go: to its own page, and nowhere else. And how large it opens."""

from dataclasses import dataclass
from typing import Literal
from urllib.parse import urlsplit

Verdict = Literal["show", "save", "refuse"]

SMALLEST = (1024, 640)
LARGEST = (1600, 1000)
# A lab's screen of 1366 x 768 has no room to give away around a window.
_FILL_UP_TO = (1440, 900)


@dataclass(frozen=True, slots=True)
class Size:
    """Width and height in pixels, the least that the person may make of them, and whether to fill the screen."""

    width: int
    height: int
    smallest: tuple[int, int]
    maximized: bool


def may_open(address: str, own: str) -> bool:
    """Whether `address` has the scheme, host and port of `own`."""
    try:
        there, here = urlsplit(address), urlsplit(own)
        return (there.scheme, there.hostname, there.port) == (here.scheme, here.hostname, here.port)
    except ValueError:
        return False


def judged(address: str, own: str) -> Verdict:
    """What to do with an address that the window is to go to: files that the page hands out are saved, not shown."""
    if address == "about:blank" or may_open(address, own):
        return "show"
    scheme, _, made_by = address.partition(":")
    return "save" if scheme == "blob" and may_open(made_by, own) else "refuse"


def fitted_size(screen_width: int, screen_height: int) -> Size:
    """The size for a screen: all of a small one, most of a large one."""
    smallest = (min(SMALLEST[0], screen_width), min(SMALLEST[1], screen_height))
    maximized = screen_width <= _FILL_UP_TO[0] or screen_height <= _FILL_UP_TO[1]
    if maximized:
        return Size(screen_width, screen_height, smallest, maximized)
    width = min(LARGEST[0], screen_width * 85 // 100)
    height = min(LARGEST[1], screen_height * 85 // 100)
    return Size(width, height, smallest, maximized)
