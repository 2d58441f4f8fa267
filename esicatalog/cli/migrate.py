"""esicatalog migrate"""

import click

from esicatalog.cli.common import Command, db_option, reporting_errors


@click.command("migrate", cls=Command)
@db_option
@reporting_errors
def command(db: str) -> None:
    """Bring a catalog of an older version up to date. A catalog is never downgraded.

    It waits, up to a minute, for those who are reading an SQLite file.

    Its views and its search are made anew; views of your own stay. On PostgreSQL a view of your own that reads one of
    the catalog's is in the way: drop it before, make it anew afterwards. Who only reads needs the right to it again.
    """
    from esicatalog.api import Catalog
    from esicatalog.catalog.database import catalog_url, shown_target, sqlite_path

    before, after = Catalog.migrate(db)
    shown = shown_target(db)
    click.echo(f"{shown}: schema {after}, nothing to do" if before == after else f"{shown}: schema {before} -> {after}")
    if before != after and sqlite_path(catalog_url(db)) is None:
        click.echo("views and search are new: GRANT SELECT on them again to those who only read", err=True)
