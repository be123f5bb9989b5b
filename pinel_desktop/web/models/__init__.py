"""Models of all bodies and responses of the HTTP interface; the OpenAPI description is generated from them."""

from typing import Annotated, Any, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field


def _writable(text: str) -> str:
    """Refuses lone surrogates, which JSON can hold but SQLite cannot."""
    text.encode()
    return text


Id = Annotated[str, AfterValidator(_writable), Field(description="UUID text")]
Time = Annotated[str, Field(description="ISO 8601 in UTC")]
Json = Annotated[dict[str, Any], Field(description="any JSON object")]


# The app's start imports this module and needs few of its models. So each model is built at its
# first use.
DEFERRED = ConfigDict(defer_build=True)


class ResponseModel(BaseModel):
    """Base of all responses. Fields with a default are present in every response."""

    model_config = DEFERRED | ConfigDict(
        extra="forbid", json_schema_serialization_defaults_required=True
    )

    @classmethod
    def of(cls, row: object, **more: Any) -> Self:
        """Converts a row of the store, whose fields have the same names, to a response.

        Args:
            more: fields that the row lacks or has in another form.
        """
        own = {name: getattr(row, name) for name in cls.model_fields if name not in more}
        return cls.model_validate({**own, **more}, from_attributes=True)


class RequestModel(BaseModel):
    """Base of all bodies and queries. Refuses unknown keys, so that typing mistakes are noticed."""

    model_config = DEFERRED | ConfigDict(extra="forbid")


class IdPath(BaseModel):
    """The `{id}` in a path."""

    model_config = DEFERRED

    id: Id


class Empty(ResponseModel):
    """`{}`: success without a value."""
