import json
import re
from collections.abc import Iterator
from datetime import datetime
from pathlib import Path
from typing import Any

import pytest

import pinel_desktop
from pinel_desktop.command_name import command_name
from pinel_desktop.messages import (
    LANGUAGES,
    SOURCE_LANGUAGE,
    catalogue,
    describe,
    language_of_system,
)
from pinel_desktop.program.signatures import PARAMETER_SPECS, range_code
from pinel_desktop.program.translation import WRONG_TYPE
from storage.text import local_time

PACKAGE = Path(pinel_desktop.__file__).parent
FOLDER = PACKAGE / "messages" / "catalogue"
AREAS = sorted(
    file.name for file in (FOLDER / SOURCE_LANGUAGE).glob("*.json") if file.name != "language.json"
)
PLACEHOLDER = re.compile(r"\{\{(\w+)\}\}")

ROOT = PACKAGE.parent
TERMS = ROOT / "docs" / "terms.md"
SHORT = {language[:2]: language for language in LANGUAGES}
# names of code in a text, whatever they are made of
CODE = re.compile(r"\{\{\w+(?:, number)?\}\}|--[\w-]+|\bpinel [a-z]+|\w+[._]\w[\w.]*")
# what no pupil reads as a sentence: a language's own name, and what the search understands
NOT_READ = ("language", "search_terms")
# what pupils read in the editor, and how one would speak to one of them alone
TO_PUPILS = ("program.json", "run.json", "python.json", "worlds.json")
TO_ONE = {
    "pt-BR": re.compile(
        r"\b(?:Escolh|Us|Troqu|Escrev|Apert|Ponh|Coloqu|Confir|Corrij|Encaix|Procur|Tir)[ae]\b|\bvocê\b"
    ),
    "es": re.compile(
        r"\b(?:Elige|Usa|Cambia|Escribe|Presiona|Pon|Revisa|Corrige|Encaja|Busca|Quita)\b|\bt[uú]s?\b"
    ),
}


def area(language: str, name: str) -> dict[str, dict[str, str]]:
    entries: dict[str, dict[str, str]] = json.loads((FOLDER / language / name).read_text("utf-8"))
    return entries


@pytest.mark.parametrize("name", AREAS)
def test_every_language_has_the_same_codes_in_the_same_order(name: str) -> None:
    for language in LANGUAGES:
        assert list(area(language, name)) == list(area(SOURCE_LANGUAGE, name))


def test_no_code_stands_in_two_areas() -> None:
    codes = [code for name in AREAS for code in area(SOURCE_LANGUAGE, name)]
    assert sorted(codes) == sorted(set(codes))


def test_a_code_stands_on_one_line() -> None:
    for file in (FOLDER / language / name for language in LANGUAGES for name in AREAS):
        lines = file.read_text("utf-8").splitlines()
        assert len(lines) == len(json.loads("\n".join(lines))) + 2, file


@pytest.mark.parametrize("code", sorted(catalogue(SOURCE_LANGUAGE)))
def test_every_code_has_words_in_every_language_with_the_same_values(code: str) -> None:
    entry = {language: catalogue(language)[code] for language in LANGUAGES}
    assert all(part(texts, "message").strip() for texts in entry.values())
    # good news and labels need no remedy, but then in no language
    assert len({bool(part(texts, "remedy").strip()) for texts in entry.values()}) == 1
    used = [set(PLACEHOLDER.findall(" ".join(texts.values()))) for texts in entry.values()]
    assert all(values == used[0] for values in used)


def part(texts: dict[str, str], name: str) -> str:
    """A part of a message in its general form."""
    return texts[name] if name in texts else texts[f"{name}_other"]


@pytest.mark.parametrize(
    ("language", "n", "message"),
    [
        ("pt-BR", 1, "O PIN foi digitado errado 1 vez. Espere 1 segundo e tente de novo."),
        ("pt-BR", 3, "O PIN foi digitado errado 3 vezes. Espere 3 segundos e tente de novo."),
        ("en", 1, "The PIN was wrong 1 time. Wait 1 second and try again."),
        ("en", 0, "The PIN was wrong 0 times. Wait 0 seconds and try again."),
    ],
)
def test_a_message_has_the_form_of_its_count(language: str, n: int, message: str) -> None:
    assert describe("pin_wait", {"failed": n, "seconds": n}, language).line == message


def test_each_part_of_a_message_counts_its_own_number() -> None:
    line = describe("pin_wait", {"failed": 5, "seconds": 1}, "es").line
    assert line == "El PIN se escribió mal 5 veces. Espere 1 segundo y pruebe de nuevo."


