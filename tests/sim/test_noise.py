import itertools
import statistics
import subprocess
import sys

import pytest

from sim.noise import Noise


def test_noise_has_the_mean_and_spread_it_promises() -> None:
    numbers = [Noise(1, 2).normal(tick, index) for tick in range(2000) for index in range(5)]
    assert statistics.fmean(numbers) == pytest.approx(0.0, abs=0.04)
    assert statistics.stdev(numbers) == pytest.approx(1.0, abs=0.03)
    assert max(map(abs, numbers)) < 3.47


@pytest.mark.parametrize(
    "pairs",
    [
        [(Noise(3, 1).normal(tick), Noise(3, 1).normal(tick + 1)) for tick in range(3000)],
        [(Noise(3, 1).normal(tick, 0), Noise(3, 1).normal(tick, 1)) for tick in range(3000)],
        [(Noise(3, 1).normal(tick), Noise(3, 2).normal(tick)) for tick in range(3000)],
        [(Noise(seed, 1).normal(7), Noise(seed + 1, 1).normal(7)) for seed in range(3000)],
    ],
    ids=["ticks", "indices", "channels", "seeds"],
)
def test_neighbours_tell_nothing_of_each_other(pairs: list[tuple[float, float]]) -> None:
    first, second = zip(*pairs, strict=True)
    assert abs(statistics.correlation(first, second)) < 0.06


def test_noise_depends_on_its_place_and_not_on_what_was_asked_before() -> None:
    places = list(itertools.product(range(20), range(4)))
    one, other = Noise(5, 9), Noise(5, 9)
    ahead = {place: one.normal(*place) for place in places}
    back = {place: other.normal(*place) for place in reversed(places)}
    assert ahead == back


def test_noise_is_the_same_in_another_process() -> None:
    code = "from sim.noise import Noise; print([Noise(2**53 - 1, 4).normal(t, 3).hex() for t in range(9)])"
    printed = subprocess.run(
        [sys.executable, "-c", code],
        env={"PYTHONHASHSEED": "77", "PYTHONPATH": ":".join(sys.path)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert printed.stdout.strip() == str([Noise(2**53 - 1, 4).normal(t, 3).hex() for t in range(9)])
