"""The HTTP interface, one file per resource."""

from dataclasses import dataclass
from typing import Any

from flask import Blueprint
from pydantic import BaseModel

from pinel_desktop.web.arguments import Handler, with_arguments
from pinel_desktop.web.responses import status_of

Responses = dict[int, type[BaseModel] | dict[str, Any]]

_ERROR = {"application/json": {"schema": {"$ref": "#/components/schemas/ErrorAnswer"}}}

TEACHER = ("teacher_only", "pin_missing")
"""Codes of a route that only the teacher may call; its handler begins with `require_teacher`."""
WRITES = (
    "database_locked",
    "database_locked_at_start",
    "database_read_only",
    "disk_full",
    "disk_full_at_start",
)
"""Error codes of routes that write to the database."""
OCTETS = {
    "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}}
}
"""An answer with a file."""


@dataclass(frozen=True)
class Operation:
    """A route as its handler declares it, for the OpenAPI description."""

    method: str
    rule: str
    handler: Handler
    responses: Responses


class Resource(Blueprint):
    """A blueprint under `/api` whose handlers are called with the validated parts of the request (`arguments.py`).

    `@api.get(rule, responses=answers(...))` declares a route.

    Attributes:
        about: title of the resource, for the OpenAPI description.
        operations: the routes in the order of their declaration.
    """

    def __init__(self, name: str, about: str, import_name: str) -> None:
        super().__init__(name, import_name, url_prefix="/api")
        self.about = about
        self.operations: list[Operation] = []

    def add_url_rule(
        self,
        rule: str,
        endpoint: str | None = None,
        view_func: Any = None,
        *args: Any,
        **options: Any,
    ) -> None:
        """Called by Flask's decorators."""
        (method,) = options["methods"]
        self.operations.append(Operation(method, rule, view_func, options.pop("responses")))
        super().add_url_rule(rule, endpoint, with_arguments(view_func), *args, **options)


def responses(good: type[BaseModel] | dict[str, Any], *codes: str) -> Responses:
    """Declares a route's successful response and its own errors.

    Args:
        codes: error codes of this route, besides the codes of all routes; each code has a fixed status.
    """
    by_status: dict[int, list[str]] = {}
    for code in codes:
        by_status.setdefault(status_of(code), []).append(f"`{code}`")
    errors: Responses = {
        status: {"description": ", ".join(found), "content": _ERROR}
        for status, found in by_status.items()
    }
    return {200: good, **errors}
