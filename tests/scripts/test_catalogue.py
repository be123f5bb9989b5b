import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.messages import LANGUAGES
from scripts import catalogue

FOLDER = Path(catalogue.__file__).parents[1] / "pinel_desktop" / "messages" / "catalogue"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A copy of the catalogue, to spoil."""
    return Path(shutil.copytree(FOLDER, tmp_path / "catalogue"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_language_is_complete(language: str) -> None:
    assert catalogue.faults(language) == []


@pytest.mark.parametrize(
    ("name", "before", "after", "fault"),
    [
        ("page/page.json", '"home"', '"hom"', "en/page/page.json: “header.home” is missing"),
        ("page/page.json", '"home"', '"hom"', "en/page/page.json: “header.hom” is unknown"),
        ("page/page.json", '"programs_one"', '"programs_few"', "“start.programs_one” is missing"),
        (
            "page/page.json",
            "{{now}}",
            "{{time}}",
            "has the placeholders ['time'] and needs ['now']",
        ),
        ("page/page.json", "Change group", "", "“header.home” is empty"),
        ("run.json", "{{max}}", "{{most}}", "“time_limit.message” has the placeholders"),
        ("page/teacher.json", "“{{text}}”", "it", "“making.criteria.says” has the placeholders []"),
    ],
)
def test_what_a_language_lacks_is_named(
    folder: Path, name: str, before: str, after: str, fault: str
) -> None:
    file = folder / "en" / name
    text = file.read_text("utf-8")
    assert before in text
    file.write_text(text.replace(before, after, 1), "utf-8")
    assert [line for line in catalogue.faults("en", folder) if fault in line]


def test_a_missing_and_an_unknown_file_are_named(folder: Path) -> None:
    (folder / "es" / "page" / "plots.json").rename(folder / "es" / "page" / "graphs.json")
    assert catalogue.faults("es", folder) == [
        "es: the file page/plots.json is missing",
        "es: the file page/graphs.json is unknown",
    ]


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_key_of_the_page_is_in_one_file(language: str) -> None:
    areas: list[dict[str, Any]] = [
        json.loads(file.read_text("utf-8")) for file in (FOLDER / language / "page").glob("*.json")
    ]
    keys = [key for area in areas for key in area]
    assert sorted(keys) == sorted(set(keys))


def test_what_the_file_of_a_language_lacks_is_named(folder: Path) -> None:
    (folder / "fr" / "language.json").write_text('{"name": "Français", "plural": {}}', "utf-8")
    assert catalogue.faults("fr", folder)[:1] == ["fr/language.json: “python” is missing"]


def test_every_key_is_used() -> None:
    assert catalogue.unused() == []


def test_an_unused_key_is_named(folder: Path) -> None:
    for name, text in (
        ("run.json", '"unneeded_words": {},'),
        ("page/page.json", '"unneeded": "",'),
    ):
        file = folder / "pt-BR" / name
        file.write_text(file.read_text("utf-8").replace("{", "{" + text, 1), "utf-8")
    assert catalogue.unused(folder) == ["page/page.json: unneeded", "run.json: unneeded_words"]


def test_every_search_term_belongs_to_a_block() -> None:
    blocks, terms = (
        json.loads((FOLDER / "pt-BR" / "page" / name).read_text("utf-8"))
        for name in ("blocks.json", "search_terms.json")
    )
    assert {kind.upper() for kind in terms["searchTerms"]} <= set(blocks["blocks"])
