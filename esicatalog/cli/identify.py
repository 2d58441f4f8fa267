"""esicatalog identify"""

import sys
from typing import TYPE_CHECKING

import click

from esicatalog.cli.common import EXIT_NO, NUMBER, db_option, format_option, print_json, reporting_errors, table_lines

if TYPE_CHECKING:
    from esicatalog.catalog.results import Identification


@click.command("identify")
@click.argument("vendor", type=NUMBER)
@click.argument("product", type=NUMBER)
@click.argument("revision", type=NUMBER, required=False)
@db_option
@format_option("table", "json")
@reporting_errors
def command(vendor: int, product: int, revision: int | None, db: str, output_format: str) -> None:
    """Say what a device with this identity is, and which documents describe it.

    Numbers are written 0x1097, #x1097 or 4247. Exit code 1 when no device of the catalog fits.
    """
    from esicatalog.api import Catalog

    with Catalog.open(db) as catalog:
        answer = catalog.identify(vendor, product, revision)
    if output_format == "json":
        print_json(answer.as_json())
    else:
        _print_answer(answer)
    if answer.device is None:
        sys.exit(EXIT_NO)


def _print_answer(answer: "Identification") -> None:
    click.echo(f"{answer.match}: {answer.reason}")
    for variant in answer.variants:
        device = variant.device
        which = f", variant {device.variant}" if len(answer.variants) > 1 else ""
        click.echo(f"\n{device.type}  {device.name or ''}{which}")
        click.echo(f"  {device.vendor or 'vendor without name'}  {device.identity_text}")
        for source in variant.sources:
            click.echo(f"  described in {source.member}, line {source.line}")
    if answer.candidates:
        click.echo("\nOthers in the catalog:" if answer.device else "\nNearest in the catalog:")
        rows = [[device.identity_text, device.type or "", device.name or ""] for device in answer.candidates]
        for line in table_lines(rows, ("identity", "type", "name")):
            click.echo(f"  {line}")
