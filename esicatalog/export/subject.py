"""What a generator is about: one device description with the modules it can carry, and where it comes from."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple, Self

from esicatalog.catalog.results import IdentifiedDevice
from esicatalog.errors import InputError, NotFound
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.document import Document, Group, Vendor
from esicatalog.esi.records.module import Module
from esicatalog.identity import Identity, identity_text
from esicatalog.model.module_offer import offered_devices
from esicatalog.model.revisions import hidden_by, latest_revision
from esicatalog.words import one_line


class Subject(NamedTuple):
    """A device description. ``origin`` names the documents that carry it, with the line of the Device element."""

    vendor_id: int
    vendor: str | None
    device: Device
    modules: tuple[Module, ...] = ()
    origin: tuple[str, ...] = ()
    substitution: str | None = None
    """Why this description stands for a device of another revision, in words; None when it is exact."""
    damage: str | None = None
    """That the documents were not read whole, in words: the description may lack something."""
    ambiguities: tuple[str, ...] = ()
    """That the identity names descriptions with other process data too, in words; empty where this one was chosen."""
    document_vendor: Vendor | None = None
    """The vendor as the document writes it."""
    groups: tuple[Group, ...] = ()
    """All groups of the document."""
    variants_with_slots: tuple[int, ...] = ()
    """Of several descriptions of the identity, those that have slots."""
    locations: tuple[str, ...] = ()
    """Where a catalog says that the documents lie which carry it, of members of archives with their place inside."""

    @property
    def product_code(self) -> int | None:
        """None where the document gives none, or none that can be read; so the revision."""
        return self.device.product_code

    @property
    def revision_no(self) -> int | None:
        """See :attr:`product_code`."""
        return self.device.revision_no

    @property
    def codes(self) -> tuple[int | None, int | None]:
        """Product code and revision, see :attr:`product_code`."""
        return self.product_code, self.revision_no

    @property
    def identity_text(self) -> str:
        """Vendor, product and revision of the description, ``-`` for one that it does not give."""
        return identity_text(self.vendor_id, self.product_code, self.revision_no)

    def required_codes(self) -> tuple[int, int, int]:
        """Vendor, product and revision, for what is made for the device that has them.

        Raises :class:`InputError` when the description does not give all of them.
        """
        if self.product_code is None or self.revision_no is None:
            given = {"product code": self.product_code, "revision": self.revision_no}
            missing = " and no ".join(name for name, value in given.items() if value is None)
            raise InputError(
                f"{self.device.type or 'the device'} has no {missing}: it can be exported as ESI only, because masters "
                "and EEPROM images identify it by them"
            )
        return self.vendor_id, self.product_code, self.revision_no

    @property
    def title(self) -> str:
        """Type and name of the device."""
        parts = (self.device.type, display_text(self.device.names))
        return ", ".join(dict.fromkeys(one_line(part) for part in parts if part and part.strip()))

    @property
    def group(self) -> Group | None:
        """The group that the device names; the first of several."""
        return next((group for group in self.groups if group.type == self.device.group_type), None)

    def of_document(self, vendor: Vendor | None, groups: Iterable[Group]) -> Self:
        """The same description with the vendor and groups of its document."""
        return self._replace(document_vendor=vendor, groups=tuple(groups))

    def beside(self, variants_with_slots: tuple[int, ...], ambiguities: tuple[str, ...] = ()) -> Self:
        """The same description among others of its identity, of which these variants have slots."""
        return self._replace(variants_with_slots=variants_with_slots, ambiguities=ambiguities)

    def standing_in(self, reason: str) -> Self:
        """The same description, accepted for another revision."""
        return self._replace(substitution=reason)


def subject_of_description(described: IdentifiedDevice, device: Device, modules: Iterable[Module]) -> Subject:
    """The subject of a description in the catalog. Raises :class:`InputError` when its vendor has no id."""
    found = described.device
    if found.vendor_id is None:
        raise InputError(f"{device.type or 'the device'} is of a vendor without id")
    origin = tuple(f"{source.member}, line {source.line}" for source in described.sources)
    locations = tuple(source.location for source in described.sources)
    return Subject(
        found.vendor_id, found.vendor, device, tuple(modules), origin, damage=described.damage, locations=locations
    )


def subjects_of_document(document: Document, file_name: str) -> list[Subject]:
    """The devices of one ESI document whose vendor has an id, in document order."""
    damage = document.damage(file_name)
    return [
        Subject(
            info.vendor_id, info.vendor_name, device, modules, (f"{file_name}, line {line}",), damage=damage
        ).of_document(info.vendor, info.groups)
        for info, device, modules, line in offered_devices(document)
        if info.vendor_id is not None
    ]


def choose_subject(subjects: Sequence[Subject], identity: Identity | None, file_name: str) -> Subject:
    """The device that ``identity`` names, or the only one; those without codes count where no other is described.

    Without a revision the latest is meant that no other device of its vendor in the document hides; a variant counts
    the descriptions of the same identity in document order. Raises :class:`NotFound` when the document does not
    describe it, and :class:`InputError` when several fit, each with the list of the devices.
    """
    if not subjects:
        raise InputError(f"{file_name}: no device of a vendor with an id is described")
    if identity is None:
        fitting = [item for item in subjects if None not in (item.product_code, item.revision_no)] or list(subjects)
    else:
        fitting = [subject for subject in subjects if _fits(subject, identity)]
    if identity is not None and identity.revision_no is None and fitting:
        of_vendor = [subject for subject in subjects if subject.vendor_id == identity.vendor_id]
        hidden = {codes for item in of_vendor for codes in hidden_by(*item.codes, item.device.hide_types)}
        latest = latest_revision((subject.revision_no, subject.codes in hidden) for subject in fitting)
        fitting = [subject for subject in fitting if subject.revision_no == latest]
    if identity is not None and identity.variant is not None:
        with_slots = tuple(number for number, subject in enumerate(fitting, 1) if subject.device.slots)
        fitting = [subject.beside(with_slots) for subject in fitting[identity.variant - 1 : identity.variant]]
    if len(fitting) == 1:
        return fitting[0]
    listed = ", ".join(f"{subject.identity_text} ({subject.device.type}; {subject.origin[0]})" for subject in subjects)
    if identity is None:
        raise InputError(f"{file_name} describes {len(subjects)} devices; name one of: {listed}")
    if fitting:
        raise InputError(
            f"{file_name} describes {identity} {len(fitting)} times; append @1 to @{len(fitting)}: "
            + ", ".join(subject.origin[0] for subject in fitting)
        )
    raise NotFound(f"{file_name} does not describe {identity}; it describes: {listed}")


def _fits(subject: Subject, identity: Identity) -> bool:
    return (
        subject.vendor_id == identity.vendor_id
        and subject.product_code == identity.product_code
        and identity.revision_no in (None, subject.revision_no)
        and (subject.revision_no is None or not identity.without_revision)
    )
