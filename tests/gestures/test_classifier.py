"""Learning signs from samples; the samples here are clouds around three corners."""

import numpy as np
import pytest

from pinel_desktop.gestures.classifier import (
    NO_SIGN,
    Calibration,
    Doubt,
    Judgement,
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


LEARNT = SignClassifier.fit(cloud("A") + cloud("B") + cloud("T"), BLOCKS)


def signs_of(classifier: SignClassifier, samples: Samples) -> set[str | None]:
    return {classifier.read(features).sign for features in samples.features}


def test_other_samples_of_a_sign_are_recognised() -> None:
    for name in "ABT":
        assert signs_of(LEARNT, cloud(name, 20, seed=8)) == {name}


def test_learning_twice_gives_the_same() -> None:
    again = SignClassifier.fit(cloud("A") + cloud("B") + cloud("T"), BLOCKS)
    assert np.array_equal(again.weights, LEARNT.weights)
    assert np.array_equal(again.points, LEARNT.points)


def test_an_unknown_sign_is_refused() -> None:
    assert signs_of(LEARNT, cloud("3", 20)) == {None}


def test_the_best_two_are_named_in_doubt_as_well() -> None:
    reading = LEARNT.read(halfway("A", "T", 1).features[0])
    assert reading.sign is None
    assert {reading.best, reading.second} == {"A", "T"}
    assert reading.confidence >= reading.second_confidence > 0.1


def test_what_was_learnt_to_be_no_sign_is_refused_even_without_doubt() -> None:
    trained = SignClassifier.fit(
        cloud("A") + cloud("B") + cloud("T") + halfway("A", "B", 60), BLOCKS
    )
    between = halfway("A", "B", 10).features
    careless = Doubt(score=0.5, margin=0, strangeness=np.inf)
    assert not trained.judge(between).is_clear(careless).any()
    assert signs_of(trained, cloud("A", 20, seed=8)) == {"A"}


def test_four_samples_teach_a_new_sign_and_the_old_ones_stay() -> None:
    taught = LEARNT.teach(cloud("3", 4))
    assert taught.signs == ("A", "B", "T", "3")
    assert signs_of(taught, cloud("3", 20, seed=9)) == {"3"}
    assert signs_of(taught, cloud("A", 20, seed=9)) == {"A"}


def test_a_person_s_own_way_is_taught_to_a_known_sign() -> None:
    own = Samples(cloud("3", 4).features, ("T",) * 4)
    assert {LEARNT.teach(own).read(f).best for f in cloud("3", 20, seed=9).features} == {"T"}


def test_what_was_taught_is_forgotten_without_a_trace() -> None:
    forgotten = LEARNT.teach(cloud("3", 4)).forget("3")
    assert forgotten.signs == LEARNT.signs
    assert np.array_equal(forgotten.points, LEARNT.points)
    assert forgotten.weights == pytest.approx(LEARNT.weights, abs=1e-6)


def test_a_sign_in_the_middle_is_forgotten_and_the_others_keep_their_names() -> None:
    forgotten = LEARNT.forget("B")
    assert forgotten.signs == ("A", "T")
    assert signs_of(forgotten, cloud("T", 20, seed=8)) == {"T"}


def test_an_answer_needs_score_margin_and_likeness() -> None:
    scores = np.array([[0.9, 0.1], [0.4, 0.0], [0.9, 0.8], [0.9, 0.1]])
    judged = Judgement(scores, np.array([0.0, 0.0, 0.0, 9.0]))
    assert judged.is_clear(Doubt(0.5, 0.2, 1)).tolist() == [True, False, False, False]


def test_probabilities_add_up_to_one_with_that_of_no_sign() -> None:
    shares = Calibration(10, 2).probabilities(np.array([[0.9, 0.1], [0.0, 0.0]]))
    assert shares.sum(1) == pytest.approx([1, 1])
    assert shares[0].argmax() == 0
    assert shares[1].argmax() == 2


def test_a_calibration_is_sharper_where_scores_are_right_more_often() -> None:
    scores = np.tile([[0.6, 0.4]], (100, 1))
    right, mixed = np.zeros(100, np.int64), np.arange(100) % 2
    assert calibrated(scores, right).sharpness > calibrated(scores, mixed).sharpness
