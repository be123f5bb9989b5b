"""Who may ask: the key, the address that was meant, and which web pages."""

import hmac
import ipaddress
import socket
from collections.abc import Mapping
from urllib.parse import parse_qs, urlsplit

from pinel_desktop.errors import PinelError
from pinel_desktop.robot.record import BridgeRecord

KEY_HEADER = "x-pinel-key"
_OWN_FETCHES = ("", "none", "same-origin")


class Callers:
    """Judges requests by their headers, for the record's address and key."""

    def __init__(self, record: BridgeRecord) -> None:
        self.has_key = bool(record.key)
        self._key = record.key.encode()
        self._names = {"localhost", record.host.lower(), *_names_of_this_pc()}

    def require_program(self, headers: Mapping[str, str]) -> None:
        """Refuses what a web page makes a browser send, also by a name that leads here (DNS rebinding).

        Raises PinelError `bridge_origin_wrong`, `bridge_host_wrong`.
        """
        if "origin" in headers or headers.get("sec-fetch-site", "none") != "none":
            raise PinelError("bridge_origin_wrong", origin=headers.get("origin", ""))
        self._require_own_name(headers)

    def require_program_or_own_page(self, headers: Mapping[str, str]) -> str | None:
        """The origin of a web page that may read the answer; None for a program.

        Without a key, pages of this PC only: all others could be anybody's, opened in a browser of this PC. With one
        any page, since it has to know the key.

        Raises PinelError `bridge_page_foreign`, `bridge_host_wrong`.
        """
        self._require_own_name(headers)
        origin = headers.get("origin") or _origin_of(headers.get("referer", ""))
        is_of_a_page = "origin" in headers or (
            headers.get("sec-fetch-site", "") not in _OWN_FETCHES
        )
        if is_of_a_page and not self.has_key and not self._is_of_this_pc(origin, headers):
            raise PinelError("bridge_page_foreign", origin=origin)
        return headers.get("origin")

    def require_key(self, headers: Mapping[str, str], query: str) -> None:
        """Raises PinelError `bridge_key_wrong`."""
        if not self.has_key:
            return
        given = headers.get(KEY_HEADER, "").encode("latin-1") or _key_in(query)
        if not hmac.compare_digest(given, self._key):
            raise PinelError("bridge_key_wrong")

    def _require_own_name(self, headers: Mapping[str, str]) -> None:
        host = headers.get("host", "")
        name = _name_in(host)
        if host and name not in self._names and not _is_ip(name):
            raise PinelError("bridge_host_wrong", host=host)

    @staticmethod
    def _is_of_this_pc(origin: str, headers: Mapping[str, str]) -> bool:
        name = _name_in(origin.partition("://")[2])
        return bool(name) and (_is_loopback(name) or name == _name_in(headers.get("host", "")))


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
