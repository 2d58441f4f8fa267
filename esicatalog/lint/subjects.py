"""What rules look at: a vendor section, a device, a module, a PDO against the dictionaries it maps from.

Everything that needs work is made when a rule asks for it, and then kept.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any, NamedTuple

from esicatalog.esi.binding import Record
from esicatalog.esi.containers import reference_path
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.document import EsiInfo
from esicatalog.esi.records.mailbox import InitCmd, coe_init_cmds
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.esi.records.profile import Profile, declared_objects
from esicatalog.lint.registry import Place
from esicatalog.model.derivation import Derivation
from esicatalog.model.dictionary import ObjectEntry
from esicatalog.model.dictionary_views import DictionaryView, EntriesBySubindex, counting_view
from esicatalog.model.pdo_facts import PDO_FIELDS, has_object
from esicatalog.model.process_data import ProcessData
from esicatalog.model.resolver import TypeSet

InSlots = Callable[[int], Iterable[EntriesBySubindex]]
"""Entries of the objects that modules have at an index in slots that they move with."""
FileFinder = Callable[[str], bool]
"""Whether a file that the document names lies beside it."""

FIRST_OBJECT = 0x1000
"""Below lie the data types; a PDO may map them as fillers."""


def is_absent(record: Record, field: str) -> bool:
    """Whether a value is not given at all, or by an empty text; what cannot be read is the reader's finding."""
    return getattr(record, field) is None and not (record.spelling or {}).get(field)


def is_off(record: Record, field: str) -> bool:
    """Whether a value is false, 0 or not given at all."""
    return is_absent(record, field) if (value := getattr(record, field)) is None else not value


class DeclaredPdo(NamedTuple):
    """A PDO of a device or module and where it stands there."""

    place: Place
    direction: str
    pdo: Pdo


class Dictionaries:
    """The dictionaries of an owner as one, see :func:`~esicatalog.model.dictionary_views.counting_view`.

    ``is_complete``: no document is missing that may have further objects. ``in_slots`` tells what modules have at an
    index in slots that they move with, to which marked objects yield.
    """

    def __init__(
        self, views: Iterable[DictionaryView], is_complete: bool = True, in_slots: "InSlots | None" = None
    ) -> None:
        self.views = tuple([view for view in views if view.by_index])
        self.is_complete = is_complete
        self._in_slots = in_slots

    def __bool__(self) -> bool:
        return bool(self.views)

    def entries(self, index: int) -> EntriesBySubindex | None:
        """Entries of an object by subindex; None when there is no such object."""
        view = counting_view(self.views, index)
        if view is None:
            return None
        brought = next(iter(self.in_slots(index)), None) if view.by_index[index].overwritten_by_module else None
        return brought or view.entries(index)

    def in_slots(self, index: int) -> Iterable[EntriesBySubindex]:
        """Entries of the objects that modules have at an index in slots that they move with."""
        return self._in_slots(index) if self._in_slots is not None else ()

    def entry(self, index: int, subindex: int) -> ObjectEntry | None:
        """One entry."""
        return (self.entries(index) or {}).get(subindex)

    def default(self, index: int) -> int | None:
        """The default of an object that is a single value, as a number."""
        entry = self.entry(index, 0)
        return entry.default_int if entry is not None else None


def declared_pdos(record: Device | Module | ProcessData) -> list[DeclaredPdo]:
    """PDOs in document order, outputs first."""
    return [
        DeclaredPdo((field, position), direction, pdo)
        for direction, field in PDO_FIELDS.items()
        for position, pdo in enumerate(getattr(record, field))
    ]


class Gaps(NamedTuple):
    """What of a document was not read as a whole and may say more than is known: nothing follows from what is absent
    there.
    """

    is_itself: bool
    """Whether it is the document itself."""
    module_documents: Sequence[str]
    """What an InfoReference names."""
    dictionaries: Sequence[str]
    """What a DictionaryFile names, seen from the document; others name what modules of other documents refer to."""

    def missing(self, may_have_modules: bool) -> list[str]:
        """In words, what may say more of a device or a module."""
        words = [f"{name!r} is missing or broken" for name in self.module_documents if may_have_modules]
        return [*words, "this document is broken"] if self.is_itself else words

    def concerns(self, profile: Profile) -> bool:
        """Whether the dictionary of a profile is missing, or may have further objects."""
        name = reference_path(profile.dictionary_file or "")
        return bool(name) and (
            profile.dictionary is None or any(reference_path(text).endswith(name) for text in self.dictionaries)
        )


class Owner:
    """What devices and modules have in common."""

    def __init__(
        self,
        record: Device | Module,
        info: EsiInfo,
        views: Sequence[DictionaryView],
        gaps: Gaps,
        may_have_modules: bool = False,
    ) -> None:
        self.record = record
        self.info = info
        self.missing = gaps.missing(may_have_modules)
        """Documents, in words, that were not read as a whole: they may have further parts of it."""
        self.own = Dictionaries(views, not self.missing and not any(map(gaps.concerns, record.profiles)))
        self.types = tuple([view.types for view in views])
        """The data types that its dictionaries declare."""

    @property
    def is_complete(self) -> bool:
        """Whether no document is missing that may have further parts of it."""
        return not self.missing

    @cached_property
    def pdos(self) -> list[DeclaredPdo]:
        """Its PDOs."""
        return declared_pdos(self.record)

    @property
    def coe_init_cmds(self) -> tuple[InitCmd, ...]:
        """Its CoE start-up commands."""
        return coe_init_cmds(self.record.mailbox)

    def object_place(self, index: int) -> Place:
        """Where an object of its own dictionaries stands; the owner itself when it stands in another document."""
        for number, profile in enumerate(self.record.profiles):
            for position, declared in enumerate(declared_objects((profile,))):
                if declared.object_index == index:
                    return ("profiles", number, "dictionary", "objects", position)
        return ()


