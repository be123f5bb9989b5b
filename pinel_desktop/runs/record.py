"""Converts a run's spec to the record in the store, and back."""

from collections.abc import Mapping
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.semantics import CURRENT, FIRST
from pinel_desktop.robot import simulation_config_from
from pinel_desktop.runs.spec import Document, RunInputs, RunSpec
from storage import RunRow, RunStart

_SEMANTICS = "semantics"


def record_of(
    spec: RunSpec,
    *,
    world_name: str,
    app_version: str,
    version_id: str | None = None,
    activity: str | None = None,
    program_id: str | None = None,
    more: dict[str, Any] | None = None,
) -> RunStart:
    """Returns the data that the store records when a run starts; the run's inputs follow as events.

    Args:
        version_id: id of the stored version that holds the document; without an id the document itself is recorded.
        activity: the activity that the run should solve.
        program_id: only for a run whose document grows, as in `RunStart`.
        more: further parameters, recorded for people only.
    """
    assert isinstance(spec.world, dict)
    assert isinstance(spec.document, dict)
    return RunStart(
        version_id=version_id,
        document=None if version_id else spec.document,
        link=spec.link,
        world=world_name,
        world_document=spec.world,
        seed=spec.seed,
        app_version=app_version,
        activity=activity,
        program_id=program_id,
        parameters={
            **spec.setting.as_parameters(),
            _SEMANTICS: spec.semantics,
            **({"robot": spec.robot.as_record()} if spec.robot else {}),
            **(more or {}),
        },
    )


def spec_of(row: RunRow, document: Document, inputs: RunInputs) -> RunSpec:
    """Returns the spec of a recorded run. Raises PinelError `run_damaged`, `run_newer`."""
    return RunSpec(
        document=document,
        world=row.world_document,
        link=row.link,
        setting=simulation_config_from(row.parameters),
        seed=row.seed,
        inputs=inputs,
        semantics=_semantics_of(row.parameters),
    )


def _semantics_of(parameters: Mapping[str, Any]) -> int:
    """Returns the semantics version of a recorded run (`execution.semantics`)."""
    version = parameters.get(_SEMANTICS)
    if not isinstance(version, int) or isinstance(version, bool) or version < FIRST:
        raise PinelError("run_damaged", part="parameters")
    if version > CURRENT:
        raise PinelError("run_newer")
    return version
