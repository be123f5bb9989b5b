"""From text to Python's own tree (`ast`), with everything that is no Python at all. Nothing is ever executed.

Python stops at the first thing that it does not understand. Here that line is put aside and the rest is tried again, so
that a person learns of all such lines at once.
"""

import ast
import re
import warnings
from bisect import bisect_right
from dataclasses import dataclass

from pinel_desktop.program.limits import MAX_BYTES, MAX_NESTING
from pinel_desktop.program.python_text.scanning import Look, Place, Trouble, look_at
from pinel_desktop.program.python_text.slips import slip_in

_MAX_TRIES = 30
_UNREADABLE = re.compile("[\x00\ud800-\udfff]")
_GOES_ON = re.compile(r"[ \t\f]*(else|elif)\b")
_BODY_MISSING = re.compile(r"expected an indented block .*on line (\d+)")
_IN_PYTHONS_WORDS = (
    ("expected an indented block", "python_indent_missing"),
    ("indent", "python_indent_wrong"),
    ("tabs", "python_indent_wrong"),
    ("maybe you meant '=='", "python_equals"),
    ("expected ':'", "python_colon_missing"),
    ("invalid character", "python_character"),
    ("invalid non-printable character", "python_character"),
    ("exceeds the limit", "python_number_too_large"),
    ("too many nested parentheses", "nesting_too_deep"),
)


@dataclass(frozen=True, slots=True)
class Parsed:
    """What Python makes of a text.

    Attributes:
        tree: Python's tree, None where nothing could be made of it; in it, each `elif` is an `if` of its own.
        look: the first look at what was parsed in the end.
        troubles: what Python does not understand.
        put_aside: lines that had trouble; the tree has something else in their place.
    """

    tree: ast.Module | None
    look: Look
    troubles: list[Trouble]
    put_aside: set[int]


def parse(text: str) -> Parsed:
    """Parses a text whose lines end in `\\n`. What is not understood is left out of the tree."""
    return _Parser(text).parse()


class _Parser:
    def __init__(self, text: str) -> None:
        self._lines = text.split("\n")
        self._put_aside: set[int] = set()
        self._troubles: list[Trouble] = []

    def parse(self) -> Parsed:
        # what may be tried again is bounded, and so is the time it takes
        size = sum(len(line) for line in self._lines) + 1
        for _ in range(max(1, min(_MAX_TRIES, 2 * MAX_BYTES // size))):
            look = look_at("\n".join(self._lines))
            troubles = [*self._unreadable(), *look.troubles]
            if not troubles:
                found = self._tree(look)
                if isinstance(found, ast.Module):
                    return Parsed(found, look, self._troubles, self._put_aside)
                troubles = [found]
            self._troubles += troubles
            if not self._without(troubles, look):
                break
        return Parsed(None, look, self._troubles, self._put_aside)

    def _unreadable(self) -> list[Trouble]:
        return [
            Trouble("python_character", Place(i, match.start()), {"character": repr(match[0])})
            for i, line in enumerate(self._lines, 1)
            if (match := _UNREADABLE.search(line))
        ]

    def _tree(self, look: Look) -> ast.Module | Trouble:
        lines = list(self._lines)
        for place in look.elifs:
            line = lines[place.line - 1]
            lines[place.line - 1] = f"{line[: place.column]}if  {line[place.column + 4 :]}"
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # such as for "\d"
                return ast.parse("\n".join(lines))
        except SyntaxError as error:
            return self._explained(error)
        except (RecursionError, MemoryError):
            return Trouble("nesting_too_deep", look.longest, {"max": MAX_NESTING})
        except ValueError:
            return Trouble("python_syntax", look.longest)

    def _explained(self, error: SyntaxError) -> Trouble:
        line = min(max(error.lineno or 1, 1), len(self._lines))
        length = len(self._lines[line - 1])
        place = Place(line, min(max((error.offset or 1) - 1, 0), length))
        said = (error.msg or "").lower()
        heading = _BODY_MISSING.search(said)
        if heading is not None:  # Python says so where the next command begins, or at the end
            text = self._lines[int(heading[1]) - 1]
            place = Place(int(heading[1]), len(text) - len(text.lstrip()))
        text = self._lines[place.line - 1]
        code = next((code for words, code in _IN_PYTHONS_WORDS if words in said), "python_syntax")
        slip = slip_in(text) if code in ("python_syntax", "python_colon_missing") else None
        if slip is not None:
            return Trouble(slip[0], place, slip[1])
        return Trouble(code, place, _params(code, text, place))

    def _without(self, troubles: list[Trouble], look: Look) -> bool:
        """Puts the lines with trouble aside; whether that changed anything."""
        before = list(self._lines)
        for trouble in troubles:
            first, last = _lines_around(trouble, look)
            if trouble.code == "python_indent_missing":
                self._give_a_body(last)
            elif trouble.code == "python_indent_wrong":
                self._lines[first - 1 : last] = [""] * (last - first + 1)
            elif first not in self._put_aside:
                self._put_aside.update(range(first, last + 1))
                self._replace(first, last)
        return self._lines != before

    def _give_a_body(self, line: int) -> None:
        heading = self._lines[line - 1].rstrip()
        if heading.endswith(":"):
            self._lines[line - 1] = f"{heading} pass"

    def _replace(self, first: int, last: int) -> None:
        """Puts something in the place of a command that keeps the lines below it in their block."""
        begin = self._lines[first - 1]
        indent = begin[: _indent(begin)]
        heading = "pass"
        if self._has_a_body(last, len(indent)):
            word = _GOES_ON.match(begin)
            heading = {"else": "else:", "elif": "elif True:"}.get(
                word[1] if word else "", "while True:"
            )
        self._lines[first - 1 : last] = [indent + heading, *[""] * (last - first)]

    def _has_a_body(self, line: int, indent: int) -> bool:
        """Whether the next command is farther in."""
        for following in self._lines[line:]:
            if following.strip() and following.lstrip()[0] != "#":
                return _indent(following) > indent
        return False


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip(" \t\f"))


def _lines_around(trouble: Trouble, look: Look) -> tuple[int, int]:
    """The lines to put aside: the whole command, or only the line where brackets or quotes are not closed."""
    line = trouble.place.line
    i = bisect_right(look.spans, (line, MAX_BYTES)) - 1
    if trouble.code in _ON_ONE_LINE or i < 0 or look.spans[i][1] < line:
        return line, line
    return look.spans[i]


_ON_ONE_LINE = ("python_bracket_not_closed", "python_bracket_not_opened", "python_text_not_closed")


def _params(code: str, line: str, place: Place) -> dict[str, object]:
    if code == "python_character":
        return {"character": line[place.column : place.column + 1]}
    return {"max": MAX_NESTING} if code == "nesting_too_deep" else {}
