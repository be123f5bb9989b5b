"""The examples: each runs to its end, in every language, as far and as long as is known of it."""

import json

import pytest

from pinel_desktop.activities import (
    EXAMPLES,
    activity_names,
    example,
    program_of_example,
    start_of,
)
from pinel_desktop.activities.checking import spec_of
from pinel_desktop.messages import LANGUAGES, SOURCE_LANGUAGE
from pinel_desktop.messages.content import texts_by_language
from pinel_desktop.runs.start import start

# path in m, robot time in s: of the first case, by the ideal robot
FIGURES = {
    "flower_of_arcs": (17.59, 56.4),
    "spiral": (27.20, 81.6),
    "vacuum_cleaner": (17.40, 91.1),
    "dice": (1.00, 3.2),
    "snail": (17.59, 35.2),
    "dance_of_signs": (3.14, 11.3),
    "line_follower": (14.20, 97.1),
    "snowflake": (12.80, 125.6),
    "guessing_game": (0.50, 6.2),
    "shy": (5.40, 30.3),
    "board_game": (11.30, 33.8),
    "board_game_alone": (10.89, 33.9),
}


def test_every_example_has_its_figures() -> None:
    assert list(FIGURES) == list(EXAMPLES)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", EXAMPLES)
def test_an_example_runs_to_its_end_as_far_and_as_long_as_known(name: str, language: str) -> None:
    shown = example(name)
    program = program_of_example(name, language)
    ended = start(spec_of(shown, shown.cases[0], program), lambda _tick, _event: None).ended
    path_m, time_s = FIGURES[name]
    assert ended.state == "finished"
    assert round(ended.path_length_m, 2) == path_m
    assert round(ended.duration_s, 1) == time_s


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_example_says_what_it_shows_in_every_language(name: str) -> None:
    shown = example(name)
    assert shown.name == name
    assert shown.story is not None
    for language in LANGUAGES:
        assert shown.title.of(language)
        assert shown.story.of(language).endswith(".")


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_word_for_shipped_programs_occurs_in_one(language: str) -> None:
    programs = [
        *(program_of_example(name, SOURCE_LANGUAGE).document for name in EXAMPLES),
        *(start_of(name, SOURCE_LANGUAGE) for name in activity_names()),
    ]
    shipped = json.dumps(programs, ensure_ascii=False)
    words = texts_by_language("programs")[language]
    assert [one for one in words if json.dumps(one, ensure_ascii=False) not in shipped] == []


def test_the_names_of_a_program_are_in_the_language_also_where_it_calls_a_function() -> None:
    document = start_of("two_teams", "en")
    assert document is not None
    bring = next(one for one in document["functions"] if one["name"] == "bring the mark")
    call = document["commands"][-1]["commands"][0]
    assert (call["function"], list(call["arguments"])) == (bring["name"], bring["parameters"])
