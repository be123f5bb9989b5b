"""Sources of capture results and answers."""

from pinel_desktop.execution.inputs.sources import (
    NO_CAPTURE,
    Capture,
    Inputs,
    InputSource,
    LiveInputs,
    Pending,
    PersonInput,
    Script,
    ScriptedInputs,
)

__all__ = [
    "NO_CAPTURE",
    "Capture",
    "InputSource",
    "Inputs",
    "LiveInputs",
    "Pending",
    "PersonInput",
    "Script",
    "ScriptedInputs",
]
