"""The package in systems older and newer than the one that built it. (packaging/trial.py makes and enters them.)"""

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tests.packaging.loading import load
from tests.packaging.test_deb import built, program

__all__ = ["program"]  # a fixture
smoke = load("packaging/smoke.py")
systems = load("packaging/systems.py")
trial = load("packaging/trial.py")


def found(**changed: object) -> dict[str, Any]:
    """What in_system.py prints if all is well."""
    window = {"about": "window", "code": "doctor_window_ok"}
    return {
        **trial.EXPECTED,
        "doctor": json.dumps({"findings": [window]}),
        "kiosk_s": 60.0,
        "smoke_s": 90.0,
        "settings": '{"pinel_language": "es"}',
        "sent_to": [],
        **changed,
    }


def test_a_package_that_works_has_no_fault() -> None:
    assert trial.faults_of(found()) == []


def test_a_program_that_prints_nothing_did_not_start() -> None:
    assert trial.faults_of(found(doctor="")) == ["the doctor: "]


def test_a_doctor_that_finds_no_window_is_a_fault() -> None:
    doctor = {"findings": [{"about": "window", "code": "doctor_window_failed"}]}
    faults = trial.faults_of(found(doctor=json.dumps(doctor)))
    assert faults == ["doctor: doctor_window_failed"]


@pytest.mark.parametrize("name", trial.EXPECTED)
def test_each_result_is_judged(name: str) -> None:
    assert trial.faults_of(found(**{name: "other"})) == [f"{name}: other"]


@pytest.mark.parametrize(
    ("changed", "fault"),
    [
        ({"kiosk_s": 181}, "kiosk_s: 181"),
        ({"smoke_s": 181}, "smoke_s: 181"),
        ({"settings": "{}"}, "the set-up file is not used"),
        ({"sent_to": ["192.0.2.1"]}, "sent to 192.0.2.1"),
    ],
)
def test_times_settings_and_addresses_are_judged(changed: dict[str, object], fault: str) -> None:
    assert trial.faults_of(found(**changed)) == [fault]


def test_addresses_off_loopback_are_found_in_the_trace() -> None:
    trace = """
    7 connect(3, {sa_family=AF_INET, sin_port=htons(53), sin_addr=inet_addr("127.0.0.1")}, 16) = 0
    7 connect(3, {sa_family=AF_UNIX, sun_path="/tmp/.X11-unix/X0"}, 110) = 0
    8 sendto(3, "a", 1, 0, {sa_family=AF_INET, sin_port=htons(53), sin_addr=inet_addr("192.0.2.1")}, 16) = -1
    8 connect(3, {sa_family=AF_INET6, inet_pton(AF_INET6, "::1", &sin6_addr)}, 28) = 0
    9 connect(3, {sa_family=AF_INET6, inet_pton(AF_INET6, "2001:db8::1", &sin6_addr)}, 28) = -1
    """
    assert trial.strangers(trace) == ["192.0.2.1", "2001:db8::1"]


def test_a_newer_package_has_the_same_files_and_leaves_its_links_alone(
    program: Path, tmp_path: Path
) -> None:
    first = built(program, tmp_path / "deb")
    copy = tmp_path / f"pinel-desktop_{trial.__version__}_amd64.deb"
    copy.hardlink_to(first)
    newer = trial.make_newer(copy)
    assert _field(newer, "Version") == f"{trial.__version__}.1"
    assert _field(first, "Version") == trial.__version__
    assert _files(newer) == _files(first)
    assert not copy.exists()


def _field(package: Path, name: str) -> str:
    return _output("dpkg-deb", "-f", str(package), name).strip()


def _files(package: Path) -> str:
    return _output("dpkg-deb", "-c", str(package))


def _output(*command: str) -> str:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def test_the_dependencies_are_one_line_for_apt() -> None:
    line = systems.dependencies()
    assert line.startswith("libc6 (>= 2.35), libstdc++6 (>= 12), ")
    assert "libssl3t64 | libssl3, " in line
    assert "#" not in line


@pytest.mark.nightly
@pytest.mark.timeout(2400)
@pytest.mark.parametrize("codename", systems.SYSTEMS)
def test_the_package_works_in_another_system_without_network(codename: str) -> None:
    try:
        trial.systems.check_machine()
    except trial.systems.NotPossibleError as reason:
        pytest.skip(str(reason))
    assert trial.deb.deb_path().is_file(), "there is no package: make deb portable"
    assert trial.report(codename)
