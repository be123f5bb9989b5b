"""Events that the app itself publishes to all pages. None of them belongs to the record of a run."""

from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal, TypedDict

from pinel_desktop.events.model import StreamEvent


@dataclass(frozen=True, slots=True)
class Hello(StreamEvent):
    """The first event of the stream.

    Attributes:
        run: id of the live run; null without one.
    """

    type: ClassVar[str] = "hello"
    run: str | None


@dataclass(frozen=True, slots=True)
class Notice(StreamEvent):
    """A message that a person should read now, in the chosen language.

    Codes: `disk_full` (a run continues but is not recorded), `recording_resumed`, `disk_nearly_full`, `backup_failed`,
    and `keeping_well_again` (both dangers to the file are over).

    Attributes:
        code: code of the message.
        message: what has happened.
        remedy: what to do.
        details: what only a technician can do; mostly empty.
    """

    type: ClassVar[str] = "notice"
    code: str
    message: str
    remedy: str
    details: str


class CheckProgress(TypedDict):
    """Status of one check of an activity in a run.

    Attributes:
        criterion: the condition, as text in the chosen language.
        measured: the progress of the run, as text; "" if a number adds nothing.
        state: `met` while the condition holds, `open` while it does not hold yet, `broken` if this run cannot meet it.
    """

    criterion: str
    measured: str
    state: Literal["open", "met", "broken"]


@dataclass(frozen=True, slots=True)
class CheckStatusChanged(StreamEvent):
    """The check list of a live run, or of a run that has just ended, has changed.

    Attributes:
        run: id of the run.
        checks: the checks that are known to count in the run; the checks of a case are added when its inputs are known.
    """

    type: ClassVar[str] = "checks_stand"
    run: str
    checks: list[CheckProgress]


class JudgedCase(TypedDict):
    """The verdict on one case of an activity.

    Attributes:
        given: inputs of the case, as text in the chosen language: signs, answers, another start.
        seen: whether the group watched this run; the other cases were executed for the verdict only.
        passed: whether the program passed the case.
        path: poses of the robot (x and y in m, yaw in rad, world frame), evenly spaced in time; empty if `seen`.
    """

    given: str
    seen: bool
    passed: bool
    path: list[tuple[float, float, float]]


@dataclass(frozen=True, slots=True)
class Judged(StreamEvent):
    """The verdict on a run that has ended.

    Attributes:
        run: id of the run.
        passed: whether the run passed; null if a run on a real robot was not judged.
        missing: the condition that does not hold yet, as text; null if the program fulfils the activity, even if this
            run was stopped before its end.
        block: id of the block that `missing` refers to; null if it refers to none.
        cases: every case of an activity that has several.
        by_robot: whether the run was judged by the measurements of a real robot.
        not_judged: why the run was not judged, as text; null if it was.
    """

    type: ClassVar[str] = "judged"
    run: str
    passed: bool | None
    missing: str | None
    block: str | None = None
    cases: list[JudgedCase] = field(default_factory=list)
    by_robot: bool = False
    not_judged: str | None = None


class CloudRow(TypedDict):
    """One robot of a cloud.

    Attributes:
        seed: seed of its random numbers, with which a run repeats its drive.
        well: whether it passed, or without an activity, touched nothing and reached the end of the program.
        cause: why not: it touched something, a check does not hold, or the run failed; null if it went well.
        path: poses of the robot (x and y in m, world frame), evenly spaced in time, then the end.
    """

    seed: int
    well: bool
    cause: Literal["collision", "check", "failure"] | None
    path: list[tuple[float, float]]


@dataclass(frozen=True, slots=True)
class CloudProgress(StreamEvent):
    """Robots of a cloud have arrived, or the cloud is over.

    Attributes:
        cloud: id of the cloud.
        n: number of all its robots.
        rows: the robots that have arrived since the last event.
        is_over: whether no more robots come: all have arrived, or the cloud was stopped or lost.
        good: at the end, seeds of the robots that passed, or without an activity, end where most of them end.
        text: at the end, that and what stopped the others, as text in the chosen language.
        block: at the end, id of the block that stopped most of the others; null without one.
    """

    type: ClassVar[str] = "cloud"
    cloud: str
    n: int
    rows: list[CloudRow]
    is_over: bool
    good: list[int]
    text: str
    block: str | None


@dataclass(frozen=True, slots=True)
class ProgramChanged(StreamEvent):
    """A program was saved, deleted or restored.

    Attributes:
        program: id of the program.
        version: id of the saved version; null if the program was moved into the bin or out of it.
        deleted_at: time at which the program was moved into the bin; null if it is not in the bin.
    """

    type: ClassVar[str] = "program"
    program: str
    version: str | None
    deleted_at: str | None


class DetectedHand(TypedDict):
    """A hand in the camera's frame, with the prediction of its sign.

    Attributes:
        box: left, top, right, bottom of the hand as fractions of the preview's width and height, mirrored like the
            preview.
        points: 21 landmarks [x, y] in the same frame; empty if the recognizer has none.
        handedness: whether it is the person's left or right hand; null if the recognizer does not know.
        best: the likeliest sign; "" if the hand shows none.
        confidence: confidence of `best`, 0 to 1.
        second: the second likeliest sign; "" without one.
        sure: whether `best` counts for a capture.
    """

    box: list[float]
    points: list[list[float]]
    handedness: Literal["left", "right"] | None
    best: str
    confidence: float
    second: str
    sure: bool


