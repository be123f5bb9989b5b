"""The app's client of the process of the clouds: starts it before it is needed, sends requests, publishes rows."""

from collections.abc import Callable, Sequence
from typing import Any

from pinel_desktop.cloud.messages import N_ROBOTS, STOP, CloudRequest
from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import CloudProgress
from pinel_desktop.messages import describe
from pinel_desktop.processes import own_command
from pinel_desktop.processes.messages import Message
from pinel_desktop.processes.supervisor import Supervisor

_START_S = 60.0  # long, because the start of the app may keep the PC busy
IDLE_END_S = 300.0


class CloudClient:
    """Client of the process; thread-safe. One cloud at a time: a new one ends the one before.

    Args:
        publish: sends an event to the page.
        command: command line that starts the process.
        idle_end_s: time after the last request until the process ends.
    """

    def __init__(
        self,
        publish: Callable[[dict[str, Any]], None],
        language: Callable[[], str],
        command: Sequence[str] | None = None,
        idle_end_s: float = IDLE_END_S,
    ) -> None:
        self._publish, self._language = publish, language
        self._cloud: str | None = None
        self._process = Supervisor(
            "cloud",
            command or own_command("cloud"),
            "cloud_lost",
            on_message=self._receive,
            on_death=self._died,
            idle_end_s=idle_end_s,
        )

    @property
    def pid(self) -> int | None:
        """Id of the process; None while it does not run."""
        return self._process.pid

    def prepare(self) -> None:
        """Starts the process, or restarts a lost one, so that it is warm at the next request; returns at once."""
        self._process.start()

    def begin(self, request: CloudRequest) -> None:
        """Starts a cloud; its rows are published as they come.

        Raises:
            PinelError: `cloud_lost` if the process does not start.
        """
        self._process.start()
        if not self._process.wait_until_ready(_START_S):
            raise PinelError("cloud_lost")
        earlier, self._cloud = self._cloud, request.cloud
        if earlier is not None and earlier != request.cloud:
            self._publish_end(earlier, "cloud_replaced")
        if not self._process.send(request.as_message()):
            raise PinelError("cloud_lost")

    def stop(self, cloud: str) -> None:
        """Ends a cloud; nothing happens if it is over."""
        if cloud == self._cloud:
            self._process.mark_used()
            self._process.send({"type": STOP})

    def close(self) -> None:
        """Ends the process."""
        self._cloud = None
        self._process.close()

    def _receive(self, message: Message) -> None:
        self._process.mark_used()
        cloud, end = message.get("cloud"), message.get("end")
        if cloud is None or cloud != self._cloud:
            return  # of an older cloud
        if end is not None:
            self._cloud = None
        text = end["text"] if end else ""
        if message.get("error"):
            text = self._text("cloud_lost")
        self._publish(
            CloudProgress(
                cloud=cloud,
                n=N_ROBOTS,
                rows=message["rows"],
                is_over=end is not None,
                good=end["good"] if end else [],
                text=text,
                block=end["block"] if end else None,
            ).to_wire()
        )

    def _died(self) -> None:
        cloud, self._cloud = self._cloud, None
        if cloud is not None:
            self._publish_end(cloud, "cloud_lost")

    def _publish_end(self, cloud: str, code: str) -> None:
        """Publishes the end of a cloud whose robots have not all arrived."""
        progress = CloudProgress(cloud, N_ROBOTS, [], True, [], self._text(code), None)
        self._publish(progress.to_wire())

    def _text(self, code: str) -> str:
        text = describe(code, {}, self._language())
        return f"{text.message} {text.remedy}"
