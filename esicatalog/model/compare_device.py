"""Comparison of what a Device element says itself: identity, checks, times, ESC, SyncManagers, FMMUs, EEPROM."""

from collections.abc import Iterable, Iterator
from typing import Any

from esicatalog.esi.records.device import Device, HideType, SyncManager
from esicatalog.esi.records.diagnostics import CauseRemedy, Diagnostics, joined_diagnostics
from esicatalog.esi.records.dictionary import EnumInfo
from esicatalog.esi.records.profile import ChannelInfo, Profile
from esicatalog.model.compare_facts import (
    EEPROM,
    FMMU,
    GENERAL,
    IDENTITY,
    SYNC_MANAGER,
    Difference,
    Fact,
    Rule,
    always,
    compare_by_position,
    compare_facts,
    compare_whole,
    contradicted,
    difference,
    either,
    lost,
    lowered,
    matched,
    never,
    raised,
)
from esicatalog.model.compare_words import (
    byte_count,
    h2,
    h4,
    h8,
    hex_data,
    listed,
    ms,
    records,
    shown_text,
    text,
    unit,
    unread_words,
    value_of,
    yes_no,
)
from esicatalog.model.revisions import accepts_revision, is_known
from esicatalog.model.sm_facts import sm_facts
from esicatalog.words import counted


def _hidden(item: HideType) -> str | None:
    product = f"product {h8(item.product_code)}" if item.product_code is not None else None
    return " ".join(filter(None, (product, h8(item.revision_no), item.product_revision, item.text))) or None


_CODES = (
    Fact("product_code", "product code", always, h8),
    Fact("serial_no", "serial number", always, h8),
)
_GENERAL = (
    Fact("type", "type", never),
    Fact("names", "name", never, shown_text),
    Fact("comments", "comment", never, shown_text),
    Fact("urls", "link", never, shown_text),
    Fact("group_type", "group", never),
    Fact("invisible", "Invisible", always, yes_no),
    Fact("physics", "Physics", contradicted),
    Fact("check_product_code", "CheckProductCode", never),
    Fact("check_revision_no", "CheckRevisionNo", never),
    Fact("check_serial_no", "CheckSerialNo", never),
    Fact("use_lrd_lwr", "UseLrdLwr", always, yes_no),
    Fact("tc_sm_class", "TcSmClass", never),
    Fact("tc_cfg_mode_safe_op", "TcCfgModeSafeOp", never, yes_no),
    Fact("module_pdo_group", "ModulePdoGroup of its own PDOs", always),
    Fact("download_module_list", "DownloadModuleList", always, yes_no),
    Fact("show_hideable_sub_devices", "ShowHideableSubDevices", never, yes_no),
    Fact("hide_types", "hidden revisions", never, listed(_hidden)),
    Fact("alternative_types", "alternative types", never, records),
    Fact("sub_devices", "sub-devices", always, records),
    Fact("sci", "saved configuration (Sci)", never),
    Fact("e_bus_current_ma", "E-bus current", never, unit("mA")),
    Fact("ether_cat_p", "EtherCAT P rails", never, records),
    Fact("preop_timeout_ms", "PreopTimeout", always, ms),
    Fact("safeop_op_timeout_ms", "SafeopOpTimeout", always, ms),
    Fact("back_to_init_timeout_ms", "BackToInitTimeout", always, ms),
    Fact("back_to_safeop_timeout_ms", "BackToSafeopTimeout", always, ms),
    Fact("start_to_init", "StartToInit", always, yes_no),
    Fact("start_to_preop", "StartToPreop", always, yes_no),
    Fact("start_to_safeop", "StartToSafeop", always, yes_no),
    Fact("start_to_safeop_no_sync", "StartToSafeopNoSync", always, yes_no),
    Fact("mailbox_request_timeout_ms", "mailbox RequestTimeout", always, ms),
    Fact("mailbox_response_timeout_ms", "mailbox ResponseTimeout", always, ms),
    Fact("dpram_size", "DpramSize", always, byte_count),
    Fact("sm_count", "SmCount", always),
    Fact("fmmu_count", "FmmuCount", always),
    Fact("ports", "ports", always, records),
    Fact("execution_units", "execution units", always, records),
    Fact("station_alias_supported", "StationAliasSupported", always),
    Fact("identification_ado", "IdentificationAdo", always, h4),
    Fact("identification_reg134", "IdentificationReg134", always, yes_no),
    Fact("device_features", "device features", never, records),
    Fact("data_rates", "data rates", always),
    Fact("esc_reg0108", "ESC register 0x0108", always, h4),
    Fact("esc_reg0400", "ESC register 0x0400", always, h4),
    Fact("esc_reg0410", "ESC register 0x0410", always, h4),
    Fact("esc_reg0420", "ESC register 0x0420", always, h4),
    Fact("esc_mi45_access", "ESC Mi45Access", always),
    Fact("info_vendor_specific", "VendorSpecific of Info", never),
    Fact("esc_vendor_specific", "VendorSpecific of ESC", never),
    Fact("vendor_specific", "VendorSpecific of the device", never),
    Fact("unmapped", "unknown elements", never, records),
)
_SYNC_UNIT = (
    Fact("name", "name", never),
    Fact("separate_su", "SeparateSu", always, yes_no),
    Fact("separate_frame", "SeparateFrame", always, yes_no),
    Fact("depend_on_input_state", "DependOnInputState", always, yes_no),
    Fact("frame_repeat_support", "FrameRepeatSupport", lost, yes_no),
)
_FMMU = (
    Fact("usage", "usage", always),
    Fact("sm", "SyncManager", always),
    Fact("su", "sync unit", always),
    Fact("op_only", "OpOnly", always, yes_no),
)
_EEPROM = (
    Fact("assign_to_pdi", "AssignToPdi", always, yes_no),
    Fact("boot_strap", "bootstrap mailbox", contradicted, hex_data),
    Fact("byte_size", "size", never, byte_count),
    Fact("config_data", "ConfigData", never, hex_data),
    Fact("config_data2", "ConfigData2", never, hex_data),
    Fact("data", "image", never, hex_data),
    Fact("categories", "categories", never, records),
    Fact("vendor_specific", "VendorSpecific", never),
)


