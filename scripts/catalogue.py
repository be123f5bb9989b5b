"""Checks the texts of every language and writes their TypeScript types: python -m scripts.catalogue

The catalogue has the form of i18next JSON v4: `{{name}}` is a placeholder, `runs_one` and `runs_other` are the forms of
a plural. Portuguese is the source. Every language needs its keys, its placeholders, and the plural forms of its rule.
Every key must be used by the code.
"""

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pinel_desktop import messages

_ROOT = Path(__file__).parents[1]
_CATALOGUE = _ROOT / "pinel_desktop" / "messages" / "catalogue"
_TYPES = _ROOT / "ui" / "src" / "i18n" / "catalogue_types.ts"
_SOURCES = ("pinel_desktop", "storage", "sim", "ui/src")
_PLACEHOLDER = re.compile(r"\{\{(\w+)(?:, number)?\}\}")
# Words, and the beginnings and ends of keys that a string contains: "check_{kind}", "_too_many".
_TOKEN = re.compile(r"""(?<=[}"`])_\w+|\w+_(?=[{"`$])|\b[^\W_]\w*""")
_PLURAL = re.compile(r"(.+)_(zero|one|two|few|many|other)")


def main() -> int:
    """Returns 1 if a language lacks something or a key is unused, after it has printed what."""
    found = [fault for language in messages.LANGUAGES for fault in faults(language)]
    found += [f"“{key}” is used nowhere" for key in unused()]
    print("\n".join(found), file=sys.stderr, end="\n" if found else "")
    types = _typescript()
    if not _TYPES.exists() or _TYPES.read_text("utf-8") != types:
        _TYPES.write_text(types, "utf-8")
    return 1 if found else 0


def faults(language: str, folder: Path = _CATALOGUE) -> list[str]:
    """Returns what a language lacks or has too much, one line each."""
    source = folder / messages.SOURCE_LANGUAGE
    names = {path.relative_to(source).as_posix() for path in source.rglob("*.json")}
    own = {
        path.relative_to(folder / language).as_posix()
        for path in (folder / language).rglob("*.json")
    }
    found = [f"{language}: the file {name} is missing" for name in sorted(names - own)]
    found += [f"{language}: the file {name} is unknown" for name in sorted(own - names)]
    lacking = _read(source / "language.json").keys() - _read(folder / language / "language.json")
    found += [f"{language}/language.json: “{key}” is missing" for key in sorted(lacking)]
    for name in sorted((names & own) - {"language.json"}):
        wanted, given = (
            _forms(_read(folder / tag / name)) for tag in (messages.SOURCE_LANGUAGE, language)
        )
        found += [f"{language}/{name}: {fault}" for fault in _differences(wanted, given, language)]
    return found


def unused(folder: Path = _CATALOGUE) -> list[str]:
    """Returns the keys of the source language whose name no source file contains.

    A key that the code builds counts as used if a string has its beginning or its end: "check_{kind}" or "_too_many".
    """
    source, tokens = folder / messages.SOURCE_LANGUAGE, _tokens_of_sources()
    paths = [
        (file, path)
        for file in (*source.glob("*.json"), *source.glob("page/*.json"))
        if file.name != "language.json"
        for path in (_forms(_read(file)) if file.parent.name == "page" else _read(file))
    ]
    found = [(file, path) for file, path in paths if not _names(path) & tokens]
    return sorted(f"{file.relative_to(source).as_posix()}: {path}" for file, path in found)


def _tokens_of_sources() -> set[str]:
    files = [path for top in _SOURCES for path in (_ROOT / top).rglob("*.*")]
    code = [
        path
        for path in files
        if (path.suffix in {".py", ".ts", ".tsx"} or path.parent.name == "worlds")
        and not path.name.endswith((".test.ts", ".test.tsx"))
        and path not in {_TYPES, _ROOT / "ui" / "src" / "api" / "types.ts"}
    ]
    return {token for path in code for token in _TOKEN.findall(path.read_text("utf-8"))}


