"""esicatalog devices"""

import click

from esicatalog.cli.common import MAPPED, NUMBER, db_option, format_option, print_rows, print_table, reporting_errors
from esicatalog.errors import EsiCatalogError
from esicatalog.identity import parse_number

PROTOCOLS = ("coe", "eoe", "foe", "soe", "aoe", "voe")
_CSV_COLUMNS = ("vendor_id_hex", "product_code_hex", "revision_no_hex", "variant", "vendor", "type", "name", "evidence")


@click.command("devices")
@db_option
@click.option("--vendor", metavar="V", help="Vendor id, or a part of the vendor's name.")
@click.option("--product", metavar="P", type=NUMBER, help="Product code.")
@click.option("--text", metavar="T", help="Words in vendor, type, name or identity.")
@click.option("--profile", metavar="N", type=NUMBER, help="Profile number, e.g. 402.")
@click.option("--sync", type=click.Choice(["sync0", "sync1"]), help="Has an OpMode that generates this signal.")
@click.option("--protocol", type=click.Choice(PROTOCOLS), help="Supports this mailbox protocol.")
@click.option("--maps", metavar="IDX[:SUB]", multiple=True, type=MAPPED, help="A PDO maps this; may be repeated.")
@click.option("--not-maps", metavar="IDX[:SUB]", multiple=True, type=MAPPED, help="No PDO maps this.")
@click.option("--bits", metavar="N", type=NUMBER, help="Length of the entries named by --maps.")
@click.option("--object", "objects", metavar="IDX[:SUB]", multiple=True, type=MAPPED, help="The dictionary has this.")
@click.option("--complete-access", is_flag=True, help="Declares SDO complete access.")
@click.option("--all-variants", is_flag=True, help="Also the descriptions that are not preferred.")
@click.option("--limit", metavar="N", type=click.IntRange(0), help="At most so many.")
@format_option("table", "json", "csv")
@reporting_errors
def command(
    db: str,
    vendor: str | None,
    product: int | None,
    text: str | None,
    profile: int | None,
    sync: str | None,
    protocol: str | None,
    maps: tuple[tuple[int, int | None], ...],
    not_maps: tuple[tuple[int, int | None], ...],
    bits: int | None,
    objects: tuple[tuple[int, int | None], ...],
    complete_access: bool,
    all_variants: bool,
    limit: int | None,
    output_format: str,
) -> None:
    """List the devices that fulfil all conditions, each with its evidence.

    Numbers are written 0x1097, #x1097 or 4247. An empty list is an answer too: exit code 0.
    """
    from esicatalog.api import Catalog

    vendor_id, vendor_name = _vendor(vendor)
    with Catalog.open(db) as catalog:
        found = catalog.devices(
            vendor_id=vendor_id,
            vendor=vendor_name,
            product_code=product,
            text=text,
            profile_no=profile,
            sync=sync,
            protocol=protocol,
            maps=maps,
            not_maps=not_maps,
            bits=bits,
            objects=objects,
            complete_access=complete_access,
            all_variants=all_variants,
            limit=limit,
        )
    if output_format == "table":
        print_table(
            [(d.identity_text, d.type or "", d.name or "", "; ".join(d.evidence)) for d in found],
            ("identity", "type", "name", "evidence"),
        )
        click.echo(f"{len(found)} devices", err=True)
    else:
        print_rows([device.as_json() for device in found], _CSV_COLUMNS, output_format)


def _vendor(text: str | None) -> tuple[int | None, str | None]:
    """A vendor id when the text starts like a number, else a part of the name."""
    if text is None:
        return None, None
    if text[:1].isdigit() or text[:1] == "#":
        return parse_number(text, "vendor"), None
    if not text.strip():
        raise EsiCatalogError("--vendor is empty; give a number or a part of the name")
    return None, text
