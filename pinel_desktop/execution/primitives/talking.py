"""Text and sound output, and questions to the group."""

from pinel_desktop.events.model import Answered, Asked
from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.execution.expressions.values import Value, display_text, from_answer, plain
from pinel_desktop.execution.primitives.base import instant, timed
from pinel_desktop.execution.primitives.waiting import wait_for_input
from pinel_desktop.execution.requests import Routine
from pinel_desktop.program.limits import MAX_TEXT
from pinel_desktop.program.model import Ask, Beep, Say


@instant("say", "text")
def say(context: RunContext, command: Say, text: Value) -> None:
    context.output.show_text(command.block, display_text(text, "say"))


@instant("beep")
def beep(context: RunContext, command: Beep) -> None:
    context.output.beep(command.block)


@timed("ask", "question")
def ask(context: RunContext, command: Ask, question: str) -> Routine:
    """Stores the answer in a variable; waits without a timeout."""
    context.output.question()
    announcement = Asked(command.block, question, command.variable)
    source = context.sources.answers
    answer = yield from wait_for_input(context, source, announcement, question=question)
    assert answer is not None  # without a timeout
    if len(answer) > MAX_TEXT:
        raise RunFailureError("text_too_long", name=command.variable, max=MAX_TEXT)
    value = from_answer(answer)
    context.variables.set(command.variable, value)
    context.emit(Answered(command.variable, plain(value)))
    return None
