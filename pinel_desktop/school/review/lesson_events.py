"""Saved versions and runs of a lesson, as the review reads them.

Times are ISO 8601 text by the PC's clock, which may be wrong.
"""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Edit:
    """A saved version.

    Attributes:
        number: of the version in its program.
        computer_id: the PC's key; only times of one PC can be compared.
        parent_id: the version that was edited.
        activity, n_hints: the activity that the program is to solve, and how many of its hints were open.
        lesson_id: the lesson, or the part of a joined lesson, in which the version was saved.
        setup_only: True if the blocks equal the blocks of `parent_id`: only world, start, robot, speed or hints
            changed.
    """

    version_id: str
    program_id: str
    program_name: str
    number: int
    at: str
    computer_id: str | None = None
    parent_id: str | None = None
    n_hints: int = 0
    setup_only: bool = False
    lesson_id: str | None = None
    activity: str | None = None


@dataclass(frozen=True, slots=True)
class Run:
    """A run; values known only at its end are None until then.

    Attributes:
        number: of the version, None for a run without one.
        state: "running", "finished", "stopped" or "failed"; `reason` is the cause.
        passed: True if the activity was passed; None without an activity, and for a real run that was not judged.
        unconfirmed: why a pass that came with a file does not count; `passed` is None then.
        lesson_id: the lesson, or the part of a joined lesson, in which the program ran.
        world: its name, "own" for a world that the group made.
        block: id of the block at which it ended; None without one.
        mistake_key: text shown for a run that did not pass, without numbers; equal for equal mistakes.
        link: the robot; "sim" is the simulator.
        duration_s: robot time, which may be slower or faster than wall time.
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
    unconfirmed: str | None = None
    duration_s: float | None = None
    computer_id: str | None = None
    lesson_id: str | None = None
    world: str | None = None
    block: str | None = None
    mistake_key: str | None = None
    link: str = "sim"

    @property
    def counts(self) -> bool:
        """True if the run is an attempt at its activity; a run on a real robot is one only if it was judged."""
        return self.link == "sim" or self.passed is not None


@dataclass(frozen=True, slots=True)
class GroupWork:
    """All edits and runs of a group in a lesson, in any order."""

    id: str
    name: str
    edits: tuple[Edit, ...] = ()
    runs: tuple[Run, ...] = ()


Event = Edit | Run


def key_of(event: Event) -> str:
    """The event's id, UUIDv7 text, which increases within one start of the app."""
    return event.version_id if isinstance(event, Edit) else event.id
