"""Clouds: the same program in many realistic robots, so that a group sees how firm it is."""

from flask import Response

from pinel_desktop.errors import PinelError
from pinel_desktop.web.api import Resource, responses
from pinel_desktop.web.api.runs import activity_of, cloud_inputs, in_case, spec_for
from pinel_desktop.web.models import Empty, IdPath
from pinel_desktop.web.models.runs import Cloud, CloudInputs, NewCloud, NewRun
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from storage import SIMULATOR

api = Resource("clouds", "Clouds: a program in 50 realistic robots.", __name__)


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

    A version that is to solve an activity gets its world, start, robot and inputs from one case of the activity, which
    judges each robot by this case. Other programs read the signs and answers of a run before. Nothing is stored.
    """
    from pinel_desktop.activities import case_texts  # noqa: PLC0415 - heavy
    from pinel_desktop.cloud.messages import N_ROBOTS, CloudRequest  # noqa: PLC0415 - heavy

    parts = services()
    if body.robot != SIMULATOR:
        raise PinelError("cloud_real_robot")
    version = parts.store.versions.get(body.version_id)
    whole = activity_of(version)
    activity = whole and in_case(whole, body.case)
    language = parts.settings.language
    given = case_texts(whole.cases, language) if whole else []
    chosen = body.model_dump(include={"version_id", "world", "start", "model", "calibrated_robot"})
    cloud = CloudInputs(run_id=body.run_id, case=body.case)
    spec = spec_for(version, activity, NewRun.model_validate(chosen), parts)
    assert isinstance(spec.document, dict)
    assert isinstance(spec.world, dict)
    request = CloudRequest(
        cloud=body.id,
        document=spec.document,
        world=spec.world,
        model=spec.setting.model,
        robot_parameters=spec.setting.parameters.changes,
        activity=activity.model_dump_json(exclude_none=True) if activity else None,
        case=given[min(body.case, len(given)) - 1] if given[1:] else "",
        inputs=cloud_inputs(spec.document, activity, cloud, parts),
        language=language,
    )
    parts.cloud.begin(request)
    return json_response(Cloud(id=body.id, n=N_ROBOTS))


@api.delete("/clouds/<id>", responses=responses(Empty))
def stop_cloud(path: IdPath) -> Response:
    """Ends a cloud; nothing happens if it is over."""
    services().cloud.stop(path.id)
    return json_response(Empty())
