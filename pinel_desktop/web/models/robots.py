"""Robots."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import Shape


class Robot(Shape):
    """Dimensions and sensors of a robot model; angles are from its heading, counterclockwise."""

    name: Annotated[str, Field(description="the `model` of a run")]
    title: str
    radius_m: float
    max_v_mps: float
    max_omega_radps: float
    sonar_angles_rad: Annotated[list[float], Field(description="by index; each on the hull")]
    sonar_range_m: float
    lidar_range_m: Annotated[float | None, Field(description="null without a laser scanner")]


class RobotList(Shape):
    """All robot models of the simulator."""

    robots: list[Robot]
