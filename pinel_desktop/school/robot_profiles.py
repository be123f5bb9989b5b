"""Profiles of the real robots of this PC, one for each kind of link; the teacher sets them up."""

from collections.abc import Sequence
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import PIONEER_3DX
from pinel_desktop.robot.robot_profile import PROFILES, RobotProfile, profile_from
from pinel_desktop.school.pin_rate_limiter import Settings


class RobotProfiles:
    """Stores the profiles in the settings of the store.

    Args:
        links: names of the links that this app has.
    """

    def __init__(self, settings: Settings, links: Sequence[str]) -> None:
        self._settings = settings
        self.kinds = tuple(link for link in links if link in PROFILES)

    def find(self, link: str) -> RobotProfile | None:
        """Returns the profile of a link; None before it is set up. Raises PinelError `unknown_link`."""
        stored = self._settings.get(self._key(link))
        if not isinstance(stored, dict):
            return None
        try:
            return profile_from(stored)
        except PinelError:  # written by a newer release
            return None

    def profile(self, link: str) -> RobotProfile:
        """Returns the profile of a link. Raises PinelError `unknown_link`, `robot_not_set_up`."""
        profile = self.find(link)
        if profile is None:
            raise PinelError("robot_not_set_up")
        return profile

    def save(self, link: str, fields: dict[str, Any]) -> RobotProfile:
        """Stores the profile of a link; a missing field gets its default.

        Raises:
            PinelError: `unknown_link`, `robot_record_range`, `robot_record_invalid`, and a start pose outside the room,
                such as `start_in_wall`.
        """
        key = self._key(link)
        profile = profile_from({**fields, "link": link})
        require_room(profile)
        self._settings.set(key, profile.as_message())
        return profile

    def forget(self, link: str) -> None:
        """Deletes the profile of a link. Raises PinelError `unknown_link`."""
        self._settings.set(self._key(link), None)

    def _key(self, link: str) -> str:
        if link not in self.kinds:
            raise PinelError("unknown_link", value=link, allowed=["sim", *self.kinds])
        return f"robot_{link}"


def require_room(profile: RobotProfile) -> None:
    """Raises PinelError with the first fault of the start pose in the room, such as `start_in_wall`."""
    from pinel_desktop.worlds import read_own_world  # noqa: PLC0415 - heavy

    _, faults = read_own_world(profile.room.as_world(), robot=PIONEER_3DX.name)
    for fault in faults:
        raise PinelError(fault.code, **fault.params)
