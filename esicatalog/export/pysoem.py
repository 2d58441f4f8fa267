"""Python module for pysoem: configuration functions and the process image as ctypes structures."""

import keyword
from collections.abc import Iterable
from typing import NamedTuple

from esicatalog.export.c_access import byte_count
from esicatalog.export.c_text import comment_lines, comment_text
from esicatalog.export.clocks import Condition, Notation
from esicatalog.export.configuration import Configuration
from esicatalog.export.esc_registers import register_remarks
from esicatalog.export.headings import heading_lines, op_mode_words
from esicatalog.export.init_cmds import StartCommand, by_transition
from esicatalog.export.io_map import IoMap, Member, io_map
from esicatalog.export.names import unique_names
from esicatalog.export.rendering import render
from esicatalog.export.sm_configuration import MappedEntry
from esicatalog.export.soem_startup import (
    HOOK_REGISTERS,
    RegisterWrite,
    command_remarks,
    hook_commands,
    later_commands,
    soem_clocks,
    start_mode_remarks,
)
from esicatalog.model.sm_facts import INPUT, OUTPUT
from esicatalog.words import counted

_USED_BY_CLASS = frozenset(("property", "from_address", "from_buffer", "from_buffer_copy", "from_param", "in_dll"))
"""What the body of the generated class uses, and what is called on the class: ctypes keeps that in its metaclass, where
an attribute of the class itself hides it."""
_PYTHON = Notation("cycle_ns", either="or", divide="//")


class Field(NamedTuple):
    """A field of the structure."""

    name: str
    type: str
    comment: str


class BitProperty(NamedTuple):
    """A property for a value that is no field."""

    name: str
    comment: str
    reading: str
    writing: str
    """The integer that the bits of ``value`` make."""
    bit_offset: int
    bit_length: int


class ImageClass(NamedTuple):
    """The structure of one direction."""

    direction: str
    name: str
    byte_size: int
    fields: tuple[Field, ...]
    properties: tuple[BitProperty, ...]


class CommandStatement(NamedTuple):
    """A command as a Python statement; None where pysoem has no call for it."""

    words: str
    statement: str | None


class DcCode(NamedTuple):
    """Statements that set the clocks."""

    words: str
    conditions: tuple[Condition, ...]
    """Of the bus cycle."""
    call: str | None
    written: str | None


def pysoem_module(configuration: Configuration) -> str:
    """The module for one device."""
    maps = [io_map(configuration, direction) for direction in (OUTPUT, INPUT)]
    remarks = [*configuration.remarks, *start_mode_remarks(configuration, "send_so"), *configuration.copy_remarks]
    remarks += [remark for layout in maps for remark in (*layout.remarks, *_sharing(layout))]
    remarks += register_remarks(configuration.subject.device, "pysoem", HOOK_REGISTERS)
    remarks += command_remarks(configuration, "pysoem")
    remarks += [
        f"{command.transition} {command.place} is left out: pysoem has no call for SoE"
        for command in configuration.commands
        if command.protocol == "SoE"
    ]
    heading = heading_lines(configuration, "pysoem configuration", remarks)
    images = [_image_class(layout) for layout in maps]
    return render(
        "pysoem.py.j2",
        configuration=configuration,
        heading=comment_lines(heading),
        images=images,
        setup=[_sent(command) for command in hook_commands(configuration)],
        later=by_transition(later_commands(configuration), _sent),
        dc=_dc(configuration),
        needs_bits=any(image.properties for image in images),
        needs_sign=any("_signed(" in item.reading for image in images for item in image.properties),
        needs_struct=any("struct." in item.reading for image in images for item in image.properties),
    )


def _sharing(layout: IoMap) -> Iterable[str]:
    if layout.bit_size and layout.starts_inside_byte:
        bits = counted(layout.bit_size, "bit")
        yield (
            f"the {layout.direction}s take {bits}: where SOEM packs several such devices into one byte, pysoem reads "
            "and writes that byte as a whole, and they may begin at another bit"
        )


def _image_class(layout: IoMap) -> ImageClass:
    names = _python_names([*(member.name for member in layout.members), *(entry.identifier for entry in layout.others)])
    count = len(layout.members)
    return ImageClass(
        layout.direction,
        f"{layout.direction.capitalize()}s",
        layout.byte_size,
        tuple(_field(name, member) for name, member in zip(names[:count], layout.members, strict=True)),
        tuple(_property(name, entry) for name, entry in zip(names[count:], layout.others, strict=True)),
    )


def _python_names(names: list[str]) -> list[str]:
    safe = [f"{name}_" if keyword.iskeyword(name) or name in _USED_BY_CLASS else name for name in names]
    return unique_names([(name,) for name in safe])


def _field(name: str, member: Member) -> Field:
    entry = member.entry
    if entry is None:
        return Field(name, f"ctypes.c_uint8 * {member.byte_count}", member.words)
    if entry.value.kind == "bytes":
        kind = f"c_uint8 * {member.byte_count}"
    elif entry.value.kind == "real":
        kind = "c_float" if entry.value.bit_length == 32 else "c_double"
    else:
        kind = f"c_{entry.value.kind}{entry.value.container_bits}"
    return Field(name, f"ctypes.{kind}", comment_text(member.words))


def _property(name: str, entry: MappedEntry) -> BitProperty:
    reading, writing = f"_read_bits(self, {entry.bit_offset}, {entry.bit_length})", "value"
    if entry.value.kind == "real":
        code = '"<f"' if entry.value.bit_length == 32 else '"<d"'
        reading = f'struct.unpack({code}, {reading}.to_bytes({byte_count(entry)}, "little"))[0]'
        writing = f'int.from_bytes(struct.pack({code}, value), "little")'
    elif entry.value.kind == "bytes":
        reading = f'{reading}.to_bytes({byte_count(entry)}, "little")'
        writing = 'int.from_bytes(value, "little")'
    elif entry.value.kind == "int":
        reading = f"_signed({reading}, {entry.bit_length})"
    return BitProperty(name, comment_text(entry.words), reading, writing, entry.bit_offset, entry.bit_length)


def _sent(command: StartCommand | RegisterWrite) -> CommandStatement:
    return CommandStatement(comment_text(command.words), _statement(command))


def _statement(command: StartCommand | RegisterWrite) -> str | None:
    data = f'bytes.fromhex("{command.data.hex()}")'
    if isinstance(command, RegisterWrite):
        return f"slave._fpwr(0x{command.register:04X}, {data})"
    if command.protocol == "SoE":
        return None
    access = ", ca=True" if command.complete_access else ""
    return f"slave.sdo_write(0x{command.object_index:04X}, {command.subindex}, {data}{access})"


def _dc(configuration: Configuration) -> DcCode | None:
    found = configuration.clocks
    if found is None:
        return None
    calls = soem_clocks(found)
    arguments = [f"True, {found.sync0_cycle.expression(_PYTHON)}", f"sync0_shift_time={found.sync0_shift_ns}"]
    if calls.has_sync01_call:
        arguments.append(f"sync1_cycle_time={found.sync1_delay.expression(_PYTHON)}")
    has_call = calls.has_sync0_call or calls.has_sync01_call
    return DcCode(
        comment_text(op_mode_words(configuration)),
        tuple(found.conditions(_PYTHON, configuration.cycle_ns)),
        f"slave.dc_sync({', '.join(arguments)})" if has_call else None,
        _statement(calls.written) if calls.written is not None else None,
    )
