"""JSON lines over pipes: how the app talks to the processes that it owns (ARCHITECTURE.md, Processes)."""

import json
from collections.abc import Iterator
from typing import Any, BinaryIO

Message = dict[str, Any]
# A process that reads answers the one with the other at once, whatever else it does.
PING, PONG = {"type": "ping"}, {"type": "pong"}
_LONGEST = 64_000_000  # octets of a line


def encoded(message: Message) -> bytes:
    """A message as one line."""
    return json.dumps(message, separators=(",", ":")).encode("ascii") + b"\n"


def write_message(pipe: BinaryIO, message: Message) -> None:
    """Writes one message as one line. Raises OSError when the pipe is closed."""
    pipe.write(encoded(message))
    pipe.flush()


def read_messages(pipe: BinaryIO) -> Iterator[Message]:
    """The messages of a pipe until it ends; lines that are too long or no JSON object are passed over."""
    while line := pipe.readline(_LONGEST):
        if len(line) == _LONGEST:
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
        part = pipe.readline(_LONGEST)
