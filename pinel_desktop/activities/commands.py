"""The commands of a program document, each with its JSON pointer and its depth in loops."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pinel_desktop.program.model import MOTIONS

LOOPS = frozenset({"repeat", "while", "until", "for", "forever"})
DRIVING = tuple(action for action, motion in MOTIONS.items() if motion != "turn")
TURNING = tuple(action for action, motion in MOTIONS.items() if motion in ("turn", "arc"))


@dataclass(frozen=True, slots=True)
class Command:
    """One command of a document.

    Attributes:
        pointer: JSON pointer of the command.
        data: the command itself.
        n_loops: number of loops around the command.
    """

    pointer: str
    data: Mapping[str, Any]
    n_loops: int

    @property
    def action(self) -> str:
        return str(self.data.get("action"))

    @property
    def block(self) -> str | None:
        """Id of the command's block; None for a program without blocks."""
        block = self.data.get("block")
        return block if isinstance(block, str) else None


def commands_of(document: Mapping[str, Any]) -> tuple[Command, ...]:
    """Returns all commands of a document in order, commands of functions last."""
    found = list(_in_list(document.get("commands"), "/commands", 0))
    for i, function in enumerate(_items(document.get("functions"))):
        found += _in_list(function.get("commands"), f"/functions/{i}/commands", 0)
    return tuple(found)


def _in_list(commands: Any, pointer: str, n_loops: int) -> Iterator[Command]:
    for i, data in enumerate(_items(commands)):
        here = f"{pointer}/{i}"
        yield Command(here, data, n_loops)
        inside = n_loops + (data.get("action") in LOOPS)
        yield from _in_list(data.get("commands"), f"{here}/commands", inside)
        for j, branch in enumerate(_items(data.get("elif"))):
            yield from _in_list(branch.get("commands"), f"{here}/elif/{j}/commands", inside)
        yield from _in_list(data.get("else"), f"{here}/else", inside)


def _items(value: Any) -> Sequence[Mapping[str, Any]]:
    return [one for one in value if isinstance(one, dict)] if isinstance(value, list) else []


def nesting_of(commands: Sequence[Command]) -> int:
    """Returns the maximum nesting depth of loops; 1 for a single loop."""
    return max((one.n_loops + 1 for one in commands if one.action in LOOPS), default=0)
