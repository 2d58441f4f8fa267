"""Rules about PDOs: index, assignment, exclusions, entries (ESI-FACTS section 9)."""

from collections.abc import Container, Iterable, Iterator, Sequence

from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.pdo import Entry, Exclude, Pdo
from esicatalog.lint.registry import ERROR, INFORMATION, WARNING, Found, listed, rule
from esicatalog.lint.subjects import DeclaredPdo, DeviceSubject, ModuleSubject, ProcessSubject, is_absent
from esicatalog.model.pdo_facts import (
    PDO_ASSIGNMENTS,
    PDO_FIELDS,
    PDO_MAPPINGS,
    entry_facts,
    entry_words,
    has_idns,
    has_object,
    is_pdo_mapping,
    places_words,
    symmetric_exclusions,
)
from esicatalog.model.pdo_mapping import assigned_by_dictionary
from esicatalog.model.process_data import ProcessData
from esicatalog.model.sm_facts import may_transport
from esicatalog.model.sync import listed_pdos
from esicatalog.sii.records import MAX_ENTRY_BITS
from esicatalog.words import counted, index_words


def _words(direction: str, index: int | None) -> str:
    return f"{direction} 0x{index:04X}" if index is not None else f"a {direction} without Index"


@rule("L27", ERROR, "ETG.2000 Pdo/@Sm: position of the Sm element; RxPdo go to Outputs, TxPdo to Inputs")
def sync_manager_of_pdo(subject: ProcessSubject | ModuleSubject) -> Iterator[Found]:
    """A PDO is assigned to a SyncManager that does not exist, runs the other way, has the mailbox or is excluded."""
    if isinstance(subject, ProcessSubject):
        targets = [("", subject.data.sync_managers)]
    else:
        targets = [(f" of {host.device.type!r}", host.device.sync_managers) for host in subject.hosts]
    for of, sync_managers in targets:
        for placed in subject.pdos:
            number = placed.pdo.sm
            if number is None:
                continue
            words = _sm_words(placed)
            if not 0 <= number < len(sync_managers):
                words += f"{of or ' of the device'}, which has {counted(len(sync_managers), 'SyncManager')}"
                yield Found(f"{words}: correct Sm", (*placed.place, "sm"))
            elif not may_transport(sync_managers[number], placed.direction):
                yield Found(f"{words}{of}, which is {sync_managers[number].usage}: correct Sm", (*placed.place, "sm"))
    for placed in subject.pdos:
        if placed.pdo.sm is not None and placed.pdo.sm in placed.pdo.excluded_sms:
            yield Found(
                f"{_sm_words(placed)}, which its ExcludedSm rules out: correct one of them", (*placed.place, "sm")
            )


def _sm_words(placed: DeclaredPdo) -> str:
    return f"{_words(placed.direction, placed.pdo.pdo_index)} is assigned to SM {placed.pdo.sm}"


@rule("L28", WARNING, "ETG.1000.6: a PDO mapping object exists once")
def index_twice(subject: ProcessSubject | ModuleSubject) -> Iterator[Found]:
    """Two PDOs have the same index."""
    seen: set[tuple[str, int]] = set()
    for placed in subject.pdos:
        index = placed.pdo.pdo_index
        if not index:
            continue
        if (placed.direction, index) in seen:
            yield Found(
                f"{_words(placed.direction, index)} is described twice: an assignment by index means the first only; "
                "give it another index",
                (*placed.place, "pdo_index"),
            )
        seen.add((placed.direction, index))


@rule("L29", WARNING, "ETG.1000.6: PDO mapping objects are 0x1600 to 0x17FF and 0x1A00 to 0x1BFF")
def index_range(subject: DeviceSubject | ModuleSubject) -> Iterator[Found]:
    """The index of a PDO is no PDO mapping object of its direction, or that of an entry is one."""
    if has_idns(subject.record):
        return  # the IDNs of its telegrams
    for direction, field in PDO_FIELDS.items():
        allowed = PDO_MAPPINGS[direction]
        for position, pdo in enumerate(getattr(subject.record, field)):
            index = pdo.pdo_index
            if index not in allowed and index is not None and not pdo.virtual:
                yield Found(
                    f"{_words(direction, index)} is no PDO mapping object; "
                    f"{direction} are 0x{allowed.start:04X} to 0x{allowed.stop - 1:04X}",
                    (field, position, "pdo_index"),
                )
            mapped = [number for number, entry in enumerate(pdo.entries) if is_pdo_mapping(entry.entry_index)]
            if mapped and is_pdo_mapping(index):
                yield Found(
                    f"{_words(direction, index)} maps {_mapping_objects([pdo.entries[number] for number in mapped])}",
                    (field, position, "entries", mapped[0], "entry_index"),
                )


