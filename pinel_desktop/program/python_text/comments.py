"""Comments: their text form, and the command to which a comment in a Python text belongs.

Comments are written on the lines before their command. On reading, a comment at the end of a command's line also
belongs to that command, and one after the last command of a block to the last command.
"""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

# characters that a text file cannot hold, or that some editors take for line ends
_UNWRITABLE = "[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff]"
_TO_ESCAPE = re.compile(rf"\\(?=[\\xu]|{_UNWRITABLE})|{_UNWRITABLE}")
_ESCAPED = re.compile(r"\\\\|\\x([0-9a-f]{2})|\\u([0-9a-f]{4})")


def comment_text(line: str) -> str:
    """A line of a comment as it is written, with invalid characters escaped, such as `\\x0c`."""
    return _TO_ESCAPE.sub(_spelled, line)


def _spelled(match: re.Match[str]) -> str:
    char = match[0]
    if char == "\\":
        return "\\\\"
    code = ord(char)
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}"


def comment_line(written: str) -> str:
    """The line of a comment, unescaped, from the text after its `#`."""
    return _ESCAPED.sub(_read, written.removeprefix(" "))


def _read(match: re.Match[str]) -> str:
    if match[0] == "\\\\":
        return "\\"
    char = chr(int(match[1] or match[2], 16))
    return char if re.match(_UNWRITABLE, char) else match[0]


@dataclass(frozen=True, slots=True)
class Comment:
    """A comment in a Python text.

    Attributes:
        line, column: position of the `#`, line from 1, column from 0.
        written: the text after the `#`.
        alone: True if the line has nothing else.
    """

    line: int
    column: int
    written: str
    alone: bool


@dataclass(frozen=True, slots=True)
class Anchor:
    """A command or function in a Python text, to which comments can be attached.

    Attributes:
        line, column: its start, line from 1, column from 0.
        last_line: its last line, without the body.
        target: the part of the document that gets the comment, usually the command; None if there is none.
    """

    line: int
    column: int
    last_line: int
    target: dict[str, Any] | None


def attach(comments: Sequence[Comment], anchors: Sequence[Anchor]) -> None:
    """Stores each comment in the `comment` of its command."""
    ordered = sorted(anchors, key=lambda anchor: (anchor.line, anchor.column))
    starts = [anchor.line for anchor in ordered]
    lines: dict[int, list[str]] = {}
    targets: dict[int, dict[str, Any]] = {}
    for comment in comments:
        target = _target(comment, ordered, starts)
        if target is not None:
            targets[id(target)] = target
            lines.setdefault(id(target), []).append(comment_line(comment.written))
    for key, target in targets.items():
        inside = [target["comment"]] if "comment" in target else []
        target["comment"] = "\n".join([*lines[key], *inside])


def _target(comment: Comment, anchors: list[Anchor], starts: list[int]) -> dict[str, Any] | None:
    """The part of the document that gets a comment. After `else:` it is the next command."""
    i = bisect_right(starts, comment.line) - 1
    if i >= 0 and comment.line <= anchors[i].last_line:
        return anchors[i].target
    following = bisect_left(starts, comment.line)
    if following < len(anchors) and (
        not comment.alone or comment.column <= anchors[following].column
    ):
        return anchors[following].target
    return _before(comment, anchors, i)


def _before(comment: Comment, anchors: list[Anchor], i: int) -> dict[str, Any] | None:
    """For a comment at the end of a block: the last command of that block."""
    while i > 0 and anchors[i].column > comment.column:
        i -= 1
    return anchors[i].target if i >= 0 else None
