"""The sheet of one device as text."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby
from typing import Any

from esicatalog.catalog.description import DeviceDescription
from esicatalog.catalog.results import FoundDevice
from esicatalog.cli.common import table_lines
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.mailbox import InitCmd, init_cmds
from esicatalog.esi.records.module import Module
from esicatalog.identity import ModuleChoice
from esicatalog.model.cia402 import CIA402
from esicatalog.model.derivation import derive
from esicatalog.model.device_facts import DeviceFacts
from esicatalog.model.device_words import (
    WITHOUT_SLOT,
    axes_alone,
    eeprom_words,
    head_facts,
    init_cmd_target,
    predefined_words,
)
from esicatalog.model.drive_modes import DriveModes
from esicatalog.model.module_choice import module_labels, slot_offers
from esicatalog.model.module_idents import module_idents_words
from esicatalog.model.pdo_facts import (
    bits_words,
    declared_sm_words,
    entry_words,
    pdo_flags,
    pdos_by_direction,
    symmetric_exclusions,
)
from esicatalog.model.process_image import SmImage, assigned_sms, byte_bit, module_sms
from esicatalog.model.revisions import revision_text
from esicatalog.model.sm_facts import sm_facts, sm_flags
from esicatalog.model.sync import generated_signals
from esicatalog.model.twincat import is_superseded, predefined_assignments
from esicatalog.sii.codes import signal_names

_MOST_ALIKE = 10
"""Devices of the same layout that a sheet names."""


def device_sheet_lines(description: DeviceDescription, choice: Mapping[int, ModuleChoice]) -> Iterator[str]:
    """The sheet as lines of text. Raises :class:`InputError` for a bad choice."""
    derived = derive(description.device, description.modules)
    images = description.images(choice) if choice else derived.images
    yield from _identity(description, derived.facts)
    yield from _sync_managers(description)
    yield from _process_image(images, "Process image" if choice else "Default process image")
    yield from _assignments(description.device, derived.images)
    yield from _pdos(description.device, assigned_sms(images), "PDOs of the device")
    yield from _slots(description, choice)
    for module, label in zip(description.modules, module_labels(description.modules), strict=True):
        yield from _module(module, label)
    for owner, items in groupby(description.init_cmds(choice), lambda item: item.owner):
        yield from _init_cmds([(item.protocol, item.command) for item in items], f"InitCmds of the {owner}")
    yield from _dc_modes(description.device, description.default_position(choice))
    yield from _drive_modes(derived.modes)
    eeprom = eeprom_words(description.device)
    if eeprom:
        yield from ("", "EEPROM", *_fact_lines(eeprom))
    findings = [[item.rule, item.message, f"{item.member}, line {item.line}"] for item in description.findings]
    yield from _section("Findings in the documents", ("rule", "finding", "where"), findings)
    yield from _neighbours(description)


def _assignments(device: Device, default_images: list[SmImage]) -> Iterator[str]:
    rows = [
        [
            item.shown_name,
            "; ".join(f"SM{sm}: {' '.join(map(_hex, indices)) or 'none'}" for sm, indices in item.pdo_indices.items()),
            predefined_words(item, default_images),
        ]
        for item in predefined_assignments(device)
    ]
    yield from _section("Predefined PDO assignments", ("name", "PDOs", ""), rows)


def _drive_modes(found: DriveModes) -> Iterator[str]:
    rows = [
        [
            f"axis {item.axis}" if item.kind == CIA402 else item.kind,
            item.mode,
            item.verdict + (" (conflict)" if item.conflict else ""),
            item.evidence,
        ]
        for item in found.verdicts
    ]
    rows += [[f"axis {item.axis}", "", "unknown", item.evidence] for item in axes_alone(found)]
    yield from _section("Drive modes: what the file says, not what the drive does", ("", "mode", "", "evidence"), rows)
    recipes = [[f"axis {item.axis}", item.mode, item.recipe] for item in found.verdicts if item.recipe]
    yield from _section("How to run them", ("", "mode", "recipe"), recipes)
    for item in found.evidence:
        if item.conflict:
            yield f"  conflict: {item.evidence}"


def _neighbours(description: DeviceDescription) -> Iterator[str]:
    """Other revisions, and devices with the same layout."""
    rows = [
        [
            "*" if item.device.revision_no == description.found.revision_no else "",
            _hex(item.device.revision_no, 8) or "-",
            revision_text(item.device.vendor_id, item.device.revision_no) or "",
            "hidden" if item.hidden else "",
            item.layout_words,
            item.device.type or "",
        ]
        for item in description.revisions
    ]
    if len(rows) > 1:
        head = ("", "revision", "", "", "process image", "type")
        yield from _section("Revisions of this product (* = this one)", head, rows)
    alike = description.same_layout
    rows = [[item.identity_text, item.type or "", item.name or ""] for item in alike[:_MOST_ALIKE]]
    more = f"; {len(alike) - _MOST_ALIKE} more: devices --like" if len(alike) > _MOST_ALIKE else ""
    yield from _section(f"Same process-image layout ({len(alike)}{more})", ("identity", "type", "name"), rows)


def _section(title: str, head: tuple[str, ...], rows: list[list[str]]) -> Iterator[str]:
    if rows:
        yield ""
        yield title
        for line in table_lines(rows, head):
            yield f"  {line}"


def _identity(description: DeviceDescription, facts: DeviceFacts) -> Iterator[str]:
    found, described = description.found, description.identified
    yield f"{found.shown_type}  {found.name or ''}".rstrip()
    shown = [
        ("vendor", f"{_hex(found.vendor_id, 8)}  {found.vendor or ''}"),
        ("product", f"{_hex(found.product_code, 8)}  ({_text(found.product_code)})"),
        ("revision", _revision(found)),
        *head_facts(description.device, facts),
        *(("described in", f"{source.member}, line {source.line}") for source in described.sources),
        *((("damaged", described.damage),) if described.damage is not None else ()),
    ]
    if len(description.variants) > 1:
        rank = "the preferred description" if found.variant == 1 else "not the preferred description"
        shown.append(("variant", f"{found.variant} of {len(description.variants)}: {rank} of this identity"))
    shown += [("warning", words) for words in description.ambiguities]
    yield from _fact_lines(shown)


def _fact_lines(facts: Iterable[tuple[str, str]]) -> Iterator[str]:
    for name, value in facts:
        yield f"  {name:15}  {value}".rstrip()


def _revision(found: FoundDevice) -> str:
    if found.revision_no is None:
        return "-"
    words = (str(found.revision_no), revision_text(found.vendor_id, found.revision_no))
    hidden = "  hidden by its vendor" if found.hidden else ""
    return f"{_hex(found.revision_no, 8)}  ({', '.join(filter(None, words))}){hidden}"


def _sync_managers(description: DeviceDescription) -> Iterator[str]:
    rows = []
    for number, sm in enumerate(description.device.sync_managers):
        facts = sm_facts(sm)
        rows.append(
            [
                f"SM{number}",
                sm.usage or "",
                _hex(sm.start_address),
                _hex(sm.control_byte, 2),
                facts.buffer_mode or "",
                facts.transfer_direction or "",
                " ".join(sm_flags(sm)),
                _text(sm.min_size),
                _text(sm.default_size),
                _text(sm.max_size),
                _text(sm.enable),
            ]
        )
    head = (
        "",
        "usage",
        "start",
        "control",
        "mode",
        "direction",
        "flags",
        "min bytes",
        "default bytes",
        "max bytes",
        "enable",
    )
    yield from _section("Sync managers", head, rows)


def _process_image(images: list[SmImage], heading: str) -> Iterator[str]:
    for image in images:
        rows = [
            [
                byte_bit(placed.bit_offset),
                _text(placed.entry.bit_length),
                entry_words(placed.entry),
                placed.entry.data_type or "",
                display_text(placed.entry.names) or "",
                _hex(pdo.pdo.pdo_index)
                + (f" of {display_text(pdo.module.names)} in slot {pdo.slot_number}" if pdo.module is not None else ""),
            ]
            for pdo in image.pdos
            for placed in pdo.entries
        ]
        title = f"{heading}, {' '.join(filter(None, (f'SM{image.sm}', image.usage_words)))}: {image.size_words}"
        yield ""
        yield title
        for line in table_lines(rows, ("byte.bit", "bits", "entry", "type", "name", "PDO")) if rows else []:
            yield f"  {line}"
        for remark in image.remarks:
            yield f"  note: {remark}"


def _pdos(owner: Device | Module, sms: Mapping[tuple[str, int], int], title: str) -> Iterator[str]:
    """``sms`` are the SyncManagers of those that are assigned."""
    rows = []
    exclusions = symmetric_exclusions((*owner.rx_pdos, *owner.tx_pdos))
    for direction, pdos in pdos_by_direction(owner):
        for position, pdo in enumerate(pdos):
            sm = sms.get((direction, position))
            rows.append(
                [
                    direction,
                    _hex(pdo.pdo_index),
                    f"SM{sm}" if sm is not None else f"no{declared_sm_words(pdo, sm)}",
                    str(len(pdo.entries)),
                    bits_words(pdo),
                    ", ".join(pdo_flags(pdo)),
                    " ".join(map(_hex, exclusions.get(pdo.pdo_index, ()))),
                    display_text(pdo.names) or "",
                ]
            )
    yield from _section(title, ("", "index", "assigned", "entries", "bits", "flags", "excludes", "name"), rows)


def _slots(description: DeviceDescription, choice: Mapping[int, ModuleChoice]) -> Iterator[str]:
    plugged = description.plugged(choice)
    rows = []
    for offer in slot_offers(description.device, description.modules, plugged):
        cells = [["*" if item.is_plugged else "", str(item.choice), item.name] for item in offer.fitting]
        place = [offer.number_words, offer.name]
        rows += [[*place, *row] for row in cells or [["", "", "no described module to choose"]]]
    yield from _section("Slots and the modules that fit (* = plugged)", ("slot", "", "", "module", "name"), rows)
    if words := module_idents_words(description.device, plugged):
        yield f"  module idents, slot by slot: {words}"


def _module(module: Module, label: str) -> Iterator[str]:
    title = f"Module {_hex(module.module_ident)}  {label}  {display_text(module.names) or ''}".rstrip()
    yield ""
    yield title
    yield from _pdos(module, module_sms(module), f"  PDOs of the module, {WITHOUT_SLOT}")
    yield from _init_cmds(init_cmds(module.mailbox), f"  InitCmds of the module, {WITHOUT_SLOT}")


def _init_cmds(commands: Iterable[tuple[str, InitCmd]], title: str) -> Iterator[str]:
    rows = [
        [protocol, " ".join(cmd.transitions), init_cmd_target(cmd), cmd.data or "", cmd.comment or ""]
        for protocol, cmd in commands
    ]
    yield from _section(title, ("", "transition", "target", "data (as sent)", "comment"), rows)


def _dc_modes(device: Device, default: int | None) -> Iterator[str]:
    rows = []
    for position, mode in enumerate(device.op_modes):
        signals = generated_signals(mode, device.dc_time_loop_control_only)
        words = signal_names(signals.sync0, signals.sync1)
        if signals.time_only:
            words.append("DC time only")
        rows.append(
            [
                f"{position}{'*' if position == default else '-' if is_superseded(mode) else ''}",
                mode.name or "",
                _hex(mode.assign_activate),
                "+".join(words) or ("unknown" if signals.dc_active is None else "no DC"),
                _cycle(mode.cycle_time_sync0_ns, mode.cycle_time_sync0_factor),
                _text(mode.shift_time_sync0_ns),
                _cycle(mode.cycle_time_sync1_ns, mode.cycle_time_sync1_factor),
                _text(mode.shift_time_sync1_ns),
                mode.description or "",
            ]
        )
    head = ("at", "OpMode", "activate", "signals", "cycle 0", "shift 0 ns", "cycle 1", "shift 1 ns", "description")
    yield from _section("DC modes (* = default, - = superseded: newer tools ignore it)", head, rows)


def _cycle(nanoseconds: int | None, factor: int | None) -> str:
    if nanoseconds:
        return f"{nanoseconds} ns"
    return f"factor {factor}" if factor is not None else ""


def _hex(value: int | None, digits: int = 4) -> str:
    return "" if value is None else f"0x{value:0{digits}X}" if digits < 8 else f"0x{value:0{digits}x}"


def _text(value: Any) -> str:
    return "" if value is None else str(value)
