"""esicatalog devices"""

from collections.abc import Callable
from typing import Any

import click

from esicatalog.catalog.device_filter import IDENTIFICATIONS, PROTOCOLS, SYNC_SIGNALS
from esicatalog.catalog.filter_texts import PARAMETERS, VENDOR_WORDS
from esicatalog.cli.common import (
    BOUNDS,
    IDENTITY,
    MODES,
    NUMBER,
    OBJECT,
    Command,
    catalog_to_ask,
    db_option,
    format_option,
    print_rows,
    print_table,
    reporting_errors,
)
from esicatalog.words import counted

_CSV_COLUMNS = (
    "vendor_id_hex",
    "product_code_hex",
    "revision_no_hex",
    "variant",
    "vendor",
    "type",
    "name",
    "hidden",
    "evidence",
)


def _filter(name: str, **attributes: Any) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """The option of a filter."""
    parameter = PARAMETERS[name]
    return click.option(f"--{name}", parameter.field, help=parameter.words, multiple=parameter.repeated, **attributes)


@click.command("devices", cls=Command)
@db_option
@click.option("--vendor", metavar="V", help=VENDOR_WORDS)
@_filter("product", metavar="P", type=NUMBER)
@_filter("text", metavar="T")
@_filter("profile", metavar="N", type=NUMBER)
@_filter("mode", metavar="CSV[,CSP]", type=MODES, default=())
@_filter("strict", is_flag=True)
@_filter("sync", type=click.Choice(SYNC_SIGNALS))
@_filter("needs-dc", is_flag=True)
@_filter("protocol", type=click.Choice(PROTOCOLS))
@_filter("complete-access", is_flag=True)
@_filter("pdo-assign", is_flag=True)
@_filter("pdo-config", is_flag=True)
@_filter("bootstrap", is_flag=True)
@_filter("no-lrw", is_flag=True)
@_filter("identification", type=click.Choice(IDENTIFICATIONS))
@_filter("physics", metavar="YY")
@_filter("bytes-in", metavar="[<=|>=]N", type=BOUNDS)
@_filter("bytes-out", metavar="[<=|>=]N", type=BOUNDS)
@_filter("min-cycle-ns", metavar="[<=|>=]N", type=BOUNDS)
@_filter("e-bus-ma", metavar="[<=|>=]N", type=BOUNDS)
@_filter("axes", metavar="[<=|>=]N", type=BOUNDS)
@_filter("maps", metavar="IDX[:SUB]", type=OBJECT)
@_filter("not-maps", metavar="IDX[:SUB]", type=OBJECT)
@_filter("bits", metavar="N", type=NUMBER)
@_filter("object", metavar="IDX[:SUB]", type=OBJECT)
@_filter("like", metavar="IDENTITY", type=IDENTITY)
@_filter("all-variants", is_flag=True)
@_filter("include-hidden", is_flag=True)
@_filter("limit", metavar="N", type=NUMBER)
@format_option("table", "json", "csv")
@reporting_errors
def command(db: str, output_format: str, **filters: Any) -> None:
    """List the devices that fulfil all conditions, each with its evidence.

    Numbers are written 0x1097, #x1097 or 4247, subindices also with two hex digits as evidence shows them (0x6000:0A);
    10 to 99 are refused without prefix, for 0x6000:10 may mean either. An empty list is an answer too: exit code 0.
    What is listed is what the files declare or imply; read 0x6502 on the drive before it moves.
    """
    with catalog_to_ask(db) as catalog:
        found = catalog.devices(**filters)
    if output_format == "table":
        # Without the option no hidden one is listed.
        marks = ("hidden",) if filters["include_hidden"] else ()
        rows = [
            (
                device.identity_text,
                *(mark if device.hidden else "" for mark in marks),
                device.type or "",
                device.name or "",
                "; ".join(device.shown_evidence),
            )
            for device in found
        ]
        print_table(rows, ("identity", *("" for _ in marks), "type", "name", "evidence"))
        click.echo(counted(len(found), "device"), err=True)
    else:
        print_rows([device.as_json() for device in found], _CSV_COLUMNS, output_format)
