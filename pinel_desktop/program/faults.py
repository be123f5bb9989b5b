"""What is wrong with a document, as data."""

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
