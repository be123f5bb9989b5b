"""Access control of the server: only the page that the app opened may use it.

The server is bound to 127.0.0.1. A one-time key in the first address, which expires, sets an HttpOnly SameSite=Strict
cookie. Every request must carry this cookie and come from our own origin. If a foreign web page makes a browser send
requests, the guard refuses them even with the cookie. It checks Host (DNS rebinding), Origin and Sec-Fetch-Site
(cross-site request forgery).
"""

import hmac
import re
import secrets
import threading
import time
from collections.abc import Callable, Mapping
from typing import Protocol

from pinel_desktop.errors import PinelError

SECRET_HEADER = "X-Pinel-Secret"
# "none": the address was typed, from a bookmark, or opened by another program
_OWN_SITE = ("same-origin", "none")
_MAX_KEYS = 16
_SECRETS = re.compile(rb"[\w-]{32,}")  # in the alphabet of `secrets.token_urlsafe`
# A slow PC needs a minute for its window; a person has to copy the address of `pinel serve`.
KEY_S = 300.0


class Headers(Protocol):
    """Headers of a request, case-insensitive."""

    def get(self, key: str, /) -> str | None: ...


class Guard:
    """Keys, cookie and secret of one server; thread-safe.

    Raises:
        PinelError: `host_wrong`, `origin_wrong`, `cross_site`, `key_missing` or `secret_wrong`.
    """

    def __init__(
        self, secret: str | None = None, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self.secret = secret or secrets.token_urlsafe(32)
        self.cookie_value = secrets.token_urlsafe(32)
        self._authority = ""
        self._clock = clock
        self._keys: list[tuple[str, float]] = []  # key, and the time when it was made
        self._lock = threading.Lock()

    def bind(self, host: str, port: int) -> None:
        """Sets the server's address; until then every request is refused."""
        self._authority = f"{host}:{port}"

    @property
    def origin(self) -> str:
        """`http://127.0.0.1:PORT`."""
        return f"http://{self._authority}"

    @property
    def cookie_name(self) -> str:
        """Name of the cookie; contains the port, because all ports of a host share cookies.

        So two apps on one PC have a cookie each.
        """
        return f"pinel_{self._authority.rpartition(':')[2]}"

    def fresh_link(self) -> str:
        """Returns a new address that opens the page once, within `KEY_S`."""
        key = secrets.token_urlsafe(24)
        with self._lock:
            self._keys = [*self._keys[1 - _MAX_KEYS :], (key, self._clock())]
        return f"{self.origin}/?key={key}"

    def redeem(self, key: str) -> bool:
        """Consumes a one-time key; True if it was valid and not too old."""
        with self._lock:
            found = [
                (stored, made)
                for stored, made in self._keys
                if hmac.compare_digest(stored.encode(), key.encode())
            ]
            self._keys = [one for one in self._keys if one not in found]
        return any(self._clock() - made <= KEY_S for _, made in found)

    def is_known(self, head: bytes) -> bool:
        """True if the head of a request contains the cookie, the secret or a key.

        The check uses up no key and permits no request.
        """
        with self._lock:
            keys = [key for key, _ in self._keys]
        known = {credential.encode() for credential in (self.cookie_value, self.secret, *keys)}
        return not known.isdisjoint(_SECRETS.findall(head))

    def check_origin(self, headers: Headers) -> None:
        """Refuses requests from other origins. Raises PinelError `host_wrong`, `origin_wrong` or `cross_site`."""
        host = headers.get("Host") or ""
        if not self._authority or host != self._authority:
            raise PinelError("host_wrong", host=host, expected=self._authority)
        origin = headers.get("Origin")
        if origin is not None and origin != self.origin:
            raise PinelError("origin_wrong", origin=origin)
        site = headers.get("Sec-Fetch-Site")
        if site is not None and site not in _OWN_SITE:
            raise PinelError("cross_site", site=site)

    def check_cookie(self, cookies: Mapping[str, str]) -> None:
        """Refuses requests without our cookie. Raises PinelError `key_missing`."""
        given = cookies.get(self.cookie_name, "")
        if not hmac.compare_digest(given.encode(), self.cookie_value.encode()):
            raise PinelError("key_missing")

    def check_secret(self, headers: Headers) -> None:
        """Refuses requests without the secret of the instance file. Raises PinelError `secret_wrong`."""
        given = headers.get(SECRET_HEADER) or ""
        if not hmac.compare_digest(given.encode(), self.secret.encode()):
            raise PinelError("secret_wrong")
