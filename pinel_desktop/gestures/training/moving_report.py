"""Evaluates moving letters, and their effect on letters at rest, with synthetic movements of real hands.

Each person at a webcam teaches five examples of each moving letter. The tested person signs to three kinds of teacher:
the same person, one other person, the three others together. The classifier of letters at rest gets the same frames;
the tested person is not in its training data.

While a computed movement rotates or bends a hand, the prediction of its letter stays as at rest. This is the worst case
for the separation of letters at rest and moving letters.
"""

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from statistics import median
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures import weights_file
from pinel_desktop.gestures.classifier import SignClassifier
from pinel_desktop.gestures.hands import HandDetector
from pinel_desktop.gestures.moving.movements import HandObservation, Movement, MovementSegmenter
from pinel_desktop.gestures.moving.moving_signs import MovingSignClassifier
from pinel_desktop.gestures.sign_spotter import SignSpotter
from pinel_desktop.gestures.stability import Decision, FramePrediction
from pinel_desktop.gestures.training import moving_hands as hands
from pinel_desktop.gestures.training.accuracy_metrics import Proportion
from pinel_desktop.gestures.training.folds import strict
from pinel_desktop.gestures.training.letter_training import SEED, fit_letters
from pinel_desktop.gestures.training.moving_hands import MOVING, Model, Random
from pinel_desktop.gestures.training.photo_features import PhotoFeatures
from pinel_desktop.gestures.training.photos import Photo
from pinel_desktop.gestures.training.sequences import video_of

N_EXAMPLES = 5
_N_PHOTOS, _N_OTHER_PHOTOS = 6, 2  # for the hand of a moving letter, and for each other letter
_N_EACH = 4  # movements for each photograph
_N_ROUNDS = 3  # of videos without a moving letter
_MIN_FRAMES = 12  # minimum number of frames in which the hand is detected


@dataclass(frozen=True)
class Actor:
    """A photographed hand that can be moved, and the predictions for its frames."""

    letter: str
    model: Model
    predictions: tuple[FramePrediction, ...]

    def frame_predictions(
        self, observations: Sequence[HandObservation]
    ) -> Iterator[tuple[FramePrediction, bool]]:
        """Yields the predictions for a video of this hand, each with whether the frame shows a left hand."""
        for i, one in enumerate(observations):
            read = self.predictions[i % len(self.predictions)]
            yield replace(read, time_s=one.time_s, points=one.points), one.is_left


@dataclass(frozen=True)
class Person:
    """A person's photographed hands by letter: `teaches` for teaching, `signs` for tests."""

    teaches: dict[str, list[Actor]]
    signs: dict[str, list[Actor]]

    def models(self, sign: str, *, teaches: bool = False) -> list[Actor]:
        """Returns the hands with the shape of a moving letter."""
        actors = (self.teaches if teaches else self.signs).get(MOVING[sign], [])
        hooked = [replace(one, model=one.model.hooked()) for one in actors]
        return hooked if sign == "X" else actors


@dataclass
class _Counted:
    """Outcomes of captures, by the kind of video."""

    answers: dict[str, dict[str, list[str]]]
    false: dict[str, list[bool]]
    steady_s: list[float | None]
    steady_alone_s: list[float | None]
    steady_right: list[bool]
    changes: list[bool]
    changes_alone: list[bool]

    @classmethod
    def empty(cls) -> "_Counted":
        return cls({}, {}, [], [], [], [], [])


def moving_report(
    photos: Sequence[Photo], dataset: PhotoFeatures, seed: int = SEED
) -> dict[str, Any]:
    """Returns the report: proportions with 95 % intervals, and times.

    Args:
        photos, dataset: the same photographs in the same order.
    """
    random = np.random.default_rng(seed)
    detector = HandDetector()
    people = {
        fold.source: _person(detector, photos, dataset, fold.source, fold.train, random)
        for fold in strict(dataset.sources)
    }
    counted = _Counted.empty()
    examples = {name: _examples(person, random) for name, person in people.items()}
    for name, pupil in people.items():
        others = [examples[other] for other in people if other != name]
        _count_signs(counted, "who_signs", MovingSignClassifier(examples[name]), pupil, random)
        for other in others:
            _count_signs(counted, "another_person", MovingSignClassifier(other), pupil, random)
        known = MovingSignClassifier(_joined(others))
        _count_signs(counted, "three_others", known, pupil, random)
        for _ in range(_N_ROUNDS):
            _count_others(counted, known, pupil, random)
    return {**_as_report(counted), "speed_ms": speed_ms(random)}


