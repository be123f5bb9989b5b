"""Shapes of every body and every answer of the HTTP interface; the OpenAPI description is made from them."""

from typing import Annotated, Any, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field


def _writable(text: str) -> str:
    """A lone surrogate can stand in JSON, but no store can be asked for it."""
    text.encode()
    return text


Id = Annotated[str, AfterValidator(_writable), Field(description="UUIDv7 text")]
Time = Annotated[str, Field(description="ISO 8601 in UTC")]
Json = Annotated[dict[str, Any], Field(description="any JSON object")]


# Whoever starts the app waits for this module, and needs few of its models: each is built when it is first used.
LATER = ConfigDict(defer_build=True)


class Shape(BaseModel):
    """Base of all answers. A field with a default is there in every answer."""

    model_config = LATER | ConfigDict(
        extra="forbid", json_schema_serialization_defaults_required=True
    )

    @classmethod
    def of(cls, row: object, **more: Any) -> Self:
        """The answer for a row of the store, whose fields have the same names.

        Args:
            more: fields that the row does not have, or has in another form.
        """
        own = {name: getattr(row, name) for name in cls.model_fields if name not in more}
        return cls.model_validate({**own, **more}, from_attributes=True)


class Body(BaseModel):
    """Base of all that is sent, bodies and queries.

    Unknown keys are refused, so that a typing mistake does not pass unseen.
    """

    model_config = LATER | ConfigDict(extra="forbid")


class IdPath(BaseModel):
    """The `{id}` of an address."""

    model_config = LATER

    id: Id


class Empty(Shape):
    """`{}`: it was done."""
