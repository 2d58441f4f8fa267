"""esicatalog snapshot"""

from pathlib import Path

import click

from esicatalog.cli.common import FILE, Command, reporting_errors


@click.command("snapshot", cls=Command)
@click.option("--from", "source", metavar="FILE|URL", required=True, help="The catalog to copy.")
@click.option(
    "--to",
    "target",
    metavar="FILE",
    type=FILE,
    required=True,
    help="The file to make; <hash> = the content hash, <state> = digest of the rest.",
)
@reporting_errors
def command(source: str, target: Path) -> None:
    """Copy a catalog into one read-only SQLite file, for `esicatalog serve --immutable`.

    Prints the file, which appears only when it is complete and verified; FILE.inspect.json beside it holds its row
    counts, and an ingest refuses it. A snapshot that holds the same already is left as it is, any other file is not
    touched: exit code 2. The content hash covers the descriptions and the documents that carry them; <state> tells the
    documents without devices and the versions that read and derive: name both where a snapshot is taken again and
    again.
    """
    from esicatalog.api import Catalog

    with Catalog.open(source, read_only=True) as catalog:
        snapshot = catalog.snapshot(target)
    click.echo(f"content hash {snapshot.content_hash}{', there already' if snapshot.was_there else ''}", err=True)
    click.echo(snapshot.path)