def _mapping_objects(entries: Sequence[Entry]) -> str:
    """What is wrong with entries that map such objects: digits without #x are decimal, and were meant as hex."""
    decimal = [text for entry in entries if (text := (entry.spelling or {}).get("entry_index", "")).isdecimal()]
    advice = "map the objects that hold the values"
    if decimal:
        meant = dict.fromkeys(f"#x{text}" for text in decimal)
        advice = f"digits without #x are decimal, probably meant: {listed([*meant])}"
    return f"{listed([entry_words(entry) for entry in entries])}: objects of this range describe PDOs; {advice}"


@rule("L30", WARNING, "ETG.2000 Exclude: meant for both sides; a tool that reads one side only offers the pair")
def exclusion_one_sided(subject: ProcessSubject | ModuleSubject) -> Iterator[Found]:
    """A PDO excludes another one that does not exclude it."""
    if not _any_excludes(subject):
        return
    excluded = {
        placed.pdo.pdo_index: {item.pdo_index for item in placed.pdo.excludes} for placed in reversed(subject.pdos)
    }
    for placed in subject.pdos:
        index = placed.pdo.pdo_index
        for number, item in enumerate(placed.pdo.excludes):
            other = excluded.get(item.pdo_index)
            if other is not None and index is not None and item.pdo_index != index and index not in other:
                yield Found(
                    f"{_words(placed.direction, index)} excludes 0x{item.pdo_index:04X}, "
                    f"which does not exclude it: add Exclude 0x{index:04X} there",
                    (*placed.place, "excludes", number),
                )


@rule("L31", ERROR, "ETG.2000 Exclude: the PDOs may not be assigned at the same time")
def exclusive_defaults(subject: ProcessSubject | ModuleSubject) -> Iterator[Found]:
    """Two PDOs that exclude each other are both assigned by default or by an OpMode, or a PDO excludes itself."""
    if isinstance(subject, ProcessSubject) and subject.data.is_modular:
        yield from _exclusive_across_slots(subject.data)
    if not _any_excludes(subject):
        return
    for placed in subject.pdos:
        for number, item in enumerate(placed.pdo.excludes):
            if item.pdo_index is not None and _in_slots(item) == _in_slots(placed.pdo):
                yield Found(
                    f"{_words(placed.direction, item.pdo_index)} excludes itself: remove that Exclude",
                    (*placed.place, "excludes", number),
                )
    told: set[tuple[int | None, int]] = set()
    for assigned, mode in _assignments(subject):
        for placed, other in _exclusive(assigned):
            index = placed.pdo.pdo_index
            if index is not None and (index, other) not in told:
                told.add((index, other))
                both = f"{_words(placed.direction, index)} and 0x{other:04X}"
                words, field = _assigning(mode, (other, index))
                yield Found(f"{both} exclude each other, but {words}", (*placed.place, *field))


def _exclusive_across_slots(data: ProcessData) -> Iterator[Found]:
    """PDOs of default modules and of the device, or of modules in several slots, that may not be assigned together."""
    slots = {placed.pdo.pdo_index: placed.slot_number for image in data.images for placed in image.pdos}
    for left_out, rival in [pair for image in data.images for pair in image.excluded]:
        if rival in slots and slots[rival] != left_out.slot_number:
            yield Found(
                f"{_words(left_out.direction, left_out.pdo.pdo_index)} of {left_out.owner} and 0x{rival:04X} exclude "
                "each other, but the default modules bring both: preset others, or one of the PDOs must lose its Sm",
            )


