"""esicatalog identify"""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, TypeVar

import click
import msgspec

from esicatalog.cli.common import (
    EXIT_NO,
    FILE,
    NUMBER,
    Command,
    catalog_to_ask,
    db_option,
    format_option,
    named_file,
    print_json,
    read_as,
    read_text_as,
    reporting_errors,
    table_lines,
)
from esicatalog.errors import InputError
from esicatalog.identity import UINT32_MAX, parse_number

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from esicatalog.api import Catalog
    from esicatalog.catalog.results import Identification
    from esicatalog.scan.records import Scan, ScannedDictionary, ScannedPdos

Seen = TypeVar("Seen", bound="ScannedPdos | ScannedDictionary", covariant=True)


@click.command("identify", cls=Command)
@click.argument("vendor", type=NUMBER, required=False)
@click.argument("product", type=NUMBER, required=False)
@click.argument("revision", type=NUMBER, required=False)
@click.option("--slaves", metavar="FILE", type=FILE, help="A scan: ethercat slaves -v, SOEM slaveinfo, CSV; - = stdin.")
@click.option("--eni", metavar="FILE", type=FILE, help="The slaves of a master configuration (ENI).")
@click.option("--sii", metavar="FILE", type=FILE, help="The device of an EEPROM image, raw or Intel HEX.")
@click.option(
    "--pdos", metavar="[POS=]FILE", multiple=True, help="With --slaves: ethercat pdos, compared with the ESI."
)
@click.option(
    "--sdos", metavar="[POS=]FILE", multiple=True, help="With --slaves: ethercat sdos, compared with the ESI."
)
@db_option
@format_option("table", "json")
@reporting_errors
def command(
    vendor: int | None,
    product: int | None,
    revision: int | None,
    slaves: Path | None,
    eni: Path | None,
    sii: Path | None,
    pdos: tuple[str, ...],
    sdos: tuple[str, ...],
    db: str,
    output_format: str,
) -> None:
    """Say what a device is, or every slave of a bus, and which documents describe it.

    Numbers are written 0x1097, #x1097 or 4247. Without exact description the nearest one is named with the reason.
    Vendor 0 and product 0 are none: so masters print a slave whose SII they did not read.
    Exit code 1 when nothing of the product is known (of a scan: of no slave).
    """
    _check_usage(vendor, product, slaves, eni, sii, bool(pdos or sdos))
    _check_one_reads_stdin([slaves, eni, sii, *(_placed(text)[1] for text in (*pdos, *sdos))])
    scan = _scan(slaves, eni)
    if scan is not None:
        from esicatalog.cli.bus_sheet import bus_lines
        from esicatalog.scan.front import read_pdos, read_sdos

        told = list(scan.finding_lines)
        seen_pdos = _seen("--pdos", pdos, read_pdos, told)
        seen_objects = _seen("--sdos", sdos, read_sdos, told)
        with catalog_to_ask(db) as catalog:
            buses = catalog.identify_scan(scan, seen_pdos, seen_objects)
        if output_format == "json":
            print_json([slave.as_json() for bus in buses for slave in bus.slaves])
        else:
            for line in bus_lines(buses):
                click.echo(line)
        for words in told:
            click.echo(words, err=True)
        if not any(slave.identification.device for bus in buses for slave in bus.slaves):
            sys.exit(EXIT_NO)
        return
    identity: tuple[int, int, int | None] = (vendor or 0, product or 0, revision)
    findings: list[str] = []
    beside: dict[str, object] = {}
    if sii is not None:
        identity, findings = _of_image(sii)
        beside = {"image": {"findings": findings}}
    with catalog_to_ask(db) as catalog:
        answer = catalog.identify(*identity)
        hint = _hexadecimal_hint(catalog, answer) if sii is None else None
    if output_format == "json":
        print_json(answer.as_json() | beside)
    else:
        _print_answer(answer, findings)
    if hint is not None:
        click.echo(hint, err=True)
    if answer.device is None:
        sys.exit(EXIT_NO)


