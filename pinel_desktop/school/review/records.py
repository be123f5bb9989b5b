"""What a lesson leaves behind, as plain records. Times are ISO 8601 text of the PC's own clock, which may be wrong."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Edit:
    """A version that was saved.

    Attributes:
        number: counts the versions of a program.
        computer_id: the PC's key; only times of one PC can be compared.
        parent_id: the version that was edited.
    """

    version_id: str
    program_id: str
    program_name: str
    number: int
    at: str
    computer_id: str | None = None
    parent_id: str | None = None


@dataclass(frozen=True, slots=True)
class Run:
    """A run; what is not known before its end is None until then.

    Attributes:
        number: of the version, None for a run without one.
        state: "running", "finished", "stopped" or "failed"; `reason` why.
        passed: whether the activity was passed; None where there was none to pass.
        duration_s: time of the robot, which may run slower or faster than the clock.
    """

    id: str
    program_id: str | None
    program_name: str | None
    version_id: str | None
    at: str
    state: str
    number: int | None = None
    ended_at: str | None = None
    reason: str | None = None
    activity: str | None = None
    passed: bool | None = None
    duration_s: float | None = None
    computer_id: str | None = None


@dataclass(frozen=True, slots=True)
class GroupWork:
    """What a group did in a lesson, in any order."""

    id: str
    name: str
    edits: tuple[Edit, ...] = ()
    runs: tuple[Run, ...] = ()


Event = Edit | Run


def key_of(event: Event) -> str:
    """UUIDv7 text: within one start of the app each is greater than the one before, whatever the clock does."""
    return event.version_id if isinstance(event, Edit) else event.id
