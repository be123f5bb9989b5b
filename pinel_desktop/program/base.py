"""What the models of a document are made of: dataclasses with slots, which pydantic reads and checks.

A long program is read a quarter faster than with `pydantic.BaseModel`, which keeps a dictionary and a set of names for
each command. Pydantic looks at them when the first document is read, and not before.
"""

from collections.abc import Iterator
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field
from typing import Any, ClassVar, dataclass_transform

from pydantic import ConfigDict, GetCoreSchemaHandler
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema


@dataclass_transform(frozen_default=True, kw_only_default=True, field_specifiers=(field,))
class _Dataclass(type):
    """Makes each class a dataclass, without the methods that take long to make: `Model` has them for all."""

    def __new__(cls, name: str, bases: tuple[type, ...], namespace: dict[str, Any]) -> Any:
        # what `dataclass` would word from all annotations; pydantic takes neither for a description
        namespace.setdefault("__doc__", f"{name}()")
        made: Any = super().__new__(cls, name, bases, namespace)
        if "__slots__" in namespace:  # `Model`, or what `dataclass` has made anew to give it slots
            return made
        return dataclass(init=False, repr=False, eq=False, slots=True, kw_only=True)(made)


class Model(metaclass=_Dataclass):
    """Base of everything in a document: unknown keys are faults, values are not converted, nothing changes.

    Pydantic alone makes instances.
    """

    __slots__ = ()
    __dataclass_fields__: ClassVar[dict[str, Field[Any]]]
    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(
        extra="forbid", strict=True, allow_inf_nan=False
    )

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Strict with all that it holds, but made from an object: strict dataclasses take their instances only."""
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
    """What a model holds, in the order of its fields."""
    return (getattr(model, name) for name in model.__dataclass_fields__)


def defaults(model: type[Model]) -> dict[str, Any]:
    """What is taken where a key is left out, by the keys that may be."""
    found: dict[str, Any] = {}
    for made in model.__dataclass_fields__.values():
        if made.default_factory is not MISSING:
            found[_key(made)] = made.default_factory()
        elif made.default is not MISSING:
            found[_key(made)] = made.default
    return found


def annotations(model: type[Model]) -> dict[str, Any]:
    """What may stand in a model, by the keys of a document."""
    return {_key(made): made.type for made in model.__dataclass_fields__.values()}


def _key(made: Field[Any]) -> str:
    marks = getattr(made.type, "__metadata__", ())
    aliases = (mark.alias for mark in marks if isinstance(mark, FieldInfo))
    return next(filter(None, aliases), made.name)