class DeviceSubject(Owner):
    """A device with the modules that its slots can reach."""

    record: Device

    def __init__(
        self,
        device: Device,
        info: EsiInfo,
        views: Sequence[DictionaryView],
        modules: Sequence["ModuleSubject"],
        derivation: Derivation,
        gaps: Gaps,
    ) -> None:
        super().__init__(device, info, views, gaps, may_have_modules=bool(device.slots))
        self.device = device
        self.modules = modules
        self.derivation = derivation

    @property
    def module_records(self) -> list[Module]:
        """The reachable modules."""
        return [subject.module for subject in self.modules]

    def entries_in_slots(self, index: int) -> Iterator[EntriesBySubindex]:
        """Entries of the objects that modules have at an index in slots that they move with."""
        dictionaries = {id(subject.module): subject.own for subject in self.modules}
        for module, unshifted in self.derivation.process_data.in_slots.objects(index):
            entries = dictionaries[id(module)].entries(unshifted)
            if entries is not None:
                yield entries

    @property
    def is_modular(self) -> bool:
        """Whether objects and PDOs can come from modules."""
        return bool(self.device.slots)


class ModuleSubject(Owner):
    """A module of a document."""

    record: Module

    def __init__(self, module: Module, info: EsiInfo, views: Sequence[DictionaryView], gaps: Gaps) -> None:
        super().__init__(module, info, views, gaps)
        self.module = module
        self.hosts: list[DeviceSubject] = []
        """The devices of the section whose slots accept it."""

    @property
    def is_complete(self) -> bool:
        """Whether the devices that may carry it are at hand: a document of modules has none."""
        return super().is_complete and bool(self.info.devices)


class ProcessSubject:
    """What a device exchanges in cycles and the modules that it can reach.

    A rule that looks at nothing else of a device is asked once for all devices that have equal ones.
    """

    def __init__(self, data: ProcessData, modules: Sequence[ModuleSubject], is_complete: bool) -> None:
        self.data = data
        self.modules = modules
        self.is_complete = is_complete
        """Whether no document is missing that may have further modules or PDOs."""
        self.pdos = declared_pdos(data)


def joined_dictionaries(owners: Sequence[Owner], in_slots: InSlots | None = None) -> Dictionaries:
    """The dictionaries of several owners as one."""
    views = [view for owner in owners for view in owner.own.views]
    return Dictionaries(views, all(owner.own.is_complete for owner in owners), in_slots)


class InfoSubject(NamedTuple):
    """A vendor section: vendor, groups, devices and modules."""

    info: EsiInfo
    find_file: FileFinder | None

    def with_images(self) -> Iterator[tuple[Place, Any]]:
        """Every record that can carry an image, with its place."""
        info = self.info
        if info.vendor is not None:
            yield ("vendor",), info.vendor
        for number, group in enumerate(info.groups):
            yield ("groups", number), group
        for number, module in enumerate(info.modules):
            yield ("modules", number), module
        for number, device in enumerate(info.devices):
            yield ("devices", number), device
            for position, slot in enumerate(device.slots):
                yield ("devices", number, "slots", position), slot
                for nth, module_class in enumerate(slot.module_classes):
                    yield ("devices", number, "slots", position, "module_classes", nth), module_class
            for position, data in enumerate(device.slot_group_data):
                yield ("devices", number, "slot_group_data", position), data


NumberedEntry = tuple[int, Entry]
"""An entry and its position in its PDO."""


class PdoTypes(NamedTuple):
    """A PDO with the names in its entries that are no base types of ESI."""

    pdo: Pdo
    foreign: Sequence[tuple[int, str]]
    """Each name with the position of the first entry that has it."""
    types: Sequence[TypeSet]
    """The data types that its owner declares."""
    are_all_types: bool
    """Whether its owner names no dictionary that is missing."""


class PdoMapping(NamedTuple):
    """A PDO, held against the dictionaries of its owner; fillers are left out."""

    direction: str
    pdo: Pdo
    described: list[tuple[int, Entry, ObjectEntry]]
    """Entries, their positions, and what a dictionary says about that which they map."""
    unknown: list[NumberedEntry]
    """Entries that map what no dictionary has, and no missing one can have."""


def pdo_mapping(direction: str, pdo: Pdo, dictionaries: Dictionaries) -> PdoMapping:
    """Look up what a PDO maps; what cannot be read is the reader's finding."""
    mapping = PdoMapping(direction, pdo, [], [])
    before, entries = None, None
    for position, entry in enumerate(pdo.entries):
        index = entry.entry_index
        if index is None or index < FIRST_OBJECT or not has_object(entry):
            continue
        if index != before:
            before, entries = index, dictionaries.entries(index)
        declared = entries.get(entry.subindex or 0) if entries is not None else None
        if declared is not None:
            mapping.described.append((position, entry, declared))
        elif dictionaries.is_complete and not any(
            (entry.subindex or 0) in found for found in dictionaries.in_slots(index)
        ):
            mapping.unknown.append((position, entry))
    return mapping
