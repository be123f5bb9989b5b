"""Reads the bytes of a program file: a document, a bare list of commands, or Python text."""

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.python_text import read_python
from pinel_desktop.program.reading import ParseResult, read_document

_BLANK = b"\xef\xbb\xbf \t\r\n"


def is_python(data: bytes, name: str = "") -> bool:
    """True for Python text, by the extension of the name, else by the first character."""
    ending = name.lower().rpartition(".")[2]
    if ending in ("py", "json"):
        return ending == "py"
    return data.strip(_BLANK)[:1] not in (b"", b"{", b"[")


def read_source(data: bytes, name: str = "") -> ParseResult:
    """Reads a program from the content of a file. Faults of Python text have `line` and `column`."""
    if not is_python(data, name):
        return read_document(data)
    if len(data) > MAX_BYTES:
        params: dict[str, object] = {"value": len(data), "max": MAX_BYTES, "line": 1, "column": 1}
        return ParseResult(None, (Fault("document_too_large", params=params),))
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        return ParseResult(None, (_not_text(data[: error.start]),))
    return read_python(text).result


def _not_text(before: bytes) -> Fault:
    lines = before.decode("utf-8").split("\n")
    params: dict[str, object] = {"line": len(lines), "column": len(lines[-1]) + 1}
    return Fault("python_not_utf8", params=params)
