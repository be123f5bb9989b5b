"""The only list of the shipped letters. A test checks that the shipped classifier has exactly these.

Imports nothing, so that the app can read it without a network.
"""

LETTERS = tuple("ABCDEFGIKLMNOPQRSTUVW")
"""The static letters of the Libras alphabet; both ways to sign D are one letter."""

LANDMARKS = "landmarks"
"""Name of the recognizer of these letters, as for `recognizers.open_recognizer`."""
YOLO = "yolo"
"""The part before the colon in the name of a detector, `yolo:FILE`."""
