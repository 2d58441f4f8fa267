"""Comparison of mailboxes: protocols, their options, and the commands that a master sends at state changes."""

from collections import Counter
from collections.abc import Iterator, Sequence

from esicatalog.esi.records.mailbox import INIT_CMD_FIELDS, InitCmd, Mailbox
from esicatalog.model.compare_device import compare_diagnostics
from esicatalog.model.compare_facts import (
    INIT_CMD,
    MAILBOX,
    Difference,
    Fact,
    always,
    compare_facts,
    compare_whole,
    difference,
    either,
    lost,
    matched_in_steps,
    never,
)
from esicatalog.model.compare_words import (
    h2,
    h4,
    hex_data,
    listed,
    records,
    supported,
    text,
    value_of,
    yes_no,
)
from esicatalog.model.device_words import soe_target

_MAILBOX = (
    Fact("data_link_layer", "DataLinkLayer", lost, yes_no),
    Fact("real_time_mode", "RealTimeMode", always, yes_no),
    Fact("aoe", "AoE", lost, supported),
    Fact("aoe_ads_router", "AoE AdsRouter", lost, yes_no),
    Fact("aoe_generate_own_net_id", "AoE GenerateOwnNetId", always, yes_no),
    Fact("aoe_initialize_own_net_id", "AoE InitializeOwnNetId", always, yes_no),
    Fact("eoe", "EoE", lost, supported),
    Fact("eoe_ip", "EoE IP", lost, yes_no),
    Fact("eoe_mac", "EoE MAC", lost, yes_no),
    Fact("eoe_time_stamp", "EoE TimeStamp", lost, yes_no),
    Fact("coe", "CoE", lost, supported),
    Fact("coe_sdo_info", "CoE SdoInfo", lost, yes_no),
    Fact("coe_pdo_assign", "CoE PdoAssign", lost, yes_no),
    Fact("coe_pdo_config", "CoE PdoConfig", lost, yes_no),
    Fact("coe_pdo_upload", "CoE PdoUpload", always, yes_no),
    Fact("coe_complete_access", "CoE CompleteAccess", lost, yes_no),
    Fact("coe_segmented_sdo", "CoE SegmentedSdo", lost, yes_no),
    Fact("coe_diag_history", "CoE DiagHistory", lost, yes_no),
    Fact("coe_sdo_upload_with_max_length", "CoE SdoUploadWithMaxLength", lost, yes_no),
    Fact("coe_time_distribution", "CoE TimeDistribution", lost, yes_no),
    Fact("coe_module_od", "CoE ModuleOD", always, yes_no),
    Fact("coe_eds_file", "CoE EdsFile", never),
    Fact("coe_ds402_channels", "CoE DS402Channels", always),
    Fact("coe_objects", "CoE Object", always, records),
    Fact("foe", "FoE", lost, supported),
    Fact("soe", "SoE", lost, supported),
    Fact("soe_channel_count", "SoE ChannelCount", always),
    Fact("soe_drive_follows_bit3", "SoE DriveFollowsBit3Support", lost, yes_no),
    Fact("soe_diag_files", "SoE DiagFile", never, listed(text)),
    Fact("voe", "VoE", lost, supported),
    Fact("vendor_specific", "VendorSpecific of the mailbox", never),
)
_INIT_CMD = (
    Fact("transitions", "at", always, listed(text)),
    Fact("data", "data", always, hex_data),
    Fact("complete_access", "CompleteAccess", always, yes_no),
    Fact("depend_on_slot", "DependOnSlot", always, yes_no),
    Fact("depend_on_slot_group", "DependOnSlotGroup", always, yes_no),
    Fact("overwritten_by_module", "OverwrittenByModule", always, yes_no),
    Fact("adapt_automatically", "AdaptAutomatically", never, yes_no),
    Fact("fixed", "Fixed", never, yes_no),
    Fact("comment", "comment", never),
)
_WITHOUT = Mailbox()


