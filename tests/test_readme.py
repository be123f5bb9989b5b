"""What the README and CONTRIBUTING name exists: targets, commands, options, files, links."""

import re
from pathlib import Path

import click
import pytest

from pinel_desktop.cli import main

ROOT = Path(__file__).resolve().parents[1]
PAGES = ("README.md", "README.pt-BR.md", "CONTRIBUTING.md")


def text_of(page: str) -> str:
    return (ROOT / page).read_text("utf-8")


def targets() -> set[str]:
    return set(re.findall(r"^([a-z]+):.*##", text_of("Makefile"), re.M))


@pytest.mark.parametrize("page", PAGES)
def test_every_make_target_named_exists(page: str) -> None:
    named = set(re.findall(r"(?:`|^)make ([a-z]+)", text_of(page), re.M))
    assert named
    assert named <= targets()


@pytest.mark.parametrize("page", PAGES)
def test_every_subcommand_named_exists(page: str) -> None:
    named = set(re.findall(r"`(?:\.venv/bin/)?pinel ([a-z]+)", text_of(page)))
    assert named <= set(main.list_commands(click.Context(main)))


@pytest.mark.parametrize("page", PAGES)
def test_every_option_named_beside_a_subcommand_exists(page: str) -> None:
    for name, option in re.findall(
        r"`(?:\.venv/bin/)?pinel ([a-z]+)[^`]*? (--[a-z-]+)", text_of(page)
    ):
        command = main.get_command(click.Context(main), name)
        assert command is not None
        assert option in {spelling for parameter in command.params for spelling in parameter.opts}


@pytest.mark.parametrize("page", PAGES)
def test_every_link_and_picture_leads_to_a_file(page: str) -> None:
    for target in re.findall(r"\]\(([^)#]+)\)", text_of(page)):
        assert (ROOT / target).is_file(), target


@pytest.mark.parametrize("page", PAGES)
def test_every_folder_named_exists(page: str) -> None:
    for folder in re.findall(
        r"`((?:pinel_desktop|ui|tests|sim|packaging|scripts)/[\w/.-]*/)`", text_of(page)
    ):
        assert (ROOT / folder).is_dir(), folder


def test_both_readmes_have_the_same_two_commands_first() -> None:
    first = [re.findall(r"^make \w+", text_of(page), re.M)[:2] for page in PAGES[:2]]
    assert first == [["make run", "make test"]] * 2


def test_every_target_is_explained_by_make_itself() -> None:
    phony = re.search(r"^\.PHONY: (.*)$", text_of("Makefile"), re.M)
    assert phony is not None
    assert {name for name in phony[1].split() if "-" not in name} == targets()


def test_ci_does_what_make_test_does() -> None:
    assert "exec make test" in text_of(".ci/run")
    assert (ROOT / ".ci" / "run").stat().st_mode & 0o111
