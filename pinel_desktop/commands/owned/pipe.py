"""The pipes between the app and a supervised process."""

import contextlib
import logging
import os
import signal
import sys
from collections.abc import Iterator
from typing import BinaryIO

from pinel_desktop.processes.standard_streams import reserve_output


@contextlib.contextmanager
def pipes() -> Iterator[tuple[BinaryIO, BinaryIO]]:
    """Yields the input pipe with the app's messages, and the output pipe for responses. Call it before anything prints.

    Ctrl+C in a terminal reaches the whole process group; the app ends this process by closing its pipe.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with os.fdopen(reserve_output(), "wb") as answers:
        logging.basicConfig(stream=sys.stderr, level=logging.INFO)
        yield sys.stdin.buffer, answers