def speed_ms(random: Random, n_signs: int = 60) -> dict[str, float]:
    """Measures the time for a frame of a moving hand, and for the end of a movement, in ms.

    Args:
        n_signs: number of taught moving signs.
    """
    examples = {str(i): random.normal(0, 1, (N_EXAMPLES, 38, 46)) for i in range(n_signs)}
    known = MovingSignClassifier(
        {sign: shown.astype(np.float32) for sign, shown in examples.items()}
    )
    spotter = SignSpotter()
    spotter.set_moving_signs(known)
    points = random.uniform(100, 300, (300, 21, 2)).astype(np.float32)
    frame_ms = _median_ms(
        lambda i: spotter.update(FramePrediction(i / 15, "A", 0.9, "B", points[i]), is_left=False),
        len(points),
    )
    end_ms = _median_ms(lambda i: known.predict(examples["0"][i % N_EXAMPLES]), 20)
    return {"frame": frame_ms, "end_of_a_movement": end_ms}


def _median_ms(work: Callable[[int], object], n: int) -> float:
    times = []
    for i in range(n):
        started = time.perf_counter()
        work(i)
        times.append(1000 * (time.perf_counter() - started))
    return round(median(times), 2)


def _person(
    detector: HandDetector,
    photos: Sequence[Photo],
    dataset: PhotoFeatures,
    source: str,
    train: NDArray[np.bool_],
    random: Random,
) -> Person:
    classifier = replace(
        fit_letters(dataset.where(train), SEED), calibration=weights_file.load().calibration
    )
    own = (dataset.sources == source) & dataset.is_hand
    teaches: dict[str, list[Actor]] = {}
    signs: dict[str, list[Actor]] = {}
    for letter in sorted(set(map(str, dataset.letters[own]))):
        n = _N_PHOTOS if letter in MOVING.values() else _N_OTHER_PHOTOS
        chosen = random.permutation(np.flatnonzero(own & (dataset.letters == letter)))[:n]
        actors = list(_actors(detector, classifier, (photos[i] for i in chosen), random))
        half = len(actors) // 2 if letter in MOVING.values() else 0
        teaches[letter], signs[letter] = actors[:half], actors[half:]
    return Person(teaches, signs)


def _actors(
    detector: HandDetector, classifier: SignClassifier, photos: Iterable[Photo], random: Random
) -> Iterator[Actor]:
    for photo in photos:
        video = video_of(detector, photo, random)
        if len(video.features) < _MIN_FRAMES:
            continue
        sign_predictions = [classifier.predict(row) for row in video.features]
        predictions = [
            FramePrediction(0.0, one.sign, one.confidence, one.second) for one in sign_predictions
        ]
        yield Actor(photo.letter, Model.of(video.features), tuple(predictions))


def _examples(teacher: Person, random: Random) -> dict[str, NDArray[np.float32]]:
    """Returns five movements of each moving letter for which there are photographs."""
    examples = {}
    for sign in MOVING:
        actors = teacher.models(sign, teaches=True)
        shown: list[Movement] = []
        while actors and len(shown) < N_EXAMPLES:
            actor = actors[int(random.integers(len(actors)))]
            shown += _movements(hands.signed(actor.model, *hands.letter_path(sign), random))
        if shown:
            examples[sign] = np.array(shown[:N_EXAMPLES])
    return examples


def _joined(examples: Sequence[dict[str, NDArray[np.float32]]]) -> dict[str, NDArray[np.float32]]:
    """Joins the examples of several people to examples of one class."""
    signs = [sign for sign in MOVING if any(sign in shown for shown in examples)]
    return {
        sign: np.concatenate([shown[sign] for shown in examples if sign in shown]) for sign in signs
    }


def _movements(observations: Iterable[HandObservation]) -> list[Movement]:
    segmenter = MovementSegmenter()
    return [found for one in observations if (found := segmenter.update(one)) is not None]


def _count_signs(
    counted: _Counted, taught_by: str, known: MovingSignClassifier, pupil: Person, random: Random
) -> None:
    """Counts the first decision for each moving letter: the right letter, a wrong letter, or none."""
    for sign in known.signs:
        for actor, _ in product(pupil.models(sign), range(_N_EACH)):
            observations = hands.signed(actor.model, *hands.letter_path(sign), random)
            first = next(
                (d for _, d in _decisions(known, actor.frame_predictions(observations))), None
            )
            label = first.label if first else ""
            for name in ("all", sign):
                outcomes = counted.answers.setdefault(taught_by, {}).setdefault(name, [])
                outcomes.append("right" if label == sign else "wrong" if label else "refused")


