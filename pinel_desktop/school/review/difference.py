"""What differs between two versions of a program, block by block."""

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from pinel_desktop.school.review.blocks import START, Block, Sheet, Socket, read_sheet

# more than any workspace has blocks: the stack of one start is the same stack, whatever hangs below it now
_OF_A_ROOT = 10**9


@dataclass(frozen=True, slots=True)
class BlockMark:
    """A block; `block` is its id."""

    block: str
    type: str


@dataclass(frozen=True, slots=True)
class Change:
    """One thing that was set on a block, as it was and as it is; None where there was or is nothing.

    Attributes:
        name: of the field or of the input with its value; "extraState.KEY" (the block's shape), "type", "disabled",
            "comment".
    """

    name: str
    before: Any
    after: Any


@dataclass(frozen=True, slots=True)
class ChangedBlock:
    """A block that is in both versions, with all that was set anew on it."""

    block: str
    type: str
    what: tuple[Change, ...]


@dataclass(frozen=True, slots=True)
class Counts:
    """How many blocks; one that was both moved and changed counts in both."""

    added: int = 0
    removed: int = 0
    changed: int = 0
    moved: int = 0


@dataclass(frozen=True, slots=True)
class Difference:
    """Blocks that came, that went, that were set anew, and that stand elsewhere.

    A block is moved when another block holds it, when it is in another input, or when it has changed places with
    others of its sequence; not when others came or went before it, nor when a loose stack lies elsewhere on the sheet.
    """

    added: tuple[BlockMark, ...] = ()
    removed: tuple[BlockMark, ...] = ()
    changed: tuple[ChangedBlock, ...] = ()
    moved: tuple[BlockMark, ...] = ()

    @property
    def summary(self) -> Counts:
        """How many of each."""
        return Counts(len(self.added), len(self.removed), len(self.changed), len(self.moved))


def difference(before: object, after: object) -> Difference:
    """Compares two workspaces as Blockly saves them, by the ids of their blocks; shadows are values of their parents.

    Takes whatever there is: what is no block is passed over. The start block, which every program has, never counts
    as added, removed or moved. With the two changed round, what was added is removed, and the same blocks are moved.
    """
    return difference_of_sheets(read_sheet(before), read_sheet(after))


def difference_of_sheets(old: Sheet, new: Sheet) -> Difference:
    """The same for workspaces that were read already."""
    moved = _moved(old, new)
    return Difference(
        added=_marks(new, (key for key in new.blocks if key not in old.blocks)),
        removed=_marks(old, (key for key in old.blocks if key not in new.blocks)),
        changed=tuple(_changed(old, new)),
        moved=_marks(new, (key for key in new.blocks if key in moved)),
    )


def _marks(sheet: Sheet, keys: Iterator[str]) -> tuple[BlockMark, ...]:
    blocks = (sheet.blocks[key] for key in keys)
    return tuple(BlockMark(block.id, block.type) for block in blocks if block.type != START)


def _changed(old: Sheet, new: Sheet) -> Iterator[ChangedBlock]:
    for key, block in new.blocks.items():
        was = old.blocks.get(key)
        what = tuple(_changes(was, block)) if was else ()
        if what:
            yield ChangedBlock(block.id, block.type, what)


def _changes(was: Block, block: Block) -> Iterator[Change]:
    if was.type != block.type:
        yield Change("type", was.type, block.type)
    if was.values == block.values:
        return
    for name in dict.fromkeys((*was.values, *block.values)):
        first, then = was.values.get(name), block.values.get(name)
        if (first is None and _is_covered(name, was)) or (
            then is None and _is_covered(name, block)
        ):
            continue  # a block was put over the value or taken off it, which is told of that block
        if first != then:
            yield Change(name, first and first.kept, then and then.kept)


def _is_covered(name: str, block: Block) -> bool:
    return any(name == socket or name.startswith(f"{socket}.") for socket in block.covered)


def _moved(old: Sheet, new: Sheet) -> set[str]:
    """Keys of the blocks that stand elsewhere; the fewest that explain both orders."""
    twins = _stacks_that_stayed(old, new)
    moved: set[str] = set()
    for socket, keys in new.sequences.items():
        twin = twins.get(socket) if socket[0] == "" else socket
        common = [key for key in keys if key in old.blocks]
        here = [key for key in common if old.blocks[key].socket == twin]
        moved.update(common)
        if here and twin:
            place = {key: index for index, key in enumerate(old.sequences[twin])}
            moved.difference_update(_in_order(here, [place[key] for key in here]))
    return moved


def _stacks_that_stayed(old: Sheet, new: Sheet) -> dict[Socket, Socket]:
    """Which stack on the new sheet is which on the old: those with one head of a program, then those most alike."""
    shared: Counter[tuple[Socket, Socket]] = Counter()
    smallest: dict[tuple[Socket, Socket], str] = {}
    for key, block in new.blocks.items():
        was = old.blocks.get(key)
        if was and block.socket[0] == was.socket[0] == "":
            pair = (block.socket, was.socket)
            is_root = block.in_program and was.in_program and block.socket == was.socket
            shared[pair] += _OF_A_ROOT if is_root and block.socket[1] == key else 1
            smallest[pair] = min(key, smallest.get(pair, key))
    twins: dict[Socket, Socket] = {}
    # no two pairs have a block in common, so that the order is the same from either side
    taken: set[Socket] = set()
    for now, then in sorted(shared, key=lambda pair: (-shared[pair], smallest[pair])):
        if now not in twins and then not in taken:
            twins[now] = then
            taken.add(then)
    return twins


def _in_order(keys: Sequence[str], places: Sequence[int]) -> list[str]:
    """The longest part of the sequence that was in this order before; of several the same from either side."""
    length = _chain_lengths(places)
    by_length: dict[int, list[int]] = {}
    for index, count in enumerate(length):
        by_length.setdefault(count, []).append(index)
    found: list[str] = []
    last = -1
    for count in range(max(length), 0, -1):
        follows = (
            index
            for index in by_length[count]
            if last < 0 or (index > last and places[index] > places[last])
        )
        last = min(follows, key=lambda index: keys[index])
        found.append(keys[last])
    return found


def _chain_lengths(places: Sequence[int]) -> list[int]:
    """For each place the length of the longest rising chain that begins with it."""
    ends: list[int] = []
    lengths = [0] * len(places)
    for index in range(len(places) - 1, -1, -1):
        at = bisect_left(ends, -places[index])
        ends[at : at + 1] = [-places[index]]
        lengths[index] = at + 1
    return lengths
