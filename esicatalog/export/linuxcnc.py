"""ethercat-conf.xml for the generic driver of LinuxCNC-Ethercat (documentation: configuration-reference.md)."""

import re
from collections.abc import Iterable, Iterator
from itertools import chain
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.export.c_access import on_byte
from esicatalog.export.c_text import comment_text, wrapped
from esicatalog.export.clocks import Clocks, Time
from esicatalog.export.configuration import Configuration
from esicatalog.export.esc_registers import register_remarks
from esicatalog.export.headings import heading_lines, op_mode_words
from esicatalog.export.igh_files import Listed, listed, sign_words
from esicatalog.export.igh_limits import pieces
from esicatalog.export.igh_startup import WATCHDOG_REGISTERS, off_beat, watchdog
from esicatalog.export.init_cmds import StartCommand
from esicatalog.export.mode_commands import mode_remarks
from esicatalog.export.rendering import render
from esicatalog.export.sm_configuration import MappedEntry, SmConfiguration
from esicatalog.model.sm_facts import OUTPUT
from esicatalog.remarks import Remarking, in_turn, remarked

PROGRAM = "LinuxCNC-Ethercat"
_MAX_NAME = 47
"""HAL_NAME_LEN of LinuxCNC 2.9, for the whole name of a pin."""
_PIN_START = "lcec.0."
_MAX_SLAVE_NAME = 15
_NAMES_OF_SLAVE = (
    "slave-online",
    "slave-oper",
    *(f"slave-state-{state}" for state in ("init", "preop", "safeop", "op")),
)
"""Pins that every slave has."""
_MAX_PINS = 256
"""LCEC_MAX_PDO_REG_COUNT."""
_PIN_BITS = 32
_SIGNED_BITS = (8, 16, 32)
_INT32_MAX = 0x7FFF_FFFF
_DATA_OF_LINE = 16
_HYPHENS = re.compile("-(?=-)")
_APART = 'In this comment "- -" stands for two hyphens, with which options begin: XML does not allow them in comments.'
"""Said where a remark names an option."""


class Pin(NamedTuple):
    """A HAL pin, whole or as part of an entry."""

    name: str
    type: str
    bit_length: int


class EntryElement(NamedTuple):
    """A pdoEntry: with one pin, with parts, or without a pin."""

    entry_index: str
    subindex: str
    bit_length: int
    pin: Pin | None
    parts: tuple[Pin, ...]
    comment: str


class PdoElement(NamedTuple):
    """A pdo with its entries."""

    pdo_index: str
    comment: str
    entries: tuple[EntryElement, ...]


class SmElement(NamedTuple):
    """A syncManager with its PDOs."""

    number: int
    direction: str
    comment: str
    pdos: tuple[PdoElement, ...]


class SdoElement(NamedTuple):
    """An sdoConfig; its data in several lines."""

    object_index: str
    subindex: str
    comment: str
    data: tuple[str, ...]


class DcElement(NamedTuple):
    """A dcConf."""

    comment: str
    assign_activate: str
    sync0_cycle: str
    sync0_shift: int
    sync1_cycle: str | None


class _Pins:
    """Names for the pins of a slave, and how many may still follow."""

    def __init__(self, slave_name: str) -> None:
        self._limit = _MAX_NAME - len(f"{_PIN_START}{slave_name}.")
        self._taken = set(_NAMES_OF_SLAVE)
        self._free = _MAX_PINS

    def take(self, identifier: str, types: Iterable[tuple[str, str, int]]) -> tuple[Pin, ...]:
        """Pins for one entry, of (suffix, type, length) each; none when there is no room for all of them."""
        wanted = list(types)
        if len(wanted) > self._free:
            return ()
        self._free -= len(wanted)
        plain, room = identifier.strip("_").replace("_", "-"), self._limit - max(len(suffix) for suffix, _, _ in wanted)
        name, number = _shortened(plain, room), 0
        while any(f"{name}{suffix}" in self._taken for suffix, _, _ in wanted):
            number += 1
            name = f"{_shortened(plain, room - len(str(number)) - 1)}-{number}"
        pins = tuple(Pin(f"{name}{suffix}", kind, length) for suffix, kind, length in wanted)
        self._taken.update(pin.name for pin in pins)
        return pins


def _shortened(name: str, room: int) -> str:
    """A name without its middle: what tells it from others, an axis for example, is its last word."""
    if len(name) <= room:
        return name
    begin, _, last = name.rpartition("-")
    begin = begin[: max(0, room - len(last) - 1)].rstrip("-")
    return f"{begin}-{last}" if begin else name[:room].rstrip("-")


def linuxcnc_configuration(configuration: Configuration) -> str:
    """The file for a bus with this device. Raises :class:`InputError` for what the driver cannot configure."""
    if configuration.choice.alias:
        raise InputError(f"{PROGRAM} finds slaves by their ring position: give no alias")
    found = listed(configuration, PROGRAM)
    device = configuration.subject.device
    slave_name = configuration.prefix[:_MAX_SLAVE_NAME].strip("_").replace("_", "-")
    pins = _Pins(slave_name)
    sync_managers, sm_remarks = remarked(in_turn(_sync_manager(sm, found, pins) for sm in found.sync_managers))
    sdos, sdo_remarks = remarked(_sdos(found.sdos))
    remarks = [
        *configuration.remarks,
        *found.remarks,
        *mode_remarks(configuration.modes, found.sdos),
        *register_remarks(device, PROGRAM, WATCHDOG_REGISTERS),
        *sm_remarks,
        *sdo_remarks,
    ]
    clocks = configuration.clocks
    dc = _dc(configuration, clocks) if clocks is not None else None
    if clocks is not None and (note := off_beat(clocks, configuration.cycle_ns)):
        remarks.append(note)
    heading = list(heading_lines(configuration, f"{PROGRAM} configuration", list(dict.fromkeys(remarks))))
    if any("--" in line for line in heading):
        heading += ["", _APART]
    return render(
        "linuxcnc.xml.j2",
        configuration=configuration,
        heading=[_comment(line) for line in wrapped(heading)],
        slave_name=slave_name,
        dc=dc,
        watchdog=watchdog(device),
        sdos=sdos,
        sync_managers=sync_managers,
    )


