"""Inputs of a run without a person, as plain data: for a run in any process."""

import json
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.runs.recorded_inputs import RecordedInputs, WireEvent, input_events
from pinel_desktop.runs.spec import RunInputs


@dataclass(frozen=True, slots=True)
class FixedInputs:
    """What a program reads: lists, or what people gave in a recorded run. Past the end of either, a run fails.

    Attributes:
        gestures, answers: signs and answers in their order, each given on the next tick.
        recorded: `input_events` of a recorded run as JSON; "" for the lists.
    """

    gestures: tuple[str, ...] = ()
    answers: tuple[str, ...] = ()
    recorded: str = ""

    @classmethod
    def of_run(cls, events: Iterable[WireEvent]) -> "FixedInputs":
        """Returns the inputs of a recorded run. Raises what `RecordedInputs` raises."""
        given = cls(recorded=json.dumps(input_events(events)))
        given.source()
        return given

    @classmethod
    def from_message(cls, message: Mapping[str, Any]) -> "FixedInputs":
        """Reads the inputs from plain data."""
        gestures, answers = (tuple(message[name]) for name in ("gestures", "answers"))
        return cls(gestures, answers, message["recorded"])

    def as_message(self) -> dict[str, Any]:
        """Returns plain data."""
        return asdict(self)

    def source(self) -> RunInputs:
        """Returns the inputs for one run."""
        if self.recorded:
            return RecordedInputs(json.loads(self.recorded), is_replay=False)
        return ScriptedInputs(self.gestures, self.answers, all_gestures=True)
