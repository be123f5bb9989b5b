"""The pen and marks on the floor."""

from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.primitives.base import instant
from pinel_desktop.program.model import Mark, Pen


@instant("pen")
def pen(context: RunContext, command: Pen) -> None:
    context.output.pen(command.block, down=command.down, color=command.color)
    context.unreported.add("pen")


@instant("mark")
def mark(context: RunContext, command: Mark) -> None:
    x, y, _ = context.pose
    context.output.mark(command.block, command.symbol, x, y)
