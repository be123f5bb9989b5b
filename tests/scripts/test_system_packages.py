"""scripts/system-packages.sh on PCs of all kinds, made of stand-ins for dpkg-query, apt-get, sudo and id."""

import os
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "system-packages.sh"
RUN = [
    "python3",
    "python3-venv",
    "ca-certificates",
    "python3-gi",
    "gir1.2-gtk-3.0",
    "gir1.2-webkit2-4.1",
]


class FakePc:
    """A folder of programs that stand in for the system's, and note how they are called."""

    def __init__(self, folder: Path) -> None:
        self.bin = folder / "bin"
        self.bin.mkdir()
        self.calls_file = folder / "calls"
        self.state = folder / "installed"
        self.lists = folder / "lists"
        self.lists.mkdir()
        (self.lists / "main_Packages").touch()
        self.os_release = folder / "os-release"
        self.os_release.write_text("VERSION_CODENAME=bookworm\n", "utf-8")
        self.program("dpkg-query", f'cat "{self.state}"')
        self.program("apt-cache", "exit 1")
        self.apt("")
        self.user_id(0)
        self.installed()

    def program(self, name: str, body: str) -> None:
        file = self.bin / name
        file.write_text(f'#!/bin/sh\necho "{name} $*" >>"{self.calls_file}"\n{body}\n', "utf-8")
        file.chmod(0o755)

    def apt(self, body: str) -> None:
        self.program("apt-get", body)

    def user_id(self, number: int) -> None:
        self.program("id", f"echo {number}")

    def sudo(self) -> None:
        self.program("sudo", '[ "$1" != -n ] || shift\nexec "$@"')

    def installed(self, *packages: str) -> None:
        lines = [f"installed {name}, " for name in packages]
        self.state.write_text("".join(f"{line}\n" for line in lines), "utf-8")

    def calls(self, program: str) -> list[str]:
        text = self.calls_file.read_text("utf-8") if self.calls_file.exists() else ""
        return [line for line in text.splitlines() if line.startswith(program + " ")]

    def run(
        self, *arguments: str, language: str = "C", path: str = "/usr/bin:/bin"
    ) -> "subprocess.CompletedProcess[str]":
        environment = {
            "PATH": f"{self.bin}:{path}",
            "LANG": language,
            "PINEL_APT_LISTS": str(self.lists),
            "PINEL_OS_RELEASE": str(self.os_release),
        }
        return subprocess.run(
            ["/bin/sh", str(SCRIPT), *arguments],
            cwd=self.bin, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False,
        )  # fmt: skip


@pytest.fixture
def pc(tmp_path: Path) -> FakePc:
    return FakePc(tmp_path)


def test_a_complete_pc_is_left_alone_without_a_word(pc: FakePc) -> None:
    pc.installed(*RUN)
    done = pc.run("run")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert pc.calls("apt-get") == []


def test_what_is_missing_is_named_with_its_reason(pc: FakePc) -> None:
    pc.installed(*RUN[:-1])
    done = pc.run("--dry-run", "run")
    assert done.returncode == 1
    assert done.stdout.splitlines() == [
        "This PC lacks these system packages:",
        "  gir1.2-webkit2-4.1   shows the page in the window",
    ]
    assert pc.calls("apt-get") == []


def test_what_makes_other_systems_is_asked_for_by_the_nightly_tests_only(pc: FakePc) -> None:
    assert "debootstrap" in pc.run("--dry-run", "nightly").stdout
    assert "debootstrap" not in pc.run("--dry-run", "test").stdout


def test_the_words_follow_the_pc_s_language(pc: FakePc) -> None:
    assert "Faltam neste PC" in pc.run("--dry-run", "run", language="pt_BR.UTF-8").stdout
    assert "A este PC le faltan" in pc.run("--dry-run", "run", language="es_ES.UTF-8").stdout


def test_exactly_the_missing_packages_are_installed(pc: FakePc) -> None:
    pc.installed(*RUN[:-2])
    assert pc.run("run").returncode == 0
    (call,) = pc.calls("apt-get")
    assert call.endswith("install -y --no-install-recommends gir1.2-gtk-3.0 gir1.2-webkit2-4.1")


def test_old_lists_are_renewed_first(pc: FakePc) -> None:
    os.utime(pc.lists / "main_Packages", (0, 0))
    assert pc.run("run").returncode == 0
    first, second = pc.calls("apt-get")
    assert first.endswith("update")
    assert " install " in second


