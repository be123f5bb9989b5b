"""Writes a landmark sequence from pictures: `python -m scripts.record_hands OUT.npz PICTURE... [--aspect W:H]`.

Each picture becomes frames of a slightly trembling hand, followed by frames without a hand. This script made
tests/camera/recordings. A recording has only the detected landmarks, no picture.
"""

import argparse
from pathlib import Path

import numpy as np

from pinel_desktop.camera.landmark_sequence import RecordedHand, write_landmark_sequence
from pinel_desktop.gestures.features import features
from pinel_desktop.gestures.hands import HandDetector
from pinel_desktop.gestures.pictures import Picture, read_picture

_N_VIEWS, _N_FRAMES, _N_EMPTY = 6, 24, 12
_TREMBLE = 0.004  # of the picture's width
_SIZE = np.array([640.0, 480.0])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("pictures", type=Path, nargs="+")
    parser.add_argument(
        "--aspect", default=None, help="width:height before the picture was stretched"
    )
    options = parser.parse_args()
    finder, random = HandDetector(), np.random.default_rng(1)
    frames: list[RecordedHand | None] = []
    for path in options.pictures:
        views = _views(finder, read_picture(path, _ratio(options.aspect)), random)
        frames += [views[i % len(views)] for i in range(_N_FRAMES)]
        frames += [None] * _N_EMPTY
    write_landmark_sequence(options.out, frames)


def _views(
    finder: HandDetector, picture: Picture, random: np.random.Generator
) -> list[RecordedHand]:
    """Returns detected hands of a picture that is shifted by a few pixels each time."""
    found = []
    for _ in range(_N_VIEWS):
        shift = random.normal(0, _TREMBLE * picture.shape[1], 2).astype(int)
        hands = finder.detect(np.roll(picture, shift, axis=(1, 0)))
        if hands:
            points = hands[0].points[:, :2] / picture.shape[1::-1] * _SIZE
            is_left = hands[0].handedness == "left"
            found.append(RecordedHand(points.astype(np.float32), features(hands[0]), is_left))
    if not found:
        raise SystemExit("no hand in a picture")
    return found


def _ratio(aspect: str | None) -> float | None:
    if aspect is None:
        return None
    width, height = aspect.split(":")
    return float(width) / float(height)


if __name__ == "__main__":
    main()
