"""What another thread asks of a run: pause, go on, step, stop, hold at blocks, another speed."""

from typing import Literal

from pinel_desktop.events.model import PauseCause

StepMode = Literal["into", "over", "out"]
LEAST_SPEED, GREATEST_SPEED = 0.1, 10.0


class RunControl:
    """The wishes of whoever watches a run; each is a plain value, read once a tick or before each command.

    Stop wins over everything, also over a pause.

    Attributes:
        breakpoints: ids of the blocks before which the run pauses.
        step: how far the run goes on before it pauses again; None when it just runs.
        hold_at: the run pauses when so many commands have begun, for the cause given; None when it does not.
        looks: which rings of sensors somebody watches: "sonar", "lidar".
        speed: robot time to wall time, in the simulator; a real robot knows one speed only.
    """

    def __init__(self) -> None:
        self.stop_requested = False
        self.pause_requested = False
        self.breakpoints: frozenset[str] = frozenset()
        self.step: StepMode | None = None
        self.hold_at: tuple[int, PauseCause] | None = None
        self.looks: frozenset[str] = frozenset()
        self.speed = 1.0

    @property
    def pace(self) -> float:
        """`speed`, but nobody waits in slow motion for a robot that is to stop."""
        return max(self.speed, 1.0) if self.stop_requested else self.speed

    def stop(self) -> None:
        self.stop_requested = True

    def pause(self) -> None:
        self.pause_requested = True

    def resume(self) -> None:
        self.step = None
        self.pause_requested = False

    def step_on(self, mode: StepMode) -> None:
        """Goes on to the next block: into functions, over them, or out of the one that runs."""
        self.step = mode
        self.pause_requested = False

    def set_speed(self, speed: float) -> None:
        """Slow motion or fast forward, from a tenth to ten times; what is beyond is brought to the nearest."""
        self.speed = min(max(speed, LEAST_SPEED), GREATEST_SPEED)
