"""Presets of classes: the stored level, world and activity with which groups start."""

from typing import Any

from pydantic import ValidationError

from pinel_desktop.errors import PinelError
from pinel_desktop.school.own_activities import known_activity
from pinel_desktop.web.models.classes import ClassPreset
from pinel_desktop.web.models.work import Setup
from pinel_desktop.web.services import Services
from storage import GroupRow, ProgramRow, Store

_OWN = "own"


def preset_of(classroom_id: str, store: Store) -> ClassPreset:
    """Returns the preset of a class; empty if this release cannot read it. Raises StoreError `classroom_not_found`."""
    stored = store.class_presets.get(classroom_id)
    try:
        return ClassPreset.model_validate(stored)
    except ValidationError:
        return ClassPreset()


def world_of_preset(name: str, parts: Services) -> dict[str, Any] | None:
    """Returns the world of an own activity by its key; None for the name of a shipped world.

    Raises:
        PinelError: `unknown_world`.
    """
    if any(world["name"] == name for world in parts.worlds):
        return None
    from pinel_desktop.activities import world_of  # noqa: PLC0415 - heavy

    try:
        return {**world_of(known_activity(parts.store, name)), "name": _OWN}
    except PinelError as error:
        allowed = [world["name"] for world in parts.worlds]
        raise PinelError("unknown_world", value=name, allowed=allowed) from error


def prepare_program(program: ProgramRow, group: GroupRow, parts: Services) -> None:
    """Sets the world of the class's preset in a new program, as its first version; ignores a deleted world."""
    preset = preset_of(group.classroom_id, parts.store) if group.classroom_id else ClassPreset()
    if preset.world is None:
        return
    try:
        world = world_of_preset(preset.world, parts)
    except PinelError:
        return
    setup = Setup(world=preset.world if world is None else _OWN)
    empty = {"pinel_ir": 1, "name": program.name, "functions": [], "commands": []}
    parts.store.versions.save(program.id, {}, empty, world=world, setup=setup.as_stored())
