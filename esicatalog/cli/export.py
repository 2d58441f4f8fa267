"""esicatalog export

A target is one function from :class:`Inputs` to text or bytes, declared with :func:`_target`.
"""

import functools
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from esicatalog.catalog.own_files import own_files
from esicatalog.cli.common import (
    FILE,
    IDENTITY,
    NUMBER,
    OUTPUT,
    Group,
    db_option,
    module_option,
    read_as,
    reporting_errors,
)
from esicatalog.cli.export_inputs import Inputs, configurations_of_scan, content_of_vendor, left_out_words
from esicatalog.errors import InputError
from esicatalog.export.choice import DEFAULT_CYCLE_NS, HEEDED, PARAMETERS, Choice, check_numbers, parse_pdo_choice
from esicatalog.export.soem import VERSIONS
from esicatalog.identity import Identity, modules_by_slot

Option = Callable[[Callable[..., Any]], Callable[..., Any]]

_PLAIN_FIELDS = ("op_mode", "cycle_ns", "name", "alias", "position")
"""Of a :class:`Choice`, those that options give as they are."""
_FILES_OF_TARGETS = ("scan", "sii", "merge")
"""Options of single targets that name a file to read."""

_DEVICE: tuple[Option, ...] = (
    click.argument("identity", type=IDENTITY, required=False),
    db_option,
    click.option("--esi", metavar="FILE", type=FILE, help="Take the device from this ESI file; no catalog is opened."),
    click.option(
        "-o",
        "--output",
        metavar="OUT",
        type=OUTPUT,
        help="Write to this file, none that is read; - = stdout, as without.",
    ),
    click.option("--accept-revision", is_flag=True, help="Take the nearest revision when the exact one is missing."),
)
_CHOICE: dict[str, Option] = {
    "pdos": click.option(
        "--pdo", metavar="0x1600,...", help="Assign these PDOs; with chosen entries: 0x1A00=0x6041+0x6064+0x60FE:1."
    ),
    "modules": module_option(
        "Plug this module, by its Type too where several share the ident: '0=0x1785/KL6021-A'.",
    ),
    "op_mode": click.option(
        "--op-mode",
        metavar="POSITION|NAME",
        help="OpMode of the distributed clocks; '#1' is position 1 even where a name is 1. Else the default one.",
    ),
    "cycle_ns": click.option(
        "--cycle-ns",
        metavar="N",
        type=NUMBER,
        help=f"Bus cycle in ns; else {DEFAULT_CYCLE_NS}, or what the OpMode fixes where that does not fit.",
    ),
    "name": click.option("--name", metavar="PREFIX", help="Begin all generated names so; else the device's type."),
    "alias": click.option(
        "--alias", metavar="N", type=NUMBER, default=0, show_default=True, help="Configured station alias."
    ),
    "position": click.option(
        "--position",
        metavar="N",
        type=NUMBER,
        default=0,
        show_default=True,
        help="Ring position; with an alias, the number of slaves behind it.",
    ),
}
"""What can be chosen for one device, by the field of :class:`Choice`."""


@click.group("export", cls=Group)
def command() -> None:
    """Generate configuration for a master, an EEPROM image or ESI XML from a description.

    IDENTITY is VENDOR:PRODUCT[:REVISION][@VARIANT]; without REVISION the latest, without VARIANT the preferred one,
    and it is told where others exchange something else. A description of another revision is refused unless
    --accept-revision is given.
    """


