"""The result of one job, as plain data."""

from dataclasses import asdict, dataclass, field
from typing import Any, Literal

# why a run did not go well: it touched something, a check does not hold, or the run failed
Cause = Literal["collision", "check", "failure"]
LOST = "worker_lost"  # reason of a row whose process died
TOO_LONG = "too_long"  # reason of a run that its time limit ended


@dataclass(frozen=True, slots=True)
class Row:
    """The result of one job.

    Attributes:
        index, program, world, seed: of the job.
        state, reason, params: how the run ended, as in `RunEnded`; a run beyond the time limit failed as `too_long`.
        passed: whether the activity's checks hold; None without an activity.
        cause: why the run did not go well; None if it did.
        check: kind of the first check that does not hold.
        block, pointer: id of the block to look at for `cause`, and JSON pointer of its command; None without one.
        n_collisions: how often the robot began to touch something.
        closing_error_m: true distance between start and end; None if the run did not start.
        duration_s: robot time.
        end: true pose at the end, x and y in m, yaw in rad, in the world's frame; None if the run did not start.
        path: x and y of poses from the start to the end, evenly spaced in time, in the world's frame.
    """

    index: int
    program: str
    world: str
    seed: int
    state: str = "failed"
    reason: str | None = None
    params: dict[str, Any] = field(default_factory=dict)
    passed: bool | None = None
    cause: Cause | None = None
    check: str | None = None
    block: str | None = None
    pointer: str | None = None
    n_collisions: int = 0
    closing_error_m: float | None = None
    duration_s: float = 0.0
    end: tuple[float, float, float] | None = None
    telemetry_sha256: str | None = None
    path: tuple[tuple[float, float], ...] = ()

    @property
    def is_well(self) -> bool:
        """Whether the run went well: it passed, or without an activity, it reached its end and touched nothing."""
        return self.cause is None

    def as_plain(self) -> dict[str, Any]:
        """Returns plain JSON data."""
        return asdict(self)
