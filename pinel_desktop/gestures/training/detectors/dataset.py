"""Writes labelled photographs as ultralytics reads them: unstretched pictures, labels, and `data.yaml`."""

import json
from collections.abc import Callable, Sequence
from pathlib import Path

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.training.folds import MIXED
from pinel_desktop.gestures.training.photos import Photo

_QUALITY = 95
DATA_FILE = "data.yaml"


def write_dataset(
    photos: Sequence[Photo],
    folder: Path,
    without: str | None = None,
    tick: Callable[[], object] = lambda: None,
) -> Path:
    """Writes the pictures of a detector's training and validation into a folder; returns its `data.yaml`.

    A box needs no change: it is a fraction of the picture's width and height. Both ways to sign D are one letter.

    Args:
        without: a source to validate on, and to train without, as without the mixed source, which may show the same
            person. By default, the splits of the photographs count.
        tick: called after each photograph.

    Raises:
        PinelError: `photos_unreadable` if a part has no photographs.
    """
    names = sorted({photo.letter for photo in photos})
    counts = {"train": 0, "valid": 0}
    for photo in photos:
        split = _split(photo, without)
        if split:
            _write(photo, folder / split, names.index(photo.letter))
            counts[split] += 1
        tick()
    if not all(counts.values()):
        raise PinelError("photos_unreadable", path=without or str(folder))
    lines = ["train: train/images", "val: valid/images", f"names: {json.dumps(names)}"]
    data = folder / DATA_FILE
    data.write_text(
        "\n".join([f"path: {json.dumps(str(folder.resolve()))}", *lines]) + "\n", "utf-8"
    )
    return data


def _split(photo: Photo, without: str | None) -> str | None:
    """Returns train or valid; None for a photograph of neither."""
    if without is None:
        return "valid" if photo.path.parts[-3] == "valid" else "train"
    if photo.source == without:
        return "valid"
    return None if photo.source == MIXED else "train"


def _write(photo: Photo, folder: Path, number: int) -> None:
    for part in ("images", "labels"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    picture = cv2.cvtColor(photo.picture(), cv2.COLOR_RGB2BGR)
    _, content = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])
    (folder / "images" / f"{photo.path.stem}.jpg").write_bytes(content.tobytes())
    box = " ".join(f"{side:.6f}" for side in photo.box)
    (folder / "labels" / f"{photo.path.stem}.txt").write_text(f"{number} {box}\n", "utf-8")
