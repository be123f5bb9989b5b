"""The HTTP interface, one file per resource."""

from typing import Any

from flask_openapi3.blueprint import APIBlueprint
from flask_openapi3.models.tag import Tag
from flask_openapi3.types import ResponseDict
from pydantic import BaseModel

from pinel_desktop.web.models.errors import ErrorAnswer

_EVERYWHERE = (400, 401, 403, 421, 422, 500)


def resource(name: str, about: str, import_name: str) -> APIBlueprint:
    """A blueprint under `/api` whose operations are described with the errors that any route may answer."""
    return APIBlueprint(
        name,
        import_name,
        url_prefix="/api",
        abp_tags=[Tag(name=name, description=about)],
        abp_responses=dict.fromkeys(_EVERYWHERE, ErrorAnswer),
        operation_id_callback=_camel_case,
    )


def _camel_case(**operation: Any) -> str:
    """`create_group` -> `createGroup`: the name of the page's function."""
    first, *others = str(operation["name"]).split("_")
    return first + "".join(word.capitalize() for word in others)


def answers(good: type[BaseModel] | dict[str, Any], *statuses: int) -> ResponseDict:
    """Descriptions of the good answer and of the errors that this operation may answer besides the usual."""
    return {200: good, **dict.fromkeys(statuses, ErrorAnswer)}
