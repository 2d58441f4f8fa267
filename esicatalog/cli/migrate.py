"""esicatalog migrate"""

import click

from esicatalog.cli.common import Command, db_option, reporting_errors


@click.command("migrate", cls=Command)
@db_option
@reporting_errors
def command(db: str) -> None:
    """Bring a catalog of an older version up to date. A catalog is never downgraded."""
    from esicatalog.api import Catalog
    from esicatalog.catalog.database import shown_target

    before, after = Catalog.migrate(db)
    shown = shown_target(db)
    click.echo(f"{shown}: schema {after}, nothing to do" if before == after else f"{shown}: schema {before} -> {after}")
