"""JSON lines over pipes: how the app talks to the processes that it owns (ARCHITECTURE.md, Processes)."""

import json
from collections.abc import Iterator
from typing import Any, BinaryIO

Message = dict[str, Any]


def write_message(pipe: BinaryIO, message: Message) -> None:
    """Writes one message as one line. Raises OSError when the pipe is closed."""
    pipe.write(json.dumps(message, separators=(",", ":")).encode("ascii") + b"\n")
    pipe.flush()


def read_messages(pipe: BinaryIO) -> Iterator[Message]:
    """The messages of a pipe until it ends; lines that are no JSON object are passed over."""
    for line in pipe:
        try:
            message = json.loads(line)
        except ValueError:
            continue
        if isinstance(message, dict):
            yield message
