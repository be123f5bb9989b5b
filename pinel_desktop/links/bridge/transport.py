"""The bridge as the transport of a real robot."""

import time
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.links.bridge.callers import Callers
from pinel_desktop.links.bridge.exchange import Exchange
from pinel_desktop.links.bridge.listener import Listener
from pinel_desktop.links.bridge.routes import Routes
from pinel_desktop.links.bridge.standing import StandingBridge, standing_bridge
from pinel_desktop.links.real import RealLink, real_link
from pinel_desktop.links.transport import Cancelled, Receiver
from pinel_desktop.robot import Sensors, Setting, Twist2D
from pinel_desktop.robot.record import BridgeRecord, RobotRecord

_POLL_S = 0.05
# For the client to hear the end: it asks 30 times a second, some while they draw three times only.
_FAREWELL_S = 1.0


class BridgeTransport:
    """Listens while it is open, or uses the bridge that stands at its address.

    The client comes to PINEL, so opening waits for it, as long as the record says.

    Attributes:
        port: where it listens; that of the record unless that is 0, which chooses a free one.
    """

    def __init__(self, record: BridgeRecord) -> None:
        self.sensors = Sensors()
        self.port = record.port
        self._record = record
        self._exchange: Exchange | None = None
        self._listener: Listener | None = None
        self._standing: StandingBridge | None = None
        self._answering: Exchange | None = None

    def open(self, receiver: Receiver, cancelled: Cancelled) -> None:
        record = self._record
        self._exchange = exchange = Exchange(receiver)
        self._answer(exchange)
        due_s = time.monotonic() + record.wait_s
        while not exchange.asked.wait(_POLL_S) and not cancelled():
            if time.monotonic() > due_s:
                raise PinelError("bridge_no_client", host=record.url_host, port=self.port)

    def listen(self, receiver: Receiver, cancelled: Cancelled) -> None:
        """Takes poses and hands out zeros; a client that comes later is heard, too."""
        self._answer(Exchange(receiver))

    def _answer(self, exchange: Exchange) -> None:
        """Answers clients from now on."""
        self._answering, self._standing = exchange, standing_bridge(self._record)
        if self._standing is not None:
            self._standing.attach(exchange)
            return
        routes = Routes(exchange, Callers(self._record))
        self._listener = Listener(self._record.host, self._record.port, routes.answer)
        self.port = self._listener.port
        self._listener.start()

    def send(self, twist: Twist2D) -> None:
        if self._exchange is not None:
            self._exchange.set_velocity(twist)

    def bumper(self) -> bool:
        return False

    def close(self) -> None:
        if self._exchange is not None and (self._listener or self._standing):
            self._exchange.finish(_FAREWELL_S)
        if self._listener is not None:
            self._listener.close()
        if self._standing is not None and self._answering is not None:
            self._standing.detach(self._answering)


def bridge_link(*, world: Any, setting: Setting, seed: int, robot: RobotRecord | None) -> RealLink:
    """A link that waits for the client of the bridge. Raises PinelError `robot_not_set_up`."""
    return real_link(BridgeTransport, setting, robot)
