"""Values of a description that cannot be read, and that what is generated therefore lacks."""

from collections.abc import Iterator, Mapping, Sequence

from esicatalog.esi.binding import Record
from esicatalog.esi.records.dc import OpMode, OpModePdo, OpModeSm
from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.esi.records.mailbox import InitCmd, Mailbox
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Exclude, Pdo
from esicatalog.esi.records.slots import ModulePdoGroup, Slot, SlotModuleIdent
from esicatalog.esi.unreadable import unreadable_values
from esicatalog.model.process_image import SmImage
from esicatalog.model.slots import PluggedModule
from esicatalog.words import index_words

_USED = (SyncManager, Pdo, Exclude, Mailbox, InitCmd, OpModeSm, OpModePdo, Slot, SlotModuleIdent, ModulePdoGroup)
"""Parts of devices and modules that count for what is generated, whatever is chosen."""
_FIELDS: Mapping[type[Record], frozenset[str]] = {
    Device: frozenset(
        (
            "module_pdo_group",
            "dc_time_loop_control_only",
            "download_module_ident_list",
            "download_module_address_list",
            "slot_pdo_increment",
            "slot_group_pdo_increment",
            "slot_index_increment",
            "slot_group_index_increment",
            "esc_reg0108",
            "esc_reg0400",
            "esc_reg0410",
            "esc_reg0420",
        )
    ),
    Module: frozenset(("module_ident", "module_pdo_group")),
    Mailbox: frozenset(("coe_pdo_assign", "coe_pdo_config", "coe_complete_access")),
    InitCmd: frozenset(("depend_on_slot", "depend_on_slot_group", "adapt_automatically", "overwritten_by_module")),
}
"""What counts of those parts that describe more than is generated.

Of a command that is left out because its place or its data cannot be read, the remark that says so names them.
"""


def unread_remarks(
    device: Device, plugged: Sequence[PluggedModule], op_mode: OpMode | None, images: Sequence[SmImage]
) -> Iterator[str]:
    """The unreadable values of what is chosen: device, plugged modules, OpMode, entries of the assigned PDOs."""
    owners: list[tuple[str, Device | Module]] = [("", device)]
    owners += [(f"module in slot {item.slot_number}: ", item.module) for item in plugged]
    for words, owner in owners:
        for place, problem in unreadable_values(
            owner, lambda part: isinstance(part, _USED) or part is op_mode, _counts
        ):
            yield unread_remark(words + place, problem)
    for pdo in (placed.pdo for image in images for placed in image.pdos):
        for number, entry in enumerate(pdo.entries, start=1):
            for place, problem in unreadable_values(entry, lambda part: False):
                yield unread_remark(f"PDO {index_words(pdo.pdo_index)}, entry {number}: {place}", problem)


def unread_remark(place: str, problem: str) -> str:
    """A value that cannot be read, in words."""
    return f"{place}: {problem}; it cannot be read and counts as absent: correct the file"


def _counts(record: Record, name: str) -> bool:
    fields = _FIELDS.get(type(record))
    return fields is None or name in fields
