"""Prints problems and metrics for people."""

import math
from collections.abc import Mapping
from typing import IO, Any

import click

from pinel_desktop.messages import Problem, explain

_ESTIMATED = " (the robot's estimate)"


class Failure(click.ClickException):
    """Ends a command with the message of a problem and, on the next line, its remedy."""

    def __init__(self, problem: Problem) -> None:
        text = explain(problem)
        super().__init__(f"{text.message}\n{text.full_remedy}")

    def show(self, file: IO[Any] | None = None) -> None:
        click.echo(self.message, file=file, err=file is None)


def print_problem(problem: Problem, language: str | None = None, *, place: str = "") -> None:
    """Prints `place`, message and remedy of a problem on one line of standard error."""
    click.echo(f"{place}: " * bool(place) + explain(problem, language).line, err=True)


def metric_lines(summary: Mapping[str, Any]) -> list[str]:
    """Returns the metrics of a run's summary (`execution.summary`) as lines; no lines for a run that never started."""
    pose = summary["pose"]
    if pose is None:
        return []
    heading = math.degrees(pose["yaw_rad"])
    is_exact = summary["closing_error_m"] == summary["estimated_closing_error_m"]
    whose = "" if is_exact else _ESTIMATED
    return [
        f"commands        {summary['n_executed']}",
        f"pose            x {pose['x_m']:.4f} m, y {pose['y_m']:.4f} m, heading {heading:.2f}°{whose}",
        f"duration        {summary['duration_s']:.2f} s",
        f"path length     {summary['path_length_m']:.3f} m",
        *_closing_errors(summary["closing_error_m"], summary["estimated_closing_error_m"]),
        *([f"kept as run     {summary['run_id']}"] if summary["run_id"] else []),
    ]


def _closing_errors(true_m: float | None, estimated_m: float) -> list[str]:
    """Returns the true closing error if it is known, and the robot's estimate if it is different."""
    if true_m is None:
        return [f"closing error   {estimated_m * 1000:.3f} mm{_ESTIMATED}"]
    lines = [f"closing error   {true_m * 1000:.3f} mm"]
    return (
        lines if true_m == estimated_m else [*lines, f"  estimated     {estimated_m * 1000:.3f} mm"]
    )
