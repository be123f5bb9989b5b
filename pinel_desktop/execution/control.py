"""Pause, resume and stop, asked for by another thread and answered at the next tick."""


class RunControl:
    """The wishes of whoever watches a run; each is a plain flag, read once a tick.

    Stop wins over everything, also over a pause.
    """

    def __init__(self) -> None:
        self.stop_requested = False
        self.pause_requested = False

    def stop(self) -> None:
        self.stop_requested = True

    def pause(self) -> None:
        self.pause_requested = True

    def resume(self) -> None:
        self.pause_requested = False
