"""Scans against the catalog: who the slaves are, and what is to be known of their bus."""

import functools
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import msgspec

from esicatalog.catalog.identity import IdentityLookup
from esicatalog.catalog.results import NONE, FoundDevice, Identification
from esicatalog.errors import InputError
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.identity import NO_REVISION, identity_text
from esicatalog.model.bus import BusSummary, DeviceAtBus, SlaveReport, as_listed, look_at_bus, with_virtual
from esicatalog.model.eeprom_pdos import soem_bits
from esicatalog.model.process_data import ProcessData
from esicatalog.model.process_image import virtual_pdos
from esicatalog.model.required_slots import missing_pdos
from esicatalog.model.scan_compare import compare_scanned_objects, compare_scanned_pdos
from esicatalog.model.slots import default_modules
from esicatalog.model.sm_facts import INPUT, OUTPUT
from esicatalog.scan.buses import slave_words
from esicatalog.scan.records import Scan, ScanFinding, ScannedDictionary, ScannedPdos, ScannedSlave
from esicatalog.words import counted, hex32

_NO_IDENTITY = Identification(None, None, None, NONE, "the scan gives no identity of this slave", None, (), ())


class IdentifiedSlave(NamedTuple):
    """A slave of a scan with the description that fits it."""

    slave: ScannedSlave
    identification: Identification
    report: SlaveReport
    differences: tuple[str, ...]
    """What its PDOs and objects, as the master printed them, are otherwise than described."""
    findings: tuple[ScanFinding, ...]
    """What the scan, and the lists of its PDOs and objects, say of it that was not understood."""

    @property
    def identity_text(self) -> str:
        """The identity as the scan gives it, ``-`` where it does not."""
        return identity_text(self.slave.vendor_id, self.slave.product_code, self.slave.revision_no)

    @property
    def described_revision(self) -> str:
        """The revision of the description that stands in for that of the slave; empty where it is the same or none."""
        answer = self.identification
        if answer.device is None or answer.is_exact:
            return ""
        return hex32(answer.device.device.revision_no, NO_REVISION)

    @property
    def source(self) -> str:
        """The first document that carries the description, and the line in it; empty without description."""
        described = self.identification.device
        if described is None or not described.sources:
            return ""
        return f"{described.sources[0].member}, line {described.sources[0].line}"

    @property
    def notes(self) -> tuple[str, ...]:
        """What people are told of it: how it was identified, what its bus asks for, what is otherwise than described.

        Of an exact match other variants count, for nothing tells which one the device is; other revisions do not.
        """
        answer = self.identification
        exact = answer.is_exact
        reasons = () if exact else (answer.reason,)
        damage = answer.device.damage if answer.device is not None else None
        warnings = (damage, answer.variant_warning, None if exact else answer.revision_warning)
        told = (f"warning: {words}" for words in warnings if words is not None)
        return (*reasons, *told, *self.report.notes, *self.differences)

    def as_json(self) -> dict[str, Any]:
        """The answer of identify, and the slave beside it."""
        slave = self.slave
        place = {
            "bus": slave.bus,
            "master": slave.master,
            "position": slave.position,
            "alias": slave.alias,
            "name": slave.name,
            "serial_no": slave.serial_no,
            "state": slave.state,
            "state_error": slave.state_error,
            "failed": slave.failed,
            "al_status_code": slave.al_status_code,
            "master_device": slave.master_device,
            "reference_clock": slave.reference_clock,
            "potential_reference_clock": slave.potential_reference_clock,
            "line": slave.line,
        }
        return {
            **self.identification.as_json(),
            "slave": {
                **place,
                **self.report._asdict(),
                "differences": list(self.differences),
                "findings": [msgspec.structs.asdict(finding) for finding in self.findings],
            },
        }


class BusReport(NamedTuple):
    """The slaves of one bus, in ring order."""

    bus: int
    slaves: tuple[IdentifiedSlave, ...]
    summary: BusSummary

    @property
    def title(self) -> str:
        """Which bus it is of several: its number in the text, and the master or interface where the text names one."""
        first = self.slaves[0].slave
        place = f"master {first.master}" if first.master is not None else first.interface
        return f"Bus {self.bus}" + (f", {place}" if place else "")

    @property
    def not_exact_at(self) -> tuple[int, ...]:
        """Positions of the slaves without exact ESI."""
        return tuple(item.slave.position for item in self.slaves if not item.identification.is_exact)


