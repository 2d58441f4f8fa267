"""Rules about drives: CiA 402 objects, modes of operation, profile numbers (ESI-FACTS section 16)."""

from collections.abc import Iterator

from esicatalog.identity import UINT32_MAX
from esicatalog.lint.registry import WARNING, Found, Place, rule
from esicatalog.lint.subjects import DeviceSubject, ModuleSubject, Owner, joined_dictionaries
from esicatalog.model.cia402 import (
    AXIS_STEP,
    CONTROLWORD,
    MAX_AXES,
    MODES_OF_OPERATION,
    MODES_OF_OPERATION_OF_AXES,
    STATUSWORD,
    SUPPORTED_DRIVE_MODES,
)
from esicatalog.model.drive_evidence import ModeEvidence, supported_modes, written_mode
from esicatalog.model.profile_facts import profile_numbers

_DEVICE_TYPE = 0x1000
_NEEDED = (CONTROLWORD, STATUSWORD, MODES_OF_OPERATION, SUPPORTED_DRIVE_MODES)
_DOUBTS = {
    "A+ swapped": "looks byte-swapped: DefaultData is little-endian, DefaultValue the number itself",
    "A+ short": "is shorter than its type",
}
_AGAINST_NAME = "C3"


@rule("L57", WARNING, "CiA 402 object 0x6060: the command would start another mode than the name promises")
def mode_against_name(subject: ModuleSubject) -> Iterator[Found]:
    """An InitCmd writes a mode to 0x6060 that the name of its module does not list."""
    against = {
        (item.mode, item.axis): item
        for host in subject.hosts
        for item in reversed(host.derivation.evidence_of_modules.get(subject.module.module_ident, ()))
        if item.rank == _AGAINST_NAME
    }
    for _, item in sorted(against.items()):
        number = _writing(subject, item)
        place: Place = ("mailbox", "coe_init_cmds", number) if number is not None else ()
        yield Found(f"{item.evidence}: correct the command or the name", place)


def _writing(subject: ModuleSubject, item: ModeEvidence) -> int | None:
    """Position of the InitCmd that writes the mode, None where that is one of the device.

    In a slot above 0 the evidence rests on another index than the one that stands in the module.
    """
    written = {
        number: index
        for number, command in enumerate(subject.coe_init_cmds)
        if (index := command.object_index or 0) in MODES_OF_OPERATION_OF_AXES
        and (mode := written_mode(command, index)) is not None
        and mode.name == item.mode
    }
    return min(written, key=lambda number: written[number] != item.object_index, default=None)


@rule("L58", WARNING, "CiA 402: 0x6040, 0x6041, 0x6060 and 0x6502 are mandatory")
def drive_objects(subject: DeviceSubject | ModuleSubject) -> Iterator[Found]:
    """A CiA 402 drive lacks a mandatory object, or the default of 0x6502 is 0 or looks wrong."""
    if isinstance(subject, DeviceSubject):
        if subject.derivation.modes.evidence:
            yield from _missing_objects(subject)
            yield from _doubtful_modes(subject)
    elif any(subject.module.module_ident in host.derivation.evidence_of_modules for host in subject.hosts):
        yield from _doubtful_modes(subject)


def _missing_objects(subject: DeviceSubject) -> Iterator[Found]:
    dictionaries = joined_dictionaries((subject, *subject.modules))
    all_described = dictionaries.is_complete and all(module.own for module in subject.modules)
    missing = [f"0x{index:04X}" for index in _NEEDED if dictionaries.entries(index) is None]
    if missing and dictionaries and all_described:
        yield Found(f"CiA 402 drive without {', '.join(missing)} in its dictionary", _dictionary_place(subject))


def _doubtful_modes(subject: Owner) -> Iterator[Found]:
    """The objects 0x6502 of a device or module, of every axis that has its controlword literally.

    What is marked OverwrittenByModule is a stand-in for that of a module.
    """
    for view in subject.own.views:
        for shift in range(0, MAX_AXES * AXIS_STEP, AXIS_STEP):
            index = SUPPORTED_DRIVE_MODES + shift
            declared = view.by_index.get(index)
            if declared is None or declared.overwritten_by_module:
                continue
            entry = view.single(index)
            if entry is None or (shift and subject.own.entries(CONTROLWORD + shift) is None):
                continue
            modes = supported_modes(entry)
            if entry.default_int == 0:
                problem = "0: it says nothing about the modes; give the modes of the drive"
            elif modes is not None and modes.rank in _DOUBTS:
                problem = f"{entry.default_raw}, which {_DOUBTS[modes.rank]}"
            else:
                continue
            yield Found(f"0x{index:04X} has the default {problem}", subject.object_place(index))


def _dictionary_place(subject: DeviceSubject) -> Place:
    numbers = [n for n, profile in enumerate(subject.device.profiles) if profile.dictionary is not None]
    return ("profiles", numbers[0], "dictionary") if numbers else ()


@rule("L59", WARNING, "ETG.1000.6 object 0x1000: the low word is the profile number")
def device_type(subject: DeviceSubject) -> Iterator[Found]:
    """The profile in 0x1000 is none of the ProfileNo."""
    default = subject.own.default(_DEVICE_TYPE) or 0
    if default <= 0:
        return
    numbers = {number.profile_no for number in profile_numbers(subject.device.profiles)}
    declared = sorted(number for number in numbers if number)
    if declared and default & 0xFFFF not in declared:
        yield Found(
            f"0x1000 has the default 0x{default:08X}, profile {default & 0xFFFF}; "
            f"ProfileNo is {', '.join(map(str, declared))}: correct one of them",
            subject.object_place(_DEVICE_TYPE),
        )


@rule("L67", WARNING, "CiA 406 object 0x6502: number of distinguishable revolutions")
def modes_of_no_drive(subject: DeviceSubject) -> Iterator[Found]:
    """0x6502 of a device that is no CiA 402 drive; it says nothing about drive modes."""
    default = subject.own.default(SUPPORTED_DRIVE_MODES)
    if default and not subject.derivation.modes.evidence and subject.own.is_complete:
        yield Found(
            f"0x6502 has the default 0x{default & UINT32_MAX:X}, but nothing else says CiA 402: "
            "do not read it as supported drive modes",
            subject.object_place(SUPPORTED_DRIVE_MODES),
        )
