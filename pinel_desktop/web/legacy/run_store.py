"""Stores runs that HTTP calls extend: all their commands as a version of one program."""

from collections.abc import Callable, Sequence
from typing import Any

from pinel_desktop.messages import LANGUAGES, describe
from pinel_desktop.runs.record import record_of
from pinel_desktop.runs.spec import RunSpec
from storage import Store

Commands = list[dict[str, Any]]

_NAME = "bridge_program"
_BODIES = ("commands", "else")


class LegacyRunStore:
    """The program of the bridge, in a group of its own.

    While a run is live, its row has the document, so that a run can be read and verified after a crash. At the run's
    end the document becomes a version.
    """

    def __init__(self, store: Store, app_version: str, language: Callable[[], str]) -> None:
        self._store, self._app_version, self._language = store, app_version, language

    def document(self, commands: Commands) -> dict[str, Any]:
        """Returns the document of a run."""
        return {"pinel_ir": 1, "name": self._name(), "functions": [], "commands": commands}

    def begin(self, spec: RunSpec, world_name: str) -> str:
        """Stores the start of a run and returns its id. Raises StoreError."""
        record = record_of(
            spec,
            world_name=world_name,
            app_version=self._app_version,
            program_id=self._program(),
        )
        return self._store.runs.begin(record).id

    def grow(self, run_id: str, commands: Commands) -> None:
        """Replaces the commands of a live run. Raises StoreError."""
        self._store.runs.update_document(run_id, self.document(commands))

    def settle(self, run_id: str, commands: Commands) -> None:
        """Stores the commands of an ended run as a version. Raises StoreError."""
        program = self._store.runs.get(run_id).program_id
        if program is not None:
            document = self.document(commands)
            # the workspace is empty: the page makes the blocks (ui/src/blocks/loader)
            version = self._store.versions.save(program, {"document": document}, document)
            self._store.runs.attach_version(run_id, version.id)

    def discard(self, run_id: str) -> None:
        """Deletes a run that could not start. Raises StoreError."""
        self._store.runs.discard(run_id)

    def _program(self) -> str:
        names = [describe(_NAME, {}, language).message for language in LANGUAGES]
        group = next(
            (
                one
                for one in self._store.groups.all()
                if one.classroom_id is None and one.name in names
            ),
            None,
        ) or self._store.groups.create(self._name())
        programs = self._store.programs.of_group(group.id)
        program = next((one for one in programs if one.name in names), None)
        return (program or self._store.programs.create(group.id, self._name())).id

    def _name(self) -> str:
        return describe(_NAME, {}, self._language()).message


def with_blocks(commands: Sequence[dict[str, Any]], first: int) -> tuple[Commands, int]:
    """Returns the commands, each with a block id counted from `first`, and the next number.

    The ids of callers would repeat in each call.
    """
    labelled: Commands = []
    for command in commands:
        one, first = {**command, "block": f"call-{first}"}, first + 1
        for body in _BODIES:
            if body in one:
                one[body], first = with_blocks(one[body], first)
        for place, branch in enumerate(one.get("elif", ())):
            inside, first = with_blocks(branch["commands"], first)
            one["elif"] = [*one["elif"]]
            one["elif"][place] = {**branch, "commands": inside}
        labelled.append(one)
    return labelled, first
