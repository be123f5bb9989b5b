"""How a window opens in kiosk mode."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

PRINT_PERMISSION_S = 120.0

# who decided: the teacher's setting of this PC, or `pinel --kiosk`, such as in a session that runs nothing else
KioskReason = Literal["setting", "command"]


class PrintPermission:
    """The teacher's permission to open the print dialog: once, and within `PRINT_PERMISSION_S`. Thread-safe."""

    def __init__(self, now_s: Callable[[], float] = time.monotonic) -> None:
        self._now_s = now_s
        self._until_s = -1.0

    def grant(self) -> None:
        """Allows the next print dialog."""
        self._until_s = self._now_s() + PRINT_PERMISSION_S

    def use(self) -> bool:
        """Returns whether a print dialog may open now, and ends the permission."""
        until_s, self._until_s = self._until_s, -1.0
        return self._now_s() < until_s


@dataclass(frozen=True, slots=True)
class KioskMode:
    """The kiosk mode of a window.

    Attributes:
        place: the place where the page opens, the part of its address after "#".
        on_place: called with the new place after each change.
        print_permission: grant it to let the page open the print dialog once.
    """

    reason: KioskReason
    place: str
    on_place: Callable[[str], None]
    print_permission: PrintPermission = field(default_factory=PrintPermission)
