"""State of the app and its settings."""

from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import Field

from pinel_desktop.messages import LANGUAGES
from pinel_desktop.page_settings import MAX_NAME, MAX_VALUE, NAME, VALUE
from pinel_desktop.web.models import Body, Id, Shape
from pinel_desktop.web.models.errors import Notice

if TYPE_CHECKING:
    Language = str
else:
    Language = Literal[LANGUAGES]


class DatabaseStatus(Shape):
    """The path of the database, and whether it can be written."""

    path: str
    writable: bool
    notice: Notice | None


class Status(Shape):
    """State of app, engine and database; the page's first request."""

    app_version: str
    engine: Literal["starting", "ready", "lost"]
    run: Id | None
    database: DatabaseStatus
    language: Language


class Settings(Body):
    """Settings of the page."""

    language: Language


class PageSetting(Body):
    """A setting that the page keeps on this PC; an empty value forgets it."""

    name: Annotated[str, Field(pattern=NAME, max_length=MAX_NAME)]
    value: Annotated[str, Field(pattern=VALUE, max_length=MAX_VALUE)]


class InstanceLink(Shape):
    """A new address that opens the page once."""

    url: str
