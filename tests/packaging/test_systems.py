"""The package in systems older and newer than the one that built it. (packaging/trial.py makes and enters them.)"""

import json
from typing import Any

import pytest

from tests.packaging.loading import load
from tests.packaging.test_smoke import healthy

systems = load("packaging/systems.py")
trial = load("packaging/trial.py")


def found(**changed: object) -> dict[str, Any]:
    window = {"about": "window", "code": "doctor_window_ok"}
    return {
        "check": json.dumps(healthy()),
        "doctor": json.dumps({"findings": [window]}),
        "n_colours": 4000,
        "install_status": 0,
        "remove_status": 0,
        "is_gone": True,
        "end_status": 0,
        "is_kiosk": True,
        "at_login": True,
        "kept": ["pinel.db"],
        "settings": '{"pinel_language": "es"}',
        **changed,
    }


def test_a_package_that_works_has_no_fault() -> None:
    assert trial.faults_of(found()) == []


def test_a_program_that_prints_nothing_did_not_start() -> None:
    assert trial.faults_of(found(check="")) == ["the package does not start"]


def test_a_screen_that_stays_empty_is_a_fault_whatever_the_program_says() -> None:
    assert trial.faults_of(found(n_colours=1)) == ["the window stays empty"]


def test_a_doctor_that_finds_no_window_is_a_fault() -> None:
    doctor = {"findings": [{"about": "window", "code": "doctor_window_failed"}]}
    faults = trial.faults_of(found(doctor=json.dumps(doctor)))
    assert faults == ["doctor: doctor_window_failed"]


@pytest.mark.parametrize(
    ("changed", "fault"),
    [
        ({"install_status": 100}, "status 100 of the installation"),
        ({"remove_status": 1}, "status 1 of the removal"),
        ({"end_status": None}, "the removal does not close the open program"),
        ({"is_gone": False}, "the removal leaves the program"),
        ({"is_kiosk": False}, "the window is not in kiosk mode"),
        ({"at_login": False}, "PINEL does not open at login"),
        ({"settings": "{}"}, "the set-up file is not used"),
        ({"kept": []}, "the removal deletes the work of the groups"),
    ],
)
def test_installation_and_removal_are_checked(changed: dict[str, object], fault: str) -> None:
    assert trial.faults_of(found(**changed)) == [fault]


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
