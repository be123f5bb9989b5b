import re
from dataclasses import fields
from pathlib import Path
from typing import get_args

from pinel_desktop.events.model import EVENT_TYPES, EventStamp, RunState
from pinel_desktop.web.models.events import RunEvent

ARCHITECTURE = Path(__file__).parents[2] / "ARCHITECTURE.md"


def test_events_and_their_fields_are_those_of_the_architecture_page() -> None:
    text = ARCHITECTURE.read_text("utf-8")
    section = text[text.index("## Events") : text.index("## HTTP")]
    rows = dict(re.findall(r"^\| `(\w+)` \| (.+) \|$", section, re.MULTILINE))
    assert set(rows) == set(EVENT_TYPES)
    for name, cls in EVENT_TYPES.items():
        mentioned = set(re.findall(r"\w+", " ".join(re.findall(r"`([^`]+)`", rows[name]))))
        assert {field.name for field in fields(cls)} <= mentioned, name


def test_the_described_interface_has_the_same_events_with_the_same_fields() -> None:
    described = {
        get_args(model.model_fields["type"].annotation)[0]: model
        for model in RunEvent.__subclasses__()
    }
    assert set(described) == set(EVENT_TYPES)
    for name, cls in EVENT_TYPES.items():
        own = set(described[name].model_fields) - set(RunEvent.model_fields) - {"type"}
        assert own == {field.name for field in fields(cls)}, name


def test_wire_objects_are_flat_and_numbered() -> None:
    stamp = EventStamp("r")
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
