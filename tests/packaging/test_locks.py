"""The lock files hold what pyproject.toml asks for, and nothing else; after a change: make lock."""

import re
import tomllib
from collections.abc import Iterable
from functools import cache
from importlib import metadata

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from tests.packaging.loading import ROOT

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
DIRECT = PROJECT["project"]["dependencies"]
# the extra `yolo` is not in the tools' environment: PyTorch would make it three times as large
EXTRAS = [
    text
    for extra, texts in PROJECT["project"]["optional-dependencies"].items()
    if extra != "yolo"
    for text in texts
]


def group(name: str) -> list[str]:
    """The requirements of a dependency group, with those of the groups that it includes."""
    found: list[str] = []
    for entry in PROJECT["dependency-groups"][name]:
        found += [entry] if isinstance(entry, str) else group(entry["include-group"])
    return found


@cache
def locked(file: str) -> dict[str, str]:
    """Name -> version of a lock file."""
    return dict(re.findall(r"^([\w.-]+)==([\w.]+)", (ROOT / file).read_text("utf-8"), re.M))


LOCKS = {
    "requirements.lock": [*DIRECT, *group("setup")],
    "requirements-dev.lock": [*DIRECT, *EXTRAS, *group("dev")],
    "requirements-node.lock": group("node"),
    "requirements-bench.lock": group("bench"),
    "requirements-bench-alone.lock": group("bench-alone"),
    "requirements-ros.lock": group("ros"),
    "requirements-models.lock": group("models"),
}


@pytest.mark.parametrize("file", LOCKS)
def test_a_lock_holds_every_requirement_in_a_version_that_it_allows(file: str) -> None:
    for text in LOCKS[file]:
        requirement = Requirement(text)
        assert requirement.specifier.contains(locked(file)[canonicalize_name(requirement.name)]), (
            text
        )


def needed_by(requirements: Iterable[str]) -> set[str]:
    """Names of all that these need on any platform, as far as it is installed here."""
    waiting, visited = [Requirement(text) for text in requirements], set()
    while waiting:
        requirement = waiting.pop()
        name = canonicalize_name(requirement.name)
        key = (name, *sorted(requirement.extras))
        if key in visited:
            continue
        visited.add(key)
        for text in _requires(name):
            found = Requirement(text)
            if "extra" not in str(found.marker) or any(
                f'extra == "{extra}"' in str(found.marker) for extra in requirement.extras
            ):
                waiting.append(found)
    return {str(key[0]) for key in visited}


def _requires(name: str) -> list[str]:
    try:
        return metadata.requires(name) or []
    except metadata.PackageNotFoundError:  # for another platform
        return []


def for_every_platform(file: str) -> set[str]:
    """Names that a lock file installs everywhere: only of these it is known here what they need."""
    return set(re.findall(r"^([\w.-]+)==[\w.]+ \\$", (ROOT / file).read_text("utf-8"), re.M))


@pytest.mark.parametrize("file", ["requirements.lock", "requirements-dev.lock"])
def test_a_lock_holds_nothing_that_nothing_needs(file: str) -> None:
    names = for_every_platform(file)
    assert len(names) > 20
    assert names - needed_by(LOCKS[file]) == set()


def test_the_environment_of_the_program_is_part_of_the_developer_s() -> None:
    assert locked("requirements.lock").items() <= locked("requirements-dev.lock").items()
