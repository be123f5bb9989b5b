"""The sentence about 50 robots."""

import pytest

from pinel_desktop.cloud.sentence import sentence_of
from pinel_desktop.sweep import Row, summary_of, together

DOCUMENT: dict[str, list[object]] = {"commands": []}


def rows(*passed: bool) -> list[Row]:
    return [
        Row(index, "", "", index, cause=None if well else "check", end=(0.0, 0.0, 0.0))
        for index, well in enumerate(passed)
    ]


@pytest.mark.parametrize(
    ("passed", "language", "says"),
    [
        ((False, False), "pt-BR", "Nenhum dos 2 robôs cumpre a missão."),
        ((False, True), "pt-BR", "1 de 2 robôs cumpre a missão."),
        ((True, True), "pt-BR", "2 de 2 robôs cumprem a missão."),
        ((False, False), "en", "None of the 2 robots passes the mission."),
        ((False, False), "es", "Ninguno de los 2 robots cumple la misión."),
        ((False, False), "fr", "Aucun des 2 robots ne réussit la mission."),
    ],
)
def test_it_says_how_many_in_the_words_of_that_number(
    passed: tuple[bool, ...], language: str, says: str
) -> None:
    text = sentence_of(summary_of(rows(*passed)), DOCUMENT, language, is_judged=True)
    assert text.startswith(says)


def test_without_a_mission_the_good_ones_end_where_most_of_them_end() -> None:
    few = [Row(index, "", "", index, end=(x, 0.0, 0.0)) for index, x in enumerate((0.0, 0.0, 0.5))]
    assert [row.seed for row in together(few)] == [0, 1]
    text = sentence_of(summary_of(few), DOCUMENT, "pt-BR", is_judged=False)
    assert text.startswith("2 de 3 robôs param")
