"""What is wrong with a document, as data."""

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Fault:
    """One thing wrong with a document.

    Attributes:
        code: key of `messages/` for message and remedy.
        pointer: JSON pointer (RFC 6901) to the place in the document as it was given.
        block: id of the Blockly block the place belongs to, or None.
        params: what fills the placeholders of the words, such as value, min and max.
    """

    code: str
    pointer: str = ""
    block: str | None = None
    params: dict[str, object] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        # What a fault shows was in a file that may hold anything: it must always be writable as JSON and text.
        object.__setattr__(self, "pointer", writable(self.pointer))
        object.__setattr__(self, "block", None if self.block is None else writable(self.block))
        params = {name: _shown(value) for name, value in self.params.items()}
        object.__setattr__(self, "params", params)


_LONGEST_SHOWN = 200
_LARGEST_SHOWN = 10**15


def writable(text: str) -> str:
    """The text with lone surrogates, which no encoding can write, spelled out."""
    return text.encode("utf-8", "backslashreplace").decode("utf-8")


def _shown(value: object) -> object:
    """A value short enough and tame enough to be shown."""
    if isinstance(value, str):
        return writable(value[:_LONGEST_SHOWN])
    if isinstance(value, int) and abs(value) > _LARGEST_SHOWN:
        digits = str(value)
        return f"{digits[:12]}… ({len(digits)})"
    if isinstance(value, list | tuple):  # of names to choose from
        return [_shown(one) for one in value]
    if isinstance(value, Mapping):
        return type(value).__name__
    return value
