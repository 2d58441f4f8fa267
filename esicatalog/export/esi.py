"""ESI documents of devices: what the catalog knows of them, written so that it reads the same.

A device needs in its document the modules that its slots reach, and no other module that they would reach too:
vendors give one ModuleIdent to different modules in different documents. Devices that would disturb each other so
are kept apart in documents of their own. Modules that no slot reaches stand where no slot would take them.
"""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import PurePosixPath
from typing import Any, NamedTuple

import msgspec

from esicatalog.errors import InputError
from esicatalog.esi.containers import resolve_reference
from esicatalog.esi.content import digest
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.document import DiagInfo, DictInfo, EsiInfo, Group, Vendor
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.profile import Profile
from esicatalog.esi.write import write_esi
from esicatalog.export.subject import Subject
from esicatalog.model.slots import ModuleVendor, accepts, reachable_modules


class DeviceWithModules(NamedTuple):
    """A device with the modules that its slots reach, in document order."""

    device: Device
    modules: Sequence[Module] = ()


class EsiContent(NamedTuple):
    """What documents are made of."""

    vendor: Vendor
    groups: tuple[Group, ...]
    devices: tuple[DeviceWithModules, ...]


def content_of(subjects: Sequence[Subject]) -> EsiContent:
    """What documents of some descriptions of one vendor are made of; the first one names the vendor."""
    first = subjects[0]
    return EsiContent(
        first.document_vendor or Vendor(vendor_id=first.vendor_id),
        tuple(group for subject in subjects for group in subject.groups),
        tuple(DeviceWithModules(subject.device, subject.modules) for subject in subjects),
    )


def sharing_a_document(subjects: Iterable[Subject]) -> Iterator[Subject]:
    """The same descriptions. Raises :class:`InputError` at the first that cannot share a document with those before."""
    document = _Document()
    for subject in subjects:
        document.require(subject.device, _by_key(subject.modules))
        yield subject


class VendorEsi(NamedTuple):
    """A document of a vendor, and of the modules that no slot reaches those that cannot stand in it."""

    document: bytes
    left_out: tuple[Module, ...]


def export_esi(vendor: Vendor, groups: Iterable[Group], devices: Iterable[DeviceWithModules]) -> bytes:
    """One EtherCATInfo document of devices, their modules and the groups they name, everything inline.

    ``groups`` may hold more than is needed; the first of a type counts. Raises :class:`InputError` when devices
    plug different modules under one ModuleIdent or ModuleClass and so cannot share a document, and for a module that a
    slot takes as another vendor's only.
    """
    return export_vendor_esi(vendor, groups, devices, ()).document


def export_vendor_esi(
    vendor: Vendor, groups: Iterable[Group], devices: Iterable[DeviceWithModules], unreached: Iterable[Module]
) -> VendorEsi:
    """The document of :func:`export_esi` with the modules that no slot reaches, as far as they can stand in it.

    One cannot that a slot of these devices would take, or whose ModuleIdent another module of the document has.
    """
    document = _Document()
    for device, modules in devices:
        document.require(device, _by_key(modules))
    left_out = tuple([module for module in unreached if not document.take_unreached(module)])
    return VendorEsi(write_esi(_info(vendor, tuple(groups), document, None)), left_out)


def export_esi_files(
    name: str,
    vendor: Vendor,
    groups: Iterable[Group],
    devices: Iterable[DeviceWithModules],
    unreached: Iterable[Module] = (),
) -> dict[str, bytes]:
    """The documents of devices with the dictionaries and diagnosis texts beside them, by relative file name.

    The first file is ``name``; devices, and modules that no slot reaches, that cannot share it follow in ``…-2.xml``
    and so on. A profile that names a DictionaryFile or a single DiagFile gets that file under the vendor's own path. It
    is written inline instead where the path leads outside of the folder, or means the file of another device with other
    content, and where several DiagFiles share the texts (records do not tell which text came from which). Raises
    :class:`InputError` for a module that a slot takes as another vendor's only.
    """
    documents, known_groups = _documents(devices, unreached), tuple(groups)
    names = [name, *(_numbered(name, number) for number in range(2, len(documents) + 1))]
    beside = _FilesBeside()
    for taken in (*names, *_missing_files(documents)):
        beside.reserve(taken)
    infos = [_info(vendor, known_groups, document, beside) for document in documents]
    files = {file_name: write_esi(info) for file_name, info in zip(names, infos, strict=True)}
    return files | {path: beside.read(path) for path in beside.paths()}


def _numbered(name: str, number: int) -> str:
    path = PurePosixPath(name)
    return str(path.with_name(f"{path.stem}-{number}{path.suffix}"))


class _Document:
    """Devices and modules that can stand in one document."""

    def __init__(self) -> None:
        self.devices: list[Device] = []
        self.modules: dict[bytes, Module] = {}
        """By content: equal modules of several devices are written once."""

    def take(self, device: Device, modules: dict[bytes, Module]) -> bool:
        """Take a device in, unless it or one that is here would then reach other modules than its own."""
        foreign = [module for key, module in self.modules.items() if key not in modules]
        added = [module for key, module in modules.items() if key not in self.modules]
        together = self.modules | modules
        if (
            reachable_modules(device, foreign)
            or any(reachable_modules(held, added) for held in self.devices)
            or _by_ident({key: module for key, module in together.items() if key in modules}) != _by_ident(modules)
        ):
            return False
        self.devices.append(device)
        self.modules = together
        return True

    def require(self, device: Device, modules: dict[bytes, Module]) -> None:
        """Take a device in. Raises :class:`InputError` where that cannot be."""
        if not self.take(device, modules):
            raise InputError(
                f"device {device.type!r} cannot share a document with the others: modules of the same ModuleIdent or "
                "ModuleClass would fit its slots or theirs; write several documents: --with-files -o OUT"
            )

    def take_unreached(self, module: Module) -> bool:
        """Take a module in, unless a device that is here would reach it or another module has its ModuleIdent."""
        idents = {held.module_ident for held in self.modules.values()} - {None}
        if module.module_ident in idents or any(reachable_modules(device, [module]) for device in self.devices):
            return False
        self.modules[_key(module)] = module
        return True