def _count_others(
    counted: _Counted, known: MovingSignClassifier, pupil: Person, random: Random
) -> None:
    """Counts decisions for videos without a moving letter.

    The videos show hands at rest, transitions, aimless movements, and movements of a letter with another letter's hand.
    """
    every = [actor for actors in pupil.signs.values() for actor in actors]
    for actor in every:
        held = hands.signed(actor.model, *hands.still(2.0), random)
        other = every[int(random.integers(len(every)))]
        change = hands.changed(actor.model, other.model, random)
        sign = str(random.choice(known.signs))
        copied = hands.signed(actor.model, *hands.letter_path(sign), random)
        idle = hands.signed(actor.model, *hands.aimless(random), random)
        _count_steady(counted, known, actor, held)
        _count_false(counted, "held letters", known, actor.frame_predictions(held))
        _count_false(counted, "transitions", known, _changing(actor, other, change))
        letters = {actor.letter, other.letter}
        for signs, times in (
            (known, counted.changes),
            (MovingSignClassifier({}), counted.changes_alone),
        ):
            found = _decisions(signs, _changing(actor, other, change))
            times.append(any(not d.is_moving and d.label not in letters for _, d in found))
        may_sign = actor.letter in MOVING.values()
        kind = "aimless, hand of a moving letter" if may_sign else "aimless, other hands"
        _count_false(counted, kind, known, actor.frame_predictions(idle))
        if not may_sign:
            _count_false(
                counted, "movement of a letter, other hand", known, actor.frame_predictions(copied)
            )


def _changing(
    first: Actor, second: Actor, observations: Sequence[HandObservation]
) -> Iterator[tuple[FramePrediction, bool]]:
    middle = len(observations) // 2
    yield from first.frame_predictions(observations[:middle])
    yield from second.frame_predictions(observations[middle:])


def _count_false(
    counted: _Counted,
    kind: str,
    known: MovingSignClassifier,
    frames: Iterable[tuple[FramePrediction, bool]],
) -> None:
    found = any(decision.is_moving for _, decision in _decisions(known, frames))
    counted.false.setdefault(kind, []).append(found)


def _count_steady(
    counted: _Counted,
    known: MovingSignClassifier,
    actor: Actor,
    observations: Sequence[HandObservation],
) -> None:
    """Records the decision time for a letter at rest, with and without taught moving letters."""
    for signs, times in (
        (known, counted.steady_s),
        (MovingSignClassifier({}), counted.steady_alone_s),
    ):
        first = next(_decisions(signs, actor.frame_predictions(observations)), None)
        times.append(first[0] if first else None)
        if signs is known and first:
            counted.steady_right.append(first[1].label == actor.letter)


def _decisions(
    known: MovingSignClassifier, frames: Iterable[tuple[FramePrediction, bool]]
) -> Iterator[tuple[float, Decision]]:
    """Yields all decisions, each with its time in s."""
    spotter = SignSpotter()
    spotter.set_moving_signs(known)
    for prediction, is_left in frames:
        if decision := spotter.update(prediction, is_left):
            yield prediction.time_s, decision


def _as_report(counted: _Counted) -> dict[str, Any]:
    return {
        "taught_by": {
            taught_by: {sign: _answers(outcomes) for sign, outcomes in signs.items()}
            for taught_by, signs in counted.answers.items()
        },
        "false": {kind: _share(found) for kind, found in counted.false.items()},
        "letters_at_rest": {
            "with_moving_letters": _steady(counted.steady_s, counted.changes),
            "without": _steady(counted.steady_alone_s, counted.changes_alone),
            "right_of_decided": _share(counted.steady_right),
        },
    }


def _answers(outcomes: Sequence[str]) -> dict[str, Any]:
    kinds = ("right", "wrong", "refused")
    return {kind: _share([one == kind for one in outcomes]) for kind in kinds}


def _steady(times: Sequence[float | None], false_letters: Sequence[bool]) -> dict[str, Any]:
    decided = [time_s for time_s in times if time_s is not None]
    return {
        "decided_within_1_s": _share([t is not None and t <= 1.0 for t in times]),
        "decided_within_2_s": _share([t is not None and t <= 2.0 for t in times]),
        "median_s": round(median(decided), 3) if decided else None,
        "wrong_letter_in_a_transition": _share(false_letters),
    }


def _share(holds: Sequence[bool]) -> dict[str, float | int | None]:
    return Proportion.among(holds).as_object()
