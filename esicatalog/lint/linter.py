"""The linter: runs the rules over a document and gives findings with element path and line."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import compress, repeat
from typing import Any, NamedTuple

from esicatalog.esi.binding import Record
from esicatalog.esi.notes import Finding
from esicatalog.esi.reader import ReadDocument
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.dictionary import Dictionary, Object
from esicatalog.esi.records.document import Document, EsiInfo
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo
from esicatalog.lint.locator import Locator, Tree
from esicatalog.lint.objects import DataTypeSubject, ObjectSubject, ObjectValues, ValuesOfType
from esicatalog.lint.registry import Check, Found, Place, Rule
from esicatalog.lint.rules import ALL_RULES
from esicatalog.lint.rules.mapping import foreign_types
from esicatalog.lint.subjects import (
    DeviceSubject,
    Dictionaries,
    FileFinder,
    Gaps,
    InfoSubject,
    ModuleSubject,
    Owner,
    PdoMapping,
    PdoTypes,
    ProcessSubject,
    joined_dictionaries,
    pdo_mapping,
)
from esicatalog.model.derivation import Deriver
from esicatalog.model.dictionary_views import DictionaryView
from esicatalog.model.memo import IdentityMemo, identities
from esicatalog.model.module_offer import ModuleOffer, module_offers
from esicatalog.model.resolver import TypeSet

_MAX_RECORDS = 20_000
_MAX_TYPES = 5_000
_MAX_OWNERS = 2_000
_MAX_DICTIONARIES = 500
_NO_DEVICES = EsiInfo()
"""The section of a document of modules, as far as rules look at it."""


class _Hit(NamedTuple):
    rule: Rule
    found: Found
    place: Place

    def below(self, place: Place) -> "_Hit":
        """The same with its place seen from further out."""
        return _Hit(self.rule, self.found, place + self.place)


_Hits = Sequence[_Hit]


class Linter:
    """Lints documents one after the other; remembers what it found in records that many of them share.

    ``deriver`` keeps what it derives for whoever asks for the same later.
    """

    def __init__(self, rules: Iterable[Rule] = ALL_RULES, deriver: Deriver | None = None) -> None:
        self._checks: dict[Any, list[tuple[Rule, Check]]] = defaultdict(list)
        self._ids = set()
        for rule in rules:
            self._ids.add(rule.id)
            if rule.check is not None:
                for subject in rule.subjects:
                    self._checks[subject].append((rule, rule.check))
        self._deriver = deriver or Deriver()
        self._views = self._deriver.views
        self._of_process: IdentityMemo[_Hits] = IdentityMemo(_MAX_OWNERS)
        self._of_pdos: IdentityMemo[_Hits] = IdentityMemo(_MAX_OWNERS)
        self._of_record: IdentityMemo[_Hits] = IdentityMemo(_MAX_RECORDS)
        self._of_object: IdentityMemo[_Hits] = IdentityMemo(_MAX_RECORDS)
        self._of_data_type: IdentityMemo[_Hits] = IdentityMemo(_MAX_RECORDS)
        self._foreign_types: IdentityMemo[Sequence[tuple[int, str]]] = IdentityMemo(_MAX_RECORDS)
        self._values_of_type: IdentityMemo[ValuesOfType] = IdentityMemo(_MAX_TYPES)
        self._of_types: IdentityMemo[_Hits] = IdentityMemo(_MAX_DICTIONARIES)
        self._of_dictionary: IdentityMemo[_Hits] = IdentityMemo(_MAX_DICTIONARIES)

    def document(self, read: ReadDocument, tree: Tree, find_file: FileFinder | None = None) -> list[Finding]:
        """All findings about a document, those of its reader included, by line.

        ``tree`` gives the elements of the document; it is called only when there is something to report.
        ``find_file`` tells whether a file that the document names lies beside it.
        """
        findings = [finding for finding in read.findings if finding.rule in self._ids]
        hits = self._document(read.document, find_file)
        if hits:
            locator = Locator(read.document, tree)
            for hit in hits:
                path, line = locator.position(hit.place)
                severity = hit.found.severity or hit.rule.severity
                findings.append(Finding(hit.rule.id, severity, hit.found.message, line, path))
        return sorted(findings, key=lambda finding: finding.line)

    def _check(self, subject: Any, kind: Any) -> list[_Hit]:
        return [_Hit(rule, found, found.place) for rule, check in self._checks[kind] for found in check(subject)]

    def _document(self, document: Document, find_file: FileFinder | None) -> list[_Hit]:
        hits: list[_Hit] = []
        if document.dictionary is not None:
            hits += _below(("dictionary",), self._dictionary(document.dictionary))
        references = document.references
        external = {reference.text for reference in references if reference.sha256 is not None}
        broken = [item for item in references if not item.is_whole]
        gaps = Gaps(
            not document.is_whole,
            [item.text for item in broken if item.kind == "InfoReference"],
            [item.text for item in broken if item.kind == "DictionaryFile"],
        )
        for number, (info, offer) in enumerate(zip(document.infos, module_offers(document), strict=True)):
            found = self._info(info, offer, external, gaps, find_file)
            hits += _below(("infos", number), found)
        return hits

    def _info(
        self,
        info: EsiInfo,
        offer: ModuleOffer,
        external: set[str],
        gaps: Gaps,
        find_file: FileFinder | None,
    ) -> list[_Hit]:
        """Modules that an InfoReference pulls in are checked in their own document, which does not know the devices:
        here is told what they have not in common with these, at the reference.
        """
        modules = [self._module(module, info, gaps) for module in offer.modules]
        devices = [self._device(device, info, offer, modules, gaps) for device in info.devices]
        for device in devices:
            for module in device.modules:
                module.hosts.append(device)
        hits = self._check(InfoSubject(info, find_file), InfoSubject)
        if info.vendor is not None:
            hits += _below(("vendor",), self._check(info.vendor, Record))
        for number, group in enumerate(info.groups):
            hits += _below(("groups", number), self._check(group, Record))
        for number, device in enumerate(devices):
            hits += _below(("devices", number), self._owner(device, DeviceSubject, external))
        for number, module in enumerate(modules[: len(info.modules)]):
            hits += _below(("modules", number), self._owner(module, ModuleSubject, external))
        at_reference: Place = ("info_references", 0) if len(info.info_references) == 1 else ()
        for module in modules[len(info.modules) :]:
            hits += _below(at_reference, self._with_hosts_only(module, gaps))
        for module in modules:
            module.hosts.clear()  # no circles: they would stay in memory until the collector comes by
        return hits

    def _module(self, module: Module, info: EsiInfo, gaps: Gaps) -> ModuleSubject:
        return ModuleSubject(module, info, self._views.of(module.profiles), gaps)

    def _with_hosts_only(self, module: ModuleSubject, gaps: Gaps) -> Iterator[_Hit]:
        """What is found in a module of another document because of the devices here, and not there already.

        Its records and dictionaries are what they are with any device.
        """
        if not module.hosts:
            return
        alone = self._module(module.module, _NO_DEVICES, gaps)
        told_there = {(hit.rule.id, hit.found) for hit in [*self._check(alone, ModuleSubject), *self._pdos(alone)]}
        words = f"module 0x{module.module.module_ident or 0:X} of another document: "
        for hit in [*self._check(module, ModuleSubject), *self._pdos(module)]:
            if (hit.rule.id, hit.found) not in told_there:
                yield hit._replace(found=hit.found._replace(message=words + hit.found.message), place=())

    def _device(
        self,
        device: Device,
        info: EsiInfo,
        offer: ModuleOffer,
        modules: Iterable[ModuleSubject],
        gaps: Gaps,
    ) -> DeviceSubject:
        reachable = list(compress(modules, offer.reached_by(device))) if device.slots else []
        derivation = self._deriver.derive(device, [item.module for item in reachable])
        return DeviceSubject(device, info, self._views.of(device.profiles), reachable, derivation, gaps)

    def _owner(self, owner: Owner, kind: type[Owner], external: set[str]) -> list[_Hit]:
        hits = self._check(owner, kind)
        if isinstance(owner, DeviceSubject) and (of_process := self._process(owner)):
            hits = sorted([*hits, *of_process], key=lambda hit: hit.rule.id)
        hits += self._check(owner.record, Record)
        if isinstance(owner, DeviceSubject):
            for number, slot in enumerate(owner.device.slots):
                hits += _below(("slots", number), self._check(slot, Record))
        hits += self._pdos(owner)
        for number, profile in enumerate(owner.record.profiles):
            for position, channel in enumerate(profile.channel_infos):
                hits += _below(("profiles", number, "channel_infos", position), self._check(channel, Record))
            if profile.dictionary is not None and profile.dictionary_file not in external:
                hits += _below(("profiles", number, "dictionary"), self._dictionary(profile.dictionary))
        return hits

    def _process(self, device: DeviceSubject) -> _Hits:
        data = device.derivation.process_data
        return self._of_process.get((id(data), device.is_complete), data, self._check_process, device)

    def _check_process(self, device: DeviceSubject) -> _Hits:
        subject = ProcessSubject(device.derivation.process_data, device.modules, device.is_complete)
        return self._check(subject, ProcessSubject)

    def _pdos(self, owner: Owner) -> _Hits:
        record, dictionaries = owner.record, self._dictionaries_for(owner)
        looked_at = (record.rx_pdos, record.tx_pdos, dictionaries.views, owner.types, *_slots(owner))
        completeness = (owner.own.is_complete, dictionaries.is_complete)
        key = (*map(identities, looked_at), _increments(owner), completeness)
        return self._of_pdos.get(key, looked_at, self._check_pdos, owner, dictionaries)

    def _check_pdos(self, owner: Owner, dictionaries: Dictionaries) -> _Hits:
        hits: list[_Hit] = []
        for place, direction, pdo in owner.pdos:
            hits += _below(place, self._of_record.of(pdo, self._check_pdo))
            foreign = self._foreign_types.of(pdo, foreign_types)
            if foreign:
                hits += _below(place, self._check(PdoTypes(pdo, foreign, owner.types, owner.own.is_complete), PdoTypes))
            if dictionaries.views and pdo.entries:
                hits += _below(place, self._check(pdo_mapping(direction, pdo, dictionaries), PdoMapping))
        return hits

    def _dictionaries_for(self, owner: Owner) -> Dictionaries:
        """Where the objects of its PDOs are looked up: its own, then those of what it is plugged into or carries.

        Nowhere when it has none of its own: then the document does not tell its objects.
        """
        if not owner.own:
            return owner.own
        others: Sequence[Owner] = ()
        in_slots = None
        if isinstance(owner, DeviceSubject):
            others, in_slots = owner.modules, owner.entries_in_slots
        elif isinstance(owner, ModuleSubject):
            others = owner.hosts
        return joined_dictionaries((owner, *others), in_slots) if others else owner.own

    def _check_pdo(self, pdo: Pdo) -> _Hits:
        return self._check(pdo, Record) + self._check(pdo, Pdo) or ()

    def _dictionary(self, dictionary: Dictionary) -> _Hits:
        view = self._views.view(dictionary)
        return self._of_dictionary.of(view, self._check_dictionary)

    def _check_dictionary(self, view: DictionaryView) -> _Hits:
        types, objects = view.types, view.dictionary.objects
        hits = self._check(view, DictionaryView)
        hits += self._of_types.of(types, self._check_types)
        keys = zip(map(id, objects), [types.closure(declared.type) for declared in objects], strict=True)
        found = self._of_object.get_all(keys, zip(objects, repeat(types)), self._check_object)
        return hits + _below_each("objects", found)

    def _check_object(self, met: tuple[Object, TypeSet], key: tuple[int, tuple[int, ...]]) -> _Hits:
        declared, types = met
        _, closure = key
        hits = self._check(declared, Record)
        data_type = types.by_name.get(declared.type) if declared.type else None
        if data_type is None or data_type.bit_size != declared.bit_size:
            hits += self._check(ObjectSubject(declared, data_type), ObjectSubject)
        sub_items = data_type.sub_items if data_type is not None else ()
        of_type = self._values_of_type.get(closure, types, ValuesOfType, sub_items, types) if sub_items else None
        values = ObjectValues(declared, of_type, types, self._deriver.resolver)
        if not values.is_sound:
            hits += self._check(values, ObjectValues)
        return hits or ()

    def _check_types(self, types: TypeSet) -> _Hits:
        declared = types.by_name.get
        subjects = [
            DataTypeSubject(data_type, tuple([declared(item.type or "") for item in data_type.sub_items]))
            for data_type in types.data_types
        ]
        keys = [identities((data_type, *of_sub_items)) for data_type, of_sub_items in subjects]
        found = self._of_data_type.get_all(keys, subjects, self._check_data_type)
        return self._check(types, TypeSet) + _below_each("data_types", found)

    def _check_data_type(self, subject: DataTypeSubject, key: tuple[int, ...]) -> _Hits:
        return self._check(subject.data_type, Record) + self._check(subject, DataTypeSubject) or ()


def _slots(owner: Owner) -> tuple[Sequence[Any], Sequence[Any]]:
    """What decides, beside increments, where modules have their objects."""
    return (owner.device.slots, owner.module_records) if isinstance(owner, DeviceSubject) else ((), ())


def _increments(owner: Owner) -> tuple[int | None, int | None]:
    if not isinstance(owner, DeviceSubject):
        return None, None
    return owner.device.slot_index_increment, owner.device.slot_group_index_increment


def _below(place: Place, hits: Iterable[_Hit]) -> list[_Hit]:
    return [hit.below(place) for hit in hits] if hits else []


def _below_each(field: str, found: Iterable[_Hits]) -> list[_Hit]:
    """What was found in each item of a list."""
    return [hit.below((field, number)) for number, hits in enumerate(found) if hits for hit in hits]
