"""esicatalog check"""

import sys

import click

from esicatalog.cli.common import EXIT_NO, Command, db_option, reporting_errors


@click.command("check", cls=Command)
@db_option
@reporting_errors
def command(db: str) -> None:
    """Verify the catalog: integrity, references, variants, content hash, every value of every description.

    That takes two or three times as long as the ingest took. The last line on stdout is the content hash alone. Exit
    code 1 when something is wrong.
    """
    from esicatalog.api import Catalog

    with Catalog.open(db) as catalog:
        result = catalog.check()
    click.echo(", ".join(f"{count} {name}" for name, count in result.counts.items()))
    for problem in result.problems:
        click.echo(f"problem: {problem}", err=True)
    click.echo(result.content_hash)
    if result.problems:
        sys.exit(EXIT_NO)
