"""Oversampling: how often a cycle samples a PDO, and which PDOs of the device hold the samples (ESI-FACTS section 18).

A PDO comes as often as the OpMode says, else by its own OSFac, the objects of each sample OSIndexInc further. All
samples are in that one PDO, unless the dictionary of a device with CoE has mapping objects behind that of the PDO, one
for each further sample, which no PDO of the description is: then each sample is a PDO of its own.
"""

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import chain
from typing import NamedTuple

import msgspec

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.identity import MAX_INDEX
from esicatalog.model.assignable_pdos import AvailablePdo, available_pdos, declares_pdo_assign
from esicatalog.model.dictionary_views import DictionaryView, DictionaryViews, counting_view
from esicatalog.model.pdo_facts import PDO_MAPPINGS, pdos_by_direction
from esicatalog.model.pdo_mapping import mapped_by_dictionary, mapping_obstacle
from esicatalog.model.slots import PluggedModule
from esicatalog.remarks import Remarking
from esicatalog.words import index_words


class Sample(NamedTuple):
    """A PDO of the device with what it maps: one sample, or all of them."""

    number: int
    """Which sample it is, from 1; 0 for all in one PDO."""
    pdo: Pdo
    """The oversampled PDO at the index of this one."""
    entries: tuple[Entry, ...]


class Oversampling:
    """The samples of the PDOs of a device with certain modules.

    ``factors`` are those of the OpMode by PDO index, None for a PDO that it lists without.
    """

    def __init__(self, device: Device, plugged: Sequence[PluggedModule], factors: Mapping[int, int | None]) -> None:
        self._device = device
        self._plugged = plugged
        self._factors = factors

    @cached_property
    def _views(self) -> tuple[DictionaryView, ...]:
        return DictionaryViews().of(self._device.profiles)

    @cached_property
    def _described(self) -> set[int | None]:
        return {item.pdo.pdo_index for item in available_pdos(self._device, self._plugged).pdos}

    def factor(self, pdo: Pdo) -> Remarking[int]:
        """How many samples a cycle has, 1 at least."""
        factor = self._factors.get(pdo.pdo_index) if pdo.pdo_index is not None else None
        if not factor:
            factor = pdo.os_fac or 1
            if factor > 1 and self._factors:
                yield (
                    f"PDO {index_words(pdo.pdo_index)}: the OpMode, which lists PDOs, says nothing about its "
                    f"oversampling; its own OSFac {factor} counts, and SYNC0 has to fit it"
                )
        return max(factor, 1)

    def samples(self, candidate: AvailablePdo, factor: int) -> Remarking[list[Sample]]:
        """The PDOs that hold so many samples.

        What the master cannot map is mapped as the dictionary says by default, where that has the lengths of the
        described entries for all samples.
        """
        pdo = candidate.pdo
        described = yield from _sampled(pdo, factor)
        indices = self._own_indices(candidate, factor)
        is_mapped_by_device = mapping_obstacle(self._device, pdo) is not None
        if not indices:
            if len(described) > 1 and is_mapped_by_device and declares_pdo_assign(self._device):
                yield (
                    f"PDO {index_words(pdo.pdo_index)} has {factor} samples here, which its mapping may "
                    "not hold: how the device assigns the samples is not described; compare with a known configuration"
                )
            return [Sample(0, pdo, tuple(chain.from_iterable(described)))]
        mapped = list(map(self._mapped, indices)) if is_mapped_by_device else []
        if not all(_fits(pdo, objects) for objects in mapped):
            mapped = []
        of_samples = [_with_objects(pdo.entries, objects) for objects in mapped] or described
        return [
            Sample(number, msgspec.structs.replace(pdo, pdo_index=index), entries)
            for number, (index, entries) in enumerate(zip(indices, of_samples, strict=True), 1)
        ]

    def _own_indices(self, candidate: AvailablePdo, factor: int) -> Sequence[int]:
        """Indices of the PDOs that hold a sample each, none where one PDO holds all."""
        first, mailbox = candidate.pdo.pdo_index, self._device.mailbox
        if factor == 1 or first is None or not candidate.pdo.entries or candidate.plugged is not None:
            return ()
        indices, known = range(first, first + factor), PDO_MAPPINGS[candidate.direction]
        if mailbox is None or not mailbox.coe or indices[0] not in known or indices[-1] not in known:
            return ()
        are_own = all(index not in self._described and counting_view(self._views, index) for index in indices[1:])
        return indices if are_own else ()

    def _mapped(self, index: int) -> list[tuple[int, int, int]]:
        view = counting_view(self._views, index)
        return mapped_by_dictionary(view.entries(index) or {}) if view is not None else []


def has_oversampling(device: Device) -> bool:
    """Whether a PDO of the device itself, or an OpMode, says anything of how often a cycle samples it."""
    return any(pdo.os_fac for _, pdos in pdos_by_direction(device) for pdo in pdos) or any(
        pdo.os_fac for op_mode in device.op_modes for item in op_mode.sm_assignments for pdo in item.pdos
    )


def _fits(pdo: Pdo, mapped: Sequence[tuple[int, int, int]]) -> bool:
    """Whether a mapping has values and gaps of the lengths that the description has."""
    described = [(bool(entry.entry_index), entry.bit_length) for entry in pdo.entries]
    return described == [(bool(index), bits) for index, _, bits in mapped]


def _with_objects(entries: Sequence[Entry], mapped: Sequence[tuple[int, int, int]]) -> tuple[Entry, ...]:
    return tuple(
        msgspec.structs.replace(entry, entry_index=index, subindex=subindex)
        for entry, (index, subindex, _) in zip(entries, mapped, strict=True)
    )


def _sampled(pdo: Pdo, factor: int) -> Remarking[list[tuple[Entry, ...]]]:
    """The entries of each sample: OSIndexInc moves the objects of each by one step more, padding stays padding.

    Nothing moves where an index would leave 16 bits, as in slots (ESI-FACTS section 12.1).
    """
    step = pdo.os_index_inc or 0
    reached = [(entry.entry_index or 0) + step * (factor - 1) for entry in pdo.entries if entry.entry_index]
    if any(not 0 < index <= MAX_INDEX for index in reached) and step and factor > 1:
        yield f"PDO {index_words(pdo.pdo_index)}: OSIndexInc {step} leads out of 16 bits in {factor} samples; left out"
        step = 0
    further = (
        tuple(
            msgspec.structs.replace(entry, entry_index=entry.entry_index + step * sample)
            if step and entry.entry_index
            else entry
            for entry in pdo.entries
        )
        for sample in range(1, factor if pdo.entries else 1)
    )
    return [pdo.entries, *further]