def _assigning(mode: OpMode | None, both: Sequence[int]) -> tuple[str, tuple[str, ...]]:
    """Why two PDOs are assigned, by default or in an OpMode, with what to do, and the field that assigns them."""
    if mode is None:
        return "both are assigned by default: one of them must lose its Sm", ("sm",)
    listed = [index for index in both if index in listed_pdos([mode])]
    staying = [index for index in both if index not in listed]
    name = f"the OpMode {mode.name!r}"
    if not listed:
        return f"both are mandatory and {name} lists neither: list one of them", ()
    if not staying:
        return f"{name} assigns both: take one of them out of its list", ()
    (one,), (other,) = listed, staying
    return f"{name} lists 0x{one:04X} and 0x{other:04X} stays, being mandatory: correct the list or Mandatory", ()


def _exclusive(assigned: Sequence[DeclaredPdo]) -> Iterator[tuple[DeclaredPdo, int]]:
    """PDOs with the index of another one before them that may not be assigned beside them."""
    exclusions = symmetric_exclusions(placed.pdo for placed in assigned)
    before: list[int] = []
    for placed in assigned:
        index = placed.pdo.pdo_index
        rivals = exclusions.get(index, ())
        yield from ((placed, other) for other in before if other in rivals)
        if index is not None:
            before.append(index)


def _assignments(subject: ProcessSubject | ModuleSubject) -> Iterator[tuple[list[DeclaredPdo], OpMode | None]]:
    """What is assigned together: by default, then by each OpMode with lists."""
    yield _assigned_by_default(subject), None
    if isinstance(subject, ModuleSubject):
        return
    transported = [placed for placed in subject.pdos if not placed.pdo.virtual]
    exclusions = symmetric_exclusions(placed.pdo for placed in transported)
    for mode in subject.data.op_modes:
        if indices := listed_pdos([mode]):
            listed = [placed.pdo for placed in transported if placed.pdo.pdo_index in indices]
            chosen = {rival for pdo in listed if pdo.mandatory for rival in exclusions.get(pdo.pdo_index, ())}
            yield [item for item in transported if item.pdo.pdo_index in indices or _stays(item.pdo, chosen)], mode


def _stays(pdo: Pdo, ruled_out: Container[int | None]) -> bool:
    """Whether a PDO is assigned to its SyncManager whatever a list has, unless it names another mandatory one."""
    return bool(pdo.mandatory) and pdo.sm is not None and pdo.pdo_index not in ruled_out


def _any_excludes(subject: ProcessSubject | ModuleSubject) -> bool:
    return any(placed.pdo.excludes for placed in subject.pdos)


def _in_slots(item: Pdo | Exclude) -> tuple[int | None, bool, bool]:
    """What decides on the index in any slot."""
    return item.pdo_index, bool(item.depend_on_slot), bool(item.depend_on_slot_group)


def _processes(subject: ProcessSubject | ModuleSubject) -> list[ProcessData]:
    """What the devices exchange that it can be a part of."""
    if isinstance(subject, ProcessSubject):
        return [subject.data]
    return [host.derivation.process_data for host in subject.hosts]


def _listing(mode: OpMode | None) -> dict[int | None, OpMode]:
    """An OpMode by each SyncManager to which it assigns PDOs itself."""
    return {item.no: mode for item in mode.sm_assignments if item.pdos} if mode is not None else {}


def _assigned_by_default(subject: ProcessSubject | ModuleSubject) -> list[DeclaredPdo]:
    """PDOs that go by their Sm in a device that it can be a part of, and are exchanged there."""
    of_devices = [_SmAttributes(data) for data in _processes(subject)]
    return [
        placed
        for placed in subject.pdos
        if placed.pdo.sm is not None and not placed.pdo.virtual
        if not of_devices or any(item.assign(placed.pdo) for item in of_devices)
    ]


class _SmAttributes:
    """Which PDOs the Sm attribute assigns in a device by default."""

    def __init__(self, data: ProcessData) -> None:
        mode = data.default_op_mode
        self._virtual = {number for number, sm in enumerate(data.sync_managers) if sm.virtual}
        self._listing = _listing(mode)
        self._listed = listed_pdos([mode] if mode is not None else [])

    def assign(self, pdo: Pdo) -> bool:
        """Whether the default OpMode lists neither the PDO nor, unless it is mandatory, others for its SyncManager."""
        stays = pdo.sm not in self._listing or bool(pdo.mandatory)
        return stays and pdo.sm not in self._virtual and pdo.pdo_index not in self._listed


