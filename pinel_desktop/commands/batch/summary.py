"""The summary of a sweep on the console."""

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from pinel_desktop.sweep import Reason, Row, Summary, summary_of

_MAX_REASONS = 10
Group = tuple[str, str]  # name of the program, name of the world


def summary_object(rows: Sequence[Row]) -> dict[str, Any]:
    """Returns the summary as plain JSON data: of all runs, and of each program in each world."""
    groups = [
        {"program": program, "world": world, **_as_object(summary)}
        for (program, world), summary in _groups(rows).items()
    ]
    return {**_as_object(summary_of(rows)), "groups": groups}


def _as_object(summary: Summary) -> dict[str, Any]:
    reasons = [{**reason._asdict(), "n_runs": count} for reason, count in summary.reasons]
    return {**asdict(summary), "success": summary.success, "reasons": reasons}


def summary_lines(rows: Sequence[Row]) -> list[str]:
    """Returns the summary as lines of text."""
    summary, groups = summary_of(rows), _groups(rows)
    lines = [
        f"runs            {summary.n_runs}",
        f"went well       {summary.success:.1%} ({summary.n_well})",
        f"collided        {summary.n_collided}",
        *_percentiles("closing error", summary.closing_error_m, 1000.0, "mm"),
        *_percentiles("robot time", summary.duration_s, 1.0, "s"),
    ]
    if len(groups) > 1:
        for (program, world), one in groups.items():
            lines.append(f"  {one.success:7.1%}  {program}, {world}")
    for reason, count in summary.reasons[:_MAX_REASONS]:
        lines.append(f"not well        {count} times: {_reason(reason)}")
    return lines


def _groups(rows: Sequence[Row]) -> dict[Group, Summary]:
    """Returns the summary of each program in each world, in the order of the rows."""
    members: dict[Group, list[Row]] = {}
    for row in sorted(rows, key=lambda row: row.index):
        members.setdefault((row.program, row.world), []).append(row)
    return {group: summary_of(some) for group, some in members.items()}


def _percentiles(
    label: str, values: tuple[float, float, float] | None, factor: float, unit: str
) -> list[str]:
    if values is None:
        return []
    low, middle, high = (value * factor for value in values)
    return [f"{label:<15} {middle:.2f} {unit} ({low:.2f} to {high:.2f} in nine of ten runs)"]


def _reason(reason: Reason) -> str:
    parts = (reason.cause, reason.detail, reason.block and f"block {reason.block}")
    return ", ".join(part for part in parts if part)
