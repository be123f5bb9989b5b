"""The hub: every reader gets everything in order, a slow one loses telemetry only."""

import threading
from typing import Any

from pinel_desktop.events import hub as hub_module
from pinel_desktop.events.hub import Hub, Subscription


def sample(n: int) -> dict[str, Any]:
    return {"type": "telemetry", "n": n}


def block(n: int) -> dict[str, Any]:
    return {"type": "block_started", "n": n}


def waiting(reader: Subscription) -> list[int]:
    found = []
    while (event := reader.get(timeout_s=0)) is not None:
        found.append(event["n"])
    return found


def test_every_reader_gets_every_event_in_order() -> None:
    hub = Hub()
    first, second = hub.subscribe(), hub.subscribe()
    for n in range(5):
        hub.publish(sample(n))
    assert waiting(first) == waiting(second) == [0, 1, 2, 3, 4]


def test_a_reader_gets_what_was_published_since_it_came_and_nothing_after_it_left() -> None:
    hub = Hub()
    hub.publish(block(0))
    with hub.subscribe() as reader:
        hub.publish(block(1))
    hub.publish(block(2))
    assert waiting(reader) == [1]


def test_a_slow_reader_loses_the_oldest_telemetry_and_nothing_else() -> None:
    hub = Hub(capacity=3)
    reader = hub.subscribe()
    hub.publish(block(100))
    for n in range(10):
        hub.publish(sample(n))
        if n % 4 == 0:
            hub.publish(block(200 + n))
    assert waiting(reader) == [100, 200, 204, 7, 8, 208, 9]


def test_a_slow_reader_loses_what_sensors_measured_too() -> None:
    hub = Hub(capacity=2)
    reader = hub.subscribe()
    for n in range(5):
        hub.publish({"type": "ranges", "n": n})
        hub.publish(block(100 + n))
    assert waiting(reader) == [100, 101, 102, 3, 103, 4, 104]


def test_a_reader_that_is_gone_for_good_is_cut_off(monkeypatch: Any) -> None:
    monkeypatch.setattr(hub_module, "_LIMIT", 10)
    hub = Hub()
    reader = hub.subscribe()
    for n in range(30):
        hub.publish(block(n))
    assert reader.closed
    assert waiting(reader) == []


def test_a_waiting_reader_is_woken_when_the_hub_closes() -> None:
    hub = Hub()
    reader = hub.subscribe()
    got: list[object] = []
    thread = threading.Thread(target=lambda: got.append(reader.get(timeout_s=30)))
    thread.start()
    hub.close()
    thread.join(timeout=5)
    assert got == [None]
    assert hub.subscribe().closed


def test_what_waited_when_the_hub_closed_can_still_be_read() -> None:
    hub = Hub()
    reader = hub.subscribe()
    hub.publish(block(1))
    hub.close()
    assert not reader.closed
    assert waiting(reader) == [1]
    assert reader.closed
