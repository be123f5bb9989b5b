"""The object that `pinel run --json` prints (docs/program-document.md)."""

from typing import Any

from pinel_desktop.execution.executor import RunResult


def run_object(result: RunResult, run_id: str | None, message: str | None) -> dict[str, Any]:
    """The object for an executed run; `message` is the reason as text."""
    ended = result.ended
    return {
        "state": ended.state,
        "reason": ended.reason,
        "message": message,
        "run_id": run_id,
        "n_executed": ended.n_executed,
        "pose": ended.pose,
        "duration_s": ended.duration_s,
        "path_length_m": ended.path_length_m,
        "closing_error_m": ended.closing_error_m,
        "estimated_closing_error_m": ended.estimated_closing_error_m,
        "said": result.shown_texts,
        "marks": [{"symbol": m.symbol, "x_m": m.x_m, "y_m": m.y_m} for m in result.marks],
        "n_beeps": result.n_beeps,
        "variables": result.variables,
        "faults": [],
        "telemetry_sha256": ended.telemetry_sha256,
    }


def unbegun_object(
    reason: str, message: str, faults: list[dict[str, Any]] | None = None
) -> dict[str, Any]:
    """Returns the object for a run that could not start, for example without its world."""
    return {
        "state": "failed",
        "reason": reason,
        "message": message,
        "run_id": None,
        "n_executed": 0,
        "pose": None,
        "duration_s": 0.0,
        "path_length_m": 0.0,
        "closing_error_m": 0.0,
        "estimated_closing_error_m": 0.0,
        "said": [],
        "marks": [],
        "n_beeps": 0,
        "variables": {},
        "faults": faults or [],
        "telemetry_sha256": None,
    }


def faulty_object(faults: list[dict[str, Any]], message: str) -> dict[str, Any]:
    """The object for a document with faults, or that cannot be read."""
    return unbegun_object("invalid_program", message, faults)
