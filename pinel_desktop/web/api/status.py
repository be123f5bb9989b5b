"""State of the app, and settings."""

import contextlib

from flask import Response

from pinel_desktop.errors import PinelError
from pinel_desktop.paths import notices_file, read_regular
from pinel_desktop.settings import LANGUAGE
from pinel_desktop.web.api import Resource, responses
from pinel_desktop.web.models.status import (
    DatabaseStatus,
    LicenceNotices,
    PageSetting,
    Settings,
    Status,
)
from pinel_desktop.web.responses import json_response, notice
from pinel_desktop.web.services import Services, services

api = Resource("status", "State of the app and its settings.", __name__)


@api.get("/status", responses=responses(Status))
def get_status() -> Response:
    """State of app, engine and database."""
    return json_response(_status(services()))


def _status(parts: Services) -> Status:
    return Status(
        app_version=parts.app_version,
        engine=parts.engine.state,
        run=parts.engine.live_run,
        database=_database(parts),
        language=parts.settings.language,
    )


def _database(parts: Services) -> DatabaseStatus:
    state = parts.database_state()
    problem = state.notice
    shown = (
        None if problem is None else notice(problem.code, problem.params, parts.settings.language)
    )
    return DatabaseStatus(path=state.path, writable=state.writable, notice=shown)


@api.get("/notices", responses=responses(LicenceNotices))
def get_notices() -> Response:
    """The licence notices of the works of others in this package."""
    text = ""
    if file := notices_file():
        with contextlib.suppress(OSError):
            text = read_regular(file).decode("utf-8", "replace")
    return json_response(LicenceNotices(text=text))


@api.post("/database/begin-empty", responses=responses(Status, "database_not_missing"))
def begin_empty() -> Response:
    """Makes the next start use an empty database if the known folder is unreachable; deletes nothing."""
    problem = services().database_state().notice
    if problem is None or problem.code not in ("database_place_missing", "database_begins_empty"):
        raise PinelError("database_not_missing")
    services().begin_empty()
    return json_response(_status(services()))


@api.put("/settings", responses=responses(Settings))
def put_settings(body: Settings) -> Response:
    """Sets the language of page and messages."""
    services().settings.choose(LANGUAGE, body.language)
    return json_response(body)


@api.put("/settings/page", responses=responses(PageSetting))
def put_page_setting(body: PageSetting) -> Response:
    """Stores a setting of the page on this PC. The page is served with all of them (`PageSettings`)."""
    services().settings.choose(body.name, body.value)
    return json_response(body)
