"""Conversion between names of variables and functions and Python identifiers.

Names of a program may contain spaces, begin with a digit or be keywords of Python:

    minha área  ->  minha__área         a space is two underscores
    if, robot   ->  if_, robot_         a reserved word gets an underscore
    2nd side    ->  _2nd__side          an underscore before a digit at the beginning
    a__b, 2²    ->  a_u5f__u5f_b        any other invalid character: its code, between `_u` and `_`

The conversion is one-to-one.
"""

import re
import unicodedata

from pinel_desktop.program.python_text.forms import RESERVED

_ESCAPE = re.compile(r"_u([0-9a-f]{1,6})_|(?<=.)__(?=.)")
_LIKE_AN_ESCAPE = re.compile(r"_u[0-9a-f]{1,6}(?![0-9A-Za-z])")


def python_name(name: str) -> str:
    """Converts a name of the program to a Python identifier."""
    if name in RESERVED:
        return f"{name}_"
    text = _escaped(name, {char for char in set(name) if _is_plain(char)})
    # combining characters, which Python would normalise
    if unicodedata.normalize("NFKC", text) != text:
        text = _escaped(name, {char for char in set(name) if char.isascii() and _is_plain(char)})
    return text


def program_name(text: str) -> str:
    """Converts a Python identifier to a name of the program."""
    if text.endswith("_") and text[:-1] in RESERVED:
        return text[:-1]
    if text[0] == "_" and not text[1:2].isidentifier():
        text = text[1:] or text
    return _ESCAPE.sub(_unescaped, text)


def _unescaped(match: re.Match[str]) -> str:
    if match[1] is None:
        return " "
    code = int(match[1], 16)
    return chr(code) if code <= 0x10FFFF else match[0]


def _is_plain(char: str) -> bool:
    """True if a character needs no escape."""
    return char != "_" and f"a{char}".isidentifier() and unicodedata.normalize("NFKC", char) == char


def _escaped(name: str, plain: set[str]) -> str:
    parts = []
    for i, char in enumerate(name):
        if char in plain or (char == "_" and _may_stay(name, i, plain)):
            parts.append(char)
        elif char == " " and 0 < i < len(name) - 1:
            parts.append("__")
        else:
            parts.append(f"_u{ord(char):x}_")
    text = "".join(parts)
    return text if text[:1].isidentifier() else f"_{text}"


def _may_stay(name: str, i: int, plain: set[str]) -> bool:
    """True if an underscore cannot be taken for part of an escape."""
    if any(char not in plain for char in (*name[max(i - 1, 0) : i], *name[i + 1 : i + 2])):
        return False
    if i == 0 and not name[1:2].isidentifier():
        return False
    if i == len(name) - 1:
        return name[:-1] not in RESERVED
    like = _LIKE_AN_ESCAPE.match(name, i)
    return like is None or like.end() == len(name)
