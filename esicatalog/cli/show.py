"""esicatalog show"""

from typing import TYPE_CHECKING

import click

from esicatalog.cli.common import IDENTITY, db_option, format_option, print_json, reporting_errors

if TYPE_CHECKING:
    from esicatalog.identity import Identity


@click.command("show")
@click.argument("identity", type=IDENTITY)
@db_option
@format_option("table", "json")
@reporting_errors
def command(identity: "Identity", db: str, output_format: str) -> None:
    """Print the sheet of one device: identity, sync managers, process image, PDOs, InitCmds, DC modes, mailbox.

    IDENTITY is VENDOR:PRODUCT[:REVISION][@VARIANT]; without REVISION the latest.
    """
    from esicatalog.api import Catalog
    from esicatalog.cli.sheet import sheet_json, sheet_lines

    with Catalog.open(db) as catalog:
        description = catalog.device(identity)
    if output_format == "json":
        print_json(sheet_json(description))
    else:
        for line in sheet_lines(description):
            click.echo(line)
