"""esicatalog export

A target is one function from :class:`Inputs` to text or bytes, declared with :func:`_target`.
"""

import functools
import sys
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import click

from esicatalog.cli.common import IDENTITY, PLUGGED, db_option, reporting_errors
from esicatalog.errors import InputError, NotFound
from esicatalog.export.choice import DEFAULT_CYCLE_NS, Choice, parse_pdo_choice
from esicatalog.export.soem import VERSIONS
from esicatalog.identity import Identity

if TYPE_CHECKING:
    from esicatalog.api import Catalog
    from esicatalog.export.configuration import Configuration
    from esicatalog.export.subject import Subject
    from esicatalog.scan.records import Scan, ScannedSlave

Option = Callable[[Callable[..., Any]], Callable[..., Any]]

_COMMON: tuple[Option, ...] = (
    click.argument("identity", type=IDENTITY, required=False),
    db_option,
    click.option("--esi", metavar="FILE", help="Take the device from this ESI file; no catalog is opened."),
    click.option("-o", "--output", metavar="OUT", help="Write to this file instead of stdout."),
    click.option(
        "--pdo", metavar="0x1600,...", help="Assign these PDOs; with chosen entries: 0x1A00=0x6041+0x6064+0x60FE:1."
    ),
    click.option("--module", "modules", metavar="SLOT=IDENT", multiple=True, type=PLUGGED, help="Plug this module."),
    click.option("--op-mode", metavar="POSITION|NAME", help="OpMode of the distributed clocks; else the default one."),
    click.option(
        "--cycle-ns", metavar="N", type=int, default=DEFAULT_CYCLE_NS, show_default=True, help="Bus cycle in ns."
    ),
    click.option("--name", metavar="PREFIX", help="Begin all generated names so; else the device's type."),
    click.option("--alias", metavar="N", type=int, default=0, show_default=True, help="Configured station alias."),
    click.option(
        "--position", metavar="N", type=int, default=0, show_default=True, help="Ring position, or behind the alias."
    ),
    click.option("--accept-revision", is_flag=True, help="Take the nearest revision when the exact one is missing."),
)


class Inputs(NamedTuple):
    """The device that is asked for, and what is chosen for it."""

    identity: Identity | None
    db: str
    esi: str | None
    accept_revision: bool
    choice: Choice

    def configuration(self) -> "Configuration":
        """The configured device. Raises :class:`InputError` and :class:`NotFound` with what to do."""
        from esicatalog.export.configuration import configure

        return configure(self.subject(), self.choice)

    def subject(self) -> "Subject":
        """The device by its ESI file or by the catalog."""
        from esicatalog.api import Catalog

        if self.esi is not None:
            return _subject_of_file(self.esi, self.identity)
        if self.identity is None:
            raise InputError("say which device: an IDENTITY, or --esi FILE")
        with Catalog.open(self.db) as catalog:
            return _subject_of_catalog(catalog, self.identity, self.accept_revision)


@click.group("export")
def command() -> None:
    """Generate configuration for a master from a description.

    IDENTITY is VENDOR:PRODUCT[:REVISION][@VARIANT]; without REVISION the latest. A description of another revision is
    refused unless --accept-revision is given.
    """


def _target(*extra: Option) -> Callable[[Callable[..., str | bytes]], click.Command]:
    """Make a command of a function from :class:`Inputs` and its own options to text or bytes."""

    def decorate(function: Callable[..., str | bytes]) -> click.Command:
        @functools.wraps(function)
        def run(
            identity: Identity | None, db: str, esi: str | None, output: str | None, accept_revision: bool, **rest: Any
        ) -> None:
            choice = Choice(
                pdos=parse_pdo_choice(pdo) if (pdo := rest.pop("pdo")) is not None else (),
                modules=dict(rest.pop("modules")),
                **{field: rest.pop(field) for field in ("op_mode", "cycle_ns", "name", "alias", "position")},
            )
            _write(function(Inputs(identity, db, esi, accept_revision, choice), **rest), output)

        callback: Callable[..., Any] = reporting_errors(run)
        for option in reversed((*_COMMON, *extra)):
            callback = option(callback)
        return command.command(function.__name__)(callback)

    return decorate


@_target(click.option("--scan", metavar="FILE", help="Slaves of a bus as a master printed them, - for stdin."))
def igh(inputs: Inputs, scan: str | None) -> str:
    """C header for the IgH EtherLab master 1.5 and 1.6.

    PDO tables, offsets, registration, typed accessors, start-up commands, distributed clocks, checks at compile time.
    --scan makes one header for all slaves of a bus.
    """
    from esicatalog.export.igh import igh_bus_header, igh_header

    if scan is None:
        return igh_header(inputs.configuration())
    if inputs.identity is not None or inputs.esi is not None:
        raise InputError("--scan names the devices itself: give neither IDENTITY nor --esi")
    if inputs.choice.pdos or inputs.choice.modules or inputs.choice.op_mode is not None:
        raise InputError("--scan takes the default PDOs, modules and OpModes; choose them for one device at a time")
    configurations, remarks = _configurations_of_scan(inputs, scan)
    return igh_bus_header(configurations, remarks, _bus_name(inputs.choice.name))


