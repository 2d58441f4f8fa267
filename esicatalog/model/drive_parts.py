"""What is looked at together for drive modes: a device's own description or a module, for one axis.

Rules of ESI-FACTS sections 12 and 16: objects that yield to those of modules, and RxPDOs that map a mode's setpoint.
"""

from collections.abc import Collection, Container, Iterable, Mapping, Sequence
from itertools import combinations, product
from typing import NamedTuple

from esicatalog.esi.records.mailbox import InitCmd
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import RX_PDO, Pdo
from esicatalog.esi.records.profile import Profile
from esicatalog.model.axes import is_commanded_axis
from esicatalog.model.cia402 import (
    AXIS_STEP,
    MODES_OF_OPERATION,
    PROFILE_AND_CYCLIC,
    SINGLE_SETPOINTS,
    SUPPORTED_DRIVE_MODES,
    DriveMode,
)
from esicatalog.model.dictionary import ObjectEntry
from esicatalog.model.dictionary_views import DictionaryView, counting_views
from esicatalog.model.pdo_facts import has_length, has_object, pdo_yields, pdos_by_direction, symmetric_exclusions
from esicatalog.model.pdo_mapping import is_mappable
from esicatalog.model.process_image import SmImage
from esicatalog.model.slots import PluggedModule
from esicatalog.model.start_up import written_places, yields

_ARRAYS = (0x60C1,)
"""Setpoints that are elements of an object."""


class Part(NamedTuple):
    """What is looked at together: the device's own description or one module, for one axis."""

    axis_shift: int
    """How far the axis's objects lie above those of the first axis."""
    views: tuple[DictionaryView, ...]
    """Its dictionaries."""
    rx_pdos: tuple[Pdo, ...]
    assigned: tuple[Pdo, ...]
    """Those of them that are in the default process image; of a module, in the one with it plugged."""
    init_cmds: tuple[InitCmd, ...]
    profiles: tuple[Profile, ...]
    """Those that speak for this axis."""
    sync0: bool
    """Whether an OpMode that it can run in generates SYNC0."""
    plugged: PluggedModule | None = None
    """The module that it is about, None for the device itself."""
    name: str = ""
    """Names of a module: type and name."""
    slots: tuple[int, ...] = ()
    """All slots in which the module drives this axis, the one that it is in first."""
    replaced: frozenset[int] = frozenset()
    """Objects of the device in whose place those of modules count."""

    @property
    def slot_number(self) -> int | None:
        """Slot that a module is in."""
        return self.plugged.slot_number if self.plugged is not None else None

    @property
    def module_ident(self) -> int | None:
        """Ident of a module."""
        return self.plugged.module.module_ident if self.plugged is not None else None

    @property
    def axis(self) -> int:
        """The number of the axis, from 0."""
        return self.axis_shift // AXIS_STEP

    def at(self, index: int) -> int:
        """Where an object of the first axis lies in this part."""
        return index + self.axis_shift


def is_drive(part: Part) -> bool:
    """Whether the part is a CiA 402 axis that a master can command."""
    return is_commanded_axis(part.axis, part.profiles, part.rx_pdos, part.views)


def declaring_views(part: Part, index: int) -> list[DictionaryView]:
    """The dictionaries with the object, as far as it counts there; the one whose object counts first."""
    found = counting_views(part.views, index)
    return [v for v in found if not v.by_index[index].overwritten_by_module] if index in part.replaced else found


def declaring_view(part: Part, index: int) -> DictionaryView | None:
    """The dictionary with the object that counts, None without one."""
    return next(iter(declaring_views(part, index)), None)


def is_declared(part: Part, index: int) -> bool:
    """Whether an object is in the dictionary and counts."""
    return declaring_view(part, index) is not None


def declared_entries(part: Part, index: int) -> Sequence[ObjectEntry]:
    """The entries of an object, none where the dictionary has no such object that counts."""
    view = declaring_view(part, index)
    resolved = view.resolved(index) if view is not None else None
    return resolved.entries if resolved is not None else ()


def single_value(part: Part, index: int) -> ObjectEntry | None:
    """The single value of an object."""
    return next(iter(single_values(part, index)), None)


def single_values(part: Part, index: int) -> list[ObjectEntry]:
    """The same in every dictionary that has it."""
    found = [view.single(index) for view in declaring_views(part, index)]
    return [entry for entry in found if entry is not None]


def may_be_mapped(part: Part, index: int) -> bool:
    """Whether the dictionary lets an object into an RxPDO, be it a value or (0x60C1) a record of some."""
    return any(is_mappable(entry, RX_PDO) for entry in declared_entries(part, index))


def marked_objects(part: Part) -> list[int]:
    """Objects that say something about modes and are marked OverwrittenByModule."""
    indices = (SUPPORTED_DRIVE_MODES, MODES_OF_OPERATION, *PROFILE_AND_CYCLIC, *SINGLE_SETPOINTS)
    declared = [(part.at(index), view.by_index.get(part.at(index))) for index in indices for view in part.views]
    return [index for index, item in declared if item is not None and item.overwritten_by_module]


SlotsDeclaring = Mapping[int, Collection[int]]
"""The slots that declare an object whatever they hold, by its index."""


def yielding(part: Part, declaring: SlotsDeclaring, plugged: Part | None = None) -> Part:
    """A part of the device beside what its slots hold, be it with a certain module in one of them.

    Its marked objects yield to those of modules (ESI-FACTS section 12).
    """
    slot_number = plugged.slot_number if plugged is not None else None
    replaced = frozenset(
        index
        for index in marked_objects(part)
        if any(number != slot_number for number in declaring.get(index, ()))
        or (plugged is not None and _declares(plugged.views, index))
    )
    return part._replace(replaced=replaced) if replaced != part.replaced else part


