"""Places of the world by their names, and the marks in them."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.robot import Pose2D, Sensors

# marks outside of all places of the world: radius of one place, a little more than the robot's
# radius
_SAME_PLACE_M = 0.3


def middle_of(
    name: str, places: Mapping[str, tuple[float, float]], origin: Pose2D
) -> tuple[float, float]:
    """Returns the middle (m, start frame) of a place.

    Ignores the case of `name`, because typed and signed names differ in it.

    Args:
        places: middles of all places in the link's frame (m).
        origin: pose of the start frame in the link's frame.

    Raises RunFailureError `place_not_named`, `no_places` or `unknown_place`.
    """
    if not name.strip():
        raise RunFailureError("place_not_named")
    if not places:
        raise RunFailureError("no_places", value=name)
    folded = name.strip().casefold()
    found = name if name in places else next((p for p in places if p.casefold() == folded), None)
    if found is None:
        raise RunFailureError("unknown_place", value=name, allowed=list(places))
    middle = Pose2D(*places[found]).relative_to(origin)
    return middle.x_m, middle.y_m


def place_under(sensors: Sensors) -> str:
    """Returns the name of the place under the robot; "" without one, and for robots without this sensor."""
    try:
        return str(sensors.reader("cell")())
    except PinelError:
        return ""


@dataclass(slots=True)
class MarkedPlaces:
    """The marks of a run by place; outside of all places of the world, by position."""

    _by_place: dict[str, str] = field(default_factory=dict)
    _outside_places: list[tuple[Pose2D, str]] = field(default_factory=list)

    def put(self, symbol: str, place: str, pose: Pose2D) -> None:
        """Records a mark; `pose` is in the start frame."""
        if place:
            self._by_place[place] = symbol
        else:
            self._outside_places.append((pose, symbol))

    def here(self, place: str, pose: Pose2D) -> str:
        """The last mark of a place, "" without one."""
        if place:
            return self._by_place.get(place, "")
        near = (
            symbol
            for marked, symbol in reversed(self._outside_places)
            if marked.distance_to(pose) <= _SAME_PLACE_M
        )
        return next(near, "")
