"""Checks the size and depth of a document, before other code recurses into it."""

from typing import Any

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_COMMANDS, MAX_NESTING
from pinel_desktop.program.pointers import Path, pointer


class _TooDeepError(Exception):
    pass


def check_shape(document: Any) -> list[Fault]:
    """Faults of a document that is neither list nor object, is nested too deep, or has too many commands."""
    if not isinstance(document, dict | list):
        return [Fault("not_a_program", params={"value": type(document).__name__})]
    try:
        n_commands = _count_commands(document, isinstance(document, dict))
    except _TooDeepError:
        return [_too_deep(document)]
    if n_commands > MAX_COMMANDS:
        return [Fault("too_many_commands", params={"value": n_commands, "max": MAX_COMMANDS})]
    return []


def _count_commands(value: Any, depth: int) -> int:
    """Counts the commands in a list or object at `depth`. Raises _TooDeepError beyond the maximum depth.

    Commands with literal parameters only, which are nearly all, are counted without a recursive call.
    """
    if depth > MAX_NESTING + 1:
        raise _TooDeepError
    if value.__class__ is dict:
        count, in_list, children = int("action" in value), False, value.values()
    else:
        count, in_list, children = 0, True, value
    for child in children:
        kind = child.__class__
        if kind is dict:
            if depth > MAX_NESTING:
                raise _TooDeepError
            for part in child.values():
                if part.__class__ is dict or part.__class__ is list:
                    count += _count_commands(child, depth + 1)
                    break
            else:
                count += "action" in child
        elif kind is list:
            count += _count_commands(child, depth + in_list)
    return count


def _too_deep(document: Any) -> Fault:
    """The fault at the first place that is too deep; slower than counting, so only used for invalid documents."""
    waiting: list[tuple[Any, Path, int, str | None]] = [
        (document, (), int(isinstance(document, dict)), None)
    ]
    while waiting:
        value, path, depth, block = waiting.pop()
        if isinstance(value, dict):
            block = value["block"] if isinstance(value.get("block"), str) else block
        if depth > MAX_NESTING + 1:
            return Fault("nesting_too_deep", pointer(path), block, {"max": MAX_NESTING})
        in_list = isinstance(value, list)
        children = enumerate(value) if in_list else value.items()
        waiting += [
            (child, (*path, key), depth + (in_list or isinstance(child, dict)), block)
            for key, child in children
            if isinstance(child, dict | list)
        ]
    raise AssertionError("nothing is too deep")