def bus_facts(bus: BusReport) -> list[tuple[str, str]]:
    """What is to be known of a bus as a whole: names of facts and their words, those that there are.

    Who lists one slave of several (``ethercat slaves -v -p 3``) asks for that one; nothing says that it gives the time.
    """
    summary = bus.summary
    is_one_of_several = len(bus.slaves) == 1 and bool(summary.not_listed)
    tells_clock = not is_one_of_several or summary.reference_clock_at
    unknown_at = [n for n in summary.bytes_unknown_at if not (is_one_of_several and n in summary.not_listed)]
    near_at = [position for position in summary.bytes_described_at if position in bus.not_exact_at]
    near = f"; of {slave_words(near_at)} as the nearest ESI has them" if near_at else ""
    unknown = f"; unknown of {slave_words(unknown_at)}" if unknown_at else ""
    sizes = f"{counted(summary.output_bytes, 'byte')} out, {counted(summary.input_bytes, 'byte')} in"
    facts = [
        ("slaves", f"{len(bus.slaves)}, {len(bus.slaves) - len(bus.not_exact_at)} with exact ESI"),
        ("not listed", slave_words(summary.not_listed)),
        ("no exact ESI", slave_words(bus.not_exact_at)),
        ("process data", sizes + near + unknown),
        ("reference clock", _reference_clock_words(bus) if tells_clock else ""),
        ("no LRW", slave_words(summary.no_lrw_at)),
        ("E-bus exceeded", slave_words(summary.e_bus_exceeded_at)),
        ("E-bus unknown", slave_words(summary.e_bus_unknown_at)),
        ("same alias", _alias_words(summary.duplicate_aliases)),
    ]
    return [(name, words) for name, words in facts if words]


def _alias_words(duplicates: Mapping[int, Sequence[int]]) -> str:
    """Aliases that several slaves share, in words."""
    return "; ".join(f"{alias}: {slave_words(positions)}" for alias, positions in duplicates.items())


def _reference_clock_words(bus: BusReport) -> str:
    """Which slave is configured as reference clock, else which can be it and of which before it nothing is known."""
    summary = bus.summary
    if summary.reference_clock_at:
        is_one = len(summary.reference_clock_at) == 1
        return f"{slave_words(summary.reference_clock_at)} {'is' if is_one else 'are'} configured as reference clock"
    clock, unknown = summary.reference_clock_candidate, summary.clock_unknown_at
    if clock is None:
        known = ["no candidate known" if unknown else "no candidate"]
    elif summary.system_time_known and not unknown:
        known = [f"slave {clock} is the first that can be it"]
    else:
        known = [f"slave {clock} is the first known to have distributed clocks"]
        known += ["system time not told"] * (not summary.system_time_known)
    described = {item.slave.position for item in bus.slaves if item.identification.device is not None}
    silent = [position for position in unknown if position in described]
    says = "its description says" if len(silent) == 1 else "their descriptions say"
    words = {
        "nothing is known of {}": [position for position in unknown if position not in described],
        f"of {{}} {says} nothing of clocks": silent,
    }
    return "; ".join([*known, *(text.format(slave_words(at)) for text, at in words.items() if at)])


_Listed = tuple[ScannedSlave, tuple[ScanFinding, ...]]
Records = Callable[[FoundDevice], tuple[Device, Sequence[Module]]]
"""Gives the records of a described device and of its modules."""


def bus_reports(
    lookup: IdentityLookup,
    scan: Scan,
    records: Records,
    pdos: Sequence[ScannedPdos],
    dictionaries: Sequence[ScannedDictionary],
) -> list[BusReport]:
    """Identify all slaves of a scan; unknown ones stay in the list.

    ``pdos`` and ``dictionaries`` of the same bus are compared with the descriptions. Raises :class:`InputError` when
    one of them does not say to which of several slaves it belongs, or belongs to none, or when two belong to one.
    """
    _check_places(pdos, scan)
    _check_places(dictionaries, scan)
    # Slaves of a bus are often alike: each description is read once.
    read = functools.cache(records)
    buses: dict[int, list[_Listed]] = defaultdict(list)
    lists: list[ScannedPdos | ScannedDictionary] = [*pdos, *dictionaries]
    for slave, findings in zip(scan.slaves, scan.findings_by_slave(), strict=True):
        beside = [finding for item in lists if _belongs(item, slave) for finding in _named(item)]
        buses[slave.bus].append((slave, (*findings, *beside)))
    found = []
    for number, of_bus in sorted(buses.items()):
        listed = sorted(of_bus, key=lambda item: item[0].position)
        fits = [_fitting(lookup, slave, read, pdos, dictionaries) for slave, _ in listed]
        lists_of = [[item for item in pdos if _belongs(item, slave)] for slave, _ in listed]
        slaves = [as_listed(slave, own) for (slave, _), own in zip(listed, lists_of, strict=True)]
        answers = [fit.answer for fit in fits]
        devices = [_at_bus(lookup, *item, read) for item in zip(slaves, lists_of, answers, strict=True)]
        reports, summary = look_at_bus(list(zip(slaves, devices, strict=True)))
        together = zip(listed, fits, reports, strict=True)
        found.append(BusReport(number, tuple(_identified(*item, read) for item in together), summary))
    return found


