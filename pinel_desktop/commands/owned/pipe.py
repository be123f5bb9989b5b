"""The pipes between the app and a supervised process."""

import contextlib
import logging
import os
import signal
import sys
from collections.abc import Iterator
from typing import BinaryIO


@contextlib.contextmanager
def pipes() -> Iterator[tuple[BinaryIO, BinaryIO]]:
    """Yields the input pipe with the app's messages, and the output pipe for responses. Call it before anything prints.

    Ctrl+C in a terminal reaches the whole process group; the app ends this process by closing its pipe. Standard
    output goes to standard error, so that prints of libraries do not corrupt the responses.
    """
    logging.basicConfig(stream=sys.stderr, level=logging.INFO)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    with answers:
        yield sys.stdin.buffer, answers
