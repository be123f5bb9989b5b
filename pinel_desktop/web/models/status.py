"""State of the app and its settings."""

from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, ValidationInfo, WithJsonSchema, create_model, field_validator

from pinel_desktop.messages import LANGUAGES
from pinel_desktop.settings import MAX_TEXT, SETTINGS, TEXT, Setting
from pinel_desktop.web.models import Id, RequestModel, ResponseModel
from pinel_desktop.web.models.errors import Notice

# without the languages, so that one more changes neither the description nor the page's types
_LANGUAGE_SCHEMA = WithJsonSchema(
    {"type": "string", "description": "tag of a language of the catalogue"}
)
OF_PAGE = {name: setting for name, setting in SETTINGS.items() if setting.of_page}

if TYPE_CHECKING:
    Language = str
    Name = str
else:
    Language = Annotated[Literal[LANGUAGES], _LANGUAGE_SCHEMA]
    Name = Literal[tuple(OF_PAGE)]


class DatabaseStatus(ResponseModel):
    """The path of the database, and whether it can be written."""

    path: str
    writable: bool
    notice: Notice | None


class Status(ResponseModel):
    """State of app, engine and database; the page's first request."""

    app_version: str
    engine: Literal["starting", "ready", "lost"]
    run: Id | None
    database: DatabaseStatus
    language: Language


class LicenceNotices(ResponseModel):
    """The works of others that the package contains, with their licences; empty if this program is not packaged."""

    text: str


class Settings(RequestModel):
    """Settings of the page."""

    language: Language


def _field(setting: Setting) -> Any:
    """Returns the type of a setting's value, with its default."""
    kind: Any = str if setting.values is None else Literal[(setting.default, *setting.values)]
    if setting.values is LANGUAGES:
        kind = Annotated[kind, _LANGUAGE_SCHEMA]
    return (Annotated[kind, Field(description=setting.about)], setting.default)


PageSettings = create_model(
    "PageSettings",
    __base__=ResponseModel,
    __doc__="Settings of this PC, with which the page is served: JSON in `data-settings` of its root.",
    **{name: _field(setting) for name, setting in OF_PAGE.items()},
)


class PageSetting(RequestModel):
    """A setting of the page, stored on this PC; an empty value resets it."""

    name: Name
    value: Annotated[str, Field(pattern=TEXT, max_length=MAX_TEXT)]

    @field_validator("value")
    @classmethod
    def _is_allowed(cls, value: str, info: ValidationInfo) -> str:
        name = info.data.get("name")
        if name is not None and value and not SETTINGS[name].allows(value):
            raise ValueError(f"{name} is never {value}")
        return value


class InstanceLink(ResponseModel):
    """A new address that opens the page once."""

    url: str
