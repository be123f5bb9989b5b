"""The printed markers, and where they lie: four on the floor, one on the robot. Needs no OpenCV.

The frame of the floor has its origin at the centre of the first floor marker, x towards the second, y towards the
fourth, z up: markers 1 to 4 are the corners of a rectangle, counterclockwise seen from above.
"""

from collections.abc import Mapping
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

from pinel_desktop.errors import PinelError

# ArUco markers 0 to 4 of the dictionary 4x4_50 of OpenCV: rows of bits, 1 is white; a black border of one bit around
MARKER_BITS = (
    ("1011", "0101", "0011", "0010"),
    ("0000", "1111", "1001", "1010"),
    ("0011", "0011", "0010", "1101"),
    ("1001", "1001", "0100", "0110"),
    ("0101", "0100", "1001", "1110"),
)
FLOOR_MARKERS = (0, 1, 2, 3)
ROBOT_MARKER = 4
MARKER_M = 0.16  # side of the black square on an A4 sheet


class OverheadSetup(BaseModel):
    """What the teacher has measured.

    Attributes:
        width_m: from the centre of floor marker 1 to that of marker 2, also from 4 to 3.
        depth_m: from the centre of marker 1 to that of marker 4, also from 2 to 3.
        camera_m: height of the lens above the floor.
        robot_m: height of the robot's marker above the floor.
    """

    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid")

    width_m: Annotated[float, Field(ge=0.5, le=10.0)] = 3.0
    depth_m: Annotated[float, Field(ge=0.5, le=10.0)] = 3.0
    camera_m: Annotated[float, Field(ge=1.0, le=10.0)] = 2.7
    robot_m: Annotated[float, Field(ge=0.0, le=0.9)] = 0.25

    @property
    def floor_centres(self) -> tuple[tuple[float, float], ...]:
        """The centres of the floor markers, in the floor's frame, in m."""
        w, d = self.width_m, self.depth_m
        return ((0.0, 0.0), (w, 0.0), (w, d), (0.0, d))


def checked_setup(lengths: Mapping[str, float]) -> OverheadSetup:
    """Reads what a person measured. Raises PinelError `overhead_range` with the field, its value and bounds."""
    for name, field in OverheadSetup.model_fields.items():
        low = next(bound.ge for bound in field.metadata if hasattr(bound, "ge"))
        high = next(bound.le for bound in field.metadata if hasattr(bound, "le"))
        if not low <= lengths[name] <= high:  # also refuses NaN
            raise PinelError("overhead_range", field=name, value=lengths[name], low=low, high=high)
    return OverheadSetup(**lengths)


def setup_of(text: str) -> OverheadSetup | None:
    """Reads the setting of a camera above the floor: four lengths in mm, `WIDTH-DEPTH-CAMERA-ROBOT`; None for none."""
    try:
        lengths = [int(part) / 1000 for part in text.split("-")]
        return OverheadSetup(**dict(zip(OverheadSetup.model_fields, lengths, strict=True)))
    except ValueError:  # a ValidationError is one, too
        return None


def setting_of(setup: OverheadSetup) -> str:
    """Returns the setting that `setup_of` reads."""
    return "-".join(str(round(length * 1000)) for length in setup.model_dump().values())
