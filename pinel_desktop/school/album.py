"""The album of a group: the stickers that its runs have won.

Everything is derived from stored runs, programs and taught signs, so a merge brings the stickers of another PC. A run
counts here exactly as it counts elsewhere: a pass from a bundle after this PC has repeated it. No sticker is for speed
or for being first, and later runs take none away.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from storage import Store
from storage.runs.album_runs import AlbumRun

if TYPE_CHECKING:
    from pinel_desktop.activities.model import PathName

StickerKind = Literal["mission", "own", "character"]
# runs without a collision for the sticker `careful`; in each the robot must drive at least so far
N_CAREFUL = 10
_MIN_PATH_M = 0.5


@dataclass(frozen=True, slots=True)
class Win:
    """When a sticker was won, by which run; None for a sign, which a class taught."""

    won_at: str
    run_id: str | None


@dataclass(frozen=True, slots=True)
class Sticker:
    """A sticker, or its empty place in the album.

    Attributes:
        name: of the activity, or of the sticker for character: `repair`, `shorter`, `careful`, `taught`.
        title: of the activity; "" for character.
        win: None for an empty place.
        n_done, n_needed: how much of it is done, if it needs more than one run.
    """

    name: str
    kind: StickerKind
    path: "PathName | None" = None
    title: str = ""
    win: Win | None = None
    n_done: int = 0
    n_needed: int = 1


def album_of(store: Store, group_id: str, language: str) -> list[Sticker]:
    """Returns the album of a group: missions along their paths, activities of teachers, then character.

    Raises:
        StoreError: `group_not_found`.
    """
    runs = store.album_runs.of_group(group_id)
    passes = first_passes(runs)
    return [
        *_missions(passes, language),
        *_own_activities(store, passes),
        *_character(store, group_id, runs),
    ]


def first_passes(runs: Iterable[AlbumRun]) -> dict[str, AlbumRun]:
    """Returns the first run that passed each activity."""
    found: dict[str, AlbumRun] = {}
    for run in runs:
        if run.passed and run.activity is not None:
            found.setdefault(run.activity, run)
    return found


def _missions(passes: dict[str, AlbumRun], language: str) -> Iterator[Sticker]:
    from pinel_desktop.activities import activity_names, shipped_activity  # noqa: PLC0415 - heavy

    for mission in map(shipped_activity, activity_names()):
        win = _win(passes.get(mission.name))
        yield Sticker(mission.name, "mission", mission.path, mission.title.of(language), win)


def _own_activities(store: Store, passes: dict[str, AlbumRun]) -> Iterator[Sticker]:
    """Yields the activities of teachers; deleted ones only if the group passed them."""
    offered = store.own_activities.titles(with_deleted=False)
    for name, title in store.own_activities.titles().items():
        if name in offered or name in passes:
            yield Sticker(name, "own", None, title, _win(passes.get(name)))


def _character(store: Store, group_id: str, runs: list[AlbumRun]) -> Iterator[Sticker]:
    careful = [run for run in runs if _is_careful(run)][:N_CAREFUL]
    tenth = careful[N_CAREFUL - 1] if len(careful) == N_CAREFUL else None
    yield Sticker("repair", "character", win=_win(_first_repair(runs)))
    yield Sticker("shorter", "character", win=_win(_first_shorter(store, runs)))
    yield Sticker("careful", "character", win=_win(tenth), n_done=len(careful), n_needed=N_CAREFUL)
    taught_at = store.album_runs.first_taught_at(group_id)
    yield Sticker("taught", "character", win=Win(taught_at, None) if taught_at else None)


def _win(run: AlbumRun | None) -> Win | None:
    return None if run is None else Win(run.started_at, run.id)


def _is_careful(run: AlbumRun) -> bool:
    """Returns whether the robot drove and the run finished, which a collision prevents."""
    return run.state == "finished" and (run.path_length_m or 0.0) >= _MIN_PATH_M


def _first_repair(runs: list[AlbumRun]) -> AlbumRun | None:
    """Returns the first run that passed an activity after another run had failed it."""
    failed = set()
    for run in runs:
        if run.passed and run.activity in failed:
            return run
        if run.passed is False:
            failed.add(run.activity)
    return None


def _first_shorter(store: Store, runs: list[AlbumRun]) -> AlbumRun | None:
    """Returns the first run that passed an activity with fewer blocks than the activity's solution."""
    passed = [run for run in runs if run.passed and run.activity and run.version_id]
    limits = _solution_blocks(store, {str(run.activity) for run in passed})
    documents = store.album_runs.documents({str(run.version_id) for run in passed})
    for run in passed:
        limit, document = limits.get(str(run.activity)), documents.get(str(run.version_id))
        if limit and document and _n_blocks(document) < limit:
            return run
    return None


def _n_blocks(document: dict[str, Any]) -> int:
    from pinel_desktop.activities.commands import commands_of  # noqa: PLC0415 - heavy

    return len(commands_of(document))


def _solution_blocks(store: Store, activities: set[str]) -> dict[str, int]:
    """Returns the number of blocks of the solutions of activities; an activity of a newer release has none."""
    from pinel_desktop.activities import activity_names, solution_of  # noqa: PLC0415 - heavy

    shipped = activities.intersection(activity_names())
    own = store.album_runs.own_solutions(activities - shipped)
    solutions = {**own, **{name: solution_of(name) for name in shipped}}
    return {name: _n_blocks(solution) for name, solution in solutions.items() if solution}
