"""What files without names are called: nobody should take one for the work itself."""

_PARTS = {"pt-BR": "sem-nomes", "en": "no-names", "es": "sin-nombres"}


def nameless(language: str) -> str:
    """The name, before its date, of a file that tells neither of a PC nor of a class."""
    return f"PINEL-{_PARTS[language]}"