def _comment(text: str) -> str:
    """The text as it may stand in a comment: without two hyphens in a row, and none at its end."""
    shown = _HYPHENS.sub("- ", comment_text(text))
    return f"{shown} " if shown.endswith("-") else shown


def _sync_manager(sm: SmConfiguration, found: Listed, pins: _Pins) -> Remarking[SmElement]:
    pdos = []
    for pdo in sm.pdos:
        entries = yield from in_turn(_entry(entry, sm, found, pins) for entry in pdo.entries)
        pdos.append(PdoElement(f"{pdo.pdo_index:04x}", _comment(pdo.name), tuple(chain.from_iterable(entries))))
    return SmElement(sm.number, "out" if sm.direction == OUTPUT else "in", _comment(sm.usage), tuple(pdos))


def _entry(entry: MappedEntry, sm: SmConfiguration, found: Listed, pins: _Pins) -> Remarking[list[EntryElement]]:
    """One element for an entry; several for one that is longer than IgH can say."""
    if entry.entry_index == 0xFFFF or entry.subindex == 0xFF:
        raise InputError(f"{PROGRAM} cannot map {entry.place}: its parser refuses this index or subindex")
    place, comment = (f"{entry.entry_index:04x}", f"{entry.subindex:02x}"), _comment(entry.comment)
    if not entry.is_gap and entry.identifier not in found.repeated:
        types = _types(entry)
        taken = pins.take(entry.identifier, types) if types else ()
        if taken:
            yield from _type_remarks(entry, sm, taken[0])
            pin, parts = (taken[0], ()) if len(taken) == 1 else (None, taken)
            return [EntryElement(*place, entry.bit_length, pin, parts, comment)]
        why = f"{PROGRAM} registers {_MAX_PINS} at most" if types else "no HAL type takes it at its place"
        yield f"{entry.words} has no pin: {why}"
    return [EntryElement(*place, length, None, (), comment) for length in pieces(entry.bit_length)]


def _type_remarks(entry: MappedEntry, sm: SmConfiguration, pin: Pin) -> Iterator[str]:
    """What the generic driver, or an older version of it, makes of a value of this type."""
    is_output = sm.direction == OUTPUT
    if pin.type == "s32" and not is_output:
        if entry.bit_length not in _SIGNED_BITS:
            yield sign_words(entry, PROGRAM)
        elif entry.bit_length < _PIN_BITS and not on_byte(entry):
            yield (
                f"{entry.words}: older versions of {PROGRAM} read {entry.bit_length} bits that begin "
                "inside a byte without their sign"
            )
    if pin.type == "float-ieee" and is_output:
        yield f"older versions of {PROGRAM} write float-ieee as an integer"
    if pin.type == "float-double-ieee":
        yield f"float-double-ieee needs a version of {PROGRAM} that knows it"


def _types(entry: MappedEntry) -> list[tuple[str, str, int]]:
    """Suffix, HAL type and length of the pins of an entry."""
    value, length = entry.value, entry.bit_length
    if value.kind == "bytes" or (value.kind == "real" and not on_byte(entry)):
        return []
    if value.kind == "real":
        return [("", "float-ieee" if length == 32 else "float-double-ieee", length)]
    if length > _PIN_BITS:
        return [("-lo", "u32", _PIN_BITS), ("-hi", "u32", length - _PIN_BITS)]
    return [("", "bit" if length == 1 else "s32" if value.kind == "int" else "u32", length)]


def _sdos(commands: Iterable[StartCommand]) -> Remarking[list[SdoElement]]:
    elements = []
    for command in commands:
        if command.object_index == 0xFFFF or command.subindex == 0xFF:
            yield f"{command.words} is left out: the parser of {PROGRAM} refuses this index or subindex"
        elif command.complete_access and command.subindex:
            yield f"{command.words} is left out: {PROGRAM} sends complete access from subindex 0 only"
        else:
            elements.append(_sdo(command))
    return elements


def _sdo(command: StartCommand) -> SdoElement:
    data = command.data
    lines = (data[start : start + _DATA_OF_LINE].hex(" ") for start in range(0, len(data), _DATA_OF_LINE))
    subindex = "complete" if command.complete_access else f"{command.subindex:02x}"
    return SdoElement(f"{command.object_index:04x}", subindex, _comment(command.words), tuple(lines))


def _dc(configuration: Configuration, found: Clocks) -> DcElement:
    cycle_ns = configuration.cycle_ns
    return DcElement(
        _comment(op_mode_words(configuration)),
        f"{found.assign_activate:x}",
        _time(found.sync0_cycle, cycle_ns),
        found.sync0_shift_ns,
        _time(found.sync1_delay, cycle_ns) if found.signals.sync1 else None,
    )


def _time(time: Time, cycle_ns: int) -> str:
    """A multiple of appTimePeriod, or nanoseconds."""
    in_ns = int(time.in_ns(cycle_ns))
    if in_ns > _INT32_MAX:
        raise InputError(f"{PROGRAM} cannot read a time of {in_ns} ns")
    if time.cycles and time.cycles.denominator == 1 and not time.ns:
        return f"*{time.cycles}"
    return str(in_ns)
