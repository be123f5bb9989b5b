"""What the README and CONTRIBUTING name exists: targets, commands, options, files, links."""

import re
import subprocess
from itertools import pairwise
from pathlib import Path

import click
import pytest

from pinel_desktop.cli import main
from pinel_desktop.execution.executor import execute
from pinel_desktop.links import open_link
from pinel_desktop.program.python_text import read_python
from pinel_desktop.program.reading import read_document
from scripts.figures import python_imports

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


PATH = re.compile(r"`((?:[\w./-]|\{[\w, -]+\})+(?:/|\.(?:py|tsx?|css|json|sh|npz|spec|png)))`")
# where the paths of a column of the map lie: its text, Python, page
ROOTS: tuple[tuple[Path, ...], ...] = (
    (),
    (ROOT, ROOT / "pinel_desktop"),
    (ROOT / "ui" / "src", ROOT),
)
# the folders that the map covers
COVERED = ("pinel_desktop", "sim", "storage", "packaging", "scripts", "ui/src")


def expanded(path: str) -> list[str]:
    """`a/{b, c}.py` as `a/b.py` and `a/c.py`."""
    braces = re.search(r"\{(.*?)\}", path)
    if braces is None:
        return [path]
    return [path.replace(braces[0], name.strip()) for name in braces[1].split(",")]


def paths_named_in_a_cell(cell: str) -> list[str]:
    """Paths of one cell of ARCHITECTURE.md. A name without a folder lies in the folder of the path before it."""
    paths: list[str] = []
    folder = ""
    for path in (path for listed in PATH.findall(cell) for path in expanded(listed)):
        whole = path if "/" in path or not folder else f"{folder}/{path}"
        folder = whole.rpartition("/")[0]
        paths.append(whole)
    return paths


def files_of_the_map(text: str) -> list[tuple[str, list[Path]]]:
    """Each path that the table names, and the files and folders that it stands for.

    Words in capitals stand for any name: `commands/NAME.py`.
    """
    found = []
    for row in re.findall(r"^\| (.*)\|$", text, re.M):
        for roots, cell in zip(ROOTS, row.split("|"), strict=True):
            for path in paths_named_in_a_cell(cell):
                pattern = re.sub(r"\b[A-Z]{2,}\b", "*", path).rstrip("/")
                found.append((path, [match for root in roots for match in root.glob(pattern)]))
    return found


