"""Judging a run that the group watched: finds its case, and decides whether and how a real robot's run can be judged.

For a real robot the room replaces the world, and the pose is the robot's own odometry in the start frame. Only what
needs neither the world nor the true pose is judged: the program, the run's events, and the driven figure.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, Literal, NamedTuple, get_args

from pydantic import ValidationError

from pinel_desktop.activities.checks.base import RealRobotTolerance, SimulatorRequirement
from pinel_desktop.activities.faults import world_of
from pinel_desktop.activities.model import Activity, Case
from pinel_desktop.activities.reading import solution_of
from pinel_desktop.activities.run_log import RunLog
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe
from pinel_desktop.program.sensors import SENSORS
from pinel_desktop.robot import SimulationConfig
from pinel_desktop.robot.robot_profile import RobotProfile
from sim.world import Wall, World, WorldError, world_from_document

# In addition to a check's requirements: walls inside the world's edge, a solution that reads the
# world, different starts.
Missing = Literal[SimulatorRequirement, "walls", "sensors", "starts"]

# Reasons why a run is not judged: missing data of the simulator, or the run itself.
Reason = Literal[Missing, "inputs", "stopped", "failed", "record", "cloud"]
_ORDER: tuple[Missing, ...] = ("zones", "boxes", "walls", "sensors", "starts", "contact", "pace")

# Actions that drive to a place by its name.
_BY_PLACE = frozenset({"go_to_place"})

# Noise of the poses of wheels and cameras: some mm, some tenths of a degree.
_NOISE_M, _NOISE_DEG = 0.01, 0.5
# Measured on the Pioneer double: it overshoots each goal by 3 cm and returns, which makes 4.19 m of
# 4 m.
_PATH = 0.06
_TOLERANCES = ("move_tolerance_m", "turn_tolerance_deg")


def cases_in(activity: Activity, world: Mapping[str, Any], setting: SimulationConfig) -> list[int]:
    """Returns the numbers, from 1, of the cases with this world, start and robot.

    Args:
        world: the world document of the run.

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
    """Returns whether the inputs of a run so far are the first inputs of a case."""
    gestures, answers = _gestures(log), _answers(log)
    return _begins(case.gestures, gestures) and _begins(case.answers, answers)


def case_of_run(
    activity: Activity, world: Mapping[str, Any], setting: SimulationConfig, log: RunLog
) -> int | None:
    """Returns the number, from 1, of the case with a run's world, start, robot and inputs; None without such a case.

    A run without samples has no case: its engine was lost, or an earlier release recorded it.

    Args:
        world: the world document of the run.

    Raises:
        PinelError: what `world_of` raises.
    """
    numbers = cases_in(activity, world, setting)
    return _first_like(activity, numbers, log)


def case_of_real_run(activity: Activity, log: RunLog) -> int | None:
    """Returns the number, from 1, of the case with the inputs of a real robot's run; ignores world and robot."""
    return _first_like(activity, range(1, len(activity.cases) + 1), log)


def _first_like(activity: Activity, numbers: Iterable[int], log: RunLog) -> int | None:
    if len(log.poses) < 2 and log.ended["state"] != "finished":
        return None
    return next((n for n in numbers if begins_like(activity.cases[n - 1], log)), None)


def _floor(document: Mapping[str, Any]) -> World | None:
    """Returns a world without its name, for comparison; None for an invalid document."""
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
    """Returns an answer in one spelling, because numbers are recorded as numbers."""
    try:
        return f"{float(str(answer).replace(',', '.')):.10g}"
    except ValueError:
        return str(answer)


def _begins(expected: Sequence[str], given: Sequence[str]) -> bool:
    """Returns whether the given inputs are the first of the expected inputs."""
    return [_typed(one) for one in expected[: len(given)]] == [_typed(one) for one in given]


class JudgingBlocker(NamedTuple):
    """A reason why a real robot's run cannot be judged for an activity.

    Attributes:
        checks: kinds of the checks that need the missing data; empty if the world itself is the reason.
    """

    missing: Missing
    checks: tuple[str, ...] = ()


def judging_blockers(activity: Activity) -> tuple[JudgingBlocker, ...]:
    """Returns all reasons why a real robot's run cannot be judged, the plainest first; empty if the run can be judged.

    If the world of an activity matters, runs are not judged, even if each check could be evaluated. The world
    matters if it has boxes, or walls inside its edge, or several starts, or if the solution reads the world.

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
    """Returns why a real robot's run is not judged, and a remedy; omits an unknown reason of a newer release."""
    if reason not in get_args(Reason):
        reason = "failed"
    if reason in _ORDER:
        what = describe(f"not_judged_{reason}", {}, language).message
        description = describe("not_judged_on_robot", {"what": what}, language)
    else:
        description = describe(f"not_judged_{reason}", {}, language)
    return f"{description.message} {description.remedy}".strip()


def not_judgeable_notice(activity: Activity, language: str) -> str | None:
    """Returns the notice that a group reads before a run that will not be judged; None if the run can be judged."""
    found = judging_blockers(activity)
    return not_judged_text(found[0].missing, language) if found else None


def tolerance_of(parameters: Mapping[str, Any]) -> RealRobotTolerance | None:
    """Returns the tolerance for the robot of a run, from the profile in the run's parameters; None for the simulator.

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
    """Returns whether a wall runs along the world's edge; the edge of the room replaces such walls."""
    (x0, y0), (x1, y1) = wall.start, wall.end
    return (x0 == x1 and abs(x0) == x_m) or (y0 == y1 and abs(y0) == y_m)


def _reads_world(value: Any) -> bool:
    """Returns whether a program reads a sensor of the world, or drives to a place by name."""
    if isinstance(value, dict):
        sensor = SENSORS.get(str(value.get("sensor")))
        if (sensor and sensor.of_world) or value.get("action") in _BY_PLACE:
            return True
        return any(map(_reads_world, value.values()))
    return isinstance(value, list) and any(map(_reads_world, value))
