"""Where a program is: the running command inside the bodies around it. Stepping never blocks."""

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from pinel_desktop.events.model import BlockEnded, BlockStarted
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.primitives import TABLE, Body

_PARTS_A_STEP = 20  # parts of expressions that take about as long as one command


class _Entry(NamedTuple):
    """A command that has begun. `reported` tells whether its end is reported as its beginning was."""

    command: Any
    pointer: str
    reported: bool


class _Frame:
    """A control-flow command with the body it is in."""

    def __init__(self, entry: _Entry | None, bodies: Iterator[Body]) -> None:
        self.entry, self.bodies = entry, bodies
        self.commands: list[Any] = []
        self.index = 0
        self.pointer = ""

    def next_body(self) -> bool:
        """Goes to the next body; False when there is none."""
        body = next(self.bodies, None)
        if body is None:
            return False
        self.commands, self.index = body.commands, 0
        self.pointer = (self.entry.pointer if self.entry else "") + body.path
        return True


class ProgramStack:
    """Steps through a program.

    A command that takes no time is reported at most once a tick for each of its places in the program, so that
    a loop without motion cannot flood those who watch.
    """

    def __init__(self, commands: list[Any], context: RunContext) -> None:
        self._context = context
        self._frames = [_Frame(None, iter([Body(commands, "/commands")]))]
        self._running: tuple[_Entry, Iterator[None]] | None = None
        self._reported: set[str] = set()
        self.n_executed = 0

    @property
    def block(self) -> str | None:
        """Id of the innermost block that is running."""
        if self._running is not None:
            return self._block_of(self._running[0])
        return self._block_of(self._frames[-1].entry) if self._frames else None

    @staticmethod
    def _block_of(entry: _Entry | None) -> str | None:
        return entry.command.block if entry else None

    @property
    def finished(self) -> bool:
        return not self._frames and self._running is None

    def run_until_time(self, max_steps: int, stop: Callable[[], bool]) -> bool:
        """Runs commands until a tick has to pass, or `max_steps` are done; False when the program is over before.

        Long conditions count as more than one step; `stop` is asked between steps, and ends them too.
        """
        if self._reported:
            self._reported.clear()
        context = self._context
        budget = max_steps + context.n_evaluated // _PARTS_A_STEP
        steps = 0
        while steps + context.n_evaluated // _PARTS_A_STEP < budget:
            if self._step():
                return True
            if self.finished:
                return False
            if stop():
                return True
            steps += 1
        return True

    def _step(self) -> bool:
        """Does one step; True when the running command needs a tick to pass."""
        if self._running is not None:
            return self._continue(*self._running)
        frame = self._frames[-1]
        if frame.index < len(frame.commands):
            frame.index += 1
            self._begin(frame.commands[frame.index - 1], f"{frame.pointer}/{frame.index - 1}")
        elif not frame.next_body():
            self._frames.pop()
            if frame.entry is not None:
                self._end(frame.entry)
        return False

    def close(self) -> None:
        """Ends the running primitive, so that it can give back what it holds."""
        if self._running is not None:
            self._running[1].close()  # type: ignore[attr-defined]  # every timed primitive is a generator
            self._running = None

    def _continue(self, entry: _Entry, ticks: Iterator[None]) -> bool:
        for _ in ticks:
            return True
        self._running = None
        self._context.done = 0.0
        self._end(entry)
        return False

    def _begin(self, command: Any, pointer: str) -> None:
        primitive = TABLE[command.action]
        entry = self._report(command, pointer, timed=primitive.timed is not None)
        if primitive.flow is not None:
            self._frames.append(_Frame(entry, primitive.flow(self._context, command)))
            return
        self.n_executed += 1
        if primitive.timed is not None:
            self._running = (entry, primitive.timed(self._context, command))
        elif primitive.instant is not None:
            primitive.instant(self._context, command)
            self._end(entry)

    def _report(self, command: Any, pointer: str, *, timed: bool) -> _Entry:
        reported = timed or pointer not in self._reported
        if reported:
            self._reported.add(pointer)
            amount = TABLE[command.action].amount
            self._context.emit(
                BlockStarted(
                    command.block, pointer, command.action, amount(command) if amount else None
                )
            )
        return _Entry(command, pointer, reported)

    def _end(self, entry: _Entry) -> None:
        if entry.reported:
            self._context.emit(BlockEnded(entry.command.block, entry.pointer))
