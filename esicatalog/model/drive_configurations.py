"""Which parts of a drive act together: its own ones, and with them each of the modules that its slots take."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.mailbox import coe_init_cmds
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.slots import Slot
from esicatalog.model.axes import further_axes
from esicatalog.model.cia402 import AXIS_STEP, PROFILE_AREA
from esicatalog.model.dictionary_views import DictionaryViews
from esicatalog.model.drive_evidence import module_names
from esicatalog.model.drive_parts import Part, SlotsDeclaring, assigned_rx_pdos, beside_modules, yielding
from esicatalog.model.process_image import SmImage, plugged_process_image
from esicatalog.model.slots import (
    PluggedModule,
    SlotDependence,
    SlotShift,
    declared_indices,
    default_modules,
    expand_module,
    fitting_modules,
    furthest_move,
    numbered_slots,
    required_instances,
    slot_dependences,
)
from esicatalog.model.sync import asked_op_modes, positions_with_sync0


def device_parts(device: Device, known: DictionaryViews, images: Sequence[SmImage]) -> list[Part]:
    """Parts of the device itself, one for each axis; ``images`` is its default process image."""
    views = known.of(device.profiles)
    assigned = assigned_rx_pdos(images, None)
    sync0 = bool(positions_with_sync0(device))
    return [
        Part(
            axis_shift=axis * AXIS_STEP,
            views=views,
            rx_pdos=device.rx_pdos,
            assigned=assigned,
            init_cmds=coe_init_cmds(device.mailbox),
            profiles=device.profiles if axis == 0 else (),
            sync0=sync0,
        )
        for axis in (0, *further_axes(views, device.rx_pdos))
    ]


def module_parts(device: Device, modules: Sequence[Module], known: DictionaryViews) -> dict[int, list[Part]]:
    """Parts of the modules by the axis that their objects belong to in the slot.

    That is not the number of the slot: I/O may come before the drive, and objects that do not depend on the slot are
    those of the same axis in each. Of several slots in which a module drives an axis the first one counts.
    """
    parts: dict[int, dict[int, Part]] = defaultdict(dict)
    axes = {id(module): _declared_axes(module, known) for module in modules}
    for plugged in _plugged(device, modules):
        for first, dependences in axes[id(plugged.module)]:
            shift = first + furthest_move(device, plugged, dependences)
            of_axis, key = parts[shift // AXIS_STEP], id(plugged.module)
            part = of_axis.get(key) or _module_part(device, plugged, first, shift, known)
            of_axis[key] = part._replace(slots=(*part.slots, plugged.slot_number))
    return {axis: list(of_axis.values()) for axis, of_axis in parts.items()}


def _declared_axes(module: Module, known: DictionaryViews) -> list[tuple[int, list[SlotDependence]]]:
    """Where axes of a module begin outside of any slot, and how their objects follow it."""
    begins = [axis * AXIS_STEP for axis in (0, *further_axes(known.of(module.profiles), module.rx_pdos))]
    return [
        (begin, slot_dependences(module, range(PROFILE_AREA + begin, PROFILE_AREA + begin + AXIS_STEP)))
        for begin in begins
    ]


def _plugged(device: Device, modules: Sequence[Module]) -> Iterator[PluggedModule]:
    """Every module in every slot that it fits, those that are there by default first."""
    yield from default_modules(device, modules)
    for number, slot, fitting in fitting_modules(device, modules):
        for module in fitting:
            yield PluggedModule(number, slot, module)


def _module_part(device: Device, plugged: PluggedModule, first: int, shift: int, known: DictionaryViews) -> Part:
    module = expand_module(device, plugged).module
    asked = [position for position in asked_op_modes(device.op_modes, [module]).values() if position is not None]
    with_sync0 = positions_with_sync0(device)
    return Part(
        axis_shift=shift,
        views=known.of(module.profiles),
        rx_pdos=module.rx_pdos,
        assigned=assigned_rx_pdos(plugged_process_image(device, [plugged]), plugged.slot_number),
        init_cmds=coe_init_cmds(module.mailbox),
        profiles=module.profiles if first == 0 else (),
        sync0=any(position in with_sync0 for position in asked) if asked else bool(with_sync0),
        plugged=plugged,
        name=module_names(module),
    )


def slots_declaring(device: Device, modules: Sequence[Module], indices: Iterable[int]) -> SlotsDeclaring:
    """For each object the slots that declare it whatever they hold."""
    declared = {id(module): declared_indices(module) for module in modules}
    found: dict[int, set[int]] = {index: set() for index in indices}
    for number, slot, held in _held(device, modules):
        shift = SlotShift(device, slot, number)
        for index, numbers in found.items():
            sources = shift.sources(index)
            if not any(sources.isdisjoint(declared[id(module)]) for module in held):
                numbers.add(number)
    return found


def _held(device: Device, modules: Sequence[Module]) -> Iterator[tuple[int, Slot, list[Module]]]:
    """What is in slots that are not left empty: the default module, else any that fits."""
    defaults = {item.slot_number: [item.module] for item in default_modules(device, modules)}
    needed = _needed(device)
    for number, slot, fitting in fitting_modules(device, modules):
        held = defaults.get(number, fitting if number in needed else [])
        if held:
            yield number, slot, held


def _needed(device: Device) -> set[int]:
    """The slots that are never empty."""
    return {number for number, slot, instance in numbered_slots(device) if instance < required_instances(slot)}


def never_alone(device: Device, modules: Sequence[Module], speaking: Iterable[Part]) -> set[int]:
    """Axes on which the device's own part never acts alone: a slot that is never empty takes only modules that speak.

    ``speaking`` are the parts of modules that say something of their axis. Beside another module, or one that nobody
    describes, the device's own part is all there is.
    """
    speakers: dict[tuple[int, int], set[int]] = defaultdict(set)
    for part in speaking:
        if part.plugged is not None:
            for number in part.slots:
                speakers[part.axis, number].add(id(part.plugged.module))
    needed = _needed(device)
    required = {
        number: set(map(id, fitting))
        for number, slot, fitting in fitting_modules(device, modules)
        if number in needed and {item.module_ident for item in slot.module_idents} <= {m.module_ident for m in fitting}
    }
    return {axis for (axis, number), heard in speakers.items() if number in required and heard >= required[number]}


def configurations(
    device: Device,
    own: Sequence[Part],
    plugged: Mapping[int, Sequence[Part]],
    declaring: SlotsDeclaring,
    there: Iterable[PluggedModule],
) -> dict[int, list[list[Part]]]:
    """Per axis the sets of parts that act together: the device's own, and with it each alternative module.

    ``there`` are the default modules. What is marked OverwrittenByModule yields to them and to the alternative.
    """
    is_marked = any(
        any(pdo.overwritten_by_module for pdo in part.rx_pdos)
        or any(command.overwritten_by_module for command in part.init_cmds)
        for part in own
    )
    held = {item.slot_number: expand_module(device, item).module for item in there} if is_marked else {}

    def beside(part: Part, *modules: PluggedModule) -> Part:
        if not is_marked:
            return part
        in_slots = held | {item.slot_number: expand_module(device, item).module for item in modules}
        return beside_modules(part, list(in_slots.values()))

    found = {}
    for axis in {part.axis for part in own} | plugged.keys():
        # Beside a module of an axis that the device itself does not describe there are its RxPDOs and InitCmds, too.
        of_axis = [part for part in own if part.axis == axis] or [_on_axis(own[0], axis)]
        found[axis] = [[beside(part) for part in of_axis]]
        for module in plugged.get(axis, ()):
            alternative = [module.plugged] if module.plugged is not None else []
            yielded = [beside(yielding(part, declaring, module), *alternative) for part in of_axis]
            found[axis].append([*yielded, module])
    return found


def _on_axis(part: Part, axis: int) -> Part:
    """A part of the device as that of another axis, for which its profiles do not speak."""
    return part._replace(axis_shift=axis * AXIS_STEP, profiles=())
