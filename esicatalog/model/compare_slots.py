"""Comparison of slots and of the modules that fit them; modules are compared as devices are."""

from collections.abc import Iterator, Sequence

import msgspec

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.slots import Slot, SlotModuleClass, SlotModuleIdent
from esicatalog.model.compare_device import compare_profiles
from esicatalog.model.compare_facts import (
    SLOTS,
    Difference,
    Fact,
    Rule,
    always,
    compare_by_position,
    compare_facts,
    difference,
    either,
    lost,
    lost_items,
    matched,
    never,
)
from esicatalog.model.compare_mailbox import compare_init_cmds, compare_mailboxes
from esicatalog.model.compare_objects import compare_objects
from esicatalog.model.compare_pdos import compare_pdos
from esicatalog.model.compare_words import (
    Show,
    h4,
    h8,
    listed,
    records,
    shown_text,
    supported,
    text,
    value_of,
    yes_no,
)

_SLOTS = (
    Fact("has_slots", "Slots", lost, supported),
    Fact("max_slot_count", "MaxSlotCount", always),
    Fact("max_slot_group_count", "MaxSlotGroupCount", always),
    Fact("slot_pdo_increment", "SlotPdoIncrement", always),
    Fact("slot_group_pdo_increment", "SlotGroupPdoIncrement", always),
    Fact("slot_index_increment", "SlotIndexIncrement", always, h4),
    Fact("slot_group_index_increment", "SlotGroupIndexIncrement", always, h4),
    Fact("download_module_ident_list", "DownloadModuleIdentList", always, yes_no),
    Fact("download_module_address_list", "DownloadModuleAddressList", always, yes_no),
    Fact("download_module_list_transition", "DownloadModuleListTransition", always),
    Fact("identify_module_by", "IdentifyModuleBy", always),
    Fact("module_pdo_groups", "module PDO groups", always, records),
    Fact("slot_group_data", "slot groups", never, records),
    Fact("slot_selections", "named module selections", never, records),
)


def _ident(module: Module) -> str | None:
    return h8(value_of(module, "module_ident"))


_idents = listed(lambda item: h8(item.module_ident))


def _default_idents(slot: Slot) -> tuple[SlotModuleIdent, ...]:
    return tuple(item for item in slot.module_idents if item.is_default)


def _class(item: SlotModuleClass) -> str | None:
    vendor = f" of vendor {h8(item.class_vendor_id)}" if item.class_vendor_id is not None else ""
    return f"{item.module_class}{vendor}"


_classes = listed(_class)


def _lost(show: Show) -> Rule:
    """What fits a slot counts when something of it is missing."""
    return lambda left, right: lost_items([show((item,)) for item in left], [show((item,)) for item in right])


_SLOT = (
    Fact("names", "name", never, shown_text),
    Fact("min_instances", "MinInstances", always),
    Fact("max_instances", "MaxInstances", always),
    Fact("slot_group", "SlotGroup", always),
    Fact("slot_pdo_increment", "SlotPdoIncrement", always),
    Fact("slot_group_pdo_increment", "SlotGroupPdoIncrement", always),
    Fact("slot_index_increment", "SlotIndexIncrement", always, h4),
    Fact("slot_group_index_increment", "SlotGroupIndexIncrement", always, h4),
    Fact("module_idents", "modules", _lost(_idents), _idents),
    Fact(_default_idents, "default module", always, _idents),
    Fact("default_ident", "Default", always, h8),
    Fact("fallback_ident", "Fallback", always, h8),
    Fact("module_classes", "module classes", _lost(_classes), _classes),
    Fact("tree_view", "TreeView", never),
)
_MODULE = (
    Fact("type", "type", never),
    Fact("names", "name", never, shown_text),
    Fact("module_class", "ModuleClass", always),
    Fact("module_pdo_group", "ModulePdoGroup", always),
    Fact("sra_parameter_supported", "SRA_ParameterSupported", always, yes_no),
    Fact("dc_op_mode_name", "DcOpModeName", always),
    Fact("vendor_specific", "VendorSpecific", never),
    Fact("unmapped", "unknown elements", never, records),
)


def compare_slots(
    left: Device, left_modules: Sequence[Module], right: Device, right_modules: Sequence[Module]
) -> Iterator[Difference]:
    """Slots by position, because it is their number; modules by ModuleIdent and occurrence.

    A slot or module that only the right one has does not count.
    """
    yield from compare_facts(SLOTS, "", left, right, _SLOTS)
    yield from compare_by_position(SLOTS, "slot ", left.slots, right.slots, _SLOT, lost)
    for module, other in matched(left_modules, right_modules, _ident):
        if module != other:
            yield from _compare_module(module, other)


def _compare_module(left: Module | None, right: Module | None) -> Iterator[Difference]:
    name = f"module {_ident(either(left, right)) or 'without ident'}"
    if left is None or right is None:
        said, also = (_module_words(item) for item in (left, right))
        yield difference(SLOTS, name, said, also, lost(left, right))
        return
    inside = (
        compare_facts(SLOTS, "", left, right, _MODULE),
        compare_pdos(left, right),
        compare_mailboxes(left.mailbox, right.mailbox),
        compare_init_cmds(left.mailbox, right.mailbox),
        compare_profiles(left.profiles, right.profiles),
        compare_objects(left.profiles, right.profiles),
    )
    for part in inside:
        for item in part:
            yield msgspec.structs.replace(item, module=name)


def _module_words(module: Module | None) -> str | None:
    if module is None:
        return None
    return ", ".join(dict.fromkeys(filter(None, (text(module.type), shown_text(module.names))))) or "without name"
