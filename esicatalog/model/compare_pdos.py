"""Comparison of PDOs: which there are, where they are assigned, what they map, what excludes them."""

from collections.abc import Hashable, Iterator, Sequence
from difflib import SequenceMatcher

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Exclude, Pdo
from esicatalog.model.base_types import base_type
from esicatalog.model.compare_facts import (
    PDO,
    Difference,
    Fact,
    always,
    compare_facts,
    difference,
    either,
    gained,
    gained_items,
    lost,
    matched,
    never,
)
from esicatalog.model.compare_words import (
    h4,
    listed,
    shown_text,
    sync_manager,
    text,
    unread_words,
    value_of,
    yes_no,
)
from esicatalog.model.pdo_facts import Mapped, bits_words, entry_facts, mapped, mapped_words, symmetric_exclusions
from esicatalog.model.twincat import PredefinedAssignment, predefined_assignments
from esicatalog.words import counted, index_words


def type_words(name: str | None) -> str | None:
    """A data type by its base type where the name tells it: ``UINT16`` is ``UINT``."""
    known = base_type(name)
    return known.name if known is not None else text(name)


def _index(pdo: Pdo) -> str:
    return h4(value_of(pdo, "pdo_index")) or "without index"


def _of_slot(item: Exclude) -> str | None:
    """An exclusion whose index depends on the slot or the slot group."""
    by = [words for words, on in (("slot", item.depend_on_slot), ("slot group", item.depend_on_slot_group)) if on]
    return f"{index_words(item.pdo_index)} by {' and '.join(by)}" if by else None


_PDO = (
    Fact("names", "name", never, shown_text),
    Fact("sm", "assignment", always, sync_manager),
    Fact("fixed", "Fixed", gained, yes_no),
    Fact("mandatory", "Mandatory", gained, yes_no),
    Fact("virtual", "Virtual", always, yes_no),
    Fact("excluded_sms", "excluded SyncManagers", gained_items, listed(sync_manager)),
    Fact("excludes", "exclusions by slot or not readable", always, listed(_of_slot)),
    Fact("su", "sync unit", always),
    Fact("os_fac", "OSFac", always),
    Fact("os_min", "OSMin", always),
    Fact("os_max", "OSMax", always),
    Fact("os_index_inc", "OSIndexInc", always),
    Fact("overwritten_by_module", "OverwrittenByModule", always, yes_no),
    Fact("depend_on_slot", "DependOnSlot", always, yes_no),
    Fact("depend_on_slot_group", "DependOnSlotGroup", always, yes_no),
    Fact("sra_parameter", "SRA_Parameter", always, yes_no),
    Fact("safety_pdo_type", "SafetyPdoType", always),
    Fact("safety_conn_number", "SafetyConnNumber", always),
    Fact("pdo_order", "PdoOrder", always),
    Fact("ref", "Ref", always),
    Fact("channel", "Chn", always),
)
_ENTRY = (
    Fact("names", "name", never, shown_text),
    Fact("comments", "comment", never, shown_text),
    Fact("data_type", "data type", lost, type_words),
    Fact("dscale", "DScale", lost),
    Fact("swap_data", "SwapData", always),
    Fact("fixed", "Fixed", gained, yes_no),
    Fact("depend_on_slot", "DependOnSlot", always, yes_no),
    Fact("depend_on_slot_group", "DependOnSlotGroup", always, yes_no),
    Fact("safety_conn_number", "SafetyConnNumber", always),
    Fact("ads_info", "AdsInfo", never),
)


def compare_pdos(left: Device | Module, right: Device | Module) -> Iterator[Difference]:
    """The PDOs of a device or module, by direction, index and occurrence."""
    lists = [("RxPDO", left.rx_pdos, right.rx_pdos), ("TxPDO", left.tx_pdos, right.tx_pdos)]
    if isinstance(left, Module) and isinstance(right, Module):
        lists.append(("SafetyParaMapping", left.safety_para_mappings, right.safety_para_mappings))
    for name, ours, theirs in lists:
        if ours != theirs:
            pairs = matched(ours, theirs, _pdo_key)
            for pdo, other in sorted(pairs, key=lambda pair: either(*pair).pdo_index or 0):
                yield from _compare_pdo(name, pdo, other)
    yield from _compare_exclusions((*left.rx_pdos, *left.tx_pdos), (*right.rx_pdos, *right.tx_pdos))


def _pdo_key(pdo: Pdo) -> Hashable:
    index = value_of(pdo, "pdo_index")
    return index if index is not None else (pdo.ref, pdo.channel)


def _place(name: str, pdo: Pdo) -> str:
    """A PDO by its index; those of files before schema 1.2 by the shared PDO that they refer to."""
    shared = " ".join(filter(None, (pdo.ref, pdo.channel)))
    return f"{name} {shared if shared and value_of(pdo, 'pdo_index') is None else _index(pdo)}"


