"""Rules about slots and modules (ESI-FACTS section 12)."""

from collections import defaultdict
from collections.abc import Iterator

from esicatalog.esi.records.dictionary import Object
from esicatalog.esi.records.mailbox import InitCmd
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry
from esicatalog.esi.records.profile import declared_objects
from esicatalog.esi.records.slots import Slot
from esicatalog.esi.unreadable import unreadable_values
from esicatalog.lint.registry import ERROR, WARNING, Found, Place, listed, rule
from esicatalog.lint.subjects import DeviceSubject, InfoSubject, ModuleSubject
from esicatalog.model.device_words import init_cmd_target
from esicatalog.model.pdo_facts import entry_words, pdos_by_direction
from esicatalog.model.slots import accepts, default_modules, expand_module, leaving_indices, preset_ident, slot_runs
from esicatalog.words import index_words

_PRESETS = ("is_default", "default_ident", "fallback_ident")


@rule("L53", ERROR, "ETG.2000 Slot/ModuleIdent, @Default, @MinInstances, @MaxInstances")
def slot_modules(subject: DeviceSubject) -> Iterator[Found]:
    """A slot names an unknown module (W where a document that may have it is missing or broken), presets several, or
    needs more than it takes (presets none: W).
    """
    unknown, severity = "no module of the document has", ERROR
    if subject.missing:
        unknown = f"no module at hand has, but {listed(subject.missing)}"
        severity = WARNING
    idents = {module.module_ident for module in subject.module_records}
    for number, (slot, instances) in enumerate(slot_runs(subject.device)):
        place: Place = ("slots", number)
        words = f"slot {instances.start}"
        for position, item in enumerate(slot.module_idents):
            if item.module_ident is not None and item.module_ident not in idents:
                yield Found(
                    f"{words} names ModuleIdent 0x{item.module_ident:X}, which {unknown}",
                    (*place, "module_idents", position),
                    severity,
                )
        for name, ident in (("Default", slot.default_ident), ("Fallback", slot.fallback_ident)):
            if ident is None or (subject.missing and ident not in idents):
                continue
            if not any(module.module_ident == ident and accepts(slot, module) for module in subject.module_records):
                yield Found(f"{words} has {name} 0x{ident:X}, which is no module that fits it", place, WARNING)
        preset = [item.module_ident for item in slot.module_idents if item.is_default]
        if preset and slot.default_ident is not None and slot.default_ident not in preset:
            preset.append(slot.default_ident)
        if len(preset) > 1:
            yield Found(f"{words} presets {len(preset)} modules: only one can be plugged", place)
        elif slot.min_instances and len(slot.module_idents) > 1 and not (preset or _may_preset(slot)):
            yield Found(
                f"{words} needs a module (MinInstances {slot.min_instances}) and presets none: "
                "mark one ModuleIdent with Default=1",
                place,
                WARNING,
            )
        lowest, highest = slot.min_instances, slot.max_instances
        if lowest is not None and highest is not None and lowest > highest:
            yield Found(f"{words} has MinInstances {lowest} above MaxInstances {highest}", place)


def _may_preset(slot: Slot) -> bool:
    """Whether a slot presets a module, or says so in a way that cannot be read."""
    said = unreadable_values(slot, lambda record: True, lambda record, name: name in _PRESETS)
    return preset_ident(slot) is not None or any(said)


@rule("L54", ERROR, "ETG.2000 Module Type/@ModuleIdent: what slots and 0xF030 refer to")
def module_ident_twice(section: InfoSubject) -> Iterator[Found]:
    """Two modules of a document have the same ModuleIdent; of those with a ModuleClass, where a slot names it."""
    named = {
        item.module_ident for device in section.info.devices for slot in device.slots for item in slot.module_idents
    }
    places: dict[int, list[int]] = defaultdict(list)
    for number, module in enumerate(section.info.modules):
        ident = module.module_ident
        if ident is not None and (module.module_class is None or ident in named):
            places[ident].append(number)
    for ident, numbers in places.items():
        for number in numbers[1:]:
            first, other = section.info.modules[numbers[0]], section.info.modules[number]
            yield Found(
                f"module {other.type!r} has the ModuleIdent 0x{ident:X} of {first.type!r}: give it one of its own",
                ("modules", number, "module_ident"),
            )


