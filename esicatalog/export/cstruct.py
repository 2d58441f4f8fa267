"""What ``ethercat cstruct`` of IgH EtherLab prints, byte for byte, for an EEPROM image or a configuration."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from esicatalog.export.c_text import comment_text
from esicatalog.export.configuration import Configuration
from esicatalog.export.igh_limits import pieces
from esicatalog.sii.image import RxPdos, SiiImage, Strings, TxPdos
from esicatalog.sii.records import Pdo
from esicatalog.words import hex32

_MAX_NAME_BYTES = 63
_LAST_SM_OF_PDO = 127
"""A greater number in an image says that the PDO is not assigned."""
_OUTPUT, _WATCHDOG = 0x04, 0x40
"""Bits of the ControlByte as the tool tests them."""


class _Entry(NamedTuple):
    entry_index: int
    subindex: int
    bit_length: int
    name: str


class _Pdo(NamedTuple):
    pdo_index: int
    name: str
    entries: tuple[_Entry, ...]


class _Sm(NamedTuple):
    control_byte: int
    pdos: tuple[_Pdo, ...]


class _Slave(NamedTuple):
    position: int
    order_number: str
    identity: tuple[int, int, int]
    sync_managers: tuple[_Sm, ...]


def cstruct_of_image(image: SiiImage, position: int = 0) -> str:
    """The C structures of a slave whose PDOs are known by its EEPROM image only; empty without SyncManagers.

    Names are the bytes of the image: write the text with ``errors="surrogateescape"``.
    """
    header = image.header
    order = image.general.order_string_number if image.general is not None else 0
    # PDOs are attached in the order in which the image stores them, whatever their direction.
    stored = [pdo for category in image.categories if isinstance(category, RxPdos | TxPdos) for pdo in category.pdos]
    sync_managers = tuple(
        _Sm(
            sm.control_byte,
            tuple(_pdo_of_image(image, pdo) for pdo in stored if pdo.sm == number and pdo.sm <= _LAST_SM_OF_PDO),
        )
        for number, sm in enumerate(image.sync_managers)
    )
    identity = (header.vendor_id, header.product_code, header.revision_no)
    return _text(_Slave(position, _string(image, order), identity, sync_managers))


def cstruct_of_configuration(configuration: Configuration) -> str:
    """The C structures of a configured device, names as they are written; empty without SyncManagers."""
    subject = configuration.subject
    configured = {sm.number: sm.pdos for sm in configuration.sync_managers}
    # Those that are described, virtual ones too, and no others that PDOs name: so has them the EEPROM image.
    sync_managers = tuple(
        _Sm(
            described.control_byte or 0,
            tuple(
                _Pdo(
                    pdo.pdo_index,
                    _cut(pdo.written_name),
                    tuple(
                        _Entry(entry.entry_index, entry.subindex, length, _cut(entry.written_name))
                        for entry in pdo.entries
                        for length in pieces(entry.bit_length)
                    ),
                )
                for pdo in configured.get(number, ())
            ),
        )
        for number, described in enumerate(subject.device.sync_managers)
    )
    order_number, identity = _cut(subject.device.type or ""), subject.required_codes()
    return _text(_Slave(configuration.choice.position, order_number, identity, sync_managers))


def _pdo_of_image(image: SiiImage, pdo: Pdo) -> _Pdo:
    entries = tuple(
        _Entry(entry.entry_index, entry.subindex, entry.bit_length, _string(image, entry.name_string_number))
        for entry in pdo.entries
    )
    return _Pdo(pdo.pdo_index, _string(image, pdo.name_string_number), entries)


def _string(image: SiiImage, number: int) -> str:
    """A string as the tool sees it: bytes up to the first zero, at most 63."""
    tables = image.of_type(Strings)
    if not tables or not 0 < number <= len(tables[0].strings):
        return ""
    data = tables[0].strings[number - 1].data
    return data.partition(b"\0")[0][:_MAX_NAME_BYTES].decode("utf-8", "surrogateescape")


def _cut(name: str) -> str:
    return name.encode()[:_MAX_NAME_BYTES].decode("utf-8", "ignore")


def _text(slave: _Slave) -> str:
    if not slave.sync_managers:
        return ""
    return "".join(f"{line}\n" for line in _lines(slave))


def _lines(slave: _Slave) -> Iterator[str]:
    prefix = f"slave_{slave.position}"
    order = f', "{comment_text(slave.order_number)}"' if slave.order_number else ""
    vendor_id, product_code, revision_no = slave.identity
    yield f"/* Master 0, Slave {slave.position}{order}"
    yield f" * Vendor ID:       {hex32(vendor_id)}"
    yield f" * Product code:    {hex32(product_code)}"
    yield f" * Revision number: {hex32(revision_no)}"
    yield " */"
    yield ""
    pdos = [pdo for sm in slave.sync_managers for pdo in sm.pdos]
    entries = [entry for pdo in pdos for entry in pdo.entries]
    if entries:
        yield f"ec_pdo_entry_info_t {prefix}_pdo_entries[] = {{"
        for entry in entries:
            place = f"0x{entry.entry_index:04x}, 0x{entry.subindex:02x}"
            yield f"    {{{place}, {entry.bit_length}}},{_comment(entry.name)}"
        yield "};"
        yield ""
    if pdos:
        yield f"ec_pdo_info_t {prefix}_pdos[] = {{"
        for pdo, place in zip(pdos, _places(f"{prefix}_pdo_entries", [pdo.entries for pdo in pdos]), strict=True):
            yield f"    {{0x{pdo.pdo_index:04x}, {len(pdo.entries)}, {place}}},{_comment(pdo.name)}"
        yield "};"
        yield ""
    yield f"ec_sync_info_t {prefix}_syncs[] = {{"
    places = _places(f"{prefix}_pdos", [sm.pdos for sm in slave.sync_managers])
    for number, (sm, place) in enumerate(zip(slave.sync_managers, places, strict=True)):
        direction = "EC_DIR_OUTPUT" if sm.control_byte & _OUTPUT else "EC_DIR_INPUT"
        watchdog = "EC_WD_ENABLE" if sm.control_byte & _WATCHDOG else "EC_WD_DISABLE"
        yield f"    {{{number}, {direction}, {len(sm.pdos)}, {place}, {watchdog}}},"
    yield "    {0xff}"
    yield "};"
    yield ""


def _places(array: str, groups: Iterable[Sequence[object]]) -> Iterator[str]:
    """Where each group begins in the array of all, NULL for an empty one."""
    offset = 0
    for group in groups:
        yield f"{array} + {offset}" if group else "NULL"
        offset += len(group)


def _comment(name: str) -> str:
    return f" /* {comment_text(name)} */" if name else ""
