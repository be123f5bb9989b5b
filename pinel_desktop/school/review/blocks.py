"""Flattens a workspace as Blockly serialises it: its blocks, each with position and values.

Workspaces may be nested deeply and old files may hold any JSON. So nothing here recurses, and JSON that is no block is
ignored.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

START = "program_start"
# blocks attached to one of these run; all others are loose (ui/src/editor/start_block.ts)
_ROOTS = (START, "function_def")
# the reason with which the editor disables loose blocks; a person did not disable them
_LOOSE = "pinel_loose"

Socket = tuple[str, str]
Tokens = tuple[object, ...]


@dataclass(frozen=True, slots=True)
class Value:
    """A value set on a block; two are equal if their JSON is equal."""

    tokens: Tokens
    json_value: Any = field(compare=False)


@dataclass(frozen=True, slots=True)
class Block:
    """A block; shadow blocks are values of their parent instead.

    Attributes:
        socket: (key of the parent block, name of the input), or ("", key of the first block) in a top-level stack.
        values: by name: fields, inputs with a shadow, "extraState.KEY", "disabled", "comment".
        covered: inputs that hold a block, which hides the value of their shadow.
        in_program: True if attached to the start block or a function.
    """

    id: str
    type: str
    socket: Socket
    values: dict[str, Value]
    covered: frozenset[str]
    in_program: bool


@dataclass(slots=True)
class FlatWorkspace:
    """All blocks of a workspace.

    Attributes:
        blocks: by key, in the order of the program; the key is the block's id, generated if it has none.
        sequences: keys of the blocks in each socket, in order.
    """

    blocks: dict[str, Block] = field(default_factory=dict)
    sequences: dict[Socket, list[str]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class BlocksInUse:
    """Numbers of blocks by type, without the start block and shadow blocks.

    Attributes:
        attached: blocks attached to the start block or a function, which run.
        loose: all other blocks, which do not run.
    """

    attached: dict[str, int]
    loose: dict[str, int]


def blocks_in_use(workspace: object) -> BlocksInUse:
    """Counts the blocks of a workspace by type, types in alphabetical order."""
    return blocks_in_flat(flatten(workspace))


def blocks_in_flat(flat: FlatWorkspace) -> BlocksInUse:
    """As `blocks_in_use`, for a flattened workspace."""
    counts: tuple[Counter[str], Counter[str]] = (Counter(), Counter())
    for block in flat.blocks.values():
        if block.type != START:
            counts[block.in_program][block.type] += 1
    loose, attached = (dict(sorted(count.items())) for count in counts)
    return BlocksInUse(attached, loose)


def flatten(workspace: object) -> FlatWorkspace:
    """Flattens a workspace; the result is empty if `workspace` holds no blocks."""
    flat = FlatWorkspace()
    todo: list[tuple[dict[str, Any], Socket | None, bool]] = [
        (top, None, top.get("type") in _ROOTS) for top in reversed(_tops(workspace))
    ]
    while todo:
        state, socket, in_program = todo.pop()
        key = _key(state, flat)
        socket = socket or ("", key)
        values, inside = _values(state)
        flat.sequences.setdefault(socket, []).append(key)
        flat.blocks[key] = Block(
            id=_text(state.get("id")),
            type=_text(state.get("type")),
            socket=socket,
            values=values,
            covered=frozenset(name for name, _ in inside),
            in_program=in_program,
        )
        below = _of(state.get("next")).get("block")
        if isinstance(below, dict):
            todo.append((below, socket, in_program))
        todo.extend((block, (key, name), in_program) for name, block in reversed(inside))
    return flat


def _tops(workspace: object) -> list[dict[str, Any]]:
    tops = _of(_of(workspace).get("blocks")).get("blocks")
    return [top for top in tops if isinstance(top, dict)] if isinstance(tops, list) else []


def _key(state: dict[str, Any], flat: FlatWorkspace) -> str:
    kind, name = _text(state.get("type")), _text(state.get("id"))
    # the start block has a fixed key: there is only one, whatever its id
    first = f"\0{START}" if kind == START else name or f"\0{kind}"
    key, count = first, 1
    while key in flat.blocks:
        count += 1
        key = f"{first}\0{count}"
    return key


def _values(state: dict[str, Any]) -> tuple[dict[str, Value], list[tuple[str, dict[str, Any]]]]:
    """Returns the values of a block and its shadows by name, and the blocks in its inputs as (input, block)."""
    values = dict(_settings(state, "", alone=False))
    inside: list[tuple[str, dict[str, Any]]] = []
    if _is_disabled(state):
        values["disabled"] = _value(True)
    comment = _of(_of(state.get("icons")).get("comment")).get("text")
    if comment:
        values["comment"] = _value(comment)
    todo = [("", state)]
    while todo:
        prefix, holder = todo.pop()
        for name, connection in _of(holder.get("inputs")).items():
            block, shadow = (_of(connection).get(kind) for kind in ("block", "shadow"))
            if isinstance(block, dict):
                inside.append((prefix + name, block))
            elif isinstance(shadow, dict):
                values.update(_settings(shadow, prefix + name, alone=True))
                todo.append((f"{prefix}{name}.", shadow))
    return values, inside


def _settings(state: dict[str, Any], name: str, *, alone: bool) -> Iterator[tuple[str, Value]]:
    """Yields fields and extra state by name; if a shadow has one field, it gets the name of the shadow's input."""
    fields = _of(state.get("fields"))
    prefix = f"{name}." if name else ""
    for field_name, value in fields.items():
        is_value = alone and len(fields) == 1
        yield name if is_value else prefix + field_name, _value(value)
    shape = state.get("extraState")
    if isinstance(shape, dict):
        for part, value in shape.items():
            yield f"{prefix}extraState.{part}", _value(value)
    elif shape is not None:
        yield f"{prefix}extraState", _value(shape)


def _is_disabled(state: dict[str, Any]) -> bool:
    reasons = state.get("disabledReasons")
    if isinstance(reasons, list):
        return any(reason != _LOOSE for reason in reasons)
    return state.get("enabled") is False


def _value(json_value: object) -> Value:
    """Returns a value with tokens that are equal only for equal JSON; in Python `True == 1`."""
    found: list[object] = []
    todo = [json_value]
    while todo:
        part = todo.pop()
        if isinstance(part, dict):
            found.append(("{", len(part)))
            for name in sorted(part, reverse=True):
                todo.extend((part[name], name))
        elif isinstance(part, list):
            found.append(("[", len(part)))
            todo.extend(reversed(part))
        else:
            found.append((isinstance(part, bool), part))
    return Value(tuple(found), json_value)


def _of(value: object) -> dict[str, Any]:
    return value if isinstance(value, dict) else {}


def _text(value: object) -> str:
    return value if isinstance(value, str) else ""
