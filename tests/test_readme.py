"""What the pages for newcomers name is there."""

import re
from pathlib import Path

import click
import pytest

from pinel_desktop.cli import main

ROOT = Path(__file__).parents[1]
PAGES = ["README.md", "README.pt-BR.md", "CONTRIBUTING.md", "ARCHITECTURE.md"]
TARGETS = set(re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE))


def text_of(page: str) -> str:
    return (ROOT / page).read_text("utf-8")


@pytest.mark.parametrize("page", PAGES)
def test_links_and_pictures_lead_somewhere(page: str) -> None:
    links = re.findall(r"\]\(([^)#]+)\)", text_of(page))
    assert [link for link in links if "://" not in link and not (ROOT / link).exists()] == []


@pytest.mark.parametrize("page", PAGES)
def test_make_targets_exist(page: str) -> None:
    assert set(re.findall(r"(?:`|^ {4})make ([a-z]+)", text_of(page), re.MULTILINE)) <= TARGETS


@pytest.mark.parametrize("page", PAGES)
def test_commands_of_pinel_exist(page: str) -> None:
    with click.Context(main) as context:
        known = set(main.list_commands(context))
    named = set(re.findall(r"`pinel ([a-z]+)", text_of(page)))
    assert named <= known | {"engine", "app"}


def test_both_readmes_begin_with_the_same_two_commands() -> None:
    for page in ("README.md", "README.pt-BR.md"):
        first = re.search(r"```sh\n(.*?)```", text_of(page), re.DOTALL)
        assert first is not None
        assert [line.split("#")[0].strip() for line in first[1].splitlines()] == [
            "make run",
            "make test",
        ]


def test_every_command_helps() -> None:
    with click.Context(main) as context:
        for name in main.list_commands(context):
            command = main.get_command(context, name)
            assert command is not None
            assert command.get_short_help_str()
            assert all(option.help for option in command.params if isinstance(option, click.Option))
