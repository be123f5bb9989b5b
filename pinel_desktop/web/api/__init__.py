"""The HTTP interface, one file per resource."""

from collections.abc import Callable
from typing import Any

from flask_openapi3.blueprint import APIBlueprint
from flask_openapi3.models.tag import Tag
from flask_openapi3.types import ParametersTuple, ResponseDict
from pydantic import BaseModel

from pinel_desktop.web.models.errors import ErrorAnswer
from pinel_desktop.web.responses import status_of

_EVERYWHERE = (400, 401, 403, 421, 422, 500)
_ERROR = {"application/json": {"schema": {"$ref": "#/components/schemas/ErrorAnswer"}}}

TEACHER = ("teacher_only", "pin_missing")
"""Codes of a route that only the teacher may call; its handler begins with `require_teacher`."""
WRITES = ("database_locked", "database_read_only", "disk_full")
"""Error codes of routes that write to the database."""
OCTETS = {
    "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}}
}
"""An answer with a file."""


class Resource(APIBlueprint):
    """A blueprint that builds its OpenAPI description on demand.

    Building all schemas takes as long as the rest of the app's start, and the page does not need them.
    """

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self._undescribed: list[Callable[[], object]] = []

    def describe(self) -> None:
        """Builds the descriptions of all operations; does nothing on later calls."""
        while self._undescribed:
            self._undescribed.pop(0)()

    def _collect_openapi_info(
        self, rule: str, func: Callable[..., Any], **options: Any
    ) -> ParametersTuple:
        collect = super()._collect_openapi_info
        self._undescribed.append(lambda: collect(rule, func, **options))
        return collect(rule, func, **{**options, "doc_ui": False})


def resource(name: str, about: str, import_name: str) -> Resource:
    """A blueprint under `/api`; all its operations declare the errors that any route may answer."""
    return Resource(
        name,
        import_name,
        url_prefix="/api",
        abp_tags=[Tag(name=name, description=about)],
        abp_responses=dict.fromkeys(_EVERYWHERE, ErrorAnswer),
        operation_id_callback=_camel_case,
    )


def _camel_case(**operation: Any) -> str:
    """Operation id of a handler: `create_group` -> `createGroup`."""
    first, *others = str(operation["name"]).split("_")
    return first + "".join(word.capitalize() for word in others)


def answers(good: type[BaseModel] | dict[str, Any], *codes: str) -> ResponseDict:
    """Declares a route's successful answer and its own errors.

    Args:
        codes: error codes of this route, besides those of all routes; each code has a fixed status.
    """
    by_status: dict[int, list[str]] = {}
    for code in codes:
        by_status.setdefault(status_of(code), []).append(f"`{code}`")
    errors: ResponseDict = {
        status: {"description": ", ".join(found), "content": _ERROR}
        for status, found in by_status.items()
    }
    return {200: good, **errors}
