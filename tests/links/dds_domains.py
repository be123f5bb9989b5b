"""A DDS domain of its own for each test, which nobody else on this PC uses and which leaves it by no network."""

import contextlib
import random
import socket
from collections.abc import Iterator

from pinel_desktop.robot.robot_profile import DdsProfile, Room

ROOM = Room(width_m=20.0, depth_m=20.0)
# Domains whose ports no other program is given by chance, and a port for each that says that it is taken. Tests with a
# fixed domain use 100 and 101.
_DOMAINS = range(1, 100)
_MARKER_PORT = 21300


@contextlib.contextmanager
def own_domain() -> Iterator[int]:
    """A free domain, kept from other tests and other PINELs while the context lasts."""
    for domain in random.sample(_DOMAINS, len(_DOMAINS)):
        with contextlib.ExitStack() as stack:
            marker = stack.enter_context(socket.socket())
            try:
                marker.bind(("127.0.0.1", _MARKER_PORT + domain))
            except OSError:
                continue
            yield domain
            return
    raise RuntimeError("no free DDS domain")


def local_profile(domain: int, **fields: object) -> DdsProfile:
    """A robot on this PC, as fast as a Pioneer, in a room of 20 m."""
    values = {"max_v_mps": 1.2, "max_omega_dps": 300.0, "room": ROOM, "peers": ("127.0.0.1",)}
    return DdsProfile.model_validate({"domain": domain, **values, **fields})
