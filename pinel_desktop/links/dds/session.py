"""This PC's part in a DDS domain: its configuration, its readers and writers as ROS expects them."""

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

# What ROS puts before the name of a topic.
TOPIC_PREFIX = "rt/"
# Participants that a PC may have: their ports are tried at each peer's address.
_MAX_PARTICIPANTS = 60
_DISCOVERY_PORT = 7400  # of domain 0; any port tells the way to a peer

# A process may have a domain only once; on the network these are all the domain of their record.
_own_numbers = itertools.count(1000)

_XCDR1 = Policy.DataRepresentation(use_cdrv0_representation=True, use_xcdrv2_representation=False)
# A robot with a ring of sonars tells all of them at once on one topic.
_SONARS = 32
# Of a velocity that is older than this, a robot that comes late must not hear.
_FRESH = duration(milliseconds=300)
_TRANSIENT_LOCAL = (Policy.Durability.TransientLocal, Policy.Lifespan(_FRESH))
_E = TypeVar("_E", bound=Entity)


class Session:
    """One participant in a domain; made connected, closed once.

    Args:
        peers: numeric addresses of the robot; then nothing is sent to others, and no multicast.

    Raises:
        PinelError: `network_missing` where this PC has no network that DDS can use.
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
        """A writer that no peer can hold up.

        Args:
            is_transient_local: readers that ask for the last message hear it, too; a late one gets it while fresh.
        """
        reliable = Policy.Reliability.Reliable(duration(milliseconds=10))
        qos = _endpoint_qos(message, reliable, *(_TRANSIENT_LOCAL if is_transient_local else ()))
        return self._register(DataWriter(self.participant, self._topic(topic, message), qos=qos))

    def reader(self, topic: str, message: type[IdlStruct]) -> "DataReader[Any]":
        """A reader of the newest message; it matches reliable and other writers."""
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
    """Ends an entity now: the library itself only does it when nothing refers to it. Safe to call twice."""
    entity.__del__()


def own_user_data() -> bytes:
    """What other PCs read about this participant: the context of ROS, this PC's name, process and machine."""
    return f"enclave=/;pinel={platform.node() or 'PC'}/{os.getpid()}/{this_machine()};".encode()


def this_machine() -> str:
    """Tells PCs apart that share their name, as those that were set up from one image do."""
    return f"{uuid.getnode():x}"


def configuration(domain: int, peers: Sequence[str]) -> str:
    """Cyclone DDS's configuration for a domain; environment variables play no part."""
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
    """This PC's own address on the way to a peer; empty if there is no way. Sends nothing."""
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
    """Which `Range` a robot publishes: robots that tell no type hash are older than the variance in it."""
    return Range if TYPE_HASHES[Range] in user_data else RangeBeforeIron
