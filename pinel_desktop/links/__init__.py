"""Robot links: one module for each backend, which `open_link` imports by name.

All real robots share the link in `real.py`, over the transport of their backend (`transport.py`).
"""

import importlib
from typing import Any, cast

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import RobotLink, SimulationConfig
from pinel_desktop.robot.robot_profile import RobotProfile

_BACKENDS = {
    "sim": ("pinel_desktop.links.sim", "SimLink"),
    "dds": ("pinel_desktop.links.dds.transport", "dds_link"),
    "bridge": ("pinel_desktop.links.bridge.transport", "bridge_link"),
    "ros2": ("pinel_desktop.links.ros2.transport", "ros2_link"),
}
LINK_NAMES = tuple(_BACKENDS)
_DEFAULT_SETTING = SimulationConfig()


def open_link(
    name: str,
    *,
    world: str | dict[str, Any],
    setting: SimulationConfig = _DEFAULT_SETTING,
    seed: int = 0,
    robot: RobotProfile | None = None,
) -> RobotLink:
    """Returns a new link of the backend `name`, not yet connected.

    Args:
        world: name of a shipped world, or a world document; real robots ignore it.
        robot: profile of a real robot; None for the simulator.

    Raises:
        PinelError: `unknown_link`, `unknown_robot`, and errors of the backend such as `unknown_world`.
    """
    if name not in _BACKENDS:
        raise PinelError("unknown_link", value=name, allowed=list(LINK_NAMES))
    module, class_name = _BACKENDS[name]
    backend = getattr(importlib.import_module(module), class_name)
    return cast(RobotLink, backend(world=world, setting=setting, seed=seed, robot=robot))
