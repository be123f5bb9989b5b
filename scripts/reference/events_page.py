"""Generates docs/events.md from the declarations in `pinel_desktop/events`."""

from collections.abc import Mapping
from typing import Any

from pinel_desktop.events.model import StreamEvent as Declared
from pinel_desktop.events.types import APP_EVENTS, RUN_EVENTS
from pinel_desktop.web.models.events import RunEvent, StreamEvent
from scripts.reference.schema_words import field_table

_HEAD = """\
# Events

The engine sends events to the app, and the app sends them to all open pages (`GET /api/stream`). The page replays a run
from its recorded events (`GET /api/runs/{id}/events`). Live and recorded events are the same objects, and the page has
one reducer for both.

This page is made from `pinel_desktop/events/model.py` and `app_events.py` by `python -m scripts.reference`.
Each event is declared there once: wire model, OpenAPI schema and the page's type derive from the declaration. Names in
recorded runs never change.

## Events of a run

Each is one flat JSON object `{"v": 1, "type": ..., "run": ID, "seq": N, "tick": N, ...}`. `seq` counts from 0 within a
run without gaps. `tick` is the 30 Hz tick; the time in s is tick / 30. Poses are in the start frame, in metres and
radians, unless the field says otherwise. `block` is the id of a block, null where the document has none.

Exactly one `run_ended` closes every run. A run that was cut off by a power cut or a kill is closed at the next start of
the app: `run_ended` with state `failed`, reason `interrupted`, and null for unknown figures. When the engine dies, the
app closes the run at once, with reason `engine_lost`, or `real_engine_lost` where it drove a real robot.

Three attributes of a declaration decide how its events are handled:

- **kept**: stored, merged between PCs, and compared when a run is verified. The recorder writes batches once a second;
  what it cannot write, for example on a full disk, it keeps in memory and tries again every 1.5 s.
- **lossy**: the hub may drop it for a page that reads too slowly. It drops nothing else and adds nothing.
- **urgent**: written to the disk at once, because the next event may come much later.

"Optional" fields are absent from runs that earlier releases recorded.
"""
_APP_HEAD = """\
## Events of the app

They occur on the stream only, have neither `seq` nor `tick`, and are not stored. Comment lines keep the stream open
while no event occurs.
"""
_SHAPES = {"StackEntry": "`{function, block}`", "Pose": "`{x_m, y_m, yaw_rad}`"}
_COMMON = ("type", *RunEvent.model_fields)


def text() -> str:
    """The whole page as Markdown."""
    schemas = StreamEvent.model_json_schema(mode="serialization")["$defs"]
    of_runs = [_section(cls, schemas, _COMMON) for cls in RUN_EVENTS.values()]
    of_app = [_section(cls, schemas, ("type",)) for cls in APP_EVENTS.values()]
    parts = [_HEAD, _overview(), *of_runs, _APP_HEAD, *of_app]
    return "\n".join(parts).rstrip() + "\n"


def _overview() -> str:
    rows = [
        f"| [`{name}`](#{name}) | {' | '.join(_traits(cls))} |" for name, cls in RUN_EVENTS.items()
    ]
    return "\n".join(["| type | kept | lossy | urgent |", "|---|---|---|---|", *rows, ""])


def _traits(cls: type[Declared]) -> list[str]:
    return ["yes" if trait else "no" for trait in (cls.is_recorded, cls.lossy, cls.urgent)]


def _section(cls: type[Declared], schemas: Mapping[str, Any], common: tuple[str, ...]) -> str:
    schema = schemas[f"{cls.__name__}Event"]
    table = field_table(schema, lambda name: _SHAPES.get(name, name), common)
    return "\n".join([f"### `{cls.type}`", "", schema["description"], "", *table])
