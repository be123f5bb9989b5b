"""The pipes of a process that the app owns."""

import contextlib
import logging
import os
import signal
import sys
from collections.abc import Iterator
from typing import BinaryIO


@contextlib.contextmanager
def pipes() -> Iterator[tuple[BinaryIO, BinaryIO]]:
    """Messages of the app, and the pipe for answers. Must be called before anything prints.

    Ctrl+C in a terminal reaches the whole process group; the app ends this process by closing its pipe. Standard
    output goes to standard error, so that prints of libraries do not corrupt the answers.
    """
    logging.basicConfig(stream=sys.stderr, level=logging.INFO)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    with answers:
        yield sys.stdin.buffer, answers
