"""JSON lines over pipes: the message format between app and supervised processes (ARCHITECTURE.md, Processes)."""

import json
from collections.abc import Iterator
from typing import Any, BinaryIO

from pinel_desktop.errors import PinelError

Message = dict[str, Any]
# The probe: a process answers PING with PONG between two pieces of work.
PING, PONG = {"type": "ping"}, {"type": "pong"}
RESPONSE = "response"
_MAX_LINE_BYTES = 64_000_000


def response(request: int, value: Any = None, error: PinelError | None = None) -> Message:
    """Returns the response to the request with this number: a value, or an error."""
    found = {"value": value} if error is None else {"code": error.code, "params": error.params}
    return {"type": RESPONSE, "request": request, **found}


def encoded(message: Message) -> bytes:
    """Encodes a message as one line of JSON."""
    return json.dumps(message, separators=(",", ":")).encode("ascii") + b"\n"


def write_message(pipe: BinaryIO, message: Message) -> None:
    """Writes one message as one line. Raises OSError if the pipe is closed."""
    pipe.write(encoded(message))
    pipe.flush()


def read_messages(pipe: BinaryIO) -> Iterator[Message]:
    """Yields the messages of a pipe until it ends; skips lines that are too long or no JSON object."""
    while line := pipe.readline(_MAX_LINE_BYTES):
        if len(line) == _MAX_LINE_BYTES:
            _skip_line(pipe, line)
            continue
        try:
            message = json.loads(line)
        except (ValueError, RecursionError):
            continue
        if isinstance(message, dict):
            yield message


def _skip_line(pipe: BinaryIO, part: bytes) -> None:
    while part and not part.endswith(b"\n"):
        part = pipe.readline(_MAX_LINE_BYTES)