def _target(*extra: Option) -> Callable[[Callable[..., str | bytes]], click.Command]:
    """Make a command of a function from :class:`Inputs` and its own options to text or bytes.

    Its name is that of the target. All targets that heed any choice take the options of all choices, so that one set of
    options serves every master; what a target does not heed is told.
    """

    def decorate(function: Callable[..., str | bytes]) -> click.Command:
        target = function.__name__

        @functools.wraps(function)
        def run(
            identity: Identity | None, db: str, esi: Path | None, output: str | None, accept_revision: bool, **rest: Any
        ) -> None:
            choice = _choice(rest)
            notes = [f"{option} changes nothing in what {target} gives" for option in _unheeded(target, choice)]
            named = filter(None, (esi, *(rest.get(option) for option in _FILES_OF_TARGETS)))
            inputs = Inputs(
                identity, db, esi, accept_revision, choice, notes, output, [*own_files(db), *map(str, named)]
            )
            inputs.check_output(output)
            made = function(inputs, **rest)
            _write(made, output)
            for note in notes:
                click.echo(f"esicatalog: {note}", err=True)

        callback: Callable[..., Any] = reporting_errors(run)
        choosing = _CHOICE.values() if HEEDED[target] else ()
        for option in reversed((*_DEVICE, *choosing, *extra)):
            callback = option(callback)
        return command.command(target)(callback)

    return decorate


def _unheeded(target: str, choice: Choice) -> list[str]:
    """Options that choose something and that a target does not heed."""
    nothing = Choice()
    unheeded = [field for field in _PLAIN_FIELDS if field not in HEEDED[target]]
    chosen = [field for field in unheeded if getattr(choice, field) != getattr(nothing, field)]
    return [f"--{PARAMETERS[field]}" for field in chosen]


def _choice(options: dict[str, Any]) -> Choice:
    """The choice in the options, which are taken out of them; what a target does not offer is not chosen."""
    pdo, modules = options.pop("pdo", None), options.pop("modules", ())
    return Choice(
        pdos=parse_pdo_choice(pdo) if pdo is not None else (),
        modules=modules_by_slot(modules),
        **{field: options.pop(field) for field in _PLAIN_FIELDS if field in options},
    )


@_target(
    click.option("--scan", metavar="FILE", type=FILE, help="Slaves of a bus as a master printed them, - for stdin.")
)
def igh(inputs: Inputs, scan: Path | None) -> str:
    """C header for the IgH EtherLab master 1.5 and 1.6.

    PDO tables, offsets, registration, typed accessors, start-up commands, distributed clocks, checks at compile time.
    --scan makes one header for all slaves of a bus; the header and stderr name those that it leaves out, and what of
    the listing is missing or was not understood. It is made for one cycle, that of --cycle-ns or 1 ms. With
    --name the names of its devices have PREFIX before their types, as headers of two buses in one program need it.
    """
    from esicatalog.export.igh import igh_bus_header, igh_header

    if scan is None:
        return igh_header(inputs.configuration())
    bus = configurations_of_scan(inputs, scan)
    header = igh_bus_header(bus, inputs.choice.name)
    for words in (*bus.left_out, *bus.unread):
        click.echo(f"esicatalog: {words}", err=True)
    return header


@_target(click.option("--sii", metavar="FILE", type=FILE, help="Print what this EEPROM image holds."))
def cstruct(inputs: Inputs, sii: Path | None) -> bytes:
    """What ``ethercat cstruct`` of IgH EtherLab prints for the device; names begin with slave_POSITION.

    Its literal EC_WD_DISABLE switches output watchdogs off; the header of ``export igh`` is the one to use. What other
    exports remark goes to stderr.
    """
    from esicatalog.export.cstruct import cstruct_of_configuration, cstruct_of_image
    from esicatalog.export.mode_commands import mode_remarks
    from esicatalog.sii.files import read_sii

    if sii is None:
        configuration = inputs.configuration()
        remarks = (*configuration.remarks, *mode_remarks(configuration.modes, configuration.commands))
        inputs.notes.extend(words for words in remarks if words not in inputs.notes)
        return cstruct_of_configuration(configuration).encode()
    inputs.check_no_device("--sii")
    check_numbers(inputs.choice)
    if inputs.choice != Choice(position=inputs.choice.position):
        raise InputError("--sii prints what the image holds: no PDOs, modules or OpMode can be chosen")
    image = read_as(sii, read_sii)
    inputs.notes.extend(f"{sii}: {finding}" for finding in image.findings)
    return cstruct_of_image(image, inputs.choice.position).encode("utf-8", "surrogateescape")


