"""A process whose standard output carries messages: prints of libraries must not corrupt them."""

import subprocess
import sys

import pytest

CHILD = """
import os, sys
from pinel_desktop.processes.standard_streams import reserve_output
output = reserve_output()
print("a library prints")
print("a library complains", file=sys.stderr, flush=True)
os.system("echo a program prints")
sys.stdout.flush()
os.write(output, b"message")
"""


@pytest.mark.parametrize("has_error_stream", [True, False])
def test_only_messages_reach_the_parent(has_error_stream: bool) -> None:
    # like the windowed program on Windows, which has no standard error to give to its children
    without = [] if has_error_stream else ["sh", "-c", 'exec "$@" 2>&-', "sh"]
    done = subprocess.run(
        [*without, sys.executable, "-c", CHILD],
        capture_output=True,
        check=True,
    )
    assert done.stdout == b"message"
    printed = sorted(done.stderr.decode().splitlines())
    assert printed == (
        ["a library complains", "a library prints", "a program prints"] if has_error_stream else []
    )
