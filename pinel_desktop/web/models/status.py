"""State of the app and its settings."""

from typing import TYPE_CHECKING, Literal

from pinel_desktop.messages import LANGUAGES
from pinel_desktop.web.models import Body, Id, Shape
from pinel_desktop.web.models.errors import Notice

if TYPE_CHECKING:
    Language = str
else:
    Language = Literal[LANGUAGES]


class DatabaseStatus(Shape):
    """Where the work is kept, and whether it can be kept now."""

    path: str
    writable: bool
    notice: Notice | None


class Status(Shape):
    """What the page asks for first."""

    app_version: str
    engine: Literal["starting", "ready", "lost"]
    run: Id | None
    database: DatabaseStatus
    language: Language


class Settings(Body):
    """What a person may choose."""

    language: Language


class InstanceLink(Shape):
    """A fresh address that opens the page once."""

    url: str
