"""Finds the ROS 2 of this PC, and the command that runs our node with its Python."""

import os
import shutil
import sys
from collections.abc import Mapping
from pathlib import Path

NODE = Path(__file__).parent / "node" / "node.py"
_FOLDERS = {"win32": (Path("C:/dev"), Path("C:/opt/ros"), Path("C:/pixi_ws"))}
_ON_LINUX = (Path("/opt/ros"),)
# The system's Python, for which ROS is built; one of a virtual environment could come first on the path.
_RUN = 'source "$0" && exec "$(command -v /usr/bin/python3 || command -v python3)" "$@"'


def node_command(
    configuration: str, environment: Mapping[str, str] = os.environ
) -> list[str] | None:
    """The command that runs the node with a configuration; None without ROS 2.

    A terminal in which ROS was set up wins over the newest one that is installed.
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
    """The set-up file of the newest ROS that is installed; ROS names its releases by the alphabet."""
    name = "local_setup.bat" if sys.platform == "win32" else "setup.bash"
    folders = _FOLDERS.get(sys.platform, _ON_LINUX)
    found = [file for folder in folders for file in folder.glob(f"*/{name}")]
    return max(found, key=lambda file: file.parent.name, default=None)
