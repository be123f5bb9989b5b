"""Learning signs from samples; the samples here are clouds around three corners."""

import numpy as np
import pytest

from pinel_desktop.gestures.classifier import (
    NO_SIGN,
    Calibration,
    ClassScores,
    RejectThresholds,
    Samples,
    SignClassifier,
    calibrated,
)

D = 30
BLOCKS = (slice(0, 12), slice(12, D))
CORNERS = {
    name: np.random.default_rng(i).normal(size=D) * 3 for i, name in enumerate(["A", "B", "T", "3"])
}


def cloud(name: str, n: int = 60, seed: int = 7) -> Samples:
    random = np.random.default_rng([seed, ord(name)])
    features = CORNERS[name] + random.normal(size=(n, D))
    return Samples(features.astype(np.float32), (name,) * n)


def halfway(a: str, b: str, n: int = 30) -> Samples:
    first, second = cloud(a, n, 11).features, cloud(b, n, 12).features
    return Samples(((first + second) / 2).astype(np.float32), (NO_SIGN,) * n)


TRAINED = SignClassifier.fit(cloud("A") + cloud("B") + cloud("T"), BLOCKS)


def signs_of(classifier: SignClassifier, samples: Samples) -> set[str | None]:
    return {classifier.predict(features).sign for features in samples.features}


def test_other_samples_of_a_sign_are_recognised() -> None:
    for name in "ABT":
        assert signs_of(TRAINED, cloud(name, 20, seed=8)) == {name}


def test_learning_twice_gives_the_same() -> None:
    again = SignClassifier.fit(cloud("A") + cloud("B") + cloud("T"), BLOCKS)
    assert np.array_equal(again.weights, TRAINED.weights)
    assert np.array_equal(again.points, TRAINED.points)


def test_an_unknown_sign_is_refused() -> None:
    assert signs_of(TRAINED, cloud("3", 20)) == {None}


def test_the_best_two_are_named_in_doubt_as_well() -> None:
    reading = TRAINED.predict(halfway("A", "T", 1).features[0])
    assert reading.sign is None
    assert {reading.best, reading.second} == {"A", "T"}
    assert reading.confidence >= reading.second_confidence > 0.1


def test_what_was_learnt_to_be_no_sign_is_refused_even_without_doubt() -> None:
    trained = SignClassifier.fit(
        cloud("A") + cloud("B") + cloud("T") + halfway("A", "B", 60), BLOCKS
    )
    between = halfway("A", "B", 10).features
    careless = RejectThresholds(min_score=0.5, min_margin=0, max_novelty=np.inf)
    assert not trained.score(between).is_clear(careless).any()
    assert signs_of(trained, cloud("A", 20, seed=8)) == {"A"}


def test_four_samples_teach_a_new_sign_and_the_old_ones_stay() -> None:
    taught = TRAINED.with_samples(cloud("3", 4))
    assert taught.signs == ("A", "B", "T", "3")
    assert signs_of(taught, cloud("3", 20, seed=9)) == {"3"}
    assert signs_of(taught, cloud("A", 20, seed=9)) == {"A"}


def test_a_person_s_own_way_is_taught_to_a_known_sign() -> None:
    own = Samples(cloud("3", 4).features, ("T",) * 4)
    assert {TRAINED.with_samples(own).predict(f).best for f in cloud("3", 20, seed=9).features} == {
        "T"
    }


def test_an_answer_needs_score_margin_and_likeness() -> None:
    scores = np.array([[0.9, 0.1], [0.4, 0.0], [0.9, 0.8], [0.9, 0.1]])
    judged = ClassScores(scores, np.array([0.0, 0.0, 0.0, 9.0]))
    assert judged.is_clear(RejectThresholds(0.5, 0.2, 1)).tolist() == [True, False, False, False]


def test_probabilities_add_up_to_one_with_that_of_no_sign() -> None:
    shares = Calibration(10, 2).probabilities(np.array([[0.9, 0.1], [0.0, 0.0]]))
    assert shares.sum(1) == pytest.approx([1, 1])
    assert shares[0].argmax() == 0
    assert shares[1].argmax() == 2


def test_a_calibration_is_sharper_where_scores_are_right_more_often() -> None:
    scores = np.tile([[0.6, 0.4]], (100, 1))
    right, mixed = np.zeros(100, np.int64), np.arange(100) % 2
    assert calibrated(scores, right).sharpness > calibrated(scores, mixed).sharpness
