"""The pipes between the app and a supervised process."""

import contextlib
import logging
import os
import signal
import sys
from collections.abc import Iterator
from typing import BinaryIO

from pinel_desktop.processes.log_file import start_child_log
from pinel_desktop.processes.standard_streams import reserve_output

_log = logging.getLogger(__name__)


@contextlib.contextmanager
def pipes(process: str) -> Iterator[tuple[BinaryIO, BinaryIO]]:
    """Yields the input pipe with the app's messages, and the output pipe for responses. Call it before anything prints.

    Also starts the log of the process, whose name is given.
    Ctrl+C in a terminal reaches the whole process group; the app ends this process by closing its pipe.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with os.fdopen(reserve_output(), "wb") as answers:
        start_child_log(process)
        _log.info("the process starts")
        yield sys.stdin.buffer, answers
