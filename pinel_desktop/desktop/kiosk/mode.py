"""How a window opens in kiosk mode."""

import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

# who decided: the teacher's setting of this PC, or `pinel --kiosk`, such as in a session that runs nothing else
KioskReason = Literal["setting", "command"]


@dataclass(frozen=True, slots=True)
class KioskMode:
    """The kiosk mode of a window.

    Attributes:
        place: the place where the page opens, the part of its address after "#".
        on_place: called with the new place after each change.
        print_allowed: set it to let the page open the print dialog once.
    """

    reason: KioskReason
    place: str
    on_place: Callable[[str], None]
    print_allowed: threading.Event = field(default_factory=threading.Event)
