"""Base of a document's models: dataclasses with slots, validated by pydantic.

Reading a long program takes a quarter less time than with `pydantic.BaseModel`, which stores a dictionary and a set of
names for each command. pydantic builds the validators when the first document is read.
"""

from collections.abc import Iterator
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field
from functools import cache
from typing import Any, ClassVar, dataclass_transform

from pydantic import ConfigDict, GetCoreSchemaHandler
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema


@dataclass_transform(frozen_default=True, kw_only_default=True, field_specifiers=(field,))
class _Dataclass(type):
    """Makes each class a dataclass. Methods that are slow to generate are inherited from `Model` instead."""

    def __new__(cls, name: str, bases: tuple[type, ...], namespace: dict[str, Any]) -> Any:
        # `dataclass` would generate a long docstring; pydantic does not take this form for a description
        namespace.setdefault("__doc__", f"{name}()")
        made: Any = super().__new__(cls, name, bases, namespace)
        # `Model`, or the class that `dataclass` creates again with slots
        if "__slots__" in namespace:
            return made
        return dataclass(init=False, repr=False, eq=False, slots=True, kw_only=True)(made)


class Model(metaclass=_Dataclass):
    """Base of all models of a document: immutable, without unknown keys, without conversion of values.

    Only pydantic creates instances.
    """

    __slots__ = ()
    __dataclass_fields__: ClassVar[dict[str, Field[Any]]]
    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(
        extra="forbid", strict=True, allow_inf_nan=False
    )

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Strict for the fields, but not for the model itself: a strict dataclass would accept no dict."""
        schema: Any = handler(source)
        schema["strict"] = False
        return schema  # type: ignore[no-any-return]

    def __setattr__(self, name: str, _value: object) -> None:
        raise FrozenInstanceError(f"cannot assign to field {name!r}")

    def __delattr__(self, name: str) -> None:
        raise FrozenInstanceError(f"cannot delete field {name!r}")

    def __setstate__(self, state: tuple[None, dict[str, Any]]) -> None:
        for name, value in state[1].items():
            object.__setattr__(self, name, value)

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and list(values(self)) == list(values(other))

    def __hash__(self) -> int:
        return hash(tuple(values(self)))

    def __repr__(self) -> str:
        shown = zip(self.__dataclass_fields__, values(self), strict=True)
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in shown)})"


def values(model: Model) -> Iterator[Any]:
    """The values of a model's fields, in order."""
    return (getattr(model, name) for name in model.__dataclass_fields__)


def defaults(model: type[Model]) -> dict[str, Any]:
    """Defaults of the optional keys, by key of the document."""
    found: dict[str, Any] = {}
    for made in model.__dataclass_fields__.values():
        if made.default_factory is not MISSING:
            found[_key(made)] = made.default_factory()
        elif made.default is not MISSING:
            found[_key(made)] = made.default
    return found


@cache
def annotations(model: type[Model]) -> dict[str, Any]:
    """Annotations of the fields, by key of the document."""
    return {_key(made): made.type for made in model.__dataclass_fields__.values()}


def _key(made: Field[Any]) -> str:
    marks = getattr(made.type, "__metadata__", ())
    aliases = (mark.alias for mark in marks if isinstance(mark, FieldInfo))
    return next(filter(None, aliases), made.name)
