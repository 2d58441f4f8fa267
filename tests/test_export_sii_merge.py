"""Merging a computed image into that of a device: what is kept, what would change, and in which words."""

import struct

import msgspec
import pytest
from sii import by_hand
from snippets import device, esi, pdo, read
from test_export_configuration import subject

from esicatalog.errors import InputError
from esicatalog.export.eeprom import eeprom_image
from esicatalog.export.sii import sii_image
from esicatalog.export.sii_changes import image_changes, stored_otherwise
from esicatalog.export.sii_header import configuration_bytes
from esicatalog.export.sii_limits import SiiLimitError, check_image, fit_image
from esicatalog.export.sii_merge import MergedImage, merge_image
from esicatalog.export.sii_summary import image_text
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.encode import encode_sii, string_table
from esicatalog.sii.errors import SiiImageError
from esicatalog.sii.image import ByteRange, Fmmus, General, RawCategory, SiiImage, Strings, SyncManagers
from esicatalog.sii.records import Fmmu, Header, SiiString

DUMP = decode_sii(by_hand.WHOLE)
"""Alias 1234, serial 42, private words, categories 3 and 43, a bootstrap mailbox; vendor 0x79A."""
CONFIG = "<Eeprom><ByteSize>2048</ByteSize><ConfigData>8003006E64000001</ConfigData></Eeprom>"
"""The PDI words of the dump."""
BROKEN = "<Eeprom><ByteSize>2048</ByteSize><ConfigData>0504006E64000001</ConfigData></Eeprom>"


def computed(content: str = "", vendor_id: int = 0x79A) -> SiiImage:
    text = esi(device(content, product="#xDEADBEEF", revision="#x00010002"))
    (info,) = read(text).document.infos
    return sii_image(vendor_id, info.groups[0], info.devices[0])


def parts(merged: MergedImage) -> list[str]:
    """The parts in which something would change, once each, in order."""
    return list(dict.fromkeys(change.part for change in merged.changes))


def test_what_only_the_device_has_is_kept():
    merged = merge_image(computed(CONFIG), DUMP)
    data = encode_sii(merged.image)
    before = by_hand.WHOLE
    assert data[8:10] == before[8:10], "alias"
    assert data[0x1C:0x20] == before[0x1C:0x20], "serial number"
    assert data[0x3A:0x7C] == before[0x3A:0x7C], "private words"
    assert data[0x7C:0x80] == before[0x7C:0x80], "size and version"
    assert data[14] == by_hand.remainder_crc(data[:14])
    raw = {item.category_type: item.data for item in merged.image.of_type(RawCategory)}
    assert raw == {3: b"factory data", 43: b"\xf0\xff"}
    assert merged.kept == (
        "station alias 1234",
        "serial number 0x0000002A",
        "words 0x1D to 0x3D",
        "word 5, not given in the description or zero there",
        "bootstrap mailbox, not given in the description or zero there",
        "category 3 (device specific), 12 bytes",
        "category 43 (SyncUnit), 2 bytes",
    )


@pytest.mark.parametrize(
    ("config_data", "configuration"),
    [
        ("0504", "0504006E64000001"),
        ("050403", "0504036E64000001"),
        ("05040301", "0504030164000001"),
        ("0504030102000000", "0504030102000000"),
        ("00000000", "8003006E64000001"),
    ],
)
def test_what_a_short_config_data_does_not_hold_stays(config_data, configuration):
    described = device(f"<Eeprom><ByteSize>2048</ByteSize><ConfigData>{config_data}</ConfigData></Eeprom>")
    (info,) = read(esi(described)).document.infos
    (described,) = info.devices
    merged = merge_image(sii_image(1, None, described), DUMP, configuration_bytes(described))
    data = encode_sii(merged.image)
    assert data[:8].hex().upper() == configuration
    assert data[14] == by_hand.remainder_crc(data[:14])
    kept = f"PDI words from byte {len(config_data) // 2}, where ConfigData ends"
    assert (kept in merged.kept) == (0 < len(config_data) < 16 and config_data != "00000000")