def compare_mailboxes(left: Mailbox | None, right: Mailbox | None) -> Iterator[Difference]:
    """Protocols and options; what is added disturbs no configuration, what is lost may be in use."""
    if (left is None) != (right is None):
        said, also = ("described" if mailbox is not None else None for mailbox in (left, right))
        yield difference(MAILBOX, "mailbox", said, also, lost(left, right))
    ours, theirs = left or _WITHOUT, right or _WITHOUT
    yield from compare_facts(MAILBOX, "", ours, theirs, _MAILBOX)
    yield from compare_diagnostics(MAILBOX, "SoE diagnosis text", [ours.soe_diag_messages], [theirs.soe_diag_messages])


def compare_init_cmds(left: Mailbox | None, right: Mailbox | None) -> Iterator[Difference]:
    """Commands that are added, removed, changed, or sent in another order.

    What is sent unchanged is matched first, the rest by its target: so a command that is put between others is one
    difference.
    """
    for protocol, field in INIT_CMD_FIELDS.items():
        ours: Sequence[InitCmd] = getattr(left or _WITHOUT, field)
        theirs: Sequence[InitCmd] = getattr(right or _WITHOUT, field)
        if ours != theirs:
            yield from _compare_commands(protocol, ours, theirs)


def _compare_commands(protocol: str, left: Sequence[InitCmd], right: Sequence[InitCmd]) -> Iterator[Difference]:
    pairs = matched_in_steps(
        enumerate(left), enumerate(right), lambda item: _sent(item[1]), lambda item: _target(item[1])
    )
    kept = []
    for item, other in pairs:
        position, command = item or (None, None)
        other_position, other_command = other or (None, None)
        place = f"{protocol} InitCmd {_target(either(command, other_command))}".rstrip()
        yield from compare_whole(INIT_CMD, place, command, other_command, _INIT_CMD)
        if position is not None and other_position is not None:
            kept.append((position, other_position))
    yield from _compare_order(protocol, left, right, kept)


def _compare_order(
    protocol: str, left: Sequence[InitCmd], right: Sequence[InitCmd], kept: Sequence[tuple[int, int]]
) -> Iterator[Difference]:
    """The commands that both have, from the first to the last one that comes at another place."""
    ours, theirs = sorted(kept), sorted(kept, key=lambda pair: pair[1])
    apart = [at for at, pair in enumerate(zip(ours, theirs, strict=True)) if pair[0] != pair[1]]
    if apart:
        part = slice(apart[0], apart[-1] + 1)
        shown = _order_words([left[position] for position, _ in ours[part]])
        other = _order_words([right[position] for _, position in theirs[part]])
        yield difference(INIT_CMD, f"{protocol} InitCmd order", shown, other, True)


def _order_words(commands: Sequence[InitCmd]) -> str:
    """Targets of commands in their order, with the data where a target alone does not tell one from another."""
    counts = Counter(map(_target, commands))
    return ", ".join(
        _target(command) + (f" = {hex_data(value_of(command, 'data'))}" if counts[_target(command)] > 1 else "")
        for command in commands
    )


def _sent(command: InitCmd) -> tuple[str, str | None, tuple[str, ...]]:
    return _target(command), hex_data(value_of(command, "data")), command.transitions


def _target(command: InitCmd) -> str:
    """What a command is for, by the fields of its protocol."""
    idn, channel, index, subindex, eoe_type = (
        value_of(command, field) for field in ("idn", "channel", "object_index", "subindex", "eoe_type")
    )
    words = []
    if idn is not None:
        words.append(soe_target(f"IDN {idn}", channel))
    elif channel is not None:
        words.append(f"channel {channel}")
    if index is not None:
        words.append(f"{h4(index)}:{(h2(subindex or 0) or '').removeprefix('0x')}")
    elif subindex is not None:
        words.append(f"subindex {subindex}")
    if eoe_type is not None:
        words.append(f"type {eoe_type}")
    return " ".join(words)