def _names(path: str) -> set[str]:
    """Returns the names of which one is in the code if it uses the key."""
    name = [step for step in path.split(".") if not step.isdigit()][-1]
    if path.startswith("editor."):  # Blockly's own keys
        return {"Blockly"}
    if path.startswith("blocks."):  # "COLOUR_BLUE" belongs to blue, "MOVE_TIP" to move
        whole = name.removesuffix("_TIP")
        return {name, whole.lower(), whole.partition("_")[2].lower()}
    cuts = [at for at, letter in enumerate(name) if letter == "_"]
    built = {name[: at + 1] for at in cuts} | {name[at:] for at in cuts}
    return {name, name.removesuffix("Help"), *built} - {"_", ""}


def _differences(
    wanted: dict[str, dict[str, str]], given: dict[str, dict[str, str]], language: str
) -> Iterator[str]:
    yield from (f"“{key}” is missing" for key in wanted.keys() - given.keys())
    yield from (f"“{key}” is unknown" for key in given.keys() - wanted.keys())
    categories = {"other", *messages.plural_rules(language)}
    for key in sorted(wanted.keys() & given.keys()):
        is_plural = "" not in wanted[key]
        if is_plural != ("" not in given[key]):
            yield f"“{key}” is a plural in one language only"
        elif is_plural:
            yield from (
                f"“{key}_{form}” is missing" for form in sorted(categories - given[key].keys())
            )
        expected = _placeholders("".join(wanted[key].values()), is_plural)
        for form, text in given[key].items():
            if (has := _placeholders(text, is_plural)) != expected:
                name = f"{key}_{form}" if form else key
                yield f"“{name}” has the placeholders {sorted(has)} and needs {sorted(expected)}"
            if not text.strip() and "".join(wanted[key].values()).strip():
                yield f"“{key}” is empty"


def _placeholders(text: str, is_plural: bool) -> set[str]:
    """Returns the names in a text. A form of a plural may say its number in words."""
    return set(_PLACEHOLDER.findall(text)) - ({"count"} if is_plural else set())


def _forms(tree: Any) -> dict[str, dict[str, str]]:
    """Returns the forms of each text by its path; a text without plural has the one form ""."""
    forms: dict[str, dict[str, str]] = {}
    for path, text in _leaves(tree, ""):
        plural = _PLURAL.fullmatch(path)
        key, form = (plural[1], plural[2]) if plural else (path, "")
        forms.setdefault(key, {})[form] = text
    return forms


def _leaves(tree: Any, path: str) -> Iterator[tuple[str, str]]:
    if isinstance(tree, str):
        yield path, tree
        return
    items = tree.items() if isinstance(tree, dict) else enumerate(tree)
    for key, one in items:
        yield from _leaves(one, f"{path}.{key}" if path else str(key))


def _read(path: Path) -> Any:
    return json.loads(path.read_text("utf-8"))


def _typescript() -> str:
    """Returns the types of the page's texts: strings, and functions of the values of their placeholders."""
    files = sorted((_CATALOGUE / messages.SOURCE_LANGUAGE / "page").glob("*.json"))
    tree = {key: one for file in files for key, one in _read(file).items() if key != "editor"}
    return (
        "// Made by `python -m scripts.catalogue` from pinel_desktop/messages/catalogue/pt-BR/page/. Do not edit.\n\n"
        f"type Value = string | number;\n\nexport interface PageTexts {_type_of(tree, '')}\n"
    )


def _type_of(tree: Any, indent: str) -> str:
    if isinstance(tree, str):
        return _function(dict.fromkeys(_PLACEHOLDER.findall(tree), "Value"))
    if isinstance(tree, list):
        return "readonly string[]"
    inner = indent + "  "
    types: dict[str, str] = {}
    for key, one in tree.items():
        if plural := _PLURAL.fullmatch(key):
            forms = "".join(str(tree.get(f"{plural[1]}_{form}", "")) for form in ("one", "other"))
            names = dict.fromkeys(_PLACEHOLDER.findall(forms), "Value") | {"count": "number"}
            types[plural[1]] = _function(names)
        else:
            types[key] = _type_of(one, inner)
    lines = [f"{inner}readonly {_name(key)}: {one};\n" for key, one in types.items()]
    return "{\n" + "".join(lines) + indent + "}"


def _function(names: dict[str, str]) -> str:
    if not names:
        return "string"
    values = "; ".join(f"{name}: {kind}" for name, kind in names.items())
    return f"(values: {{ {values} }}) => string"


def _name(key: str) -> str:
    return key if re.fullmatch(r"[A-Za-z_]\w*", key) else json.dumps(key)


if __name__ == "__main__":
    sys.exit(main())
