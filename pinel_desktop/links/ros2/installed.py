"""Finds the ROS 2 installation of this PC, and builds the command that runs our node with its Python."""

import os
import shutil
import sys
from collections.abc import Mapping
from pathlib import Path

NODE = Path(__file__).parent / "node" / "node.py"
_FOLDERS = {"win32": (Path("C:/dev"), Path("C:/opt/ros"), Path("C:/pixi_ws"))}
_ON_LINUX = (Path("/opt/ros"),)
# The system's Python, for which ROS is built. In PATH, a virtual environment's Python could
# precede.
_RUN = 'source "$0" && exec "$(command -v /usr/bin/python3 || command -v python3)" "$@"'


def node_command(
    configuration: str, environment: Mapping[str, str] = os.environ
) -> list[str] | None:
    """Returns the command that runs the node with a configuration; None without ROS 2.

    If PINEL was started in a terminal with a sourced ROS, that ROS is used; else the newest installed release.
    """
    if environment.get("ROS_VERSION") == "2" and (python := shutil.which("python3")):
        return [python, str(NODE), configuration]
    setup = newest_setup()
    if setup is None:
        return None
    if sys.platform == "win32":
        return ["cmd", "/c", "call", str(setup), "&&", "python", str(NODE), configuration]
    return ["bash", "-c", _RUN, str(setup), str(NODE), configuration]


def newest_setup() -> Path | None:
    """Returns the set-up file of the newest installed ROS release; release names are in alphabetical order."""
    name = "local_setup.bat" if sys.platform == "win32" else "setup.bash"
    folders = _FOLDERS.get(sys.platform, _ON_LINUX)
    found = [file for folder in folders for file in folder.glob(f"*/{name}")]
    return max(found, key=lambda file: file.parent.name, default=None)
