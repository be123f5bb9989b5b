"""The commands to a live run, declared once.

The route and the page's types derive from `LiveCommand`, the engine's reader from `EngineCommand`. A new command is
a class here, with what it does to a run (`apply`), and whatever in the page sends it.
"""

from typing import Annotated, Any, Literal, get_args

from pydantic import BaseModel, ConfigDict, Field, RootModel

from pinel_desktop.events.model import CaptureBy
from pinel_desktop.execution.control import (
    CALLER_LEFT,
    MAX_SPEED,
    MIN_SPEED,
    Reply,
    RunControl,
    StepMode,
)
from pinel_desktop.execution.inputs import Capture

# The app's start imports this module; a model is built when it is first used.
_LAZY = ConfigDict(defer_build=True, frozen=True)

# What the app says 20 times a second while a real robot drives: nobody could stop it in an app that is frozen, or
# without a page.
KEEPALIVE = {"type": "app_alive"}
KEEPALIVE_PERIOD_S = 0.05

BlockIds = Annotated[list[Annotated[str, Field(max_length=100)]], Field(max_length=1000)]
SpeedFactor = Annotated[float, Field(ge=MIN_SPEED, le=MAX_SPEED)]
Sign = Annotated[str, Field(max_length=100)]
Ring = Literal["sonar", "lidar"]


class _Command(BaseModel):
    """Base of all commands; `do` tells them apart. Unknown keys are refused."""

    model_config = _LAZY | ConfigDict(extra="forbid")

    def apply(self, control: RunControl, reply: Reply) -> None:
        """Does it to the run, from the engine's reading thread; `reply` takes the value of what asks for one."""
        raise NotImplementedError


class Pause(_Command):
    """Makes the run wait."""

    do: Literal["pause"] = "pause"

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.pause()


class Resume(_Command):
    """Lets the run go on after a pause."""

    do: Literal["resume"] = "resume"

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.resume()


class Stop(_Command):
    """Stops the robot and ends the run."""

    do: Literal["stop"] = "stop"

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.stop()
        reply(None, None)


class Abandon(_Command):
    """Stops the robot: the program that asked for the run over HTTP has hung up. The app alone sends it."""

    do: Literal["abandon"] = "abandon"

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.stop(CALLER_LEFT)
        reply(None, None)


class Step(_Command):
    """Goes on to the next block and pauses there: into functions, over them, or out of the one that runs."""

    do: Literal["step"] = "step"
    mode: StepMode

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.step_on(self.mode)


class SetBreakpoints(_Command):
    """Ids of the blocks before which the run pauses; replaces those set before."""

    do: Literal["breakpoints"] = "breakpoints"
    blocks: BlockIds

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.breakpoints = frozenset(self.blocks)


class SetSpeed(_Command):
    """Robot time divided by wall time, in the simulator: slow motion or fast forward."""

    do: Literal["speed"] = "speed"
    factor: SpeedFactor

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.set_speed(self.factor)


class Subscribe(_Command):
    """Rings of sensors that the stream reports from now on, as `ranges` events; an empty list ends it."""

    do: Literal["subscribe"] = "subscribe"
    sensors: Annotated[list[Ring], Field(max_length=2)]

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.subscriptions = frozenset(self.sensors)


class Evaluate(_Command):
    """Asks for the value of an expression of the program document while the run is paused."""

    do: Literal["evaluate"] = "evaluate"
    expression: Any

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.evaluate(self.expression, reply)


class AnswerCapture(_Command):
    """The sign that was shown, as a person says or the camera saw. Does nothing while no capture is under way.

    Attributes:
        result: name of the sign; "" means none.
        by, confidence, second: as in the event `gesture_result`.
    """

    do: Literal["answer_capture"] = "answer_capture"
    result: Sign
    by: CaptureBy = "person"
    confidence: Annotated[float, Field(ge=0.0, le=1.0)] | None = None
    second: Sign = ""

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.inputs.gestures.answer(Capture(self.result, self.by, self.confidence, self.second))


class Answer(_Command):
    """The group's answer to the question of its program. Does nothing while none is asked."""

    do: Literal["answer"] = "answer"
    value: Annotated[str, Field(max_length=1000)]

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.inputs.answers.answer(self.value)


class Append(_Command):
    """Commands for the end of the program, in the normal form of a document; the run is an open one from then on.

    The app alone sends it, since it keeps the document that the run grows to.
    """

    do: Literal["append"] = "append"
    commands: list[Any]

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.append(self.commands)


class Finish(_Command):
    """An open run ends as soon as all of its commands are done."""

    do: Literal["finish"] = "finish"

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.finish()


PageCommand = (
    Pause
    | Resume
    | Stop
    | Step
    | SetBreakpoints
    | SetSpeed
    | Subscribe
    | Evaluate
    | AnswerCapture
    | Answer
)
Command = PageCommand | Append | Finish | Abandon
# those of a page
COMMANDS: dict[str, type[PageCommand]] = {
    model.model_fields["do"].default: model for model in get_args(PageCommand)
}


class LiveCommand(RootModel[Any]):
    """One command of a page to a live run."""

    model_config = _LAZY

    # in the brackets of RootModel it would be built at once, whatever the configuration says
    root: Annotated[PageCommand, Field(discriminator="do")]


class EngineCommand(RootModel[Any]):
    """One command of the app to a live run."""

    model_config = _LAZY

    root: Annotated[Command, Field(discriminator="do")]
