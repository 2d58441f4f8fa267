"""Values of a description that cannot be read, and that what is generated therefore lacks."""

from collections.abc import Iterator, Sequence

from esicatalog.esi.records.dc import OpMode, OpModePdo, OpModeSm
from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.esi.records.mailbox import InitCmd, Mailbox
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Exclude, Pdo
from esicatalog.esi.records.slots import ModulePdoGroup, Slot, SlotModuleIdent
from esicatalog.esi.unreadable import unreadable_values
from esicatalog.model.pdo_facts import index_words
from esicatalog.model.process_image import SmImage
from esicatalog.model.slots import PluggedModule

_USED = (SyncManager, Pdo, Exclude, Mailbox, InitCmd, OpModeSm, OpModePdo, Slot, SlotModuleIdent, ModulePdoGroup)
"""Parts of devices and modules that count for what is generated, whatever is chosen."""


def unread_remarks(
    device: Device, plugged: Sequence[PluggedModule], op_mode: OpMode | None, images: Sequence[SmImage]
) -> Iterator[str]:
    """The unreadable values of what is chosen: device, plugged modules, OpMode, entries of the assigned PDOs."""
    owners: list[tuple[str, Device | Module]] = [("", device)]
    owners += [(f"module in slot {item.slot_number}: ", item.module) for item in plugged]
    for words, owner in owners:
        for place, problem in unreadable_values(owner, lambda part: isinstance(part, _USED) or part is op_mode):
            yield _remark(words + place, problem)
    for pdo in (placed.pdo for image in images for placed in image.pdos):
        for number, entry in enumerate(pdo.entries, start=1):
            for place, problem in unreadable_values(entry, lambda part: False):
                yield _remark(f"PDO {index_words(pdo.pdo_index)}, entry {number}: {place}", problem)


def _remark(place: str, problem: str) -> str:
    return f"{place}: {problem}; what stands here is made without it: correct the file"
