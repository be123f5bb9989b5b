"""CSV files for spreadsheets in three languages."""

import pytest

from pinel_desktop.school.review import spreadsheet
from pinel_desktop.school.review.spreadsheet import Cell


def test_each_language_has_its_signs() -> None:
    rows: list[list[Cell]] = [["a;b", 1.5, 3, True, None, -0.25]]
    for language in ("pt-BR", "es"):
        text = spreadsheet(["Grupo", "s"], rows, language)
        assert text == '\ufeffGrupo;s\r\n"a;b";1,5;3;1;;-0,25\r\n'
    assert spreadsheet(["s"], rows, "en") == "\ufeffs\r\na;b,1.5,3,1,,-0.25\r\n"


@pytest.mark.parametrize("sign", ["=", "+", "-", "@", "\t", "\r", "\uff1d"])
def test_names_are_never_formulas(sign: str) -> None:
    text = spreadsheet([f"{sign}A1"], [[f"{sign}cmd|'/c calc'!A0"]], "en")
    assert f"'{sign}A1" in text
    assert f"'{sign}cmd" in text


def test_quotes_and_lines_stay_within_their_cell() -> None:
    text = spreadsheet(["a"], [['"x"\n;\0']], "es")
    assert text == '\ufeffa\r\n"""x""\n;"\r\n'
