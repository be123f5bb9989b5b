"""Sources of capture results and answers."""

from pinel_desktop.execution.inputs.sources import (
    NO_CAPTURE,
    NO_NUMBER,
    Capture,
    Inputs,
    InputSource,
    LiveInputs,
    Pending,
    PersonInput,
    ScriptedInputs,
    number_of,
)

__all__ = [
    "NO_CAPTURE",
    "NO_NUMBER",
    "Capture",
    "InputSource",
    "Inputs",
    "LiveInputs",
    "Pending",
    "PersonInput",
    "ScriptedInputs",
    "number_of",
]