def _named(item: ScannedPdos | ScannedDictionary) -> Iterator[ScanFinding]:
    """The findings of a list, which say of which: its lines are those of another text than the scan's."""
    for finding in item.findings:
        yield ScanFinding(line=finding.line, message=f"{item.origin}: {finding.message}")


def _at_bus(
    lookup: IdentityLookup,
    slave: ScannedSlave,
    lists: Sequence[ScannedPdos],
    answer: Identification,
    records: Records,
) -> DeviceAtBus | None:
    """What the bus has to know of the description; its bits, which no row has, where the master tells bits."""
    described = answer.found
    at_bus = lookup.at_bus(described) if described is not None else None
    if described is None or at_bus is None or (slave.output_bits is None and slave.input_bits is None):
        return at_bus
    device, modules = records(described)
    data = ProcessData(device, modules)
    at_bus = at_bus._replace(
        output_bits=data.bit_size(OUTPUT),
        input_bits=data.bit_size(INPUT),
        soem_outputs=soem_bits(device, OUTPUT, data.images),
        soem_inputs=soem_bits(device, INPUT, data.images),
    )
    return with_virtual(at_bus, lists, virtual_pdos(data.images))


class _Fit(NamedTuple):
    """The answer for a slave, its ``device`` the variant that fits best what the master printed of it."""

    answer: Identification
    differences: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def _identified(listed: _Listed, fit: _Fit, report: SlaveReport, records: Records) -> IdentifiedSlave:
    slave, findings = listed
    missing: tuple[str, ...] = ()
    if fit.answer.device is not None and None in (report.output_bytes, report.input_bytes):
        missing = _missing_modules(*records(fit.answer.device.device))
    report = report._replace(notes=(*report.notes, *missing, *fit.notes))
    return IdentifiedSlave(slave, fit.answer, report, fit.differences, findings)


def _missing_modules(device: Device, modules: Sequence[Module]) -> tuple[str, ...]:
    """Why lengths are not known where modules have to be chosen first."""
    missing = missing_pdos(device, modules, default_modules(device, modules))
    return tuple(dict.fromkeys(pdos.words for pdos in missing.values()))


def _fitting(
    lookup: IdentityLookup,
    slave: ScannedSlave,
    records: Records,
    pdos: Sequence[ScannedPdos],
    dictionaries: Sequence[ScannedDictionary],
) -> _Fit:
    known = slave.identity
    answer = (
        lookup.identify(known.vendor_id, known.product_code, known.revision_no) if known is not None else _NO_IDENTITY
    )
    printed_pdos = [item for item in pdos if _belongs(item, slave)]
    own_pdos = [item for item in printed_pdos if item.is_complete]
    printed_dictionaries = [item for item in dictionaries if _belongs(item, slave)]
    own_dictionaries = [item for item in printed_dictionaries if item.is_complete]
    left_out = _list_words(own_pdos != printed_pdos, own_dictionaries != printed_dictionaries)
    broken = (f"{left_out} not compared: their list was not understood in full",) * bool(left_out)
    if not own_pdos and not own_dictionaries:
        return _Fit(answer, notes=broken)
    if answer.device is None:
        lists = _list_words(bool(own_pdos), bool(own_dictionaries))
        return _Fit(answer, notes=(*broken, f"{lists} not compared: no description of slave {slave.position}"))
    compared = [_compared(*records(variant.device), own_pdos, own_dictionaries) for variant in answer.variants]
    best = min(compared, key=_rank)
    device = answer.variants[compared.index(best)]
    notes = _choice_notes(
        {variant.device.variant: found for variant, found in zip(answer.variants, compared, strict=True)},
        _list_words(bool(own_pdos), bool(own_dictionaries) and best.objects_compared),
    )
    answer = msgspec.structs.replace(answer, device=device, variant_warning=lookup.other_variants(device.device))
    return _Fit(answer, best.differences, (*notes, *broken, *_quiet_notes(own_pdos, own_dictionaries)))


