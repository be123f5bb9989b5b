"""Clouds: the same program in many realistic robots, so that a group sees how firm it is."""

from typing import TYPE_CHECKING, Any

from flask import Response

from pinel_desktop.errors import PinelError
from pinel_desktop.web.api import Resource, responses
from pinel_desktop.web.api.runs import activity_of, spec_for
from pinel_desktop.web.models import Empty, IdPath
from pinel_desktop.web.models.runs import Cloud, NewCloud, NewRun
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import Services, services
from storage import SIMULATOR

if TYPE_CHECKING:
    from pinel_desktop.runs.spec import Document

api = Resource("clouds", "Clouds: a program in 50 realistic robots.", __name__)

_READING = frozenset({"classify_gestures", "read_number", "ask"})


@api.post("/clouds/ready", responses=responses(Empty))
def prepare_cloud() -> Response:
    """Starts the processes of the clouds, so that the next cloud need not wait for them."""
    services().cloud.prepare()
    return json_response(Empty())


@api.post(
    "/clouds",
    responses=responses(
        Cloud,
        "version_not_found",
        "run_not_found",
        "invalid_program",
        "unknown_world",
        "world_missing",
        "calibrated_robot_not_found",
        "calibrated_robot_deleted",
        "cloud_real_robot",
        "cloud_needs_inputs",
        "cloud_lost",
    ),
)
def begin_cloud(body: NewCloud) -> Response:
    """Drives a version in 50 realistic robots, each with the slip of its own seed; ends the cloud before.

    A version that is to solve an activity gets its world, start, robot and the inputs of its first case from the
    activity, which judges each robot. Other programs read the signs and answers of a run before. Nothing is stored.
    """
    from pinel_desktop.cloud.messages import N_ROBOTS, CloudRequest  # noqa: PLC0415 - heavy

    parts = services()
    if body.robot != SIMULATOR:
        raise PinelError("cloud_real_robot")
    version = parts.store.versions.get(body.version_id)
    activity = activity_of(version)
    chosen = body.model_dump(include={"version_id", "world", "start", "model", "calibrated_robot"})
    spec = spec_for(version, activity, NewRun.model_validate(chosen), parts)
    inputs = None if activity else _inputs(spec.document, body.run_id, parts)
    assert isinstance(spec.document, dict)
    assert isinstance(spec.world, dict)
    request = CloudRequest(
        cloud=body.id,
        document=spec.document,
        world=spec.world,
        model=spec.setting.model,
        robot_parameters=spec.setting.parameters.changes,
        activity=activity.model_dump_json(exclude_none=True) if activity else None,
        gestures=inputs and inputs[0],
        answers=inputs and inputs[1],
        language=parts.settings.language,
    )
    parts.cloud.begin(request)
    return json_response(Cloud(id=body.id, n=N_ROBOTS))


@api.delete("/clouds/<id>", responses=responses(Empty))
def stop_cloud(path: IdPath) -> Response:
    """Ends a cloud; nothing happens if it is over."""
    services().cloud.stop(path.id)
    return json_response(Empty())


def _inputs(
    document: "Document", run_id: str | None, parts: Services
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Returns signs and answers of a run. Raises `cloud_needs_inputs` if the program reads some and there is no run."""
    from pinel_desktop.activities.commands import commands_of  # noqa: PLC0415 - heavy
    from pinel_desktop.runs.recorded_inputs import given_inputs  # noqa: PLC0415 - heavy

    assert isinstance(document, dict)
    if not any(command.action in _READING for command in commands_of(document)):
        return (), ()
    if run_id is None:
        raise PinelError("cloud_needs_inputs")
    events: list[dict[str, Any]] = parts.store.runs.events(run_id)
    return given_inputs(events)
