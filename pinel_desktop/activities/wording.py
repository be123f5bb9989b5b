"""Texts of check results and diagnoses: numbers formatted for the language, blocks by their labels.

`blocks_named` finds the blocks that a hint names.

The suffix of a value's name is its unit: `_m`, `_deg`, `_s`. `{gap_m}` becomes "12 cm" or "1,62 m", `{gap}` the
bare number in that unit, `{gap_cm}` the centimetres.
"""

import re
from collections.abc import Iterator, Mapping
from typing import Any

from pinel_desktop.activities.commands import Command, commands_of
from pinel_desktop.messages import (
    LANGUAGES,
    SOURCE_LANGUAGE,
    catalogue,
    decimal_sign,
    describe,
)
from pinel_desktop.messages.content import place_name
from pinel_desktop.program.model import action_names

TextByLanguage = dict[str, str]
# `{{name}}` in the catalogue, `{name}` in an activity
_PLACEHOLDER = re.compile(r"\{?\{(\w+)\}\}?")
_UNITS = ("_m", "_deg", "_s")
_OF_PLACES = ("zone", "zones", "visited")
_QUOTED = re.compile('[“«"]([^”»"]+)[”»"]')
# the names of these blocks are everyday words, which name a block only in quotation marks
_EVERYDAY = frozenset(
    {
        "stop",
        "wait",
        "ask",
        "say",
        "mark",
        "set_variable",
        "change_variable",
        "conditional_execution",
    }
    | {"while", "for", "call", "return", "drive"}
)
_SIGNS = {
    "==": "=",
    "!=": "≠",
    "<": "<",
    "<=": "≤",
    ">": ">",
    ">=": "≥",
    "+": "+",
    "-": "−",
    "*": "×",
    "/": "÷",
}


def number(value: float, language: str, digits: int = 2) -> str:
    """Formats a number with at most `digits` decimals, a true minus sign and no negative zero."""
    text = f"{value:.{digits}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    text = "0" if text in ("-0", "") else text
    return text.replace("-", "−").replace(".", decimal_sign(language))


def length(metres: float, language: str) -> str:
    """Formats a length in metres, in centimetres if shorter than 1 m, in millimetres if shorter than 1 cm."""
    size = abs(metres)
    if size < 0.00995 and size >= 0.0005:
        return f"{number(metres * 1000, language, 0)} mm"
    if size < 0.995:
        return f"{number(metres * 100, language, 0)} cm"
    return f"{number(metres, language)} m"


def formatted_values(values: Mapping[str, Any], language: str) -> dict[str, Any]:
    """Returns values as texts in a language, by the names that messages may use."""
    texts: dict[str, Any] = {}
    for name, value in values.items():
        if isinstance(value, Command):
            texts[name] = block_label(value, language)
        elif name in _OF_PLACES:
            texts[name] = _places_named(value, language)
        elif name == "name":
            texts[name] = short_name(str(value), language)
        elif isinstance(value, bool) or not isinstance(value, int | float):
            texts[name] = value
        else:
            texts |= _forms(name, float(value), language)
    return texts


def _places_named(places: Any, language: str) -> Any:
    """Returns the name of a place, or of each in a list, with its translation."""
    if isinstance(places, str):
        return place_name(places, language)
    return [place_name(one, language) for one in places]


def _forms(name: str, value: float, language: str) -> dict[str, str]:
    unit = next((one for one in _UNITS if name.endswith(one)), "")
    bare = name.removesuffix(unit)
    if unit == "_m":
        cm = number(value * 100, language, 0)
        return {name: length(value, language), bare: number(value, language), f"{bare}_cm": cm}
    if unit == "_deg":
        degrees = number(value, language, 0)
        return {name: f"{degrees}°", bare: degrees}
    if unit == "_s":
        seconds = number(value, language, 1)
        return {name: f"{seconds} s", bare: seconds}
    return {name: number(value, language)}


def short_name(action: str, language: str) -> str:
    """Returns the short name of a kind of block."""
    key = f"block_{action}" if action != "pen" else "block_pen_down"
    return describe(key, {}, language).remedy


def block_text(document: Mapping[str, Any], block: str, language: str) -> str | None:
    """Returns the label of a block by its id; None if the program has no command of that block."""
    found = next((one for one in commands_of(document) if one.block == block), None)
    return block_label(found, language) if found else None


def block_label(command: Command, language: str) -> str:
    """Returns the label of a block with its values; its short name if a value is computed in the run."""
    data, action = command.data, command.action
    if action == "pen":
        action = "pen_down" if data.get("down") else "pen_up"
    key = f"block_{action}"
    if key not in catalogue(language):
        return action
    values = _parameters(data, language)
    description = describe(key, values, language)
    placeholders = _PLACEHOLDER.findall(catalogue(language)[key]["message"])
    return (
        description.message if all(name in values for name in placeholders) else description.remedy
    )


