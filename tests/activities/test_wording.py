"""Words for pupils: numbers, lengths, and blocks by the labels that they have on the screen."""

import json
import re
from pathlib import Path

import pytest

from pinel_desktop.activities.commands import Command
from pinel_desktop.activities.diagnosis import _FACTS
from pinel_desktop.activities.model import NUMBER_FACTS, TEXT_FACTS
from pinel_desktop.activities.wording import (
    block_label,
    formatted_values,
    interpolate,
    length,
    number,
    short_name,
)
from pinel_desktop.messages import LANGUAGES, catalogue
from pinel_desktop.program.model import action_names

CATALOGUE = Path(__file__).parents[2] / "pinel_desktop" / "messages" / "catalogue"
LABEL = {"conditional_execution": "IF"}


def block(**data: object) -> Command:
    return Command("/commands/0", data, 0)


def shown_labels(language: str) -> dict[str, str]:
    """The texts of the page's blocks."""
    text = (CATALOGUE / language / "page" / "blocks.json").read_text("utf-8")
    return dict(json.loads(text)["blocks"])


def plain(label: str) -> str:
    """A label without icon, values and spaces at its end."""
    return re.sub(r"\s+", " ", re.sub(r"%\d|\{\{\w+\}\}", "·", label)).strip(" ·")


@pytest.mark.parametrize("language", LANGUAGES)
def test_blocks_have_the_labels_that_they_have_on_the_screen(language: str) -> None:
    labels = shown_labels(language)
    names = [*(name for name in action_names() if name != "pen"), "pen_down", "pen_up"]
    for name in names:
        shown = labels[LABEL.get(name, name.upper())]
        assert plain(catalogue(language)[f"block_{name}"]["message"]) == plain(shown)
    for name in ("LEFT", "RIGHT", "STRAIGHT", "AROUND"):
        assert catalogue(language)[f"block_{name.lower()}"]["message"] == labels[name]


@pytest.mark.parametrize("language", LANGUAGES)
def test_values_have_the_words_that_they_have_on_the_screen(language: str) -> None:
    labels = shown_labels(language)
    pairs = {"distance": "DISTANCE_SENSOR", "gesture": "GESTURE_RESULT"}
    for name in ("front", "back", "bumper", "heading", "time", "floor", "distance", "gesture"):
        shown = labels[pairs.get(name, name.upper())]
        assert plain(catalogue(language)[f"value_{name}"]["message"]) == plain(shown)


def test_a_block_is_named_with_its_values_or_without_those_that_are_worked_out() -> None:
    assert block_label(block(action="turn", angle=-90.0), "pt-BR") == "girar à direita 90 °"
    assert block_label(block(action="turn", angle={"op": "/", "args": [360, 5]}), "en") == "turn"
    assert block_label(block(action="repeat", times=4), "es") == "repetir 4 veces"
    red = block(action="pen", down=True, color="red")
    assert block_label(red, "pt-BR") == "abaixar a caneta: vermelho"
    assert block_label(block(action="pen", down=False), "en") == "pen up"
    assert block_label(block(action="while", condition={}), "pt-BR") == "enquanto"
    assert short_name("classify_gestures", "pt-BR") == "ler sinal"


RED = {"op": "==", "args": [{"sensor": "floor"}, "red"]}
NEAR = {"op": "<", "args": [{"sensor": "distance", "direction": "front"}, 0.5]}
NOT_B = {"op": "!=", "args": [{"gesture": "result"}, "B"]}


@pytest.mark.parametrize(
    ("condition", "label"),
    [
        (RED, "repetir até que cor do chão = vermelho"),
        (NEAR, "repetir até que distância à frente (m) < 0,5"),
        (NOT_B, "repetir até que sinal lido ≠ ‘B’"),
        (
            {"op": "and", "args": [RED, {"sensor": "bumper"}]},
            "repetir até que cor do chão = vermelho e bateu em algo",
        ),
        ({"op": "not", "args": [{"sensor": "bumper"}]}, "repetir até que não bateu em algo"),
        ({"op": ">", "args": [{"var": "metros"}, 3.0]}, "repetir até que metros > 3"),
        ({"op": "==", "args": [{"length": {"var": "l"}}, 3.0]}, "repetir até que"),
    ],
)
def test_a_block_with_a_condition_is_named_with_it(condition: object, label: str) -> None:
    assert block_label(block(action="until", condition=condition), "pt-BR") == label


@pytest.mark.parametrize(
    ("metres", "text"),
    [
        (0.0, "0 cm"),
        (0.004, "4 mm"),
        (0.1199, "12 cm"),
        (1.0, "1 m"),
        (1.618, "1,62 m"),
        (-0.5, "−50 cm"),
    ],
)
def test_lengths_have_the_unit_that_a_pupil_would_measure_in(metres: float, text: str) -> None:
    assert length(metres, "pt-BR") == text


def test_numbers_have_sensible_digits() -> None:
    assert number(3.82905218142, "pt-BR") == "3,83"
    assert number(3.0, "en") == "3"
    assert number(-0.0001, "es") == "0"


@pytest.mark.parametrize(
    ("language", "text"), [("pt-BR", "“padaria”"), ("en", "“padaria · bakery”")]
)
def test_a_place_is_named_as_on_its_plate_on_the_floor(language: str, text: str) -> None:
    assert interpolate("“{zone}”", {"zone": "padaria"}, language) == text
    assert formatted_values({"zones": ["meu canto"]}, language) == {"zones": ["meu canto"]}


def test_a_text_that_names_what_there_is_not_stays_as_it_is() -> None:
    assert interpolate("{gap_m} {nothing} {", {"gap_m": 0.12}, "en") == "12 cm {nothing} {"


def test_every_fact_that_a_diagnosis_may_name_is_worked_out() -> None:
    assert set(_FACTS) == NUMBER_FACTS | TEXT_FACTS
