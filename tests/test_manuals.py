"""The manuals: pages of docs/ that the program shows (ui/manual_pages.ts). What they name exists, in each language."""

import re
from pathlib import Path

import click
import pytest

from pinel_desktop.cli import main

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
NAMES = sorted(file.name.removesuffix(".pt-BR.md") for file in DOCS.glob("*.pt-BR.md"))
PAGES = [f"{name}{ending}" for name in NAMES for ending in (".pt-BR.md", ".md")]


def text_of(page: str) -> str:
    return (DOCS / page).read_text("utf-8")


def command_lines(page: str) -> list[list[str]]:
    """The command lines of `pinel` in code of a page, as words without the name."""
    return [
        line.split() for line in re.findall(r"(?:`|^)pinel ([a-z-][^`\n]*)", text_of(page), re.M)
    ]


def test_the_page_shows_all_of_them() -> None:
    listed = (ROOT / "ui" / "manual_pages.ts").read_text("utf-8")
    names = re.search(r"NAMES = \[(.*?)\]", listed, re.DOTALL)
    assert names
    assert sorted(re.findall(r'"(\w+)"', names[1])) == NAMES


@pytest.mark.parametrize("page", PAGES)
def test_every_link_and_picture_leads_to_a_file(page: str) -> None:
    for target in re.findall(r"\]\((?!https?:)([^)#]+)", text_of(page)):
        assert (DOCS / target).is_file(), target


@pytest.mark.parametrize("name", NAMES)
def test_a_page_in_portuguese_leads_to_pages_in_portuguese(name: str) -> None:
    pages = re.findall(r"\]\((\w+)\.md", text_of(f"{name}.pt-BR.md"))
    assert [page for page in pages if page in NAMES] == [name]  # the page itself in English


@pytest.mark.parametrize("page", PAGES)
def test_every_subcommand_named_exists(page: str) -> None:
    named = {line[0] for line in command_lines(page) if line[0].isalpha()}
    assert named <= set(main.list_commands(click.Context(main)))


@pytest.mark.parametrize("page", PAGES)
def test_every_option_named_beside_a_subcommand_exists(page: str) -> None:
    for name, *words in command_lines(page):
        command = main.get_command(click.Context(main), name)
        if isinstance(command, click.Group) and words:
            command = command.get_command(click.Context(command), words[0])
        if command is not None:
            known = {spelling for parameter in command.params for spelling in parameter.opts}
            assert {option for option in words if option.startswith("--")} <= known, name


def test_the_page_to_which_messages_point_has_the_section_that_they_name() -> None:
    assert "\n## Instalar de novo\n" in text_of("install.pt-BR.md")
    assert "\n## Install again\n" in text_of("install.md")
