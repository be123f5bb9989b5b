"""The sentence about a cloud: how many robots do what the group wants, and what stops the others."""

from collections import Counter
from collections.abc import Mapping
from typing import Any

from pinel_desktop.activities import block_text
from pinel_desktop.messages import describe
from pinel_desktop.sweep import Reason, Summary
from pinel_desktop.sweep.rows import LOST, TOO_LONG

_MAX_REASONS = 2


def sentence_of(
    summary: Summary,
    document: Mapping[str, Any],
    language: str,
    *,
    is_judged: bool,
    case: str = "",
) -> str:
    """Returns the sentence.

    Args:
        document: the program's document, for the labels of its blocks.
        is_judged: whether an activity judged the runs.
        case: what the case of the activity gives to the program; "" for the only case.
    """
    code = ("cloud_passed_case" if case else "cloud_passed") if is_judged else "cloud_together"
    n_good = summary.n_well if is_judged else summary.n_together
    values = {"count": n_good, "all": summary.n_runs, "case": case}
    parts = [describe(code, values, language).message]
    # several checks of one activity may fail at one block
    counts: Counter[tuple[str, str | None]] = Counter()
    for reason, n in summary.reasons:
        counts[_kind(reason), reason.block] += n
    for (kind, block), n in counts.most_common(_MAX_REASONS):
        label = block_text(document, block, language) if block else None
        code = f"cloud_{kind}_at" if label and kind != "robot_lost" else f"cloud_{kind}"
        parts.append(describe(code, {"n": n, "block": label}, language).message)
    return " ".join(parts)


def _kind(reason: Reason) -> str:
    return {LOST: "robot_lost", TOO_LONG: TOO_LONG}.get(reason.detail or "", reason.cause)
