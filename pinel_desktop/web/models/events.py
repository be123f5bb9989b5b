"""Wire models of events, derived from their declarations in `pinel_desktop/events`."""

import inspect
import re
from dataclasses import MISSING
from functools import cache, reduce
from operator import or_
from types import UnionType
from typing import (
    Annotated,
    Any,
    ClassVar,
    Literal,
    Union,
    get_args,
    get_origin,
    get_type_hints,
    is_typeddict,
)

from pydantic import ConfigDict, Field, GetCoreSchemaHandler, RootModel, create_model
from pydantic_core import CoreSchema

from pinel_desktop.events.model import NullIfInterrupted
from pinel_desktop.events.model import StreamEvent as Declared
from pinel_desktop.events.types import APP_EVENTS, RUN_EVENTS
from pinel_desktop.web.models import DEFERRED, Id, ResponseModel


class RunEvent(ResponseModel):
    """Fields of every event of a run; time in s is tick / 30. Recorded events may lack fields that have a default."""

    model_config = ConfigDict(json_schema_serialization_defaults_required=False)

    v: Literal[1]
    run: Id
    seq: int
    tick: int


def described(declaration: type) -> tuple[str, dict[str, str]]:
    """Returns the docstring of an event without its `Attributes`, and the descriptions of these by name."""
    about, _, attributes = (inspect.getdoc(declaration) or "").partition("\n\nAttributes:\n")
    found = re.findall(r"^    (\w+): (.+(?:\n     .+)*)", attributes, re.M)
    return about, {name: " ".join(text.split()) for name, text in found}


def _model(
    declaration: type, name: str, base: type[ResponseModel], **head: Any
) -> type[ResponseModel]:
    about, meanings = described(declaration)
    declared = getattr(declaration, "__dataclass_fields__", {})
    fields: dict[str, Any] = dict(head)
    for field, hint in get_type_hints(declaration, include_extras=True).items():
        if get_origin(hint) is ClassVar:
            continue
        described_as: dict[str, Any] = {"description": meanings.get(field)}
        if field in declared and declared[field].default is not MISSING:
            # optional without a default value, else the page's types would not be optional
            described_as["default_factory"] = lambda: None
        fields[field] = (_wire(hint), Field(**described_as))
    return create_model(name, __base__=base, __doc__=about, __module__=__name__, **fields)


@cache
def _object(declaration: type) -> type[ResponseModel]:
    return _model(declaration, declaration.__name__, ResponseModel)


def _wire(hint: Any) -> Any:
    """Returns the wire type of a field: TypedDicts become models, and `NullIfInterrupted` fields may be null."""
    if is_typeddict(hint):
        return _object(hint)
    origin, parts = get_origin(hint), get_args(hint)
    if origin is Annotated and any(isinstance(part, NullIfInterrupted) for part in parts):
        return parts[0] | None
    if origin is UnionType:
        return reduce(or_, map(_wire, parts))
    return origin[tuple(map(_wire, parts))] if origin in (list, dict) else hint


class _OneOf:
    """A lazy union of the models of declared events.

    The description and the tests build the models when they first need the schema; the app's start does not.
    """

    def __init__(self, *declared: dict[str, Any]) -> None:
        self._declared = declared

    def __get_pydantic_core_schema__(
        self, _source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        models = tuple(_event(cls) for declared in self._declared for cls in declared.values())
        return handler.generate_schema(
            Annotated[Union[models], Field(discriminator="type")]  # noqa: UP007 - made of a tuple
        )


@cache
def _event(declaration: type[Declared]) -> type[ResponseModel]:
    base = RunEvent if declaration.type in RUN_EVENTS else ResponseModel
    name = f"{declaration.__name__}Event"
    return _model(declaration, name, base, type=(Literal[declaration.type], ...))


# `RootModel[SomeType]` would be built at once, in spite of `defer_build`.
class Event(RootModel[Any]):
    """One event of a run."""

    model_config = DEFERRED

    root: Annotated[Any, _OneOf(RUN_EVENTS)]


class StreamEvent(RootModel[Any]):
    """The content of one `data:` line of the stream."""

    model_config = DEFERRED

    root: Annotated[Any, _OneOf(RUN_EVENTS, APP_EVENTS)]
