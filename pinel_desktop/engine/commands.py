"""The commands to a live run (Stop, pause, step, breakpoints, speed, answers), each declared once.

The HTTP route and the page's types derive from `LiveCommand`, the engine's parser from `EngineCommand`. A new command
is a class here with its effect on a run (`apply`), plus the code of the page that sends it.
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

# The app imports this module at its start. Pydantic therefore builds each model at its first use.
_LAZY = ConfigDict(defer_build=True, frozen=True)

# The app sends this message 20 times a second while a real robot drives and a page is open. Without
# it the engine stops the robot: nobody can press Stop in a frozen app, or without a page.
KEEPALIVE = {"type": "app_alive"}
KEEPALIVE_PERIOD_S = 0.05

BlockIds = Annotated[list[Annotated[str, Field(max_length=100)]], Field(max_length=1000)]
SpeedFactor = Annotated[float, Field(ge=MIN_SPEED, le=MAX_SPEED)]
Sign = Annotated[str, Field(max_length=100)]
Ring = Literal["sonar", "lidar"]


class _Command(BaseModel):
    """Base of all commands; `do` names the command. Unknown keys are refused."""

    model_config = _LAZY | ConfigDict(extra="forbid")

    def apply(self, control: RunControl, reply: Reply) -> None:
        """Applies the command to the run, on the engine's reading thread.

        Args:
            reply: receives the value or the error of a command that has a response.
        """
        raise NotImplementedError


class Pause(_Command):
    """Pauses the run."""

    do: Literal["pause"] = "pause"

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.pause()


class Resume(_Command):
    """Resumes the run after a pause."""

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
    """Stops the robot because the HTTP client that requested the run has disconnected. Only the app sends it."""

    do: Literal["abandon"] = "abandon"

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.stop(CALLER_LEFT)
        reply(None, None)


class Step(_Command):
    """Runs to the next block and pauses there: into functions, over them, or out of the running one."""

    do: Literal["step"] = "step"
    mode: StepMode

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.step_on(self.mode)


class SetBreakpoints(_Command):
    """Ids of the blocks before which the run pauses; replaces the previous breakpoints."""

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
    """Sensor rings that the stream reports from now on as `ranges` events; an empty list unsubscribes."""

    do: Literal["subscribe"] = "subscribe"
    sensors: Annotated[list[Ring], Field(max_length=2)]

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.subscriptions = frozenset(self.sensors)


class Evaluate(_Command):
    """Evaluates an expression of the program document while the run is paused."""

    do: Literal["evaluate"] = "evaluate"
    expression: Any

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.evaluate(self.expression, reply)


class AnswerCapture(_Command):
    """The shown sign, from a person or from the camera. Has no effect while no capture is in progress.

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
    """The group's answer to the question of its program. Has no effect while no question is open."""

    do: Literal["answer"] = "answer"
    value: Annotated[str, Field(max_length=1000)]

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.inputs.answers.answer(self.value)


class Append(_Command):
    """Appends commands to the program, in the normal form of a document. From then on the run is open.

    Only the app sends it, because the app stores the growing document of an open run.
    """

    do: Literal["append"] = "append"
    commands: list[Any]

    def apply(self, control: RunControl, reply: Reply) -> None:
        control.append(self.commands)


class Finish(_Command):
    """Ends an open run as soon as all of its commands are done."""

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
# commands that a page may send
COMMANDS: dict[str, type[PageCommand]] = {
    model.model_fields["do"].default: model for model in get_args(PageCommand)
}


class LiveCommand(RootModel[Any]):
    """One command from a page to a live run."""

    model_config = _LAZY

    # A type in the brackets of RootModel would be built at import, despite `defer_build`.
    root: Annotated[PageCommand, Field(discriminator="do")]


class EngineCommand(RootModel[Any]):
    """One command from the app to a live run."""

    model_config = _LAZY

    root: Annotated[Command, Field(discriminator="do")]
