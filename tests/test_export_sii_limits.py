"""What an EEPROM holds: sizes, counts and lengths, and what is left out to fit."""

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from snippets import device, esi, pdo, read
from test_export_configuration import subject

from esicatalog.errors import InputError
from esicatalog.export.sii import described_image, sii_image
from esicatalog.export.sii_header import eeprom_bytes
from esicatalog.export.sii_limits import SiiLimitError, check_image, fit_image
from esicatalog.export.sii_remarks import eeprom_remarks
from esicatalog.export.sii_summary import image_text
from esicatalog.export.subject import subjects_of_document
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.encode import encode_sii
from esicatalog.sii.image import RawCategory, SiiImage


def image(content: str = "") -> SiiImage:
    (info,) = read(esi(device(content))).document.infos
    return sii_image(1, info.groups[0], info.devices[0])


def used(content: str = "") -> int:
    """Bytes of an image without free bytes."""
    return len(encode_sii(image(content)))


NAMED = (
    pdo("RxPdo", "#x1600", 8, attributes='Sm="0"')
    + pdo("RxPdo", "#x1601", 8, 8)
    + "<Dc><OpMode><Name>DC mode</Name><AssignActivate>0</AssignActivate></OpMode></Dc>"
)
"""One assigned PDO with one entry, another with two entries, an OpMode; everything has a name."""


def test_the_size_of_a_small_image_by_hand():
    """Header 128; strings 4 + 1 + (2+1) + (1+1) + (5+1) + (1+1) for T1, G, Group, N, even; General 4 + 32; end 2."""
    assert used() == 128 + 4 + 14 + 36 + 2


@pytest.mark.parametrize("byte_size", [256, 2048, 65536])
def test_an_image_fills_its_eeprom_with_0xff(byte_size):
    data = encode_sii(check_image(image(), byte_size))
    assert len(data) == byte_size
    assert data.startswith(encode_sii(image()))
    assert set(data[used() :]) == {0xFF}


def test_an_image_that_fits_exactly():
    assert len(encode_sii(check_image(image(), used()))) == used()


@pytest.mark.parametrize("missing", [1, 2, 56])
def test_an_image_too_large_says_by_how_much(missing):
    with pytest.raises(
        SiiLimitError, match=f"takes {used()} bytes, {missing} more than the {used() - missing} "
    ) as found:
        check_image(image(), used() - missing)
    assert isinstance(found.value, InputError)
    assert found.value.excess_bytes == missing


def names(count: int) -> str:
    """An assigned PDO with 200 names and another with the rest."""
    entries = [f"<Entry><Index>#x7000</Index><BitLen>8</BitLen><Name>n{n}</Name></Entry>" for n in range(count)]
    first, second = "".join(entries[:200]), "".join(entries[200:])
    return (
        f'<RxPdo Sm="0"><Index>#x1600</Index><Name>R</Name>{first}</RxPdo>'
        f"<RxPdo><Index>#x1601</Index><Name>R</Name>{second}</RxPdo>"
    )


def test_a_string_table_has_255_strings():
    """T1, G, Group, N and R leave 250 for entries."""
    assert len(check_image(image(names(250)), 65536).categories[0].strings) == 255
    with pytest.raises(SiiLimitError, match="256 strings where a string table has room for 255"):
        check_image(image(names(251)), 65536)


def test_too_many_strings_are_left_out_on_demand():
    found, dropped = fit_image(image(names(251)), 65536)
    assert [line.split(":")[0] for line in dropped] == ["names of entries of PDOs that no SyncManager is assigned"]
    assert [len(item.entries) for item in found.rx_pdos] == [200, 51]
    assert len(found.categories[0].strings) == 5 + 200


def test_entries_of_more_than_255_bits_and_pdos_of_more_than_255_entries_are_named():
    entry = "<Entry><Index>#x7001</Index><SubIndex>2</SubIndex><BitLen>256</BitLen></Entry>"
    long = f"<RxPdo><Index>#x1601</Index><Name>R</Name>{entry}</RxPdo>"
    many = pdo("TxPdo", "#x1A00", *[1] * 256)
    with pytest.raises(SiiLimitError) as found:
        check_image(image(long + many), 65536)
    assert "entry 0x7001:02 of PDO 0x1601 with 256 bits where 255 are possible" in str(found.value)
    assert "PDO 0x1A00 with 256 entries where 255 are possible" in str(found.value)
    assert found.value.excess_bytes == 0


