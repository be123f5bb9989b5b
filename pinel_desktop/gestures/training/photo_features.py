"""Features of all hands in a set of photographs, computed once and cached in a file."""

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

_FORMAT = "2"  # raise it if the detection of hands or the computation of features changes


@dataclass(frozen=True)
class PhotoFeatures:
    """Features of n photographs.

    files, letters, sources: names, (n,).
    features: of the labelled hand, (n, 1748). presence: of this hand, (n,); 0 if none was detected.
    painted_features, painted_presence: likewise for a false hand, detected after the hand was painted over.
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
        """Returns the photographs for which `chosen` (n,) is True."""
        return PhotoFeatures(**{name: getattr(self, name)[chosen] for name in _FIELDS})

    def samples(self) -> Samples:
        """Returns the hands with their letters, as training samples."""
        return Samples(self.features, tuple(map(str, self.letters)))

    @classmethod
    def joined(cls, parts: Sequence["PhotoFeatures"]) -> "PhotoFeatures":
        """Concatenates all parts."""
        return cls(
            **{name: np.concatenate([getattr(part, name) for part in parts]) for name in _FIELDS}
        )

    @property
    def painted(self) -> Samples:
        """False hands, detected in pictures whose hand was painted over, as samples without a sign."""
        found = self.painted_features[self.painted_presence > MIN_PRESENCE]
        return Samples(found, (NO_SIGN,) * len(found))

    @property
    def is_hand(self) -> NDArray[np.bool_]:
        """Whether a hand was detected in each picture, (n,)."""
        found: NDArray[np.bool_] = self.presence > MIN_PRESENCE
        return found


_FIELDS = tuple(PhotoFeatures.__dataclass_fields__)


def load_photo_features(
    photos: Sequence[Photo],
    cache: Path | None = None,
    tick: Callable[[], object] = lambda: None,
) -> PhotoFeatures:
    """Loads the features of photographs from `cache`, if it has the same photographs, networks and format.

    Otherwise computes them (about 0.15 s for each photograph) and writes them to `cache`. Calls `tick` after each
    photograph.
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
    """Returns a hash over all inputs of the features."""
    parts = [_FORMAT, networks.PALM.sha256, networks.HAND.sha256]
    parts += [
        f"{p.path.name} {p.letter} {p.source} {p.box} {p.path.stat().st_size}" for p in photos
    ]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()
