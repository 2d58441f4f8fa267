"""C header for the IgH EtherLab master 1.5 and 1.6: what an application needs to configure and use devices."""

from collections.abc import Iterator, Sequence

from esicatalog.errors import InputError
from esicatalog.export.c_text import comment_lines
from esicatalog.export.configuration import Configuration
from esicatalog.export.esc_registers import register_remarks
from esicatalog.export.headings import heading_lines, title_line
from esicatalog.export.igh_device import DeviceCode, device_code
from esicatalog.export.igh_limits import lrw_remarks, unassigned_remarks
from esicatalog.export.igh_startup import WATCHDOG_REGISTERS, start_mode_remarks, timeout_remarks, unsendable_remarks
from esicatalog.export.names import checked_prefix, unique_names
from esicatalog.export.rendering import render
from esicatalog.export.scan_bus import BusConfigurations
from esicatalog.words import counted

TARGET = "IgH EtherLab 1.5 and 1.6 configuration"


def igh_header(configuration: Configuration) -> str:
    """The header for one device. Raises :class:`InputError` for what the master's structures cannot hold."""
    return _header(
        configuration.prefix,
        list(_heading_lines(configuration)),
        [(device_code(configuration), [])],
        [(configuration, configuration.prefix)],
        configuration.cycle_ns,
    )


_BUS = "bus"
"""Name of a bus that has no other, in the include guard alone."""


def igh_bus_header(bus: BusConfigurations, name: str | None = None) -> str:
    """One header for the slaves of a bus; what equal slaves share stands there once.

    Slaves are named after their device and position, behind ``name`` where it is given: headers of several buses need
    different ones. The header says which slaves are not there and why, and what of the listing was not understood.
    Raises :class:`InputError` for what the master's structures cannot hold, for two slaves at one place and for a name
    that cannot begin names.
    """
    configurations, left_out, unread = bus
    if not configurations:
        raise InputError("; ".join(("no slave of the bus can be configured", *left_out, *unread)))
    _check_places(configurations)
    kinds: list[Configuration] = []
    kind_of = [_kind(configuration, kinds) for configuration in configurations]
    prefix = checked_prefix(name) if name is not None else _BUS
    begin = f"{prefix}_" if name is not None else ""
    kind_names = unique_names(
        [(f"{begin}{kind.prefix}", f"{begin}{kind.prefix}_{kind.subject.revision_no:x}") for kind in kinds], [prefix]
    )
    kinds = [kind._replace(prefix=kind_name) for kind, kind_name in zip(kinds, kind_names, strict=True)]
    slave_names = unique_names(
        [
            (f"{kind_names[kind]}_{_place(configuration)}",)
            for configuration, kind in zip(configurations, kind_of, strict=True)
        ],
        [prefix, *kind_names],
    )
    lines = [title_line(TARGET, _slaves_of(bus))]
    if left_out:
        lines += ["", f"NOT ALL SLAVES: {len(left_out)} more of the bus cannot be configured by this header:"]
        lines += [f"- {words}" for words in left_out]
    if unread:
        lines += ["", "CHECK THAT THIS IS THE BUS: of its listing this is missing or was not understood:"]
        lines += [f"- {words}" for words in unread]
    return _header(
        prefix,
        lines,
        [(device_code(kind), list(_heading_lines(kind))[2:]) for kind in kinds],
        [
            (configuration._replace(prefix=kinds[kind].prefix), slave_name)
            for configuration, kind, slave_name in zip(configurations, kind_of, slave_names, strict=True)
        ],
        configurations[0].cycle_ns,
    )


def _slaves_of(bus: BusConfigurations) -> str:
    """How many slaves of how many; of all of them only where nothing speaks for more."""
    count, listed = len(bus.configurations), len(bus.configurations) + len(bus.left_out)
    if bus.unread:
        return f"{count} of the {counted(listed, 'slave')} that {'was' if listed == 1 else 'were'} read of a bus"
    return f"{count} of the {listed} slaves of a bus" if bus.left_out else f"a bus of {counted(count, 'slave')}"


def _heading_lines(configuration: Configuration) -> Iterator[str]:
    device = configuration.subject.device
    remarks = (
        *configuration.remarks,
        *start_mode_remarks(configuration),
        *configuration.copy_remarks,
        *timeout_remarks(device),
        *register_remarks(device, "IgH", WATCHDOG_REGISTERS),
        *unassigned_remarks(configuration),
        *unsendable_remarks(configuration),
        *lrw_remarks(device, "register its outputs in one domain and its inputs in another"),
    )
    return heading_lines(configuration, TARGET, remarks)


def _check_places(configurations: Sequence[Configuration]) -> None:
    places = [(configuration.choice.alias, configuration.choice.position) for configuration in configurations]
    for alias, position in places:
        if places.count((alias, position)) > 1:
            raise InputError(f"two slaves stand at alias {alias}, position {position}; give the listing of one bus")


def _kind(configuration: Configuration, kinds: list[Configuration]) -> int:
    """Position among the kinds of devices; a new one is added. Slaves differ from their kind in their place only."""
    choice = configuration.choice._replace(alias=0, position=0)
    for number, kind in enumerate(kinds):
        if kind.subject == configuration.subject and kind.choice == choice:
            return number
    kinds.append(configuration._replace(choice=choice))
    return len(kinds) - 1


def _place(configuration: Configuration) -> str:
    choice = configuration.choice
    return f"alias{choice.alias}_{choice.position}" if choice.alias else str(choice.position)


def _header(
    name: str,
    heading: Sequence[str],
    devices: Sequence[tuple[DeviceCode, Sequence[str]]],
    slaves: Sequence[tuple[Configuration, str]],
    cycle_ns: int,
) -> str:
    return render(
        "igh.h.j2",
        name=name,
        heading=comment_lines(heading),
        devices=[(device, comment_lines(lines)) for device, lines in devices],
        slaves=[
            (
                next(device for device, _ in devices if device.prefix == configuration.prefix),
                configuration.choice,
                slave,
            )
            for configuration, slave in slaves
        ],
        cycle_ns=cycle_ns,
        needs_bits=any(device.needs_bits for device, _ in devices),
        needs_cycle=any(device.needs_cycle for device, _ in devices),
    )