def test_what_no_image_can_hold_is_left_out_with_its_pdo():
    long = (
        "<RxPdo {}><Index>#x1601</Index><Name>R</Name><Entry><Index>#x7001</Index><BitLen>256</BitLen></Entry></RxPdo>"
    )
    kept = pdo("RxPdo", "#x1600", 8, attributes='Sm="0"') + pdo("TxPdo", "#x1A00", 8)
    found, dropped = fit_image(image(kept + long.format("")), 2048)
    assert [item.pdo_index for item in (*found.rx_pdos, *found.tx_pdos)] == [0x1600, 0x1A00]
    words = (
        "PDOs that no image can hold, with all of the same SyncManager, which a master then has to know from elsewhere"
    )
    assert dropped == (f"{words}: 0x1601",)
    assert found.text(found.rx_pdos[0].entries[0].name_string_number) == "e1"
    found, dropped = fit_image(image(kept + long.format('Sm="0"')), 2048)
    assert [item.pdo_index for item in (*found.rx_pdos, *found.tx_pdos)] == [0x1A00]
    assert dropped == (f"{words}: 0x1600, 0x1601",)
    assert found.text(found.general.group_string_number) == "G"


def test_names_go_first_step_by_step():
    """Every size down to that of the header."""
    seen: list[str] = []
    full, byte_size = image(NAMED), used(NAMED)
    while byte_size >= 130:
        found, dropped = fit_image(full, byte_size)
        assert len(encode_sii(found)) == byte_size
        steps = [line.split(":")[0] for line in dropped]
        assert steps[: len(seen)] == seen
        seen = steps
        byte_size -= 1
    assert seen == [
        "names of entries of PDOs that no SyncManager is assigned",
        "names of entries",
        "names of PDOs",
        "names of OpModes",
        "names of group and image",
        "PDOs that no SyncManager is assigned",
        "all PDOs, which a master then has to know from elsewhere",
        "all OpModes",
        "everything else that is computed",
    ]


def test_what_fits_is_not_touched():
    found, dropped = fit_image(image(NAMED), 2048)
    assert dropped == ()
    assert found == check_image(image(NAMED), 2048)


def test_the_names_that_stay_are_the_same():
    full = image(NAMED)
    found, dropped = fit_image(full, used(NAMED) - 1)
    assert dropped == ("names of entries of PDOs that no SyncManager is assigned: 2",)
    assert [found.text(item.name_string_number) for item in found.rx_pdos] == ["RxPdo #x1600", "RxPdo #x1601"]
    assert [found.text(entry.name_string_number) for entry in found.rx_pdos[0].entries] == ["e1"]
    assert [entry.name_string_number for entry in found.rx_pdos[1].entries] == [0, 0]
    assert found.text(found.general.order_string_number) == "T1"
    assert found.text(found.dc_modes[0].name_string_number) == "DC mode"


def test_an_eeprom_of_128_bytes_holds_the_header_alone():
    found, dropped = fit_image(image(), 128)
    assert encode_sii(found) == encode_sii(image())[:128]
    assert dropped[-1] == "everything else that is computed: category 10 (STRINGS), category 30 (General)"


def test_categories_of_the_maker_are_never_left_out():
    own = RawCategory(category_type=3, data=bytes(100))
    full = msgspec.structs.replace(image(), categories=(own, *image().categories))
    assert fit_image(full, 128 + 104 + 2).image.categories == (own,)
    with pytest.raises(SiiLimitError):
        fit_image(full, 128 + 104)


@settings(max_examples=40, deadline=None)
@given(
    st.sampled_from([128, 256, 384, 512, 1024]),
    st.lists(st.lists(st.integers(1, 64), max_size=6), max_size=6),
    st.booleans(),
)
def test_a_fitted_image_reads_as_a_sound_one(byte_size, lengths, assigned):
    attributes = 'Sm="0"' if assigned else ""
    content = "".join(pdo("TxPdo", f"#x{0x1A00 + n:X}", *bits, attributes=attributes) for n, bits in enumerate(lengths))
    found, dropped = fit_image(image(content), byte_size)
    data = encode_sii(found)
    assert len(data) == byte_size
    decoded = decode_sii(data)
    assert msgspec.structs.replace(decoded, findings=()) == found
    assert decoded.findings == () or not found.end_mark
    if not dropped:
        assert found.tx_pdos == image(content).tx_pdos