def _quiet_notes(pdos: Sequence[ScannedPdos], dictionaries: Sequence[ScannedDictionary]) -> Iterator[str]:
    """What lists without entries do not tell."""
    if not all(item.lists_entries for item in pdos):
        yield "PDOs are listed without entries: mappings are not compared, bytes are those described by default"
    if not all(item.lists_entries for item in dictionaries):
        yield "objects are listed without entries: only their indices are compared"


def _list_words(pdos: bool, objects: bool) -> str:
    return " and ".join(["PDOs"] * pdos + ["objects"] * objects)


class _Compared(NamedTuple):
    """A description beside what the master printed of a slave."""

    differences: tuple[str, ...]
    objects_compared: bool
    """False where objects were printed and the description has none to compare them with."""


def _rank(found: _Compared) -> tuple[bool, int]:
    """Where nothing can be compared nothing differs: such a description fits last, not best."""
    return not found.objects_compared, len(found.differences)


def _choice_notes(compared: Mapping[int, _Compared], lists: str) -> tuple[str, ...]:
    """What is told of the descriptions by their variant; ``lists`` are those that the taken one was compared with."""
    fewest = min(map(_rank, compared.values()))
    best = [variant for variant, found in compared.items() if _rank(found) == fewest]
    silent = [variant for variant, found in compared.items() if not found.objects_compared]
    notes = []
    if len(compared) - len(silent) == 1 < len(compared):
        notes.append(f"variant {best[0]} of {len(compared)} is taken: of the others no objects are described")
    elif lists and len(compared) > 1:
        notes.append(_best_words(best, len(compared), lists))
    if silent:
        of_variants = f" of variant {', '.join(map(str, silent))}" if len(compared) > 1 else ""
        notes.append(f"objects not compared: the description{of_variants} has no dictionary of the device itself")
    return tuple(notes)


def _best_words(best: Sequence[int], count: int, lists: str) -> str:
    """Which variants fit what was printed; ``best`` are their numbers, the one that is taken first."""
    if len(best) == count:
        return f"all {count} variants fit its {lists} alike"
    if len(best) == 1:
        return f"variant {best[0]} of {count} fits its {lists} best"
    named = f"{', '.join(map(str, best[:-1]))} and {best[-1]}"
    return f"variants {named} of {count} fit its {lists} best and alike; {best[0]} is taken"


def _compared(
    device: Device, modules: Sequence[Module], pdos: Sequence[ScannedPdos], dictionaries: Sequence[ScannedDictionary]
) -> _Compared:
    of_pdos = [words for item in pdos for words in compare_scanned_pdos(device, modules, item)]
    of_objects = [compare_scanned_objects(device, modules, dictionary) for dictionary in dictionaries]
    told = [words for found in of_objects for words in found or ()]
    return _Compared((*of_pdos, *told), None not in of_objects)


def _check_places(lists: Sequence[ScannedPdos | ScannedDictionary], scan: Scan) -> None:
    """Raise :class:`InputError` unless each list belongs to one slave, and to each belongs one at most."""
    taken = set()
    for item in lists:
        slave = _slave_of(item, scan)
        if id(slave) in taken:
            raise InputError(
                f"{item.origin}, line {item.line}: another list of slave {slave.position}; give one of it, and files "
                "of several slaves without POSITION=: their headings name them"
            )
        taken.add(id(slave))


def _slave_of(item: ScannedPdos | ScannedDictionary, scan: Scan) -> ScannedSlave:
    """The slave to which a list belongs. Raises :class:`InputError` where it is none or several."""
    if len(scan.slaves) > 1 and item.position is None:
        raise InputError(f"{item.origin} does not name its slave; write POSITION=FILE")
    found = [slave for slave in scan.slaves if _belongs(item, slave)]
    if not found:
        of_master = f" of master {item.master}" if item.master is not None else ""
        raise InputError(f"{item.origin} is of slave {item.position}{of_master}, which the scan has not")
    if len(found) > 1:
        raise InputError(
            f"{item.origin} fits slave {item.position} of several buses; put the heading of its master "
            f"before it (=== Master N, Slave {item.position} ===), or give the scan of one bus"
        )
    return found[0]


def _belongs(item: ScannedPdos | ScannedDictionary, slave: ScannedSlave) -> bool:
    """Whether a list is of this slave; tables, lists of identities and SOEM name no master."""
    return item.position in (None, slave.position) and (
        item.master is None or slave.master is None or item.master == slave.master
    )