def test_an_image_in_the_description_gives_all_pdi_words():
    described = device(f"<Eeprom><Data>{by_hand.WHOLE.hex()}</Data></Eeprom>")
    (info,) = read(esi(described)).document.infos
    assert configuration_bytes(info.devices[0]) == 14


def test_the_order_of_the_dump_is_kept_and_new_categories_follow():
    everything = "<Fmmu>Outputs</Fmmu><Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", 8)
    merged = merge_image(computed(everything), DUMP)
    assert [item.category_type for item in merged.image.categories] == [3, 10, 30, 40, 41, 43, 51]
    bare = msgspec.structs.replace(DUMP, categories=DUMP.categories[:1])
    merged = merge_image(computed(everything), bare)
    assert [item.category_type for item in merged.image.categories] == [3, 10, 30, 40, 41, 51]


def test_the_first_of_repeated_categories_is_replaced_and_the_others_go():
    strings = DUMP.categories[1]
    doubled = msgspec.structs.replace(DUMP, categories=(*DUMP.categories, strings))
    merged = merge_image(computed(), doubled)
    assert [item.category_type for item in merged.image.categories] == [3, 10, 30, 43]


def test_a_category_that_could_not_be_read_is_replaced_too():
    broken = RawCategory(category_type=30, data=b"BootCfg\0")
    merged = merge_image(computed(), msgspec.structs.replace(DUMP, categories=(broken,)))
    assert [item.category_type for item in merged.image.categories] == [30, 10]
    assert merged.image.general is not None


def test_factory_categories_of_the_device_win_over_declared_ones():
    declared = "".join(f"<Category><CatNo>{n}</CatNo><Data>AABB</Data></Category>" for n in (3, 4))
    merged = merge_image(computed(f"<Eeprom><ByteSize>2048</ByteSize>{declared}</Eeprom>"), DUMP)
    raw = {item.category_type: item.data for item in merged.image.of_type(RawCategory)}
    assert raw == {3: b"factory data", 43: b"\xf0\xff", 4: b"\xaa\xbb"}
    assert "category 3 (device specific), 12 bytes; the description declares other data" in merged.kept
    assert ("other categories", "category 4 (device specific) would be added: aa bb") in words(merged.changes)


@pytest.mark.parametrize("content", ["", "<Eeprom><ByteSize>2048</ByteSize></Eeprom>"])
def test_without_config_data_the_pdi_words_stay(content):
    merged = merge_image(computed(content), DUMP)
    assert encode_sii(merged.image)[:16] == by_hand.WHOLE[:16]
    assert "PDI words, not given in the description or zero there" in merged.kept
    assert "PDI words" not in parts(merged)


def test_other_config_data_are_the_first_change():
    merged = merge_image(computed(BROKEN, vendor_id=2), DUMP)
    assert struct.unpack_from("<HHHH", encode_sii(merged.image)) == (0x0405, 0x6E00, 0x0064, 0x0100)
    assert words(merged.changes)[0] == ("PDI words", "PDI control: 0x0380 would become 0x0405")
    assert words(merged.changes)[1][0] == "check sum"
    assert words(merged.changes)[2] == ("identity", "vendor id: 0x0000079A would become 0x00000002")
    lines = image_text(subject(""), merged.image, merged=merged).splitlines()
    assert [line for line in lines if "unreachable" in line or "another device" in line] == lines[3:5]


def test_the_parts_come_in_the_order_of_harm():
    merged = merge_image(computed(BROKEN + pdo("RxPdo", "#x1601", 8), vendor_id=2), DUMP)
    assert parts(merged) == [
        "PDI words",
        "check sum",
        "identity",
        "mailboxes",
        "SyncManagers",
        "FMMUs",
        "PDOs",
        "OpModes",
        "General",
        "texts",
    ]


