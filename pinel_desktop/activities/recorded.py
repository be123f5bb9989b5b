"""A run that a group saw: which case of an activity it was, and of a real robot whether it can be judged, and how.

Of a real robot the room replaces the world, and the pose is its own odometry in the start frame. What is compared with
neither is judged: the program, the run's events, and the figure that was driven.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, Literal, NamedTuple, get_args

from pydantic import ValidationError

from pinel_desktop.activities.checks.base import RealRobotTolerance, SimulatorRequirement
from pinel_desktop.activities.evidence import RunLog
from pinel_desktop.activities.faults import world_of
from pinel_desktop.activities.model import Activity, Case
from pinel_desktop.activities.reading import solution_of
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe
from pinel_desktop.program.sensors import SENSORS
from pinel_desktop.robot import SimulationConfig
from pinel_desktop.robot.robot_profile import RobotProfile
from sim.world import Wall, World, WorldError, world_from_document

# Beside what a check needs: walls within the world's edge, readings of what stands in it, different starts in it.
Missing = Literal[SimulatorRequirement, "walls", "sensors", "starts"]

# Why a run is not judged: what is missing, or that the run itself tells nothing.
Reason = Literal[Missing, "inputs", "stopped", "failed", "record"]
_ORDER: tuple[Missing, ...] = ("zones", "boxes", "walls", "sensors", "starts", "contact", "pace")

# Drives by a place's name.
_BY_PLACE = frozenset({"go_to_place"})

# Poses of wheels and of cameras are good to some mm, headings to some tenths of a degree.
_NOISE_M, _NOISE_DEG = 0.01, 0.5
# Measured on the Pioneer double: past each goal by 3 cm and back, which makes 4.19 m of 4 m.
_PATH = 0.06
_TOLERANCES = ("move_tolerance_m", "turn_tolerance_deg")


def cases_in(activity: Activity, world: Mapping[str, Any], setting: SimulationConfig) -> list[int]:
    """Numbers from 1 of the cases that have this world, start and robot.

    Args:
        world: the world's document.

    Raises:
        PinelError: what `world_of` raises.
    """
    floor = _floor(world)
    if floor is None or setting != SimulationConfig(
        activity.model, activity.preset, activity.feedback
    ):
        return []
    cases = enumerate(activity.cases, 1)
    return [number for number, case in cases if floor == _floor(world_of(activity, case))]


def begins_like(case: Case, log: RunLog) -> bool:
    """Whether what a run was given so far is the beginning of what a case gives."""
    gestures, answers = _gestures(log), _answers(log)
    return _begins(case.gestures, gestures) and _begins(case.answers, answers)


def case_of_run(
    activity: Activity, world: Mapping[str, Any], setting: SimulationConfig, log: RunLog
) -> int | None:
    """Number from 1 of the case whose world, start, robot and inputs a run had; None for a run of another kind.

    A run without samples, of an engine that was lost or of an earlier release, is none.

    Args:
        world: the world's document.

    Raises:
        PinelError: what `world_of` raises.
    """
    numbers = cases_in(activity, world, setting)
    return _first_like(activity, numbers, log)


def case_of_real_run(activity: Activity, log: RunLog) -> int | None:
    """Number from 1 of the case whose inputs a run on a real robot had; world and robot are its own."""
    return _first_like(activity, range(1, len(activity.cases) + 1), log)


def _first_like(activity: Activity, numbers: Iterable[int], log: RunLog) -> int | None:
    if len(log.poses) < 2 and log.ended["state"] != "finished":
        return None
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


def _begins(expected: Sequence[str], given: Sequence[str]) -> bool:
    """Whether a run was given the beginning of what a case gives."""
    return [_typed(one) for one in expected[: len(given)]] == [_typed(one) for one in given]


class JudgingBlocker(NamedTuple):
    """Why a real run cannot be judged for an activity.

    Attributes:
        checks: kinds of the checks that need it; none where the world itself is the reason.
    """

    missing: Missing
    checks: tuple[str, ...] = ()


def judging_blockers(activity: Activity) -> tuple[JudgingBlocker, ...]:
    """All that keeps a real run from being judged, the plainest first; none where it can be judged.

    An activity whose world matters is not judged, even if each of its checks could be: one with boxes or with walls
    within its edge, with several starts, or whose solution reads what stands in the world.

    Raises:
        PinelError: what `world_of` raises.
    """
    found: dict[Missing, list[str]] = {one: [] for one in _of_world(activity)}
    for check in activity.all_checks():
        for requirement in check.requirements():
            kinds = found.setdefault(requirement, [])
            if check.check not in kinds:
                kinds.append(check.check)
    return tuple(JudgingBlocker(one, tuple(found[one])) for one in _ORDER if one in found)


def not_judged_text(reason: str, language: str) -> str:
    """Why a run on a real robot is not judged, and what to do; that of a newer release says only that it was not."""
    if reason not in get_args(Reason):
        reason = "failed"
    if reason in _ORDER:
        what = describe(f"not_judged_{reason}", {}, language).message
        description = describe("not_judged_on_robot", {"what": what}, language)
    else:
        description = describe(f"not_judged_{reason}", {}, language)
    return f"{description.message} {description.remedy}".strip()


def not_judgeable_notice(activity: Activity, language: str) -> str | None:
    """What a group reads before the run if it will not be judged; None if it can be."""
    found = judging_blockers(activity)
    return not_judged_text(found[0].missing, language) if found else None


def tolerance_of(parameters: Mapping[str, Any]) -> RealRobotTolerance | None:
    """How exactly the robot of a run drives, by the robot's record in the run's parameters; None for the simulator.

    Raises:
        PinelError: `run_damaged`.
    """
    robot = parameters.get("robot")
    if not isinstance(robot, Mapping):
        return None
    try:
        record = RobotProfile.model_validate(
            {name: robot[name] for name in _TOLERANCES if name in robot}
        )
    except ValidationError as error:
        raise PinelError("run_damaged", part="parameters") from error
    move_m, turn_deg = record.move_tolerance_m, record.turn_tolerance_deg
    return RealRobotTolerance(move_m + _NOISE_M, turn_deg + _NOISE_DEG, _PATH)


def _of_world(activity: Activity) -> Iterator[Missing]:
    document = world_of(activity)
    world = world_from_document(document)
    width_m, depth_m = document.get("size_m", (0.0, 0.0))
    if world.boxes:
        yield "boxes"
    if any(not _is_edge(wall, width_m / 2, depth_m / 2) for wall in world.walls):
        yield "walls"
    if any(_reads_world(one) for one in (activity.solution, solution_of(activity.name))):
        yield "sensors"
    if any(case.start != activity.cases[0].start for case in activity.cases):
        yield "starts"


def _is_edge(wall: Wall, x_m: float, y_m: float) -> bool:
    """Whether a wall runs along the edge of the world, in place of which there is the edge of the room."""
    (x0, y0), (x1, y1) = wall.start, wall.end
    return (x0 == x1 and abs(x0) == x_m) or (y0 == y1 and abs(y0) == y_m)


def _reads_world(value: Any) -> bool:
    """Whether a program has a sensor that reads the world, or drives to a place by name."""
    if isinstance(value, dict):
        sensor = SENSORS.get(str(value.get("sensor")))
        if (sensor and sensor.of_world) or value.get("action") in _BY_PLACE:
            return True
        return any(map(_reads_world, value.values()))
    return isinstance(value, list) and any(map(_reads_world, value))
