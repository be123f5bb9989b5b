"""The event stream. One stream has all events, because browsers allow only about six connections to a host."""

import json
from collections.abc import Iterable, Iterator

from flask import Response

from pinel_desktop.events.app_events import Hello
from pinel_desktop.events.hub import Subscription
from pinel_desktop.web.api import Resource, responses
from pinel_desktop.web.models.events import StreamEvent
from pinel_desktop.web.services import services

api = Resource("stream", "Live events.", __name__)

MODELS = (StreamEvent,)  # for the description
HEARTBEAT_INTERVAL_S = 10.0
_EVENTS = {
    "description": "Server-sent events; `data:` holds one event as JSON.",
    "content": {"text/event-stream": {"schema": {"$ref": "#/components/schemas/StreamEvent"}}},
}


@api.get("/stream", responses=responses(_EVENTS))
def stream_events() -> Response:
    """All events as they occur, after a first `hello`.

    Comment lines keep the stream open while no event occurs.
    """
    parts = services()
    subscription = parts.hub.subscribe()
    first = [Hello(parts.engine.live_run).to_wire(), *parts.opened_file.news()]
    return Response(_lines(subscription, first), mimetype="text/event-stream")


def _lines(subscription: Subscription, first: Iterable[object]) -> Iterator[str]:
    with subscription:
        yield from map(_line, first)
        while not subscription.closed:
            event = subscription.get(timeout_s=HEARTBEAT_INTERVAL_S)
            yield ": still here\n\n" if event is None else _line(event)


def _line(event: object) -> str:
    return f"data: {json.dumps(event, separators=(',', ':'))}\n\n"
