"""JSON lines over pipes: whatever comes, the messages among it are read."""

import io

import pytest

from pinel_desktop.processes import messages
from pinel_desktop.processes.messages import read_messages


@pytest.mark.parametrize(
    "garbage",
    [
        b"",
        b"[W:onnxruntime] warning",
        b"\xff\xfe\x00",
        b"null",
        b"[1]",
        b"[" * 200_000,
        b"9" * 5000,
    ],
    ids=["empty", "words", "octets", "null", "list", "deep", "large number"],
)
def test_a_line_that_is_no_message_is_passed_over(garbage: bytes) -> None:
    pipe = io.BytesIO(garbage + b'\n{"type": "alive"}\n')
    assert list(read_messages(pipe)) == [{"type": "alive"}]


def test_a_line_that_is_too_long_is_passed_over_as_a_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(messages, "_MAX_LINE_BYTES", 32)
    long = b'{"type": "' + 100 * b"a" + b'"}\n'
    pipe = io.BytesIO(long + b'{"type": "alive"}\n' + long)
    assert list(read_messages(pipe)) == [{"type": "alive"}]
