"""Where a program is: the running command inside the bodies and functions around it. Stepping never blocks.

Functions are frames on this stack and not calls of Python, so that their depth is the language's business.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from pinel_desktop.events.model import BlockEnded, BlockStarted, StackEntry
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.compiled_commands import CompiledCommand, compile_command
from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.execution.expressions.values import Value
from pinel_desktop.execution.expressions.variables import Names
from pinel_desktop.execution.inputs import Pending
from pinel_desktop.execution.requests import Body, Invoke, Jump, Leave, Returned, Routine
from pinel_desktop.program.limits import MAX_RECURSION
from pinel_desktop.program.model import Program

_REPORT_TICKS = TICK_HZ // 5
_PARTS_A_STEP = 20  # parts of expressions that take about as long as one command


class _Entry(NamedTuple):
    """A command that has begun. `reported` tells whether its end is reported as its beginning was."""

    command: Any
    pointer: str
    amount: float | None
    reported: bool


class _Frame:
    """A body that is run: of a command that is under way, of a function, or of the whole program.

    Attributes:
        entry, routine: the command and what it still has to do; None for functions and the program.
        is_loop: whether `break` and `continue` end here.
        function: name of the function whose body this is.
        outer: the parameters of who called the function.
        commands, index, pointer: the body, the next command in it, its place in the document.
        value: what the routine is to be given: the value of the function it has called.
    """

    __slots__ = (
        "commands",
        "entry",
        "function",
        "index",
        "is_loop",
        "outer",
        "pointer",
        "routine",
        "value",
    )

    def __init__(
        self,
        commands: Sequence[Any],
        pointer: str,
        *,
        entry: _Entry | None = None,
        routine: Routine | None = None,
        is_loop: bool = False,
    ) -> None:
        self.commands, self.pointer, self.index = commands, pointer, 0
        self.entry, self.routine, self.is_loop = entry, routine, is_loop
        self.function: str | None = None
        self.outer: Names = {}
        self.value: Value | None = None


class ProgramStack:
    """Steps through a program.

    A command that takes no time is reported at most five times a second for each of its places in the program, so that
    a loop without motion cannot flood those who watch.
    """

    def __init__(self, program: Program, context: RunContext) -> None:
        self._context = context
        self._functions = {
            function.name: (function, f"/functions/{i}/commands")
            for i, function in enumerate(program.functions)
        }
        self._frames = [_Frame(program.commands, "/commands")]
        self._beginning: Any = None
        self._timed: Routine | None = None
        # asked before each command; says whether the run is to be held there
        self.holds: Callable[[Any], bool] | None = None
        self.is_held = False
        self.awaits_person = False
        self._reported: set[str] = set()
        self._forget_at = _REPORT_TICKS
        # by identity: the program is there as long as the run, and is frozen
        self._compiled: dict[int, CompiledCommand] = {}
        self.calls: list[StackEntry] = []
        self.n_calls = 0
        self.n_executed = 0

    @property
    def block(self) -> str | None:
        """Id of the innermost block that is running."""
        if self._beginning is not None:
            return _block(self._beginning)
        inside = (frame.entry for frame in reversed(self._frames))
        return next((_block(entry.command) for entry in inside if entry is not None), None)

    @property
    def next_block(self) -> str | None:
        """Id of the block that begins next where the run is held, else of the one that is running."""
        if not self.is_held:
            return self.block
        frame = self._frames[-1]
        return _block(frame.commands[frame.index])

    @property
    def finished(self) -> bool:
        return not self._frames

    def run_until_time(self, max_steps: int, stop: Callable[[], bool]) -> bool:
        """Runs commands until a tick has to pass, or `max_steps` are done; False when the program is over before.

        It returns True as well where a command is held (`is_held`), when no tick has to pass, and where one waits for
        a person or a camera (`awaits_person`). Long expressions count as more than one step; `stop` is asked between
        steps, and ends them too.
        """
        if self._reported and self._context.tick >= self._forget_at:
            self._reported.clear()
            self._forget_at = self._context.tick + _REPORT_TICKS
        self.is_held = self.awaits_person = False
        timed = self._timed
        if timed is not None:  # what let the last tick pass mostly needs the next one too
            self._timed = None
            if self._go_on(self._frames[-1], timed):
                return True
        context = self._context
        budget = max_steps + context.n_evaluated // _PARTS_A_STEP
        steps = 0
        while steps + context.n_evaluated // _PARTS_A_STEP < budget:
            if self._step():
                return True
            if not self._frames:
                return False
            if stop():
                return True
            steps += 1
        return True

    def close(self) -> None:
        """Ends everything that is under way, so that it can give back what it holds."""
        while self._frames:
            routine = self._frames.pop().routine
            if routine is not None:
                routine.close()

    def _step(self) -> bool:
        """Does one step; True when the running command needs a tick to pass."""
        frame = self._frames[-1]
        if frame.index < len(frame.commands):
            index = frame.index
            if self.holds is not None and self.holds(frame.commands[index]):
                self.is_held = True
                return True
            frame.index = index + 1
            self._begin(frame.commands[index], f"{frame.pointer}/{index}")
            return False
        if frame.routine is None:
            self._finish_function(None)
            return False
        return self._go_on(frame, frame.routine)

    def _go_on(self, frame: _Frame, routine: Routine) -> bool:
        """Lets the command of a frame do its next part; True when it needs time to pass."""
        value, frame.value = frame.value, None
        try:
            wanted = routine.send(value)
        except StopIteration as end:
            self._pop(frame)
            if end.value is not None:
                self._jump(end.value)
            return False
        if wanted is None or wanted is Pending.PERSON:
            self._timed = routine
            self.awaits_person = wanted is not None
            if frame.entry is not None and not frame.entry.reported:
                self._report_late()
            return True
        if isinstance(wanted, Body):
            entry = frame.entry
            frame.commands, frame.index = wanted.commands, 0
            frame.pointer = (entry.pointer if entry else "") + wanted.path
        elif isinstance(wanted, Invoke):
            self._invoke(wanted)
        return False

    def _pop(self, frame: _Frame) -> None:
        """The frame's command is over."""
        self._frames.pop()
        self._context.done = 0.0
        if frame.entry is not None:
            self._end(frame.entry)

    def _begin(self, command: Any, pointer: str) -> None:
        self._beginning = command
        compiled = self._compiled.get(id(command))
        if compiled is None:
            compiled = self._compiled[id(command)] = compile_command(command, self._context)
        primitive = compiled.primitive
        if not primitive.is_flow:
            self.n_executed += 1
        if compiled.in_steps is not None:
            entry = self._report(command, pointer, None)
            self._push(entry, compiled.in_steps(), compiled)
        elif compiled.values is not None:
            try:
                values = compiled.values()
            except RunFailureError:
                self._report(command, pointer, None)
                raise
            amount = primitive.amount(*values) if primitive.amount else None
            entry = self._report(command, pointer, amount)
            self._perform(entry, compiled, values)
        self._beginning = None

    def _perform(self, entry: _Entry, compiled: CompiledCommand, values: Sequence[Any]) -> None:
        primitive = compiled.primitive
        if primitive.instant is not None:
            jump = primitive.instant(self._context, entry.command, *values)
            self._end(entry)
            if jump is not None:
                self._jump(jump)
        elif primitive.routine is not None:
            self._push(entry, primitive.routine(self._context, entry.command, *values), compiled)

    def _push(self, entry: _Entry, routine: Routine, compiled: CompiledCommand) -> None:
        is_loop = compiled.primitive.is_loop
        self._frames.append(_Frame((), "", entry=entry, routine=routine, is_loop=is_loop))

    def _jump(self, jump: Jump) -> None:
        if isinstance(jump, Returned):
            while self._frames[-1].routine is not None:
                self._leave_body()
            self._finish_function(jump.value)
            return
        while not self._frames[-1].is_loop:
            self._leave_body()
        loop = self._frames[-1]
        if jump is Leave.LOOP:
            self._leave_body()
        else:
            loop.index = len(loop.commands)

    def _leave_body(self) -> None:
        frame = self._frames[-1]
        if frame.routine is not None:
            frame.routine.close()
        self._pop(frame)

    def _invoke(self, wanted: Invoke) -> None:
        if len(self.calls) >= MAX_RECURSION:
            raise RunFailureError("recursion_too_deep", function=wanted.function, max=MAX_RECURSION)
        function, pointer = self._functions[wanted.function]
        frame = _Frame(function.commands, pointer)
        frame.outer = self._context.variables.enter(wanted.arguments)
        frame.function = function.name
        self.calls.append({"function": function.name, "block": self.block})
        self.n_calls += 1
        self._frames.append(frame)

    def _finish_function(self, value: Value | None) -> None:
        """The function or the program is over; the command that called it gets the value."""
        frame = self._frames.pop()
        if frame.function is None:
            return
        self._context.variables.leave(frame.outer)
        self.calls.pop()
        self.n_calls += 1
        self._frames[-1].value = value

    def _report(self, command: Any, pointer: str, amount: float | None) -> _Entry:
        entry = _Entry(command, pointer, amount, pointer not in self._reported)
        if entry.reported:
            self._started(entry)
        return entry

    def _started(self, entry: _Entry) -> None:
        self._reported.add(entry.pointer)
        command = entry.command
        self._context.emit(BlockStarted(command.block, entry.pointer, command.action, entry.amount))

    def _report_late(self) -> None:
        """Something takes time after all: its beginning, and what is around it, is reported now."""
        for frame in self._frames:
            entry = frame.entry
            if entry is not None and not entry.reported:
                self._started(entry)
                frame.entry = entry._replace(reported=True)

    def _end(self, entry: _Entry) -> None:
        if entry.reported:
            self._context.emit(BlockEnded(entry.command.block, entry.pointer))


def _block(command: Any) -> str | None:
    block: str | None = command.block
    return block