@rule("L32", WARNING, "ETG.2000 Exclude: index of another PDO")
def exclusion_of_unknown(subject: ProcessSubject | ModuleSubject) -> Iterator[Found]:
    """Exclude names a PDO that is not described."""
    if not _any_excludes(subject):
        return
    hosts = [] if isinstance(subject, ProcessSubject) else subject.hosts
    if not all(owner.is_complete for owner in (subject, *hosts)):
        return
    modules = subject.modules if isinstance(subject, ProcessSubject) else [m for host in hosts for m in host.modules]
    known = {placed.pdo.pdo_index for owner in (subject, *hosts, *modules) for placed in owner.pdos}
    for placed in subject.pdos:
        for number, item in enumerate(placed.pdo.excludes):
            if item.pdo_index is None or item.pdo_index in known:
                continue
            if not any(data.in_slots.has_pdo(item.pdo_index) for data in _processes(subject)):
                yield Found(
                    f"{_words(placed.direction, placed.pdo.pdo_index)} excludes 0x{item.pdo_index:04X}, "
                    "which is no PDO of the device: correct or remove it",
                    (*placed.place, "excludes", number),
                )


@rule("L33", ERROR, "ETG.2000 RxPdo/Index, TxPdo/Index, Entry/Index, Entry/BitLen: required")
def incomplete(pdo: Pdo) -> Iterator[Found]:
    """A PDO or an entry has no Index, or an entry no BitLen or one below 0 (objects in no bits: W)."""
    if is_absent(pdo, "pdo_index") and pdo.ref is None:  # an old Ref names what is described elsewhere
        yield Found("the PDO has no Index: no master can assign it; give it")
    empty = []
    for number, entry in enumerate(pdo.entries):
        if is_absent(entry, "entry_index"):
            yield Found(
                f"entry {number + 1} of PDO {index_words(pdo.pdo_index)} has no Index: "
                "nothing tells what it maps; give it, 0 for padding",
                ("entries", number),
            )
        length = entry.bit_length
        if is_absent(entry, "bit_length") if length is None else length < 0:
            words = "no BitLen" if length is None else f"BitLen {length}"
            yield Found(
                f"entry {number + 1} of PDO {index_words(pdo.pdo_index)} has {words}: "
                "nothing tells where the next entries lie",
                ("entries", number),
            )
        elif length == 0 and entry.entry_index and has_object(entry):
            empty.append((number, (entry.entry_index, entry.subindex or 0)))
    if empty:
        yield Found(
            f"PDO {index_words(pdo.pdo_index)} maps {listed(places_words(place for _, place in empty))} with BitLen 0: "
            "no value is exchanged there, and some masters refuse such entries; give the length if a value is meant",
            ("entries", empty[0][0], "bit_length"),
            WARNING,
        )


@rule("L34", INFORMATION, "ETG.2000 Entry: index 0 is a gap, only its BitLen counts")
def padding_with_type(pdo: Pdo) -> Iterator[Found]:
    """A padding entry carries a SubIndex or a DataType."""
    for number, entry in enumerate(pdo.entries):
        if entry_facts(entry).is_padding and (entry.subindex or entry.data_type):
            carried = f"SubIndex {entry.subindex}" if entry.subindex else f"DataType {entry.data_type}"
            yield Found(
                f"entry {number + 1} of PDO {index_words(pdo.pdo_index)} is padding (index 0) with {carried}, "
                "which means nothing: remove it",
                ("entries", number),
            )


@rule("L35", WARNING, "PDOs of a SyncManager follow each other bit by bit; only their sum is rounded up to bytes")
def not_whole_bytes(subject: ProcessSubject) -> Iterator[Found]:
    """The only PDO of a SyncManager is no whole number of bytes (several PDOs together: I)."""
    for image in subject.data.images:
        if not image.bit_size % 8 or not image.has_known_size:
            continue
        alone = len(image.pdos) == 1
        first = image.pdos[0]
        place = () if first.position is None or first.module is not None else _place(first.direction, first.position)
        what = _words(first.direction, first.pdo.pdo_index) if alone else f"{len(image.pdos)} PDOs"
        yield Found(
            f"SM {image.sm}: {what} of {counted(image.bit_size, 'bit')}; the last byte is filled up: where the "
            f"device maps the other {-image.bit_size % 8} too, describe them by a padding entry (Index 0)",
            place,
            WARNING if alone else INFORMATION,
        )