def _compare_pdo(name: str, left: Pdo | None, right: Pdo | None) -> Iterator[Difference]:
    if left is not None and right is not None:
        place = _place(name, left)
        yield from compare_facts(PDO, place, left, right, _PDO)
        if left.entries != right.entries:
            yield from _compare_entries(place, left.entries, right.entries)
    elif left is not None:
        yield difference(PDO, _place(name, left), _pdo_words(left), None, True)
    elif right is not None:
        needed = right.sm is not None or bool(right.mandatory)
        yield difference(PDO, _place(name, right), None, _pdo_words(right), needed)


def _pdo_words(pdo: Pdo) -> str:
    size = f"{counted(len(pdo.entries), 'entry', 'entries')}, {bits_words(pdo)} bit"
    flags = [name for name in ("fixed", "mandatory", "virtual") if getattr(pdo, name)]
    return ", ".join(filter(None, (sync_manager(value_of(pdo, "sm")), size, *flags, shown_text(pdo.names))))


def _compare_entries(place: str, left: Sequence[Entry], right: Sequence[Entry]) -> Iterator[Difference]:
    """Entries by what they map: one that is put in or taken out does not change those behind it."""
    for number, other_number in aligned(list(map(_mapped, left)), list(map(_mapped, right))):
        ours = left[number] if number is not None else None
        theirs = right[other_number] if other_number is not None else None
        where = f"{place} entry {_number(number, other_number, ours)}"
        if ours is None or theirs is None or _mapped(ours) != _mapped(theirs):
            yield difference(PDO, where, _entry_words(ours), _entry_words(theirs), True)
        elif not entry_facts(ours).is_padding:
            yield from compare_facts(PDO, where, ours, theirs, _ENTRY)


def _mapped(entry: Entry) -> tuple[Mapped, str | None]:
    """What an entry maps, where what cannot be read is as the vendor wrote it."""
    return mapped(entry), unread_words(entry, ("entry_index", "bit_length"))


def _number(number: int | None, other: int | None, entry: Entry | None) -> str:
    """The number of an entry, counted from 1; its object when the numbers differ."""
    if number is not None and other is not None and number != other and entry is not None:
        return _mapped_words(entry)
    known = number if number is not None else other
    return str(known + 1) if known is not None else ""


def _entry_words(entry: Entry | None) -> str | None:
    if entry is None:
        return None
    words = _mapped_words(entry)
    if entry_facts(entry).is_padding:
        return words
    return " ".join(filter(None, (words, type_words(entry.data_type), shown_text(entry.names))))


def _mapped_words(entry: Entry) -> str:
    known, unread = _mapped(entry)
    return mapped_words(*known) + (f" ({unread})" if unread is not None else "")


def aligned(left: Sequence[Hashable], right: Sequence[Hashable]) -> list[tuple[int | None, int | None]]:
    """Positions that belong together: equal items in their order, and others where both stand at the same position.

    The result for exchanged sides is the exchanged result.
    """
    if repr(right) < repr(left):
        return [(position, other) for other, position in aligned(right, left)]
    pairs: list[tuple[int | None, int | None]] = []
    for tag, start, stop, other_start, other_stop in SequenceMatcher(None, left, right, autojunk=False).get_opcodes():
        together = min(stop - start, other_stop - other_start) if tag == "equal" or start == other_start else 0
        pairs += [(start + step, other_start + step) for step in range(together)]
        pairs += [(position, None) for position in range(start + together, stop)]
        pairs += [(None, position) for position in range(other_start + together, other_stop)]
    return pairs


def _compare_exclusions(left: Sequence[Pdo], right: Sequence[Pdo]) -> Iterator[Difference]:
    """What may not be assigned beside a PDO that both have; PDOs that only one side has are told as such."""
    rivals, others = symmetric_exclusions(left), symmetric_exclusions(right)
    if rivals == others:
        return
    indices, other_indices = ({pdo.pdo_index for pdo in pdos} for pdos in (left, right))
    of_one_side = indices ^ other_indices
    for index in sorted(found for found in indices & other_indices if found is not None):
        ours, theirs = (set(known.get(index, ())) - of_one_side for known in (rivals, others))
        if ours != theirs:
            said, also = listed(index_words)(sorted(ours - theirs)), listed(index_words)(sorted(theirs - ours))
            yield difference(PDO, f"PDO {index_words(index)} exclusions", said, also, bool(theirs - ours))


def compare_predefined_assignments(left: Device, right: Device) -> Iterator[Difference]:
    """TwinCAT's predefined PDO assignments, by name."""
    for ours, theirs in matched(
        predefined_assignments(left), predefined_assignments(right), lambda assignment: assignment.name
    ):
        said, also = (_assignment_words(item) for item in (ours, theirs))
        if said != also:
            place = f"predefined assignment {either(ours, theirs).name}"
            yield difference(PDO, place, said, also, lost(ours, theirs))


def _assignment_words(assignment: PredefinedAssignment | None) -> str | None:
    if assignment is None:
        return None
    sms = [f"SM{sm}: {listed(index_words)(indices) or 'none'}" for sm, indices in assignment.pdo_indices.items()]
    return "; ".join(["default"] * assignment.is_default + sms)
