"""Where a run gets the results of captures and the answers to questions from."""

from pinel_desktop.execution.inputs.sources import (
    Inputs,
    InputSource,
    LiveInputs,
    Pending,
    PersonInput,
    Script,
    ScriptedInputs,
)

__all__ = [
    "InputSource",
    "Inputs",
    "LiveInputs",
    "Pending",
    "PersonInput",
    "Script",
    "ScriptedInputs",
]
