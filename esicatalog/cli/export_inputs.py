"""Where the devices of ``esicatalog export`` come from: the catalog, an ESI file, the listing of a bus."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import msgspec

from esicatalog.cli.common import catalog_to_ask, read_text_as
from esicatalog.errors import InputError, NotFound
from esicatalog.export.choice import Choice
from esicatalog.identity import Identity
from esicatalog.words import counted, hex32

if TYPE_CHECKING:
    from esicatalog.catalog.results import FoundDevice
    from esicatalog.esi.records.module import Module
    from esicatalog.export.configuration import Configuration
    from esicatalog.export.esi import EsiContent
    from esicatalog.export.scan_bus import BusConfigurations
    from esicatalog.export.subject import Subject


class Inputs(NamedTuple):
    """The device that is asked for, and what is chosen for it."""

    identity: Identity | None
    db: str
    esi: Path | None
    accept_revision: bool
    choice: Choice
    notes: list[str]
    """What is told about the devices that were taken, once something is made of them: a refusal is one line."""
    output: str | None
    """The file that is written, None for stdout."""
    read: list[str]
    """The files that are read, and those of the catalog; what they pull in is added when they are read."""

    def configuration(self) -> "Configuration":
        """The configured device. Raises :class:`InputError` and :class:`NotFound` with what to do."""
        from esicatalog.export.configuration import configure

        return configure(self.subject(), self.choice)

    def subject(self) -> "Subject":
        """The device by its ESI file or by the catalog."""
        from esicatalog.export.scan_bus import subject_for

        if self.esi is not None:
            found, references = _subject_of_file(self.esi, self.identity)
            self.read.extend(str(self.esi.parent / member) for member in references)
            self.tell(found)
            return found
        if self.identity is None:
            raise InputError("say which device: an IDENTITY, or --esi FILE")
        with catalog_to_ask(self.db) as catalog:
            found = subject_for(catalog, self.identity, self.accept_revision)
        self.tell(found)
        return found

    def tell(self, subject: "Subject") -> None:
        """Note, once, what there is to know of a description and of its choice.

        Raises :class:`InputError` where the output is a document that the catalog has it from.
        """
        from esicatalog.esi.containers import NESTED

        files = {part for location in subject.locations for part in (location, location.split(NESTED)[0])}
        self.read.extend(name for name in files.difference(self.read) if Path(name).exists())
        self.check_output(self.output)
        accepted = f"accepted, {subject.substitution}" if subject.substitution is not None else None
        told = (accepted, subject.damage, *subject.ambiguities)
        self.notes.extend(words for words in told if words and words not in self.notes)

    def check_output(self, output: str | Path | None) -> None:
        """Raise :class:`InputError` where writing there would destroy a file that is read, or the catalog."""
        if output is not None and any(_is_same_file(Path(output), Path(name)) for name in self.read):
            raise InputError(f"{output}: is an input of this export or its catalog; write to another file")

    def check_no_device(self, option: str) -> None:
        """Raise :class:`InputError` when a device is named beside an option that says everything itself."""
        if self.identity is not None or self.esi is not None:
            raise InputError(f"{option} says itself what it is about: give neither IDENTITY nor --esi")


def configurations_of_scan(inputs: Inputs, file: Path) -> "BusConfigurations":
    """Configurations of the slaves that the catalog knows and that can be configured, and words about the others."""
    from esicatalog.export.scan_bus import bus_configurations
    from esicatalog.scan.front import read_scan

    inputs.check_no_device("--scan")
    choice = inputs.choice
    if choice.pdos or choice.modules or choice.op_mode is not None:
        raise InputError("--scan takes the default PDOs, modules and OpModes; choose them for one device at a time")
    if choice.alias or choice.position:
        raise InputError("--scan addresses every slave by its ring position; give --alias or --position for one device")
    scan = read_text_as(file, read_scan)
    with catalog_to_ask(inputs.db) as catalog:
        found = bus_configurations(catalog, scan, accept_revision=inputs.accept_revision, cycle_ns=choice.cycle_ns)
    for configuration in found.configurations:
        inputs.tell(configuration.subject)
    return found


def content_of_vendor(inputs: Inputs, vendor_id: int, in_one_document: bool) -> "tuple[EsiContent, tuple[Module, ...]]":
    """The preferred description of every device of a vendor, and the modules that no slot of any device reaches.

    The other descriptions are noted. Raises :class:`NotFound` when there is neither, and :class:`InputError` at the
    first device that cannot be ``in_one_document`` with those before it.
    """
    from esicatalog.catalog.device_filter import DeviceFilter
    from esicatalog.export.esi import EsiContent, content_of, sharing_a_document

    inputs.check_no_device("--vendor")
    with catalog_to_ask(inputs.db) as catalog:
        found = catalog.export_subjects(vendor_id)
        subjects = list(sharing_a_document(found) if in_one_document else found)
        unreached = catalog.unreached_modules(vendor_id)
        listed = catalog.find(DeviceFilter(vendor_id=vendor_id, all_variants=True, include_hidden=True))
    if not subjects and not unreached.modules:
        raise NotFound(f"vendor {hex32(vendor_id)} has no device and no module in the catalog")
    for subject in subjects:
        inputs.tell(subject)
    inputs.notes.extend(_further_descriptions(listed))
    return content_of(subjects) if subjects else EsiContent(unreached.vendor, (), ()), unreached.modules


def left_out_words(modules: "Sequence[Module]") -> "Iterator[str]":
    """That modules are not in the one document that is written; nothing where all are."""
    if modules:
        named = ", ".join(f"{module.type!r} ({hex32(module.module_ident)})" for module in modules)
        yield (
            f"left out: {counted(len(modules), 'module')} that no description reaches, because a device here would "
            f"take them or another module has their ModuleIdent; --with-files -o OUT writes them too: {named}"
        )


def _further_descriptions(listed: "Iterable[FoundDevice]") -> "Iterator[str]":
    """Identity by identity the descriptions that are not preferred."""
    further: dict[str, list[int]] = {}
    for device in listed:
        if device.variant > 1:
            preferred = msgspec.structs.replace(device, variant=1)
            further.setdefault(preferred.identity_text, []).append(device.variant)
    for identity, variants in further.items():
        numbers = " to ".join(f"@{number}" for number in dict.fromkeys((min(variants), max(variants))))
        yield f"{identity}: {counted(len(variants), 'more description')}, {numbers}"


def _is_same_file(path: Path, other: Path) -> bool:
    """Whether both are one regular file, or would be: a terminal may well be read and written."""
    if path.exists() and other.exists():
        return path.is_file() and path.samefile(other)
    return path.resolve() == other.resolve()


def _subject_of_file(file: Path, identity: Identity | None) -> "tuple[Subject, list[str]]":
    """The device of a file, and the members beside it that the file pulls in."""
    from esicatalog.esi.reader import read_esi
    from esicatalog.export.subject import choose_subject, subjects_of_document
    from esicatalog.ingest.this_process import limited

    with limited():
        document = read_esi(file).document
    references = [reference.location for reference in document.references if reference.location is not None]
    return choose_subject(subjects_of_document(document, file.name), identity, file.name), references
