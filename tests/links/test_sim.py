import importlib.util
import sys
from pathlib import Path

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links import open_link
from pinel_desktop.robot import RobotLink

# tests are no package (they would shadow the packages they test): the contract is loaded by its file
_spec = importlib.util.spec_from_file_location(
    "link_contract", Path(__file__).with_name("link_contract.py")
)
assert _spec is not None
assert _spec.loader is not None
_module = importlib.util.module_from_spec(_spec)
sys.modules["link_contract"] = _module
_spec.loader.exec_module(_module)


class TestSimLink(_module.LinkContract):  # type: ignore[misc, name-defined]
    def open(self) -> RobotLink:
        link = open_link("sim", world="obstacles")
        link.connect()
        return link


def test_unknown_world_and_unknown_link_are_errors_that_list_what_there_is() -> None:
    with pytest.raises(PinelError) as world:
        open_link("sim", world="nowhere")
    with pytest.raises(PinelError) as link:
        open_link("teleporter", world="empty_room")
    assert (world.value.code, link.value.code) == ("unknown_world", "unknown_link")
    assert link.value.params["allowed"] == ["sim"]
