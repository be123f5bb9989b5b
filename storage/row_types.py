"""Types of the rows that the store returns. Times are ISO 8601 text in UTC, ids UUID text."""

import math
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from storage.limits import N_FEATURES
from storage.text import readable_object, readable_points

_SAMPLE_BYTES = 2 * N_FEATURES

Json = dict[str, Any]
TruePoseRow = tuple[int | None, float, float, float, float, float]
SIMULATOR = "sim"  # the link of simulated runs
CALIBRATED_ROBOT = "calibrated_robot"  # name of a run's calibrated robot, in its parameters


@dataclass(frozen=True, slots=True)
class GroupRow:
    """Pupils who work together; `n_programs` is without programs in the bin, whose number is `n_in_bin`.

    Attributes:
        has_album: False if the preset of its class switches albums of stickers off.
        robot_name: "" if the robot has the group's name.
        robot_pattern: one of `choices.PATTERNS`; "" for groups of earlier releases.
    """

    id: str
    name: str
    color: str
    picture: str
    robot_name: str
    robot_pattern: str
    classroom_id: str | None
    created_at: str
    n_programs: int = 0
    n_in_bin: int = 0
    n_runs: int = 0
    has_album: bool = True


@dataclass(frozen=True, slots=True)
class ClassroomRow:
    """A class of the school; `computer` is the PC of its first lesson, None before."""

    id: str
    name: str
    created_at: str
    computer: str | None = None
    n_groups: int = 0


@dataclass(frozen=True, slots=True)
class LessonRow:
    """A meeting of a class; `title` is "" if the lesson opened by itself.

    Attributes:
        computer: name of the PC that opened it last.
        part_of: the lesson that it was joined to.
    """

    id: str
    classroom_id: str | None
    title: str
    activity: str | None
    by_itself: bool
    computer_id: str
    computer: str | None
    opened_at: str
    used_at: str
    closed_at: str | None
    part_of: str | None
    n_versions: int = 0
    n_runs: int = 0


@dataclass(frozen=True, slots=True)
class NoteRow:
    """A note of the teacher about a run."""

    id: str
    run_id: str
    text: str
    written_at: str
    seen_at: str | None
    program_id: str | None
    program_name: str | None


@dataclass(frozen=True, slots=True)
class OwnActivityRow:
    """An activity that a teacher made; `document` and `goal` as pinel_desktop/activities reads and writes them."""

    id: str
    title: str
    document: Json
    goal: Json
    created_at: str
    deleted_at: str | None


@dataclass(frozen=True, slots=True)
class CalibratedRobotRow:
    """A robot of the simulator with the errors of a real one.

    Attributes:
        model: name of the model that it differs from.
        parameters, report: as pinel_desktop/calibration/report.py writes them.
    """

    id: str
    title: str
    model: str
    parameters: Json
    report: Json
    created_at: str
    deleted_at: str | None


@dataclass(frozen=True, slots=True)
class SignSamples:
    """A sign that a class taught.

    Attributes:
        samples, movements: hands at rest, and movements; rows of `N_FEATURES` float16, little-endian, newest first.
    """

    sign: str
    samples: bytes = b""
    movements: bytes = b""

    @property
    def n_samples(self) -> int:
        return len(self.samples) // _SAMPLE_BYTES

    @property
    def hands(self) -> list[bytes]:
        """The samples, one by one."""
        starts = range(0, len(self.samples), _SAMPLE_BYTES)
        return [self.samples[start : start + _SAMPLE_BYTES] for start in starts]

    @property
    def n_movements(self) -> int:
        return len(self.movements) // _SAMPLE_BYTES


@dataclass(frozen=True, slots=True)
class ProgramRow:
    """Saved blocks of a group."""

    id: str
    name: str
    group_id: str
    created_at: str
    updated_at: str
    deleted_at: str | None = None
    n_versions: int = 0
    n_runs: int = 0


@dataclass(frozen=True, slots=True)
class FaultRow:
    """One fault of a document, without its message."""

    code: str
    pointer: str
    block: str | None
    params: Json


@dataclass(frozen=True, slots=True)
class VersionRow:
    """One state of a program; `document` is None while it has faults, `world` if the group made no world for it.

    Attributes:
        setup: name of the world, start, robot setting, speed, activity; None if an earlier release saved it.
    """

    id: str
    program_id: str
    created_at: str
    workspace: Json
    document: Json | None
    faults: tuple[FaultRow, ...]
    world: Json | None = None
    setup: Json | None = None
    number: int = 0
    label: str = ""
    parent_id: str | None = None
    lesson_id: str | None = None


@dataclass(frozen=True, slots=True)
class VersionSummary:
    """A version in the history of a program, without its content.

    Attributes:
        label: the name that its group gave it, "" for none.
        n_runs: number of its runs.
        n_passed: number of its runs that passed the activity.
        setup: as in `VersionRow`.
        setup_only: True if it has the blocks of its parent: only its setup or the group's own world changed.
    """

    id: str
    number: int
    created_at: str
    can_run: bool
    label: str
    parent_id: str | None
    lesson_id: str | None
    computer: str | None
    n_runs: int
    n_passed: int
    setup: Json | None
    setup_only: bool


