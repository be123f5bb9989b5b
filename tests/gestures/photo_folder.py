"""A folder of labelled photographs, with drawn hands."""

import csv
from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np

from tests.gestures.drawn import OPEN, drawn_hand

SOURCES = ("p1_webcam", "p2_webcam", "p3_webcam", "g8_phone_mix")
LETTERS = {"L": ("index",), "V": ("index", "middle"), "B": OPEN}


def make_photos(folder: Path, n_each: int = 2, sources: Sequence[str] = SOURCES) -> Path:
    """Pictures of three letters by each source, stretched to squares, and one without a letter; returns the table."""
    rows = [{"split": "train", "file": "no.jpg", "label": "", "letter": "", "source": sources[0]}]
    for s, source in enumerate(sources):
        for letter, stretched in LETTERS.items():
            for i in range(n_each):
                name = f"{source}_{letter}{i}.jpg"
                _write(folder / "train", name, stretched, 560 + 20 * s + 7 * i)
                row = {"split": "train", "file": name, "label": letter}
                rows.append({**row, "letter": letter, "source": source})
    table = folder / "sources.csv"
    with table.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    return table


def _write(split: Path, name: str, stretched: tuple[str, ...], size: int) -> None:
    for kind in ("images", "labels"):
        (split / kind).mkdir(parents=True, exist_ok=True)
    hand = drawn_hand(stretched, size)
    wide = np.full((640, 1138, 3), (70, 90, 110), np.uint8)
    wide[640 - min(size, 640) :, 200 : 200 + size] = hand[: min(size, 640)]
    square = cv2.resize(wide, (640, 640))
    cv2.imwrite(str(split / "images" / name), square[..., ::-1])
    x, width = (200 + 0.44 * size) / 1138, 0.5 * size / 1138
    y, height = 1 - (min(size, 640) - 0.5 * size) / 640, 0.65 * size / 640
    label = split / "labels" / f"{Path(name).stem}.txt"
    label.write_text(f"0 {x} {y} {width} {height}\n", "utf-8")
