"""One file per backend that can drive a robot; `open_link()` opens one by name, importing it only then."""

import importlib
from typing import cast

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import PIONEER_3DX, RobotLink, RobotModel

_BACKENDS = {"sim": ("pinel_desktop.links.sim", "SimLink")}
LINK_NAMES = tuple(_BACKENDS)


def open_link(name: str, *, world: str, robot: RobotModel = PIONEER_3DX) -> RobotLink:
    """A link of the backend `name`, not yet connected.

    Raises PinelError `unknown_link`, and what the backend itself has to say (`unknown_world`).
    """
    if name not in _BACKENDS:
        raise PinelError("unknown_link", value=name, allowed=list(LINK_NAMES))
    module, class_name = _BACKENDS[name]
    backend = getattr(importlib.import_module(module), class_name)
    return cast(RobotLink, backend(world=world, robot=robot))
