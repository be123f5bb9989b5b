"""Shapes of every body and every answer of the HTTP interface; the OpenAPI description is made from them."""

from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field


def _writable(text: str) -> str:
    """A lone surrogate can stand in JSON, but no store can be asked for it."""
    text.encode()
    return text


Id = Annotated[str, AfterValidator(_writable), Field(description="UUIDv7 text")]
Time = Annotated[str, Field(description="ISO 8601 in UTC")]
Json = Annotated[dict[str, Any], Field(description="any JSON object")]


# Whoever starts the app waits for this module, and needs few of its models: each is built when it is first used.
_LATER = ConfigDict(defer_build=True)


class Shape(BaseModel):
    """Base of all answers."""

    model_config = _LATER | ConfigDict(extra="forbid")


class Body(BaseModel):
    """Base of all that is sent, bodies and queries.

    Unknown keys are refused, so that a typing mistake does not pass unseen.
    """

    model_config = _LATER | ConfigDict(extra="forbid")


class IdPath(BaseModel):
    """The `{id}` of an address."""

    model_config = _LATER

    id: Id


class Empty(Shape):
    """`{}`: it was done."""
