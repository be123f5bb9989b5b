"""Faults of a document."""

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Fault:
    """One fault of a document.

    Attributes:
        code: key of message and remedy in `messages/`.
        pointer: JSON pointer (RFC 6901) to the place in the original document.
        block: id of the Blockly block of that place, or None.
        params: values of the message's placeholders, such as value, min and max.
    """

    code: str
    pointer: str = ""
    block: str | None = None
    params: dict[str, object] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        # files may contain anything, but a fault must be encodable as JSON and text
        object.__setattr__(self, "pointer", encodable(self.pointer))
        object.__setattr__(self, "block", None if self.block is None else encodable(self.block))
        params = {name: _shown(value) for name, value in self.params.items()}
        object.__setattr__(self, "params", params)


_MAX_SHOWN_LENGTH = 100  # more than any message shows
_MAX_SHOWN_NUMBER = 10**15


def encodable(text: str) -> str:
    """Escapes lone surrogates, which UTF-8 cannot encode."""
    return text.encode("utf-8", "backslashreplace").decode("utf-8")


def _shown(value: object) -> object:
    """A value shortened for a message."""
    if isinstance(value, str):
        return encodable(value[:_MAX_SHOWN_LENGTH])
    if isinstance(value, int) and abs(value) > _MAX_SHOWN_NUMBER:
        digits = str(value)
        return f"{digits[:12]}… ({len(digits)})"
    if isinstance(value, list | tuple):  # names to choose from
        return [_shown(one) for one in value]
    if isinstance(value, Mapping):
        return type(value).__name__
    return value