def refused_terms() -> list[tuple[str, str]]:
    """The words of the column "Not" of docs/terms.md, each with its language."""
    found, is_read = [], False
    for line in TERMS.read_text("utf-8").splitlines():
        cell = line[1:-1].rpartition("|")[2].strip() if line.startswith("|") else None
        if cell in ("Not", None):
            is_read = cell == "Not"
        elif is_read and cell and not cell.startswith("---"):
            for part in cell.split("; "):
                short, _, texts = part.partition(": ")
                found += [(SHORT[short], term) for term in texts.split(", ")]
    return found


def refusal(term: str) -> re.Pattern[str]:
    """What a word of the column "Not" matches; the head of docs/terms.md says how."""
    whole = re.fullmatch(r"\[(.+)\]", term)
    stem = re.escape(whole[1] if whole else term).replace(r"\*", r"\w*")
    pattern = f"^{stem}$" if whole else rf"(?<!\w){stem}(?!\w)"
    return re.compile(pattern, 0 if term.isupper() else re.IGNORECASE)


def refused_texts(texts: dict[str, str], language: str) -> dict[str, str]:
    """Those of the texts that have a word which docs/terms.md refuses in their language."""
    refused = [refusal(term) for of, term in refused_terms() if of == language]
    messages = {place: CODE.sub(" ", text) for place, text in texts.items()}
    return {
        place: texts[place]
        for place, text in messages.items()
        if any(one.search(text) for one in refused)
    }


def leaves(node: Any, place: str = "") -> Iterator[tuple[str, str]]:
    """All texts of a file of the catalogue, each with its place."""
    if isinstance(node, str):
        yield place, node
    else:
        for key, one in node.items() if isinstance(node, dict) else enumerate(node):
            yield from leaves(one, f"{place}/{key}")


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_thing_is_called_by_its_one_word(language: str) -> None:
    files = [file for file in (FOLDER / language).rglob("*.json") if file.stem not in NOT_READ]
    texts = {
        f"{file.stem}{place}": text
        for file in files
        for place, text in leaves(json.loads(file.read_text("utf-8")))
    }
    assert len(texts) > 1000
    assert refused_texts(texts, language) == {}


@pytest.mark.parametrize(
    "page", [ROOT / "README.pt-BR.md", *sorted((ROOT / "docs").glob("*.pt-BR.md"))], ids=str
)
def test_pages_in_portuguese_call_it_so_too(page: Path) -> None:
    prose = re.sub(r"```.*?```|`[^`]*`|\]\([^)]*\)", " ", page.read_text("utf-8"), flags=re.DOTALL)
    lines = {str(number): line for number, line in enumerate(prose.splitlines(), 1)}
    assert refused_texts(lines, "pt-BR") == {}


@pytest.mark.parametrize(("language", "term"), refused_terms())
def test_each_word_that_the_page_of_terms_refuses_is_found_in_a_text(
    language: str, term: str
) -> None:
    bare = term.strip("[]").replace("*", "")
    messages = bare if term.startswith("[") else f"– {bare}, –"
    assert refused_texts({"here": messages}, language) == {"here": messages}
    assert refused_texts({"here": f"x{bare}"}, language) == {}


def test_names_of_code_are_no_words() -> None:
    messages = "Use robot.gesture_result, --gestures or “pinel gestures train”: {{gesture}}."
    assert refused_texts({"here": messages}, "en") == {}
    assert refused_texts({"here": "A gesture."}, "en") == {"here": "A gesture."}
    assert refused_texts({"here": "Um sinal de Libras."}, "pt-BR") == {}


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_command_to_type_stands_in_quotation_marks(language: str) -> None:
    messages = {code: " ".join(texts.values()) for code, texts in catalogue(language).items()}
    bare = re.compile(
        r"`|(?<!“)(?<!«\u00a0)\{\{command\}\}|\bpinel (?:doctor|export|merge|pin|run|runs|serve)\b"
    )
    assert {code: text for code, text in messages.items() if bare.search(text)} == {}


@pytest.mark.parametrize("language", sorted(TO_ONE))
def test_pupils_are_spoken_to_as_a_group(language: str) -> None:
    entries = [entry for name in TO_PUPILS for entry in area(language, name).values()]
    remedies = [part(entry, "remedy") for entry in entries]
    assert [text for text in remedies if TO_ONE[language].search(text)] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_paths_and_commands_are_in_the_details_and_not_in_the_remedy(language: str) -> None:
    remedies = {
        code: part(texts, "remedy")
        for code, texts in catalogue(language).items()
        if "details" in texts
    }
    assert len(remedies) > 20
    technical = re.compile(r"\{\{(?:path|folder|name|problem)\}\}|--|\{\{command\}\}")
    assert {code: text for code, text in remedies.items() if technical.search(text)} == {}
    full = describe("disk_full", {"path": "/a/b.db"}, language)
    assert "/a/b.db" in full.details
    assert full.line == f"{full.message} {full.remedy} {full.details}"