@_target(click.option("--sii", metavar="FILE", help="Print what this EEPROM image holds."))
def cstruct(inputs: Inputs, sii: str | None) -> bytes:
    """What ``ethercat cstruct`` of IgH EtherLab prints for the device.

    Its literal EC_WD_DISABLE switches output watchdogs off; the header of ``export igh`` is the one to use.
    """
    from esicatalog.export.cstruct import cstruct_of_configuration, cstruct_of_image
    from esicatalog.sii.decode import decode_sii
    from esicatalog.sii.files import image_bytes

    if sii is None:
        return cstruct_of_configuration(inputs.configuration()).encode()
    if inputs.identity is not None or inputs.esi is not None:
        raise InputError("--sii says everything itself: give neither IDENTITY nor --esi")
    image = decode_sii(image_bytes(_read(sii)))
    return cstruct_of_image(image, inputs.choice.position).encode("utf-8", "surrogateescape")


@_target(
    click.option("--soem", type=click.Choice(VERSIONS), default=VERSIONS[-1], show_default=True, help="SOEM version.")
)
def soem(inputs: Inputs, soem: str) -> str:
    """C header for SOEM: configuration hook, distributed clocks, process image."""
    from esicatalog.export.soem import soem_header

    return soem_header(inputs.configuration(), soem)


def _subject_of_file(name: str, identity: Identity | None) -> "Subject":
    from esicatalog.esi.reader import read_esi
    from esicatalog.export.subject import choose_subject, subjects_of_document

    file_name = Path(name).name
    return choose_subject(subjects_of_document(read_esi(name).document, file_name), identity, file_name)


def _subject_of_catalog(catalog: "Catalog", identity: Identity, accept_revision: bool) -> "Subject":
    """The exact description, or the one that the catalog ranks first where that is accepted."""
    answer = catalog.identify(identity.vendor_id, identity.product_code, identity.revision_no)
    if identity.revision_no is None or answer.match == "exact":
        return _described(catalog, identity)
    if answer.device is None:
        raise NotFound(f"{identity}: {answer.reason}")
    found = answer.device.device
    if not accept_revision:
        raise NotFound(f"{identity}: {answer.reason}; --accept-revision takes {found.identity_text}")
    if found.vendor_id is None or found.product_code is None:
        raise NotFound(f"{identity}: {answer.reason}")
    words = f"asked for {identity}, described is {found.identity_text}: {answer.reason}"
    click.echo(f"esicatalog: accepted, {words}", err=True)
    nearest = Identity(found.vendor_id, found.product_code, found.revision_no, found.variant)
    return _described(catalog, nearest).standing_in(words)


def _described(catalog: "Catalog", identity: Identity) -> "Subject":
    from esicatalog.export.subject import subject_of_description

    description = catalog.device(identity)
    return subject_of_description(description.found, description.sources, description.device, description.modules)


def _configurations_of_scan(inputs: Inputs, name: str) -> "tuple[list[Configuration], list[str]]":
    """Configurations of the slaves that the catalog knows, and words about the others."""
    from esicatalog.api import Catalog
    from esicatalog.scan.front import read_scan

    scan = read_scan(_read(name).decode("utf-8", "replace"))
    _check_single_bus(scan)
    remarks: list[str] = []
    with Catalog.open(inputs.db) as catalog:
        found = list(_known_slaves(inputs, catalog, scan.slaves, remarks))
    return found, remarks


def _check_single_bus(scan: "Scan") -> None:
    buses = {slave.bus for slave in scan.slaves}
    if len(buses) > 1:
        raise InputError(f"the listing holds {len(buses)} buses; give one of them")


def _known_slaves(
    inputs: Inputs, catalog: "Catalog", slaves: "Iterable[ScannedSlave]", remarks: list[str]
) -> "Iterator[Configuration]":
    from esicatalog.export.configuration import configure

    known: dict[Identity, Subject | None] = {}
    refused: list[str] = []
    for slave in slaves:
        identity = slave.identity
        try:
            if identity is not None and identity not in known:
                known[identity] = _subject_of_scan(catalog, identity, inputs.accept_revision)
        except NotFound as error:
            refused.append(f"position {slave.position}: {error}")
            continue
        subject = known[identity] if identity is not None else None
        if subject is None:
            named = f" ({identity})" if identity is not None else ""
            remarks.append(f"position {slave.position}: {slave.name or 'slave'}{named} is unknown and left out")
            continue
        yield configure(subject, inputs.choice._replace(alias=0, position=slave.position, name=None))
    if refused:
        raise NotFound("; ".join(refused))


def _subject_of_scan(catalog: "Catalog", identity: Identity, accept_revision: bool) -> "Subject | None":
    """The device of a slave, None when the catalog knows nothing near. Raises :class:`NotFound` when not accepted."""
    if catalog.identify(identity.vendor_id, identity.product_code, identity.revision_no).device is None:
        return None
    if identity.revision_no is None and not accept_revision:
        raise NotFound(f"{identity}: the listing gives no revision; --accept-revision takes the latest description")
    return _subject_of_catalog(catalog, identity, accept_revision)


def _bus_name(name: str | None) -> str:
    from esicatalog.export.configuration import checked_prefix

    return checked_prefix(name) if name is not None else "bus"


def _read(name: str) -> bytes:
    try:
        return sys.stdin.buffer.read() if name == "-" else Path(name).read_bytes()
    except OSError as error:
        raise InputError(f"{name}: {error.strerror or error}") from error


def _write(result: str | bytes, output: str | None) -> None:
    data = result.encode() if isinstance(result, str) else result
    if output is None:
        sys.stdout.buffer.write(data)
        sys.stdout.buffer.flush()
        return
    try:
        Path(output).write_bytes(data)
    except OSError as error:
        raise InputError(f"{output}: {error.strerror or error}") from error