def _key(module: Module) -> bytes:
    return digest(msgspec.msgpack.encode(module))


def _by_key(modules: Iterable[Module]) -> dict[bytes, Module]:
    return {_key(module): module for module in modules}


def _by_ident(modules: dict[bytes, Module]) -> list[bytes]:
    """Modules by ModuleIdent, those that share one in their order: the first of them is the default."""
    return sorted(modules, key=lambda key: modules[key].module_ident or 0)


def _documents(devices: Iterable[DeviceWithModules], unreached: Iterable[Module] = ()) -> list[_Document]:
    documents = [_Document()]
    for device, modules in devices:
        own = _by_key(modules)
        if not any(document.take(device, own) for document in documents):
            documents.append(_Document())
            documents[-1].take(device, own)
    for module in unreached:
        if not any(document.take_unreached(module) for document in documents):
            documents.append(_Document())
            documents[-1].take_unreached(module)
    return documents


def _check_vendors(vendor: Vendor, document: _Document) -> None:
    """Raise :class:`InputError` for a module that no slot would reach: all here become those of the one vendor."""
    of_vendor = ModuleVendor(vendor.vendor_id, vendor.vendor_id)
    for device in document.devices:
        for module in reachable_modules(device, document.modules.values()):
            if not any(accepts(slot, module, of_vendor) for slot in device.slots):
                raise InputError(
                    f"device {device.type!r} cannot be written with its module {module.type!r}: its slots take the "
                    f"ModuleClass {module.module_class!r} of another vendor only, and a document has one vendor"
                )


def _info(vendor: Vendor, groups: tuple[Group, ...], document: _Document, beside: "_FilesBeside | None") -> EsiInfo:
    _check_vendors(vendor, document)
    return EsiInfo(
        vendor=vendor,
        groups=_groups_of(document.devices, groups),
        devices=tuple(_with_profiles(device, beside) for device in document.devices),
        modules=tuple(_with_profiles(module, beside) for module in document.modules.values()),
    )


def _groups_of(devices: Iterable[Device], groups: tuple[Group, ...]) -> tuple[Group, ...]:
    """The groups that devices name and the parents of those, in the order given."""
    by_type = {group.type: group for group in reversed(groups)}
    wanted = [device.group_type for device in devices]
    named: set[str | None] = set()
    while wanted:
        group = by_type.get(wanted.pop())
        if group is not None and group.type not in named:
            named.add(group.type)
            wanted.append(group.parent_group)
    return tuple(group for group in groups if group.type in named and by_type[group.type] is group)


def _missing_files(documents: Iterable[_Document]) -> Iterator[str]:
    """References that led nowhere when the device was read; they must not lead to another device's file now."""
    for document in documents:
        owners: list[Device | Module] = [*document.devices, *document.modules.values()]
        for profile in (profile for owner in owners for profile in owner.profiles):
            if profile.dictionary_file is not None and profile.dictionary is None:
                yield profile.dictionary_file
            if profile.diag_messages is None:
                yield from profile.diag_files


def _with_profiles(owner: Any, beside: "_FilesBeside | None") -> Any:
    profiles = tuple(_with_contents(profile, beside) for profile in owner.profiles)
    return msgspec.structs.replace(owner, profiles=profiles)


def _with_contents(profile: Profile, beside: "_FilesBeside | None") -> Profile:
    """The profile with its external contents either in files beside the document or inline, never both."""
    changes: dict[str, Any] = {}
    if profile.dictionary_file is not None and profile.dictionary is not None:
        dictionary = DictInfo(dictionary=profile.dictionary)
        kept = beside is not None and beside.keep(profile.dictionary_file, dictionary)
        changes |= {"dictionary": None} if kept else {"dictionary_file": None}
    if profile.diag_files and profile.diag_messages is not None:
        texts = DiagInfo(diag_messages=profile.diag_messages)
        kept = beside is not None and len(profile.diag_files) == 1 and beside.keep(profile.diag_files[0], texts)
        changes |= {"diag_messages": None} if kept else {"diag_files": ()}
    return msgspec.structs.replace(profile, **changes) if changes else profile


class _FilesBeside:
    """Files that documents refer to: a container in which every reference that stays inside finds its file."""

    def __init__(self) -> None:
        self._reserved: set[str] = set()
        self._files: dict[str, tuple[str, DictInfo | DiagInfo]] = {}
        """Path and content by the path in lower case: readers find files in any letter case."""

    def reserve(self, reference: str) -> None:
        """Keep nothing in the file that ``reference`` means."""
        path = resolve_reference(self, "", reference)
        if path is not None:
            self._reserved.add(path.lower())

    def keep(self, reference: str, content: DictInfo | DiagInfo) -> bool:
        """Whether the file that ``reference`` means can have this content; then it has."""
        path = resolve_reference(self, "", reference)
        if path is None or path.lower() in self._reserved:
            return False
        _, held = self._files.setdefault(path.lower(), (path, content))
        return held == content

    def paths(self) -> list[str]:
        """The files kept, in the order of the devices."""
        return [path for path, _ in self._files.values()]

    def find(self, member: str) -> str:
        """Any file is there or can be."""
        return member

    def read(self, member: str) -> bytes:
        """The document that a file holds."""
        return write_esi(self._files[member.lower()][1])
