"""Profiles of real robots: address and topics, speed limits, goal tolerances, and the room.

A PC stores one profile for each kind of link. A run stores the profile with which it was started.
"""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Annotated, Any, ClassVar, Self

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from pinel_desktop.errors import PinelError
from pinel_desktop.messages import LANGUAGES, describe
from pinel_desktop.robot.geometry import Pose2D
from pinel_desktop.robot.models import RobotModel

# The app imports this module at its start. Pydantic therefore builds each model at its first use.
_SETTINGS = ConfigDict(defer_build=True, frozen=True, extra="forbid")

# Domain 232 is the last one with ports below 65536 (OMG DDSI-RTPS 2.5, 9.6.2).
LAST_DOMAIN = 232
# A ROS name: letters, digits and underscores, with slashes between the parts.
_ROS_NAME = r"^/?[A-Za-z_][A-Za-z0-9_]*(/[A-Za-z_][A-Za-z0-9_]*)*$"
_SOON_S = 20.0
# name of the world document of a room
ROOM = "room"
RosName = Annotated[str, Field(pattern=_ROS_NAME, max_length=100)]
HostName = Annotated[str, Field(pattern=r"^[A-Za-z0-9.:\-]+$", max_length=100)]


class Room(BaseModel):
    """The free floor of a real room, a rectangle, and the robot's pose at the start of a run.

    The frame is the frame of worlds: origin in the centre, x to the right of the drawing, metres and degrees.
    """

    model_config = _SETTINGS

    width_m: Annotated[float, Field(ge=1.0, le=50.0)] = 4.0
    depth_m: Annotated[float, Field(ge=1.0, le=50.0)] = 4.0
    x_m: Annotated[float, Field(ge=-25.0, le=25.0)] = 0.0
    y_m: Annotated[float, Field(ge=-25.0, le=25.0)] = 0.0
    heading_deg: Annotated[float, Field(ge=-360.0, le=360.0)] = 0.0

    @property
    def start(self) -> Pose2D:
        """The robot's pose at the start of a run, in the room's frame, in m and rad."""
        return Pose2D(self.x_m, self.y_m, math.radians(self.heading_deg))

    def as_world(self) -> dict[str, Any]:
        """Returns a world document (docs/worlds.md) of the room: its edge as walls, and the start."""
        x, y = self.width_m / 2, self.depth_m / 2
        corners = [[-x, -y], [x, -y], [x, y], [-x, y]]
        edges = zip(corners, corners[1:] + corners[:1], strict=True)
        return {
            "pinel_world": 1,
            "name": ROOM,
            "title": {tag: describe("review_room", {}, tag).message for tag in LANGUAGES},
            "size_m": [self.width_m, self.depth_m],
            "start": {"x_m": self.x_m, "y_m": self.y_m, "heading_deg": self.heading_deg},
            "walls": [{"from": a, "to": b} for a, b in edges],
            "boxes": [],
        }


class RobotProfile(BaseModel):
    """Base of all profiles: the fields that every kind of real robot has.

    Attributes:
        max_v_mps, max_omega_dps: speed limits, which no program can exceed.
        move_tolerance_m, turn_tolerance_deg: goal tolerances. Static friction keeps the wheels from moving by less.
        room: the room; the link stops a robot at its edge.
        comes_to_us: whether the robot connects to this PC. If False, this PC searches for the robot.
    """

    model_config = _SETTINGS
    link: ClassVar[str]
    comes_to_us: ClassVar[bool] = False

    max_v_mps: Annotated[float, Field(ge=0.05, le=1.2)] = 0.3
    max_omega_dps: Annotated[float, Field(ge=5.0, le=300.0)] = 60.0
    move_tolerance_m: Annotated[float, Field(ge=0.001, le=0.1)] = 0.01
    turn_tolerance_deg: Annotated[float, Field(ge=0.1, le=10.0)] = 0.6
    room: Room = Field(default_factory=Room)

    @property
    def address(self) -> str:
        """Identifies the robot among all robots in reach of this PC. Two runs never drive the same address."""
        raise NotImplementedError

    def limited(self, robot: RobotModel) -> RobotModel:
        """Returns the robot's model with the speed limits of this profile."""
        v = min(self.max_v_mps, robot.max_v_mps)
        omega = min(math.radians(self.max_omega_dps), robot.max_omega_radps)
        return replace(
            robot,
            max_v_mps=v,
            max_omega_radps=omega,
            start_v_mps=min(v, robot.start_v_mps),
            start_omega_radps=min(omega, robot.start_omega_radps),
        )

    def as_message(self) -> dict[str, Any]:
        """Returns plain JSON data, which `profile_from` reads."""
        return {"link": self.link, **self.model_dump(mode="json")}

    def as_record(self) -> dict[str, Any]:
        """Returns the data of `as_message` without the key, for the record of a run, which other PCs receive."""
        return {"link": self.link, **self.model_dump(mode="json", exclude={"key"})}

    def slowed(self) -> Self:
        """Returns a copy with half of the speed limits, for the first run in front of people."""
        halved = {
            name: max(limits(type(self), name)[0], getattr(self, name) / 2)
            for name in ("max_v_mps", "max_omega_dps")
        }
        return self.model_copy(update=halved)

    def for_contact(self) -> Self:
        """Returns a copy with a shorter wait for the connection, for a contact test that a person watches."""
        return self


