"""Admission of HTTP requests: key, Host header (DNS rebinding) and origin of web pages (CORS)."""

import hmac
import ipaddress
import socket
from collections.abc import Mapping
from urllib.parse import parse_qs, urlsplit

from pinel_desktop.errors import PinelError
from pinel_desktop.robot.robot_profile import BridgeProfile

KEY_HEADER = "x-pinel-key"
_OWN_FETCHES = ("", "none", "same-origin")
# Origin of a page opened as a file, and of a page in a sandboxed frame; no header distinguishes
# them.
_NO_ORIGIN = ("null", "")


class RequestGuard:
    """Admits or refuses requests by their headers, for the address and the key of a profile.

    Args:
        file_pages: whether pages without an origin, which were opened as a file, are admitted without a key.
    """

    def __init__(self, profile: BridgeProfile, *, file_pages: bool = False) -> None:
        self.has_key = bool(profile.key)
        self.file_pages = file_pages
        self._key = profile.key.encode()
        self._names = {"localhost", profile.host.lower(), *_names_of_this_pc()}

    def page_origin(self, headers: Mapping[str, str], *, for_robots: bool = False) -> str | None:
        """Returns the origin of a web page that may read the response; None for a program that is no page.

        If the profile has a key, any page is admitted, because it must send the key. Without a key, only pages of this
        PC are admitted: a page of any other site could be open in a browser of this PC.

        Args:
            for_robots: whether the route is for robots; pages then need a key or `file_pages`.

        Raises:
            PinelError: `bridge_page_foreign`, `bridge_origin_wrong` for a robot's route, `bridge_host_wrong`.
        """
        origin = headers.get("origin") or _origin_of(headers.get("referer", ""))
        is_of_a_page = "origin" in headers or (
            headers.get("sec-fetch-site", "") not in _OWN_FETCHES
        )
        if is_of_a_page and not self._admits(origin, headers, for_robots=for_robots):
            code = "bridge_origin_wrong" if for_robots else "bridge_page_foreign"
            raise PinelError(code, origin=origin)
        self._require_own_name(headers)
        return headers.get("origin")

    def require_key(self, headers: Mapping[str, str], query: str) -> None:
        """Checks the key in header or query. Raises PinelError `bridge_key_wrong`."""
        if not self.has_key:
            return
        given = headers.get(KEY_HEADER, "").encode("latin-1") or _key_in(query)
        if not hmac.compare_digest(given, self._key):
            raise PinelError("bridge_key_wrong")

    def _admits(self, origin: str, headers: Mapping[str, str], *, for_robots: bool) -> bool:
        """Returns whether a page of that origin is admitted; `require_key` checks the key later."""
        if self.has_key:
            return True
        if self.file_pages and origin in _NO_ORIGIN:
            return _may_be_a_file(headers)
        is_open = self.file_pages or not for_robots
        return is_open and self._is_of_this_pc(origin, headers)

    def _require_own_name(self, headers: Mapping[str, str]) -> None:
        """Refuses foreign host names (DNS rebinding). With a key all names are allowed, such as the name of a tunnel.

        Raises PinelError `bridge_host_wrong`.
        """
        if self.has_key:
            return
        host = headers.get("host", "")
        name = _name_in(host)
        if host and name not in self._names and not _is_ip(name):
            raise PinelError("bridge_host_wrong", host=host)

    @staticmethod
    def _is_of_this_pc(origin: str, headers: Mapping[str, str]) -> bool:
        name = _name_in(origin.partition("://")[2])
        return bool(name) and (_is_loopback(name) or name == _name_in(headers.get("host", "")))


def _may_be_a_file(headers: Mapping[str, str]) -> bool:
    """Returns whether a request without an origin may come from a page that was opened as a file.

    A file page sends requests with `fetch`, for which the browser obeys the preflight, or loads an image. A form or a
    link of another site sends a navigation, or a request without CORS. If a preflight has the header for private
    networks, the page is from the internet.
    """
    if headers.get("access-control-request-private-network") == "true":
        return False
    is_picture = headers.get("sec-fetch-dest") == "image" and "origin" not in headers
    return is_picture or headers.get("sec-fetch-mode", "cors") == "cors"


def _origin_of(address: str) -> str:
    """Returns scheme, host and port of a URL; "" without a scheme."""
    scheme, separator, rest = address.partition("://")
    return f"{scheme}{separator}{rest.partition('/')[0]}" if separator else ""


def _key_in(query: str) -> bytes:
    return parse_qs(query).get("key", [""])[0].encode(errors="replace")


def _name_in(host: str) -> str:
    """Returns the host name of a Host header, without its port; "" without a valid one."""
    try:
        return (urlsplit(f"//{host}").hostname or "").lower()
    except ValueError:
        return ""


def _is_ip(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def _is_loopback(name: str) -> bool:
    return name == "localhost" or (_is_ip(name) and ipaddress.ip_address(name).is_loopback)


def _names_of_this_pc() -> set[str]:
    name = socket.gethostname().lower()
    return {name, name.partition(".")[0], f"{name.partition('.')[0]}.local"}
