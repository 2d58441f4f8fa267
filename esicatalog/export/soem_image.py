"""The process image of one direction as a packed C structure, with accessors for what is no member of it."""

from typing import NamedTuple

from esicatalog.export.c_access import Function, Place, c_type, read_value, reader, write_value, writer
from esicatalog.export.c_text import comment_text
from esicatalog.export.configuration import Configuration
from esicatalog.export.io_map import IoMap, Member, io_map
from esicatalog.export.sm_configuration import MappedEntry
from esicatalog.model.sm_facts import OUTPUT


class MemberCode(NamedTuple):
    """A member of the structure."""

    declaration: str
    name: str
    byte_offset: int
    comment: str


class ImageCode(NamedTuple):
    """The structure of one direction."""

    direction: str
    type_name: str
    byte_size: int
    bit_size: int | None
    """All bits that the device exchanges in this direction; None where that is not known."""
    starts_inside_byte: bool
    """Whether SOEM may let the image begin at any bit."""
    members: tuple[MemberCode, ...]
    accessors: tuple[Function, ...]
    remarks: tuple[str, ...]

    @property
    def needs_bits(self) -> bool:
        """Whether an accessor needs the helpers for values that do not fill bytes."""
        return bool(self.accessors)


def image_code(configuration: Configuration, direction: str) -> ImageCode:
    """The structure of one direction; without members when nothing is exchanged."""
    layout = io_map(configuration, direction)
    type_name = f"{configuration.prefix}_{direction}s_t"
    return ImageCode(
        direction,
        type_name,
        layout.byte_size,
        layout.bit_size if layout.is_described else None,
        layout.starts_inside_byte,
        tuple(map(_member, layout.members)),
        tuple(_accessor(configuration.prefix, type_name, layout, entry) for entry in layout.others),
        layout.remarks,
    )


def _member(member: Member) -> MemberCode:
    entry = member.entry
    if entry is None or entry.value.kind == "bytes":
        declaration = f"uint8_t {member.name}[{member.byte_count}];"
    else:
        declaration = f"{c_type(entry)} {member.name};"
    return MemberCode(declaration, member.name, member.byte_offset, comment_text(member.words))


def _accessor(prefix: str, type_name: str, layout: IoMap, entry: MappedEntry) -> Function:
    is_output = layout.direction == OUTPUT
    const = "" if is_output else "const "
    image, cast = f"{const}{type_name} *image", f"({const}uint8_t *) image"
    bit = str(entry.bit_offset)
    if layout.starts_inside_byte:
        image, cast, bit = f"{const}uint8_t *image, uint8_t start_bit", "image", f"start_bit + {bit}"
    place = Place(cast, bit)
    if is_output:
        return writer(entry, f"{prefix}_set_{entry.identifier}", image, write_value(entry, place))
    return reader(entry, f"{prefix}_get_{entry.identifier}", image, read_value(entry, place))
