"""The difference of two versions of a program, block by block."""

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from pinel_desktop.school.review.blocks import START, Block, FlatWorkspace, Socket, flatten

# exceeds any number of blocks: stacks with the same root always match
_ROOT_WEIGHT = 10**9


@dataclass(frozen=True, slots=True)
class BlockRef:
    """A block; `block` is its id."""

    block: str
    type: str


@dataclass(frozen=True, slots=True)
class Change:
    """A changed value of a block; `before` or `after` is None if the value was or is absent.

    Attributes:
        name: a field, an input with a value, "extraState.KEY" (the block's shape), "type", "disabled" or "comment".
    """

    name: str
    before: Any
    after: Any


@dataclass(frozen=True, slots=True)
class ChangedBlock:
    """A block of both versions with its changed values."""

    block: str
    type: str
    what: tuple[Change, ...]


@dataclass(frozen=True, slots=True)
class Counts:
    """Numbers of blocks; a block that was moved and changed counts twice."""

    added: int = 0
    removed: int = 0
    changed: int = 0
    moved: int = 0


@dataclass(frozen=True, slots=True)
class Difference:
    """Blocks that were added, removed, changed and moved.

    A block counts as moved if its parent or input differs, or its order relative to other blocks of its sequence. It
    does not if blocks were only added or removed before it, or if its whole loose stack has another position.
    """

    added: tuple[BlockRef, ...] = ()
    removed: tuple[BlockRef, ...] = ()
    changed: tuple[ChangedBlock, ...] = ()
    moved: tuple[BlockRef, ...] = ()

    @property
    def summary(self) -> Counts:
        """The number of blocks in each list."""
        return Counts(len(self.added), len(self.removed), len(self.changed), len(self.moved))


def difference(before: object, after: object) -> Difference:
    """Compares two workspaces as Blockly serialises them, by the ids of their blocks.

    Accepts any object and ignores JSON that is no block. Shadow blocks are values of their parents. The start block
    never counts as added, removed or moved. If the arguments are swapped, added and removed blocks are swapped and the
    moved blocks are the same.
    """
    return difference_of_flat(flatten(before), flatten(after))


def difference_of_flat(old: FlatWorkspace, new: FlatWorkspace) -> Difference:
    """As `difference`, for flattened workspaces."""
    moved = _moved(old, new)
    return Difference(
        added=_block_refs(new, (key for key in new.blocks if key not in old.blocks)),
        removed=_block_refs(old, (key for key in old.blocks if key not in new.blocks)),
        changed=tuple(_changed(old, new)),
        moved=_block_refs(new, (key for key in new.blocks if key in moved)),
    )


def _block_refs(flat: FlatWorkspace, keys: Iterator[str]) -> tuple[BlockRef, ...]:
    blocks = (flat.blocks[key] for key in keys)
    return tuple(BlockRef(block.id, block.type) for block in blocks if block.type != START)


def _changed(old: FlatWorkspace, new: FlatWorkspace) -> Iterator[ChangedBlock]:
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
            continue  # a block was inserted over the value or removed; that block reports it
        if first != then:
            yield Change(name, first and first.json_value, then and then.json_value)


def _is_covered(name: str, block: Block) -> bool:
    return any(name == socket or name.startswith(f"{socket}.") for socket in block.covered)


def _moved(old: FlatWorkspace, new: FlatWorkspace) -> set[str]:
    """Keys of the moved blocks: the smallest set whose move turns the old order into the new one."""
    matches = _matching_stacks(old, new)
    moved: set[str] = set()
    for socket, keys in new.sequences.items():
        match = matches.get(socket) if socket[0] == "" else socket
        common = [key for key in keys if key in old.blocks]
        here = [key for key in common if old.blocks[key].socket == match]
        moved.update(common)
        if here and match:
            place = {key: index for index, key in enumerate(old.sequences[match])}
            moved.difference_update(_increasing_subsequence(here, [place[key] for key in here]))
    return moved


def _matching_stacks(old: FlatWorkspace, new: FlatWorkspace) -> dict[Socket, Socket]:
    """Maps top-level stacks, new to old: first stacks with the same root, then pairs that share most blocks."""
    shared: Counter[tuple[Socket, Socket]] = Counter()
    first_key: dict[tuple[Socket, Socket], str] = {}
    for key, block in new.blocks.items():
        was = old.blocks.get(key)
        if was and block.socket[0] == was.socket[0] == "":
            pair = (block.socket, was.socket)
            is_root = block.in_program and was.in_program and block.socket == was.socket
            shared[pair] += _ROOT_WEIGHT if is_root and block.socket[1] == key else 1
            first_key[pair] = min(key, first_key.get(pair, key))
    matches: dict[Socket, Socket] = {}
    # pairs share no blocks, so the sort order is the same if old and new are swapped
    used: set[Socket] = set()
    for now, then in sorted(shared, key=lambda pair: (-shared[pair], first_key[pair])):
        if now not in matches and then not in used:
            matches[now] = then
            used.add(then)
    return matches


def _increasing_subsequence(keys: Sequence[str], places: Sequence[int]) -> list[str]:
    """The longest subsequence with increasing places; among several, the choice is symmetric in old and new."""
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
    """For each index, the length of the longest increasing subsequence that starts there."""
    ends: list[int] = []
    lengths = [0] * len(places)
    for index in range(len(places) - 1, -1, -1):
        at = bisect_left(ends, -places[index])
        ends[at : at + 1] = [-places[index]]
        lengths[index] = at + 1
    return lengths
