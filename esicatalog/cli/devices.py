"""esicatalog devices"""

from typing import Any

import click

from esicatalog.catalog.device_filter import IDENTIFICATIONS, PROTOCOLS, SYNC_SIGNALS
from esicatalog.cli.common import (
    BOUNDS,
    IDENTITY,
    MODES,
    NUMBER,
    OBJECT,
    Command,
    db_option,
    format_option,
    print_rows,
    print_table,
    reporting_errors,
)
from esicatalog.model.counting import counted

_CSV_COLUMNS = ("vendor_id_hex", "product_code_hex", "revision_no_hex", "variant", "vendor", "type", "name", "evidence")


@click.command("devices", cls=Command)
@db_option
@click.option("--vendor", metavar="V", help="Vendor id (digits, 0x… or #…), or a part of the vendor's name.")
@click.option("--product", "product_code", metavar="P", type=NUMBER, help="Product code.")
@click.option("--text", metavar="T", help="Words in vendor, type, name or identity; blank = all devices.")
@click.option("--profile", "profile_no", metavar="N", type=NUMBER, help="Profile number, e.g. 402.")
@click.option("--mode", "modes", metavar="CSV[,CSP]", type=MODES, default=(), help="Runs all these CiA 402 modes.")
@click.option("--strict", is_flag=True, help="With --mode: only the verdict yes, not likely.")
@click.option("--sync", type=click.Choice(SYNC_SIGNALS), help="Has an OpMode that generates this signal.")
@click.option("--needs-dc", is_flag=True, help="Runs with distributed clocks only.")
@click.option("--protocol", type=click.Choice(PROTOCOLS), help="Supports this mailbox protocol.")
@click.option("--complete-access", is_flag=True, help="Declares SDO complete access.")
@click.option("--pdo-assign", is_flag=True, help="Declares that PDOs can be assigned (0x1C12, 0x1C13).")
@click.option("--pdo-config", is_flag=True, help="Declares that PDO mappings can be changed.")
@click.option("--bootstrap", is_flag=True, help="Has a bootstrap mailbox.")
@click.option("--no-lrw", is_flag=True, help="Cannot handle LRW frames.")
@click.option("--identification", type=click.Choice(IDENTIFICATIONS), help="Returns an explicit identification so.")
@click.option("--physics", metavar="YY", help="Ports A to D: Y MII, K E-bus, H fast hot connect, blank unused.")
@click.option(
    "--bytes-in",
    metavar="[<=|>=]N",
    type=BOUNDS,
    help="Input bytes of the default process image, where they are known.",
)
@click.option(
    "--bytes-out",
    metavar="[<=|>=]N",
    type=BOUNDS,
    help="Output bytes of the default process image, where they are known.",
)
@click.option("--min-cycle-ns", metavar="[<=|>=]N", type=BOUNDS, help="Smallest bus cycle that the file tells.")
@click.option("--e-bus-ma", metavar="[<=|>=]N", type=BOUNDS, help="E-bus current; negative = supplies.")
@click.option("--axes", metavar="[<=|>=]N", type=BOUNDS, help="Number of CiA 402 axes.")
@click.option("--maps", metavar="IDX[:SUB]", multiple=True, type=OBJECT, help="A PDO maps this; may be repeated.")
@click.option("--not-maps", metavar="IDX[:SUB]", multiple=True, type=OBJECT, help="No PDO maps this.")
@click.option("--bits", metavar="N", type=NUMBER, help="Length of the entries named by --maps.")
@click.option("--object", "objects", metavar="IDX[:SUB]", multiple=True, type=OBJECT, help="The dictionary has this.")
@click.option("--like", metavar="IDENTITY", type=IDENTITY, help="Same process-image layout as this device.")
@click.option("--all-variants", is_flag=True, help="Also the descriptions that are not preferred.")
@click.option("--include-hidden", is_flag=True, help="Also revisions that their vendor hides (HideType).")
@click.option("--limit", metavar="N", type=NUMBER, help="At most so many.")
@format_option("table", "json", "csv")
@reporting_errors
def command(db: str, output_format: str, **filters: Any) -> None:
    """List the devices that fulfil all conditions, each with its evidence.

    Numbers are written 0x1097, #x1097 or 4247, subindices also with two hex digits as evidence shows them (0x6000:0A);
    10 to 99 are refused without prefix, for 0x6000:10 may mean either. An empty list is an answer too: exit code 0.
    What is listed is what the files declare or imply; read 0x6502 on the drive before it moves.
    """
    from esicatalog.api import Catalog

    with Catalog.open(db) as catalog:
        found = catalog.devices(**filters)
    if output_format == "table":
        print_table(
            [(d.identity_text, d.type or "", d.name or "", "; ".join(d.shown_evidence)) for d in found],
            ("identity", "type", "name", "evidence"),
        )
        click.echo(counted(len(found), "device"), err=True)
    else:
        print_rows([device.as_json() for device in found], _CSV_COLUMNS, output_format)
