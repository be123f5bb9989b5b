"""`pinel merge`: merges work exported on other PCs."""

import json
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import click

from pinel_desktop.commands.database import opened_store
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.messages import describe, explain, language_of_system
from storage import Store, StoreError
from storage.exchange.bundle_writing import SUFFIX
from storage.exchange.deleting.pending import PendingDeletion, PendingWork
from storage.exchange.merge_report import MergeReport

_REFUSED = 2


@dataclass(frozen=True, slots=True)
class _Outcome:
    file: Path
    report: MergeReport | None
    error: StoreError | None


@click.command()
@click.argument("files", nargs=-1, required=True, type=click.Path(path_type=Path))
@database_option
@click.option(
    "--delete",
    is_flag=True,
    help="Also delete here, permanently, what was deleted on the PCs of the files. What was moved or is newer stays.",
)
@click.option(
    "--keep",
    "kept",
    multiple=True,
    metavar="KEY",
    help="With --delete: a group or program that stays nevertheless, here and everywhere. Can be repeated.",
)
@click.option(
    "--delete-newer",
    is_flag=True,
    help="With --delete: also delete what was moved or is newer here.",
)
@click.option(
    "--open-lesson", is_flag=True, help="Also open here the lesson of a lesson file, on this PC."
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.pass_context
def command(
    ctx: click.Context,
    files: tuple[Path, ...],
    delete: bool,
    kept: tuple[str, ...],
    delete_newer: bool,
    open_lesson: bool,
    as_json: bool,
) -> None:
    """Merge the work of other PCs. FILES are files written by `pinel export`, or folders of such files.

    The order does not matter, and merging a file again changes nothing. Exit status: 0, or 2 if a file was refused;
    the others are merged nevertheless.
    """
    with opened_store(chosen_database(ctx), may_be_new=True) as store:
        outcomes = []
        for file in _all(files):
            outcomes.append(
                _merged(store, file, delete=delete, newer=not delete_newer, retained=kept)
            )
            lesson = _opened(store, outcomes[-1]) if open_lesson else None
            if not as_json:
                click.echo("\n".join(filter(None, (_as_text(outcomes[-1]), lesson))))
        found = store.exchange.content_hash()
    click.echo(
        json.dumps(_as_object(outcomes, found), ensure_ascii=False)
        if as_json
        else f"content_hash  {found}"
    )
    ctx.exit(_REFUSED if any(outcome.error for outcome in outcomes) else 0)


def _all(files: Iterable[Path]) -> Iterator[Path]:
    """Yields the files, and all bundles of folders; also a folder without bundles, which `_merged` refuses."""
    for file in files:
        found = sorted(file.glob(f"*{SUFFIX}")) if file.is_dir() else []
        yield from found or [file]


def _merged(
    store: Store, file: Path, *, delete: bool, newer: bool, retained: tuple[str, ...]
) -> _Outcome:
    try:
        if file.is_dir():
            raise StoreError("bundles_none", path=str(file))
        merge = store.exchange.merge
        return _Outcome(
            file, merge(file, delete=delete, retained=retained, retain_newer=newer), None
        )
    except StoreError as error:
        return _Outcome(file, None, error)


def _opened(store: Store, outcome: _Outcome) -> str | None:
    """Opens the lesson of a lesson file; returns a message about it, None for another file."""
    if outcome.report is None or outcome.report.info.lesson_id is None:
        return None
    title = store.lessons.resume(outcome.report.info.lesson_id).title
    return describe("lesson_file_opened", {"title": title}, language_of_system()).message


def _as_text(outcome: _Outcome) -> str:
    report, error = outcome.report, outcome.error
    if error is not None:
        text = explain(error)
        return f"{text.message}\n{text.full_remedy}"
    assert report is not None
    params: dict[str, Any] = {"file": outcome.file.name, "computer": report.info.computer_name}
    for table in ("groups", "programs", "versions", "runs"):
        params[table] = report.added.get(table, 0)
    for name in ("changed", "skipped", "removed"):
        params[name] = sum(getattr(report, name).values())
    code = "merged_nothing_new" if report.nothing_new else "merged"
    lines = [describe(code, params, language_of_system()).message]
    if report.info.anonymous and report.added.get("groups"):
        lines.append(describe("merged_nameless", params, language_of_system()).message)
    if report.n_unconfirmed:
        params["count"] = report.n_unconfirmed
        lines.append(describe("merged_unconfirmed", params, language_of_system()).message)
    if report.would_delete is not None:
        lines += _would_delete(report.would_delete)
    lines += [_about("merge_kept", one) for one in report.retained]
    if report.left_in:
        retained = {"files": report.left_in}
        lines.append(describe("merge_deleted_kept", retained, language_of_system()).message)
    return "\n".join(lines)


def _would_delete(pending: PendingDeletion) -> list[str]:
    text = describe("merge_would_delete", asdict(pending), language_of_system())
    newer = [
        _about("merge_moved_group" if one.is_moved else f"merge_newer_{one.kind}", one)
        for one in pending.work
        if one.is_newer
    ]
    return [text.message, *newer, text.full_remedy]


def _about(code: str, one: PendingWork) -> str:
    return describe(code, asdict(one), language_of_system()).message


def _as_object(outcomes: list[_Outcome], found: str) -> dict[str, Any]:
    added: Counter[str] = Counter()
    for outcome in outcomes:
        added.update(outcome.report.added if outcome.report else {})
    return {
        "files": [_of_file(outcome) for outcome in outcomes],
        "added": dict(added),
        "content_hash": found,
    }


def _of_file(outcome: _Outcome) -> dict[str, Any]:
    report, error = outcome.report, outcome.error
    if report is None:
        assert error is not None
        explanation = explain(error)
        text = {
            "code": error.code,
            "message": explanation.message,
            "remedy": explanation.full_remedy,
        }
        detail = error.params.get("problem")  # text of the library or the check, untranslated
        return {"file": str(outcome.file), "error": {**text, "detail": detail}}
    counts = {name: getattr(report, name) for name in ("added", "changed", "skipped", "removed")}
    return {
        "file": str(outcome.file),
        "error": None,
        "computer_id": report.info.computer_id,
        "computer_name": report.info.computer_name,
        "exported_at": report.info.exported_at,
        "n_unconfirmed": report.n_unconfirmed,
        "nothing_new": report.nothing_new,
        **_pending(report.would_delete),
        "kept": [asdict(one) for one in report.retained],
        "still_in": report.left_in,
        **counts,
    }


def _pending(pending: PendingDeletion | None) -> dict[str, Any]:
    """Returns `would_delete` with the numbers of rows to delete, and `can_keep` with their groups and programs."""
    if pending is None:
        return {"would_delete": None, "can_keep": []}
    counts = asdict(pending)
    work = counts.pop("work")
    return {
        "would_delete": counts,
        "can_keep": [{**one, "is_newer": one["id"] in pending.newer} for one in work],
    }
