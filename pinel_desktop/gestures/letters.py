"""The letters that ship: their one list. A test holds that the classifier that ships knows these and no others."""

LETTERS = tuple("ABCDEFGIKLMNOPQRSTUVW")
"""The static letters of the Libras alphabet; both ways to sign D are one letter."""
