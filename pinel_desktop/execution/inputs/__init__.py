"""Sources of capture results and answers."""

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
