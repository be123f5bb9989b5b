"""What the app itself tells all pages on the stream. None of it belongs to the record of a run."""

from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal, TypedDict

from pinel_desktop.events.model import StreamEvent


@dataclass(frozen=True, slots=True)
class Hello(StreamEvent):
    """The first event of the stream.

    Attributes:
        run: id of the live run; null when there is none.
    """

    type: ClassVar[str] = "hello"
    run: str | None


@dataclass(frozen=True, slots=True)
class Notice(StreamEvent):
    """Something that a person should know now, in words of the chosen language.

    A run goes on but is not being recorded (`disk_full`), and is recorded again (`recording_resumed`); the file is
    in danger (`disk_nearly_full`, `backup_failed`), and is no longer (`keeping_well_again`).

    Attributes:
        code: code of the message.
        message: what has happened.
        remedy: what to do.
    """

    type: ClassVar[str] = "notice"
    code: str
    message: str
    remedy: str


class CheckProgress(TypedDict):
    """How a run stands with one check of its activity.

    Attributes:
        criterion: what counts, in words of the chosen language.
        measured: how far the run is, in words; "" where a number says nothing more.
        state: `met` while it holds, `open` while it does not hold yet, `broken` where this run will not fulfil it.
    """

    criterion: str
    measured: str
    state: Literal["open", "met", "broken"]


@dataclass(frozen=True, slots=True)
class CheckStatusChanged(StreamEvent):
    """How a run that goes on, or has just ended, stands with the checks of its activity. Told when that changes.

    Attributes:
        run: id of the run.
        checks: the checks that are known to count in it; a case's own are added when its inputs are known.
    """

    type: ClassVar[str] = "checks_stand"
    run: str
    checks: list[CheckProgress]


class JudgedCase(TypedDict):
    """A case of an activity in which a program was judged.

    Attributes:
        given: what it gives to the program, in words of the chosen language: signs, answers, another start.
        seen: whether it is the run that the group saw; the others were run for the verdict.
        passed: whether the program passed in it.
    """

    given: str
    seen: bool
    passed: bool


@dataclass(frozen=True, slots=True)
class Judged(StreamEvent):
    """A run that has ended was checked against its activity.

    Attributes:
        run: id of the run.
        passed: whether it passed; null if a run on a real robot was not judged.
        missing: in words what does not hold yet; null where the program fulfils the activity, also when the run did
            not come to its end.
        block: id of the block that `missing` is about; null where it is about none.
        cases: every case of an activity that has several.
        by_robot: whether the run that the group saw was judged by what a real robot measured.
        not_judged: in words why it was not judged; null where it was.
    """

    type: ClassVar[str] = "judged"
    run: str
    passed: bool | None
    missing: str | None
    block: str | None = None
    cases: list[JudgedCase] = field(default_factory=list)
    by_robot: bool = False
    not_judged: str | None = None


@dataclass(frozen=True, slots=True)
class ProgramChanged(StreamEvent):
    """A program was saved, deleted or restored; told to all windows that have it open.

    Attributes:
        program: id of the program.
        version: id of the version that was saved; null where the program went into the bin or came out of it.
        deleted_at: since when it lies in the bin; null where it does not.
    """

    type: ClassVar[str] = "program"
    program: str
    version: str | None
    deleted_at: str | None


class DetectedHand(TypedDict):
    """A hand that the camera sees, and what it looks like.

    Attributes:
        points: 21 landmarks [x, y] as fractions of the preview's width and height, mirrored like it.
        handedness: which hand of the person it is.
        best: the likeliest sign; "" where it looks like none.
        confidence: of `best`, 0 to 1.
        second: the next likeliest sign; "" when there is none.
        sure: whether `best` counts for a capture.
    """

    points: list[list[float]]
    handedness: Literal["left", "right"]
    best: str
    confidence: float
    second: str
    sure: bool


@dataclass(frozen=True, slots=True)
class CameraSight(StreamEvent):
    """What the camera sees just now, at most 10 times a second; never a picture.

    Attributes:
        hands: the hands in the picture, at most two.
        label: the sign that is becoming steady; "" while none is.
        progress: how near it is to being the answer of a capture, 0 to 1.
        moved: the sign that a movement has shown, told for about a second; "" while there is none.
        moved_confidence: of `moved`, 0 to 1; higher for a movement that is nearer to what the class showed.
        aspect: width of the picture divided by its height.
    """

    type: ClassVar[str] = "camera_sight"
    lossy: ClassVar[bool] = True
    hands: list[DetectedHand]
    label: str
    progress: float
    moved: str
    moved_confidence: float
    aspect: float


@dataclass(frozen=True, slots=True)
class CameraChanged(StreamEvent):
    """The camera was switched on or off, or is of no use.

    Attributes:
        state: what it does now.
        code: of the message why it is of no use; null when it is of use, or may become so.
        params: parameters of the message.
        message: what is wrong, in words of the chosen language.
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
    """A real robot that a page asks about, when what is known of it changes, at most twice a second.

    Attributes:
        link: its kind.
        use: what its link is there for: somebody looks at it, a run or a try drives it, or the teacher's keys.
        state: `searching`, `waiting` for the client of the bridge, `connected`, or `silent`: nothing has come for a
            while.
        address: where it is waited for, of the bridge; "" of other kinds.
        age_s: for how many seconds nothing has come; null while it is not silent.
        rate_hz: messages about its pose in a second; null while that is not known.
        battery: its charge from 0 to 1; null if it does not tell.
        x_m: its place in the room, counted from where it stood at the start; null while that is not known.
        y_m: its place, likewise.
        heading_deg: the direction it looks in, in the room.
        holder: who else drives it; null for nobody.
        code: of the message about what is missing, or what ended driving by keys; null where all is well.
        message: that, in words of the chosen language.
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


@dataclass(frozen=True, slots=True)
class SignRecording(StreamEvent):
    """A class teaches the camera a sign: another sample was recorded, all of them were kept, or it was given up.

    Attributes:
        classroom: id of the class.
        sign: name of the sign.
        is_moving: whether movements are recorded, not hands at rest.
        n_samples: hands or movements recorded so far.
        n_wanted: of a whole recording.
        is_kept: whether they are on disk.
        code: of the message why the recording was given up; null where it was not.
        params: parameters of the message.
        message: why, in words of the chosen language.
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
    """The signs that a class taught are no longer those that were listed last.

    Attributes:
        classroom: id of the class; null where it may be any.
    """

    type: ClassVar[str] = "signs_changed"
    classroom: str | None