def _hexadecimal_hint(catalog: "Catalog", answer: "Identification") -> str | None:
    """What is known by the digits that an unknown identity has in decimal, read as hexadecimal ones."""
    asked = (answer.vendor_id, answer.product_code)
    vendor_id, product_code = (int(str(number), 16) for number in asked)
    if answer.device is not None or max(vendor_id, product_code) > UINT32_MAX:
        return None
    found = catalog.identify(vendor_id, product_code).device
    if found is None:
        return None
    read, meant = " ".join(map(str, asked)), f"0x{vendor_id:x} 0x{product_code:x}"
    return f"decimal {read} is unknown; {meant} would be {found.device.type or 'known'}"


def _check_usage(
    vendor: int | None, product: int | None, slaves: Path | None, eni: Path | None, sii: Path | None, beside: bool
) -> None:
    doors = [vendor is not None, slaves is not None, eni is not None, sii is not None]
    ways = "VENDOR PRODUCT [REVISION], --slaves FILE, --eni FILE or --sii FILE"
    if sum(doors) > 1:
        raise InputError(f"give only one of {ways}")
    if not any(doors) or (vendor is not None and product is None):
        raise InputError(f"say who: {ways}")
    if beside and slaves is None:
        raise InputError("--pdos and --sdos are compared with the slaves of a scan; give --slaves FILE too")


def _check_one_reads_stdin(files: "Sequence[Path | None]") -> None:
    if sum(str(file) == "-" for file in files) > 1:
        raise InputError("standard input can be read once; give files, or - for one of them only")


def _scan(slaves: Path | None, eni: Path | None) -> "Scan | None":
    from esicatalog.scan.front import read_eni, read_scan

    if slaves is not None:
        return read_text_as(slaves, read_scan)
    return read_as(eni, read_eni) if eni is not None else None


class _Printed(Protocol[Seen]):
    """Lists of slaves in what a master printed."""

    @property
    def slaves(self) -> "tuple[Seen, ...]": ...


def _seen(
    option: str, texts: tuple[str, ...], read: "Callable[[str], _Printed[Seen]]", told: list[str]
) -> "list[Seen]":
    """Lists that a master printed, each at the ring position that the option names.

    What of them was not understood goes to ``told``, and that a heading names another slave.
    """
    from esicatalog.scan.records import ScanFinding

    found: list[Seen] = []
    for text in texts:
        position, path = _placed(text)
        place = {"position": position} if position is not None else {}
        origin = f"{option} {text}"
        for item in read_text_as(path, read).slaves:
            findings = item.findings
            if item.position not in (None, place.get("position", item.position)):
                message = f"the heading before it names slave {item.position}"
                findings += (ScanFinding(line=item.line, message=message),)
            told += [f"{origin}, line {finding.line}: {finding.message}" for finding in findings]
            found.append(msgspec.structs.replace(item, origin=origin, findings=findings, **place))
    return found


def _placed(text: str) -> tuple[int | None, Path]:
    """Ring position and file of ``[POSITION=]FILE``."""
    position, equals, path = text.partition("=")
    if equals and position.isdigit():
        return parse_number(position, "position", 0xFFFF), named_file(path)
    return None, named_file(text)


def _of_image(path: Path) -> tuple[tuple[int, int, int], list[str]]:
    """Whose EEPROM image it is, and what is odd about it."""
    from esicatalog.sii.files import read_sii

    image = read_as(path, read_sii)
    header = image.header
    return (header.vendor_id, header.product_code, header.revision_no), list(image.findings)


def _print_answer(answer: "Identification", image_findings: "Sequence[str]") -> None:
    click.echo(f"{answer.match}: {answer.reason}")
    for finding in image_findings:
        click.echo(f"image: {finding}")
    for variant in answer.variants:
        device = variant.device
        which = f", variant {device.variant}" if len(answer.variants) > 1 else ""
        click.echo(f"\n{device.type}  {device.name or ''}{which}")
        click.echo(f"  {device.vendor or 'vendor without name'}  {device.identity_text}")
        if device.hidden:
            click.echo("  hidden: another description of the vendor supersedes it (HideType)")
        for source in variant.sources:
            click.echo(f"  described in {source.member}, line {source.line}")
    for warning in answer.warnings:
        click.echo(f"\nwarning: {warning}")
    if answer.candidates:
        click.echo("\nOthers in the catalog:" if answer.device else "\nNearest in the catalog:")
        rows = [
            [device.identity_text, device.type or "", device.name or "", "hidden" if device.hidden else ""]
            for device in answer.candidates
        ]
        for line in table_lines(rows, ("identity", "type", "name", "")):
            click.echo(f"  {line}")
