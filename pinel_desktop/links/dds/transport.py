"""DDS transport: carries velocities to a ROS 2 robot and its messages back."""

import math
import socket
import threading
import time
from collections.abc import Callable
from typing import Any

from cyclonedds.idl import IdlStruct
from cyclonedds.pub import DataWriter

from pinel_desktop.errors import PinelError
from pinel_desktop.links.dds import messages
from pinel_desktop.links.dds.command_claim import CommandClaim
from pinel_desktop.links.dds.endpoint_search import EndpointSearch
from pinel_desktop.links.dds.graph import Graph
from pinel_desktop.links.dds.messages import Twist, TwistStamped, type_name
from pinel_desktop.links.dds.robot_subscriber import RobotSubscriber
from pinel_desktop.links.dds.session import Session, range_type
from pinel_desktop.links.real import RealLink, real_link
from pinel_desktop.links.ros2.node.drivers import FINAL_ZEROS_S, LOST_TIMEOUT_S, UNMATCHED_TIMEOUT_S
from pinel_desktop.links.ros_sensors import RosSensors
from pinel_desktop.links.transport import Cancelled, Receiver
from pinel_desktop.robot import STANDSTILL, RobotModel, Sensors, SimulationConfig, Twist2D
from pinel_desktop.robot.robot_profile import DdsProfile, RobotProfile

_SEARCH_TIMEOUT_S = 5.0
_MATCH_TIMEOUT_S = 5.0
_POLL_S = 0.05
_Kinds = dict[str, tuple[type[IdlStruct], ...]]


class DdsTransport:
    """The connection with one robot in a DDS domain."""

    def __init__(self, profile: DdsProfile, robot: RobotModel) -> None:
        self._profile = profile
        self._command_topic = profile.name_of(profile.command_topic)
        self._odometry_topic = profile.name_of(profile.odometry_topic)
        self._sensors = RosSensors(robot)
        self.sensors: Sensors = self._sensors
        self._session: Session | None = None
        self._writer: DataWriter[Any] | None = None
        self._message: Callable[[Twist2D], IdlStruct] = _plain
        self._subscriber: RobotSubscriber | None = None
        self._claim: CommandClaim | None = None
        self._is_open = False
        self._unmatched_since_s: float | None = None

    def open(self, receiver: Receiver, cancelled: Cancelled) -> None:
        found = self._search(cancelled)
        if found is None:
            return
        session, graph, search = found
        self._claim = claim = CommandClaim(graph, self._command_topic, self._odometry_topic)
        if not _wait(claim.is_free, cancelled, _SEARCH_TIMEOUT_S):
            if cancelled():
                return
            raise claim.problem()

        def watch() -> None:
            claim.require_alone()
            self._require_subscriber()

        self._subscriber = subscriber = self._receive(session, graph, search, receiver, watch)
        assert search.command_type is not None
        self._message = subscriber.stamped if search.command_type is TwistStamped else _plain
        # Transient-local only if the robot requires it: others must not receive an old velocity
        # again.
        asks_for_last = any(
            listener.is_transient_local for listener in graph.subscribers(self._command_topic)
        )
        self._writer = session.writer(
            self._command_topic, search.command_type, is_transient_local=asks_for_last
        )
        claim.announce()
        _wait(claim.check_claim, cancelled, math.inf)
        subscriber.start()
        if not _wait(self._is_matched, cancelled, _MATCH_TIMEOUT_S) and not cancelled():
            raise self._unmatched_problem()
        self._is_open = True

    def listen(self, receiver: Receiver, cancelled: Cancelled) -> None:
        found = self._search(cancelled)
        if found is None:
            return
        session, graph, search = found
        claim = CommandClaim(graph, self._command_topic, self._odometry_topic)

        def watch() -> None:
            holder = claim.holder()
            receiver.on_holder(holder.name if holder else None)

        self._subscriber = self._receive(session, graph, search, receiver, watch)
        self._subscriber.start()

    def _search(self, cancelled: Cancelled) -> tuple[Session, Graph, EndpointSearch] | None:
        """Searches the robot; returns None if the search was cancelled."""
        peers = addresses(self._profile.peers, cancelled)
        if cancelled():
            return None
        self._session = session = Session(self._profile.domain, peers)
        graph = Graph(session)
        search = EndpointSearch(graph, self._profile)
        if _wait(search.is_complete, cancelled, _SEARCH_TIMEOUT_S):
            return session, graph, search
        if cancelled():
            return None
        raise search.problem()

    def send(self, twist: Twist2D) -> None:
        if self._writer is None:
            return
        is_disputed = self._claim is not None and self._claim.is_disputed
        self._writer.write(self._message(STANDSTILL if is_disputed else twist))

    def bumper(self) -> bool:
        return self._sensors.touches()

    def close(self) -> None:
        self._send_last_zeros()
        if self._subscriber is not None:
            self._subscriber.close()
        if self._session is not None:
            self._session.close()

    def _send_last_zeros(self) -> None:
        """If the robot's odometry has stopped, sends zeros for up to `FINAL_ZEROS_S`, in case the robot returns."""
        due_s = time.monotonic() + FINAL_ZEROS_S
        while self._is_lost() and time.monotonic() < due_s:
            self.send(STANDSTILL)
            time.sleep(_POLL_S)

    def _is_lost(self) -> bool:
        last_pose_s = self._subscriber.last_pose_s if self._subscriber is not None else None
        return (
            self._is_open
            and last_pose_s is not None
            and time.monotonic() - last_pose_s > LOST_TIMEOUT_S
        )

    def _receive(
        self,
        session: Session,
        graph: Graph,
        search: EndpointSearch,
        receiver: Receiver,
        watch: Callable[[], None],
    ) -> RobotSubscriber:
        """Returns a subscriber, not yet started, to the odometry and to all sensors, also to later ones."""
        found = _Topics(graph, _sensor_topics(self._profile))
        localisation = _Topics(graph, _localisation_topics(self._profile))

        def poll() -> None:
            for topic, message in localisation.newly_published():
                subscriber.follow_localisation(topic, message)
            for topic, message in found.newly_published():
                subscriber.subscribe(topic, message)
            for message in found.unpublished():
                subscriber.withdraw(message)
            watch()

        assert search.odometry_type is not None
        subscriber = RobotSubscriber(session, receiver, self._sensors, poll)
        subscriber.subscribe(self._odometry_topic, search.odometry_type)
        return subscriber

    def _is_matched(self) -> bool:
        """Sends zeros and returns whether the robot is matched; messages before the matching are lost."""
        self.send(STANDSTILL)
        return self._has_subscriber()

    def _has_subscriber(self) -> bool:
        return bool(self._writer and self._writer.get_matched_subscriptions())

    def _require_subscriber(self) -> None:
        """Raises PinelError `robot_deaf` if the command topic has had no subscriber for `UNMATCHED_TIMEOUT_S`."""
        if not self._is_open or self._has_subscriber():
            self._unmatched_since_s = None
            return
        now_s = time.monotonic()
        self._unmatched_since_s = self._unmatched_since_s or now_s
        if now_s - self._unmatched_since_s > UNMATCHED_TIMEOUT_S:
            raise self._unmatched_problem()

    def _unmatched_problem(self) -> PinelError:
        return PinelError("robot_deaf", topic=f"/{self._command_topic}")


