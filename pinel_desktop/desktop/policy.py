"""The window's navigation policy, which allows its own page only, its reloads after a crash, and its size. PURE."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, Protocol, TypeVar
from urllib.parse import urlsplit

NavigationDecision = Literal["show", "save", "refuse"]

MIN_SIZE = (1024, 640)
MAX_SIZE = (1600, 1000)
# on screens up to this size, such as 1366 x 768, the window is maximised
_MAXIMIZE_UP_TO = (1440, 900)
MAX_RELOADS = 3
_PERIOD_S = 60.0
# one crash may be noticed several times
_SAME_S = 2.0


@dataclass(frozen=True, slots=True)
class Size:
    """Width, height and minimum size of the window in pixels, and whether it is maximised."""

    width: int
    height: int
    min_size: tuple[int, int]
    maximized: bool


class Area(Protocol):
    """A rectangle of the desktop, such as a screen; pixels."""

    x: int
    y: int
    width: int
    height: int


_Screen = TypeVar("_Screen", bound=Area)


def second_screen(screens: Sequence[_Screen], at: tuple[int, int]) -> _Screen | None:
    """Returns the first screen that does not show the point `at`; None if every screen shows it."""
    for one in screens:
        if not (one.x <= at[0] < one.x + one.width and one.y <= at[1] < one.y + one.height):
            return one
    return None


def may_open(address: str, own: str) -> bool:
    """Returns whether `address` has the scheme, host and port of `own`."""
    try:
        there, here = urlsplit(address), urlsplit(own)
        return (there.scheme, there.hostname, there.port) == (here.scheme, here.hostname, here.port)
    except ValueError:
        return False


def decide_navigation(address: str, own: str) -> NavigationDecision:
    """Decides about a navigation to `address`: show the page, save files created by the page, refuse all else."""
    if may_open(address, own):
        return "show"
    scheme, _, made_by = address.partition(":")
    return "save" if scheme == "blob" and may_open(made_by, own) else "refuse"


class ReloadLimit:
    """Limits how often the page is loaded again after a crash, because a page may cause one each time."""

    def __init__(self) -> None:
        self._times_s: list[float] = []

    def next_wait_s(self, now_s: float) -> float | None:
        """Returns how long to wait before the next reload, and counts it; None if one is due within `_SAME_S`.

        At most `MAX_RELOADS` take place within `_PERIOD_S`; later ones wait.
        """
        self._times_s = [time_s for time_s in self._times_s if now_s - time_s < _PERIOD_S]
        if self._times_s and now_s < self._times_s[-1] + _SAME_S:
            return None
        is_free = len(self._times_s) < MAX_RELOADS
        due_s = now_s if is_free else self._times_s[-MAX_RELOADS] + _PERIOD_S
        self._times_s.append(due_s)
        return due_s - now_s


def fitted_size(screen_width: int, screen_height: int) -> Size:
    """Returns the window's size for a screen in pixels: all of a small screen, 85 % of a large one up to `MAX_SIZE`."""
    min_size = (min(MIN_SIZE[0], screen_width), min(MIN_SIZE[1], screen_height))
    maximized = screen_width <= _MAXIMIZE_UP_TO[0] or screen_height <= _MAXIMIZE_UP_TO[1]
    if maximized:
        return Size(screen_width, screen_height, min_size, maximized)
    width = min(MAX_SIZE[0], screen_width * 85 // 100)
    height = min(MAX_SIZE[1], screen_height * 85 // 100)
    return Size(width, height, min_size, maximized)