class DetectedNumber(TypedDict):
    """The number that the hands in the camera's frame show together.

    Attributes:
        best: the likeliest number, in digits; "" if no hand is there to count.
        confidence: confidence of `best`, 0 to 1.
        second: the second likeliest number; "" without one.
        sure: whether `best` counts for a capture.
        progress: progress of `best` towards the answer of the capture, 0 to 1.
    """

    best: str
    confidence: float
    second: str
    sure: bool
    progress: float


@dataclass(frozen=True, slots=True)
class CameraSight(StreamEvent):
    """Hands and signs in the newest frame of the camera, without the frame. Sent at most 10 times a second.

    Attributes:
        hands: the hands in the frame, at most two.
        label: the sign that the stability filter counts now; "" without one.
        progress: progress of `label` towards the answer of a capture, 0 to 1.
        moved: the last sign that a movement showed, for about a second; "" without one.
        moved_confidence: confidence of `moved`, 0 to 1; higher for a movement closer to the samples of the class.
        aspect: width of the frame divided by its height.
        number: the number shown by hand; null unless a capture waits for one.
    """

    type: ClassVar[str] = "camera_sight"
    lossy: ClassVar[bool] = True
    hands: list[DetectedHand]
    label: str
    progress: float
    moved: str
    moved_confidence: float
    aspect: float
    number: DetectedNumber | None = None


@dataclass(frozen=True, slots=True)
class CameraChanged(StreamEvent):
    """The camera was switched on or off, or has failed.

    Attributes:
        state: the new state of the camera.
        code: code of the message about the failure; null without a failure.
        params: parameters of the message.
        message: the failure, as text in the chosen language.
        remedy: what to do.
    """

    type: ClassVar[str] = "camera_state"
    state: Literal["off", "opening", "on", "failed"]
    code: str | None
    params: dict[str, Any]
    message: str
    remedy: str


@dataclass(frozen=True, slots=True)
class RobotStateChanged(StreamEvent):
    """State of a real robot that a page watches. Sent when it changes, at most twice a second.

    Attributes:
        link: kind of the robot's link.
        use: purpose of the link: `watch` for a page, `run` for a run or a trial, `jog` for the teacher's keys.
        state: `searching`, `waiting` for the client of the bridge, `connected`, or `silent`: no message for a while.
        address: address at which the bridge waits for its client; "" for other links.
        age_s: time since the last message while the state is `silent`, in s; else null.
        rate_hz: odometry messages per second; null while unknown.
        battery: charge from 0 to 1; null if the robot does not report it.
        x_m: x in the room's frame, in m, by the odometry since the robot's start; null while unknown.
        y_m: y in the room's frame, in m, by the odometry since the robot's start; null while unknown.
        heading_deg: heading in the room, in degrees; null while unknown.
        holder: name of another program that drives the robot; null without one.
        code: code of the message about a problem, or about the end of driving by keys; null without one.
        message: that message, as text in the chosen language.
        remedy: what to do.
    """

    type: ClassVar[str] = "robot_state"
    link: str
    use: Literal["watch", "run", "jog"]
    state: Literal["searching", "waiting", "connected", "silent"]
    address: str
    age_s: float | None
    rate_hz: float | None
    battery: float | None
    x_m: float | None
    y_m: float | None
    heading_deg: float | None
    holder: str | None
    code: str | None
    message: str
    remedy: str


TruthState = Literal["seeing", "problem", "recorded", "nothing"]


@dataclass(frozen=True, slots=True)
class TruthSourceChanged(StreamEvent):
    """A source that follows a live run on a real robot sees the robot no more, or again; or the run is over.

    Attributes:
        run: id of the run.
        source: the camera above the floor, or the robot's own localisation.
        state: `seeing`, `problem`, `recorded` once what was seen is kept with the run, `nothing` if nothing was.
        code: code of the message about the problem; null without one.
        message: that message, as text in the chosen language.
        remedy: what to do.
    """

    type: ClassVar[str] = "truth_source"
    run: str
    source: Literal["tape", "camera", "localisation"]
    state: TruthState
    code: str | None
    message: str
    remedy: str


@dataclass(frozen=True, slots=True)
class SignRecording(StreamEvent):
    """A class teaches the camera a sign: one more sample was recorded, all were stored, or the recording was aborted.

    Attributes:
        classroom: id of the class.
        sign: name of the sign.
        is_moving: whether the samples are movements, not hands at rest.
        n_samples: number of samples recorded so far.
        n_wanted: number of samples in a complete recording.
        is_kept: whether the samples are on disk.
        code: code of the message about the abort; null without an abort.
        params: parameters of the message.
        message: reason of the abort, as text in the chosen language.
        remedy: what to do.
    """

    type: ClassVar[str] = "sign_recording"
    classroom: str
    sign: str
    is_moving: bool
    n_samples: int
    n_wanted: int
    is_kept: bool
    code: str | None
    params: dict[str, Any]
    message: str
    remedy: str


@dataclass(frozen=True, slots=True)
class SignsChanged(StreamEvent):
    """The list of signs that a class taught has changed.

    Attributes:
        classroom: id of the class; null if any class may be affected.
    """

    type: ClassVar[str] = "signs_changed"
    classroom: str | None


@dataclass(frozen=True, slots=True)
class FileOpened(StreamEvent):
    """A person has opened a file with PINEL, such as by a double click: pages show where the teacher merges it."""

    type: ClassVar[str] = "file_opened"
