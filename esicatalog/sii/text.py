"""An SII image as a sheet of text."""

from collections.abc import Iterator, Sequence

from esicatalog.sii.checksum import header_checksum, is_loaded
from esicatalog.sii.codes import category_title, flag_words, signal_names
from esicatalog.sii.encode import category_offsets
from esicatalog.sii.image import General, RawCategory, SiiImage, Strings
from esicatalog.sii.records import DcMode, Header, Pdo
from esicatalog.words import counted, hex32

_HEX_BYTES_A_LINE = 16
_MOST_HEX_BYTES = 256
_NOT_ASSIGNED = 0xFF


def sheet_lines(image: SiiImage) -> Iterator[str]:
    """The sheet line by line: header, mailboxes, categories by kind, unknown ones in hex, findings at the end."""
    yield from _header(image)
    yield from _mailboxes(image.header)
    yield from _strings(image)
    if image.general is not None:
        yield from _general(image, image.general)
    yield from _fmmus(image)
    yield from _sync_managers(image)
    yield from _pdos(image, image.rx_pdos, "RxPDO")
    yield from _pdos(image, image.tx_pdos, "TxPDO")
    yield from _dc_modes(image)
    yield from _others(image)
    if image.findings:
        yield from _titled("Findings", image.findings)


def _titled(title: str, lines: Sequence[str]) -> Iterator[str]:
    yield ""
    yield title
    for line in lines:
        yield f"  {line}"


