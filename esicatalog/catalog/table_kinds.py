"""How tables are declared: columns with comments, and rows that belong to a device or module, or to another row."""

from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import types
from esicatalog.catalog.mapping import TABLE_RECORDS, codec

metadata = sa.MetaData(
    naming_convention={
        "ix": "ix_%(table_name)s_%(column_0_N_name)s",
        "uq": "uq_%(table_name)s_%(column_0_N_name)s",
        "fk": "fk_%(table_name)s_%(column_0_N_name)s",
        "pk": "pk_%(table_name)s",
        "ck": "ck_%(table_name)s_%(constraint_name)s",
    }
)


def integer(name: str, comment: str, *constraints: Any, **options: Any) -> sa.Column[Any]:
    """A column of whole numbers."""
    return sa.Column(name, types.integer(), *constraints, comment=comment, **options)


def text(name: str, comment: str, *constraints: Any, **options: Any) -> sa.Column[Any]:
    """A column of texts."""
    return sa.Column(name, types.text(), *constraints, comment=comment, **options)


def boolean(name: str, comment: str, **options: Any) -> sa.Column[Any]:
    """A column of 0 and 1."""
    return sa.Column(name, types.boolean(), comment=comment, **options)


def parent_column(parent: str) -> str:
    """Name of the column that refers to a parent table: ``pdo_id`` for ``pdos``."""
    return {"diagnostics": "diagnostics_id"}.get(parent, f"{parent[:-1]}_id")


def key(comment: str = "Row number; not stable between catalogs") -> sa.Column[Any]:
    """The number of a row, handed out by the writer."""
    return integer("id", comment, primary_key=True, autoincrement=True)


def reference(target: str, comment: str, **options: Any) -> sa.Column[Any]:
    """A column that refers to ``table.column``; its name is that of the row it refers to, unless given."""
    table, column = target.split(".")
    name = options.pop("name", f"{table[:-3] + 'y' if table.endswith('ies') else table[:-1]}_{column}")
    return integer(name, comment, sa.ForeignKey(target), **options)


def recorded(table: str) -> list[sa.Column[Any]]:
    """Columns of the table's record type."""
    return [
        sa.Column(column.name, types.BY_KIND[column.kind](), comment=column.doc)
        for column in codec(TABLE_RECORDS[table]).columns
    ]


def table(name: str, comment: str, *items: Any, **options: Any) -> sa.Table:
    """A table with a comment, whose columns take values of their type alone."""
    return sa.Table(name, metadata, *items, comment=comment, sqlite_strict=True, **options)


def owned(name: str, comment: str, *extra: sa.Column[Any], derived: tuple[sa.Column[Any], ...] = ()) -> sa.Table:
    """A table whose rows belong to exactly one device or module."""
    return table(
        name,
        comment,
        key(),
        reference("devices.id", "Device description that the row belongs to; NULL for a module's", index=True),
        reference("modules.id", "Module that the row belongs to; NULL for a device's", index=True),
        integer("position", "Position in document order, from 0", nullable=False),
        *extra,
        *recorded(name),
        *derived,
        sa.CheckConstraint("(device_id IS NULL) <> (module_id IS NULL)", name="one_owner"),
    )


def part(name: str, parent: str, comment: str, *derived: sa.Column[Any], indexed: bool = True) -> sa.Table:
    """A table whose rows belong to a row of another table; ``indexed`` unless an index of its own begins with it."""
    return table(
        name,
        comment,
        key(),
        reference(f"{parent}.id", "Row it belongs to", name=parent_column(parent), nullable=False, index=indexed),
        integer("position", "Position in document order, from 0", nullable=False),
        *recorded(name),
        *derived,
    )
