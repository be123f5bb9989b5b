"""What the camera above the floor sees, as a message: for the command and the teacher's page. Needs no OpenCV."""

import math
from collections.abc import Sequence

CodeAndParams = tuple[str, dict[str, object]]


def wording(
    pose: Sequence[float] | None, problem: str | None, missing: Sequence[int]
) -> CodeAndParams | None:
    """Returns code and parameters of the message; None while nothing can be said.

    Args:
        pose: x, y (m), heading (rad) of the robot on the floor, and one sigma of place and heading.
        problem, missing: as in `tracking.Sighting`.
    """
    if problem:
        return problem, {"markers": ", ".join(map(str, missing))}
    if pose is None:
        return None
    x, y, yaw, sigma_m, sigma_rad = pose
    return "overhead_seen", {
        "x": round(x, 3),
        "y": round(y, 3),
        "heading": round(math.degrees(yaw), 1),
        "sigma_mm": round(1000 * sigma_m),
        "sigma_deg": round(math.degrees(sigma_rad), 1),
    }
