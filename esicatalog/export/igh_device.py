"""The part of an IgH header that equal devices share: PDO tables, offsets type, accessors, configuration."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from esicatalog.export.c_access import (
    Function,
    Place,
    byte_count,
    on_byte,
    read_value,
    reader,
    real_from,
    real_to,
    whole_bytes,
    write_value,
    writer,
)
from esicatalog.export.c_text import comment_text
from esicatalog.export.configuration import Configuration
from esicatalog.export.igh_limits import check_limits, pieces
from esicatalog.export.igh_startup import Startup, startup
from esicatalog.export.sm_configuration import AssignedPdo, MappedEntry, SmConfiguration
from esicatalog.model.pdo_facts import carries_value
from esicatalog.model.sm_facts import OUTPUT, sm_facts
from esicatalog.words import counted

_DIRECTIONS = {OUTPUT: "EC_DIR_OUTPUT"}


class Registration(NamedTuple):
    """How the offset of an entry is found: by index and subindex, or by place where an earlier entry has the same."""

    entry: MappedEntry
    has_bit_position: bool
    sm: int
    pdo_position: int
    entry_position: int
    is_repeated: bool

    @property
    def bit_position(self) -> str:
        """The member of the offsets that takes the bit, as the master's functions take it."""
        return f"{self.entry.identifier}_bit_position" if self.has_bit_position else ""


class ArraySize(NamedTuple):
    """Bytes of an entry that is handled by pointer."""

    identifier: str
    byte_count: int


class ImageSize(NamedTuple):
    """Length of the process image of a SyncManager; ``terms`` are the lengths of its PDOs in bits."""

    sm: int
    bit_size: int
    byte_size: int
    terms: str


class DeviceCode(NamedTuple):
    """Everything that a header says once for equal devices."""

    configuration: Configuration
    prefix: str
    title: str
    entry_rows: tuple[str, ...]
    pdo_rows: tuple[str, ...]
    sync_rows: tuple[str, ...]
    sizes: tuple[ImageSize, ...]
    registrations: tuple[Registration, ...]
    members: tuple[str, ...]
    """Of the offsets type."""
    array_sizes: tuple[ArraySize, ...]
    accessors: tuple[Function, ...]
    repeated: tuple[Registration, ...]
    """Those that the table of registrations cannot tell apart."""
    startup: Startup

    @property
    def needs_bits(self) -> bool:
        """Whether an accessor needs the helpers for values that do not fill bytes."""
        return any("esicatalog_" in line for accessor in self.accessors for line in accessor.body)

    @property
    def needs_cycle(self) -> bool:
        """Whether a time depends on the bus cycle, or the bus cycle on a time."""
        clocks = self.startup.clocks
        return clocks is not None and clocks.needs_cycle


def device_code(configuration: Configuration) -> DeviceCode:
    """The shared part for one device. Raises :class:`InputError` for what the master's structures cannot hold."""
    check_limits(configuration)
    prefix = configuration.prefix
    assigned = [pdo for sm in configuration.sync_managers if sm.is_described for pdo in sm.pdos]
    registrations = tuple(_registrations(configuration))
    return DeviceCode(
        configuration,
        prefix,
        comment_text(configuration.subject.title),
        tuple(_entry_rows(assigned)),
        tuple(_pdo_rows(prefix, assigned)),
        tuple(_sync_rows(prefix, configuration.sync_managers)),
        tuple(_sizes(configuration)),
        registrations,
        tuple(_members(registrations)),
        tuple(
            ArraySize(item.entry.identifier, byte_count(item.entry))
            for item in registrations
            if item.entry.value.kind == "bytes"
        ),
        tuple(_accessor(prefix, configuration, item) for item in registrations),
        tuple(item for item in registrations if item.is_repeated),
        startup(configuration),
    )


def _entry_rows(pdos: Iterable[AssignedPdo]) -> Iterator[str]:
    for pdo in pdos:
        for entry in pdo.entries:
            lengths = list(pieces(entry.bit_length))
            for number, length in enumerate(lengths, 1):
                part = f", part {number} of {len(lengths)}" if len(lengths) > 1 else ""
                name = comment_text(entry.comment)
                yield f"{{0x{entry.entry_index:04x}, 0x{entry.subindex:02x}, {length}}}, /* {name}{part} */"


def _row_count(pdo: AssignedPdo) -> int:
    return sum(1 for entry in pdo.entries for _ in pieces(entry.bit_length))


def _pdo_rows(prefix: str, pdos: Iterable[AssignedPdo]) -> Iterator[str]:
    offset = 0
    for pdo in pdos:
        count = _row_count(pdo)
        slot = f", slot {pdo.slot_number}" if pdo.slot_number is not None else ""
        name = comment_text(f"{pdo.direction} {pdo.name}".strip())
        yield f"{{0x{pdo.pdo_index:04x}, {count}, {prefix}_pdo_entries + {offset}}}, /* {name}{slot} */"
        offset += count


