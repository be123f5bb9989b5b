"""What a person chose."""

from typing import Any

from storage.connection import Access
from storage.text import dumped, loaded


class Settings:
    """Values by name, as JSON."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def get(self, key: str) -> Any:
        """None where nothing was chosen."""
        with self._access.reading() as db:
            row = db.execute("SELECT value FROM settings WHERE key = ?", [key]).fetchone()
        return loaded(row["value"]) if row else None

    def set(self, key: str, value: object) -> None:
        """On disk when this returns."""
        self._access.write(
            lambda db: (
                db.execute(
                    "INSERT OR REPLACE INTO settings VALUES (?, ?)", [key, dumped(value)]
                ).rowcount
            )
        )
