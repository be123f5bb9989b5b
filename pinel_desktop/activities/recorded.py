"""Which case of an activity a run that a group saw was, if any."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from pinel_desktop.activities.evidence import RunLog
from pinel_desktop.activities.faults import world_of
from pinel_desktop.activities.model import Activity
from pinel_desktop.robot import Setting
from sim.world import World, WorldError, world_from_document


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
    if setting != Setting(activity.model, activity.preset, activity.feedback):
        return None
    if len(log.poses) < 2 and log.ended["state"] != "finished":
        return None
    floor = _floor(world)
    gestures, answers = _gestures(log), _answers(log)
    for number, case in enumerate(activity.cases, 1):
        same_inputs = _begins(case.gestures, gestures) and _begins(case.answers, answers)
        if same_inputs and floor is not None and floor == _floor(world_of(activity, case)):
            return number
    return None


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
