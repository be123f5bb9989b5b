"""The runs and signs that the album of a group is derived from. Nothing of the album itself is stored."""

from collections.abc import Iterable
from typing import Any, NamedTuple

from storage.file.repository import Repository
from storage.run_validity import counted, masking_damage
from storage.sql import require, rows_of, setup_value
from storage.text import readable_object, to_json


class AlbumRun(NamedTuple):
    """An ended run of a group.

    Attributes:
        passed: whether it passed its activity; None if it was not judged, or while its result does not count.
        path_length_m: length of the path, in m; None if the robot did not report it.
    """

    id: str
    activity: str | None
    passed: bool | None
    state: str
    path_length_m: float | None
    version_id: str | None
    started_at: str


class AlbumRuns(Repository):
    """Reads what stickers are derived from."""

    def of_group(self, group_id: str) -> list[AlbumRun]:
        """Returns the runs of a group that were judged or finished, oldest first.

        Raises:
            StoreError: `group_not_found`.
        """
        query = f"""SELECT id, activity, {counted()} AS passed, {masking_damage("state")} AS state, path_length_m,
                version_id, started_at
            FROM runs WHERE group_id = ? AND (passed IS NOT NULL OR runs.state = 'finished') ORDER BY id"""
        with self._database.read_connection() as db:
            require(db, "groups", group_id)
            return [_album_run(tuple(row)) for row in rows_of(db, query, [group_id])]

    def documents(self, version_ids: Iterable[str]) -> dict[str, dict[str, Any]]:
        """Returns the program documents of versions by key, without damaged ones."""
        query = """SELECT id, document FROM versions
            WHERE id IN (SELECT value FROM json_each(?)) AND document IS NOT NULL"""
        found = self._rows(query, to_json(sorted(version_ids)))
        parsed = {str(row["id"]): readable_object(row["document"]) for row in found}
        return {key: document for key, document in parsed.items() if document is not None}

    def own_solutions(self, activities: Iterable[str]) -> dict[str, dict[str, Any] | None]:
        """Returns the solutions of activities that a teacher made, by key; None for one that is damaged."""
        query = f"""SELECT id, {setup_value("document", "solution")} AS solution FROM own_activities
            WHERE id IN (SELECT value FROM json_each(?))"""
        found = self._rows(query, to_json(sorted(activities)))
        return {str(row["id"]): readable_object(row["solution"]) for row in found}

    def first_taught_at(self, group_id: str) -> str | None:
        """Returns when a class of the group first taught a sign: its present class, or one in whose lessons it ran."""
        query = """SELECT min(created_at) AS at FROM taught_signs WHERE classroom_id IN (
                SELECT classroom_id FROM groups WHERE id = ?
                UNION SELECT lessons.classroom_id FROM runs JOIN lessons ON lessons.id = runs.lesson_id
                      WHERE runs.group_id = ?)"""
        (row,) = self._rows(query, group_id, group_id)
        return None if row["at"] is None else str(row["at"])


def _album_run(values: tuple[object, ...]) -> AlbumRun:
    run = AlbumRun._make(values)
    return run._replace(passed=None if run.passed is None else bool(run.passed))
