"""The OpenAPI 3.1 description of all routes, generated at the first request for it.

flask-openapi3 derives it from the models that validate the bodies, so it cannot differ from the code. It was chosen
over apiflask (marshmallow first) and spectree (no OpenAPI 3.1). The app starts without it, because its import is slow.
"""

import json
from functools import cache
from typing import Any

from flask_openapi3.blueprint import APIBlueprint
from flask_openapi3.models.info import Info
from flask_openapi3.models.tag import Tag
from flask_openapi3.openapi import OpenAPI
from pydantic import BaseModel

from pinel_desktop import __version__
from pinel_desktop.web.api import Resource, stream
from pinel_desktop.web.models.errors import ErrorAnswer
from pinel_desktop.web.models.status import PageSettings
from pinel_desktop.web.routes import RESOURCES

_EVERYWHERE = (400, 401, 403, 421, 422, 500)
_REFERENCE = "#/components/schemas/{model}"


@cache
def description_text() -> str:
    """The description as JSON text, deterministic."""
    return json.dumps(description(), indent=2, sort_keys=True, ensure_ascii=False) + "\n"


def description() -> dict[str, Any]:
    """The description as a dict."""
    api = OpenAPI(
        __name__,
        info=Info(title="PINEL Desktop", version=__version__),
        doc_ui=False,
        static_folder=None,
        validation_error_model=ErrorAnswer,
        security_schemes={"cookie": {"type": "apiKey", "in": "cookie", "name": "pinel_PORT"}},
        openapi_extensions={"security": [{"cookie": []}]},
    )
    for module in RESOURCES:
        _describe(api, module.api)
    document: dict[str, Any] = api.api_doc
    document["components"]["schemas"] |= _schemas((*stream.MODELS, PageSettings))
    return document


def _describe(api: OpenAPI, resource: Resource) -> None:
    """Adds a resource. Merges paths that two resources share, because the library would use only the last one."""
    described = APIBlueprint(
        resource.name,
        resource.import_name,
        url_prefix=resource.url_prefix,
        abp_tags=[Tag(name=resource.name, description=resource.about)],
        abp_responses=dict.fromkeys(_EVERYWHERE, ErrorAnswer),
        operation_id_callback=_camel_case,
    )
    for one in resource.operations:
        add = getattr(described, one.method.lower())
        add(one.rule, responses=one.responses)(one.handler)
    before = {path: item.model_copy() for path, item in api.paths.items()}
    api.register_api(described)
    for path in before.keys() & api.paths.keys():
        added = {name: value for name, value in api.paths[path] if value is not None}
        api.paths[path] = before[path].model_copy(update=added)


def _camel_case(**operation: Any) -> str:
    """Operation id of a handler: `create_group` -> `createGroup`."""
    first, *others = str(operation["name"]).split("_")
    return first + "".join(part.capitalize() for part in others)


def _schemas(models: tuple[type[BaseModel], ...]) -> dict[str, Any]:
    """Schemas of models that no JSON answer refers to, such as stream events."""
    found: dict[str, Any] = {}
    for model in models:
        schema = model.model_json_schema(ref_template=_REFERENCE, mode="serialization")
        found |= schema.pop("$defs", {})
        found[model.__name__] = schema
    return found
