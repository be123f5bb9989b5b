"""Compares recognizers on the same photographs: signs read, false answers, time, memory and file size."""

import multiprocessing
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from pinel_desktop.gestures.letters import LANDMARKS
from pinel_desktop.gestures.recognition import LandmarkRecognizer
from pinel_desktop.gestures.recognizer import SignRecognizer, clearest
from pinel_desktop.gestures.recognizers import open_recognizer
from pinel_desktop.gestures.training import letter_training
from pinel_desktop.gestures.training.accuracy_metrics import Proportion
from pinel_desktop.gestures.training.folds import MIXED
from pinel_desktop.gestures.training.photo_features import PhotoFeatures
from pinel_desktop.gestures.training.photos import Photo

Report = dict[str, Any]
# Sets of photographs whose letters of both ways to sign D have their own classes name them so.
_ONE_LETTER = {"D1": "D", "D2": "D"}
_N_TIMED = 25


@dataclass(frozen=True)
class Comparison:
    """What to compare.

    photos: all photographs. features: theirs, in the same order, to train the letters without the tested ones.
    detector: file of a detector that was trained on the split `train`.
    left_out: for each source, a detector that was trained without it.
    """

    photos: Sequence[Photo]
    features: PhotoFeatures
    detector: Path
    left_out: Mapping[str, Path]


def compare(comparison: Comparison, tick: Callable[[], object] = lambda: None) -> Report:
    """Returns for each set of photographs the figures of landmarks and detector, and what a frame of each costs.

    Both are tested on the same photographs, and trained without them. Calls `tick` after each photograph.

    Raises:
        PinelError: a detector cannot be used.
    """
    return {
        "sets": {
            name: {
                "landmarks": figures(_landmarks(comparison, trained), tested, tick),
                "yolo": figures(open_recognizer(f"yolo:{detector}"), tested, tick),
            }
            for name, trained, tested, detector in _sets(comparison)
        },
        "cost": {
            name: _cost(name, comparison.photos)
            for name in (LANDMARKS, f"yolo:{comparison.detector}")
        },
    }


def _sets(comparison: Comparison) -> Iterator[tuple[str, np.ndarray, list[Photo], Path]]:
    """Yields name, mask of the photographs for training, tested photographs, and detector of each set."""
    sources = comparison.features.sources
    is_valid = np.array([photo.path.parts[-3] == "valid" for photo in comparison.photos])
    if is_valid.any():
        tested = [photo for photo, own in zip(comparison.photos, is_valid, strict=True) if own]
        yield "valid", ~is_valid, tested, comparison.detector
    for source, detector in comparison.left_out.items():
        tested = [photo for photo in comparison.photos if photo.source == source]
        yield source, ~np.isin(sources, [source, MIXED]), tested, detector


def _landmarks(comparison: Comparison, trained: np.ndarray) -> LandmarkRecognizer:
    return LandmarkRecognizer(letter_training.fit_letters(comparison.features.where(trained)))


def figures(
    recognizer: SignRecognizer,
    photos: Sequence[Photo],
    tick: Callable[[], object] = lambda: None,
) -> Report:
    """Returns the shares of right letters, of answers, of right answers, and of answers to a hand painted over."""
    right, answered, painted = [], [], []
    for photo in photos:
        picture = photo.picture()
        best, sign = _read(recognizer, picture)
        right.append(best == photo.letter)
        answered.append(sign is not None)
        painted.append(_read(recognizer, photo.painted_over(picture))[1] is not None)
        tick()
    is_right, is_answered = np.array(right, bool), np.array(answered, bool)
    shares = {
        "right": is_right,
        "answered": is_answered,
        "right_of_answered": is_right[is_answered],
        "painted_over_answered": np.array(painted, bool),
    }
    return {name: Proportion.among(holds).as_object() for name, holds in shares.items()}


def _read(recognizer: SignRecognizer, picture: np.ndarray) -> tuple[str | None, str | None]:
    """Returns the likeliest letter and the answered letter of a picture."""
    found = clearest(recognizer.read(picture))
    if found is None:
        return None, None
    best, sign = found.prediction.best, found.prediction.sign
    return _ONE_LETTER.get(best, best), sign


def _cost(name: str, photos: Sequence[Photo]) -> Report:
    """Returns time for a frame of a video (ms, median) and memory (MB), in a process of its own."""
    context = multiprocessing.get_context("spawn")
    with context.Pool(1) as pool:
        return pool.apply(_measured, (name, list(photos[:_N_TIMED])))


def _measured(name: str, photos: Sequence[Photo]) -> Report:
    import psutil  # noqa: PLC0415 - in the process that is measured

    pictures = [photo.picture() for photo in photos]
    before = psutil.Process().memory_info().rss
    recognizer = open_recognizer(name)
    times = []
    for picture in pictures:
        started = time.perf_counter()
        recognizer.track(picture)
        recognizer.track(picture)
        times.append(1000 * (time.perf_counter() - started) / 2)
    grown = psutil.Process().memory_info().rss - before
    return {"ms_a_frame": round(median(times), 1), "memory_mb": round(grown / 1e6)}


def as_table(report: Report, average_precision: Mapping[str, float] | None) -> str:
    """Returns the report as a table in Markdown.

    Args:
        average_precision: `map50` and `map50_95` of the detector on `valid`; None if they were not measured.
    """
    lines = ["| | landmarks | YOLOv8n |", "|---|---|---|"]
    if average_precision:
        values = f"{average_precision['map50']:.3f} / {average_precision['map50_95']:.3f}"
        lines.append(f"| `valid`: mAP50 / mAP50-95 | no boxes | {values} |")
    for name, both in report["sets"].items():
        for figure in ("right", "answered", "right_of_answered", "painted_over_answered"):
            cells = [_share(both[kind][figure]) for kind in ("landmarks", "yolo")]
            lines.append(f"| {name}: {figure.replace('_', ' ')} | {' | '.join(cells)} |")
    for figure, unit in (("ms_a_frame", "ms a frame, one thread"), ("memory_mb", "memory, MB")):
        lines.append(
            f"| {unit} | {' | '.join(str(one[figure]) for one in report['cost'].values())} |"
        )
    return "\n".join(lines)


def _share(share: Mapping[str, Any]) -> str:
    if share["share"] is None:
        return "none answered"
    return f"{share['share']:.3f} [{share['low']:.3f}, {share['high']:.3f}] of {share['of']}"