def test_reserved_bytes_of_general_stay():
    general = msgspec.structs.replace(DUMP.general, sysman_class=0x13, legacy_ports=7, reserved_20=bytes(range(12)))
    categories = tuple(general if item == DUMP.general else item for item in DUMP.categories)
    merged = merge_image(computed(), msgspec.structs.replace(DUMP, categories=categories))
    found = merged.image.general
    assert (found.sysman_class, found.legacy_ports, found.reserved_20) == (0x13, 7, bytes(range(12)))
    assert found.e_bus_current_ma == 0, "what the description says counts"


def test_merging_an_image_into_itself_changes_nothing():
    image = check_image(computed(CONFIG + pdo("RxPdo", "#x1600", 8, attributes='Sm="0"')), 2048)
    merged = merge_image(image, image)
    assert merged.changes == ()
    assert check_image(merged.image, merged.byte_size) == image
    assert "The device's image would not change." in image_text(subject(""), image, merged=merged)


def told(merged: MergedImage) -> tuple[bytes, list[str]]:
    """The image that is written, and what is told of it behind the first line."""
    image = check_image(merged.image, merged.byte_size, merged.dump)
    return encode_sii(image), image_text(subject(""), image, merged=merged).splitlines()[1:]


UNCHANGED = "The device's image would not change."


def test_what_a_dump_does_not_hold_is_not_written():
    """Some tools read up to the end mark: what is behind is not known to be free."""
    dump = decode_sii(encode_sii(computed(CONFIG)))
    data, lines = told(merge_image(computed(CONFIG), dump))
    assert data == encode_sii(dump)
    assert lines[:3] == [
        f"The dump holds {len(data)} of the EEPROM's 2048 bytes; {2048 - len(data)} were not in it.",
        f"{2048 - len(data)} bytes behind this image are no part of it and stay as they are, if the tool that writes "
        "it leaves alone what the file does not hold.",
        UNCHANGED,
    ]


def test_an_image_longer_than_its_dump_tells_what_it_overwrites():
    dump = decode_sii(encode_sii(computed(CONFIG)))
    merged = merge_image(computed(CONFIG + pdo("RxPdo", "#x1600", 8)), dump)
    data, lines = told(merged)
    assert data == encode_sii(merged.image)
    more = len(data) - len(encode_sii(dump))
    assert more > 0
    assert lines[1].startswith(f"Writing this image overwrites the first {more} of them, whatever they hold")
    assert lines[2].startswith(f"{2048 - len(data)} bytes behind this image")
    assert UNCHANGED not in lines


def test_an_image_shorter_than_its_dump_is_filled_up_to_it():
    dump = decode_sii(encode_sii(computed(CONFIG + pdo("RxPdo", "#x1600", 8))))
    merged = merge_image(computed(CONFIG), dump)
    data, _ = told(merged)
    free = len(encode_sii(dump)) - len(encode_sii(merged.image))
    assert free > 0
    assert data == encode_sii(merged.image) + b"\xff" * free
    assert encode_sii(fit_image(merged.image, merged.byte_size, merged.dump).image) == data


def test_of_a_whole_dump_nothing_is_unread():
    dump = check_image(computed(CONFIG), 2048)
    data, lines = told(merge_image(computed(CONFIG), dump))
    assert (data, lines[0]) == (encode_sii(dump), UNCHANGED)


def test_a_wrong_check_sum_is_a_change():
    sound = check_image(computed(CONFIG), 2048)
    header = msgspec.structs.replace(sound.header, checksum=sound.header.checksum ^ 0xFF)
    merged = merge_image(computed(CONFIG), msgspec.structs.replace(sound, header=header))
    data, lines = told(merged)
    assert data == encode_sii(sound)
    right = sound.header.checksum
    assert words(merged.changes) == [("check sum", f"check sum: 0x{right ^ 0xFF:02X} would become 0x{right:02X}")]
    assert "check sum in the dump is wrong" in lines[0]
    assert UNCHANGED not in lines


