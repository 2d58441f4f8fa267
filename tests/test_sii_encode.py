"""Records to SII images, and back."""

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sii import by_hand

from esicatalog.errors import InputError
from esicatalog.sii.checksum import with_checksum
from esicatalog.sii.codes import CoeDetails, Enabled, GeneralFlags, MailboxProtocols, PdoFlags, SmEnable
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.encode import category_offsets, encode_sii, string_table
from esicatalog.sii.errors import SiiEncodeError
from esicatalog.sii.image import (
    DistributedClocks,
    Fmmus,
    General,
    RawCategory,
    RxPdos,
    SiiImage,
    Strings,
    SyncManagers,
    TxPdos,
)
from esicatalog.sii.records import DcMode, Fmmu, Header, Pdo, PdoEntry, SiiString, SyncManager

U8, U16, U32 = (st.integers(0, high) for high in (0xFF, 0xFFFF, 0xFFFFFFFF))
I16, I32 = (st.integers(-high - 1, high) for high in (0x7FFF, 0x7FFFFFFF))


def test_the_hand_made_image_comes_back():
    assert encode_sii(decode_sii(by_hand.WHOLE)) == by_hand.WHOLE


def test_an_image_from_records():
    image = SiiImage(
        header=with_checksum(Header(vendor_id=0x79A, product_code=1, size_word=1)),
        categories=(
            string_table(["Größe", "x"]),
            Fmmus(fmmus=(Fmmu(usage_code=1), Fmmu(usage_code=0xFF))),
            RxPdos(pdos=(Pdo(pdo_index=0x1600, sm=2, entries=(PdoEntry(entry_index=0x7000, bit_length=8),)),)),
        ),
        trailing=b"\xff\xff",
    )
    data = encode_sii(image)
    assert data[8 * 2 : 10 * 2] == bytes.fromhex("9A070000")
    assert data[128:] == b"".join(
        (
            bytes.fromhex("0A00 0500 02 05") + b"Gr\xf6\xdfe" + bytes.fromhex("01") + b"x" + b"\xff",
            bytes.fromhex("2800 0100 01 FF"),
            bytes.fromhex("3300 0800 0016 01 02 00 00 0000  0070 00 00 00 08 0000"),
            bytes.fromhex("FFFF FFFF"),
        )
    )
    assert decode_sii(data) == image
    assert category_offsets(image) == [128, 142, 148, 168]


def test_a_string_table_keeps_every_text():
    texts = ["", "plain", "Größe", "Ã¤", "Ωmega", "温度"]
    table = string_table(texts)
    assert [string.text for string in table.strings] == texts
    assert [string.encoding for string in table.strings] == ["ascii", "ascii", "cp1252", "utf-8", "utf-8", "utf-8"]


@given(st.lists(st.text(max_size=30), max_size=10))
def test_a_string_table_gives_its_texts_back_or_refuses(texts):
    try:
        table = string_table(texts)
    except SiiEncodeError:
        return
    decoded = decode_sii(encode_sii(SiiImage(header=with_checksum(Header(size_word=30)), categories=(table,))))
    assert [decoded.text(number) for number in range(1, len(texts) + 1)] == texts
    assert decoded.findings == ()


@pytest.mark.parametrize(
    ("image", "words"),
    [
        (SiiImage(header=Header(vendor_id=2**32)), "Header: vendor_id 4294967296 does not fit into 32 bits"),
        (SiiImage(header=Header(station_alias=-1)), "station_alias -1"),
        (SiiImage(header=Header(private=b"")), "private does not fit: 66 bytes needed, 0 given"),
        (
            SiiImage(categories=(RxPdos(pdos=(Pdo(pdo_index=0x1600, entries=(PdoEntry(bit_length=256),)),)),)),
            "PDO 0x1600: entry 1: PdoEntry: bit_length 256 does not fit into 8 bits (Length in bits)",
        ),
        (
            SiiImage(categories=(RxPdos(pdos=(Pdo(), Pdo(pdo_index=0x1601, sm=300))),)),
            "PDO 0x1601: Pdo: sm 300 does not fit into 8 bits (Sync manager it is assigned to)",
        ),
        (
            SiiImage(categories=(SyncManagers(sync_managers=(SyncManager(), SyncManager(length_bytes=65536))),)),
            "SM1: SyncManager: length_bytes 65536 does not fit into 16 bits (Length in bytes)",
        ),
        (
            SiiImage(categories=(DistributedClocks(modes=(DcMode(cycle_time_sync0_factor=40000),)),)),
            "OpMode 1: DcMode: cycle_time_sync0_factor 40000",
        ),
        (SiiImage(categories=(TxPdos(pdos=(Pdo(entries=(PdoEntry(),) * 256),)),)), "Pdo: entries 256"),
        (SiiImage(categories=(Strings(strings=(SiiString(),) * 256),)), "256 strings"),
        (SiiImage(categories=(Strings(strings=(SiiString(data=bytes(256)),)),)), "string 1 takes 256 bytes"),
        (SiiImage(categories=(Strings(strings=(SiiString(data=b"A"),)),)), "category 10 (STRINGS): 3 bytes"),
        (
            SiiImage(categories=(Fmmus(fmmus=(Fmmu(usage_code=1),)),)),
            "category 40 (FMMU): 1 byte is no number",
        ),
        (SiiImage(categories=(RawCategory(category_type=3, data=bytes(131072)),)), "131072 bytes"),
        (SiiImage(categories=(RawCategory(category_type=0xFFFF),)), "a category type is 0 to 0xFFFE"),
        (SiiImage(categories=(General(e_bus_current_ma=40000),)), "General: e_bus_current_ma 40000"),
        (SiiImage(end_mark=False, trailing=b"\xff"), "without an end mark"),
    ],
)
def test_what_does_not_fit_is_named(image, words):
    with pytest.raises(SiiEncodeError) as caught:
        encode_sii(image)
    assert isinstance(caught.value, InputError)
    assert words in str(caught.value)