def _sync_rows(prefix: str, sync_managers: Iterable[SmConfiguration]) -> Iterator[str]:
    """Assignments of the SyncManagers.

    Without PDOs, or with PDOs whose entries nobody describes, the master keeps what it reads from the device: told
    so, it would write an empty assignment or mapping.
    """
    offset = 0
    for sm in sync_managers:
        direction = _DIRECTIONS.get(sm.direction, "EC_DIR_INPUT")
        words = comment_text(_sm_words(sm))
        if sm.is_described:
            pdos = f"{len(sm.pdos)}, {prefix}_pdos + {offset}"
            yield f"{{{sm.number}, {direction}, {pdos}, EC_WD_DEFAULT}}, /* {words} */"
            offset += len(sm.pdos)
        elif sm.is_mailbox:
            yield f"{{{sm.number}, {direction}, 0, NULL, EC_WD_DEFAULT}}, /* {words} */"
        else:
            why = "entries of its PDOs are not described" if sm.pdos else "no PDO is assigned"
            yield f"/* {words}: {why}; left out, the master keeps what it reads from the device */"


def _sm_words(sm: SmConfiguration) -> str:
    control = sm.sync_manager.control_byte if sm.sync_manager is not None else None
    words = f"SM{sm.number} {sm.usage}".rstrip()
    if sm.sync_manager is None or control is None:
        return f"{words}, ControlByte not described"
    watchdog = "on" if sm_facts(sm.sync_manager).watchdog_trigger else "off"
    return f"{words}, ControlByte 0x{control:02X}: watchdog trigger {watchdog}"


def _sizes(configuration: Configuration) -> Iterator[ImageSize]:
    """Lengths that are those of the device: not where PDOs of required modules are missing."""
    for sm in configuration.sync_managers:
        if sm.is_described and sm.direction not in configuration.lacking:
            lengths = [sum(entry.bit_length for entry in pdo.entries) for pdo in sm.pdos]
            yield ImageSize(sm.number, sm.bit_size, sm.byte_size, " + ".join(map(str, lengths)))


def _registrations(configuration: Configuration) -> Iterator[Registration]:
    known: set[tuple[int, int]] = set()
    for sm in configuration.sync_managers:
        for pdo_position, pdo in enumerate(sm.pdos):
            row = 0
            for entry in pdo.entries:
                place = (entry.entry_index, entry.subindex)
                if carries_value(entry):
                    inside_byte = not on_byte(entry) or entry.bit_length < 8
                    yield Registration(entry, inside_byte, sm.number, pdo_position, row, place in known)
                # One of no bits too: the master takes the first that it finds.
                known.add(place)
                row += sum(1 for _ in pieces(entry.bit_length))


def _members(registrations: Iterable[Registration]) -> Iterator[str]:
    for item in registrations:
        entry = item.entry
        where = f"SM{item.sm}"
        where += f" byte {entry.bit_offset // 8}" if entry.is_placed else ", place not known"
        where += f" bit {entry.bit_offset % 8}" if entry.is_placed and item.has_bit_position else ""
        bits = counted(entry.bit_length, "bit")
        yield f"unsigned int {entry.identifier}; /* {entry.place}, {bits}, {where} */"
        if item.has_bit_position:
            yield f"unsigned int {entry.identifier}_bit_position;"


def _accessor(prefix: str, configuration: Configuration, item: Registration) -> Function:
    entry = item.entry
    is_output = any(sm.number == item.sm and sm.direction == OUTPUT for sm in configuration.sync_managers)
    pointer = f"data + offsets->{entry.identifier}"
    place = Place(pointer, f"offsets->{item.bit_position}" if item.has_bit_position else "0")
    kind = "uint8_t *" if is_output else "const uint8_t *"
    arguments = f"{kind}data, const {prefix}_offsets_t *offsets"
    if entry.value.kind == "bytes" and whole_bytes(entry):
        comment = f"{comment_text(entry.words)}: its {byte_count(entry)} bytes"
        head = f"static inline {kind}{prefix}_data_{entry.identifier}({arguments})"
        return Function(comment, head, (f"return {pointer};",))
    if is_output:
        return writer(entry, f"{prefix}_write_{entry.identifier}", arguments, _write_body(entry, place))
    return reader(entry, f"{prefix}_read_{entry.identifier}", arguments, _read_body(entry, place))


def _macro_suffix(entry: MappedEntry) -> str | None:
    """The type in the names of EC_READ_… and EC_WRITE_…, None where they cannot take the value."""
    if entry.value.kind == "bytes" or not on_byte(entry) or not entry.value.fills_container:
        return None
    return f"{'S' if entry.value.kind == 'int' else 'U'}{entry.bit_length}"


def _read_body(entry: MappedEntry, place: Place) -> tuple[str, ...]:
    suffix = _macro_suffix(entry)
    if entry.bit_length == 1:
        return (f"return EC_READ_BIT({place.pointer}, {place.bit});",)
    if suffix is None:
        return read_value(entry, place)
    if entry.value.kind == "real":
        return real_from(entry, f"EC_READ_{suffix}({place.pointer})")
    return (f"return EC_READ_{suffix}({place.pointer});",)


def _write_body(entry: MappedEntry, place: Place) -> tuple[str, ...]:
    suffix = _macro_suffix(entry)
    if entry.bit_length == 1:
        return (f"EC_WRITE_BIT({place.pointer}, {place.bit}, value);",)
    if suffix is None:
        return write_value(entry, place)
    if entry.value.kind == "real":
        return real_to(entry, f"EC_WRITE_{suffix}({place.pointer}, raw);")
    return (f"EC_WRITE_{suffix}({place.pointer}, value);",)