def test_every_byte_that_differs_is_told():
    """A bit of each byte of an image inverted, but for those after which it is none. Padding of texts is no value."""
    padding = by_hand.WHOLE.index(by_hand.STRINGS) + len(by_hand.STRINGS) - 1
    for offset in range(len(by_hand.WHOLE) - len(by_hand.END) - 6):
        data = bytearray(by_hand.WHOLE)
        data[offset] ^= 1 << offset % 8
        try:
            other = decode_sii(bytes(data))
        except SiiImageError:
            continue
        assert stored_otherwise(DUMP, other) or offset < 128, hex(offset)
        assert bool(image_changes(DUMP, other)) == (offset != padding), hex(offset)


def test_what_only_is_stored_otherwise_is_no_value_but_told():
    sound = check_image(computed(CONFIG + "<Fmmu>Outputs</Fmmu>"), 2048)
    strings = sound.of_type(Strings)[0]
    turned = msgspec.structs.replace(strings, strings=(*strings.strings, SiiString()), rest=b"\0")
    categories = [turned if item is strings else item for item in sound.categories]
    dump = msgspec.structs.replace(sound, categories=tuple(categories))
    data, lines = told(merge_image(computed(CONFIG + "<Fmmu>Outputs</Fmmu>"), dump))
    assert data != encode_sii(dump)
    assert lines[0] == "No value would change, only how it is stored: order, padding or encoding of texts."
    assert not any(line.startswith("Writing it would change") for line in lines)


@pytest.mark.parametrize(
    ("other", "expected"),
    [
        ({"end_mark": False, "trailing": b""}, ("end mark",)),
        ({"trailing": b"\0\0"}, ("bytes behind the end mark",)),
        ({"trailing": b"\xff\xff"}, ()),
        ({"categories": (General(), Fmmus())}, ("order of the categories",)),
        ({"categories": (Fmmus(fmmus=(Fmmu(usage_code=0xFF),) * 2), General())}, ("codes of FMMUs without use",)),
        ({"categories": (Fmmus(),)}, ("category 30 (General)", "order of the categories")),
    ],
)
def test_images_that_say_the_same(other, expected):
    image = SiiImage(categories=(Fmmus(), General()))
    changed = msgspec.structs.replace(image, **other)
    assert image_changes(image, changed) == ()
    assert stored_otherwise(image, changed) == expected


def test_bytes_and_texts_that_a_merge_loses_are_told():
    texts = string_table(["T1", "G", "Group", "N", "calibrated"])
    own = SyncManagers(rest=b"\1\2")
    dump = msgspec.structs.replace(computed(CONFIG), categories=(texts, computed(CONFIG).general, own))
    assert words(merge_image(computed(CONFIG), dump).changes) == [
        ("unreadable categories", "category 41 (SyncM), bytes of no whole record would be removed: 01 02"),
        ("texts", "texts that nothing names would be removed: 'calibrated'"),
    ]


def dump_with_tail(free: int, size_word: int = 5) -> SiiImage:
    """The dump in an EEPROM that ends with four bytes of the maker's, after so many free ones."""
    header = msgspec.structs.replace(DUMP.header, size_word=size_word)
    return msgspec.structs.replace(DUMP, header=header, trailing=b"\xff" * free + b"\x01\x02\xff\x04")


def test_bytes_behind_the_end_mark_keep_their_address():
    dump = dump_with_tail(100)
    address = len(encode_sii(dump)) - 4
    for content in ("", CONFIG, "<Fmmu>Outputs</Fmmu>", pdo("RxPdo", "#x1600", *range(1, 20))):
        merged = merge_image(computed(content), dump)
        data = encode_sii(check_image(merged.image, merged.byte_size, dump))
        assert data[address : address + 4] == b"\x01\x02\xff\x04"
        assert len(data) == len(encode_sii(dump)), "what was not read is not written"
    assert merged.kept[-1] == "104 bytes behind the end mark"


