"""Runs predicted by other runs: which ones may be, and how far off the prediction is."""

import math
import random
from collections.abc import Sequence

import pytest

from pinel_desktop.calibration import Drive
from pinel_desktop.calibration.held_out import MAX_RATIO, HeldOut, held_out
from pinel_desktop.calibration.umbmark import umbmark_of
from pinel_desktop.calibration.wheels import calibrate_wheels
from pinel_desktop.robot import PIONEER_3DX
from tests.calibration.hidden_robot import OFFERED, PATTERN, driven, hidden_errors

_TRACK_M = PIONEER_3DX.track_m


def _held_out(drives: Sequence[Drive]) -> list[HeldOut]:
    return held_out(drives, calibrate_wheels(drives, _TRACK_M), _TRACK_M)


def test_a_square_is_held_out_only_if_another_run_turned_to_its_side() -> None:
    hidden = hidden_errors(random.Random(1))
    drives = [driven(text, hidden, seed, by="tape") for seed, text in enumerate(OFFERED)]
    assert _held_out(drives[:3]) == []
    assert [one.place for one in _held_out(drives[:4])] == [1, 3]
    found = _held_out(drives)
    assert [one.place for one in found] == [1, 2, 3, 4, 5, 6]  # squares alone do not tell the line
    for one in found:
        assert math.hypot(*one.off_m) == pytest.approx(one.error_m)


def test_a_calibration_leaves_little_of_the_systematic_error_that_umbmark_measures() -> None:
    hidden = hidden_errors(random.Random(2))
    drives = [driven(text, hidden, seed, by="tape") for seed, text in enumerate(OFFERED)]
    found = umbmark_of(drives, _TRACK_M, _held_out(drives))
    assert found is not None
    assert (found.n_left, found.n_right) == (3, 3)
    assert found.left_over_m is not None
    assert found.left_over_m < 0.05
    assert found.worst_m > 0.1
    alone = umbmark_of(drives[:3], _TRACK_M, _held_out(drives[:3]))
    assert alone is not None
    assert alone.left_over_m is None


@pytest.mark.nightly
@pytest.mark.timeout(3600)
@pytest.mark.parametrize(("by", "n_robots"), [("tape", 40), ("camera", 12)])
def test_the_offered_pattern_predicts_its_own_runs_within_the_bound(by: str, n_robots: int) -> None:
    """Over hidden robots, the root mean square of the errors is at most 1.3 times that of the noise floors."""
    errors, floors, nominal = 0.0, 0.0, 0.0
    for seed in range(n_robots):
        hidden = hidden_errors(random.Random(seed))
        drives = [driven(text, hidden, 100 * seed + i, by=by) for i, text in enumerate(OFFERED)]
        found = _held_out(drives)
        assert len(found) >= 6
        errors += sum(one.error_m**2 for one in found) / len(found)
        floors += sum(one.expected_m**2 for one in found) / len(found)
        nominal += sum(one.nominal_m**2 for one in found) / len(found)
    cm = [100.0 * math.sqrt(total / n_robots) for total in (errors, floors, nominal)]
    print(f"{by}: error {cm[0]:.1f} cm, floor {cm[1]:.1f} cm, not calibrated {cm[2]:.1f} cm")
    assert cm[0] <= MAX_RATIO * cm[1]


def test_three_runs_are_the_pattern_without_its_repetitions() -> None:
    assert OFFERED[:3] == PATTERN
