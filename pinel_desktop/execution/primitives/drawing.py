"""The pen and marks on the floor."""

from typing import Literal

from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.places import place_under
from pinel_desktop.execution.primitives.base import instant
from pinel_desktop.program.model import Mark, Pen


@instant("pen")
def pen(context: RunContext, command: Pen) -> None:
    context.output.pen(command.block, down=command.down, color=command.color)
    context.unreported.add("pen")


@instant("mark", "symbol")
def mark(context: RunContext, command: Mark, symbol: Literal["X", "O"]) -> None:
    x, y, _ = context.pose
    context.output.mark(command.block, symbol, x, y)
    context.marked.put(symbol, place_under(context.sensors), context.pose)
