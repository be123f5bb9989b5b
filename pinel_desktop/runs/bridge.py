"""The HTTP bridge between runs, in the engine's process; the app controls it by messages.

Messages of the app:

- `bridge_listen` with `record` (the robot profile), `routes` (by path: `method` and `max_body`) and `file_pages`;
- `bridge_answer` with `question`, `status`, and `document` or `jpeg`;
- `bridge_alive`, the keepalive, once a second while a question is open.

Messages to the app:

- `bridge_listens` with `port`, or `bridge_refused` with `code` and `params`;
- `bridge_asked` with `question`, `method`, `path`, `body`, `request` (the same for all pictures of one stream),
  `batch` (number of the page's batch; null between two batches) and `of_page` (whether a web page sent the
  request);
- `bridge_batch_ended`: a block page has sent its last command;
- `bridge_withdrawn` with `question`: the client hung up, or the app's keepalive expired.
"""

from collections.abc import Callable
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.links.bridge.pending_requests import PendingRequests
from pinel_desktop.links.bridge.persistent_bridge import DelegatedRoute, PersistentBridge
from pinel_desktop.robot.robot_profile import BridgeProfile, profile_from

Message = dict[str, Any]


class BridgeController:
    """Executes the app's messages about the bridge.

    Args:
        send: sends a message to the app; may block.
    """

    def __init__(self, send: Callable[[Message], None]) -> None:
        self._send = send
        self._questions = PendingRequests(send)
        self._bridge: PersistentBridge | None = None

    def handle(self, message: Message) -> None:
        """Executes one message of the app; ignores all other types."""
        match message["type"]:
            case "bridge_listen":
                if self._bridge is None:
                    self._listen(message)
            case "bridge_answer":
                self._questions.settle(message)
            case "bridge_alive":
                self._questions.record_keepalive()

    def close(self) -> None:
        """Ends all questions and stops listening."""
        self._questions.close()
        if self._bridge is not None:
            self._bridge.close()

    def _listen(self, message: Message) -> None:
        routes = {path: DelegatedRoute(**route) for path, route in message["routes"].items()}
        try:
            record = profile_from(message["record"])
            assert isinstance(record, BridgeProfile)
            self._bridge = PersistentBridge(
                record,
                routes,
                self._questions.submit,
                file_pages=message["file_pages"],
                on_batch_end=lambda: self._questions.notify({"type": "bridge_batch_ended"}),
            )
        except PinelError as error:
            self._send({"type": "bridge_refused", "code": error.code, "params": error.params})
            return
        self._bridge.start()
        self._send({"type": "bridge_listens", "port": self._bridge.port})
