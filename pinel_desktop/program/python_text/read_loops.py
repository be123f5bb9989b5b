"""The three forms of `for`: repeating with `range`, counting with `steps`, and counting with `range`."""

import ast
from collections.abc import Sequence
from typing import Any, Protocol

from pinel_desktop.program.python_text.diagnostics import Positioned
from pinel_desktop.program.python_text.read_expressions import ExpressionReader


class _Assigning(Protocol):
    def assigned(self, node: Positioned, name: str) -> str: ...


def loop_of_for(
    node: ast.For, statements: _Assigning, expressions: ExpressionReader, pointer: str
) -> dict[str, Any] | None:
    """The command `repeat` or `for`, without its body; None if it is neither."""
    call, target = node.iter, node.target
    if not isinstance(target, ast.Name) or not isinstance(call, ast.Call):
        return None
    args, name = call.args, call.func.id if isinstance(call.func, ast.Name) else ""
    if call.keywords or not 1 <= len(args) <= 3 or any(isinstance(a, ast.Starred) for a in args):
        return None
    if name == "range" and target.id == "_" and len(args) == 1:
        return {"action": "repeat", "times": expressions.read(args[0], f"{pointer}/times")}
    if name not in ("steps", "range") or (name == "steps" and len(args) == 1):
        return None
    places = [f"{pointer}/{key}" for key in (("to",) if len(args) == 1 else ("from", "to", "by"))]
    bounds = [expressions.read(arg, place) for arg, place in zip(args, places, strict=False)]
    if name == "range":
        counted = _counted(bounds)
        if counted is None:
            return None
        bounds = counted
    variable = statements.assigned(target, target.id)
    loop = {"action": "for", "variable": variable, "from": bounds[0], "to": bounds[1]}
    return {**loop, "by": bounds[2]} if len(bounds) > 2 else loop


def _counted(bounds: Sequence[Any]) -> list[Any] | None:
    """`from`, `to` and `by` of a `range`, which excludes its end; None if the step is not a literal number."""
    start, stop, *step = bounds if len(bounds) > 1 else (0, *bounds)
    by = step[0] if step else 1
    if isinstance(by, bool) or not isinstance(by, int) or by == 0:
        return None
    before = 1 if by > 0 else -1
    if isinstance(stop, int) and not isinstance(stop, bool):
        return [start, stop - before, *step]
    return [start, {"op": "-" if by > 0 else "+", "args": [stop, 1]}, *step]
