"""Explains common mistakes that Python reports only as invalid syntax."""

import re
from functools import cache

from pinel_desktop.messages import python_keywords

_MAX_LENGTH = 300  # longer lines were not typed by hand
_ELSE_IF = re.compile(r"\s*else\s+if\b")
_STEP = re.compile(r"(\w+)\s*(\+\+|--)\s*;?\s*(?:#.*)?$")
_TURNED_ROUND = re.compile(r"=<|=>")
_FIRST_TOKEN = re.compile(r"\s*(\w+)")
_KEYWORDS = (
    "if",
    "elif",
    "else",
    "for",
    "while",
    "def",
    "return",
    "break",
    "continue",
    "pass",
    "global",
)


def common_mistake(line: str) -> tuple[str, dict[str, object]] | None:
    """Code and params of the fault for a line with a common mistake; None if none is recognised."""
    if len(line) > _MAX_LENGTH:
        return None
    if _ELSE_IF.match(line):
        return "python_else_if", {}
    step = _STEP.search(line)
    if step:
        return "python_step", {"instead": f"{step[1]} {step[2][0]}= 1"}
    turned = _TURNED_ROUND.search(line)
    if turned:
        return "python_turned_round", {"value": turned[0], "instead": turned[0][::-1]}
    token = _FIRST_TOKEN.match(line)
    meant = _meanings().get(token[1].lower()) if token else None
    if token and meant and token[1] != meant:
        return "python_word", {"value": token[1], "instead": meant}
    return None


@cache
def _meanings() -> dict[str, str]:
    """The keyword that is meant: by itself in other case, or by a translation."""
    return {**{keyword: keyword for keyword in _KEYWORDS}, **python_keywords()}