def _place(direction: str, position: int) -> tuple[str, int]:
    return (PDO_FIELDS[direction], position)


@rule("L40", WARNING, "ETG.2010: an entry of the EEPROM's PDO categories has one byte for its length in bits")
def too_long_for_eeprom(pdo: Pdo) -> Iterator[Found]:
    """An entry is longer than 255 bits."""
    for number, entry in enumerate(pdo.entries):
        if entry.bit_length is not None and entry.bit_length > MAX_ENTRY_BITS:
            yield Found(
                f"entry {number + 1} of PDO {index_words(pdo.pdo_index)} has {entry.bit_length} bits; "
                f"an EEPROM image holds {MAX_ENTRY_BITS} at most: split it",
                ("entries", number, "bit_length"),
            )


@rule(
    "L65",
    WARNING,
    "CoE objects 0x1C10 + n (ETG.1000.6) and ETG.2000 Pdo/@Sm, OpMode/Sm: they say what is assigned by default",
)
def assignment_object(subject: DeviceSubject) -> Iterator[Found]:
    """The defaults of 0x1C12 or 0x1C13 name other PDOs than those assigned by Sm or the default OpMode, or in another
    order.
    """
    if subject.is_modular:
        return
    listing = _listing(subject.derivation.process_data.default_op_mode)
    for image in subject.derivation.images:
        entries = subject.own.entries(PDO_ASSIGNMENTS.start + image.sm)
        if not entries:
            continue
        defaults = assigned_by_dictionary(entries)
        assigned = list(dict.fromkeys(placed.pdo.pdo_index for placed in image.pdos))
        if defaults is not None and defaults != assigned:
            mode = listing.get(image.sm)
            what = f"the OpMode {mode.name!r}" if mode is not None else f"Sm={image.sm}"
            is_order = set(defaults) == set(assigned)
            yield Found(
                f"0x{PDO_ASSIGNMENTS.start + image.sm:04X} assigns {_indices(defaults, is_order)} by default, "
                f"{what} assigns {_indices(assigned, is_order)}"
                + (" in that order" if is_order else "")
                + ": which of them counts depends on the master",
                subject.object_place(PDO_ASSIGNMENTS.start + image.sm),
            )


def _indices(indices: Iterable[int | None], in_order: bool) -> str:
    known = [index for index in indices if index]
    return listed([f"0x{index:04X}" for index in (known if in_order else sorted(known))]) or "none"


@rule("L66", WARNING, "ETG.2000 Pdo/@Mandatory: it must stay assigned, so it must be assigned")
def mandatory_without_sync_manager(subject: ProcessSubject) -> Iterator[Found]:
    """A mandatory PDO has no Sm, or excludes optional ones, which can then never be assigned."""
    pdos = [placed.pdo for placed in subject.pdos if not placed.pdo.virtual]
    assigned = {pdo.pdo_index for pdo in pdos if not is_absent(pdo, "sm")}.union(listed_pdos(subject.data.op_modes))
    optional = {pdo.pdo_index for pdo in pdos} - assigned
    exclusions = symmetric_exclusions(pdos) if _any_excludes(subject) else {}
    for placed in subject.pdos:
        pdo = placed.pdo
        if not pdo.mandatory or pdo.virtual:
            continue
        words = _words(placed.direction, pdo.pdo_index)
        excluded = [index for index in exclusions.get(pdo.pdo_index, ()) if index in optional]
        if pdo.pdo_index in optional:
            yield Found(f"{words} is Mandatory, but no Sm assigns it: give its Sm", placed.place)
        elif excluded and pdo.sm is not None:
            yield Found(
                f"{words} is Mandatory and excludes {listed([f'0x{index:04X}' for index in excluded])}: "
                "these can never be assigned; drop Mandatory",
                (*placed.place, "mandatory"),
            )
