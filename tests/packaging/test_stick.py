"""The script that installs from a USB stick, with a program in place of apt-get that writes down how it was called."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.packaging.loading import ROOT, load

stick = load("packaging/stick.py")

_FAKE_APT = """#!/bin/sh
for one in "$@"; do echo "argument $one" >>"$CALLS"; done
for one in "$@"; do case "$one" in
    Dir::Etc::SourceList=*) cat "${one#*=}" >>"$CALLS" ;;
esac; done
case " $* " in
    *" --print-uris "*) ;;
    *" install "*) echo installed >>"$CALLS" ;;
esac
echo "${SAID:-}"
exit "${STATUS:-0}"
"""


class Pc:
    """A PC with a stick; `calls` is what apt-get was given, with the list of sources that it would read."""

    def __init__(self, folder: Path) -> None:
        self.stick = folder / "PEN DRIVE" / "PINEL 1º ano 100%"
        self.stick.mkdir(parents=True)
        shutil.copy(ROOT / "packaging" / "stick" / "instalar.sh", self.stick)
        (self.stick / "pinel-desktop_1_amd64.deb").write_bytes(b"package")
        (self.stick / "Packages").touch()
        self._programs = folder / "programs"
        self._programs.mkdir()
        self._write_program("apt-get", _FAKE_APT)
        self._write_program("dpkg", '#!/bin/sh\necho "dpkg $*" >>"$CALLS"\n')
        self._write_program("id", "#!/bin/sh\necho ${UID_OF_TEST:-0}\n")
        self._calls = folder / "calls"
        self._calls.touch()
        self.free(10_000)

    def free(self, free_mb: int) -> None:
        """Leaves so much room on the disk."""
        line = f"/dev/sda1 9 9 {free_mb}000 9% /"
        self._write_program("df", f"#!/bin/sh\necho Filesystem; echo {line!r}\n")

    def install(self, *options: str, **environment: str) -> "subprocess.CompletedProcess[str]":
        path = f"{self._programs}:{os.environ['PATH']}"
        return subprocess.run(
            ["sh", str(self.stick / "instalar.sh"), *options],
            env={"PATH": path, "LANG": "pt_BR.UTF-8", "CALLS": str(self._calls), **environment},
            capture_output=True,
            text=True,
            check=False,
        )

    @property
    def calls(self) -> str:
        return self._calls.read_text("utf-8")

    @property
    def n_installations(self) -> int:
        """How often apt-get was called to install, and not only to ask: `--assume-no` asks nothing in an update."""
        return self.calls.count("installed\n")

    def _write_program(self, name: str, text: str) -> None:
        (self._programs / name).write_text(text, "utf-8")
        (self._programs / name).chmod(0o755)


@pytest.fixture
def pc(tmp_path: Path) -> Pc:
    pc = Pc(tmp_path)
    stick.write_checksums(pc.stick)
    return pc


def test_apt_reads_the_stick_only(pc: Pc) -> None:
    done = pc.install()
    assert done.returncode == 0, done.stderr
    assert done.stdout.endswith("Pronto. O PINEL está no menu, em Educação.\n")
    assert "argument Dir::Etc::SourceParts=/dev/null\n" in pc.calls
    assert "argument install\nargument pinel-desktop\n" in pc.calls
    sources = {line for line in pc.calls.splitlines() if line.startswith("deb ")}
    place = "".join(letter if letter == "/" else _escaped(letter) for letter in str(pc.stick))
    assert sources == {f"deb [trusted=yes] file:{place} ./"}


@pytest.mark.parametrize(("free_mb", "is_enough"), [(863, False), (915, True)])
def test_a_disk_without_room_is_named_before_anything_is_installed(
    free_mb: int, is_enough: bool, pc: Pc
) -> None:
    pc.free(free_mb)
    done = pc.install(SAID="After this operation, 862 MB of additional disk space will be used.")
    assert done.returncode == (0 if is_enough else 1), done.stderr
    said = f"O disco não tem espaço: são precisos 912 MB, e há {free_mb} MB livres."
    assert (said in done.stderr) is not is_enough
    assert pc.n_installations == int(is_enough)


def reseal(folder: Path) -> None:
    (folder / "SHA256SUMS").unlink()
    stick.write_checksums(folder)


def test_an_update_needs_room_for_the_new_program_beside_the_old_one(pc: Pc) -> None:
    pc.free(300)
    index = pc.stick / "Packages"
    index.write_text("Package: other\nInstalled-Size: 9\n\n", "utf-8")
    reseal(pc.stick)
    said = "After this operation, 1,024 kB of additional disk space will be used."
    assert pc.install(SAID=said).returncode == 0
    index.write_text("Package: pinel-desktop\nVersion: 1\nInstalled-Size: 280000\n\n", "utf-8")
    reseal(pc.stick)
    assert "são precisos 330 MB, e há 300 MB livres" in pc.install(SAID=said).stderr
    nothing = "0 upgraded, 0 newly installed, 0 to remove and 0 not upgraded."
    assert pc.install(SAID=nothing).returncode == 0


def test_what_a_power_cut_left_is_configured_first_and_nothing_is_removed(pc: Pc) -> None:
    assert pc.install().returncode == 0
    install = "argument -y\nargument --fix-broken\nargument --no-remove\nargument install\n"
    assert pc.n_installations == 1  # the question about the room changes nothing
    assert pc.calls.index("dpkg --configure -a\n") < pc.calls.index(install)


def test_the_kiosk_session_is_installed_from_the_stick_with_its_option(pc: Pc) -> None:
    done = pc.install("--kiosk")
    assert done.returncode == 0, done.stderr
    wanted = "".join(f"argument {package}\n" for package in ("pinel-desktop", *stick.KIOSK))
    assert f"argument install\n{wanted}" in pc.calls


@pytest.mark.parametrize("is_built", [True, False])
def test_the_installer_for_windows_is_on_the_stick_if_it_was_built(
    is_built: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files = {name: tmp_path / name for name in ("some.deb", "some.tar.xz", "some-setup.exe")}
    for file in files.values():
        file.write_bytes(b"built")
    if not is_built:
        files["some-setup.exe"].unlink()
    monkeypatch.setattr(stick.deb, "deb_path", lambda: files["some.deb"])
    monkeypatch.setattr(stick.portable, "portable_path", lambda: files["some.tar.xz"])
    monkeypatch.setattr(stick.nsis, "installer_path", lambda: files["some-setup.exe"])
    monkeypatch.setattr(stick, "write_index", lambda folder: None)
    stick.begin(tmp_path / "stick")
    assert (tmp_path / "stick" / "some-setup.exe").is_file() is is_built
    assert (tmp_path / "stick" / "instalar.sh").is_file()


def _escaped(letter: str) -> str:
    return "".join(f"%{byte:02x}" for byte in letter.encode())


def test_packages_of_this_system_are_used_if_the_stick_has_them(pc: Pc) -> None:
    codename = subprocess.run(
        ["sh", "-c", ". /etc/os-release; echo $VERSION_CODENAME"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout.strip()
    assert codename
    assert f"pacotes para este sistema ({codename})" in pc.install().stdout
    (pc.stick / codename).mkdir()
    assert "pacotes para este sistema" not in pc.install().stdout
    assert f"/{_escaped(codename)} ./\n" in pc.calls


def test_a_damaged_file_is_found_before_anything_is_installed(pc: Pc) -> None:
    (pc.stick / "pinel-desktop_1_amd64.deb").write_bytes(b"pakcage")
    done = pc.install()
    assert done.returncode == 1
    assert "Um arquivo do pendrive está danificado ou falta." in done.stderr
    assert pc.calls == ""


def test_a_failed_installation_is_not_called_done(pc: Pc) -> None:
    done = pc.install(STATUS="100")
    assert done.returncode != 0
    assert "Pronto" not in done.stdout


def test_an_ordinary_user_reads_what_to_type(pc: Pc) -> None:
    done = pc.install(UID_OF_TEST="1000", LANG="es_AR.UTF-8")
    assert done.returncode == 1
    assert "Escriba: sudo sh" in done.stderr
    assert pc.calls == ""
