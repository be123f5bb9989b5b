"""The sentence about a cloud: how many robots do what the group wants, and what stops the others."""

from collections.abc import Mapping
from typing import Any

from pinel_desktop.activities import block_text
from pinel_desktop.messages import describe
from pinel_desktop.sweep import Reason, Summary
from pinel_desktop.sweep.rows import LOST, TOO_LONG

_MAX_REASONS = 2


def sentence_of(
    summary: Summary, document: Mapping[str, Any], language: str, *, is_judged: bool
) -> str:
    """Returns the sentence.

    Args:
        document: the program's document, for the labels of its blocks.
        is_judged: whether an activity judged the runs.
    """
    code, n_good = "cloud_passed" if is_judged else "cloud_together", n_good_of(summary, is_judged)
    parts = [describe(code, {"good": n_good, "all": summary.n_runs}, language).message]
    for reason, n in summary.reasons[:_MAX_REASONS]:
        parts.append(_reason_text(reason, n, document, language))
    return " ".join(parts)


def n_good_of(summary: Summary, is_judged: bool) -> int:
    """Returns how many robots do what the group wants: pass, or without an activity, end where most of them end."""
    return summary.n_well if is_judged else summary.n_together


def _reason_text(reason: Reason, n: int, document: Mapping[str, Any], language: str) -> str:
    if reason.detail == LOST:
        return describe("cloud_robot_lost", {"n": n}, language).message
    kind = "too_long" if reason.detail == TOO_LONG else reason.cause
    block = block_text(document, reason.block, language) if reason.block else None
    code = f"cloud_{kind}_at" if block else f"cloud_{kind}"
    return describe(code, {"n": n, "block": block}, language).message
