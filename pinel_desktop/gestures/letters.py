"""The only list of the shipped letters. A test checks that the shipped classifier has exactly these."""

LETTERS = tuple("ABCDEFGIKLMNOPQRSTUVW")
"""The static letters of the Libras alphabet; both ways to sign D are one letter."""