def test_the_text_says_what_was_left_out_and_why_to_merge():
    fitted = fit_image(image(NAMED), used(NAMED) - 1)
    text = image_text(subject(NAMED), fitted.image, dropped=fitted.dropped)
    assert text.splitlines()[0].startswith("SII image of T1 (0x00000001:0x00000001:0x00000001): ")
    assert "--merge DUMP" in text
    assert "unreachable" in text
    assert "lost" in text
    assert (
        "Left out to fit the format or the EEPROM:\n  names of entries of PDOs that no SyncManager is assigned: 2\n"
        in text
    )
    assert "gives no ConfigData" in text
    assert "2048 bytes are assumed" in text


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("<Eeprom><ByteSize>256</ByteSize><BootStrap>0011</BootStrap></Eeprom>", "BootStrap 0011 is not 8 bytes"),
        (
            "<Eeprom><BootStrap>001000010011000199</BootStrap></Eeprom>",
            "BootStrap 001000010011000199 is longer than 8 bytes",
        ),
        (
            "<Eeprom><ConfigData>0000000000000000</ConfigData></Eeprom>",
            "The description gives no usable ConfigData: the PDI words are zero. Do not write this image unmerged",
        ),
        (
            "<Mailbox><CoE/></Mailbox><Sm>Outputs</Sm>",
            "do not write this image, no master reaches them: no receive mailbox, no send mailbox.",
        ),
        (
            '<Sm ControlByte="#x26" DefaultSize="128">Mine</Sm>',
            "do not write this image, no master reaches them: no receive mailbox, no send mailbox, no protocols.",
        ),
        (
            '<Sm ControlByte="#x26" StartAddress="#x1000" DefaultSize="128" Enable="1"/>'
            '<Sm ControlByte="#x22" StartAddress="#x1080" DefaultSize="128" Enable="1"/>',
            "do not write this image, no master reaches them: no protocols.",
        ),
        (
            '<Sm ControlByte="#x26" StartAddress="#x1000"/><Mailbox><CoE/></Mailbox>',
            "Mailboxes without a usable attribute, stored as 0; do not write this image, no master reaches them: "
            "Enable of SM0, DefaultSize of SM0.",
        ),
        (
            '<Sm ControlByte="#x26"/><Sm ControlByte="#x22"/><Sm/><Sm/>'
            + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"'),
            "stored as their mode, direction and PDOs tell: SM0 MBoxOut, SM1 MBoxIn, SM2 Outputs.",
        ),
        ("<Sm/>", "SyncManagers without a code for their use, stored as unused: (empty)."),
        (
            "<Dc><OpMode><Name>a</Name><Desc>with SYNC0</Desc></OpMode></Dc>",
            "stored only in an image for a device whose own has some, as TwinCAT stores none: with SYNC0.",
        ),
        ("<Eeprom><ConfigData>" + "00" * 16 + "</ConfigData></Eeprom>", "ConfigData is 2 bytes longer"),
        (
            "<Eeprom><ConfigData>0421004401000E</ConfigData></Eeprom>",
            "ConfigData has 7 of the 8 bytes of the PDI words",
        ),
        ("<Eeprom><ByteSize>2000</ByteSize></Eeprom>", "ByteSize is stored in units of 128 bytes: 2000 as 1920."),
        ("<Eeprom><ByteSize>-5</ByteSize></Eeprom>", "ByteSize is stored in units of 128 bytes: -5 as 128."),
        (
            "<Eeprom><ConfigData>050E0</ConfigData></Eeprom>",
            "The description gives no usable ConfigData: the PDI words are zero.",
        ),
        (
            "<Eeprom><ConfigData>05 0E</ConfigData></Eeprom>",
            "correct the file: Eeprom/ConfigData '05 0E' is not hexBinary (pairs of hex digits).",
        ),
        ("<Eeprom><BootStrap>0x10</BootStrap></Eeprom>", "Eeprom/BootStrap '0x10' is not hexBinary"),
        ("<Eeprom><Data>050</Data></Eeprom>", "Eeprom/Data '050' is not hexBinary"),
        ("<Eeprom><ConfigData2>1</ConfigData2></Eeprom>", "Eeprom/ConfigData2 '1' is not hexBinary"),
        (
            "<Eeprom><Category><CatNo>9</CatNo><Data>01020</Data></Category></Eeprom>",
            "Eeprom/Category/Data '01020' is not hexBinary",
        ),
        (
            "<Eeprom><Category><CatNo>9</CatNo><DataUINT>70000</DataUINT></Category></Eeprom>",
            "data cannot be read or do not fit into their type, left out; correct the file: 9.",
        ),
        (
            '<Sm StartAddress="#x1000" ControlByte="#x24">Outputs</Sm><Sm Enable="1">Inputs</Sm>',
            "inputs: Enable of SM0, StartAddress of SM1, ControlByte of SM1.",
        ),
        *(
            (
                f"<Dc><OpMode><Name>a</Name><ShiftTime{attribute}>0</ShiftTime{attribute[:5]}></OpMode></Dc>",
                "An image has no place for: attributes of ShiftTimeSync0 and ShiftTimeSync1.",
            )
            for attribute in ('Sync0 Factor="1"', 'Sync0 Input="1"', 'Sync1 OutputDelayTime="5"')
        ),
        ("<Fmmu>Dynamic</Fmmu><Fmmu>Outputs</Fmmu>", "FMMUs without a code for their use, stored as unused: Dynamic."),
        ("<Sm>Motors</Sm>", "SyncManagers without a code for their use, stored as unused: Motors."),
        ('<Sm ControlByte="#x24" Watchdog="1">Outputs</Sm>', "the ControlByte is stored: SM0."),
        ("<ESC><Reg0410>0</Reg0410></ESC>", "An image has no place for: values of ESC registers."),
        (
            "<RxPdo><Index>#x1600</Index><Entry><Index>1</Index><BitLen>16</BitLen>"
            '<DataType SwapData="Swap_HB_LB">INT</DataType></Entry></RxPdo>',
            "An image has no place for: SwapData.",
        ),
        ("<Eeprom><ConfigData2>00</ConfigData2></Eeprom>", "An image has no place for: ConfigData2."),
        ('<RxPdo Ref="A"/>', "PDOs without index, left out: A."),
        ("<RxPdo><Name>Named</Name></RxPdo>", "PDOs without index, left out: Named."),
        (
            "<RxPdo><Index>#x1600</Index><Entry><Index>1</Index><BitLen>8</BitLen><DataType>DT1</DataType></Entry></RxPdo>",
            "Data types without a code, stored as 0: DT1.",
        ),
        (
            "<RxPdo><Index>#x1600</Index><Entry><Index>#x6064</Index><SubIndex>2</SubIndex></Entry></RxPdo>",
            "lengths of its process data are wrong: 0x6064:02 of PDO 0x1600.",
        ),
        (
            "<Dc><OpMode><Name>a</Name><VendorSpecific><T IgnoreFromBuildNo='1'/></VendorSpecific></OpMode></Dc>",
            "left out: 1 of 1.",
        ),
        ("<Eeprom><Category><CatNo>30</CatNo><Data>00</Data></Category></Eeprom>", "or none, left out: 30."),
        ("<Su/>", "sync units (category 43)"),
        ('<Fmmu Sm="2">Inputs</Fmmu>', "category 42"),
        ('<Slots><Slot MinInstances="0" MaxInstances="1"/></Slots>', "An image has no place for: PDOs of modules."),
        (pdo("RxPdo", "#x1600", 8, extra="<Exclude>#x1601</Exclude>"), "An image has no place for: Exclude."),
    ],
)
def test_remarks(content, words):
    assert words in image_text(subject(content), image(content))