def test_every_code_that_the_program_raises_has_words() -> None:
    raised = re.compile(
        r"(?:PinelError|RunFailureError|StoreError|WorldError|Fault|PydanticCustomError|_add)\(\s*\"(\w+)\""
        r"|append\(\(\"(\w+)\", "
    )
    sources = [
        *PACKAGE.rglob("*.py"),
        *(PACKAGE.parent / "sim").rglob("*.py"),
        *(PACKAGE.parent / "storage").rglob("*.py"),
    ]
    found = [pair for source in sources for pair in raised.findall(source.read_text("utf-8"))]
    codes = {code for pair in found for code in pair if code}
    assert (
        "distance_out_of_range" not in codes
    )  # made from the parameter's name, so it is checked below
    assert codes - set(catalogue(SOURCE_LANGUAGE)) == set()
    assert [code for code in codes if not part(catalogue(SOURCE_LANGUAGE)[code], "remedy")] == []


def test_every_range_in_the_language_has_words() -> None:
    bounded = [
        (name, t) for (_, name), t in PARAMETER_SPECS.items() if {t.ge, t.gt, t.le} != {None}
    ]
    codes = {range_code(name, spec) for name, spec in bounded}
    codes |= {f"wrong_type_{kind}" for kind in WRONG_TYPE.values()}
    assert codes <= set(catalogue(SOURCE_LANGUAGE))


def test_values_are_put_in_literally_whatever_they_hold() -> None:
    nasty = "{value} {0.__class__} %s {allowed}"
    texts = describe("unknown_action", {"value": nasty, "allowed": ["a", "b"]}, "en")
    assert nasty in texts.message
    assert "a, b" in texts.remedy


def test_numbers_have_the_decimal_sign_of_their_language_and_long_texts_are_cut() -> None:
    params = {"value": 100.5, "min": 0, "max": 100.0}
    assert "100,5" in describe("distance_out_of_range", params, "pt-BR").message
    assert "100.5" in describe("distance_out_of_range", params, "en").message
    assert "to 100." in describe("distance_out_of_range", params, "en").remedy
    assert len(describe("unknown_action", {"value": "x" * 999, "allowed": []}, "en").message) < 200


@pytest.mark.parametrize(
    ("language", "shown"),
    [
        ("pt-BR", "14/11/2026 às 13:30"),
        ("en", "2026-11-14 13:30"),
        ("es", "14/11/2026 a las 13:30"),
    ],
)
def test_moments_are_written_as_in_their_language(language: str, shown: str) -> None:
    moment = local_time(datetime(2026, 11, 14, 13, 30).astimezone())
    assert shown in describe("version_damaged", {"time": moment}, language).message
    assert moment in describe("unknown_action", {"value": moment}, language).message


@pytest.mark.parametrize("name", ["path", "folder", "file"])
def test_the_place_of_a_file_is_told_whole(name: str) -> None:
    place = "C:\\Users\\Laboratório de Informática\\" + "Turma 9B\\" * 20 + "programa.json"
    placeholder = "{{" + name + "}}"
    codes = [
        code for code, texts in catalogue("es").items() if placeholder in part(texts, "message")
    ]
    assert codes
    for code in codes:
        assert place in describe(code, {name: place}, "es").message


@pytest.mark.parametrize(
    ("environment", "language"),
    [
        ({"LANG": "en_US.UTF-8"}, "en"),
        ({"LANG": "es_AR.UTF-8", "PINEL_LANG": "pt"}, "pt-BR"),
        ({"LC_ALL": "C", "LANG": "pt_BR.UTF-8"}, "pt-BR"),
        ({"LANG": "C"}, "pt-BR"),
        ({}, "pt-BR"),
    ],
)
def test_language_follows_the_system_and_is_portuguese_otherwise(
    monkeypatch: pytest.MonkeyPatch, environment: dict[str, str], language: str
) -> None:
    for variable in ("PINEL_LANG", "LC_ALL", "LC_MESSAGES", "LANG"):
        monkeypatch.delenv(variable, raising=False)
    for variable, value in environment.items():
        monkeypatch.setenv(variable, value)
    assert language_of_system() == language


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_was_done_of_a_motion_is_said_without_the_sign_of_its_side(language: str) -> None:
    turn = {"done": -77.0, "amount": -180.0, "unit": "°"}
    message = describe("blocked", turn, language).message
    assert "77 °" in message
    assert "-" not in message
    beside = describe("blocked_beside", {**turn, "away": 0.5}, language).message
    assert "180" not in beside


def test_a_measured_length_has_two_decimals_and_a_number_of_the_program_stays_as_written() -> None:
    motion = {"done": 3.768, "amount": 9.125, "unit": "m"}
    message = describe("blocked", motion, "pt-BR").message
    assert "3,77 m" in message
    assert "9,125 m" in message


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_refused_pin_names_no_command_of_a_terminal(language: str) -> None:
    assert command_name() not in describe("pin_wrong", {}, language).line
