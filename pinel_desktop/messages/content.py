"""Texts of the worlds, activities, examples and programs that ship: `catalogue/LANGUAGE/content/AREA.json`, by name."""

import json
from collections.abc import Mapping
from functools import cache
from importlib import resources
from typing import Any, Literal

from pinel_desktop.messages import LANGUAGES

Area = Literal["missions", "examples", "worlds", "programs"]
_CATALOGUE = resources.files(__name__.rpartition(".")[0]) / "catalogue"


@cache
def texts_by_language(area: Area) -> dict[str, dict[str, Any]]:
    """Returns the texts of an area: language -> name -> texts."""
    return {
        language: json.loads(
            (_CATALOGUE / language / "content" / f"{area}.json").read_text("utf-8")
        )
        for language in LANGUAGES
    }


def world_titles(language: str) -> dict[str, str]:
    """Returns the titles of the shipped worlds in a language, by name."""
    return texts_by_language("worlds")[language]


def place_name(name: str, language: str) -> str:
    """Returns the name of a place as its plate on the floor has it: with a translation, where one is known."""
    translation = _places(language).get(name, name)
    return name if translation == name else f"{name} · {translation}"


@cache
def _places(language: str) -> dict[str, str]:
    texts = json.loads((_CATALOGUE / language / "page" / "places.json").read_text("utf-8"))
    places: dict[str, str] = texts["places"]
    return places


def titled(world: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the document of a shipped world with its title in every language."""
    texts = texts_by_language("worlds")
    return {**world, "title": {language: texts[language][world["name"]] for language in LANGUAGES}}


def with_texts(document: Mapping[str, Any], area: Area) -> dict[str, Any]:
    """Returns the document of a shipped activity with its texts in every language, the form of docs/activities.md.

    The shipped document has no texts: `label` and `say` in it are keys of the catalogue.
    """
    of_name = {tag: names[document["name"]] for tag, names in texts_by_language(area).items()}
    source = of_name[LANGUAGES[0]]

    def localized(key: str, index: int | None = None) -> dict[str, str]:
        texts = {tag: texts[key] for tag, texts in of_name.items()}
        return {tag: text if index is None else text[index] for tag, text in texts.items()}

    def filled(node: Any) -> Any:
        if isinstance(node, list):
            return [filled(one) for one in node]
        if not isinstance(node, Mapping):
            return node
        return {
            key: localized(one) if key in ("label", "say") else filled(one)
            for key, one in node.items()
        }

    own = [key for key in source if not key.startswith(("label_", "say_", "hints"))]
    hints = [localized("hints", index) for index in range(len(source.get("hints", ())))]
    return {
        **filled(document),
        **{key: localized(key) for key in own},
        **({"hints": hints} if hints else {}),
    }


def program_in_language(document: Mapping[str, Any], language: str) -> dict[str, Any]:
    """Returns the document of a shipped program with its names and texts in a language.

    The shipped program has those of the source language; they are the keys of the catalogue.
    """
    words = texts_by_language("programs")[language]

    def translated(node: Any) -> Any:
        if isinstance(node, list):
            return [translated(one) for one in node]
        if isinstance(node, Mapping):
            return {words.get(key, key): translated(one) for key, one in node.items()}
        return words.get(node, node) if isinstance(node, str) else node

    return dict(translated(document))
