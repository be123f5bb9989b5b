"""A first look at a document's size and shape, before anything recurses into it."""

from typing import Any

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_COMMANDS, MAX_NESTING
from pinel_desktop.program.translation import pointer


def check_outline(document: Any) -> list[Fault]:
    """Faults of a document that is no list or object, nests too deep or has too many commands."""
    if not isinstance(document, dict | list):
        return [Fault("not_a_program", params={"value": type(document).__name__})]
    n_commands = 0
    waiting: list[tuple[Any, tuple[str | int, ...], int, str | None]] = [(document, (), 0, None)]
    while waiting:
        value, path, depth, block = waiting.pop()
        if isinstance(value, dict):
            block = value["block"] if isinstance(value.get("block"), str) else block
            n_commands += "action" in value
            depth += 1
        if depth > MAX_NESTING + 1:
            return [Fault("nesting_too_deep", pointer(path), block, {"max": MAX_NESTING})]
        children = value.items() if isinstance(value, dict) else enumerate(value)
        waiting.extend(
            (child, (*path, key), depth + isinstance(value, list) * isinstance(child, list), block)
            for key, child in children
            if isinstance(child, dict | list)
        )
    if n_commands > MAX_COMMANDS:
        return [Fault("too_many_commands", params={"value": n_commands, "max": MAX_COMMANDS})]
    return []