def _parameters(data: Mapping[str, Any], language: str) -> dict[str, str]:
    values = {
        name: number(value, language)
        if isinstance(value, int | float)
        else _quoted(value, language)
        for name, value in data.items()
        if isinstance(value, str | int | float) and not isinstance(value, bool)
    }
    for name in ("name", "variable", "list", "function", "symbol"):
        if name in values:
            values[name] = str(data[name])
    angle = data.get("angle")
    if isinstance(angle, int | float):
        side = "block_left" if angle >= 0 else "block_right"
        values |= {"side": describe(side, {}, language).message}
        values |= {"angle": number(abs(angle), language)}
    if data.get("action") == "pen":
        color = f"block_color_{data.get('color') or 'blue'}"
        values["color"] = describe(color, {}, language).message
    condition = expression_label(data.get("condition"), language)
    if condition is not None:
        values["condition"] = condition
    if data.get("action") in ("go_to", "go_to_place"):
        route = "block_around" if data.get("avoid") else "block_straight"
        values["way"] = describe(route, {}, language).message
    return values


def _quoted(value: str, language: str) -> str:
    return describe("value_quoted", {"text": value}, language).message


def expression_label(value: Any, language: str) -> str | None:
    """Returns an expression as its blocks show it; None if it is too long for a sentence."""
    if isinstance(value, bool) or not isinstance(value, dict | int | float | str):
        return None
    if isinstance(value, str):
        return f"‘{value}’"  # inside of the quotes around the block
    if isinstance(value, int | float):
        return number(value, language)
    if "var" in value:
        return str(value["var"])
    if "gesture" in value:
        code = "value_number_shown" if value["gesture"] == "number" else "value_gesture"
        return describe(code, {}, language).message
    if "sensor" in value:
        return _sensor_label(value, language)
    return _operation_label(value, language) if "op" in value else None


def _sensor_label(value: Mapping[str, Any], language: str) -> str | None:
    code = f"value_{value['sensor']}"
    if code not in catalogue(language):
        return None
    direction = str(value.get("direction", ""))
    direction_code = (
        f"value_{direction}" if direction in ("front", "back") else f"block_{direction}"
    )
    return describe(code, {"way": describe(direction_code, {}, language).message}, language).message


def _operation_label(value: Mapping[str, Any], language: str) -> str | None:
    op, args = str(value["op"]), list(value.get("args", ()))
    is_of_floor = any(isinstance(one, dict) and one.get("sensor") == "floor" for one in args)
    parts = [
        describe(f"block_color_{one}", {}, language).message
        if is_of_floor and f"block_color_{one}" in catalogue(language)
        else expression_label(one, language)
        for one in args
        if isinstance(one, str | dict | int | float)
    ]
    if len(parts) != len(args) or any(part is None for part in parts):
        return None
    if op == "not" and len(parts) == 1:
        return describe("value_not", {"one": parts[0]}, language).message
    if len(parts) != 2:
        return None
    if op in ("and", "or"):
        return describe(f"value_{op}", {"one": parts[0], "other": parts[1]}, language).message
    return f"{parts[0]} {_SIGNS[op]} {parts[1]}" if op in _SIGNS else None


def texts_of(code: str, values: Mapping[str, Any], command: Command | None) -> TextByLanguage:
    """Returns the message of a code in every language, with the block to look at."""
    texts: TextByLanguage = {}
    for language in LANGUAGES:
        description = describe(code, formatted_values(values, language), language)
        remedy = description.remedy
        if command is not None:
            block = block_label(command, language)
            remedy = describe("check_look_at", {"block": block}, language).message
        texts[language] = f"{description.message} {remedy}".strip()
    return texts


def interpolate(text: str, values: Mapping[str, Any], language: str) -> str:
    """Inserts the values of a run into a text of an activity; placeholders with unknown names stay."""
    texts = formatted_values(values, language)

    def fill(match: re.Match[str]) -> str:
        return str(texts.get(match[1], match[0]))

    return _PLACEHOLDER.sub(fill, text)


def blocks_named(texts: dict[str, str]) -> dict[str, str]:
    """Returns the actions that a hint names, each with that name: quoted in any language, or unquoted in Portuguese.

    Args:
        texts: the hint by language.
    """
    found: dict[str, str] = {}
    for language in LANGUAGES:
        for quoted in _QUOTED.findall(texts.get(language, "")):
            found |= dict(_first(quoted.strip(), language))
    plain = _QUOTED.sub(" ", texts.get(SOURCE_LANGUAGE, ""))
    for start in re.finditer(r"\b\w", plain):
        named = dict(_first(plain[start.start() :], SOURCE_LANGUAGE))
        found |= {action: name for action, name in named.items() if action not in _EVERYDAY}
    return found


def _first(text: str, language: str) -> Iterator[tuple[str, str]]:
    """Yields the action whose name a text begins with; of several, the longest: “repeat until” is not “repeat”."""
    candidates = [
        (len(name), action, name)
        for action, name in _names(language)
        if re.match(rf"{re.escape(name)}\b", text, re.IGNORECASE)
    ]
    if candidates:
        _, action, name = max(candidates)
        yield action, name


def _names(language: str) -> Iterator[tuple[str, str]]:
    for action in action_names():
        if action != "call":
            yield action, short_name(action, language)
    yield "pen", describe("block_pen_up", {}, language).remedy
