"""Small facts about PDOs and their entries that every reader of the catalog needs."""

from collections.abc import Container, Iterable, Mapping
from typing import Annotated, Protocol

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.numbers import MAX_STORED
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import RX_PDO, TX_PDO, Entry, Pdo
from esicatalog.esi.unreadable import unreadable
from esicatalog.words import index_words

PDO_MAPPINGS = {RX_PDO: range(0x1600, 0x1800), TX_PDO: range(0x1A00, 0x1C00)}
"""Mapping objects of each direction: a PDO has the index of one (ETG.1000.6)."""
_MAPPING_OBJECTS = frozenset(index for indices in PDO_MAPPINGS.values() for index in indices)
PDO_ASSIGNMENTS = range(0x1C10, 0x1C30)
"""Assignment objects: one for each SyncManager, from 0 (ETG.1000.6)."""


PDO_FIELDS = {RX_PDO: "rx_pdos", TX_PDO: "tx_pdos"}
"""Fields of devices and modules by the direction of the PDOs in them."""


def pdos_by_direction(owner: Device | Module) -> tuple[tuple[str, tuple[Pdo, ...]], ...]:
    """What a device or module sends and receives, ``RxPdo`` first."""
    return (RX_PDO, owner.rx_pdos), (TX_PDO, owner.tx_pdos)


def has_idns(owner: Device | Module) -> bool:
    """Whether its PDOs, entries and objects are numbered by IDNs (IEC 61800-7-204), as with SoE and no CoE.

    An IDN says nothing as an index: P-0-0064 of AX5000 drives is 0x8040, and no controlword.
    """
    return owner.mailbox is not None and owner.mailbox.soe and not owner.mailbox.coe


def is_pdo_mapping(index: int | None) -> bool:
    """Whether an object describes the content of a PDO."""
    return index in _MAPPING_OBJECTS


class PdoFacts(Record):
    """What a PDO amounts to."""

    bit_size: Annotated[
        int | None, Doc("Sum of the entries' lengths in bits, padding included, OSFac not expanded")
    ] = 0
    entry_count: Annotated[int, Doc("Number of entries, padding included")] = 0


Mapped = tuple[int | None, int | str, int | None]
"""Index, subindex and bit length of an entry; of padding only the length counts.

The subindex is a text where the document has one that cannot be read: it is unknown and no other's.
"""


class EntryFacts(Record):
    """What an entry is."""

    is_padding: Annotated[bool, Doc("Padding gap: index 0, only the length counts")] = False


def pdo_bits(pdo: Pdo) -> int:
    """Bits of one sample of a PDO; a length below 0 takes no room."""
    return sum([max(entry.bit_length or 0, 0) for entry in pdo.entries])


def bits_words(pdo: Pdo) -> str:
    """Bits of one sample as sheets and pages say it: ``12``, ``?`` or ``at least 12`` where not all are described."""
    bits = pdo_bits(pdo)
    if is_described(pdo):
        return str(bits)
    return f"at least {bits}" if bits else "?"


def pdo_flags(pdo: Pdo) -> list[str]:
    """What is set of a PDO, in the words of sheets and pages; OSFac says how often a cycle samples it by default."""
    fields = ("fixed", "mandatory", "virtual", "overwritten_by_module")
    flags = [name.replace("_", " ") for name in fields if getattr(pdo, name)]
    return [*flags, *([f"OSFac {pdo.os_fac}"] if pdo.os_fac is not None else [])]


def declared_sm_words(pdo: Pdo, sm: int | None) -> str:
    """The SyncManager that a PDO names and is not assigned to, in words: it yields to a module's PDO, for instance.

    ``sm`` is the one to which it is assigned; nothing where that is one, or where the PDO names none.
    """
    return f" (Sm {pdo.sm} in the file)" if sm is None and pdo.sm is not None else ""


def pdo_facts(pdo: Pdo) -> PdoFacts:
    """Size and number of entries of a PDO; a sum of 2^63 or more counts as none (ESI-FACTS section 1.1)."""
    bits = pdo_bits(pdo)
    return PdoFacts(bit_size=bits if bits <= MAX_STORED else None, entry_count=len(pdo.entries))


def entry_facts(entry: Entry) -> EntryFacts:
    """Index 0 is padding whatever else the entry carries (ESI-FACTS section 9)."""
    return _PADDING if entry.entry_index == 0 else _NO_PADDING


_PADDING, _NO_PADDING = EntryFacts(is_padding=True), EntryFacts(is_padding=False)


def mapped(entry: Entry) -> Mapped:
    """What an entry maps."""
    subindex: int | str | None = entry.subindex if entry.entry_index != 0 else 0
    if subindex is None:
        subindex = (entry.spelling or {})["subindex"] if unreadable(entry, "subindex") is not None else 0
    return (entry.entry_index, subindex, entry.bit_length)


