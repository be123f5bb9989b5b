"""A DDS participant of this PC: its configuration, and readers and writers with the QoS that ROS expects."""

import itertools
import os
import platform
import socket
import uuid
from collections.abc import Sequence
from typing import Any, TypeVar
from xml.sax.saxutils import quoteattr

from cyclonedds.core import DDSException, Entity, Policy, Qos
from cyclonedds.domain import Domain, DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

from pinel_desktop.errors import PinelError
from pinel_desktop.links.dds.messages import TYPE_HASHES, Range, RangeBeforeIron

# ROS's prefix of topic names in DDS.
TOPIC_PREFIX = "rt/"
# Maximum number of participants per PC. Discovery tries the ports of all of them at each peer.
_MAX_PARTICIPANTS = 60
_DISCOVERY_PORT = 7400  # of domain 0; the route to a peer is the same for any port

# Cyclone DDS allows a domain number only once per process. Each session therefore has an internal
# number; on the network it uses the domain of its profile (`ExternalDomainId`).
_own_numbers = itertools.count(1000)

_XCDR1 = Policy.DataRepresentation(use_cdrv0_representation=True, use_xcdrv2_representation=False)
# A robot with a ring of sonars publishes all of their readings at once on one topic.
_SONARS = 32
# A robot that connects late must not receive a velocity older than this.
_FRESH = duration(milliseconds=300)
_TRANSIENT_LOCAL = (Policy.Durability.TransientLocal, Policy.Lifespan(_FRESH))
_E = TypeVar("_E", bound=Entity)


class Session:
    """One participant in a DDS domain. The constructor connects it.

    Args:
        peers: numeric addresses of the robot. If given, the session sends to these addresses only, without multicast.

    Raises:
        PinelError: `network_missing` if this PC has no network that DDS can use.
    """

    def __init__(self, domain: int, peers: Sequence[str] = ()) -> None:
        number = next(_own_numbers)
        self._made: list[Entity] = []
        try:
            self._made.append(Domain(number, configuration(domain, peers)))
            self.participant = DomainParticipant(number, qos=Qos(Policy.Userdata(own_user_data())))
        except DDSException as error:
            self.close()
            raise PinelError("network_missing", detail=str(error)) from error
        self._made.append(self.participant)

    def writer(
        self, topic: str, message: type[IdlStruct], *, is_transient_local: bool = False
    ) -> "DataWriter[Any]":
        """Returns a writer that no peer can block for more than 10 ms.

        Args:
            is_transient_local: whether the writer matches transient-local readers. A reader that connects late then
                receives the last message, unless the message has expired.
        """
        reliable = Policy.Reliability.Reliable(duration(milliseconds=10))
        qos = _endpoint_qos(message, reliable, *(_TRANSIENT_LOCAL if is_transient_local else ()))
        return self._register(DataWriter(self.participant, self._topic(topic, message), qos=qos))

    def reader(self, topic: str, message: type[IdlStruct]) -> "DataReader[Any]":
        """Returns a reader of the newest message; it matches reliable and best-effort writers."""
        depth = _SONARS if message in {Range, RangeBeforeIron} else 1
        qos = _endpoint_qos(message, Policy.Reliability.BestEffort, depth=depth)
        return self._register(DataReader(self.participant, self._topic(topic, message), qos=qos))

    def close(self) -> None:
        """Leaves the domain; safe to call twice."""
        for entity in reversed(self._made):
            delete(entity)
        self._made.clear()

    def _topic(self, topic: str, message: type[IdlStruct]) -> "Topic[Any]":
        return self._register(Topic(self.participant, TOPIC_PREFIX + topic, message))

    def _register(self, entity: _E) -> _E:
        self._made.append(entity)
        return entity


def delete(entity: Entity) -> None:
    """Deletes an entity now; safe to call twice.

    Without this call, the library deletes an entity only once nothing refers to it.
    """
    entity.__del__()


def own_user_data() -> bytes:
    """Returns the USER_DATA of this participant: ROS enclave, this PC's name, process id and machine id."""
    return f"enclave=/;pinel={platform.node() or 'PC'}/{os.getpid()}/{this_machine()};".encode()


def this_machine() -> str:
    """Returns an id of this PC, because PCs set up from one disk image share their name."""
    return f"{uuid.getnode():x}"


def configuration(domain: int, peers: Sequence[str]) -> str:
    """Returns the configuration of Cyclone DDS for a domain; environment variables have no effect on it."""
    here = _address_towards(peers[0]) if peers else ""
    interface = f"<Interfaces><NetworkInterface address={quoteattr(here)}/></Interfaces>"
    addresses = "".join(f"<Peer address={quoteattr(peer)}/>" for peer in peers)
    general = f"<AllowMulticast>false</AllowMulticast>{interface if here else ''}" if peers else ""
    unicast = (
        f"<Peers>{addresses}</Peers><SPDPInterval>1 s</SPDPInterval>"
        "<ParticipantIndex>auto</ParticipantIndex>"
        f"<MaxAutoParticipantIndex>{_MAX_PARTICIPANTS}</MaxAutoParticipantIndex>"
    )
    return (
        f"<CycloneDDS><Domain><General>{general}</General><Discovery>"
        f"<ExternalDomainId>{domain}</ExternalDomainId>{unicast if peers else ''}"
        "</Discovery></Domain></CycloneDDS>"
    )


def _address_towards(peer: str) -> str:
    """Returns this PC's own address on the route to a peer; sends nothing.

    Raises PinelError `network_missing` without a route.
    """
    family = socket.AF_INET6 if ":" in peer else socket.AF_INET
    try:
        with socket.socket(family, socket.SOCK_DGRAM) as probe:
            probe.connect((peer, _DISCOVERY_PORT))
            return str(probe.getsockname()[0])
    except OSError as error:
        raise PinelError("network_missing", detail=str(error)) from error


def _endpoint_qos(message: type[IdlStruct], *policies: Any, depth: int = 1) -> Qos:
    type_hash = TYPE_HASHES.get(message)
    user_data = [Policy.Userdata(f"typehash={type_hash};".encode())] if type_hash else []
    return Qos(*policies, Policy.History.KeepLast(depth), _XCDR1, *user_data)


def range_type(user_data: str) -> type[IdlStruct]:
    """Returns the `Range` type that a robot publishes.

    Releases of ROS without type hashes also lack the field `variance`.
    """
    return Range if TYPE_HASHES[Range] in user_data else RangeBeforeIron
