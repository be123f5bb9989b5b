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
"""Codes of a route that writes to the database."""
OCTETS = {
    "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}}
}
"""An answer that is a file."""


class Resource(APIBlueprint):
    """A blueprint whose operations are described when somebody asks.

    The schemas of all answers cost as much time as the rest of the app's start, and the page never asks.
    """

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self._undescribed: list[Callable[[], object]] = []

    def describe(self) -> None:
        """Makes the descriptions of all operations; the second time there is nothing left to do."""
        while self._undescribed:
            self._undescribed.pop(0)()

    def _collect_openapi_info(
        self, rule: str, func: Callable[..., Any], **options: Any
    ) -> ParametersTuple:
        collect = super()._collect_openapi_info
        self._undescribed.append(lambda: collect(rule, func, **options))
        return collect(rule, func, **{**options, "doc_ui": False})


def resource(name: str, about: str, import_name: str) -> Resource:
    """A blueprint under `/api` whose operations are described with the errors that any route may answer."""
    return Resource(
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


def answers(good: type[BaseModel] | dict[str, Any], *codes: str) -> ResponseDict:
    """Descriptions of the good answer, and of the errors of this route besides those of every route.

    Args:
        codes: codes of these errors; the status of each follows from its code.
    """
    by_status: dict[int, list[str]] = {}
    for code in codes:
        by_status.setdefault(status_of(code), []).append(f"`{code}`")
    errors: ResponseDict = {
        status: {"description": ", ".join(found), "content": _ERROR}
        for status, found in by_status.items()
    }
    return {200: good, **errors}