def test_bytes_behind_the_end_mark_keep_their_address_when_names_are_left_out():
    dump = dump_with_tail(100)
    address = len(encode_sii(dump)) - 4
    merged = merge_image(computed(pdo("RxPdo", "#x1600", *range(1, 20))), dump)
    fitted = fit_image(merged.image, address + 4, dump).image
    assert encode_sii(fitted)[address:] == b"\x01\x02\xff\x04"


def test_bytes_behind_the_end_mark_are_not_overwritten():
    dump = dump_with_tail(0)
    content = pdo("RxPdo", "#x1600", *range(1, 60))
    excess = len(encode_sii(merge_image(computed(content), DUMP).image)) - len(by_hand.WHOLE) + 6
    with pytest.raises(SiiLimitError, match=f"{excess} bytes too long: it would overwrite") as found:
        check_image(merge_image(computed(content), dump).image, 768, dump)
    assert found.value.excess_bytes == excess


def test_the_eeprom_is_as_large_as_its_dump():
    """A size word can be wrong: 14 stands in a real image of 2048 bytes."""
    dump = msgspec.structs.replace(
        DUMP, header=msgspec.structs.replace(DUMP.header, size_word=1), trailing=b"\xff" * 600
    )
    assert merge_image(computed(), dump).byte_size == len(encode_sii(dump))
    assert merge_image(computed(), DUMP).byte_size == 2048


def test_a_dump_of_another_size_keeps_it():
    dump = msgspec.structs.replace(DUMP, header=msgspec.structs.replace(DUMP.header, size_word=31))
    merged = merge_image(computed(CONFIG), dump)
    assert merged.image.header.size_word == 31
    assert "size of the EEPROM, 4096 bytes; the description says 2048" in merged.kept


PDOS = (
    '<RxPdo Sm="2"><Index>#x1600</Index><Name>Target</Name>'
    "<Entry><Index>#x607A</Index><SubIndex>0</SubIndex><BitLen>32</BitLen><DataType>DINT</DataType></Entry></RxPdo>"
)


def words(found):
    return [(change.part, change.text) for change in found]


def changes(before: str, after: str) -> list[tuple[str, str]]:
    return words(image_changes(computed(before), computed(after)))


