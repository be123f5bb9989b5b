"""A run's spec as the store keeps it, and back."""

from typing import Any

from pinel_desktop.robot import setting_from
from pinel_desktop.runs.spec import Document, RunInputs, RunSpec
from storage import RunRow, RunStart


def record_of(
    spec: RunSpec,
    *,
    world_name: str,
    app_version: str,
    version_id: str | None = None,
    activity: str | None = None,
    more: dict[str, Any] | None = None,
) -> RunStart:
    """What is kept of a run when it begins; its inputs follow as events.

    Args:
        version_id: of the stored version that holds the document; without one the document itself is kept.
        activity: what was to be solved.
        more: further parameters, for people to look up.
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
        parameters={**spec.setting.as_parameters(), **(more or {})},
    )


def spec_of(row: RunRow, document: Document, inputs: RunInputs) -> RunSpec:
    """The spec of a recorded run. Raises PinelError `run_damaged`."""
    return RunSpec(
        document=document,
        world=row.world_document,
        link=row.link,
        setting=setting_from(row.parameters),
        seed=row.seed,
        inputs=inputs,
    )
