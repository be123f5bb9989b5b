"""Annotates a camera frame: a box around each hand, labelled with its sign, as in the original PINEL."""

import unicodedata
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.pictures import Picture

_SURE, _UNSURE = (0, 160, 60), (230, 140, 0)  # RGB
_WHITE, _INK = (255, 255, 255), (32, 32, 32)
_MARGIN = 0.03  # around the landmarks, as a fraction of the picture's height
_FONT, _SCALE, _THICKNESS = cv2.FONT_HERSHEY_SIMPLEX, 0.6, 2


def annotated(picture: Picture, hands: Sequence[Mapping[str, Any]], caption: str = "") -> Picture:
    """Returns a copy of the picture with hands and caption drawn into it.

    A recognised sign has a green box; a rejected prediction has an orange box and a question mark.

    Args:
        hands: as in the event `camera_sight`: boxes as fractions of the picture's width and height.
    """
    drawn = np.ascontiguousarray(picture)
    if drawn is picture:
        drawn = picture.copy()
    for hand in hands:
        _draw(drawn, hand)
    if caption:
        _write(drawn, caption)
    return drawn


def _write(picture: Picture, caption: str) -> None:
    """Writes one line at the bottom of the picture, shrunk to the picture's width if it is too long."""
    height, width = picture.shape[:2]
    text = _ascii(caption)
    (text_width, text_height), _ = cv2.getTextSize(text, _FONT, _SCALE, _THICKNESS)
    scale = _SCALE * min(1.0, (width - 16) / max(text_width, 1))
    cv2.rectangle(picture, (0, height - text_height - 16), (width, height), _INK, -1)
    cv2.putText(picture, text, (8, height - 9), _FONT, scale, _WHITE, _THICKNESS)


def _draw(picture: Picture, hand: Mapping[str, Any]) -> None:
    height, width = picture.shape[:2]
    margin = _MARGIN * height if hand["points"] else 0.0  # landmarks lie inside the hand
    corners = np.array(hand["box"], np.float32) * (width, height, width, height)
    left, top = (int(value) for value in corners[:2] - margin)
    right, bottom = (int(value) for value in corners[2:] + margin)
    color = _SURE if hand["sure"] else _UNSURE
    cv2.rectangle(picture, (left, top), (right, bottom), color, _THICKNESS)
    label = _ascii(f"{hand['best']} {hand['confidence']:.0%}{'' if hand['sure'] else ' ?'}")
    (text_width, text_height), _ = cv2.getTextSize(label, _FONT, _SCALE, _THICKNESS)
    base = max(top, text_height + 8)
    cv2.rectangle(picture, (left, base - text_height - 8), (left + text_width + 8, base), color, -1)
    cv2.putText(picture, label, (left + 4, base - 5), _FONT, _SCALE, _WHITE, _THICKNESS)


def _ascii(text: str) -> str:
    """Strips accents, which OpenCV's fonts cannot draw."""
    return unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode("ascii")