def mapped_words(index: int | None, subindex: int | str | None, bit_length: int | None) -> str:
    """What an entry maps, e.g. ``0x6041:00 (16 bit)``; None is a subindex that cannot be read."""
    target = "padding" if index == 0 else f"{index_words(index)}:{subindex_words(subindex)}"
    return f"{target} ({'no length' if bit_length is None else f'{bit_length} bit'})"


def subindex_words(subindex: int | str | None) -> str:
    """A subindex as two digits; a question mark for one that cannot be read, with what stands there if it is given."""
    if isinstance(subindex, int):
        return f"{subindex:02X}"
    return "?" if subindex is None else f"? {subindex!r}"


def has_length(entry: Entry) -> bool:
    """Whether an entry says how many bits it takes, be it none: BitLen has no minimum in the schema (ETG.2000)."""
    return entry.bit_length is not None and entry.bit_length >= 0


class Exchanged(Protocol):
    """What a PDO maps: an entry as it is described, or as an export writes it."""

    @property
    def entry_index(self) -> int | None:
        """Index of the object, 0 for a gap."""

    @property
    def bit_length(self) -> int | None:
        """Length in bits."""


def carries_value(entry: Exchanged) -> bool:
    """Whether an object is exchanged in an entry: one of no bits stands in the mapping, and nothing is read there."""
    return bool(entry.entry_index) and (entry.bit_length or 0) > 0


def has_object(entry: Entry) -> bool:
    """Whether an entry says what it maps, be it padding."""
    is_padding = entry_facts(entry).is_padding
    return is_padding or (entry.entry_index is not None and unreadable(entry, "subindex") is None)


def lacks_subindex(owner: Device | Module, entry: Entry) -> bool:
    """Whether an entry of an owner maps an object without SubIndex, which then is 0 (ESI-FACTS section 9).

    IDNs have none; one that cannot be read is not lacking.
    """
    return bool(entry.entry_index) and entry.subindex is None and has_object(entry) and not has_idns(owner)


def entry_words(entry: Entry) -> str:
    """What an entry maps, e.g. ``0x6041:00``."""
    if entry_facts(entry).is_padding:
        return "padding"
    if entry.entry_index is None:
        return "unknown"
    return f"{index_words(entry.entry_index)}:{f'{entry.subindex or 0:02X}' if has_object(entry) else '?'}"


def places_words(places: Iterable[tuple[int, int]]) -> list[str]:
    """Indices and subindices, each run of subindices as one: ``0x7000:02 to :0F``."""
    runs: list[tuple[int, int, int]] = []
    for index, subindex in places:
        if runs and (index, subindex - 1) == (runs[-1][0], runs[-1][2]):
            runs[-1] = (index, runs[-1][1], subindex)
        else:
            runs.append((index, subindex, subindex))
    return [
        f"{index_words(index)}:{first:02X}" + (f" to :{last:02X}" if last > first else "")
        for index, first, last in runs
    ]


def pdo_yields(pdo: Pdo, of_modules: Container[int | None]) -> bool:
    """Whether a PDO of the device gives way to one of modules, whose indices are given (ESI-FACTS section 12)."""
    return bool(pdo.overwritten_by_module) and pdo.pdo_index in of_modules


def mapped_entries(entries: Iterable[Entry]) -> list[Mapped]:
    """What entries map, one behind the other: PDOs that are equal in it are read by the same code."""
    return [mapped(entry) for entry in entries]


def is_described(pdo: Pdo) -> bool:
    """Whether it is known how long a PDO is.

    One without entries has variable content (ESI-FACTS section 9), but not where it is Fixed: its list of entries is
    empty then and stays so (EL1252: "Reserved", and DefaultSize counts the other PDOs). An old Ref names entries that
    are described elsewhere.
    """
    if not pdo.entries:
        return bool(pdo.fixed) and pdo.ref is None
    return all(has_length(entry) for entry in pdo.entries)


def symmetric_exclusions(pdos: Iterable[Pdo]) -> Mapping[int | None, tuple[int, ...]]:
    """Which PDO indices may not be assigned beside a PDO, by its index.

    Exclude is meant for both sides, and 210 real ones are written on one side only (ESI-FACTS section 9): what either
    PDO names counts for both. A PDO that excludes itself excludes nothing.
    """
    found: dict[int | None, dict[int, None]] = {}
    for pdo in pdos:
        for item in pdo.excludes:
            if item.pdo_index is not None and pdo.pdo_index is not None and item.pdo_index != pdo.pdo_index:
                found.setdefault(pdo.pdo_index, {})[item.pdo_index] = None
                found.setdefault(item.pdo_index, {})[pdo.pdo_index] = None
    return {index: tuple(rivals) for index, rivals in found.items()}
