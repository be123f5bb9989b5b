"""Texts of an activity in every language, and the base of its models."""

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

from pinel_desktop.messages import SOURCE_LANGUAGE
from sim.document import LanguageTag

_MAX_TITLE, _MAX_TEXT = 200, 1000


class Model(BaseModel):
    """Base of all parts of an activity."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


class Title(Model):
    """A title in Portuguese, and in further languages by their tags."""

    model_config = ConfigDict(extra="allow", populate_by_name=True)

    __pydantic_extra__: dict[LanguageTag, Annotated[str, Field(max_length=_MAX_TITLE)]] = Field(
        init=False
    )
    pt_br: Annotated[str, Field(alias="pt-BR", max_length=_MAX_TITLE)]

    def of(self, language: str) -> str:
        """Returns the text in a language; in Portuguese if the language is missing."""
        texts: dict[str, str] = self.model_dump(by_alias=True)
        return texts.get(language, texts[SOURCE_LANGUAGE])


class Texts(Title):
    """A text in Portuguese, and in further languages by their tags."""

    __pydantic_extra__: dict[LanguageTag, Annotated[str, Field(max_length=_MAX_TEXT)]] = Field(
        init=False
    )
    pt_br: Annotated[str, Field(alias="pt-BR", max_length=_MAX_TEXT)]
