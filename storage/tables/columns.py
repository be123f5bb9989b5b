"""The classes that declare tables and columns; the other modules of this folder use them."""

from dataclasses import dataclass
from typing import NamedTuple

from storage.limits import MAX_REVISION
from storage.tables import rules
from storage.tables.rules import Rule

UNCHANGED = ""  # an anonymous bundle has the column's value as it is


class Kind(NamedTuple):
    """A kind of column.

    Attributes:
        sql: its type in SQLite.
        parquet: its type in docs/parquet.md.
        rule: validation rule of columns that have none of their own; None if every column must have one.
        anonymised: as `Column.anonymised`, with `{}` for the column's name.
    """

    sql: str
    parquet: str
    rule: Rule | None
    anonymised: str | None = UNCHANGED


KEY = Kind("TEXT", "text", rules.key, "fresh({})")
TEXT = Kind("TEXT", "text", None, None)
JSON = Kind("TEXT", "text", rules.json_object, "neutral({})")
TIME = Kind("TEXT", "time", rules.time)
COUNT = Kind("INTEGER", "count", rules.count)
FLAG = Kind("INTEGER", "flag", rules.flag)
NUMBER = Kind("REAL", "number", rules.real)
BLOB = Kind("BLOB", "blob", rules.blob)


@dataclass(frozen=True, slots=True)
class Column:
    """A column of a table.

    Attributes:
        description: its meaning, for docs/.
        rule: true for each value that a store writes; a bundle with another value is refused.
        anonymised: SQL expression of its value in an anonymous bundle, or `UNCHANGED`. Required for a text column.
            The expression can use `fresh` (a new key), `plain` (a neutral word), `neutral` (JSON with neutral words)
            and `name_key`.
        optional: the column may be NULL.
        parquet: the Parquet export has the column.
        counts_empty: False if the content hash leaves the column out while every row has the empty text. Files without
            such values then have the same hash as in an earlier release.
        references: the table whose key it has.
        is_parent: the row is deleted with the row that it references.
    """

    name: str
    kind: Kind
    description: str
    rule: Rule | None = None
    anonymised: str | None = None
    optional: bool = False
    parquet: bool = True
    counts_empty: bool = True
    references: str = ""
    is_parent: bool = False

    def __post_init__(self) -> None:
        if self.kind is TEXT and (self.rule is None or self.anonymised is None):
            raise ValueError(
                f"{self.name}: a text needs a rule, and what an anonymous bundle holds"
            )

    @property
    def accepts(self) -> Rule:
        """Its rule, which also accepts NULL if the column is optional."""
        rule = self.rule or self.kind.rule
        assert rule is not None
        return rules.optional(rule) if self.optional else rule

    @property
    def anonymous(self) -> str:
        """SQL expression of its value in an anonymous bundle, `UNCHANGED` for the value itself."""
        if self.anonymised is not None:
            return self.anonymised
        return (self.kind.anonymised or UNCHANGED).format(self.name)


class ParquetColumn(NamedTuple):
    """A column of a Parquet file; `source` is the SQL expression that gives its values."""

    name: str
    type: str
    description: str
    source: str


@dataclass(frozen=True, slots=True)
class Table:
    """A table.

    Attributes:
        description: its meaning in the view `about` and in docs/database.md.
        key: columns that identify a row, in every file.
    """

    name: str
    description: str
    columns: tuple[Column, ...]
    key: tuple[str, ...] = ("id",)


@dataclass(frozen=True, slots=True)
class ReplicatedTable(Table):
    """A table whose rows are exchanged between PCs.

    Attributes:
        condition: SQL of the rows that are exchanged, with `{schema}` in place of the schema's name.
        own_tombstone: a row that is deleted with its parent gets a tombstone of its own. Rows of other tables are
            only found below such rows, and need none.
        deletable: False if deletions never delete a row.
        anonymous: False if anonymous bundles have no rows.
        parquet: the Parquet export has the table.
        metrics: further columns of the Parquet file.
        precedence: SQL expressions that decide which of two states of a row is newer, before revision and values do.
            They have `{side}` in place of the table's name.
        bound: columns that never change, and whose hash is in the key (`storage/text.py: id_of`).
        counts_empty: False if the content hash leaves the table out while it has no rows. Files without such rows
            then have the same hash as in an earlier release.
    """

    condition: str = "1"
    own_tombstone: bool = False
    deletable: bool = True
    anonymous: bool = True
    parquet: bool = True
    metrics: tuple[ParquetColumn, ...] = ()
    precedence: tuple[str, ...] = ()
    bound: tuple[str, ...] = ()
    counts_empty: bool = True

    @property
    def parents(self) -> tuple[tuple[str, str], ...]:
        """The columns that refer to a parent row, each with the parent's table."""
        return tuple(
            (column.name, column.references) for column in self.columns if column.is_parent
        )

    @property
    def parquet_columns(self) -> tuple[ParquetColumn, ...]:
        """The columns of its Parquet file."""
        declared = [
            ParquetColumn(column.name, column.kind.parquet, column.description, column.name)
            for column in self.columns
            if column.parquet
        ]
        return (*declared, *self.metrics)

    @property
    def rules(self) -> dict[str, Rule]:
        """The rule of each column."""
        return {column.name: column.accepts for column in self.columns}


def parent(name: str, table: str, description: str, *, optional: bool = False) -> Column:
    """Returns a column with the key of the parent row."""
    return Column(name, KEY, description, optional=optional, references=table, is_parent=True)


def reference(name: str, table: str, description: str, *, optional: bool = True) -> Column:
    """Returns a column with the key of a row that is deleted independently of this one."""
    return Column(name, KEY, description, optional=optional, references=table)


def metric(name: str, description: str, sql: str) -> ParquetColumn:
    """Returns a count that only the Parquet export has."""
    return ParquetColumn(name, "count", description, sql)


def numbered(table: str, label: str) -> str:
    """Returns the SQL of a name's replacement: a word, and the position of the row in its table."""
    return f"'{label} ' || (SELECT count(*) FROM {table} AS other WHERE other.id <= {table}.id)"


# rows that are changed in place
REVISED = (
    Column(
        "revision",
        COUNT,
        "counts changes; of two states of a row the greater is kept",
        rules.whole(1, MAX_REVISION),
        parquet=False,
    ),
    Column(
        "changed_at",
        TIME,
        "when it was changed; decides between states of one revision",
        rules.time_or_empty,
        parquet=False,
    ),
)
# condition: the row belongs to a run that has ended
ENDED = "run_id NOT IN (SELECT id FROM {schema}.runs WHERE state = 'running')"