class RosProfile(RobotProfile):
    """A robot that speaks ROS 2.

    Attributes:
        domain: the robot's ROS_DOMAIN_ID.
        namespace: namespace of the robot's topics; empty for none.
        command_topic: topic of geometry_msgs Twist or TwistStamped, whichever the robot subscribes to.
        odometry_topic: topic of nav_msgs Odometry or geometry_msgs PoseStamped.
        scan_topic, sonar_topic, bumper_topic, battery_topic: empty if the robot has no such topic.
        localisation_topic: topic of geometry_msgs PoseStamped or PoseWithCovarianceStamped, where the robot's own
            localisation says where it is; empty for none.
        localisation_frame: name of the frame of those poses.
        peers: addresses of the robot, for networks without multicast.
    """

    domain: Annotated[int, Field(ge=0, le=LAST_DOMAIN)] = 0
    namespace: RosName | Annotated[str, Field(pattern="^$")] = ""
    command_topic: RosName = "cmd_vel"
    odometry_topic: RosName = "odom"
    scan_topic: RosName | Annotated[str, Field(pattern="^$")] = "scan"
    sonar_topic: RosName | Annotated[str, Field(pattern="^$")] = "sonar"
    bumper_topic: RosName | Annotated[str, Field(pattern="^$")] = "bumper_state"
    battery_topic: RosName | Annotated[str, Field(pattern="^$")] = "battery_state"
    localisation_topic: RosName | Annotated[str, Field(pattern="^$")] = ""
    localisation_frame: RosName = "map"
    peers: Annotated[tuple[HostName, ...], Field(max_length=20)] = ()

    @property
    def address(self) -> str:
        return f"domain {self.domain} {self.name_of(self.command_topic)}"

    def as_record(self) -> dict[str, Any]:
        record = super().as_record()
        if not self.localisation_topic:  # the record of a release that read no localisation
            del record["localisation_topic"], record["localisation_frame"]
        return record

    def name_of(self, topic: str) -> str:
        """Returns a topic's full name without the leading slash; an absolute name gets no namespace."""
        if topic.startswith("/") or not self.namespace:
            return topic.strip("/")
        return f"{self.namespace.strip('/')}/{topic}"


class DdsProfile(RosProfile):
    """A ROS 2 robot that PINEL reaches over DDS, without an installed ROS."""

    link = "dds"


class Ros2Profile(RosProfile):
    """A ROS 2 robot that PINEL reaches with the ROS installed on this PC."""

    link = "ros2"


class BridgeProfile(RobotProfile):
    """A simulator or robot that is an HTTP client of this PC, as in the original PINEL.

    The client requests velocities and posts its pose.

    Attributes:
        host, port: address at which this PC listens.
        key: key that each request must contain; empty for none, because clients of the original send none.
        wait_s: how long `connect` waits for the first request, in s.
    """

    link = "bridge"
    comes_to_us = True

    host: HostName = "127.0.0.1"
    port: Annotated[int, Field(ge=0, le=65535)] = 5000
    key: Annotated[str, Field(max_length=100)] = ""
    wait_s: Annotated[float, Field(ge=0.1, le=3600.0)] = 60.0

    def for_contact(self) -> Self:
        return self.model_copy(update={"wait_s": min(self.wait_s, _SOON_S)})

    @property
    def address(self) -> str:
        return f"{self.url_host}:{self.port}"

    @property
    def url_host(self) -> str:
        """The host as written in a URL; an IPv6 address has brackets."""
        return f"[{self.host}]" if ":" in self.host else self.host


PROFILES: dict[str, type[RobotProfile]] = {
    profile.link: profile for profile in (DdsProfile, Ros2Profile, BridgeProfile)
}


def fields_of(profile: type[RobotProfile]) -> list[str]:
    """Returns the names of all fields; fields of the room are named `room.NAME`."""
    own = [name for name in profile.model_fields if name != "room"]
    return [*own, *(f"room.{name}" for name in Room.model_fields)]


def limits(profile: type[RobotProfile], field: str) -> tuple[float, float]:
    """Returns the minimum and maximum of a numeric field; NaN for other fields."""
    in_room, _, name = field.rpartition(".")
    fields = Room.model_fields if in_room == "room" else profile.model_fields
    bounds = fields[name].metadata if name in fields else []
    low = next((bound.ge for bound in bounds if hasattr(bound, "ge")), math.nan)
    high = next((bound.le for bound in bounds if hasattr(bound, "le")), math.nan)
    return float(low), float(high)


def profile_from(message: Mapping[str, Any]) -> RobotProfile:
    """Reads a profile from plain JSON data; a missing field gets its default.

    Raises:
        PinelError: `unknown_link`; `robot_record_range` if a numeric field is no number within its bounds;
            `robot_record_invalid` for any other invalid field. The last two name the field and its value.
    """
    fields = dict(message)
    link = fields.pop("link", None)
    if link not in PROFILES:
        raise PinelError("unknown_link", value=link, allowed=list(PROFILES))
    try:
        return PROFILES[link].model_validate(fields)
    except ValidationError as error:
        raise _first_fault(PROFILES[link], error) from error


def _first_fault(profile: type[RobotProfile], error: ValidationError) -> PinelError:
    first = error.errors(include_url=False)[0]
    field = ".".join(str(part) for part in first["loc"] if not str(part).startswith("constrained"))
    low, high = limits(profile, field)
    if math.isnan(low):
        return PinelError("robot_record_invalid", field=field, value=first["input"])
    return PinelError("robot_record_range", field=field, value=first["input"], low=low, high=high)
