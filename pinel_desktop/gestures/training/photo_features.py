"""The features of all hands of a set of photographs, computed once and kept in a file."""

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures import networks
from pinel_desktop.gestures.classifier import NO_SIGN, Samples
from pinel_desktop.gestures.features import N_FEATURES, features
from pinel_desktop.gestures.hands import MIN_PRESENCE, HandDetector
from pinel_desktop.gestures.landmarks import Hand
from pinel_desktop.gestures.training.photos import Photo

_FORMAT = "2"  # to be raised when hands are found, or features computed, in another way


@dataclass(frozen=True)
class PhotoFeatures:
    """n photographs: the features (n, 1748) of the hand in each, and of what was found where it was painted over.

    files, letters, sources: (n,) names.
    presence: (n,) of the labelled hand, 0 where none was found. painted_presence: (n,) likewise, painted over.
    """

    files: NDArray[np.str_]
    letters: NDArray[np.str_]
    sources: NDArray[np.str_]
    features: NDArray[np.float32]
    presence: NDArray[np.float64]
    painted_features: NDArray[np.float32]
    painted_presence: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.letters)

    def where(self, chosen: NDArray[np.bool_]) -> "PhotoFeatures":
        """Those for which `chosen` (n,) holds."""
        return PhotoFeatures(**{name: getattr(self, name)[chosen] for name in _FIELDS})

    def samples(self) -> Samples:
        """The hands with their letters."""
        return Samples(self.features, tuple(map(str, self.letters)))

    @classmethod
    def joined(cls, parts: Sequence["PhotoFeatures"]) -> "PhotoFeatures":
        """All of these, one after the other."""
        return cls(
            **{name: np.concatenate([getattr(part, name) for part in parts]) for name in _FIELDS}
        )

    @property
    def painted(self) -> Samples:
        """What was taken for a hand in pictures that show none any more."""
        found = self.painted_features[self.painted_presence > MIN_PRESENCE]
        return Samples(found, (NO_SIGN,) * len(found))

    @property
    def is_hand(self) -> NDArray[np.bool_]:
        """In which pictures a hand was found, (n,)."""
        found: NDArray[np.bool_] = self.presence > MIN_PRESENCE
        return found


_FIELDS = tuple(PhotoFeatures.__dataclass_fields__)


def load_photo_features(
    photos: Sequence[Photo],
    cache: Path | None = None,
    tick: Callable[[], object] = lambda: None,
) -> PhotoFeatures:
    """The recordings of photographs: from `cache` where it is of the same photographs, networks and features.

    Otherwise they are computed (about 0.15 s each) and written there. `tick` is called after each photograph.
    """
    key = _key(photos)
    if cache and cache.is_file():
        with np.load(cache, allow_pickle=False) as archive:
            if str(archive["key"]) == key:
                return PhotoFeatures(**{name: archive[name] for name in _FIELDS})
    made = _compute_features(photos, tick)
    if cache:
        cache.parent.mkdir(parents=True, exist_ok=True)
        np.savez_compressed(cache, key=np.array(key), **{k: getattr(made, k) for k in _FIELDS})
    return made


def _compute_features(photos: Sequence[Photo], tick: Callable[[], object]) -> PhotoFeatures:
    detector = HandDetector()
    rows, painted = [], []
    for photo in photos:
        picture = photo.picture()
        hands = detector.detect(picture, accepts=photo.accepts(picture))
        rows.append(_best(hands))
        painted.append(_best(detector.detect(photo.painted_over(picture))))
        tick()
    return PhotoFeatures(
        files=np.array([photo.path.name for photo in photos]),
        letters=np.array([photo.letter for photo in photos]),
        sources=np.array([photo.source for photo in photos]),
        features=np.array([row[0] for row in rows], np.float32),
        presence=np.array([row[1] for row in rows]),
        painted_features=np.array([row[0] for row in painted], np.float32),
        painted_presence=np.array([row[1] for row in painted]),
    )


def _best(hands: Sequence[Hand]) -> tuple[NDArray[np.float32], float]:
    if not hands:
        return np.zeros(N_FEATURES, np.float32), 0.0
    hand = max(hands, key=lambda hand: hand.presence)
    return features(hand), hand.presence


def _key(photos: Sequence[Photo]) -> str:
    """Changes with all that the recordings depend on."""
    parts = [_FORMAT, networks.PALM.sha256, networks.HAND.sha256]
    parts += [
        f"{p.path.name} {p.letter} {p.source} {p.box} {p.path.stat().st_size}" for p in photos
    ]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()
