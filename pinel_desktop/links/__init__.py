"""One file per backend that can drive a robot; `open_link()` opens one by name, importing it only then."""

import importlib
from typing import Any, cast

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import RobotLink, Setting

_BACKENDS = {"sim": ("pinel_desktop.links.sim", "SimLink")}
LINK_NAMES = tuple(_BACKENDS)
_AS_IT_COMES = Setting()


def open_link(
    name: str,
    *,
    world: str | dict[str, Any],
    setting: Setting = _AS_IT_COMES,
    seed: int = 0,
    address: str | None = None,
) -> RobotLink:
    """A link of the backend `name`, not yet connected.

    Args:
        world: the name of one that ships, or a document.
        address: where the robot is to be found, for backends that need one.

    Raises PinelError `unknown_link`, `unknown_robot`, and what the backend itself has to say (`unknown_world`).
    """
    if name not in _BACKENDS:
        raise PinelError("unknown_link", value=name, allowed=list(LINK_NAMES))
    module, class_name = _BACKENDS[name]
    backend = getattr(importlib.import_module(module), class_name)
    return cast(RobotLink, backend(world=world, setting=setting, seed=seed, address=address))
