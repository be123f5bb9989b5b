"""The app's side of the engine: owns its process, sends messages, hands on its events."""

from collections.abc import Callable
from typing import Any, Literal

EngineState = Literal["starting", "ready", "lost"]
EventSink = Callable[[dict[str, Any]], None]


class EngineClient:
    """Starts the engine process and keeps one running; thread-safe.

    `on_event` is called on the reader thread with every event object of ARCHITECTURE.md, in order. When the
    process dies during a run, the client makes up the missing `run_ended` (failed, `engine_lost`).
    """

    def __init__(self, on_event: EventSink) -> None:
        self._on_event = on_event

    @property
    def state(self) -> EngineState:
        """`starting` until the process has said it is ready; `lost` when it cannot be started again."""
        raise NotImplementedError

    @property
    def live_run(self) -> str | None:
        """Id of the run that has begun and not ended."""
        raise NotImplementedError

    def start(self) -> None:
        """Starts the process; returns at once, the state tells when it is ready."""
        raise NotImplementedError

    def run(self, run_id: str, document: dict[str, Any], *, world: str, seed: int = 0, link: str = "sim") -> None:
        """Begins a live run. Raises PinelError `run_in_progress` or `engine_not_ready`."""
        raise NotImplementedError

    def pause(self, run_id: str) -> None:
        """Raises PinelError `run_not_live` when that run is not the live one; so do the three below."""
        raise NotImplementedError

    def resume(self, run_id: str) -> None:
        raise NotImplementedError

    def stop(self, run_id: str) -> None:
        raise NotImplementedError

    def answer_capture(self, run_id: str, result: str) -> None:
        raise NotImplementedError

    def close(self) -> None:
        """Ends the pipe (the engine sends zeros and exits) and waits for the process."""
        raise NotImplementedError