@pytest.mark.parametrize(
    ("before", "after", "expected"),
    [
        (PDOS, PDOS, []),
        (
            PDOS,
            PDOS.replace("32", "16").replace("DINT", "INT"),
            [
                ("PDOs", "RxPDO 0x1600: SM2, entries: 1, bits: 32 would become "
                 "SM2, entries: 1, bits: 16"),
                ("PDOs", "RxPDO 0x1600, entry 1: 0x607A:00, 32 bits, DINT would become 0x607A:00, 16 bits, INT"),
            ],
        ),
        (
            PDOS,
            PDOS.replace("#x607A", "0"),
            [("PDOs", "RxPDO 0x1600, entry 1: 0x607A:00, 32 bits, DINT would become a gap of 32 bits")],
        ),
        (
            PDOS,
            PDOS.replace('Sm="2"', 'Mandatory="1"'),
            [("PDOs", "RxPDO 0x1600: SM2, entries: 1, bits: 32 would become "
              "not assigned, entries: 1, bits: 32"),
             ("PDOs", "RxPDO 0x1600, flags: none would become mandatory")],
        ),
        (PDOS, "", [("PDOs", "RxPDO 0x1600 would be removed: SM2, entries: 1, bits: 32")]),
        ("", PDOS, [("PDOs", "RxPDO 0x1600 would be added: SM2, entries: 1, bits: 32")]),
        (
            pdo("TxPdo", "#x1A00") + pdo("TxPdo", "#x1A01"),
            pdo("TxPdo", "#x1A01") + pdo("TxPdo", "#x1A00"),
            [("PDOs", "order of the TxPDOs: 0x1A00, 0x1A01 would become 0x1A01, 0x1A00")],
        ),
        (
            pdo("TxPdo", "#x1A00", 1) + pdo("TxPdo", "#x1A00", 2),
            pdo("TxPdo", "#x1A00", 1) + pdo("TxPdo", "#x1A00", 3),
            [
                ("PDOs", "TxPDO 0x1A00: not assigned, entries: 1, bits: 2 would become "
                 "not assigned, entries: 1, bits: 3"),
                ("PDOs", "TxPDO 0x1A00, entry 1: 0x7000:01, 2 bits, type 0x00 would become "
                 "0x7000:01, 3 bits, type 0x00"),
            ],
        ),
        (PDOS, PDOS.replace("Target", "Position"),
         [("texts", "name of RxPDO 0x1600: 'Target' would become 'Position'")]),
        ("<Fmmu>Outputs</Fmmu>", "<Fmmu>Inputs</Fmmu>", [("FMMUs", "FMMU0: Outputs would become Inputs")]),
        (
            '<Sm StartAddress="#x1000" ControlByte="#x64" Enable="1">Outputs</Sm>',
            '<Sm StartAddress="#x1000" ControlByte="#x24" Enable="1">Outputs</Sm>',
            [("SyncManagers", "SM0: Outputs at 0x1000, 0 bytes, control 0x64, enable 0x01 would become "
              "Outputs at 0x1000, 0 bytes, control 0x24, enable 0x01")],
        ),
        (
            "<Mailbox><CoE/></Mailbox>",
            '<Mailbox><CoE CompleteAccess="1"/><FoE/></Mailbox>',
            [
                ("mailboxes", "mailbox protocols: CoE would become CoE, FoE"),
                ("General", "CoE: SDO would become SDO, complete access"),
                ("General", "FoE: none would become enabled"),
            ],
        ),
        (
            "",
            "<Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate></OpMode></Dc>",
            [("OpModes", "OpMode 1 would be added: AssignActivate 0x0300, SYNC0 cycle 0 ns factor 1, shift 0 ns, "
              "SYNC1 factor 0, shift 0 ns")],
        ),
        (
            "<Dc><OpMode><AssignActivate>#x300</AssignActivate><ShiftTimeSync0>250</ShiftTimeSync0></OpMode></Dc>",
            "<Dc><OpMode><AssignActivate>#x300</AssignActivate><ShiftTimeSync0>-250</ShiftTimeSync0></OpMode></Dc>",
            [("OpModes", "OpMode 1: AssignActivate 0x0300, SYNC0 cycle 0 ns factor 1, shift 250 ns, SYNC1 factor 0, "
              "shift 0 ns would become AssignActivate 0x0300, SYNC0 cycle 0 ns factor 1, shift -250 ns, "
              "SYNC1 factor 0, shift 0 ns")],
        ),
    ],
)  # fmt: skip
def test_changes_in_words(before, after, expected):
    assert changes(before, after) == expected


def test_padding_of_fmmus_is_no_change():
    """Tools fill up with 0x00 or 0xFF; both mean unused."""
    padded = decode_sii(by_hand.image((40, b"\x01\xff")))
    other = decode_sii(by_hand.image((40, b"\x01\x00")))
    assert image_changes(padded, other) == ()


def test_further_words_and_categories_are_changes_too():
    before = SiiImage(header=Header(), categories=(RawCategory(category_type=3, data=b"AB"),))
    after = SiiImage(header=Header(execution_delay=5, private=b"\x01" + bytes(65)))
    assert tuple(words(image_changes(before, after))) == (
        ("other words", "word 0x10, a delay: 0 would become 5"),
        ("other words", "words 0x1D to 0x3D: zeros would become 01"),
        ("other categories", "category 3 (device specific) would be removed: 41 42"),
    )