@dataclass(frozen=True, slots=True)
class RunStart:
    """The data of a run at its start. Give `version_id`, or `document` for a run without a version.

    Attributes:
        program_id: for a run whose document grows (`Runs.update_document`), the program whose version it becomes.
    """

    link: str
    world: str
    world_document: Json
    seed: int
    app_version: str
    version_id: str | None = None
    document: Json | None = None
    parameters: Json = field(default_factory=dict)
    activity: str | None = None
    program_id: str | None = None


@dataclass(frozen=True, slots=True)
class RunRow:
    """One execution; its metrics are None until it has ended."""

    id: str
    group_id: str | None
    program_id: str | None
    program_name: str | None
    version_id: str | None
    document: Json | None
    link: str
    world: str
    world_document: Json
    seed: int
    parameters: Json
    app_version: str
    state: str
    reason: str | None
    params: Json
    block: str | None
    started_at: str
    ended_at: str | None
    duration_s: float | None
    n_executed: int | None
    path_length_m: float | None
    closing_error_m: float | None
    summary: Json
    telemetry_sha256: str | None
    path: list[list[float]]
    lesson_id: str | None = None
    computer_id: str | None = None
    activity: str | None = None
    passed: bool | None = None
    check_report: Json | None = None
    unconfirmed: str | None = None

    @property
    def estimated_closing_error_m(self) -> float | None:
        """As in the event `run_ended`; None before the end, and in runs of earlier releases."""
        return _estimated_closing_error_m(self.summary)

    @property
    def model(self) -> str | None:
        """Name of the robot model; None for a run of the first releases, which had one model."""
        return _model(self.parameters)

    @property
    def calibrated_robot(self) -> str | None:
        """Name of the calibrated robot that drove; None of others."""
        return _calibrated_robot(self.parameters)

    @property
    def counted(self) -> bool | None:
        """`passed`, but None while the pass does not count."""
        return None if self.unconfirmed else self.passed


def _calibrated_robot(parameters: Json) -> str | None:
    value = parameters.get(CALIBRATED_ROBOT)
    return value if isinstance(value, str) else None


def _model(parameters: Json) -> str | None:
    value = parameters.get("model")
    return value if isinstance(value, str) else None


def _estimated_closing_error_m(summary: Json) -> float | None:
    """Returns the value from the run's summary, None if it is no number: in a bundle it may be anything."""
    value = summary.get("estimated_closing_error_m")
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return value if math.isfinite(value) else None


class TruthRow(NamedTuple):
    """Where a real robot truly was in a run, by one source.

    Attributes:
        poses: tick (None: after the run), x, y in m, heading in rad, one sigma of position in m and of heading in rad;
            in the frame of the start, in the order of the ticks.
    """

    run_id: str
    source: str
    measured_at: str
    poses: tuple[TruePoseRow, ...]


class RunSummary(NamedTuple):
    """A run for lists, without its world and program. JSON is parsed on access.

    The fields are columns of `runs`, except `unconfirmed`: why a pass does not count, None if it does. It is `waiting`
    until this PC has repeated the run, then the finding (`storage/runs/confirmation.py`).
    """

    id: str
    group_id: str | None
    program_id: str | None
    program_name: str | None
    version_id: str | None
    link: str
    world: str
    seed: int
    state: str
    reason: str | None
    params_json: str | None
    block: str | None
    started_at: str
    ended_at: str | None
    duration_s: float | None
    n_executed: int | None
    path_length_m: float | None
    closing_error_m: float | None
    telemetry_sha256: str | None
    lesson_id: str | None
    computer_id: str | None
    activity: str | None
    passed_bit: int | None
    path_json: str | None
    summary_json: str | None
    parameters_json: str | None
    unconfirmed: str | None

    @property
    def model(self) -> str | None:
        """As in `RunRow`."""
        return _model(readable_object(self.parameters_json) or {})

    @property
    def calibrated_robot(self) -> str | None:
        """As in `RunRow`."""
        return _calibrated_robot(readable_object(self.parameters_json) or {})

    @property
    def params(self) -> Json:
        """Parameters of the reason's message."""
        return readable_object(self.params_json) or {}

    @property
    def estimated_closing_error_m(self) -> float | None:
        """As in `RunRow`."""
        return _estimated_closing_error_m(readable_object(self.summary_json) or {})

    @property
    def path(self) -> list[list[float]]:
        """Points for the picture, in m."""
        return readable_points(self.path_json)

    @property
    def passed(self) -> bool | None:
        """Whether the run passed the activity; None without activity, and while the pass does not count."""
        return None if self.passed_bit is None else bool(self.passed_bit)
