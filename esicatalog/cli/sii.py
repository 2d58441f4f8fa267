"""esicatalog sii"""

import sys
from pathlib import Path

import click

from esicatalog.cli.common import (
    EXIT_NO,
    FILE,
    Group,
    catalog_to_ask,
    db_option,
    format_option,
    print_json,
    read_as,
    reporting_errors,
)


@click.group("sii", cls=Group)
def command() -> None:
    """Read EEPROM (SII) images."""


@command.command("decode")
@click.argument("file", type=FILE)
@format_option("table", "json")
@reporting_errors
def decode(file: Path, output_format: str) -> None:
    """Print what an EEPROM image says: header, strings, sync managers, PDOs, clocks, and what is odd about it.

    FILE is raw or Intel HEX, whatever its name; - reads standard input. No catalog is opened.
    """
    from esicatalog.sii.files import read_sii
    from esicatalog.sii.text import sheet_lines
    from esicatalog.sii.view import sii_json

    image = read_as(file, read_sii)
    if output_format == "json":
        print_json(sii_json(image))
    else:
        for line in sheet_lines(image):
            click.echo(line)


@command.command("verify")
@click.argument("file", type=FILE)
@db_option
@format_option("table", "json")
@reporting_errors
def verify(file: Path, db: str, output_format: str) -> None:
    """Compare an EEPROM image with the catalogued description of its identity.

    Exit code 1 when they differ in what a master uses (identity, mailboxes, sync managers, FMMUs, PDOs, clocks, flags
    and CoE details of General, and what of these categories cannot be read), when the check sum over the configuration
    words is wrong, which the device does not start with, and when the identity is not described exactly. What the
    description does not say is no difference, and its texts may be in any language that it has.
    """
    from esicatalog.sii.files import read_sii

    image = read_as(file, read_sii)
    with catalog_to_ask(db) as catalog:
        verified = catalog.verify_sii(image)
    if output_format == "json":
        print_json(verified.as_json())
    else:
        for line in verified.lines():
            click.echo(line)
    if not verified.agrees:
        sys.exit(EXIT_NO)
