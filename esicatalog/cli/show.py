"""esicatalog show"""

from typing import TYPE_CHECKING

import click

from esicatalog.cli.common import (
    IDENTITY,
    Command,
    catalog_to_ask,
    db_option,
    format_option,
    module_option,
    print_json,
    reporting_errors,
)
from esicatalog.identity import modules_by_slot

if TYPE_CHECKING:
    from esicatalog.identity import Identity, ModuleChoice


@click.command("show", cls=Command)
@click.argument("identity", type=IDENTITY)
@db_option
@module_option(
    "Plug this module into this slot (counted from 0), by its Type too where several share the ident: "
    "'0=0x1785/KL6021-A'. May be repeated; else the default modules.",
)
@format_option("table", "json")
@reporting_errors
def command(identity: "Identity", db: str, modules: "tuple[tuple[int, ModuleChoice], ...]", output_format: str) -> None:
    """Print the sheet of one device: sync managers, process image, PDOs, slots, InitCmds, DC modes, drive modes and
    findings.

    IDENTITY is VENDOR:PRODUCT[:REVISION][@VARIANT]; without REVISION the latest, with - as REVISION the description
    that names none. InitCmds are listed as they are sent: those of the plugged modules at their indices in the slots,
    without those of the device that yield to them. JSON has every fact, drive mode and evidence complete, with null for
    what is not known or not there; its records of the document (device, modules) leave out what has its default. Where
    it has several variants, these are descriptions of the identity that contradict each other.
    """
    from esicatalog.catalog.description import description_json
    from esicatalog.cli.sheet import device_sheet_lines

    choice = modules_by_slot(modules)
    with catalog_to_ask(db) as catalog:
        description = catalog.device(identity)
    if output_format == "json":
        print_json(description_json(description, choice))
    else:
        for line in device_sheet_lines(description, choice):
            click.echo(line)
