"""Serialises the events of a run as numbered JSON objects, which are sent and stored."""

from dataclasses import asdict, dataclass
from typing import Any

from pinel_desktop.events.model import Event

SCHEMA_VERSION = 1


@dataclass(slots=True)
class EventSequencer:
    """Turns the events of one run into wire objects and numbers them from `next_seq`."""

    run: str
    next_seq: int = 0

    def wire(self, tick: int, event: Event) -> dict[str, Any]:
        """Returns the event as the flat JSON object of docs/events.md."""
        head = {
            "v": SCHEMA_VERSION,
            "type": event.type,
            "run": self.run,
            "seq": self.next_seq,
            "tick": tick,
        }
        self.next_seq += 1
        return {**head, **asdict(event)}
