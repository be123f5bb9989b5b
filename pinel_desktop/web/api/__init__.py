"""The HTTP interface, one file per resource."""

from collections.abc import Callable
from typing import Any

from flask_openapi3.blueprint import APIBlueprint
from flask_openapi3.models import Tag

from pinel_desktop.web.models.errors import ErrorAnswer

_EVERYWHERE = {401: ErrorAnswer, 403: ErrorAnswer, 421: ErrorAnswer, 422: ErrorAnswer, 500: ErrorAnswer}


def resource(name: str, about: str, import_name: str) -> APIBlueprint:
    """A blueprint under `/api` whose operations are described with the errors that any route may answer."""
    return APIBlueprint(
        name,
        import_name,
        url_prefix="/api",
        abp_tags=[Tag(name=name, description=about)],
        abp_responses=dict(_EVERYWHERE),
        operation_id_callback=_camel_case,
    )


def _camel_case(**operation: Any) -> str:
    """`create_group` -> `createGroup`: the name of the page's function."""
    first, *others = str(operation["name"]).split("_")
    return first + "".join(word.capitalize() for word in others)


Answers = dict[int, Any]
View = Callable[..., Any]


def errors(*statuses: int) -> Answers:
    """Descriptions of the further errors that an operation may answer."""
    return {status: ErrorAnswer for status in statuses}