def test_zeros_behind_the_end_mark_stay_and_are_free():
    """Some tools fill up with 0x00. What is free needs no room, and what is not overwritten stays."""
    used = encode_sii(computed(CONFIG))
    dump = decode_sii((used + bytes(300)).ljust(2048, b"\xff"))
    merged = merge_image(computed(CONFIG), dump)
    assert merged.kept == (), "nothing is there that could be kept"
    data, lines = told(merged)
    assert data == encode_sii(dump)
    assert lines[0] == UNCHANGED
    longer = merge_image(computed(CONFIG + pdo("RxPdo", "#x1600", 8)), dump)
    data = encode_sii(check_image(longer.image, longer.byte_size, dump))
    assert data[len(encode_sii(longer.image)) :] == encode_sii(dump)[len(encode_sii(longer.image)) :]


def test_bytes_behind_the_strings_that_a_merge_loses_are_told():
    """An odd byte pads the table; more than that is the maker's."""
    strings, *others = computed(CONFIG).categories
    kept = strings.rest + bytes.fromhex("53 45 43 52")
    dump = msgspec.structs.replace(computed(CONFIG), categories=(msgspec.structs.replace(strings, rest=kept), *others))
    assert words(merge_image(computed(CONFIG), dump).changes) == [
        ("other categories", f"bytes of no whole record would be removed: {kept.hex(' ')}")
    ]


def test_a_second_general_category_that_a_merge_loses_is_told():
    dump = msgspec.structs.replace(
        computed(CONFIG), categories=(*computed(CONFIG).categories, General(reserved_20=b"SECOND" + bytes(6)))
    )
    stored = "00 " * 20 + "53 45 43 4f 4e 44" + " 00" * 6
    assert words(merge_image(computed(CONFIG), dump).changes) == [
        ("other categories", f"further General categories would be removed: {stored}")
    ]


def test_a_check_sum_that_is_not_tested_is_not_called_wrong():
    """0x88A4: a slave controller loads the words whatever their check sum (ESC data sheet)."""
    data = encode_sii(check_image(computed(CONFIG), 2048))
    merged = merge_image(computed(CONFIG), decode_sii(data[:14] + b"\xa4\x88" + data[16:]))
    _, lines = told(merged)
    assert not any("does not load" in line for line in lines)
    assert "  check sum: check sum: 0xA4 would become" in "\n".join(lines)


def test_what_overlaps_the_bytes_behind_is_left_out_on_demand():
    """Two free bytes behind the end mark, then the maker's: a longer name does not fit, without it all does."""
    named = CONFIG + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')
    used = encode_sii(computed(named))
    dump = decode_sii((used + b"\xff\xffCALI").ljust(2048, b"\xff"))
    merged = merge_image(computed(named.replace(">e1<", ">a much longer name<")), dump)
    with pytest.raises(SiiLimitError, match=r"would overwrite the device's own bytes .*--fit\)"):
        check_image(merged.image, merged.byte_size, dump)
    image, dropped = fit_image(merged.image, merged.byte_size, dump)
    assert dropped == ("names of entries: 1",)
    data = encode_sii(image)
    assert data[len(used) + 2 :] == encode_sii(dump)[len(used) + 2 :]
    assert [item.pdo_index for item in image.rx_pdos] == [0x1600]


def test_more_strings_than_a_table_holds_are_left_out_beside_bytes_behind():
    many = CONFIG + pdo("RxPdo", "#x1600", *[8] * 255)
    tail = b"\xff" * 7000 + b"CALI"
    header = msgspec.structs.replace(DUMP.header, size_word=127)
    dump = msgspec.structs.replace(DUMP, header=header, trailing=tail)
    merged = merge_image(computed(many), dump)
    data = encode_sii(fit_image(merged.image, merged.byte_size, dump).image)
    assert data[-4:] == b"CALI"
    assert len(data) == len(encode_sii(dump))