@pytest.mark.parametrize(
    "content",
    [
        "<Sm Virtual='1'>Outputs</Sm>",
        '<Sm StartAddress="#x1000" ControlByte="#x24" Enable="0">Outputs</Sm>',
        '<Dc><OpMode><Name>a</Name><ShiftTimeSync0 Input="0" Factor="0">0</ShiftTimeSync0></OpMode></Dc>',
    ],
)
def test_what_is_given_or_needs_nothing_is_not_remarked(content):
    config = "<Eeprom><ByteSize>2048</ByteSize><ConfigData>0401000000000000</ConfigData></Eeprom>"
    assert eeprom_remarks(subject(content + config)) == ()


def test_all_texts_that_are_cut_are_named():
    long = "x" * 256
    mode = f"<Dc><OpMode><Name>mode {long}</Name><AssignActivate>0</AssignActivate></OpMode></Dc>"
    text = esi(device(mode, type_text=f"type {long}")).replace(">Group<", f">group {long}<")
    (described,) = subjects_of_document(read(text).document, "x.xml")
    (remark,) = (remark for remark in eeprom_remarks(described) if remark.startswith("Texts cut"))
    assert [text.split()[0] for text in remark.removeprefix("Texts cut to 255 bytes: ").split(", ")] == [
        "'type",
        "'mode",
        "'group",
    ]


@pytest.mark.parametrize("byte_size", [524289 + 127, 1 << 20, 1 << 24])
def test_an_eeprom_larger_than_the_largest_is_refused(byte_size):
    """4 MBit, 524288 bytes, is what a slave controller addresses (ESC data sheet)."""
    described = subject(f"<Eeprom><ByteSize>{byte_size}</ByteSize></Eeprom>")
    found = described_image(described)
    with pytest.raises(SiiLimitError, match=f"EEPROM of {byte_size} bytes .* the largest has 524288"):
        check_image(found, eeprom_bytes(found.header, described.device))


def test_nothing_to_remark():
    content = "<Eeprom><ByteSize>2048</ByteSize><ConfigData>0401000000000000</ConfigData></Eeprom>"
    assert "About this image" not in image_text(subject(content), image(content))


def test_codes_and_letters_that_are_missing_are_named():
    text = esi(device(product="")).replace('Physics="YY"', 'Physics="YX"')
    (described,) = subjects_of_document(read(text).document, "x.xml")
    found = image_text(described, described_image(described))
    assert "Not given, so 0: ProductCode, RevisionNo." in found
    assert "Physics letters without a code, stored as unused ports: X." in found
