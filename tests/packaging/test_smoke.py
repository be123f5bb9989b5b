"""The judge of the smoke test is not to be lenient."""

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
        "store": {"signed": True, "telemetry_sha256": "c7e0"},
    }


def test_a_healthy_answer_has_no_fault() -> None:
    assert smoke.faults_of(healthy()) == []


def test_an_empty_answer_is_faulty_in_everything() -> None:
    assert len(smoke.faults_of({})) == 11


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


def test_a_run_that_was_not_judged_is_found() -> None:
    assert smoke.faults_of({**healthy(), "judged": False}) == ["judged"]


def test_signs_that_were_not_seen_are_found() -> None:
    assert smoke.faults_of({**healthy(), "signs": ["B"]}) == ["signs"]