@pytest.mark.parametrize("lost", [ByteRange(0x40, 0x4F), ByteRange(len(by_hand.WHOLE) - 7, len(by_hand.WHOLE) - 1)])
def test_a_dump_that_lacks_bytes_of_the_image_is_not_merged_into(lost):
    """What an Intel HEX file leaves out reads 0xFF: it would be written over factory data. The end mark counts."""
    dump = msgspec.structs.replace(DUMP, unread=(lost, ByteRange(0x300, 0x300)))
    with pytest.raises(InputError, match=f"does not hold the bytes 0x{lost.first:X} to 0x{lost.last:X}, and"):
        merge_image(computed(CONFIG), dump)


def test_bytes_behind_the_end_mark_that_were_not_read_are_told():
    whole = check_image(computed(CONFIG), 2048)
    merged = merge_image(computed(CONFIG), msgspec.structs.replace(whole, unread=(ByteRange(0x400, 0x40F),)))
    _, lines = told(merged)
    assert lines[0].startswith(
        "Writing this image overwrites the bytes 0x400 to 0x40F, which the dump does not hold, with 0xFF"
    )
    assert lines[1] == "What the dump holds would not change."


def test_what_is_replaced_is_not_called_kept():
    """A General of 16 bytes is kept raw when it is read, and a computed one takes its place."""
    broken = RawCategory(category_type=30, data=b"BootCfg\0")
    merged = merge_image(computed(CONFIG), msgspec.structs.replace(DUMP, categories=(broken, DUMP.categories[0])))
    kept = [line for line in merged.kept if line.startswith("category")]
    assert kept == ["category 3 (device specific), 12 bytes"]


def test_a_whole_image_that_repeats_a_category_is_merged_whole():
    """Two TxPDO categories with a PDO each, which the dump has as one, or as two."""
    twice = tuple((50, index + bytes(1) + b"\xff\0\0\0\0") for index in (b"\0\x1a", b"\1\x1a"))
    whole = decode_sii(by_hand.image(*by_hand.CATEGORIES[:6], *twice))
    merged = merge_image(whole, DUMP)
    assert [item.pdo_index for item in merged.image.tx_pdos] == [0x1A00, 0x1A01]
    merged = merge_image(whole, whole)
    assert encode_sii(merged.image) == encode_sii(whole)


def test_what_is_odd_about_the_dump_is_told():
    dump = decode_sii(by_hand.image(*by_hand.CATEGORIES, end=b""))
    _, lines = told(merge_image(computed(CONFIG), dump))
    assert f"  no end mark after the last category: the image ends at byte 0x{len(encode_sii(dump)):X}." in lines
    assert "About the dump:" in lines


def test_the_device_keeps_descriptions_of_op_modes_that_are_described():
    mode = "<Dc><OpMode><Name>DC</Name>{}<AssignActivate>#x300</AssignActivate></OpMode></Dc>"
    described = subject(mode.format("<Desc>with SYNC0</Desc>") + CONFIG)
    plain = eeprom_image(described).image
    assert plain.text(plain.dc_modes[0].description_string_number) is None
    assert b"with SYNC0" not in encode_sii(plain)
    own = sii_image(0xE5C, described.group, described.device, descriptions=True)
    assert own.text(own.dc_modes[0].description_string_number) == "with SYNC0"
    made = eeprom_image(described, dump=check_image(own, 2048))
    assert (made.image, made.merged.changes) == (check_image(own, 2048), ())


def test_a_description_of_an_op_mode_that_is_cut_is_told_where_it_is_stored():
    mode = f"<Dc><OpMode><Name>DC</Name><Desc>{'x' * 256}</Desc><AssignActivate>#x300</AssignActivate></OpMode></Dc>"
    described = subject(mode + CONFIG)
    cut = f"Texts cut to 255 bytes: '{'x' * 40}'…."
    assert cut not in image_text(described, eeprom_image(described).image)
    own = sii_image(0xE5C, described.group, described.device, descriptions=True)
    made = eeprom_image(described, dump=check_image(own, 2048))
    assert made.image.text(made.image.dc_modes[0].description_string_number) == "x" * 255
    assert cut in image_text(described, made.image, merged=made.merged)
