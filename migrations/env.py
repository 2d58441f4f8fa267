"""Alembic environment: runs on the connection that the catalog hands over."""

from alembic import context

from esicatalog.catalog.schema import metadata
from esicatalog.catalog.views import FULL_TEXT
from esicatalog.errors import CatalogError

connection = context.config.attributes["connection"]


def include_object(item: object, name: str | None, kind: str, reflected: bool, compare_to: object) -> bool:
    """Leave out what the views module makes: the full-text table with its shadow tables."""
    return not (kind == "table" and name is not None and name.startswith(FULL_TEXT))


context.configure(
    connection=connection,
    target_metadata=metadata,
    include_object=include_object,
    render_as_batch=connection.dialect.name == "sqlite",
    transaction_per_migration=False,
)
try:
    context.run_migrations()
except NotImplementedError as refusal:
    # Migrations stand alone, without the package's errors; none leads back.
    raise CatalogError(str(refusal)) from refusal
