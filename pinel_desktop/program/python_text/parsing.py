"""Parses a text to Python's syntax tree (`ast`), and reports all syntax problems. The text is never executed.

Python's parser stops at the first problem. Here the affected lines are skipped and the rest is parsed again, so that
all problems are reported at once.
"""

import ast
import re
import warnings
from bisect import bisect_right
from dataclasses import dataclass

from pinel_desktop.program.limits import MAX_BYTES, MAX_NESTING
from pinel_desktop.program.python_text.common_mistakes import common_mistake
from pinel_desktop.program.python_text.scanning import Scan, SyntaxProblem, TextPosition, scan_text

_MAX_TRIES = 30
_UNREADABLE = re.compile("[\x00\ud800-\udfff]")
_CONTINUATION = re.compile(r"[ \t\f]*(else|elif)\b")
_BODY_MISSING = re.compile(r"expected an indented block .*on line (\d+)")
_PYTHON_MESSAGES = (
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
    """Result of parsing a text.

    Attributes:
        tree: Python's syntax tree, None if there is none; each `elif` is an `if` in it.
        scan: the scan of the text that was parsed last.
        problems: all syntax problems.
        skipped: numbers of the lines with problems; the tree has replacements there.
    """

    tree: ast.Module | None
    scan: Scan
    problems: list[SyntaxProblem]
    skipped: set[int]


def parse(text: str) -> Parsed:
    """Parses a text whose lines end in `\\n`. Lines with syntax problems are left out of the tree."""
    return _Parser(text).parse()


class _Parser:
    def __init__(self, text: str) -> None:
        self._lines = text.split("\n")
        self._skipped: set[int] = set()
        self._problems: list[SyntaxProblem] = []

    def parse(self) -> Parsed:
        # bounds the repetitions, hence the time
        size = sum(len(line) for line in self._lines) + 1
        for _ in range(max(1, min(_MAX_TRIES, 2 * MAX_BYTES // size))):
            scan = scan_text("\n".join(self._lines))
            problems = [*self._unreadable(), *scan.problems]
            if not problems:
                found = self._tree(scan)
                if isinstance(found, ast.Module):
                    return Parsed(found, scan, self._problems, self._skipped)
                problems = [found]
            self._problems += problems
            if not self._skip(problems, scan):
                break
        return Parsed(None, scan, self._problems, self._skipped)

    def _unreadable(self) -> list[SyntaxProblem]:
        return [
            SyntaxProblem(
                "python_character", TextPosition(i, match.start()), {"character": repr(match[0])}
            )
            for i, line in enumerate(self._lines, 1)
            if (match := _UNREADABLE.search(line))
        ]

    def _tree(self, scan: Scan) -> ast.Module | SyntaxProblem:
        lines = list(self._lines)
        for place in scan.elifs:
            line = lines[place.line - 1]
            lines[place.line - 1] = f"{line[: place.column]}if  {line[place.column + 4 :]}"
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # for example about "\d"
                return ast.parse("\n".join(lines))
        except SyntaxError as error:
            return self._problem_of(error)
        except (RecursionError, MemoryError):
            return SyntaxProblem("nesting_too_deep", scan.max_command_start, {"max": MAX_NESTING})
        except ValueError:
            return SyntaxProblem("python_syntax", scan.max_command_start)

    def _problem_of(self, error: SyntaxError) -> SyntaxProblem:
        line = min(max(error.lineno or 1, 1), len(self._lines))
        length = len(self._lines[line - 1])
        place = TextPosition(line, min(max((error.offset or 1) - 1, 0), length))
        message = (error.msg or "").lower()
        heading = _BODY_MISSING.search(message)
        if heading is not None:  # Python reports it at the next command, or at the end of the text
            text = self._lines[int(heading[1]) - 1]
            place = TextPosition(int(heading[1]), len(text) - len(text.lstrip()))
        text = self._lines[place.line - 1]
        code = next(
            (code for phrase, code in _PYTHON_MESSAGES if phrase in message), "python_syntax"
        )
        slip = common_mistake(text) if code in ("python_syntax", "python_colon_missing") else None
        if slip is not None:
            return SyntaxProblem(slip[0], place, slip[1])
        return SyntaxProblem(code, place, _params(code, text, place))

    def _skip(self, problems: list[SyntaxProblem], scan: Scan) -> bool:
        """Replaces the lines with problems; True if that changed the text."""
        before = list(self._lines)
        for problem in problems:
            first, last = _lines_to_skip(problem, scan)
            if problem.code == "python_indent_missing":
                self._add_body(last)
            elif problem.code == "python_indent_wrong":
                self._lines[first - 1 : last] = [""] * (last - first + 1)
            elif first not in self._skipped:
                self._skipped.update(range(first, last + 1))
                self._replace(first, last)
        return self._lines != before

    def _add_body(self, line: int) -> None:
        heading = self._lines[line - 1].rstrip()
        if heading.endswith(":"):
            self._lines[line - 1] = f"{heading} pass"

    def _replace(self, first: int, last: int) -> None:
        """Replaces a command so that the following lines retain their indentation level."""
        begin = self._lines[first - 1]
        indent = begin[: _indent(begin)]
        heading = "pass"
        if self._has_body(last, len(indent)):
            clause = _CONTINUATION.match(begin)
            heading = {"else": "else:", "elif": "elif True:"}.get(
                clause[1] if clause else "", "while True:"
            )
        self._lines[first - 1 : last] = [indent + heading, *[""] * (last - first)]

    def _has_body(self, line: int, indent: int) -> bool:
        """True if the next command is indented deeper."""
        for following in self._lines[line:]:
            if following.strip() and following.lstrip()[0] != "#":
                return _indent(following) > indent
        return False


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip(" \t\f"))


def _lines_to_skip(problem: SyntaxProblem, scan: Scan) -> tuple[int, int]:
    """First and last line to skip: the whole command, or one line if brackets or quotes are not closed."""
    line = problem.position.line
    i = bisect_right(scan.spans, (line, MAX_BYTES)) - 1
    if problem.code in _ON_ONE_LINE or i < 0 or scan.spans[i][1] < line:
        return line, line
    return scan.spans[i]


_ON_ONE_LINE = ("python_bracket_not_closed", "python_bracket_not_opened", "python_text_not_closed")


def _params(code: str, line: str, place: TextPosition) -> dict[str, object]:
    if code == "python_character":
        return {"character": line[place.column : place.column + 1]}
    return {"max": MAX_NESTING} if code == "nesting_too_deep" else {}
