"""Activities by name: those that ship, and those that a teacher made, which the store keeps by their keys.

An own activity is data that may come from another PC: it is read by the same rules as a file each time.
"""

import json
from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from pinel_desktop.errors import PinelError
from pinel_desktop.messages import LANGUAGES
from storage import OwnActivityRow, Store, StoreError

if TYPE_CHECKING:
    from pinel_desktop.activities import Activity, Goal
    from pinel_desktop.program.faults import Fault

_CACHE_SIZE = 64


def known_activity(store: Store, name: str) -> "Activity":
    """The activity of that name, also an own one that was deleted: lessons and programs still name it.

    Raises:
        PinelError: `unknown_activity`, `activity_newer`; `own_activity_unreadable` with faults that no PINEL writes.
    """
    from pinel_desktop.activities import activity_names, shipped_activity  # noqa: PLC0415 - heavy

    if name in activity_names():
        return shipped_activity(name)
    try:
        row = store.own_activities.get(name)
    except StoreError as error:
        if error.code != "own_activity_not_found":
            raise
        raise PinelError("unknown_activity", value=name, allowed=activity_names()) from error
    return own_activity(row)


def own_activity(row: OwnActivityRow) -> "Activity":
    """The activity of a row, by the row's key. Raises PinelError as `known_activity`."""
    activity, faults = _read(json.dumps({**row.document, "name": row.id}))
    if activity is not None and not faults:
        return activity
    newer = next((fault for fault in faults if fault.code == "activity_newer"), None)
    if newer is not None:
        raise PinelError(newer.code, **newer.params)
    raise PinelError("own_activity_unreadable", title=row.title, count=len(faults))


@lru_cache(maxsize=_CACHE_SIZE)
def _read(text: str) -> "tuple[Activity | None, tuple[Fault, ...]]":
    from pinel_desktop.activities import read_activity  # noqa: PLC0415 - heavy

    return read_activity(text)


def goal_of_known(store: Store, name: str) -> "Goal":
    """What the picture of an activity's goal shows. Raises StoreError `own_activity_not_found`."""
    from pinel_desktop.activities import activity_names, shipped_goal  # noqa: PLC0415 - heavy

    return (
        shipped_goal(name) if name in activity_names() else own_goal(store.own_activities.get(name))
    )


def own_goal(row: OwnActivityRow) -> "Goal":
    """The picture of an own activity's goal; only its world where the row holds no picture."""
    from pydantic import ValidationError  # noqa: PLC0415 - heavy

    from pinel_desktop.activities import Goal  # noqa: PLC0415 - heavy

    try:
        return Goal.model_validate_json(json.dumps(row.goal))
    except ValidationError:
        return Goal(lines=[], zones=[], boxes={})


def all_titles(store: Store, language: str) -> dict[str, str]:
    """Titles of all activities in a language, by name, also of own ones that were deleted."""
    from pinel_desktop.activities import activity_titles  # noqa: PLC0415 - heavy

    return {**activity_titles(language), **store.own_activities.titles()}


def in_all_languages(text: str) -> dict[str, str]:
    """A text that a teacher wrote once, as activities have texts."""
    return dict.fromkeys(LANGUAGES, text)


def save_activity(
    store: Store, activity: "Activity", document: Mapping[str, Any]
) -> OwnActivityRow:
    """Keeps an activity with the picture of its goal.

    Args:
        document: of the activity, in JSON.

    Raises:
        StoreError: `name_empty`, `name_too_long`, `own_activities_too_many`.
        PinelError: `own_activity_unsound` where its solution does not pass, or a program without commands does.
    """
    from pinel_desktop.activities import goal_of, trials  # noqa: PLC0415 - heavy
    from pinel_desktop.program.reading import read_document  # noqa: PLC0415

    if not all(trial.is_right for trial in trials(activity, ("ideal",))):
        raise PinelError("own_activity_unsound")
    goal = goal_of(activity, read_document(activity.solution or {}))
    title = activity.title.of(LANGUAGES[0])
    return store.own_activities.save(activity.name, title, document, goal.model_dump(mode="json"))
