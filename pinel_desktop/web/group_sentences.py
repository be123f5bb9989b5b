"""One sentence about each group in the review of a lesson."""

import contextlib
import re
from collections.abc import Mapping

from pinel_desktop.activities import block_text
from pinel_desktop.messages import describe
from pinel_desktop.school.review import GroupStatus, Run
from storage import Store, StoreError

_END_OF_SENTENCE = re.compile(r"(?<=[.!?])\s")


def sentence_of(
    status: GroupStatus,
    store: Store,
    *,
    texts: Mapping[str, str],
    other_mission: str | None,
    language: str,
) -> str:
    """Returns the sentence about a group.

    Args:
        texts: what the group was told about a run, by run id.
        other_mission: title of the run's activity if it is not one of the lesson's.
    """
    kind, run = status.kind, status.run
    block = _block(run, store, language) if run and kind == "collision" else None
    code = f"status_{kind}" if kind != "collision" or block else "status_collision_somewhere"
    what = _END_OF_SENTENCE.split(texts.get(run.id, ""), maxsplit=1)[0] if run else ""
    if kind in ("failed", "not_passed") and what:
        code = "status_told"
    values = {"count": status.n, "block": block or "", "what": what}
    text = describe(code, values, language).message
    if other_mission is None:
        return text
    return describe("status_of_other", {"title": other_mission, "text": text}, language).message


def _block(run: Run, store: Store, language: str) -> str | None:
    """Returns the text of the block at which a run ended; None if it is unknown."""
    if run.block is None or run.version_id is None:
        return None
    with contextlib.suppress(StoreError):  # a damaged version
        document = store.versions.get(run.version_id).document or {}
        return block_text(document, run.block, language)
    return None
