"""Comments: how a line of one is written, and which command a comment in a Python text belongs to.

A comment stands on the lines before its command. A reader also finds comments elsewhere: one behind a command belongs
to it, and one after the last command of a block to that command.
"""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

# what cannot stand in a text file, or ends a line in some editors
_UNWRITABLE = "[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff]"
_TO_ESCAPE = re.compile(rf"\\(?=[\\xu]|{_UNWRITABLE})|{_UNWRITABLE}")
_ESCAPED = re.compile(r"\\\\|\\x([0-9a-f]{2})|\\u([0-9a-f]{4})")


def comment_text(line: str) -> str:
    """A line of a comment as it is written, what cannot be in a text spelled out, as in `\\x0c`."""
    return _TO_ESCAPE.sub(_spelled, line)


def _spelled(match: re.Match[str]) -> str:
    char = match[0]
    if char == "\\":
        return "\\\\"
    code = ord(char)
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}"


def comment_line(written: str) -> str:
    """The line of a comment from what follows its `#`."""
    return _ESCAPED.sub(_read, written.removeprefix(" "))


def _read(match: re.Match[str]) -> str:
    if match[0] == "\\\\":
        return "\\"
    char = chr(int(match[1] or match[2], 16))
    return char if re.match(_UNWRITABLE, char) else match[0]


@dataclass(frozen=True, slots=True)
class Comment:
    """A comment in a Python text: its place (line from 1, column from 0), what follows `#`, whether it stands alone."""

    line: int
    column: int
    written: str
    alone: bool


@dataclass(frozen=True, slots=True)
class Anchor:
    """A command or function in a Python text, which may have comments.

    Attributes:
        line, column: where it begins, line from 1, column from 0.
        last_line: where it ends; with a body, where its heading ends.
        target: the command, or what a comment here is put on instead; None where there is nothing.
    """

    line: int
    column: int
    last_line: int
    target: dict[str, Any] | None


def attach(comments: Sequence[Comment], anchors: Sequence[Anchor]) -> None:
    """Puts each comment on the command it belongs to, as its `comment`."""
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
    """What a comment is put on. Behind an `else:` it belongs to what follows."""
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
    """The last command of the block that a comment at its end belongs to."""
    while i > 0 and anchors[i].column > comment.column:
        i -= 1
    return anchors[i].target if i >= 0 else None