def _control_byte(value: int | str | None) -> str | None:
    if not isinstance(value, int):
        return value
    facts = sm_facts(SyncManager(control_byte=value))
    flags = {
        "PDI interrupt": facts.pdi_interrupt,
        "ECAT interrupt": facts.ecat_interrupt,
        "watchdog": facts.watchdog_trigger,
    }
    words = [facts.buffer_mode, facts.transfer_direction, *(name for name, on in flags.items() if on)]
    return f"{h2(value)} ({', '.join(word or 'reserved' for word in words)})"


def _number_words(item: Profile | ChannelInfo) -> str:
    """ProfileNo, AddInfo and SubAddInfo, e.g. ``5001/742``."""
    return "/".join(str(part) for part in (item.profile_no, item.add_info, item.sub_add_info) if part is not None)


def _profile_number(item: Profile) -> str:
    unread = unread_words(item, ("profile_no", "add_info", "sub_add_info"))
    return " ".join(filter(None, (_number_words(item), unread)))


def _channel(item: ChannelInfo) -> str:
    group = f" in group {item.channel_group}" if item.channel_group is not None else ""
    return _number_words(item) + group + (" (replaced by a module's)" if item.overwritten_by_module else "")


_SYNC_MANAGER = (
    Fact("usage", "usage", always),
    Fact("start_address", "start address", always, h4),
    Fact("control_byte", "control byte", always, _control_byte),
    Fact("min_size", "min size", raised, byte_count),
    Fact("default_size", "default size", contradicted, byte_count),
    Fact("max_size", "max size", lowered, byte_count),
    Fact("enable", "enable", always),
    Fact("virtual", "Virtual", always, yes_no),
    Fact("op_only", "OpOnly", always, yes_no),
    Fact("one_byte_mode", "OneByteMode", always, yes_no),
    Fact("watchdog", "Watchdog", always, yes_no),
    Fact("fixed_assignment", "FixedAssignment", always, yes_no),
)

_PROFILE = (
    Fact(_profile_number, "number", always),
    Fact("channel", "channel", always),
    Fact("channel_count", "channel count", always),
    Fact("channel_infos", "channels", always, listed(_channel)),
    Fact("dictionary_file", "dictionary file", never),
    Fact("diag_files", "diagnosis files", never, listed(text)),
    Fact("vendor_specific", "VendorSpecific", never),
)


def _cause_remedy(item: CauseRemedy) -> str:
    return ": ".join(filter(None, (item.idx, shown_text(item.causes), shown_text(item.remedies))))


def _named_value(item: EnumInfo) -> str:
    return " ".join(filter(None, (text(item.value), shown_text(item.texts))))


_MESSAGE = (
    Fact("diag_class", "class", never),
    Fact("message_texts", "text", never, shown_text),
    Fact("descriptions", "description", never, shown_text),
    Fact("diag_reset", "reset", never),
    Fact("diag_reaction", "reaction", never),
    Fact("diag_type", "type", never),
    Fact("cause_remedies", "causes and remedies", never, listed(_cause_remedy)),
    Fact("infos", "information", never, shown_text),
    Fact("hints", "hint", never, shown_text),
    Fact("urls", "link", never, shown_text),
)
_DIAGNOSTICS = (
    Fact("diag_resets", "resets", never, listed(_named_value)),
    Fact("diag_reactions", "reactions", never, listed(_named_value)),
    Fact("diag_types", "types", never, listed(_named_value)),
)
"""What the numbers in the messages mean."""