@_target(
    click.option("--soem", type=click.Choice(VERSIONS), default=VERSIONS[-1], show_default=True, help="SOEM version.")
)
def soem(inputs: Inputs, soem: str) -> str:
    """C header for SOEM: configuration hook, distributed clocks, process image."""
    from esicatalog.export.soem import soem_header

    return soem_header(inputs.configuration(), soem)


@_target()
def pysoem(inputs: Inputs) -> str:
    """Python module for pysoem: configuration functions, process image as ctypes structures."""
    from esicatalog.export.pysoem import pysoem_module

    return pysoem_module(inputs.configuration())


@_target()
def ros2(inputs: Inputs) -> str:
    """Slave file for ethercat_driver_ros2.

    Nothing switches a drive on: automatic state transitions and fault reset are off.
    """
    from esicatalog.export.ros2 import ros2_slave

    return ros2_slave(inputs.configuration())


@_target()
def linuxcnc(inputs: Inputs) -> str:
    """ethercat-conf.xml for the generic driver of LinuxCNC-Ethercat."""
    from esicatalog.export.linuxcnc import linuxcnc_configuration

    return linuxcnc_configuration(inputs.configuration())


@_target(
    click.option(
        "--merge", metavar="DUMP", type=FILE, help="Keep what is the device's own in this image read from it."
    ),
    click.option("--fit", is_flag=True, help="Leave out names, then more, until the image fits; says what."),
    click.option(
        "--language", metavar="LCID", type=NUMBER, help="Texts in this language where the description has it."
    ),
)
def sii(inputs: Inputs, merge: Path | None, fit: bool, language: int | None) -> bytes:
    """EEPROM image of the device.

    For a device in the field use --merge with its own image: alias, serial number, factory data and private words
    stay, and what would change is told. It ends where that image ends, unless it needs more: what was not read is
    not written. Words about the image go to stderr.
    """
    from esicatalog.export.eeprom import eeprom_image
    from esicatalog.export.sii_summary import image_text
    from esicatalog.sii.encode import encode_sii
    from esicatalog.sii.files import read_sii

    subject = inputs.subject()
    dump = read_as(merge, read_sii) if merge is not None else None
    made = eeprom_image(subject, language=language, dump=dump, fit=fit)
    click.echo(image_text(subject, made.image, merged=made.merged, dropped=made.dropped), err=True)
    return encode_sii(made.image)


@_target(
    click.option(
        "--vendor",
        metavar="V",
        type=NUMBER,
        help="All devices and modules of this vendor in place of one device, preferred descriptions only.",
    ),
    click.option("--with-files", is_flag=True, help="Dictionary files beside OUT where the description has them."),
)
@click.pass_context
def esi(context: click.Context, inputs: Inputs, vendor: int | None, with_files: bool) -> bytes:
    """ESI XML of the device, made from the catalog alone: vendor, group, device, modules.

    Also of a device without revision (V:P:-). --vendor takes all devices, those without any codes too, each by its
    preferred description, and the modules that no slot of any device reaches; stderr names what is left out.
    """
    from esicatalog.export.esi import content_of, export_esi_files, export_vendor_esi

    if vendor is not None:
        content, unreached = content_of_vendor(inputs, vendor, not with_files)
    else:
        content, unreached = content_of([inputs.subject()]), ()
    if not with_files:
        written = export_vendor_esi(*content, unreached)
        inputs.notes.extend(left_out_words(written.left_out))
        return written.document
    output = context.params["output"]
    if output is None:
        raise InputError("--with-files writes several files; say where with -o OUT")
    path = Path(output)
    first, *others = export_esi_files(path.name, *content, unreached).items()
    for name, _ in others:
        inputs.check_output(path.parent / name)
    for name, made in others:
        beside = path.parent / name
        beside.parent.mkdir(parents=True, exist_ok=True)
        _write(made, str(beside))
    return first[1]


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
