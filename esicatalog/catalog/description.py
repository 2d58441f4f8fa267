"""One device as the catalog holds it: records, documents, neighbours; and all of it as JSON."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import msgspec
import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.devices import find_device, variants_with_slots
from esicatalog.catalog.identity import IdentityLookup
from esicatalog.catalog.query import ConnectionQuery
from esicatalog.catalog.reader import RecordReader
from esicatalog.catalog.results import DeviceSource, FoundDevice, IdentifiedDevice
from esicatalog.catalog.siblings import Revision, revisions_of, same_layout
from esicatalog.esi.binding import Record
from esicatalog.esi.notes import REFUSED
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.identity import Identity, ModuleChoice
from esicatalog.model.derivation import derive
from esicatalog.model.device_words import init_cmd_target
from esicatalog.model.module_choice import SlotOffer, chosen_modules, slot_offers
from esicatalog.model.pdo_facts import has_object
from esicatalog.model.process_image import SmImage, whole_process_image
from esicatalog.model.slots import PluggedModule, expand_module
from esicatalog.model.start_up import OwnedInitCmd, all_init_cmds
from esicatalog.model.sync import default_position

_MOST_FINDINGS = 200
_NO_LINE = 1 << 31
"""Beyond the last line of any document."""


class SourceFinding(NamedTuple):
    """What was noticed in the Device element, or is broken in its document."""

    rule: str
    severity: str
    message: str
    line: int
    member: str


class DeviceDescription(NamedTuple):
    """A device as the catalog holds it: identity, documents, records of the device and of its modules, neighbours."""

    device_id: int
    """Row number in this catalog; not stable between catalogs."""
    found: FoundDevice
    variants: tuple[IdentifiedDevice, ...]
    """All descriptions of this identity, this one included, the preferred one first. Several contradict each other."""
    device: Device
    modules: tuple[Module, ...]
    revisions: tuple[Revision, ...]
    """All revisions of the product, this one included."""
    same_layout: tuple[FoundDevice, ...]
    """Other devices whose default process image has the same layout."""
    findings: tuple[SourceFinding, ...]
    variants_with_slots: tuple[int, ...] = ()
    """Of several descriptions of the identity, those that have slots."""
    ambiguities: tuple[str, ...] = ()
    """What was chosen where the identity leaves it open and others exchange something else, in words."""

    @property
    def warnings(self) -> tuple[str, ...]:
        """What to know before the description is taken for a device."""
        return tuple(filter(None, (self.identified.damage, *self.ambiguities)))

    @property
    def identified(self) -> IdentifiedDevice:
        """It with the documents and lines that carry it."""
        return next(item for item in self.variants if item.device.variant == self.found.variant)

    @property
    def sources(self) -> tuple[DeviceSource, ...]:
        """Documents and lines that carry it."""
        return self.identified.sources

    @property
    def vendor_id(self) -> int | None:
        """Its vendor, None for one without id."""
        return self.found.vendor_id

    def plugged(self, choice: Mapping[int, ModuleChoice]) -> list[PluggedModule]:
        """The default modules with these in their place. Raises :class:`InputError` for a choice that does not fit."""
        return chosen_modules(self.device, self.modules, choice, self.variants_with_slots)

    def default_position(self, choice: Mapping[int, ModuleChoice]) -> int | None:
        """Position of the OpMode that counts with these modules in place of the default ones.

        Raises :class:`InputError` for a choice that does not fit.
        """
        return default_position(self.device.op_modes, [item.module for item in self.plugged(choice)])

    def images(self, choice: Mapping[int, ModuleChoice]) -> list[SmImage]:
        """Process images with these modules in place of the default ones.

        Raises :class:`InputError` for a choice that does not fit.
        """
        return whole_process_image(self.device, self.modules, self.plugged(choice))

    def init_cmds(self, choice: Mapping[int, ModuleChoice]) -> list[OwnedInitCmd]:
        """InitCmds of the device and of these modules in place of the default ones, as they are sent.

        Raises :class:`InputError` for a choice that does not fit.
        """
        return list(all_init_cmds(self.device, (expand_module(self.device, item) for item in self.plugged(choice))))


def read_description(connection: sa.Connection, lookup: IdentityLookup, identity: Identity) -> DeviceDescription:
    """Read a description in a number of queries that does not depend on its size. Raises :class:`NotFound`."""
    number, found, descriptions = find_device(connection, identity)
    variants = lookup.with_sources(descriptions)
    reader = RecordReader(ConnectionQuery(connection))
    device = reader.device(number)
    return DeviceDescription(
        number,
        found,
        tuple(variants),
        device,
        tuple(reader.modules_of(number)),
        revisions_of(connection, number, found),
        same_layout(connection, number),
        _findings(connection, number),
        variants_with_slots(connection, found, len(variants)),
        lookup.ambiguities(identity, found),
    )


def _findings(connection: sa.Connection, device_id: int) -> tuple[SourceFinding, ...]:
    findings, placed, sources = schema.findings.c, schema.device_sources.c, schema.sources.c
    # What is broken may concern every device of its document, and comes first: of many findings not all are given.
    is_of_document = findings.rule == REFUSED
    query = (
        sa.select(findings.rule, findings.severity, findings.message, findings.line, sources.member)
        .join(schema.device_sources, placed.source_id == findings.source_id)
        .join(schema.sources, sources.id == findings.source_id)
        .where(
            placed.device_id == device_id,
            sa.or_(is_of_document, _below_device(), sa.and_(_without_number(), _in_lines())),
        )
        .order_by(sources.member, ~is_of_document, findings.line, sources.location, findings.id)
        .limit(_MOST_FINDINGS)
    )
    return tuple(SourceFinding(*row) for row in connection.execute(query))


_PATH = sa.func.replace(schema.findings.c.path, "[0]", "")
"""A first element is written with its position or, where it is the only one of its tag, without."""
_BELOW_REPEATED = ("%/Descriptions[%/Devices%/Device%", "%/Devices[%/Device%")
"""Paths into a device that stands in another Descriptions or Devices than the first."""


def _below_device() -> sa.ColumnElement[bool]:
    """Whether the path of a finding is that of the placed Device element or of something in it."""
    placed, root = schema.device_sources.c, schema.sources.c.root
    section = sa.case((root == "EtherCATInfoList", root + _numbered("/EtherCATInfo", placed.section)), else_=root)
    device = section + _numbered("/Descriptions/Devices/Device", placed.position) + "/"
    return sa.func.substr(_PATH + "/", 1, sa.func.length(device)) == device


def _numbered(path: str, position: sa.ColumnElement[int]) -> sa.ColumnElement[str]:
    return sa.case((position == 0, path), else_=sa.literal(path + "[") + sa.cast(position, sa.Text) + "]")


def _without_number() -> sa.ColumnElement[bool]:
    """Whether a path does not tell the number of a device: none is known, or the element around devices occurs again.

    Broken markup has no path.
    """
    return sa.or_(schema.findings.c.path == "", *map(_PATH.like, _BELOW_REPEATED))


def _in_lines() -> sa.ColumnElement[bool]:
    """Whether a finding lies between the placed Device element and the next device or module."""
    placed, modules, line = schema.device_sources.c, schema.module_sources.c, schema.findings.c.line
    later = schema.device_sources.alias().c
    ends = [
        sa.select(sa.func.min(other.line)).where(other.source_id == placed.source_id, other.line > placed.line)
        for other in (later, modules)
    ]
    return sa.and_(
        line >= placed.line,
        *(line < sa.func.coalesce(end.scalar_subquery(), sa.literal(_NO_LINE)) for end in ends),
    )


def description_json(description: DeviceDescription, choice: Mapping[int, ModuleChoice]) -> dict[str, Any]:
    """Identity, sources, variants, process image, slots, InitCmds, facts, drive modes, and the records of device and
    modules.

    Records hold what their document says, and leave out what it does not; what is derived is complete.
    """
    derived = derive(description.device, description.modules)
    images = description.images(choice) if choice else derived.images
    return {
        "identity": description.found.as_json(),
        "sources": [source.as_json() for source in description.sources],
        "warnings": list(description.warnings),
        "variants": [variant.as_json() for variant in description.variants],
        "process_image": [_image_json(image) for image in images],
        "slots": [
            _slots_json(offer)
            for offer in slot_offers(description.device, description.modules, description.plugged(choice))
        ],
        "init_cmds": [_init_cmd_json(item) for item in description.init_cmds(choice)],
        "facts": _complete(derived.facts),
        "drive_modes": [_complete(verdict) for verdict in derived.modes.verdicts],
        "mode_evidence": [_complete(evidence) for evidence in derived.modes.evidence],
        "findings": [item._asdict() for item in description.findings],
        "revisions": [
            {**item.device.as_json(), "hidden": item.hidden, "layout_changed": item.layout_changed}
            for item in description.revisions
        ],
        "same_process_image_layout": [item.as_json() for item in description.same_layout],
        "device": msgspec.to_builtins(description.device),
        "modules": [msgspec.to_builtins(module) for module in description.modules],
    }


def _complete(derived: Record) -> dict[str, Any]:
    """All fields of a record that no document spells."""
    return {name: value for name, value in msgspec.structs.asdict(derived).items() if name != "spelling"}


def _slots_json(offer: SlotOffer) -> dict[str, Any]:
    return {
        "first": offer.numbers[0],
        "last": offer.numbers[-1],
        "name": offer.name,
        "modules": [
            {"choice": str(module.choice), "name": module.name, "plugged": module.is_plugged}
            for module in offer.fitting
        ],
    }


def _init_cmd_json(item: OwnedInitCmd) -> dict[str, Any]:
    command = item.command
    return {
        "slot": item.slot_number,
        "protocol": item.protocol,
        "transitions": list(command.transitions),
        "target": init_cmd_target(command),
        "object_index": command.object_index,
        "subindex": command.subindex,
        "idn": command.idn,
        "channel": command.channel,
        "complete_access": bool(command.complete_access),
        "data": command.data,
        "comment": command.comment,
    }


def _image_json(image: SmImage) -> dict[str, Any]:
    return {
        "sm": image.sm,
        "usage": image.usage,
        "bit_size": image.bit_size if image.has_known_size else None,
        "byte_size": image.byte_size,
        "size": image.size_words,
        "remarks": list(image.remarks),
        "entries": [
            {
                "bit_offset": placed.bit_offset,
                "bit_length": placed.entry.bit_length,
                "entry_index": placed.entry.entry_index,
                "subindex": (placed.entry.subindex or 0) if has_object(placed.entry) else None,
                "name": display_text(placed.entry.names),
                "data_type": placed.entry.data_type,
                "direction": pdo.direction,
                "pdo_index": pdo.pdo.pdo_index,
                "module_ident": pdo.module.module_ident if pdo.module is not None else None,
                "slot": pdo.slot_number,
            }
            for pdo in image.pdos
            for placed in pdo.entries
        ],
    }