def unnamed_folders(text: str) -> set[str]:
    """The folders with sources that the table names neither by themselves nor by a file in them."""
    listed = subprocess.run(
        ["git", "ls-files", *COVERED], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout.splitlines()
    folders = {str(Path(file).parent) for file in listed if not file.endswith("/README.md")}
    matches = [match for _, matches in files_of_the_map(text) for match in matches]
    named = {match if match.is_dir() else match.parent for match in matches}
    return folders - {str(folder.relative_to(ROOT)) for folder in named}


def test_every_path_that_the_architecture_names_exists() -> None:
    files = files_of_the_map(text_of("ARCHITECTURE.md"))
    assert len(files) > 500
    assert [path for path, matches in files if not matches] == []


def test_the_architecture_names_every_folder_that_holds_sources() -> None:
    assert unnamed_folders(text_of("ARCHITECTURE.md")) == set()


@pytest.mark.parametrize(
    ("path", "folder"),
    [
        ("`sim/worlds/NAME.json`", "sim/worlds"),
        ("`activities/checks/GROUP/KIND.py`", "pinel_desktop/activities/checks/run"),
        ("`camera/testing/`", "ui/src/camera/testing"),
    ],
)
def test_a_folder_that_the_architecture_does_not_name_is_found(path: str, folder: str) -> None:
    text = text_of("ARCHITECTURE.md")
    assert path in text
    assert folder in unnamed_folders(text.replace(path, ""))


def arrows(diagram: str) -> set[tuple[str, str]]:
    """The arrows of a Mermaid flowchart, from one name in it to another."""
    found = set()
    for line in diagram.splitlines():
        ends = [re.findall(r"(?:^|& )(\w+)", end.strip()) for end in re.split(r" -+> ", line)]
        found |= {(one, other) for left, right in pairwise(ends) for one in left for other in right}
    return found


def folders_of_the_diagram(diagram: str) -> dict[str, str]:
    """Each folder or file named in a box, and the name of the box."""
    return {
        folder.removesuffix(".py"): box
        for box, label in re.findall(r'(\w+)\["(.*?)"\]', diagram)
        for folder in re.findall(r"([a-z]+)(?:/|\.py)", label)
    }


def reachable(edges: set[tuple[str, str]]) -> set[tuple[str, str]]:
    """Each pair of which the second is met by following arrows from the first."""
    longer = edges | {(a, d) for a, b in edges for c, d in edges if b == c}
    return edges if longer == edges else reachable(longer)


def test_the_diagram_of_imports_is_what_the_code_does() -> None:
    """Every arrow is an import, and every import follows arrows; what serves all folders is not drawn."""
    diagram = re.findall(r"```mermaid\nflowchart TD\n(.*?)```", text_of("ARCHITECTURE.md"), re.S)[0]
    boxes = folders_of_the_diagram(diagram)
    assert len(boxes) > 15

    def box(path: str) -> str | None:
        top, _, rest = path.partition("/")
        return boxes.get(rest.partition("/")[0] if top == "pinel_desktop" else top)

    imports = {(box(one), box(other)) for one, other in python_imports()}
    known = {(one, other) for one, other in imports if one and other and one != other}
    drawn = arrows(diagram)
    assert drawn <= known
    assert known <= reachable(drawn)


def test_the_architecture_is_short() -> None:
    lines = text_of("ARCHITECTURE.md").splitlines()
    assert len(lines) <= 150
    assert max(map(len, lines)) <= 300


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


def worked_example(of: str = "") -> list[tuple[str, str]]:
    """The pieces of CONTRIBUTING's examples, all or those of one: a file, and what stands in it."""
    text = text_of("CONTRIBUTING.md")
    if of:
        text = re.split(r"^\*\*", text.split(f"\n**{of}**")[1], flags=re.M)[0]
    return re.findall(r"^ +`([\w/.-]+)`\n +```\w+\n(.*?)^ +```$", text, re.M | re.S)


def unindented(text: str) -> str:
    """Lines without what stands before and after them: an example may be set in farther."""
    return "\n".join(line.strip() for line in text.strip().splitlines())


@pytest.mark.parametrize(
    ("change", "folders"),
    [
        ("A block", ["program", "execution", "blocks", "catalogue", "blocks"]),
        ("A sensor", ["program", "links", "catalogue"]),
        ("A robot", ["robot"]),
        ("A robot link", ["links", "links", "robot", "messages"]),
        (
            "A check kind of an activity",
            ["checks", "checks", "catalogue", "catalogue", "activities"],
        ),
        ("An event", ["events", "execution"]),
        ("A request of the page", ["models", "api", "api"]),
        ("A route and a screen", ["shell", "teacher", "catalogue"]),
        ("A language", ["catalogue", "catalogue", "page", "content"]),
    ],
)
def test_the_example_of_a_change_names_each_place_in_its_order(
    change: str, folders: list[str]
) -> None:
    files = [file for file, _ in worked_example(change)]
    assert len(files) == len(folders)
    for file, folder in zip(files, folders, strict=True):
        assert folder in file.split("/")


def test_the_example_of_a_column_has_three_places() -> None:
    files = [file for file, _ in worked_example("A column that travels between PCs")]
    assert files == [
        "storage/tables/ddl.py",
        "storage/tables/work.py",
        "storage/row_types.py",
    ]


@pytest.mark.parametrize(("file", "piece"), worked_example())
def test_each_piece_of_the_example_stands_in_its_file(file: str, piece: str) -> None:
    assert unindented(piece) in unindented(text_of(file))


def test_the_block_of_the_example_runs_as_it_says() -> None:
    reading = read_python("robot.wait(2)\n")
    assert reading.document is not None
    assert reading.document["commands"] == [{"action": "wait", "seconds": 2.0}]
    program = read_document(reading.document).program
    assert program is not None
    assert execute(program, open_link("sim", world="empty_room")).ended.duration_s == pytest.approx(
        2.0, abs=0.05
    )
