"""Keys of other PCs: which of them the teacher approved."""

from dataclasses import dataclass

from storage.errors import StoreError
from storage.file.repository import Repository


@dataclass(frozen=True, slots=True)
class ComputerKey:
    """A key with which a PC signed its bundles.

    Attributes:
        approved_at: when the teacher approved it; None for a key that waits.
    """

    public_key: str
    computer_id: str
    name: str
    seen_at: str
    approved_at: str | None


class ComputerKeys(Repository):
    """The keys that came with bundles."""

    def all(self) -> list[ComputerKey]:
        """The one that came last first."""
        rows = self._rows(
            """SELECT public_key, computer_id, name, seen_at, approved_at FROM computer_keys
               ORDER BY seen_at DESC, public_key"""
        )
        return [ComputerKey(**dict(row)) for row in rows]

    def approve(self, public_key: str) -> None:
        """What this key signed counts from now on, and what it signed before and still waits; on disk afterwards.

        Raises:
            StoreError: `computer_not_found` for a key that no bundle came with.
        """
        now = self._database.now()
        self._set(public_key, now)
        self._database.write(
            lambda db: (
                db.execute(
                    """DELETE FROM unconfirmed_runs WHERE public_key = ?
                       AND (finding IS NULL OR finding = 'not_repeatable')""",
                    [public_key],
                ).rowcount
            )
        )

    def withdraw(self, public_key: str) -> None:
        """What this key signs from now on must be confirmed; see `approve`."""
        self._set(public_key, None)

    def _set(self, public_key: str, approved_at: str | None) -> None:
        query = "UPDATE computer_keys SET approved_at = ? WHERE public_key = ?"
        values = [approved_at, public_key]
        if not self._database.write(lambda db: db.execute(query, values).rowcount):
            raise StoreError("computer_not_found", id=public_key)
