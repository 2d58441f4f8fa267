"""Slave file for ethercat_driver_ros2, which its generic plugins load (documentation: Generic EtherCAT Slave).

The driver writes every output in every cycle: the command interface, or ``default`` while that is missing or NaN. So
each output has a default, and each value that the driver cannot place has ``mask: 0``, which leaves its bits alone.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.export.c_access import on_byte
from esicatalog.export.c_text import comment_lines, comment_text
from esicatalog.export.cia402_names import CIA402_NAMES
from esicatalog.export.configuration import Configuration
from esicatalog.export.esc_registers import NO_REGISTERS, register_remarks
from esicatalog.export.headings import heading_lines, op_mode_words
from esicatalog.export.igh_files import Listed, listed, sign_words
from esicatalog.export.igh_limits import pieces
from esicatalog.export.init_cmds import StartCommand, single_accesses
from esicatalog.export.mode_commands import mode_remarks
from esicatalog.export.names import unique_names
from esicatalog.export.rendering import render
from esicatalog.export.sm_configuration import MappedEntry, SmConfiguration
from esicatalog.model.cia402 import (
    AXIS_STEP,
    CONTROLWORD,
    DRIVE_MODES,
    MODES_DISPLAY,
    MODES_OF_OPERATION,
    STATUSWORD,
)
from esicatalog.model.drive_evidence import mode_code
from esicatalog.model.module_idents import MODULE_IDENT_LIST
from esicatalog.model.sm_facts import INPUT, OUTPUT
from esicatalog.remarks import Remarking, in_turn, remarked

PROGRAM = "ethercat_driver_ros2"
_INTERFACES = {
    CONTROLWORD: "control_word",
    STATUSWORD: "status_word",
    MODES_OF_OPERATION: "mode_of_operation",
    MODES_DISPLAY: "mode_of_operation",
    0x607A: "position",
    0x60FF: "velocity",
    0x6071: "effort",
    0x6064: "position",
    0x606C: "velocity",
    0x6077: "effort",
}
"""Names that ros2_control and the controllers of the driver use, by the CiA 402 object of the first axis."""
_INTERFACES_BY_NAME = {CIA402_NAMES[index]: interface for index, interface in _INTERFACES.items()}
"""The same for drives that have such values elsewhere: motion terminals (profile 5001) and SoE."""
_TARGET_POSITION, _ACTUAL_POSITION = 0x607A, 0x6064
_NOT_PLAIN = frozenset(("y", "n", "yes", "no", "on", "off", "true", "false", "null"))
_SDO_TYPES = {1: "uint8", 2: "uint16", 4: "int32", 8: "int64"}
"""By length; the driver reads values as 32 bit signed integers."""


class Row(NamedTuple):
    """One line of a list, and what it means."""

    text: str
    comment: str


class PdoRows(NamedTuple):
    """A PDO with its channels."""

    pdo_index: str
    comment: str
    channels: tuple[Row, ...]


class Side(NamedTuple):
    """How the driver calls things of one direction."""

    key: str
    interface: str


class PdoList(NamedTuple):
    """All PDOs of one direction."""

    side: Side
    pdos: tuple[PdoRows, ...]


_SIDES = {OUTPUT: Side("rpdo", "command_interface"), INPUT: Side("tpdo", "state_interface")}


def ros2_slave(configuration: Configuration) -> str:
    """The file for one device. Raises :class:`InputError` for what the driver cannot configure."""
    found = listed(configuration, PROGRAM)
    lists, list_remarks = remarked(in_turn(_pdo_list(configuration, found, side) for side in (OUTPUT, INPUT)))
    sdos, sdo_remarks = remarked(_sdos(found.sdos))
    remarks = [
        *configuration.remarks,
        *found.remarks,
        *mode_remarks(configuration.modes, list(filter(_is_sent, found.sdos)), starts_cyclic=True),
        *_dc_remarks(configuration),
        *register_remarks(configuration.subject.device, PROGRAM, NO_REGISTERS),
        *_drive_remarks(configuration, found),
        *list_remarks,
        *sdo_remarks,
    ]
    heading = heading_lines(configuration, f"{PROGRAM} slave configuration", remarks)
    return render(
        "ros2.yaml.j2",
        configuration=configuration,
        heading=comment_lines(heading),
        op_mode=comment_text(op_mode_words(configuration)),
        suits_drive_plugin=_suits_drive_plugin(configuration),
        sdos=sdos,
        lists=[item for item in lists if item.pdos],
        sync_managers=[_sync_manager(sm) for sm in found.sync_managers],
    )


def _pdo_list(configuration: Configuration, found: Listed, direction: str) -> Remarking[PdoList]:
    side = _SIDES[direction]
    sync_managers = [sm for sm in found.sync_managers if sm.is_described and sm.direction == direction]
    if len(sync_managers) > 1:
        numbers = ", ".join(f"SM{sm.number}" for sm in sync_managers)
        raise InputError(
            f"{numbers} have PDOs; {PROGRAM} assigns every {side.key} to each SyncManager of the direction"
        )
    reached = []
    for entry in (entry for sm in sync_managers for entry in sm.entries if entry.identifier not in found.repeated):
        if _value(entry, side):
            reached.append(entry)
        else:
            yield f"{entry.words} has no interface: {PROGRAM} has no type for it at its place"
    yield from _type_remarks(reached, side)
    interfaces = _interfaces(configuration, reached)
    modes = {item.object_index: item.wanted for item in configuration.modes if item.wanted is not None}
    pdos = (
        PdoRows(
            f"0x{pdo.pdo_index:04x}",
            comment_text(pdo.name),
            tuple(row for entry in pdo.entries for row in _channels(entry, side, interfaces, modes)),
        )
        for sm in sync_managers
        for pdo in sm.pdos
    )
    return PdoList(side, tuple(pdos))


def _type_remarks(entries: Sequence[MappedEntry], side: Side) -> Iterator[str]:
    """What the driver, or an older version of it, makes of some types."""
    values = [_value(entry, side) for entry in entries]
    if side.key == "tpdo":
        for entry, value in zip(entries, values, strict=True):
            if entry.value.kind == "int" and value.startswith("type: bit"):
                yield sign_words(entry, PROGRAM)
    if any(value.startswith("type: real") for value in values):
        yield f"real32 and real64 need a version of {PROGRAM} that knows these types"
    if side.key == "rpdo" and any(value.startswith("type: bit") for value in values):
        yield f"older versions of {PROGRAM} clear the rest of the byte when they write a bitN"


def _interfaces(configuration: Configuration, entries: Sequence[MappedEntry]) -> dict[str, str]:
    """Interface by identifier. Objects of CiA 402 choose first, whatever the vendor calls entries of his own."""
    names = {
        index + axis * AXIS_STEP: f"{name}_axis{axis}" if axis else name
        for axis in configuration.axes
        for index, name in _INTERFACES.items()
    }
    standard = [entry for entry in entries if entry.entry_index in names and not entry.subindex]
    others = [entry for entry in entries if entry.entry_index not in names or entry.subindex]
    first = unique_names([(names[entry.entry_index], entry.identifier) for entry in standard])
    then = unique_names([_candidates(configuration, entry) for entry in others], first)
    return {entry.identifier: name for entry, name in zip((*standard, *others), (*first, *then), strict=True)}


def _candidates(configuration: Configuration, entry: MappedEntry) -> tuple[str, ...]:
    """Names of an entry that is no object of CiA 402, from plain to precise."""
    own = (entry.identifier, f"{entry.identifier}_{entry.entry_index:04x}_{entry.subindex:02x}")
    stem, separator, axis = entry.identifier.partition("_axis")
    if not configuration.is_drive or stem not in _INTERFACES_BY_NAME or (separator and not axis.isdecimal()):
        return own
    return (f"{_INTERFACES_BY_NAME[stem]}{separator}{axis}", *own)


def _channels(
    entry: MappedEntry, side: Side, interfaces: Mapping[str, str], modes: Mapping[int, bytes]
) -> Iterator[Row]:
    """One row for an entry; several for one that is longer than IgH can say."""
    place, comment = f"index: 0x{entry.entry_index:04x}, sub_index: {entry.subindex}", comment_text(entry.comment)
    name = interfaces.get(entry.identifier)
    ending = f", default: {_default(entry, modes)}" if side.key == "rpdo" else ""
    if name is None:
        for length in pieces(entry.bit_length):
            yield Row(f"{place}, type: bit{length}, mask: 0{ending}", comment)
        return
    written = f'"{name}"' if name in _NOT_PLAIN else name
    yield Row(f"{place}, {_value(entry, side)}, {side.interface}: {written}{ending}", comment)


def _default(entry: MappedEntry, modes: Mapping[int, bytes]) -> int:
    """What is sent without a command: 0, or the mode of a start-up command, which the cyclic value must not undo."""
    data = modes.get(entry.entry_index, b"") if not entry.subindex else b""
    return int.from_bytes(data, "little", signed=entry.value.kind == "int")


def _value(entry: MappedEntry, side: Side) -> str:
    """Type, mask and factor for a value that the driver can read and write, else empty."""
    value, bit = entry.value, entry.bit_offset % 8
    if on_byte(entry) and value.kind != "bytes" and value.fills_container:
        return f"type: {value.kind}{value.bit_length}"
    if bit + entry.bit_length > 8 or value.kind not in ("int", "uint"):
        return ""
    mask, scale = ((1 << entry.bit_length) - 1) << bit, 1 << bit
    if entry.bit_length == 1:
        return f"type: bool, mask: {mask}"
    factor = f", factor: {scale if side.key == 'rpdo' else 1 / scale}" if bit else ""
    return f"type: bit{entry.bit_length}, mask: {mask}{factor}"


def _sdos(commands: Iterable[StartCommand]) -> Remarking[list[Row]]:
    rows = []
    for command in chain.from_iterable(map(_accesses, commands)):
        if not _is_sent(command):
            yield f"{command.words} is left out: {PROGRAM} sends integers that fit 32 bits, one subindex at a time"
            continue
        place = f"index: 0x{command.object_index:04x}, sub_index: {command.subindex}"
        rows.append(
            Row(
                f"{place}, type: {_SDO_TYPES[len(command.data)]}, value: {_sdo_value(command)}",
                comment_text(command.words),
            )
        )
    return rows


def _is_sent(command: StartCommand) -> bool:
    """Whether the driver can send it."""
    value = _sdo_value(command)
    return not command.complete_access and len(command.data) in _SDO_TYPES and -(1 << 31) <= value < 1 << 31


def _sdo_value(command: StartCommand) -> int:
    return int.from_bytes(command.data, "little", signed=len(command.data) > 2)


def _accesses(command: StartCommand) -> Iterable[StartCommand]:
    """What the driver sends for a command: the list of the modules, of which all is known, one by one."""
    is_list = command.complete_access and command.object_index == MODULE_IDENT_LIST and not command.subindex
    return single_accesses(command) if is_list else (command,)


def _sync_manager(sm: SmConfiguration) -> Row:
    pdos = _SIDES[sm.direction].key if sm.is_described else "~"
    return Row(f"index: {sm.number}, type: {sm.direction}, pdo: {pdos}", comment_text(sm.usage))


def _dc_remarks(configuration: Configuration) -> Iterable[str]:
    found, cycle_ns = configuration.clocks, configuration.cycle_ns
    if found is None or not (found.signals.sync0 or found.signals.sync1):
        return
    sync0 = found.sync0_cycle.in_ns(cycle_ns)
    if sync0 == cycle_ns and not found.sync0_shift_ns and not found.signals.sync1:
        return
    shift = f" with a shift of {found.sync0_shift_ns} ns" if found.sync0_shift_ns else ""
    sync1 = f" and SYNC1 {found.sync1_delay.in_ns(cycle_ns)} ns behind it" if found.signals.sync1 else ""
    yield (
        f"the OpMode asks for SYNC0 every {sync0} ns{shift}{sync1}; {PROGRAM} always sets SYNC0 to its own period with "
        "a shift of its own, and SYNC1 to no delay"
    )


def _suits_drive_plugin(configuration: Configuration) -> bool:
    """Whether the plugin EcCiA402Drive, which knows the first axis only, has something to command."""
    return 0 in configuration.axes and CONTROLWORD in _mapped(configuration, OUTPUT)


def _mapped(configuration: Configuration, direction: str) -> set[int]:
    """Indices, which is all that EcCiA402Drive knows objects by."""
    return {entry.entry_index for sm in configuration.images(direction) for entry in sm.entries}


def _drive_remarks(configuration: Configuration, found: Listed) -> Iterator[str]:
    """What EcCiA402Drive makes of it (generic_ec_cia402_drive.cpp)."""
    if not _suits_drive_plugin(configuration):
        return
    yield "the plugin EcCiA402Drive switches the drive on by itself where it does not know auto_state_transitions"
    if any(entry.is_gap for sm in found.sync_managers for pdo in sm.pdos for entry in pdo.entries):
        yield (
            "there are gaps (index 0x0000): EcCiA402Drive takes values behind a gap for other objects, and sends wrong "
            "targets, unless its processData goes by domain_map_, as in newer versions; else use GenericEcSlave"
        )
    if _TARGET_POSITION not in _mapped(configuration, OUTPUT):
        return
    read, wanted = _mapped(configuration, INPUT), configuration.modes[0].wanted
    if MODES_DISPLAY not in read:
        yield (
            "0x6061 is not mapped: without CSP read from there EcCiA402Drive sends 0 as target position, whatever is "
            "commanded (older versions: until one is commanded)"
        )
        return
    if _ACTUAL_POSITION not in read:
        yield (
            "0x6064 is not mapped: EcCiA402Drive cannot hold the actual position, its target position is 0 until one "
            "is commanded"
        )
    if wanted is not None and mode_code(wanted) == DRIVE_MODES["PP"].code:
        yield (
            "the start-up command sets PP: EcCiA402Drive sends a commanded position only while 0x6061 reads CSP (some "
            "versions: or PP; older ones: always), else the last position that it read"
        )
