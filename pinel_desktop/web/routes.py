"""All routes of the API, and their OpenAPI 3.1 description.

flask-openapi3 derives the description from the models that validate the bodies, so it cannot differ from the code. It
was chosen over apiflask (marshmallow first) and spectree (no OpenAPI 3.1).
"""

import json
from functools import cache
from typing import Any

from flask_openapi3.models.info import Info
from flask_openapi3.openapi import OpenAPI
from pydantic import BaseModel

from pinel_desktop import __version__
from pinel_desktop.web.api import (
    Resource,
    activities,
    camera,
    classrooms,
    exchange,
    groups,
    history,
    instance,
    notes,
    programs,
    python,
    removal,
    review,
    runs,
    signs,
    status,
    stream,
    teacher,
    versions,
    worlds,
)
from pinel_desktop.web.api.preparing import lesson_files, own_activities, robots
from pinel_desktop.web.errors import invalid_request
from pinel_desktop.web.models.errors import ErrorAnswer

_RESOURCES = (
    status,
    teacher,
    classrooms,
    groups,
    activities,
    own_activities,
    programs,
    versions,
    runs,
    history,
    review,
    notes,
    exchange,
    lesson_files,
    removal,
    python,
    worlds,
    robots,
    camera,
    signs,
    stream,
    instance,
)
_REFERENCE = "#/components/schemas/{model}"


def app_with_routes() -> OpenAPI:
    """A Flask app with the routes only, without services, guard and page; sufficient for the description."""
    app = OpenAPI(
        __name__,
        info=Info(title="PINEL Desktop", version=__version__),
        doc_ui=False,
        static_folder=None,
        validation_error_model=ErrorAnswer,
        validation_error_callback=invalid_request,
        security_schemes={"cookie": {"type": "apiKey", "in": "cookie", "name": "pinel_PORT"}},
        openapi_extensions={"security": [{"cookie": []}]},
    )
    for module in _RESOURCES:
        _register(app, module.api)
    return app


def description() -> dict[str, Any]:
    """The OpenAPI description as a dict."""
    for module in _RESOURCES:
        module.api.describe()
    document: dict[str, Any] = app_with_routes().api_doc
    document["components"]["schemas"] |= _schemas(stream.MODELS)
    return document


def _register(app: OpenAPI, api: Resource) -> None:
    """Registers a resource. Merges paths shared by two resources, of which the library would keep only the last."""
    before = {path: item.model_copy() for path, item in app.paths.items()}
    app.register_api(api)
    for path in before.keys() & app.paths.keys():
        added = {name: value for name, value in app.paths[path] if value is not None}
        app.paths[path] = before[path].model_copy(update=added)


@cache
def description_text() -> str:
    """The OpenAPI description as JSON text, deterministic."""
    return json.dumps(description(), indent=2, sort_keys=True, ensure_ascii=False) + "\n"


def _schemas(models: tuple[type[BaseModel], ...]) -> dict[str, Any]:
    """Schemas of models that no JSON answer refers to, such as stream events."""
    found: dict[str, Any] = {}
    for model in models:
        schema = model.model_json_schema(ref_template=_REFERENCE, mode="serialization")
        found |= schema.pop("$defs", {})
        found[model.__name__] = schema
    return found
