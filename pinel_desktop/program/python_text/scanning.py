"""Scans a Python text for comments, brackets and quotes, before it is parsed.

Finds what Python's parser drops (comments, which `if` is an `elif`), problems that it explains badly (unclosed brackets
and quotes), and input that must not reach it (brackets nested too deep).
"""

import re
from dataclasses import dataclass, field

from pinel_desktop.program.limits import MAX_COMMANDS, MAX_NESTING
from pinel_desktop.program.python_text.comments import Comment

_MAX_BRACKETS = MAX_NESTING + 16  # sufficient for an expression of 64 levels
MAX_FAULTS = 1_000  # more are not recorded
_MAX_PARSED_COMMANDS = 5 * MAX_COMMANDS
_MAX_DIGITS = 400  # a double has less than 310
_CLOSING = {"(": ")", "[": "]", "{": "}"}
_TOKEN = re.compile(
    r'''
    (?P<space>[ \t\f]++|\\\n)
    |(?P<newline>\n)
    |(?P<comment>\#[^\n]*+)
    |(?P<string>(?:[rRbBuUfF]{1,2})?(?:
        """[^"\\]*(?:(?:\\.|"(?!""))[^"\\]*)*""" | \'\'\'[^'\\]*(?:(?:\\.|'(?!''))[^'\\]*)*\'\'\'
        | "(?!"")[^"\\\n]*(?:\\.[^"\\\n]*)*" | '(?!'')[^'\\\n]*(?:\\.[^'\\\n]*)*'
        | ""(?!") | \'\'(?!')
    ))
    |(?P<open_bracket>[(\[{])
    |(?P<close>[)\]}])
    |(?P<quote>"""|\'\'\'|["'])
    |(?P<name_or_number>\w++)
    |(?P<sign>[^\w\s"'#()\[\]{}\\]++)
    |(?P<other>.)
    ''',
    re.VERBOSE | re.DOTALL,
)


@dataclass(frozen=True, slots=True)
class TextPosition:
    """A place in a text: line from 1, column from 0."""

    line: int
    column: int


@dataclass(frozen=True, slots=True)
class SyntaxProblem:
    """A problem that prevents parsing."""

    code: str
    position: TextPosition
    params: dict[str, object] = field(default_factory=dict)


@dataclass(slots=True)
class Scan:
    """Result of scanning a text.

    Attributes:
        comments: all comments.
        elifs: start of each `elif`.
        problems: problems that prevent parsing.
        spans: first and last line of each command.
        max_command_start: start of the command with the most tokens.
    """

    comments: list[Comment] = field(default_factory=list)
    elifs: list[TextPosition] = field(default_factory=list)
    problems: list[SyntaxProblem] = field(default_factory=list)
    spans: list[tuple[int, int]] = field(default_factory=list)
    max_command_start: TextPosition = field(default_factory=lambda: TextPosition(1, 0))


def scan_text(text: str) -> Scan:
    """Scans a text whose lines end in `\\n`."""
    return _Scanner(text).scan()


class _Scanner:
    def __init__(self, text: str) -> None:
        self._text = text
        self._scan = Scan()
        self._line, self._line_start = 1, 0
        self._open: list[tuple[str, TextPosition]] = []
        self._first: TextPosition | None = None  # of the command that is being read
        self._n_tokens = self._max_tokens = 0
        self._n_commands = 0
        self._too_deep = self._too_many = False

    def scan(self) -> Scan:
        position, end = 0, len(self._text)
        while position < end:
            match = _TOKEN.match(self._text, position)
            assert match is not None
            assert match.lastgroup is not None
            position = match.end()
            if match.lastgroup == "quote":
                position = self._unclosed_quote(match)
            elif match.lastgroup != "space":
                getattr(self, f"_{match.lastgroup}")(match)
            self._count_lines(match.start(), position)
        self._end_command()
        without_end = {problem.position.line for problem in self._scan.problems}
        for bracket, place in self._open:
            if place.line in without_end:  # its end is inside an unclosed string
                continue
            self._problem("python_bracket_not_closed", place, bracket=bracket)
        return self._scan

    def _position(self, match: re.Match[str]) -> TextPosition:
        return TextPosition(self._line, match.start() - self._line_start)

    def _problem(self, code: str, place: TextPosition, **params: object) -> None:
        if len(self._scan.problems) < MAX_FAULTS:
            self._scan.problems.append(SyntaxProblem(code, place, params))

    def _count_lines(self, start: int, end: int) -> None:
        n_newlines = self._text.count("\n", start, end)
        if n_newlines:
            self._line += n_newlines
            self._line_start = self._text.rindex("\n", start, end) + 1

    def _newline(self, _match: re.Match[str]) -> None:
        if not self._open:
            self._end_command()

    def _end_command(self) -> None:
        if self._first is not None:
            self._n_commands += 1
            self._check_number(self._first)
            self._scan.spans.append((self._first.line, self._line))
            if self._n_tokens > self._max_tokens:
                self._max_tokens, self._scan.max_command_start = self._n_tokens, self._first
        self._first, self._n_tokens = None, 0

    def _comment(self, match: re.Match[str]) -> None:
        place = self._position(match)
        before = self._text[self._line_start : match.start()]
        alone = not before.strip()
        self._scan.comments.append(Comment(place.line, place.column, match[0][1:], alone))

    def _token(self, match: re.Match[str]) -> TextPosition:
        place = self._position(match)
        self._n_tokens += 1
        if self._first is None:
            self._first = place
            if match[0] == "elif":
                self._scan.elifs.append(place)
        return place

    def _name_or_number(self, match: re.Match[str]) -> None:
        place = self._token(match)
        if len(match[0]) > _MAX_DIGITS and match[0][0].isdigit():
            self._problem("python_number_too_large", place)

    def _string(self, match: re.Match[str]) -> None:
        self._token(match)

    def _sign(self, match: re.Match[str]) -> None:
        place = self._token(match)
        self._n_commands += match[0].count(";")
        self._check_number(place)

    def _check_number(self, place: TextPosition) -> None:
        """Reports a text with more commands than any program can have, which would take long to parse."""
        if self._n_commands > _MAX_PARSED_COMMANDS and not self._too_many:
            self._too_many = True
            params = {"value": self._n_commands, "max": MAX_COMMANDS}
            self._problem("too_many_commands", place, **params)

    def _other(self, match: re.Match[str]) -> None:
        self._problem("python_character", self._token(match), character=match[0])

    def _open_bracket(self, match: re.Match[str]) -> None:
        place = self._token(match)
        self._open.append((match[0], place))
        if len(self._open) > _MAX_BRACKETS and not self._too_deep:
            self._too_deep = True
            self._problem("nesting_too_deep", place, max=MAX_NESTING)

    def _close(self, match: re.Match[str]) -> None:
        place = self._token(match)
        if self._open and _CLOSING[self._open[-1][0]] == match[0]:
            self._open.pop()
        else:
            self._problem("python_bracket_not_opened", place, bracket=match[0])

    def _unclosed_quote(self, match: re.Match[str]) -> int:
        """Records an unclosed string; returns where it ends: triple-quoted at the end of the text, else of the line."""
        self._problem("python_text_not_closed", self._token(match))
        end = self._text.find("\n", match.end())
        return len(self._text) if end < 0 or len(match[0]) > 1 else end
