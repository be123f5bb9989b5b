"""docs/worlds.md against the code."""

import json
import re
from pathlib import Path

from pinel_desktop.messages import SOURCE_LANGUAGE, catalogue
from sim import document, placement
from sim.document import WorldDocument
from sim.floor import COLORS
from sim.parsing import read_world
from sim.world import DEFAULT_BOX_MASS_KG, list_worlds

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "worlds.md").read_text("utf-8")
ROWS = re.findall(r"^\| (`.*?) \| (.*) \|$", PAGE, re.MULTILINE)


def test_the_example_is_read_without_faults() -> None:
    (example,) = re.findall(r"```json\n(.*?)```", PAGE, re.DOTALL)
    reading = read_world(example, robot_radius_m=0.25)
    assert reading.faults == ()
    assert set(json.loads(example)) == set(WorldDocument.model_fields)


def test_every_key_has_a_row_with_its_limits() -> None:
    rows = {key.strip("`"): text for key, text in ROWS}
    assert set(WorldDocument.model_fields) <= set(rows)
    for key, maximum in (("walls", document.MAX_WALLS), ("boxes", document.MAX_BOXES)):
        assert f"at most {maximum} " in rows[key]
    assert f"`mass_kg` ({DEFAULT_BOX_MASS_KG:g})" in rows["boxes"]
    assert all(color in rows["floor"] for color in COLORS)
    assert f"at most {document.MAX_BYTES // 1024} KiB" in PAGE
    assert f"at most {document.MAX_TITLE} characters" in rows["title"]


def test_every_fault_between_parts_is_told() -> None:
    source = Path(placement.__file__).read_text("utf-8")
    codes = set(re.findall(r'"([a-z]+(?:_[a-z]+)+)"', source)) & set(catalogue(SOURCE_LANGUAGE))
    assert len(codes) >= 10
    assert codes <= set(re.findall(r"`(\w+)`", PAGE))


def test_every_world_that_ships_is_told_with_programs_that_there_are() -> None:
    documented = {key.strip("`"): re.findall(r"`(\w+)`", text) for key, text in ROWS}
    for world in list_worlds():
        programs = documented[world["name"]]
        found = [name for name in programs if (ROOT / f"tests/programs/{name}.json").is_file()]
        assert found, world["name"]
