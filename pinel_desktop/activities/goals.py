"""The goal of an activity as data for a picture: drawing or path of the solution, and the zones to reach."""

from functools import cache
from importlib import resources

from pydantic import BaseModel, ConfigDict

from pinel_desktop.activities.checking import spec_of
from pinel_desktop.activities.faults import world_of
from pinel_desktop.activities.model import Activity, Case
from pinel_desktop.events.model import BoxesMoved, Event, Pen, Telemetry
from pinel_desktop.program.reading import ParseResult
from pinel_desktop.robot import Pose2D
from pinel_desktop.runs.start import start
from sim.world import world_from_document

GOAL_FILE = "goal.json"
_DECIMALS = 2

BoxPose = tuple[float, float, float]


class _Model(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class GoalLine(_Model):
    """The robot's path, or its drawing if the solution uses the pen.

    Attributes:
        sign: the sign of the case; None for a case without a sign or with several signs.
        color: colour of the pen; None for a path.
        points: x and y in m, world frame.
    """

    sign: str | None
    color: str | None
    points: list[tuple[float, float]]


class Goal(_Model):
    """The parts of the picture on the activity's world.

    Attributes:
        zones: names of the required zones, in their order.
        boxes: end poses of the pushed boxes by index: x and y in m and yaw in rad, world frame.
    """

    lines: list[GoalLine]
    zones: list[str]
    boxes: dict[str, BoxPose]


@cache
def shipped_goal(name: str) -> Goal:
    """Returns the goal of a shipped activity, which `python -m scripts.reference` generates."""
    file = resources.files(__name__.rpartition(".")[0]) / "catalogue" / name / GOAL_FILE
    return Goal.model_validate_json(file.read_text("utf-8"))


def goal_of(activity: Activity, solution: ParseResult | None) -> Goal:
    """Returns the goal from runs of a program that passes; without a program the zones are the goal.

    If cases have a single sign, draws each of them, because cases with several signs only repeat these. Otherwise
    draws the first case.
    """
    signed = [case for case in activity.cases if _sign(case)]
    cases = (signed or activity.cases[:1]) if solution else []
    drives = [_Drive(activity, case, solution) for case in cases if solution]
    lines = [line for drive in drives for line in drive.lines()]
    boxes = drives[0].boxes if drives else {}
    return Goal(lines=lines if activity.shows_path else [], zones=_zones(activity), boxes=boxes)


class _Drive:
    """A run of one case of the activity."""

    def __init__(self, activity: Activity, case: Case, solution: ParseResult) -> None:
        self.boxes: dict[str, BoxPose] = {}
        self._sign = _sign(case)
        self._start = Pose2D(*world_from_document(world_of(activity, case)).start)
        self._pose = self._start
        self._path = self._position()
        self._strokes: list[tuple[str, list[float]]] = []
        self._is_down = False
        start(spec_of(activity, case, solution), self._observe)

    def lines(self) -> list[GoalLine]:
        """Returns the strokes of the pen; without strokes, the path."""
        if not self._strokes:
            return [self._line(None, self._path)]
        return [self._line(color, trail) for color, trail in self._strokes]

    def _line(self, color: str | None, trail: list[float]) -> GoalLine:
        return GoalLine(sign=self._sign, color=color, points=_points(trail))

    def _observe(self, _tick: int, event: Event) -> None:
        if type(event) is Telemetry:
            self._drive_to(self._start.compose(Pose2D(event.x_m, event.y_m)))
        elif type(event) is Pen:
            self._is_down = event.down
            if event.down:
                self._strokes.append((event.color, self._position()))
        elif type(event) is BoxesMoved:
            for index, (x, y, yaw) in event.boxes.items():
                self.boxes[index] = (_rounded(x), _rounded(y), _rounded(yaw))

    def _position(self) -> list[float]:
        return [self._pose.x_m, self._pose.y_m]

    def _drive_to(self, pose: Pose2D) -> None:
        self._pose = pose
        self._path += self._position()
        if self._is_down:
            self._strokes[-1][1].extend(self._position())


def _sign(case: Case) -> str | None:
    signs = [sign for sign in case.gestures if sign]
    return signs[0] if len(signs) == 1 else None


def _points(trail: list[float]) -> list[tuple[float, float]]:
    from storage.runs.simplify_path import outline_of_trail  # noqa: PLC0415 - slow, and no job needs it

    return [(_rounded(x), _rounded(y)) for x, y in outline_of_trail(trail)]


def _rounded(value: float) -> float:
    return round(value, _DECIMALS) + 0.0  # no -0.0


def _zones(activity: Activity) -> list[str]:
    return list(
        dict.fromkeys(zone for check in activity.all_checks() for zone in check.goal_zones())
    )