def _table(title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    if rows:
        widths = [max(map(len, column)) for column in zip(head, *rows, strict=True)]
        cells = (zip(row, widths, strict=True) for row in (head, *rows))
        yield from _titled(title, ["  ".join(cell.ljust(width) for cell, width in row).rstrip() for row in cells])


def _facts(facts: Sequence[tuple[str, str]]) -> list[str]:
    width = max(len(name) for name, _ in facts)
    return [f"{name:{width}}  {value}".rstrip() for name, value in facts]


def _header(image: SiiImage) -> Iterator[str]:
    header = image.header
    needed = header_checksum(header)
    if header.checksum == needed:
        verdict = "right"
    else:
        verdict = "not tested" if is_loaded(header) else f"wrong, 0x{needed:02X} needed"
    name = image.text(image.general.name_string_number) if image.general is not None else None
    yield _shown(name or "SII image")
    numbers = (
        ("vendor", header.vendor_id),
        ("product", header.product_code),
        ("revision", header.revision_no),
        ("serial", header.serial_no),
    )
    facts = [
        *((name, f"{hex32(number)}  ({number})") for name, number in numbers),
        ("alias", str(header.station_alias)),
        ("PDI control", f"0x{header.pdi_control:04X}  {_listed([header.pdi_type or 'unknown type'])}"),
        ("ESC configuration", _listed(flag_words(header.esc_configuration))),
        ("PDI configuration", f"0x{header.pdi_configuration:04X}, extended 0x{header.pdi_configuration_2:04X}"),
        ("SYNC pulse", f"{header.sync_impulse_length_ns} ns"),
        ("check sum", f"0x{header.checksum:02X}, {verdict}"),
        ("size", counted(header.byte_size, "byte")),
        ("version", str(header.version)),
    ]
    delays = (header.execution_delay, header.port0_delay, header.port1_delay)
    if any(delays):
        facts.append(("delays", "execution {}, port 0 {}, port 1 {}".format(*delays)))
    reserved = (("5", header.reserved_5), ("6", header.reserved_6), ("0x13", header.reserved_13))
    facts += [(f"word {word}", f"0x{value:04X}") for word, value in reserved if value]
    for line in _facts(facts):
        yield f"  {line}"
    if any(header.private):
        yield from _titled("Words 0x1D to 0x3D", _hex_lines(header.private))


def _mailboxes(header: Header) -> Iterator[str]:
    rows = [
        [name, *(f"0x{offset:04X}, {counted(size, 'byte')}" if size else "none" for offset, size in areas)]
        for name, areas in (
            (
                "bootstrap",
                (
                    (header.bootstrap_receive_mailbox_offset, header.bootstrap_receive_mailbox_size),
                    (header.bootstrap_send_mailbox_offset, header.bootstrap_send_mailbox_size),
                ),
            ),
            (
                "standard",
                (
                    (header.standard_receive_mailbox_offset, header.standard_receive_mailbox_size),
                    (header.standard_send_mailbox_offset, header.standard_send_mailbox_size),
                ),
            ),
        )
    ]
    protocols = _listed(flag_words(header.mailbox_protocols))
    yield from _table(f"Mailbox: {protocols}", ("", "receive (master to slave)", "send (slave to master)"), rows)


def _strings(image: SiiImage) -> Iterator[str]:
    for table in image.of_type(Strings):
        lines = [
            f"{number:3}  {_shown(string.text)}" + (f"  ({string.encoding})" if string.encoding != "ascii" else "")
            for number, string in enumerate(table.strings, start=1)
        ]
        yield from _titled("Strings", lines)


def _general(image: SiiImage, general: General) -> Iterator[str]:
    ports = ", ".join(port or "unknown" for port in general.port_types)
    facts = [
        ("group", _named(image, general.group_string_number)),
        ("group name", _named(image, general.group_name_string_number)),
        ("order", _named(image, general.order_string_number)),
        ("name", _named(image, general.name_string_number)),
        ("image", _named(image, general.image_string_number)),
        ("CoE", _listed(flag_words(general.coe_details))),
        ("FoE", _listed(flag_words(general.foe_details))),
        ("EoE", _listed(flag_words(general.eoe_details))),
        ("SoE channels", str(general.soe_channels)),
        ("DS402 channels", str(general.ds402_channels)),
        ("flags", _listed(flag_words(general.flags))),
        ("E-bus", f"{general.e_bus_current_ma} mA" + (" (feeds)" if general.e_bus_current_ma < 0 else "")),
        ("ports", ports),
        ("identification", f"0x{general.identification_address:04X}" if general.identification_address else "none"),
    ]
    if general.sysman_class:
        facts.append(("SysmanClass", f"0x{general.sysman_class:02X}"))
    if general.legacy_ports:
        facts.append(("legacy ports", f"0x{general.legacy_ports:02X}"))
    yield from _titled("General", _facts([(name, value) for name, value in facts if value]))


def _fmmus(image: SiiImage) -> Iterator[str]:
    rows = [
        [f"FMMU{number}", fmmu.usage or f"0x{fmmu.usage_code:02X}, unknown"] for number, fmmu in enumerate(image.fmmus)
    ]
    yield from _table("FMMUs", ("", "usage"), rows)


def _sync_managers(image: SiiImage) -> Iterator[str]:
    rows = [
        [
            f"SM{number}",
            sm.usage or f"0x{sm.usage_code:02X}, unknown",
            f"0x{sm.start_address:04X}",
            str(sm.length_bytes),
            f"0x{sm.control_byte:02X}",
            sm.buffer_mode or "unknown",
            sm.direction or "unknown",
            _listed(flag_words(sm.control)),
            f"0x{int(sm.enable):02X}: {_listed(flag_words(sm.enable))}",
        ]
        for number, sm in enumerate(image.sync_managers)
    ]
    head = ("", "usage", "start", "bytes", "control", "mode", "direction", "triggers", "enable")
    yield from _table("Sync managers", head, rows)


def _pdos(image: SiiImage, pdos: Sequence[Pdo], kind: str) -> Iterator[str]:
    for pdo in pdos:
        place = f"SM{pdo.sm}" if pdo.sm != _NOT_ASSIGNED else "not assigned"
        sync = f", DC sync {pdo.dc_sync}" if pdo.dc_sync else ""
        yield ""
        yield (
            f"{kind} 0x{pdo.pdo_index:04X} {_named(image, pdo.name_string_number)}: "
            f"{place}{sync}, {counted(pdo.bit_length, 'bit')}, flags {_listed(flag_words(pdo.flags))}"
        )
        position = 0
        for entry in pdo.entries:
            name = _named(image, entry.name_string_number) if entry.entry_index else "(gap)"
            data_type = entry.data_type or f"0x{entry.data_type_code:02X}"
            flags = f"  flags 0x{entry.flags:04X}" if entry.flags else ""
            yield (
                f"  {position // 8:4}.{position % 8}  0x{entry.entry_index:04X}:{entry.subindex:02X}  "
                f"{counted(entry.bit_length, 'bit'):8}  {data_type:8}  {name}{flags}".rstrip()
            )
            position += entry.bit_length


def _dc_modes(image: SiiImage) -> Iterator[str]:
    rows = [
        [
            _named(image, mode.name_string_number),
            f"0x{mode.assign_activate:04X}",
            _signals(mode),
            f"{mode.cycle_time_sync0_ns} ns",
            str(mode.cycle_time_sync0_factor),
            f"{mode.shift_time_sync0_ns} ns",
            str(mode.cycle_time_sync1_factor),
            f"{mode.shift_time_sync1_ns} ns",
            _named(image, mode.description_string_number),
        ]
        for mode in image.dc_modes
    ]
    head = ("OpMode", "activate", "signals", "cycle 0", "factor 0", "shift 0", "factor 1", "shift 1", "description")
    yield from _table("Distributed clocks", head, rows)


def _signals(mode: DcMode) -> str:
    return ", ".join(signal_names(mode.sync0, mode.sync1)) or ("no pulses" if mode.dc_active else "off")


def _others(image: SiiImage) -> Iterator[str]:
    for category, offset in zip(image.categories, category_offsets(image), strict=False):
        if isinstance(category, RawCategory):
            title = f"{category_title(category.category_type)} at byte 0x{offset:X}"
            yield from _titled(f"Other: {title}, {counted(len(category.data), 'byte')}", _hex_lines(category.data))
    if image.trailing.strip(b"\x00\xff"):
        yield from _titled(f"After the end mark: {counted(len(image.trailing), 'byte')}", _hex_lines(image.trailing))


def _hex_lines(data: bytes) -> list[str]:
    lines = []
    for start in range(0, min(len(data), _MOST_HEX_BYTES), _HEX_BYTES_A_LINE):
        piece = data[start : start + _HEX_BYTES_A_LINE]
        letters = "".join(chr(byte) if 0x20 <= byte < 0x7F else "." for byte in piece)
        lines.append(f"{start:04X}  {piece.hex(' '):{3 * _HEX_BYTES_A_LINE - 1}}  {letters}")
    if len(data) > _MOST_HEX_BYTES:
        lines.append(f"… {counted(len(data) - _MOST_HEX_BYTES, 'byte')} more")
    return lines


def _named(image: SiiImage, string_number: int) -> str:
    text = image.text(string_number)
    if text is None:
        return f"(string {string_number} is missing)" if string_number else ""
    return _shown(text)


def _shown(text: str) -> str:
    """A text without control characters, which would otherwise reach a terminal."""
    return "".join(char if char.isprintable() else f"\\x{ord(char):02x}" for char in text)


def _listed(words: Sequence[str]) -> str:
    return ", ".join(words) or "none"
