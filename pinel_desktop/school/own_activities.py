"""Activities by name: shipped activities, and own activities, which a teacher made and the store holds by key.

An own activity is data that may come from another PC. It is validated like a file each time it is read.
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
    """Returns the activity with that name, also a deleted own activity, because lessons and programs still name it.

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
    """Returns the activity of a row, named by the row's key. Raises PinelError as `known_activity`."""
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
    """Returns the shapes in the picture of an activity's goal. Raises StoreError `own_activity_not_found`."""
    from pinel_desktop.activities import activity_names, shipped_goal  # noqa: PLC0415 - heavy

    return (
        shipped_goal(name) if name in activity_names() else own_goal(store.own_activities.get(name))
    )


def own_goal(row: OwnActivityRow) -> "Goal":
    """Returns the picture of an own activity's goal; without shapes if the row has no valid picture."""
    from pydantic import ValidationError  # noqa: PLC0415 - heavy

    from pinel_desktop.activities import Goal  # noqa: PLC0415 - heavy

    try:
        return Goal.model_validate_json(json.dumps(row.goal))
    except ValidationError:
        return Goal(lines=[], zones=[], boxes={})


def all_titles(store: Store, language: str) -> dict[str, str]:
    """Returns the titles of all activities in a language, by name, including deleted own activities."""
    from pinel_desktop.activities import activity_titles  # noqa: PLC0415 - heavy

    return {**activity_titles(language), **store.own_activities.titles()}


def in_all_languages(text: str) -> dict[str, str]:
    """Returns a text that a teacher wrote once under each language, the form of texts in activities."""
    return dict.fromkeys(LANGUAGES, text)


def save_activity(
    store: Store, activity: "Activity", document: Mapping[str, Any]
) -> OwnActivityRow:
    """Stores an activity with the picture of its goal.

    Args:
        document: the activity as JSON data.

    Raises:
        StoreError: `name_empty`, `name_too_long`, `own_activities_too_many`.
        PinelError: `own_activity_unsound` if its solution does not pass, or if a program without commands passes.
    """
    from pinel_desktop.activities import goal_of, trials  # noqa: PLC0415 - heavy
    from pinel_desktop.program.reading import read_document  # noqa: PLC0415

    if not all(trial.is_right for trial in trials(activity, ("ideal",))):
        raise PinelError("own_activity_unsound")
    goal = goal_of(activity, read_document(activity.solution or {}))
    title = activity.title.of(LANGUAGES[0])
    return store.own_activities.save(activity.name, title, document, goal.model_dump(mode="json"))
