"""Writes the landmarks for the page's drawings of signs: `python -m scripts.sign_drawings DATA RECORDINGS.npz`.

For each letter it selects the most typical hand: the photograph of a person at a webcam whose features are nearest to
the letter's mean. It writes only the 21 landmarks, as a right hand appears in a mirror. Letters set by hand stay.
"""

import json
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures import weights_file
from pinel_desktop.gestures.hands import HandDetector
from pinel_desktop.gestures.landmarks import Hand
from pinel_desktop.gestures.training.folds import PEOPLE
from pinel_desktop.gestures.training.photo_features import load_photo_features
from pinel_desktop.gestures.training.photos import Photo, read_photos

# a photograph hides what these letters are about: the fingers that touch
_BY_HAND = ("B", "M", "N")
_OUT = Path(__file__).parents[1] / "ui" / "src" / "camera" / "signs.json"


def main(data: Path, cache: Path) -> None:
    photos = read_photos(data)
    recordings = load_photo_features(photos, cache)
    finder = HandDetector()
    points = weights_file.load().projection(recordings.features)
    at_webcam = np.isin(recordings.sources, PEOPLE) & recordings.is_hand
    drawn = {}
    for letter in sorted(set(map(str, recordings.letters))):
        of_letter = np.flatnonzero((recordings.letters == letter) & at_webcam)
        distances = np.linalg.norm(points[of_letter] - points[of_letter].mean(0), axis=1)
        drawn[letter] = _landmarks(_hand(finder, photos[of_letter[distances.argmin()]]))
    known = json.loads(_OUT.read_text("utf-8"))
    drawn |= {letter: known[letter] for letter in _BY_HAND}
    lines = [f"  {json.dumps(name)}: {json.dumps(marks)}" for name, marks in drawn.items()]
    _OUT.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


def _hand(finder: HandDetector, photo: Photo) -> Hand:
    picture = photo.picture()
    return finder.detect(picture, accepts=photo.accepts(picture))[0]


def _landmarks(hand: Hand) -> list[list[float]]:
    """Landmarks of a right hand in a mirror, in units of the larger side: x right, y down, z away from the viewer."""
    mirrored: NDArray[np.float64] = hand.points * [1 if hand.mirrored else -1, 1, 1]
    low, high = mirrored[:, :2].min(0), mirrored[:, :2].max(0)
    mirrored[:, :2] -= (low + high) / 2
    return np.round(mirrored / (high - low).max(), 3).tolist()  # type: ignore[no-any-return]


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