@pytest.mark.parametrize("text", ["x" * 256, "ends with zero\0", "\ud800"])
def test_texts_that_no_table_holds(text):
    with pytest.raises(SiiEncodeError):
        string_table([text])


def flags(kind, bits):
    return bits.map(kind)


HEADERS = st.builds(
    Header,
    pdi_control=U16,
    pdi_configuration=U16,
    sync_impulse_length_10ns=U16,
    pdi_configuration_2=U16,
    station_alias=U16,
    reserved_5=U16,
    reserved_6=U16,
    vendor_id=U32,
    product_code=U32,
    revision_no=U32,
    serial_no=U32,
    port0_delay=U16,
    bootstrap_receive_mailbox_offset=U16,
    standard_send_mailbox_size=U16,
    mailbox_protocols=flags(MailboxProtocols, U16),
    private=st.binary(min_size=66, max_size=66),
    size_word=st.just(0xFFFF),
    version=U16,
).map(with_checksum)
ENTRIES = st.builds(
    PdoEntry, entry_index=U16, subindex=U8, data_type_code=U8, bit_length=U8, flags=U16, name_string_number=st.just(0)
)
PDOS = st.lists(
    st.builds(
        Pdo,
        pdo_index=U16,
        entries=st.lists(ENTRIES, max_size=3).map(tuple),
        sm=U8,
        dc_sync=U8,
        flags=flags(PdoFlags, U16),
    ),
    max_size=3,
).map(tuple)
STRING_TABLES = st.lists(st.binary(max_size=12), max_size=6).map(
    lambda items: Strings(
        strings=tuple(SiiString(data=item) for item in items),
        rest=b"\0" * ((1 + sum(map(len, items)) + len(items)) % 2),
    )
)
GENERALS = st.builds(
    General,
    legacy_ports=U8,
    coe_details=flags(CoeDetails, U8),
    foe_details=flags(Enabled, U8),
    eoe_details=flags(Enabled, U8),
    soe_channels=U8,
    flags=flags(GeneralFlags, U8),
    e_bus_current_ma=I16,
    physical_ports=U16,
    identification_address=U16,
    reserved_20=st.binary(min_size=12, max_size=12),
)
FMMUS = st.lists(st.builds(Fmmu, usage_code=U8), max_size=6).map(lambda items: Fmmus(fmmus=tuple(items[::2] * 2)))
SYNC_MANAGERS = st.lists(
    st.builds(
        SyncManager,
        start_address=U16,
        length_bytes=U16,
        control_byte=U8,
        status_byte=U8,
        enable=flags(SmEnable, U8),
        usage_code=U8,
    ),
    max_size=4,
).map(lambda items: SyncManagers(sync_managers=tuple(items)))
CLOCKS = st.lists(
    st.builds(
        DcMode,
        cycle_time_sync0_ns=U32,
        shift_time_sync0_ns=I32,
        shift_time_sync1_ns=I32,
        cycle_time_sync1_factor=I16,
        assign_activate=U16,
        cycle_time_sync0_factor=I16,
        reserved_20=U32,
    ),
    max_size=3,
).map(lambda items: DistributedClocks(modes=tuple(items)))
RAW = st.builds(
    RawCategory, category_type=st.sampled_from([1, 9, 20, 42, 43, 2048, 0xFFFE]), data=st.sampled_from([b"", b"AB"])
)
CATEGORIES = st.tuples(
    RAW,
    STRING_TABLES,
    GENERALS,
    FMMUS,
    SYNC_MANAGERS,
    PDOS.map(lambda pdos: TxPdos(pdos=pdos)),
    PDOS.map(lambda pdos: RxPdos(pdos=pdos)),
    CLOCKS,
).flatmap(st.permutations)
IMAGES = st.builds(
    SiiImage,
    header=HEADERS,
    categories=CATEGORIES.map(tuple),
    trailing=st.binary(max_size=9),
)


@settings(max_examples=150, deadline=None)
@given(IMAGES)
def test_records_come_back(image):
    assert decode_sii(encode_sii(image)) == image


@given(IMAGES)
@settings(max_examples=30, deadline=None)
def test_findings_are_no_part_of_the_bytes(image):
    assert encode_sii(msgspec.structs.replace(image, findings=("something",))) == encode_sii(image)
