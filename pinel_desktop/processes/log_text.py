"""Text of log records without personal data: support may read a log file, so it has no pupils' work and no names.

A record's own text is written in this program. Everything inserted into it may come from a file or a person, so only
numbers, plain words such as the name of a table, and descriptions of exceptions are kept.
"""

import logging
import re
import traceback
from collections.abc import Iterator, Mapping
from datetime import UTC, datetime
from pathlib import PurePath
from types import TracebackType

OWN_PACKAGES = ("pinel_desktop", "storage", "sim")
# a word, an HTTP method, or a route with the names of its parameters
_PLAIN_TEXT = re.compile(r"[a-z_.]{1,40}|[A-Z]{3,7}|/[a-z_/<>:]{0,80}")
# Their messages name parts of programs, not values that the programs process.
_TECHNICAL_ERRORS = (ImportError, AttributeError, NameError, TypeError, MemoryError)
_SQLITE = ("sqlite3", "pysqlite3")
_MAX_CHARACTERS = 300
_MAX_FRAMES = 40


class PlainFormatter(logging.Formatter):
    """Formats a record as `TIME LEVEL LOGGER: TEXT`, in UTC, with the stack of its exception below.

    Of a record of another package, whose text is not known, only the place in the code is written.
    """

    def format(self, record: logging.LogRecord) -> str:
        time = f"{datetime.fromtimestamp(record.created, UTC):%Y-%m-%dT%H:%M:%SZ}"
        lines = [f"{time} {record.levelname} {record.name}: {_text(record)}"]
        if record.exc_info and record.exc_info[1] is not None:
            lines += _stack(record.exc_info[1])
        return "\n".join(lines)


def described(error: BaseException) -> str:
    """Returns the type of an exception, and what may be told of its message."""
    kind, detail = type(error).__name__, _detail(error)
    return f"{kind}: {detail}" if detail else kind


def _text(record: logging.LogRecord) -> str:
    if record.name.partition(".")[0] not in OWN_PACKAGES:
        return f"{record.filename}:{record.lineno}"
    values = (record.args,) if isinstance(record.args, Mapping) else record.args or ()
    template = str(record.msg)
    try:
        return template % tuple(_plain(value) for value in values) if values else template
    except (TypeError, ValueError):  # another kind of placeholder than `%s`
        return template


def _plain(value: object) -> object:
    match value:
        case None | bool() | int() | float():
            return value
        case BaseException():
            return described(value)
        case str() if _PLAIN_TEXT.fullmatch(value):
            return value
    return f"<{type(value).__name__}>"


def _detail(error: BaseException) -> str:
    code = getattr(error, "code", None)  # of our own errors
    if isinstance(code, str) and _PLAIN_TEXT.fullmatch(code):
        return code
    if isinstance(error, OSError) and error.errno is not None:
        return f"{error.errno} {error.strerror}"
    if isinstance(error, _TECHNICAL_ERRORS) or type(error).__module__.startswith(_SQLITE):
        return str(error)[:_MAX_CHARACTERS]
    return ""


def _stack(error: BaseException) -> Iterator[str]:
    """Yields the lines of an exception and of its causes, the first cause first."""
    for cause in reversed(list(_chain(error))):
        yield f"  {described(cause)}"
        yield from _frames(cause.__traceback__)


def _chain(error: BaseException) -> Iterator[BaseException]:
    known: set[int] = set()
    current: BaseException | None = error
    while current is not None and id(current) not in known:
        known.add(id(current))
        yield current
        hidden = None if current.__suppress_context__ else current.__context__
        current = current.__cause__ or hidden


def _frames(trace: TracebackType | None) -> Iterator[str]:
    for frame in traceback.extract_tb(trace)[-_MAX_FRAMES:]:
        yield f"    {_short(frame.filename)}:{frame.lineno} {frame.name}"


def _short(file: str) -> str:
    """Returns the path from the package on, as the folders before it may name a person."""
    parts = PurePath(file).parts
    tops = [n for n, part in enumerate(parts) if part in (*OWN_PACKAGES, "site-packages")]
    return "/".join(parts[tops[-1] :] if tops else parts[-2:])
