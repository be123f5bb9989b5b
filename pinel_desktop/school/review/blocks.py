"""A workspace as Blockly keeps it, laid out flat: its blocks, where each stands and what was set on it.

Pupils nest deeply and old files hold anything: nothing here recurses, and what is no block is passed over.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

START = "program_start"
# what runs hangs below one of these; all else lies loose on the sheet (ui/src/editor/start_block.ts)
_ROOTS = (START, "function_def")
# set by the editor on loose blocks: says where a block stands, not that somebody switched it off
_LOOSE = "pinel_loose"

Socket = tuple[str, str]
Tokens = tuple[object, ...]


@dataclass(frozen=True, slots=True)
class Value:
    """Something that was set on a block; equal where the JSON is."""

    tokens: Tokens
    kept: Any = field(compare=False)


@dataclass(frozen=True, slots=True)
class Block:
    """A block that a person put there; shadows are values of the block in which they stand.

    Attributes:
        socket: key of the block that holds it and the name of the input; ("", key of the head) of a stack on the sheet.
        values: by name: fields, inputs with a shadow, "extraState.KEY", "disabled", "comment".
        covered: inputs in which a block stands, so that the value beneath is not seen.
        in_program: whether it hangs below the start or a function.
    """

    id: str
    type: str
    socket: Socket
    values: dict[str, Value]
    covered: frozenset[str]
    in_program: bool


@dataclass(slots=True)
class Sheet:
    """All blocks by key (the block's id, made up where there is none) and the sequence in each socket."""

    blocks: dict[str, Block] = field(default_factory=dict)
    sequences: dict[Socket, list[str]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class BlocksInUse:
    """How many blocks of each type there are; the start block and shadows, which are always there, do not count.

    Attributes:
        attached: that hang below the start or a function, and hence run.
        loose: that lie on the sheet and do not run.
    """

    attached: dict[str, int]
    loose: dict[str, int]


def blocks_in_use(workspace: object) -> BlocksInUse:
    """Counts the blocks of a workspace by type, types in alphabetical order."""
    return blocks_of_sheet(read_sheet(workspace))


def blocks_of_sheet(sheet: Sheet) -> BlocksInUse:
    """The same for a workspace that was read already."""
    counts: tuple[Counter[str], Counter[str]] = (Counter(), Counter())
    for block in sheet.blocks.values():
        if block.type != START:
            counts[block.in_program][block.type] += 1
    loose, attached = (dict(sorted(count.items())) for count in counts)
    return BlocksInUse(attached, loose)


def read_sheet(workspace: object) -> Sheet:
    """The blocks of a workspace in the order of the program; none where it holds none."""
    sheet = Sheet()
    todo: list[tuple[dict[str, Any], Socket | None, bool]] = [
        (top, None, top.get("type") in _ROOTS) for top in reversed(_tops(workspace))
    ]
    while todo:
        state, socket, in_program = todo.pop()
        key = _key(state, sheet)
        socket = socket or ("", key)
        values, inside = _values(state)
        sheet.sequences.setdefault(socket, []).append(key)
        sheet.blocks[key] = Block(
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
    return sheet


def _tops(workspace: object) -> list[dict[str, Any]]:
    tops = _of(_of(workspace).get("blocks")).get("blocks")
    return [top for top in tops if isinstance(top, dict)] if isinstance(tops, list) else []


def _key(state: dict[str, Any], sheet: Sheet) -> str:
    kind, name = _text(state.get("type")), _text(state.get("id"))
    # there is one start block, whatever a loader called it
    first = f"\0{START}" if kind == START else name or f"\0{kind}"
    key, count = first, 1
    while key in sheet.blocks:
        count += 1
        key = f"{first}\0{count}"
    return key


def _values(state: dict[str, Any]) -> tuple[dict[str, Value], list[tuple[str, dict[str, Any]]]]:
    """What was set on a block, also in its shadows; and the blocks that stand in its inputs, by input."""
    values = dict(_settings(state, "", alone=False))
    inside: list[tuple[str, dict[str, Any]]] = []
    if _is_off(state):
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
    """Fields and shape; the one field of a shadow goes by the name of the input."""
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


def _is_off(state: dict[str, Any]) -> bool:
    reasons = state.get("disabledReasons")
    if isinstance(reasons, list):
        return any(reason != _LOOSE for reason in reasons)
    return state.get("enabled") is False


def _value(kept: object) -> Value:
    """With its tokens, which are equal for equal JSON only: Python takes `True` and `1` for the same."""
    found: list[object] = []
    todo = [kept]
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
    return Value(tuple(found), kept)


def _of(value: object) -> dict[str, Any]:
    return value if isinstance(value, dict) else {}


def _text(value: object) -> str:
    return value if isinstance(value, str) else ""
