"""The execution stack of a program: frames of bodies and functions. Stepping never blocks.

Functions are frames of this stack, not Python calls, so that the language sets the depth of recursion.
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
_PARTS_A_STEP = 20  # expression parts that take about as long as one command


class _Entry(NamedTuple):
    """A command that has started; `reported`: whether its start was reported, so that its end will be reported, too."""

    command: Any
    pointer: str
    amount: float | None
    reported: bool


class _Frame:
    """A running body: of a command, of a function, or of the whole program.

    Attributes:
        entry, routine: the command and its generator; None for functions and the program.
        is_loop: whether `break` and `continue` refer to this body.
        function: name of the function, for its body.
        outer: parameters of the caller, for the body of a function.
        commands, index, pointer: the body, the index of its next command, its JSON pointer.
        value: value of a called function, to be sent to the routine.
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

    Commands that take no time are reported at most five times a second per place in the program, so that a loop
    without motion cannot flood the observer.

    Attributes:
        should_pause: called before each command; None without an observer.
        is_paused: whether the run pauses before the next command.
        awaits_person: whether the running command waits for a person or a camera.
        is_open: whether the program may grow: at its end it waits for more commands.
        awaits_commands: whether an open program has reached its end.
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
        self.should_pause: Callable[[Any], bool] | None = None
        self.is_paused = False
        self.awaits_person = False
        self.is_open = self.awaits_commands = False
        self._last_step = 0
        self._reported: set[str] = set()
        self._forget_at = _REPORT_TICKS
        # keyed by identity: the program is frozen and outlives the run
        self._compiled: dict[int, CompiledCommand] = {}
        self.calls: list[StackEntry] = []
        self.n_calls = 0
        self.n_executed = 0
        self.n_steps = 0

    @property
    def block(self) -> str | None:
        """Id of the innermost running block."""
        if self._beginning is not None:
            return _block(self._beginning)
        inside = (frame.entry for frame in reversed(self._frames))
        return next((_block(entry.command) for entry in inside if entry is not None), None)

    @property
    def next_block(self) -> str | None:
        """Id of the next block while the run is paused before it, otherwise of the running block."""
        if not self.is_paused:
            return self.block
        frame = self._frames[-1]
        return _block(frame.commands[frame.index])

    @property
    def finished(self) -> bool:
        return not self._frames

    def run_until_time(self, max_steps: int, stop: Callable[[], bool]) -> bool:
        """Runs commands until a tick is needed or `max_steps` are done; False when the program has ended.

        Also returns True, without need of a tick, before a command at which the run pauses (`is_paused`), while one
        waits for a person or a camera (`awaits_person`) and at the end of an open program (`awaits_commands`). Long
        expressions count as several steps; `stop` is polled between steps and ends them.
        """
        if self._reported and self._context.tick >= self._forget_at:
            self._reported.clear()
            self._forget_at = self._context.tick + _REPORT_TICKS
        is_resumed, self.awaits_commands = self.awaits_commands, False
        self.is_paused = self.awaits_person = False
        timed = self._timed
        # fast path: the command that needed the last tick mostly needs the next one, too
        if timed is not None:
            self._timed = None
            if self._resume(self._frames[-1], timed):
                return True
        context = self._context
        # after a wait for commands no tick has passed: the run equals a run of the whole
        # program
        if not is_resumed:
            self._last_step = self.n_steps + max_steps + context.n_evaluated // _PARTS_A_STEP
        while self.n_steps + context.n_evaluated // _PARTS_A_STEP < self._last_step:
            self.n_steps += 1
            if self._step():
                return True
            if not self._frames:
                return False
            if stop():
                return True
        return True

    def extend(self, commands: Sequence[Any]) -> None:
        """Appends commands to an open program that has reached its end."""
        frame = self._frames[0]
        frame.commands = [*frame.commands, *commands]

    def close(self) -> None:
        """Closes all running routines, so that they release their resources."""
        while self._frames:
            routine = self._frames.pop().routine
            if routine is not None:
                routine.close()

    def _step(self) -> bool:
        """Does one step; True when the running command needs a tick."""
        frame = self._frames[-1]
        if frame.index < len(frame.commands):
            index = frame.index
            if self.should_pause is not None and self.should_pause(frame.commands[index]):
                self.is_paused = True
                return True
            frame.index = index + 1
            self._begin(frame.commands[index], f"{frame.pointer}/{index}")
            return False
        if frame.routine is None:
            if self.is_open and frame.function is None:
                self.n_steps -= 1
                self.awaits_commands = True
                return True
            self._finish_function(None)
            return False
        return self._resume(frame, frame.routine)

    def _resume(self, frame: _Frame, routine: Routine) -> bool:
        """Resumes the routine of a frame; True when it needs time to pass."""
        value, frame.value = frame.value, None
        try:
            request = routine.send(value)
        except StopIteration as end:
            self._pop(frame)
            if end.value is not None:
                self._jump(end.value)
            return False
        if request is None or request is Pending.PERSON:
            self._timed = routine
            self.awaits_person = request is not None
            if frame.entry is not None and not frame.entry.reported:
                self._report_late()
            return True
        if isinstance(request, Body):
            entry = frame.entry
            frame.commands, frame.index = request.commands, 0
            frame.pointer = (entry.pointer if entry else "") + request.path
        elif isinstance(request, Invoke):
            self._invoke(request)
        return False

    def _pop(self, frame: _Frame) -> None:
        """Removes a frame whose command has ended."""
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

    def _invoke(self, request: Invoke) -> None:
        if len(self.calls) >= MAX_RECURSION:
            raise RunFailureError(
                "recursion_too_deep", function=request.function, max=MAX_RECURSION
            )
        function, pointer = self._functions[request.function]
        frame = _Frame(function.commands, pointer)
        frame.outer = self._context.variables.enter(request.arguments)
        frame.function = function.name
        self.calls.append({"function": function.name, "block": self.block})
        self.n_calls += 1
        self._frames.append(frame)

    def _finish_function(self, value: Value | None) -> None:
        """Ends the function or the program; passes the value to the calling command."""
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
        """Reports the withheld starts of running commands, once one of these commands takes time."""
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
