"""Which case of an activity a run that a group saw was, if any."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from pinel_desktop.activities.evidence import RunLog
from pinel_desktop.activities.faults import world_of
from pinel_desktop.activities.model import Activity, Case
from pinel_desktop.robot import Setting
from sim.world import World, WorldError, world_from_document


def cases_in(activity: Activity, world: Mapping[str, Any], setting: Setting) -> list[int]:
    """Numbers from 1 of the cases that have this world, start and robot.

    Args:
        world: the world's document.

    Raises:
        PinelError: what `world_of` raises.
    """
    floor = _floor(world)
    if floor is None or setting != Setting(activity.model, activity.preset, activity.feedback):
        return []
    cases = enumerate(activity.cases, 1)
    return [number for number, case in cases if floor == _floor(world_of(activity, case))]


def begins_like(case: Case, log: RunLog) -> bool:
    """Whether what a run was given so far is the beginning of what a case gives."""
    gestures, answers = _gestures(log), _answers(log)
    return _begins(case.gestures, gestures) and _begins(case.answers, answers)


def case_of_run(
    activity: Activity, world: Mapping[str, Any], setting: Setting, log: RunLog
) -> int | None:
    """Number from 1 of the case whose world, start, robot and inputs a run had; None for a run of another kind.

    A run without samples, of an engine that was lost or of an earlier release, is none.

    Args:
        world: the world's document.

    Raises:
        PinelError: what `world_of` raises.
    """
    if len(log.poses) < 2 and log.ended["state"] != "finished":
        return None
    numbers = cases_in(activity, world, setting)
    return next((n for n in numbers if begins_like(activity.cases[n - 1], log)), None)


def _floor(document: Mapping[str, Any]) -> World | None:
    """A world without its name, for comparing."""
    try:
        return replace(world_from_document(dict(document)), name="")
    except WorldError:
        return None


def _gestures(log: RunLog) -> list[str]:
    events = (event for event in log.events if event["type"] == "gesture_result")
    return [str(event["result"]) for event in events if event["source"] == "capture"]


def _answers(log: RunLog) -> list[str]:
    return [_typed(event["value"]) for event in log.events if event["type"] == "answered"]


def _typed(answer: object) -> str:
    """An answer in one spelling: numbers are recorded as numbers."""
    try:
        return f"{float(str(answer).replace(',', '.')):.10g}"
    except ValueError:
        return str(answer)


def _begins(wanted: Sequence[str], given: Sequence[str]) -> bool:
    """Whether a run was given the beginning of what a case gives."""
    return [_typed(one) for one in wanted[: len(given)]] == [_typed(one) for one in given]