def _sensor_topics(profile: DdsProfile) -> _Kinds:
    scan, sonar = (messages.LaserScan,), (messages.Range, messages.PointCloud)
    rows = (
        (profile.scan_topic, scan),
        (profile.sonar_topic, sonar),
        (profile.bumper_topic, (messages.Bool,)),
        (profile.battery_topic, (messages.BatteryState,)),
    )
    return {profile.name_of(topic): kinds for topic, kinds in rows if topic}


def _localisation_topics(profile: DdsProfile) -> _Kinds:
    topic = profile.localisation_topic
    kinds = (messages.PoseWithCovarianceStamped, messages.PoseStamped)
    return {profile.name_of(topic): kinds} if topic else {}


class _Topics:
    """Topics with the types that each may have; finds each topic once the robot publishes it."""

    def __init__(self, graph: Graph, kinds: _Kinds) -> None:
        self._graph = graph
        self._unfound = dict(kinds)
        self._types: dict[str, type[IdlStruct]] = {}

    def newly_published(self) -> list[tuple[str, type[IdlStruct]]]:
        """Returns the topics and types that were found since the last call."""
        found: list[tuple[str, type[IdlStruct]]] = []
        for topic, kinds in tuple(self._unfound.items()):
            for publisher in self._graph.publishers(topic):
                kind = next(
                    (kind for kind in kinds if type_name(kind) == publisher.type_name), None
                )
                if kind is not None:
                    is_range = kind is messages.Range
                    found.append((topic, range_type(publisher.user_data) if is_range else kind))
                    del self._unfound[topic]
                    break
        self._types.update(found)
        return found

    def unpublished(self) -> list[type[IdlStruct]]:
        """Returns the types of found topics that have no publisher now."""
        return [kind for topic, kind in self._types.items() if not self._graph.publishers(topic)]


def _plain(twist: Twist2D) -> Twist:
    return Twist(messages.Vector3(x=twist.v_mps), messages.Vector3(z=twist.omega_radps))


def _wait(condition: Callable[[], bool], cancelled: Cancelled, seconds: float) -> bool:
    """Waits and returns whether `condition` became true in time, without a cancellation."""
    due_s = time.monotonic() + seconds
    while not cancelled():
        if condition():
            return True
        if time.monotonic() > due_s:
            return False
        time.sleep(_POLL_S)
    return False


def addresses(peers: tuple[str, ...], cancelled: Cancelled) -> list[str]:
    """Returns the numeric addresses of peers; waits at most 5 s for a name server.

    Raises PinelError `peer_unknown`.
    """
    found: dict[str, str] = {}

    def resolve() -> None:
        for peer in peers:
            try:
                found[peer] = str(socket.getaddrinfo(peer, None, type=socket.SOCK_DGRAM)[0][4][0])
            except OSError:
                return

    thread = threading.Thread(target=resolve, name="robot-peers", daemon=True)
    thread.start()
    _wait(lambda: not thread.is_alive(), cancelled, _SEARCH_TIMEOUT_S)
    unknown = next((peer for peer in peers if peer not in found), None)
    if unknown is not None and not cancelled():
        raise PinelError("peer_unknown", peer=unknown)
    return list(found.values())


def dds_link(
    *, world: Any, setting: SimulationConfig, seed: int, robot: RobotProfile | None = None
) -> RealLink:
    """Returns the link to a ROS 2 robot over DDS. Raises PinelError `robot_not_set_up` without a profile."""
    del world, seed
    return real_link(lambda profile: DdsTransport(profile, setting.robot), setting, robot)
