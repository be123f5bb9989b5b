"""Printed markers are found in a picture, to a fraction of a pixel."""

import numpy as np

from pinel_desktop.camera.overhead.detection import find_markers
from pinel_desktop.camera.overhead.markers import MARKER_BITS
from pinel_desktop.gestures.opencv import cv2
from tests.camera.overhead.rendering import Scene


def test_the_printed_bits_are_those_of_the_dictionary() -> None:
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    for number, rows in enumerate(MARKER_BITS):
        drawn = cv2.aruco.generateImageMarker(dictionary, number, 6, borderBits=1)
        bits = (drawn[1:5, 1:5] > 0).astype(int).tolist()
        assert bits == [[int(bit) for bit in row] for row in rows]


def test_all_four_floor_markers_are_found() -> None:
    assert find_markers(Scene().picture(None)).keys() == {0, 1, 2, 3}


def test_a_marker_that_is_there_twice_counts_for_none() -> None:
    picture = Scene().picture(None)
    twice = np.concatenate([picture, picture], axis=1)
    assert find_markers(twice) == {}


def test_a_picture_without_markers_has_none() -> None:
    noise = np.random.default_rng(1).integers(0, 255, (720, 1280, 3), dtype=np.uint8)
    assert find_markers(noise) == {}
