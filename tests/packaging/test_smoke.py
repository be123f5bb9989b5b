"""The judge of the smoke test is not to be lenient."""

import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.packaging.loading import load

smoke = load("packaging/smoke.py")


def healthy() -> dict[str, Any]:
    return {
        "ok": True,
        "window": {"backend": "gtk", "ready_s": 1.8},
        "run": {"state": "finished", "closing_error_m": 1e-15, "duration_s": 15.8},
        "judged": True,
        "signs": ["B", "A"],
        "versions": {"sqlite": "3.53.0"},
        "store": {"telemetry_sha256": "c7e0"},
    }


def test_a_healthy_answer_has_no_fault() -> None:
    assert smoke.faults_of(healthy()) == []


def test_an_empty_answer_is_faulty_in_everything() -> None:
    assert len(smoke.faults_of({})) == 10


@pytest.mark.parametrize(
    ("part", "key", "value"),
    [
        ("window", "backend", "browser"),
        ("run", "state", "failed"),
        ("run", "closing_error_m", 0.001),
        ("run", "duration_s", 24.0),
        ("store", "telemetry_sha256", None),
    ],
)
def test_one_wrong_value_is_found(part: str, key: str, value: object) -> None:
    found = healthy()
    found[part][key] = value
    assert smoke.faults_of(found) == [f"{part}.{key}"]


def test_windows_has_another_window_and_the_sqlite_of_python() -> None:
    found = healthy()
    found["window"]["backend"] = "edgechromium"
    found["versions"]["sqlite"] = "3.45.3"
    assert smoke.faults_of(found, "win32") == []
    assert smoke.faults_of(found, "linux") == ["window.backend", "versions.sqlite"]


def test_a_run_that_was_not_judged_is_found() -> None:
    assert smoke.faults_of({**healthy(), "judged": False}) == ["judged"]


def test_signs_that_were_not_seen_are_found() -> None:
    assert smoke.faults_of({**healthy(), "signs": ["B"]}) == ["signs"]


def package_with(folder: Path, *files: str) -> Path:
    for name in files:
        file = folder / "_internal" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
    return folder


def test_python_and_the_libraries_of_wheels_may_ship(tmp_path: Path) -> None:
    package = package_with(
        tmp_path,
        "libpython3.11.so.1.0",
        "numpy.libs/libgfortran-040039e1-0352e75f.so.5.0.0",
        "opencv_python_headless.libs/libssl-28bef1ac.so.1.1",
        "pymunk/_chipmunk.abi3.so",
    )
    assert smoke.library_faults(package) == []


def test_a_link_may_not_ship(tmp_path: Path) -> None:
    library = "opencv_python_headless.libs/libssl-28bef1ac.so.1.1"
    package = package_with(tmp_path, library)
    (package / "_internal" / "libssl-28bef1ac.so.1.1").symlink_to(library)
    assert smoke.library_faults(package) == [
        "_internal/libssl-28bef1ac.so.1.1 is a link, and the file system of a USB stick may have none"
    ]


SHARED_WITH_WEBKIT = (
    *("libstdc++.so.6", "libgcc_s.so.1", "libz.so.1", "libexpat.so.1", "libffi.so.8"),
    *("liblzma.so.5", "libbz2.so.1.0", "libuuid.so.1", "libsqlite3.so.0"),
    *("libssl.so.3", "libcrypto.so.3"),
)


@pytest.mark.parametrize("name", SHARED_WITH_WEBKIT)
@pytest.mark.parametrize("folder", ["", "numpy.libs/"])
def test_a_library_that_webkit_loads_too_may_not_ship(
    tmp_path: Path, folder: str, name: str
) -> None:
    faults = smoke.library_faults(package_with(tmp_path, folder + name))
    assert faults == [
        f"_internal/{folder}{name} ships, and would take the place of the one that WebKit needs"
    ]


@pytest.mark.parametrize("name", ["libgnutls.so.30", "libzstd.so.1", "libpythonic.so.1"])
def test_a_library_of_the_system_that_nobody_has_looked_at_is_named(
    tmp_path: Path, name: str
) -> None:
    faults = smoke.library_faults(package_with(tmp_path, name))
    assert faults == [
        f"_internal/{name} ships, and packaging/system-libraries.txt does not name it"
    ]


@pytest.mark.parametrize(
    ("place", "is_outside"),
    [
        (".local/share/pinel/pinel.db", False),
        (".local/share/pinel/logs/app.log", False),
        (".cache/gtk-3.0/compose/a.cache", False),
        (".cache/Microsoft/DeveloperTools/.onnxruntime/deviceid", True),
        (".local/share/other/file", True),
        ("Desktop/file", True),
    ],
)
def test_files_outside_the_data_folder_are_found(place: str, is_outside: bool) -> None:
    home = Path("/home/nobody")
    assert smoke.is_outside(home / place, home) is is_outside


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_a_process_of_the_package_that_still_runs_is_found(tmp_path: Path) -> None:
    program = tmp_path / "package" / "pinel"
    program.parent.mkdir()
    shutil.copy("/usr/bin/sleep", program)
    with subprocess.Popen([program, "60"]) as process:
        faults = smoke.leftover_faults(program.parent, tmp_path / "home")
        process.kill()
    assert faults == [f"still runs: {process.pid}"]
    assert smoke.leftover_faults(program.parent, tmp_path / "home") == []
