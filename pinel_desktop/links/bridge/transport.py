"""The HTTP bridge as the transport of a real robot."""

import time
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.links.bridge.bridge_session import BridgeSession
from pinel_desktop.links.bridge.http_server import BridgeHttpServer
from pinel_desktop.links.bridge.persistent_bridge import PersistentBridge, find_persistent_bridge
from pinel_desktop.links.bridge.request_guard import RequestGuard
from pinel_desktop.links.bridge.routes import Routes
from pinel_desktop.links.real import RealLink, real_link
from pinel_desktop.links.transport import Cancelled, Receiver
from pinel_desktop.robot import Sensors, SimulationConfig, Twist2D
from pinel_desktop.robot.robot_profile import BridgeProfile, RobotProfile

_POLL_S = 0.05
# Time in which the client receives the last zeros and the end. A client polls 30 times a second,
# some only three times while they draw.
_FAREWELL_S = 1.0


class BridgeTransport:
    """Listens while it is open, or uses the persistent bridge at its address.

    The client connects to PINEL. Therefore `open` waits for its first request, at most `wait_s` of the profile.

    Attributes:
        port: port on which it listens; a free one if the profile's port is 0.
    """

    def __init__(self, profile: BridgeProfile) -> None:
        self.sensors = Sensors()
        self.port = profile.port
        self._profile = profile
        self._session: BridgeSession | None = None
        self._server: BridgeHttpServer | None = None
        self._persistent_bridge: PersistentBridge | None = None
        self._active_session: BridgeSession | None = None

    def open(self, receiver: Receiver, cancelled: Cancelled) -> None:
        profile = self._profile
        self._session = session = BridgeSession(receiver)
        self._serve(session)
        due_s = time.monotonic() + profile.wait_s
        while not session.asked.wait(_POLL_S) and not cancelled():
            if time.monotonic() > due_s:
                raise PinelError("bridge_no_client", host=profile.url_host, port=self.port)

    def listen(self, receiver: Receiver, cancelled: Cancelled) -> None:
        """Receives poses and sends zeros; does not wait for the client."""
        self._serve(BridgeSession(receiver))

    def _serve(self, session: BridgeSession) -> None:
        """Starts to respond to clients with this session."""
        self._active_session, self._persistent_bridge = (
            session,
            find_persistent_bridge(self._profile),
        )
        if self._persistent_bridge is not None:
            self._persistent_bridge.attach(session)
            return
        routes = Routes(session, RequestGuard(self._profile))
        self._server = BridgeHttpServer(self._profile.host, self._profile.port, routes.respond)
        self.port = self._server.port
        self._server.start()

    def send(self, twist: Twist2D) -> None:
        if self._session is not None:
            self._session.set_velocity(twist)

    def bumper(self) -> bool:
        return False

    def close(self) -> None:
        if self._session is not None and (self._server or self._persistent_bridge):
            self._session.finish(_FAREWELL_S)
        if self._server is not None:
            self._server.close()
        if self._persistent_bridge is not None and self._active_session is not None:
            self._persistent_bridge.detach(self._active_session)


def bridge_link(
    *, world: Any, setting: SimulationConfig, seed: int, robot: RobotProfile | None
) -> RealLink:
    """Returns a link that waits for the client of the bridge.

    Raises PinelError `robot_not_set_up` without a profile.
    """
    return real_link(BridgeTransport, setting, robot)
