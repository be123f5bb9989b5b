"""Reads the world named on the command line: a shipped world, or a document in a file."""

import os
from dataclasses import dataclass
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.messages.content import titled
from pinel_desktop.program.faults import Fault
from sim.world import WorldError, world_document


@dataclass(frozen=True, slots=True)
class ChosenWorld:
    """A world's name and document."""

    name: str
    document: dict[str, Any]


class WorldFileError(PinelError):
    """A world file that has faults or cannot be read."""

    def __init__(self, faults: tuple[Fault, ...]) -> None:
        super().__init__("invalid_world", count=len(faults))
        self.faults = faults


def choose_world(name_or_file: str, *, robot: str) -> ChosenWorld:
    """Returns the shipped world with this name, or the world in this file. The robot must fit at the start pose.

    A name means a file if it ends in `.json`, or if it is no world's name but an existing file.

    Raises:
        PinelError: `unknown_world`.
        WorldFileError: `invalid_world`.
    """
    is_json = name_or_file.lower().endswith(".json")
    try:
        if not is_json:
            return ChosenWorld(name_or_file, titled(world_document(name_or_file)))
    except WorldError as error:
        if not os.path.isfile(name_or_file):
            raise PinelError(error.code, **error.params) from error
    document = _read(name_or_file, robot)
    return ChosenWorld(document["name"], document)


def _read(file: str, robot: str) -> dict[str, Any]:
    # imports numpy, which is slower than the run of most programs
    from pinel_desktop.worlds import MAX_BYTES, read_own_world  # noqa: PLC0415

    try:
        with open(file, "rb") as opened:
            text = opened.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        raise WorldFileError((Fault("file_unreadable", params={"path": file}),)) from error
    document, faults = read_own_world(text, robot=robot)
    if document is None:
        raise WorldFileError(tuple(faults))
    return document
