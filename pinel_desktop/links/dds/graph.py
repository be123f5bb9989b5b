"""Publishers and subscribers in a DDS domain (the ROS graph), read from DDS's built-in topics."""

import re
import uuid
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import psutil
from cyclonedds.builtin import (
    BuiltinDataReader,
    BuiltinTopic,
    BuiltinTopicDcpsParticipant,
    BuiltinTopicDcpsPublication,
    BuiltinTopicDcpsSubscription,
)
from cyclonedds.core import InstanceState, Policy, Qos
from cyclonedds.domain import DomainParticipant

from pinel_desktop.links.dds.session import TOPIC_PREFIX, Session, this_machine

_MAX_SAMPLES = 200
_PINEL = re.compile(r"pinel=([^;/]*)/(\d+)/([0-9a-f]+);")


@dataclass(frozen=True, slots=True)
class Endpoint:
    """A publisher or subscriber of a ROS topic.

    Attributes:
        topic: full name, without the leading slash.
        type_name: name of the message type on the network.
        participant: id of the participant to which the endpoint belongs.
        user_data: USER_DATA of the endpoint, such as a type hash.
        is_transient_local: whether its durability is transient-local; such a subscriber matches only transient-local
            publishers.
    """

    topic: str
    type_name: str
    participant: uuid.UUID
    user_data: str
    is_transient_local: bool = False


@dataclass(frozen=True, slots=True)
class Participant:
    """A program in the domain.

    Attributes:
        name: name of its PC if known, else its identifier.
        is_pinel: whether the program is a PINEL.
        has_exited: whether it is a PINEL of this PC whose process has ended; DDS detects that only after 10 s.
    """

    name: str
    is_pinel: bool
    has_exited: bool


class Graph:
    """The endpoints in a session's domain, except the session's own. Not thread-safe."""

    def __init__(self, session: Session) -> None:
        participant = session.participant
        self._own: uuid.UUID = participant.get_guid()
        self._participants = _CurrentInstances(participant, BuiltinTopicDcpsParticipant)
        self._publications = _CurrentInstances(participant, BuiltinTopicDcpsPublication)
        self._subscriptions = _CurrentInstances(participant, BuiltinTopicDcpsSubscription)

    def publishers(self, topic: str = "") -> list[Endpoint]:
        """Returns the publishers of `topic`; without one, the publishers of all ROS topics."""
        return list(self._endpoints(self._publications, topic))

    def subscribers(self, topic: str = "") -> list[Endpoint]:
        """Returns the subscribers of `topic`; without one, the subscribers of all ROS topics."""
        return list(self._endpoints(self._subscriptions, topic))

    def participant(self, key: uuid.UUID) -> Participant:
        """Returns the participant with that id."""
        found = self._participants.snapshot().get(key)
        qos = found.qos if found is not None else Qos()
        pinel = _PINEL.search(_user_data(qos))
        if pinel is None:
            return Participant(_host(qos) or str(key), is_pinel=False, has_exited=False)
        host, pid, machine = pinel.groups()
        has_exited = machine == this_machine() and not psutil.pid_exists(int(pid))
        return Participant(host, is_pinel=True, has_exited=has_exited)

    def _endpoints(self, instances: "_CurrentInstances", topic: str) -> Iterator[Endpoint]:
        for found in instances.snapshot().values():
            name = found.topic_name
            if found.participant_key == self._own or not name.startswith(TOPIC_PREFIX):
                continue
            name = name.removeprefix(TOPIC_PREFIX)
            if topic in {"", name}:
                who, user_data = found.participant_key, _user_data(found.qos)
                yield Endpoint(
                    name, found.type_name, who, user_data, _is_transient_local(found.qos)
                )


class _CurrentInstances:
    """The instances of a built-in topic in state `Alive`, by key."""

    def __init__(self, participant: DomainParticipant, topic: BuiltinTopic) -> None:
        self._reader = BuiltinDataReader(participant, topic)
        self._samples: dict[uuid.UUID, Any] = {}

    def snapshot(self) -> dict[uuid.UUID, Any]:
        for sample in self._reader.take(_MAX_SAMPLES):
            if sample.sample_info.instance_state == InstanceState.Alive:
                self._samples[sample.key] = sample
            else:
                self._samples.pop(sample.key, None)
        return self._samples


def _user_data(qos: Qos) -> str:
    user_data = qos[Policy.Userdata] if Policy.Userdata in qos else None  # noqa: SIM401 - no dictionary
    return user_data.data.decode("utf-8", "replace") if user_data else ""


def _is_transient_local(qos: Qos) -> bool:
    return Policy.Durability.TransientLocal in qos


def _host(qos: Qos) -> str:
    """Returns the name of the participant's PC, which only Cyclone DDS publishes; else ""."""
    properties = {policy.key: policy.value for policy in qos if isinstance(policy, Policy.Property)}
    return str(properties.get("__Hostname", ""))