def compare_identity(
    left: Device, right: Device, left_vendor_id: int | None, right_vendor_id: int | None
) -> Iterator[Difference]:
    """Vendor, product, revision, serial number.

    The revision counts unless the left CheckRevisionNo accepts the right one: see :func:`revision_verdict`.
    """
    if left_vendor_id != right_vendor_id:
        yield difference(IDENTITY, "vendor", h8(left_vendor_id), h8(right_vendor_id), True)
    yield from compare_facts(IDENTITY, "", left, right, _CODES)
    yield from compare_facts(IDENTITY, "", left, right, (Fact("revision_no", "revision", _refused(left), h8),))


def _refused(left: Device) -> Rule:
    """A revision counts unless the left CheckRevisionNo accepts it."""

    def counts(ours: Any, theirs: Any) -> bool:
        are_numbers = isinstance(ours, int) and isinstance(theirs, int)
        return not (are_numbers and accepts_revision(left.check_revision_no, theirs, ours))

    return counts


def revision_verdict(left: Device, right: Device) -> str | None:
    """Whether a master configured for the left revision takes the right one (CheckRevisionNo), in words.

    None when the revisions are the same or one of them is unknown.
    """
    ours, theirs = left.revision_no, right.revision_no
    if ours is None or theirs is None or ours == theirs:
        return None
    if left.check_revision_no is None:
        return f"whether a master configured for {h8(ours)} takes {h8(theirs)} is its own choice: no CheckRevisionNo"
    if not is_known(left.check_revision_no):
        return (
            f"whether a master configured for {h8(ours)} takes {h8(theirs)} is not known: "
            f"nor is its CheckRevisionNo {left.check_revision_no!r}"
        )
    verb = "takes" if accepts_revision(left.check_revision_no, theirs, ours) else "refuses"
    return f"a master configured for {h8(ours)} {verb} {h8(theirs)}: CheckRevisionNo {left.check_revision_no}"


def compare_general(left: Device, right: Device) -> Iterator[Difference]:
    """Texts, start-up checks, times, ports, ESC registers, profiles, sync units, diagnosis texts."""
    yield from compare_facts(GENERAL, "", left, right, _GENERAL)
    yield from compare_profiles(left.profiles, right.profiles)
    yield from compare_by_position(GENERAL, "sync unit ", left.sync_units, right.sync_units, _SYNC_UNIT, lost)


def compare_sync_managers(left: Device, right: Device) -> Iterator[Difference]:
    """SyncManagers by number."""
    yield from compare_by_position(SYNC_MANAGER, "SM", left.sync_managers, right.sync_managers, _SYNC_MANAGER)


def compare_fmmus(left: Device, right: Device) -> Iterator[Difference]:
    """FMMUs by number; one more does not count."""
    yield from compare_by_position(FMMU, "FMMU", left.fmmus, right.fmmus, _FMMU, lost)


def compare_eeprom(left: Device, right: Device) -> Iterator[Difference]:
    """What the EEPROM image needs beyond the description; a master uses the bootstrap mailbox of it."""
    yield from compare_whole(EEPROM, "Eeprom", left.eeprom, right.eeprom, _EEPROM, never)


def compare_profiles(left: tuple[Profile, ...], right: tuple[Profile, ...]) -> Iterator[Difference]:
    """Profile numbers, channels, diagnosis texts; the dictionaries are compared as objects."""
    yield from compare_by_position(GENERAL, "profile ", left, right, _PROFILE)
    yield from compare_diagnostics(
        GENERAL,
        "diagnosis text",
        [profile.diag_messages for profile in left],
        [profile.diag_messages for profile in right],
    )


def compare_diagnostics(
    area: str, name: str, left: Iterable[Diagnostics | None], right: Iterable[Diagnostics | None]
) -> Iterator[Difference]:
    """Diagnosis texts by text id; one difference when a side has none at all. They never count."""
    ours, theirs = (joined_diagnostics(side) or Diagnostics() for side in (left, right))
    messages, others = ours.diag_messages, theirs.diag_messages
    if not messages or not others:
        count, other_count = (counted(len(known), "text") if known else None for known in (messages, others))
        if count != other_count:
            yield difference(area, f"{name}s", count, other_count, False)
    else:
        for message, other in matched(messages, others, lambda item: value_of(item, "text_id")):
            place = f"{name} {h4(value_of(either(message, other), 'text_id'))}"
            yield from compare_whole(area, place, message, other, _MESSAGE, never)
    yield from compare_facts(area, f"{name}s", ours, theirs, _DIAGNOSTICS)