def beside_modules(part: Part, modules: Sequence[Module]) -> Part:
    """A part of the device beside these modules, as they are in their slots: its marked PDOs and InitCmds yield."""
    indices = {pdo.pdo_index for module in modules for _, pdos in pdos_by_direction(module) for pdo in pdos}
    places = written_places(modules)
    rx_pdos = tuple([pdo for pdo in part.rx_pdos if not pdo_yields(pdo, indices)])
    init_cmds = tuple([command for command in part.init_cmds if not yields(command, places)])
    if len(rx_pdos) == len(part.rx_pdos) and len(init_cmds) == len(part.init_cmds):
        return part
    return part._replace(rx_pdos=rx_pdos, init_cmds=init_cmds)


def assigned_rx_pdos(images: Iterable[SmImage], slot_number: int | None) -> tuple[Pdo, ...]:
    """RxPDOs of the device itself or of what is in a slot, as far as they are in a process image."""
    return tuple(
        placed.pdo
        for image in images
        for placed in image.pdos
        if placed.direction == RX_PDO and placed.slot_number == slot_number
    )


def _declares(views: Sequence[DictionaryView], index: int) -> bool:
    return any(index in view.by_index for view in views)


def maps_setpoint(part: Part, pdo: Pdo, setpoints: Sequence[int]) -> bool:
    """Whether a PDO maps these setpoints, all of them.

    No mapping object transports a virtual PDO (ESI-FACTS sections 9 and 18).
    """
    wanted = {part.at(index) for index in setpoints}
    return bool(wanted) and not pdo.virtual and wanted.issubset([entry.entry_index for entry in pdo.entries])


def mapping_pdos(part: Part, mode: DriveMode) -> Sequence[Pdo]:
    """The RxPDOs that map the setpoint of a mode: one with all of it, else one for each object.

    Drives with one object a PDO assign several, which must not exclude each other. None where an object is not mapped.
    """
    whole = _fitting_pdos(part, mode.setpoints)
    if whole or len(mode.setpoints) < 2:
        return whole[:1]
    each = [_fitting_pdos(part, (index,)) for index in mode.setpoints]
    if not all(each):
        return ()
    rivals = {index: frozenset(others) for index, others in symmetric_exclusions(part.rx_pdos).items()}
    return next((pdos for pdos in product(*each) if _go_together(pdos, rivals)), ())


def _fitting_pdos(part: Part, setpoints: Sequence[int]) -> list[Pdo]:
    """The RxPDOs that map setpoints: those assigned by default before others, of one index the first."""
    fitting = [pdo for pdo in part.rx_pdos if maps_setpoint(part, pdo, setpoints)]
    by_index: dict[int | None, Pdo] = {}
    for pdo in sorted(fitting, key=lambda pdo: pdo not in part.assigned):
        by_index.setdefault(pdo.pdo_index, pdo)
    return list(by_index.values())


def _go_together(pdos: Iterable[Pdo], rivals: Mapping[int | None, Collection[int]]) -> bool:
    return not any(other.pdo_index in rivals.get(pdo.pdo_index, ()) for pdo, other in combinations(pdos, 2))


def mapping_pdo(index: int, pdos: Iterable[Pdo]) -> Pdo | None:
    """The first of some PDOs that maps an object."""
    return next((pdo for pdo in pdos if any(entry.entry_index == index for entry in pdo.entries)), None)


def unusable_entry(pdo: Pdo, objects: Container[int | None]) -> str | None:
    """Why nothing can be sent in the entries of a PDO for some objects, as the end of a sentence; else None."""
    for entry in pdo.entries:
        if entry.entry_index in objects and not (has_object(entry) and has_length(entry)):
            return f"without a usable {'BitLen' if has_object(entry) else 'SubIndex'}"
        if entry.entry_index in objects and not entry.bit_length:
            return "in an entry of 0 bits"
    return None


def setpoint_words(part: Part, mode: DriveMode) -> str:
    """The objects of a mode's setpoint in words."""
    return object_words(map(part.at, mode.setpoints))


def mapped_words(part: Part, index: int, pdos: Iterable[Pdo]) -> str:
    """An object as PDOs map it, with the subindex and a doubt where that is none of a single value.

    CiA 402 has setpoints and modes at subindex 0, but for those that are arrays.
    """
    subindices = [entry.subindex or 0 for pdo in pdos for entry in pdo.entries if entry.entry_index == index]
    if not subindices or 0 in subindices or index - part.axis_shift in _ARRAYS:
        return object_words([index])
    subindex = subindices[0]
    is_known = any(entry.subindex == subindex for entry in declared_entries(part, index))
    doubt = "which CiA 402 does not have" if is_known else "which neither CiA 402 nor a dictionary has"
    return f"0x{index:04X}:{subindex:02X}, {doubt}"


def mapped_setpoint_words(part: Part, mode: DriveMode, pdos: Sequence[Pdo]) -> str:
    """The objects of a mode's setpoint as PDOs map them."""
    return " and ".join(mapped_words(part, part.at(index), pdos) for index in mode.setpoints)


def object_words(indices: Iterable[int]) -> str:
    """Objects in words."""
    return " and ".join(f"0x{index:04X}" for index in indices)


def pdo_words(pdo: Pdo) -> str:
    """A PDO in words."""
    return f"RxPDO 0x{pdo.pdo_index:04X}" if pdo.pdo_index is not None else "an RxPDO"


def mapping_words(pdos: Sequence[Pdo]) -> str:
    """PDOs in words, as what maps something."""
    return " and ".join(map(pdo_words, pdos)) + (" maps" if len(pdos) == 1 else " map")
