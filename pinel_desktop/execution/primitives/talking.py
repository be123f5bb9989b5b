"""Speaking to the group, and listening."""

from pinel_desktop.events.model import Answered, Asked
from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.execution.expressions.values import Value, from_answer, plain, shown
from pinel_desktop.execution.primitives.base import instant, timed
from pinel_desktop.execution.primitives.waiting import wait_for_input
from pinel_desktop.execution.requests import Routine
from pinel_desktop.program.limits import MAX_TEXT
from pinel_desktop.program.model import Ask, Beep, Say


@instant("say", "text")
def say(context: RunContext, command: Say, text: Value) -> None:
    context.output.say(command.block, shown(text, "say"))


@instant("beep")
def beep(context: RunContext, command: Beep) -> None:
    context.output.beep(command.block)


@timed("ask", "question")
def ask(context: RunContext, command: Ask, question: str) -> Routine:
    """Waits until somebody answers."""
    context.output.question()
    announcement = Asked(command.block, question, command.variable)
    source = context.sources.answers
    answer = yield from wait_for_input(context, source, announcement, question=question)
    assert answer is not None  # there is no timeout
    if len(answer) > MAX_TEXT:
        raise RunFailureError("text_too_long", name=command.variable, max=MAX_TEXT)
    value = from_answer(answer)
    context.variables.set(command.variable, value)
    context.emit(Answered(command.variable, plain(value)))
    return None