@rule("L55", WARNING, "ETG.2000 DependOnSlot: index + slot number x increment")
def shifted_indices(subject: DeviceSubject | ModuleSubject) -> Iterator[Found]:
    """An index that moves with the slot leaves 16 bits, or meets that of another slot or of the device; an entry or
    InitCmd of a module does not move as the object does.
    """
    if isinstance(subject, ModuleSubject):
        yield from _moving_otherwise(subject)
    elif subject.device.slots:
        yield from _overflows(subject)
        yield from _collisions(subject)


def _moving_otherwise(subject: ModuleSubject) -> Iterator[Found]:
    """What names an object of the module by an index that is another one in slots above 0."""
    moves = {declared.object_index: _moves(declared) for declared in declared_objects(subject.module.profiles)}

    def differs(item: Entry | InitCmd, index: int | None) -> bool:
        return index in moves and moves[index] != _moves(item)

    words = "which does not move with the slot as the object does: give it the DependOnSlot of the object"
    for placed in subject.pdos:
        found = [(n, entry) for n, entry in enumerate(placed.pdo.entries) if differs(entry, entry.entry_index)]
        if found:
            entries = listed([entry_words(entry) for _, entry in found])
            yield Found(
                f"{placed.direction} {index_words(placed.pdo.pdo_index)} maps {entries}, {words}",
                (*placed.place, "entries", found[0][0]),
            )
    for number, command in enumerate(subject.coe_init_cmds):
        if differs(command, command.object_index):
            yield Found(
                f"InitCmd for {init_cmd_target(command)}, {words}",
                ("mailbox", "coe_init_cmds", number),
            )


def _moves(item: Object | Entry | InitCmd) -> tuple[bool, bool]:
    """What an index follows."""
    return bool(item.depend_on_slot), bool(item.depend_on_slot_group)


def _overflows(subject: DeviceSubject) -> Iterator[Found]:
    for plugged, problems in leaving_indices(subject.device, subject.module_records):
        more = f" and {len(problems) - 1} more" if len(problems) > 1 else ""
        place = _place(subject, plugged.slot_number)
        yield Found(f"module {plugged.module.type!r}: {problems[0]}{more}", place)


def _place(subject: DeviceSubject, slot_number: int) -> Place:
    """Where the Slot element of a slot stands; equal ones are one record."""
    runs = enumerate(slot_runs(subject.device))
    return ("slots", next(position for position, (_, numbers) in runs if slot_number in numbers))


def _collisions(subject: DeviceSubject) -> Iterator[Found]:
    """Indices of default modules that the device or a default module before has; one finding for each two of them.

    Of the device's objects only those count that an object moves to: real modules repeat others (0x1018, 0xF050).
    """
    own = [placed for placed in subject.pdos if not placed.pdo.overwritten_by_module]
    taken = {(placed.direction, placed.pdo.pdo_index): "the device" for placed in own}
    of_device = {
        ("object", declared.object_index)
        for view in subject.own.views
        for declared in view.dictionary.objects
        if not declared.overwritten_by_module
    }
    for plugged in default_modules(subject.device, subject.module_records):
        here = f"slot {plugged.slot_number}"
        meeting: dict[str, list[str]] = defaultdict(list)
        expanded = _indices(expand_module(subject.device, plugged).module)
        for (what, index), unmoved in zip(expanded, _indices(plugged.module), strict=True):
            if index is None:
                continue
            other = taken.setdefault((what, index), here)
            if (what, index) in of_device and (what, index) != unmoved:
                other = "the device"
            if other != here:
                meeting[other].append(f"{what} 0x{index:04X}")
        for other, indices in meeting.items():
            words = "meets that" if len(indices) == 1 else "meet those"
            yield Found(
                f"{listed(indices)} of the default module in {here} {words} of {other}: "
                "give DependOnSlot and an increment, or describe it once",
                _place(subject, plugged.slot_number),
            )


def _indices(module: Module) -> Iterator[tuple[str, int | None]]:
    """The indices of PDOs and objects, each with what it is of."""
    yield from ((direction, pdo.pdo_index) for direction, pdos in pdos_by_direction(module) for pdo in pdos)
    yield from (("object", declared.object_index) for declared in declared_objects(module.profiles))
