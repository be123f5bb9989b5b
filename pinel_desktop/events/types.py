"""Registry of all events by name, and the event names that have each trait (recorded, lossy, urgent)."""

from typing import Any, Literal

from pinel_desktop.events import app_events, model  # noqa: F401 - declares them
from pinel_desktop.events.model import Event, StreamEvent


def _declared(base: type[Any]) -> dict[str, type[Any]]:
    """Returns the subclasses of `base` by event name.

    `dataclass(slots=True)` creates a second class, so `__subclasses__` may list both; the later one is the right one.
    """
    return {cls.type: cls for cls in base.__subclasses__() if hasattr(cls, "type")}


RUN_EVENTS: dict[str, type[Event]] = _declared(Event)
APP_EVENTS: dict[str, type[StreamEvent]] = _declared(StreamEvent)


def _types_that_are(trait: Literal["is_recorded", "lossy", "urgent"]) -> frozenset[str]:
    declared = RUN_EVENTS | APP_EVENTS
    return frozenset(name for name, cls in declared.items() if getattr(cls, trait))


RECORDED = _types_that_are("is_recorded")
LOSSY = _types_that_are("lossy")
URGENT = _types_that_are("urgent")
