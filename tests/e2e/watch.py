"""Checks that the page in tests sends no foreign requests and has no errors."""

from dataclasses import dataclass, field
from urllib.parse import urlsplit

from playwright.sync_api import BrowserContext, ConsoleMessage, Page, Request, WebError

_LOCAL_SCHEMES = {"data", "blob"}
_POLL_MS = 20


@dataclass
class Watch:
    """Records requests, console messages and errors of a browser context."""

    foreign_requests: list[str] = field(default_factory=list)
    complaints: list[str] = field(default_factory=list)
    expected: list[str] = field(default_factory=list)
    unsettled: list[Request] = field(default_factory=list)

    def over(self, context: BrowserContext) -> None:
        context.on("request", self._on_request)
        context.on("requestfinished", self._on_answer)
        context.on("requestfailed", self._on_answer)
        context.on("console", self._on_console)
        context.on("weberror", self._on_error)

    def expect(self, part: str) -> None:
        """Allows an error that the test causes on purpose, by a part of its text."""
        self.expected.append(part)

    def settle(self, page: Page) -> None:
        """Waits until the server has responded to every setting that the page sent; the page itself does not wait."""
        calm = 0
        # if the language was chosen twice, the page sends the second choice after the response to
        # the first
        while calm < 2:
            calm = 0 if any(one.frame.page == page for one in self.unsettled) else calm + 1
            page.wait_for_timeout(_POLL_MS)

    def verdict(self) -> None:
        assert self.foreign_requests == []
        unexpected = [text for text in self.complaints if not self._is_expected(text)]
        assert unexpected == [], "\n".join(unexpected)

    def _on_request(self, request: Request) -> None:
        address = urlsplit(request.url)
        if address.scheme not in _LOCAL_SCHEMES and address.hostname != "127.0.0.1":
            self.foreign_requests.append(request.url)
        if request.method == "PUT" and "/api/settings" in address.path:
            self.unsettled.append(request)

    def _on_answer(self, request: Request) -> None:
        if request in self.unsettled:
            self.unsettled.remove(request)

    def _on_console(self, message: ConsoleMessage) -> None:
        if message.type in {"error", "warning"}:
            where = message.location.get("url", "")
            self.complaints.append(f"{message.type}: {message.text} ({where})")

    def _on_error(self, error: WebError) -> None:
        self.complaints.append(f"thrown: {error.error}")

    def _is_expected(self, text: str) -> bool:
        return any(part in text for part in self.expected)
