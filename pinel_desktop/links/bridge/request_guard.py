"""Who may ask: the key, the address that was meant, and which web pages."""

import hmac
import ipaddress
import socket
from collections.abc import Mapping
from urllib.parse import parse_qs, urlsplit

from pinel_desktop.errors import PinelError
from pinel_desktop.robot.robot_profile import BridgeProfile

KEY_HEADER = "x-pinel-key"
_OWN_FETCHES = ("", "none", "same-origin")
# the Origin of a page that was opened as a file, and of one in a sandboxed frame: no header tells them apart
_NO_ORIGIN = ("null", "")


class RequestGuard:
    """Judges requests by their headers, for the record's address and key.

    Args:
        file_pages: whether pages without an origin are answered without a key: those opened as a file.
    """

    def __init__(self, record: BridgeProfile, *, file_pages: bool = False) -> None:
        self.has_key = bool(record.key)
        self.file_pages = file_pages
        self._key = record.key.encode()
        self._names = {"localhost", record.host.lower(), *_names_of_this_pc()}

    def page_origin(self, headers: Mapping[str, str], *, for_robots: bool = False) -> str | None:
        """The origin of a web page that may read the response; None for a program.

        Without a key, pages of this PC only: all others could be anybody's, opened in a browser of this PC. With one
        any page, since it has to know the key.

        Args:
            for_robots: the route is that of a robot: pages need a key or `file_pages`.

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
        """Raises PinelError `bridge_key_wrong`."""
        if not self.has_key:
            return
        given = headers.get(KEY_HEADER, "").encode("latin-1") or _key_in(query)
        if not hmac.compare_digest(given, self._key):
            raise PinelError("bridge_key_wrong")

    def _admits(self, origin: str, headers: Mapping[str, str], *, for_robots: bool) -> bool:
        """Whether a page of that origin may ask; the key is required later."""
        if self.has_key:
            return True
        if self.file_pages and origin in _NO_ORIGIN:
            return _may_be_a_file(headers)
        is_open = self.file_pages or not for_robots
        return is_open and self._is_of_this_pc(origin, headers)

    def _require_own_name(self, headers: Mapping[str, str]) -> None:
        """Refuses a name that somebody else leads here (DNS rebinding); with a key a tunnel's name is as good."""
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
    """Whether a page that was opened as a file sends such a request without an origin.

    Such a page asks by `fetch`, whose preflight the browser obeys, or shows a picture. A form or a link of another site
    comes as a navigation or without CORS; a site of the internet may be named as such in the preflight.
    """
    if headers.get("access-control-request-private-network") == "true":
        return False
    is_picture = headers.get("sec-fetch-dest") == "image" and "origin" not in headers
    return is_picture or headers.get("sec-fetch-mode", "cors") == "cors"


def _origin_of(address: str) -> str:
    """Scheme, host and port of a URL; "" for none."""
    scheme, mark, rest = address.partition("://")
    return f"{scheme}{mark}{rest.partition('/')[0]}" if mark else ""


def _key_in(query: str) -> bytes:
    return parse_qs(query).get("key", [""])[0].encode(errors="replace")


def _name_in(host: str) -> str:
    """The name of a Host header, without its port; "" for none."""
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
