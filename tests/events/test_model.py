from dataclasses import fields

import pytest

from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import RunState
from pinel_desktop.events.model import StreamEvent as Declared
from pinel_desktop.events.types import APP_EVENTS, LOSSY, RECORDED, RUN_EVENTS, URGENT
from pinel_desktop.web.models.events import RunEvent, StreamEvent, described

DECLARED = RUN_EVENTS | APP_EVENTS


@pytest.mark.parametrize("declared", DECLARED.values(), ids=DECLARED)
def test_every_event_says_what_happened_and_what_each_field_means(declared: type[Declared]) -> None:
    about, meanings = described(declared)
    assert about.partition("\n")[0].endswith(".")
    assert list(meanings) == [field.name for field in fields(declared)]


def test_the_described_interface_has_the_same_events_with_the_same_fields() -> None:
    schema = StreamEvent.model_json_schema(mode="serialization")
    models = schema["discriminator"]["mapping"]
    assert set(models) == set(DECLARED)
    for name, cls in DECLARED.items():
        head = {"type", *(RunEvent.model_fields if name in RUN_EVENTS else ())}
        own = set(schema["$defs"][models[name].rpartition("/")[2]]["properties"]) - head
        assert own == {field.name for field in fields(cls)}, name


def test_a_record_holds_all_that_a_run_reports_but_measurements_and_waits() -> None:
    assert set(RUN_EVENTS) - RECORDED == {"ranges", "countdown", "commands_awaited"}
    assert set(RUN_EVENTS) >= RECORDED


def test_only_samples_may_be_dropped_and_none_of_them_is_waited_for() -> None:
    assert {"telemetry", "ranges", "countdown", "camera_sight"} == LOSSY
    assert not LOSSY & URGENT


def test_wire_objects_are_flat_and_numbered() -> None:
    stamp = EventSequencer("r")
    assert stamp.wire(0, RunState("running")) == {
        "v": 1,
        "type": "run_state",
        "run": "r",
        "seq": 0,
        "tick": 0,
        "state": "running",
        "cause": None,
        "block": None,
        "n_begun": None,
    }
    assert stamp.wire(3, RunState("paused"))["seq"] == 1
