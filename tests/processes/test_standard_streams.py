"""The standard streams: messages that prints must not corrupt, and streams that Windows lacks or reads differently."""

import io
import subprocess
import sys

import pytest

from pinel_desktop.processes.standard_streams import error_output, use_utf8

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


def test_a_child_of_a_program_without_error_stream_gets_the_null_device(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert error_output() is None
    monkeypatch.setattr(sys, "stderr", None)
    assert error_output() == subprocess.DEVNULL


def test_pipes_carry_utf8_whatever_the_encoding_of_the_pc(monkeypatch: pytest.MonkeyPatch) -> None:
    printed = io.BytesIO()
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO("avançar".encode()), "cp1252"))
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(printed, "cp1252", write_through=True))
    monkeypatch.setattr(sys, "stderr", None)
    use_utf8()
    print(sys.stdin.read(), "→ 1 m", end="")
    assert printed.getvalue().decode() == "avançar → 1 m"
