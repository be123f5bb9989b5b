"""Robots."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import Shape


class Robot(Shape):
    """What is needed to draw a robot and what it senses; angles from its heading, counterclockwise."""

    name: Annotated[str, Field(description="what a run asks for as its `model`")]
    title: str
    radius_m: float
    max_v_mps: float
    max_omega_radps: float
    sonar_angles_rad: Annotated[list[float], Field(description="by index; each on the hull")]
    sonar_range_m: float
    lidar_range_m: Annotated[float | None, Field(description="null without a laser scanner")]


class RobotList(Shape):
    """Every robot that a run can be made with in the simulator."""

    robots: list[Robot]
