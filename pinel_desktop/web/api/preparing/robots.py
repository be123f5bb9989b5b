"""The real robots that this PC can drive: their set-up, contact, keys and start."""

import math
from typing import Literal

from flask import Response

from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, explain
from pinel_desktop.robot.robot_profile import (
    PROFILES,
    RobotProfile,
    RosProfile,
    fields_of,
    limits,
    profile_from,
)
from pinel_desktop.web.api import TEACHER, WRITES, Resource, responses
from pinel_desktop.web.models import Empty
from pinel_desktop.web.models.robots import (
    FoundRobot,
    FoundRobots,
    Jog,
    LinkPath,
    RealRobot,
    RealRobotList,
    RealRobotRecord,
    RobotContact,
    RobotField,
    RobotWatch,
)
from pinel_desktop.web.models.worlds import World
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import is_teacher, require_teacher

api = Resource("robots", "Real robots.", __name__)


@api.get("/real-robots", responses=responses(RealRobotList))
def list_real_robots() -> Response:
    """All kinds of real robots. Only the teacher gets their connection data."""
    return json_response(RealRobotList(robots=[_robot(link) for link in services().robots.kinds]))


@api.put(
    "/real-robots/<link>",
    responses=responses(
        RealRobot, "unknown_link", "robot_record_range", "robot_record_invalid", *TEACHER, *WRITES
    ),
)
def put_real_robot(path: LinkPath, body: RealRobotRecord) -> Response:
    """Sets up a kind of robot on this PC. For the teacher.

    If the start pose is outside the room, the request is refused with 422 and the reason, such as `start_in_wall`.
    """
    require_teacher()
    try:
        services().robots.save(path.link, body.record)
    except PinelError as error:
        raise _with_field_label(error, path.link) from error
    return json_response(_robot(path.link))


@api.delete(
    "/real-robots/<link>", responses=responses(RealRobot, "unknown_link", *TEACHER, *WRITES)
)
def forget_real_robot(path: LinkPath) -> Response:
    """Deletes the set-up of a kind of robot on this PC. For the teacher."""
    require_teacher()
    services().robots.forget(path.link)
    return json_response(_robot(path.link))


@api.post(
    "/real-robots/<link>/contact",
    responses=responses(RobotContact, "unknown_link", "robot_not_set_up", *TEACHER),
)
def contact_real_robot(path: LinkPath) -> Response:
    """Connects to the robot, reads its data for a second and commands no motion. For the teacher."""
    require_teacher()
    parts = services()
    profile = parts.robots.profile(path.link)
    try:
        found = parts.engine.contact(profile.for_contact())
    except PinelError as error:
        text = explain(error, parts.settings.language)
        nothing = dict.fromkeys(("x_m", "y_m", "heading_deg", "rate_hz", "battery"))
        return json_response(RobotContact(**nothing, problem=text.message, remedy=text.remedy))
    return json_response(RobotContact(**found, problem=None, remedy=None))


@api.post(
    "/real-robots/<link>/find",
    responses=responses(
        FoundRobots,
        "unknown_link",
        "robot_record_range",
        "robot_record_invalid",
        "network_missing",
        "peer_unknown",
        "engine_not_ready",
        *TEACHER,
    ),
)
def find_real_robots(path: LinkPath, body: RealRobotRecord) -> Response:
    """Searches for ROS 2 robots in the domain of a profile that need not be stored. For the teacher."""
    require_teacher()
    try:
        profile = profile_from({**body.record, "link": path.link})
    except PinelError as error:
        raise _with_field_label(error, path.link) from error
    if not isinstance(profile, RosProfile):
        found_by_search = [one for one, kind in PROFILES.items() if issubclass(kind, RosProfile)]
        raise PinelError("unknown_link", value=path.link, allowed=found_by_search)
    found = services().engine.find(profile)
    return json_response(
        FoundRobots(domain=profile.domain, robots=[FoundRobot(**one) for one in found])
    )


@api.post(
    "/real-robots/<link>/watch", responses=responses(Empty, "unknown_link", "robot_not_set_up")
)
def watch_real_robot(path: LinkPath, body: RobotWatch) -> Response:
    """Listens to the robot for the next seconds and publishes its state as `robot_state` events. Commands no motion."""
    parts = services()
    profile = parts.robots.profile(path.link)
    parts.status_feed.watch(parts.engine, profile, is_first=body.is_first)
    return json_response(Empty())


@api.post(
    "/real-robots/<link>/jog",
    responses=responses(Empty, "unknown_link", "robot_not_set_up", "run_in_progress", *TEACHER),
)
def jog_real_robot(path: LinkPath, body: Jog) -> Response:
    """Moves the robot slowly for a fifth of a second. For the teacher.

    While a key is held, the page repeats the request; the first request connects.
    """
    require_teacher()
    parts = services()
    profile = parts.robots.profile(path.link)
    parts.engine.jog(profile, body.drive, body.turn, body.sent_ms / 1000)
    return json_response(Empty())


@api.delete(
    "/real-robots/<link>/jog", responses=responses(Empty, "unknown_link", "robot_not_set_up")
)
def halt_real_robot(path: LinkPath) -> Response:
    """Stops a robot that is moved by keys, at once. For everybody."""
    parts = services()
    parts.engine.halt(parts.robots.profile(path.link))
    return json_response(Empty())


@api.post(
    "/real-robots/<link>/at-start",
    responses=responses(Empty, "unknown_link", "robot_not_set_up", *TEACHER),
)
def set_real_robot_start(path: LinkPath) -> Response:
    """Defines the robot's current pose as the start pose of its room; moves nothing. For the teacher."""
    require_teacher()
    parts = services()
    parts.engine.set_start_here(parts.robots.profile(path.link))
    return json_response(Empty())


def _with_field_label(error: PinelError, link: str) -> PinelError:
    """Returns the error with its field named as in the form."""
    field = str(error.params.get("field", ""))
    name = next((one for one in fields_of(PROFILES[link]) if field.startswith(one)), None)
    if name is None:
        return error
    return PinelError(error.code, **{**error.params, "field": _label_and_hint(name)[0]})


def _robot(link: str) -> RealRobot:
    stored = services().robots.find(link)
    profile = stored or PROFILES[link]()
    return RealRobot(
        link=link,
        is_set_up=stored is not None,
        max_v_mps=profile.max_v_mps,
        slow_v_mps=profile.slowed().max_v_mps,
        world=World.model_validate(stored.room.as_world()) if stored else None,
        record=profile.as_message() if is_teacher() else None,
        fields=[_field(type(profile), name) for name in fields_of(type(profile))],
    )


def _field(profile: type[RobotProfile], name: str) -> RobotField:
    label, hint = _label_and_hint(name)
    low, high = limits(profile, name)
    info = profile.model_fields.get(name)
    is_number = not math.isnan(low)
    return RobotField(
        name=name,
        part=_part(name),
        label=label,
        hint=hint,
        low=low if is_number else None,
        high=high if is_number else None,
        is_whole=info is not None and info.annotation is int,
        is_list=info is not None and isinstance(info.default, tuple),
    )


def _part(field: str) -> Literal["speed", "room", "address", "tolerance"]:
    if field.startswith("room."):
        return "room"
    if field not in RobotProfile.model_fields:
        return "address"
    return "tolerance" if "tolerance" in field else "speed"


def _label_and_hint(field: str) -> tuple[str, str]:
    """Label and hint of a field."""
    code = f"robot_field_{field.replace('.', '_')}"
    text = describe(code, {}, services().settings.language)
    return text.message, text.remedy