def test_a_failed_installation_is_tried_again_with_new_lists(pc: FakePc, tmp_path: Path) -> None:
    once = tmp_path / "once"
    pc.apt(f'case "$*" in *install*) [ -e "{once}" ] || {{ touch "{once}"; exit 100; }} ;; esac')
    assert pc.run("run").returncode == 0
    assert [call.rpartition(" ")[2] for call in pc.calls("apt-get")][1] == "update"


def test_each_package_that_is_ready_is_shown_and_the_rest_of_apt_s_talk_is_not(pc: FakePc) -> None:
    pc.apt('echo "Reading package lists..."; echo "Setting up python3-gi (3.42.2-3) ..."')
    out = pc.run("run").stdout
    assert "\n  python3-gi\n" in out
    assert "Reading" not in out


def test_without_root_sudo_is_used_and_does_not_ask_where_nobody_can_answer(pc: FakePc) -> None:
    pc.user_id(1000)
    pc.sudo()
    assert pc.run("run").returncode == 0
    assert pc.calls("sudo")[0].startswith("sudo -n env DEBIAN_FRONTEND=noninteractive apt-get")


def test_without_root_and_sudo_the_command_to_ask_for_is_said(pc: FakePc, tmp_path: Path) -> None:
    pc.user_id(1000)
    done = pc.run("run", path=str(_tools_without_sudo(tmp_path)))
    assert done.returncode == 1
    assert "apt-get install --no-install-recommends python3 python3-venv" in done.stdout
    assert pc.calls("apt-get") == []


def test_when_apt_cannot_the_command_to_ask_for_is_said(pc: FakePc) -> None:
    pc.apt("exit 100")
    done = pc.run("run")
    assert done.returncode == 1
    assert "apt-get update && apt-get install" in done.stdout


def test_on_other_systems_the_packages_are_named_and_the_set_up_goes_on(
    pc: FakePc, tmp_path: Path
) -> None:
    (pc.bin / "dpkg-query").unlink()
    done = pc.run("run", path=str(_tools_without_sudo(tmp_path)))
    assert done.returncode == 0
    assert "not Debian or Ubuntu" in done.stdout
    assert "  gir1.2-webkit2-4.1\n" in done.stdout


def test_what_another_package_provides_counts_as_installed(pc: FakePc) -> None:
    pc.state.write_text(
        "".join(f"installed real-{name}, {name} (= 1.0)\n" for name in RUN), "utf-8"
    )
    assert pc.run("--dry-run", "run").returncode == 0


def test_a_removed_package_whose_settings_stayed_counts_as_missing(pc: FakePc) -> None:
    pc.installed(*RUN[1:])
    pc.state.write_text(pc.state.read_text("utf-8") + "config-files python3, \n", "utf-8")
    assert "  python3 " in pc.run("--dry-run", "run").stdout


def test_a_pc_without_a_screen_needs_no_window(pc: FakePc) -> None:
    pc.installed("python3", "python3-venv", "ca-certificates")
    assert pc.run("--dry-run", "serve").returncode == 0


FAST_DDS = "libfastrtps-dev"


def test_tests_need_fast_dds_where_apt_has_it(pc: FakePc) -> None:
    pc.program("apt-cache", f'[ "$*" = "show {FAST_DDS}" ]')
    assert f"  {FAST_DDS} " in pc.run("--dry-run", "test").stdout


def test_where_apt_has_another_fast_dds_none_is_needed(pc: FakePc) -> None:
    assert FAST_DDS not in pc.run("--dry-run", "test").stdout


@pytest.mark.parametrize(("release", "is_needed"), [("bookworm", True), ("trixie", False)])
def test_without_package_lists_the_release_tells_whether_apt_will_have_fast_dds(
    pc: FakePc, release: str, is_needed: bool
) -> None:
    (pc.lists / "main_Packages").unlink()
    pc.os_release.write_text(f"VERSION_CODENAME={release}\n", "utf-8")
    assert (FAST_DDS in pc.run("--dry-run", "test").stdout) == is_needed


def test_a_purpose_that_does_not_exist_is_refused(pc: FakePc) -> None:
    assert pc.run("fly").returncode == 2


def _tools_without_sudo(folder: Path) -> Path:
    """The few programs that the script needs, and no others."""
    tools = folder / "tools"
    tools.mkdir()
    for name in (
        "dirname",
        "sed",
        "tr",
        "sort",
        "grep",
        "cut",
        "find",
        "head",
        "mktemp",
        "cat",
        "rm",
        "env",
    ):
        source = next(
            place for place in (Path("/usr/bin", name), Path("/bin", name)) if place.exists()
        )
        (tools / name).symlink_to(source)
    return tools
