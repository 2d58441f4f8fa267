"""The header for IgH EtherLab: what it tells the master, and where accessors read and write."""

import re
import struct

import pytest
from snippets import device, esi, pdo, read
from test_export_compile import IGH_15, IGH_16, SOEM_2, check_syntax, gcc, igh_output, needs_gcc, output_of
from test_export_configuration import COE, EMPTY, FACTOR_1, SMS, configured, dc, entry, init_cmd, rx, subject, times

from esicatalog.errors import InputError
from esicatalog.esi.reader import read_esi
from esicatalog.export.choice import Choice, parse_pdo_choice
from esicatalog.export.configuration import Configuration, configure
from esicatalog.export.headings import choice_lines
from esicatalog.export.igh import igh_bus_header, igh_header
from esicatalog.export.scan_bus import BusConfigurations
from esicatalog.export.soem import soem_header
from esicatalog.export.subject import subjects_of_document

CONFIGURE = """
    ec_slave_config_t *sc = ecrt_master_slave_config(NULL, D_ALIAS, D_POSITION, D_VENDOR_ID, D_PRODUCT_CODE);
    printf("config %d\\n", d_config(sc));
"""
REGISTER = 'printf("registered %d\\n", ecrt_domain_reg_pdo_entry_list(NULL, d_domain_regs));'


def l6n(data, **choice) -> Configuration:
    (found,) = subjects_of_document(read_esi(data / "l6n_drive.xml").document, "l6n_drive.xml")
    return configure(found, Choice(**choice))


def header_of(content: str, **choice) -> str:
    return igh_header(configured(content, name="d", **choice))


def test_the_worked_example_of_the_l6n_drive(data):
    """Three RxPDO entries and seven of nine TxPDO entries, with the watchdog left alone."""
    chosen = parse_pdo_choice("0x1600,0x1A00=0x603F+0x6041+0x6061+0x6064+0x60B9+0x60BA+0x60FD")
    text = igh_header(l6n(data, pdos=chosen))
    rows = [line.split(" /*")[0].strip() for line in text.splitlines() if re.match(r"    \{(0x|[0-4], EC)", line)]
    assert rows == [
        "{0x6040, 0x00, 16},",
        "{0x607a, 0x00, 32},",
        "{0x60b8, 0x00, 16},",
        "{0x603f, 0x00, 16},",
        "{0x6041, 0x00, 16},",
        "{0x6061, 0x00, 8},",
        "{0x6064, 0x00, 32},",
        "{0x60b9, 0x00, 16},",
        "{0x60ba, 0x00, 32},",
        "{0x60fd, 0x00, 32},",
        "{0x1600, 3, l6n_pdo_entries + 0},",
        "{0x1a00, 7, l6n_pdo_entries + 3},",
        "{0, EC_DIR_OUTPUT, 0, NULL, EC_WD_DEFAULT},",
        "{1, EC_DIR_INPUT, 0, NULL, EC_WD_DEFAULT},",
        "{2, EC_DIR_OUTPUT, 1, l6n_pdos + 0, EC_WD_DEFAULT},",
        "{3, EC_DIR_INPUT, 1, l6n_pdos + 1, EC_WD_DEFAULT},",
        "{0xff, EC_DIR_INVALID, 0, NULL, EC_WD_DEFAULT}",
    ]
    for line in ("L6N_VENDOR_ID 0x00004321", "L6N_PRODUCT_CODE 0x000000e2", "L6N_REVISION_NO 0x00000001"):
        assert f"#define {line}\n" in text
    assert "#define L6N_SM2_BYTES 8\n" in text
    assert "#define L6N_SM3_BYTES 19\n" in text
    assert "EC_WD_DISABLE" not in text
    assert "ControlByte 0x64: watchdog trigger on" in text


@needs_gcc
def test_the_l6n_header_places_entries_as_the_master_does(data, tmp_path):
    main = """
    uint8_t image[64] = {0};
    ec_slave_config_t *sc = ecrt_master_slave_config(NULL, L6N_ALIAS, L6N_POSITION, L6N_VENDOR_ID, L6N_PRODUCT_CODE);
    l6n_config(sc);
    l6n_config_dc(sc);
    ecrt_domain_reg_pdo_entry_list(NULL, l6n_domain_regs);
    l6n_write_target_position(image, &l6n_offsets, -2);
    for (int i = 0; i < 8; i++)
        printf("%02x", image[i]);
    image[8 + 5] = 0x01; image[8 + 6] = 0x02; image[8 + 8] = 0x80;
    printf(" %d\\n", l6n_read_position_actual_value(image, &l6n_offsets));
    """
    lines = igh_output(tmp_path, igh_header(l6n(data, op_mode="DC", alias=5, position=2)), main)
    assert lines == [
        "slave 5 2 0x00004321 0x000000e2",
        "sm 0 dir 1 pdos 0 watchdog 0",
        "sm 1 dir 2 pdos 0 watchdog 0",
        "sm 2 dir 1 pdos 1 watchdog 0",
        "sm 3 dir 2 pdos 1 watchdog 0",
        "timeout 1 2 3000",
        "timeout 2 4 10000",
        "timeout 4 8 10000",
        "timeout 2 1 5000",
        "timeout 4 1 5000",
        "timeout 8 1 5000",
        "timeout 4 2 5000",
        "timeout 8 4 200",
        "sdo 0x6060:00 08",
        "dc 0x0300 1000000 0 0 0",
        "entry 0x6040:00 byte 0 bit 0",
        "entry 0x607a:00 byte 2 bit 0",
        "entry 0x60b8:00 byte 6 bit 0",
        "entry 0x603f:00 byte 8 bit 0",
        "entry 0x6041:00 byte 10 bit 0",
        "entry 0x6061:00 byte 12 bit 0",
        "entry 0x6064:00 byte 13 bit 0",
        "entry 0x60b9:00 byte 17 bit 0",
        "entry 0x60ba:00 byte 19 bit 0",
        "entry 0x60fd:00 byte 23 bit 0",
        "entry 0x6077:00 byte 27 bit 0",
        "entry 0x60f4:00 byte 29 bit 0",
        # -2 little-endian at byte 2; 0x80000201 read as a signed number
        f"0000feffffff0000 {struct.unpack('<i', bytes([1, 2, 0, 0x80]))[0]}",
    ]


GAP_3 = "<Entry><Index>0</Index><BitLen>3</BitLen></Entry>"
ODD = SMS + rx(
    "#x1600",
    entry("#x7000", 1, "flag", 1, "BOOL"),
    GAP_3,
    entry("#x7000", 12, "small", 2, "INT"),
    entry("#x7000", 4, "nibble", 3, "BIT4"),
    entry("#x7000", 32, "shifted real", 4, "REAL"),
    entry("#x7000", 4, "rest", 5, "BIT4"),
    entry("#x7000", 64, "long real", 6, "LREAL"),
    entry("#x7000", 24, "three bytes", 7, "INT24"),
    entry("#x7000", 24, "text", 8, "STRING(3)"),
    entry("#x7000", 1, "one more bit", 9, "BOOL"),
    entry("#x7000", 70, "long bits", 10),
)


def as_little_endian(*fields: tuple[int, int]) -> bytes:
    """Fields (value, bits) packed from the lowest bit on."""
    total, at = 0, 0
    for value, bits in fields:
        total |= (value & ((1 << bits) - 1)) << at
        at += bits
    return total.to_bytes((at + 7) // 8, "little")


@needs_gcc
def test_accessors_of_values_that_do_not_fill_bytes(tmp_path):
    main = f"""
    uint8_t image[64] = {{0}};
    const uint8_t bits[9] = {{1, 2, 3, 4, 5, 6, 7, 8, 0x3f}};
    {CONFIGURE}
    {REGISTER}
    d_write_flag(image, &d_offsets, 1);
    d_write_small(image, &d_offsets, -5);
    d_write_nibble(image, &d_offsets, 0xA);
    d_write_shifted_real(image, &d_offsets, 1.5f);
    d_write_rest(image, &d_offsets, 0x5);
    d_write_long_real(image, &d_offsets, -0.25);
    d_write_three_bytes(image, &d_offsets, -70000);
    memcpy(d_data_text(image, &d_offsets), "abc", D_TEXT_SIZE);
    d_write_one_more_bit(image, &d_offsets, 0);
    d_write_long_bits(image, &d_offsets, bits);
    for (int i = 0; i < D_SM2_BYTES; i++)
        printf("%02x", image[i]);
    printf("\\n");
    """
    lines = igh_output(tmp_path, header_of(ODD), main)
    (real,), (long_real,) = struct.unpack("<I", struct.pack("<f", 1.5)), struct.unpack("<Q", struct.pack("<d", -0.25))
    expected = as_little_endian(
        (1, 1),
        (0, 3),
        (-5, 12),
        (0xA, 4),
        (real, 32),
        (5, 4),
        (long_real, 64),
        (-70000, 24),
        (int.from_bytes(b"abc", "little"), 24),
        (0, 1),
        (int.from_bytes(bytes([1, 2, 3, 4, 5, 6, 7, 8, 0x3F]), "little"), 70),
    )
    assert lines[-1] == expected.hex()
    assert "config 0" in lines
    assert "registered 0" in lines
    assert "entry 0x7000:02 byte 0 bit 4" in lines
    assert "entry 0x7000:04 byte 2 bit 4" in lines
    assert "entry 0x7000:08 byte 18 bit 0" in lines


@needs_gcc
def test_inputs_are_read_where_outputs_would_be_written(tmp_path):
    content = ODD.replace("RxPdo", "TxPdo").replace('Sm="2"', 'Sm="3"').replace("#x1600", "#x1A00")
    image = as_little_endian((1, 1), (0, 3), (-5, 12), (0xA, 4), (0x3FC00000, 32), (5, 4), (0, 64), (-70000, 24))
    data = ", ".join(str(byte) for byte in image + b"xyz" + b"\x03")
    main = f"""
    const uint8_t image[64] = {{{data}}};
    uint8_t bits[9];
    {CONFIGURE}
    {REGISTER}
    d_read_long_bits(image, &d_offsets, bits);
    printf("%u %d %u %.1f %u %d %.3s %u %u\\n", d_read_flag(image, &d_offsets), d_read_small(image, &d_offsets),
        d_read_nibble(image, &d_offsets), (double) d_read_shifted_real(image, &d_offsets),
        d_read_rest(image, &d_offsets), d_read_three_bytes(image, &d_offsets),
        (const char *) d_data_text(image, &d_offsets), d_read_one_more_bit(image, &d_offsets), bits[0]);
    """
    assert igh_output(tmp_path, header_of(content), main)[-1] == "1 -5 10 1.5 5 -70000 xyz 1 1"


@needs_gcc
def test_entries_that_repeat_are_registered_by_place(tmp_path):
    content = (
        SMS
        + pdo("RxPdo", "#x1600", 16, attributes='Sm="2"')
        + pdo("RxPdo", "#x1601", 4, attributes='Sm="2"')
        + pdo("TxPdo", "#x1A00", 16, attributes='Sm="3"')
    )
    main = f"""
    {CONFIGURE}
    {REGISTER}
    printf("repeated %d\\n", d_register_repeated(sc, NULL, &d_offsets));
    printf("%u %u.%u %u\\n", d_offsets.rx_pdo_x1600_e1, d_offsets.rx_pdo_x1601_e1,
        d_offsets.rx_pdo_x1601_e1_bit_position, d_offsets.tx_pdo_x1a00_e1);
    """
    lines = igh_output(tmp_path, header_of(content), main)
    assert [line for line in lines if line.startswith("entry")] == ["entry 0x7000:01 byte 0 bit 0"]
    assert lines[-2:] == ["repeated 0", "0 2.0 3"]


@needs_gcc
def test_an_entry_of_no_bits_is_mapped_and_not_registered(tmp_path):
    """The master takes it as it is (ecrt_slave_config_pdo_mapping_add), and finds the mapping of the device equal."""
    lines = igh_output(tmp_path, header_of(EMPTY), f"{CONFIGURE}\n{REGISTER}")
    assert [line for line in lines if line.startswith("entry")] == [
        "entry 0x7000:01 byte 0 bit 0",
        "entry 0x7000:11 byte 2 bit 0",
    ]
    assert "{0x7000, 0x02, 0}, /* none */" in header_of(EMPTY)


def test_an_entry_behind_one_of_no_bits_with_its_index_is_registered_by_place():
    """The master's search by index ends at the first."""
    text = header_of(SMS + rx("#x1600", entry("#x7000", 0, "none", 1), entry("#x6041", 16), entry("#x7000", 8, "v", 1)))
    assert "ecrt_slave_config_reg_pdo_entry_pos(sc, 2, 0, 2," in text


@needs_gcc
def test_samples_are_registered_by_their_own_index(tmp_path):
    """0x7000:01 in three samples with OSIndexInc 16, one behind the other."""
    content = SMS + pdo("RxPdo", "#x1600", 16, attributes='Sm="2" OSFac="3" OSIndexInc="16"')
    text = header_of(content)
    assert "d_register_repeated" not in text
    lines = igh_output(tmp_path, text, f"{CONFIGURE}\n{REGISTER}")
    assert [line for line in lines if line.startswith("entry")] == [
        "entry 0x7000:01 byte 0 bit 0",
        "entry 0x7010:01 byte 2 bit 0",
        "entry 0x7020:01 byte 4 bit 0",
    ]


def test_a_virtual_sync_manager_is_not_told_to_the_master():
    content = SMS + '<Sm Virtual="1">MBoxIn</Sm>' + pdo("RxPdo", "#x1600", 16, attributes='Sm="2"')
    text = header_of(content)
    assert "SM3" in text and "SM4" not in text


@needs_gcc
def test_start_up_commands(tmp_path):
    soe = (
        "<SoE><InitCmd Chn='1'><Transition>SO</Transition><IDN>32</IDN><Data>0B00</Data></InitCmd>"
        "<InitCmd><Transition>SP</Transition><IDN>33</IDN><Data>01</Data></InitCmd></SoE>"
    )
    coe = "".join(
        (
            init_cmd("PS", "#x2001", "0102"),
            init_cmd("IP", "#x2002", "03"),
            init_cmd("PS", "#x1C12", "04"),
            init_cmd("PS", "#x1A01", "05"),
            init_cmd("PS", "#x2003", "06", 'CompleteAccess="1"'),
            init_cmd("PS", "#x2004", "0700", 'CompleteAccess="1"').replace("<SubIndex>1", "<SubIndex>0"),
            init_cmd("SO", "#x2005", "08"),
            init_cmd("OP", "#x2006", "0900", 'CompleteAccess="1"').replace("<SubIndex>1", "<SubIndex>0"),
            init_cmd("SP", "#x1C13", "0A"),
        )
    )
    mapped = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + pdo("TxPdo", "#x1A01", 8, attributes='Sm="3"')
    watchdog = "<ESC><Reg0400>2498</Reg0400><Reg0420>100</Reg0420></ESC>"
    content = f"{SMS}{mapped}<Mailbox><CoE>{coe}</CoE>{soe}</Mailbox>{watchdog}"
    text = header_of(content)
    lines = igh_output(tmp_path, text, f"{CONFIGURE} d_send_so(NULL, 3); d_send_sp(NULL, 4); d_send_op(NULL, 5);")
    assert [line for line in lines if not line.startswith(("slave", "sm "))] == [
        "watchdog 2498 100",
        "sdo 0x2002:01 03",
        "sdo 0x2001:01 0102",
        "complete sdo 0x2004 0700",
        "idn 1 0x0020 state 4 0b00",
        "config 0",
        "download 3 0x2005:01 08",
        "write idn 4 0 0x0021 01",
        "complete download 5 0x2006 0900",
    ]
    assert text.count("left out, ecrt_slave_config_pdos() writes PDO assignment and mapping") == 3
    why = "IgH sends complete access from subindex 0 only, and this begins at 1"
    assert f"/* PS 0x2003: left out, {why} */" in text
    assert f" * - PS 0x2003 is left out: {why}\n" in text


@needs_gcc
def test_commands_on_pdos_that_the_master_does_not_write_are_sent(tmp_path):
    """SM2 has a PDO without described entries, so the tables leave it out; 0x1A05 is assigned nowhere."""
    commands = "".join(init_cmd("PS", f"#x{index}", "01") for index in ("1C12", "1600", "1A05", "1C13", "1A00"))
    mapped = rx("#x1600") + pdo("TxPdo", "#x1A00", 8, attributes='Sm="3"')
    text = header_of(f"{SMS}{mapped}<Mailbox><CoE>{commands}</CoE></Mailbox>")
    sent = [line for line in igh_output(tmp_path, text, CONFIGURE) if line.startswith("sdo")]
    assert sent == ["sdo 0x1c12:01 01", "sdo 0x1600:01 01", "sdo 0x1a05:01 01"]
    assert text.count("left out, ecrt_slave_config_pdos() writes PDO assignment and mapping") == 2


@needs_gcc
@pytest.mark.parametrize(
    ("mode", "options", "printed"),
    [
        (times("#x320", FACTOR_1, shift0="-5000"), (), "dc 0x0320 1000000 -5000 0 0"),
        (times("#x700", FACTOR_1, FACTOR_1, shift1="20000"), (), "dc 0x0700 1000000 0 20000 0"),
        (times("#x730", 'Factor="-8">0', 'Factor="-1">0'), ("-DCYCLE_NS=2000000",), "dc 0x0730 250000 0 1750000 0"),
        (times("#x700", 'Factor="3">0', 'Factor="1">0'), ("-DCYCLE_NS=1000000000",), "dc 0x0700 3000000000 0 0 0"),
        (times("#x700", 'Factor="2">0', shift1="20000"), ("-DCYCLE_NS=2147483000",), "dc 0x0700 4294966000 0 20000 0"),
        (times("#x700", FACTOR_1, ">4000000"), ("-DCYCLE_NS=2000000",), "dc 0x0700 2000000 0 2000000 0"),
        (times("#x100"), (), "dc 0x0100 0 0 0 0"),
        (times("#x630", FACTOR_1), (), "dc 0x0630 0 0 0 0"),
    ],
)
def test_the_clocks_as_the_master_gets_them(tmp_path, mode, options, printed):
    header = header_of(SMS + dc(("m", mode)))
    sources = (IGH_16[1] + "/fake_master.c",)
    lines = output_of(tmp_path, header, f"{CONFIGURE} d_config_dc(sc);", (*IGH_16, *options), *sources)
    assert lines[-1] == printed


@needs_gcc
@pytest.mark.parametrize("name", ["typeof", "asm", "inline", "typeof_unqual", "linux", "char8_t", "restrict"])
def test_a_name_that_is_a_keyword_compiles(tmp_path, name):
    header = header_of(SMS + rx("#x1600", entry("#x7000", 16, name)))
    for standard in ("gnu11", "gnu17", "gnu2x"):
        check_syntax(tmp_path, [header], IGH_16, f"-std={standard}")


@needs_gcc
def test_a_cycle_that_cannot_be_divided_does_not_compile(tmp_path):
    header = header_of(SMS + dc(("os", times("#x730", 'Factor="-8">0', 'Factor="-1">0'))))
    with pytest.raises(AssertionError, match="CYCLE_NS must be a multiple of 8 ns"):
        check_syntax(tmp_path, [header], IGH_16, "-DCYCLE_NS=1000001")


@needs_gcc
def test_a_cycle_that_drifts_against_a_fixed_sync0_does_not_compile(tmp_path):
    """The header has the cycle though no time follows it: what is compiled otherwise is compared all the same."""
    header = header_of(SMS + dc(("m", times("#x300", ">250000"))))
    for option in ((), ("-DCYCLE_NS=250000",), ("-DCYCLE_NS=125000",)):
        check_syntax(tmp_path, [header], IGH_16, *option)
    with pytest.raises(AssertionError, match="CYCLE_NS must be a multiple or a divisor of 250000 ns"):
        check_syntax(tmp_path, [header], IGH_16, "-DCYCLE_NS=700000")


@needs_gcc
def test_a_cycle_at_which_a_slower_sync1_does_not_follow_sync0_does_not_compile(tmp_path):
    """At 1 ms SYNC1, once in a bus cycle, is faster than SYNC0 and follows it; at 6 ms it would come 3 ms later."""
    content = SMS + dc(("m", times("#x700", ">3000000", 'Factor="-1">0')))
    usual, longer = header_of(content), header_of(content, cycle_ns=6_000_000)
    for header, fits_not in ((usual, 6_000_000), (longer, 1_500_000)):
        # Where both are as long, both headers say 0.
        check_syntax(tmp_path, [header], IGH_16, "-DCYCLE_NS=3000000")
        with pytest.raises(AssertionError, match="the SYNC0 cycle at this CYCLE_NS"):
            check_syntax(tmp_path, [header], IGH_16, f"-DCYCLE_NS={fits_not}")


@needs_gcc
def test_a_cycle_of_which_a_fixed_sync1_is_no_multiple_does_not_compile(tmp_path):
    """SYNC1 every 4 ms: at 1.5 ms it would come every 3 ms, whatever the delay says."""
    header = header_of(SMS + dc(("m", times("#x700", FACTOR_1, ">4000000"))))
    check_syntax(tmp_path, [header], IGH_16, "-DCYCLE_NS=2000000")
    with pytest.raises(AssertionError, match="SYNC1 is described at no multiple of the SYNC0 cycle at this CYCLE_NS"):
        check_syntax(tmp_path, [header], IGH_16, "-DCYCLE_NS=1500000")


def test_the_cycle_of_the_option_is_the_default_of_the_header():
    text = header_of(SMS + dc(("m", times("#x300", FACTOR_1))), cycle_ns=500_000)
    assert "#ifndef CYCLE_NS\n#define CYCLE_NS 500000\n" in text


def test_without_clocks_there_is_no_call_and_no_cycle():
    text = header_of(SMS + dc(("free", times("0", FACTOR_1))))
    assert "ecrt_slave_config_dc" not in text
    assert "CYCLE_NS" not in text


def test_only_what_is_known_for_a_mailbox_is_told_to_the_master_without_pdos():
    """A word of the vendor's that begins like one says nothing: an empty assignment might be written there."""
    text = header_of("<Sm>MBoxOut</Sm><Sm>MBoxState</Sm><Sm>Outputs</Sm>" + rx("#x1600", entry("#x7000", 16, "a")))
    assert "{0, EC_DIR_OUTPUT, 0, NULL, EC_WD_DEFAULT}" in text
    assert "{1, EC_DIR" not in text
    assert "SM1 MBoxState, ControlByte not described: no PDO is assigned; left out" in text


def test_a_sync_manager_whose_content_is_unknown_is_left_to_the_device():
    empty = "<TxPdo Sm='3'><Index>#x1A00</Index><Name>T</Name></TxPdo>"
    text = header_of(
        SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + empty + pdo("TxPdo", "#x1A01", 8, attributes='Sm="3"')
    )
    assert "{2, EC_DIR_OUTPUT, 1, d_pdos + 0, EC_WD_DEFAULT}" in text
    assert "{3," not in text
    assert "SM3 Inputs, ControlByte 0x20: watchdog trigger off: entries of its PDOs are not described; left out" in text


@needs_gcc
def test_entries_behind_a_pdo_without_described_entries_are_found_by_the_master_bit_by_bit(tmp_path):
    """Nothing tells whether they begin on a byte, so the bit that the master registers counts."""
    behind = rx("#x1601", entry("#x7000", 1, "flag", 1, "BOOL"), entry("#x7000", 16, "word", 2, "UINT"))
    text = header_of(SMS + rx("#x1600") + behind)
    assert "unsigned int word; /* 0x7000:02, 16 bits, SM2, place not known */" in text
    assert "&d_offsets.word, &d_offsets.word_bit_position}" in text
    assert "esicatalog_write_bits(data + offsets->word, offsets->word_bit_position, 16," in text
    assert "PDO 0x1600 of SM2 has no described entries" in text
    check_syntax(tmp_path, [text], IGH_16)


def test_what_the_structures_cannot_hold():
    long = SMS + rx("#x1600", entry("#x7000", 256, "block", 1))
    assert re.findall(r"\{0x7000, 0x01, (\d+)\}", header_of(long)) == ["248", "8"]
    with pytest.raises(InputError, match="0x7000:01 of PDO 0x1600 has 256 bits"):
        header_of(long + COE)
    with pytest.raises(InputError, match="SM16; IgH knows SM0 to SM15"):
        header_of("<Sm>Outputs</Sm>" * 17 + pdo("RxPdo", "#x1600", 8, attributes='Sm="16"'))


@needs_gcc
def test_long_entries_keep_their_place(tmp_path):
    content = SMS + rx("#x1600", entry("#x7000", 600, "block", 1), entry("#x7001", 8, "after"))
    main = f'{CONFIGURE} {REGISTER} printf("%d %d\\n", D_BLOCK_SIZE, D_SM2_BYTES);'
    lines = igh_output(tmp_path, header_of(content), main)
    assert "entry 0x7000:01 byte 0 bit 0" in lines
    assert "entry 0x7001:00 byte 75 bit 0" in lines
    assert lines[-1] == "75 76"


HOSTILE = (
    "*/ int injected; /*",
    'x " y \\',
    "??/ trigraph ??/",
    "line&#10;#error broken",
    "&#x202E;reversed",
    "&#x2028;separator",
    "*&#x200B;/ int hidden;",
    "int",
    "&lt;/&gt;",
)


@needs_gcc
@pytest.mark.parametrize("options", [IGH_15, IGH_16], ids=["1.5", "1.6"])
@pytest.mark.parametrize("standard", ["-std=gnu11", "-std=c11"])
def test_names_of_a_vendor_break_nothing(tmp_path, options, standard):
    entries = [entry("#x7000", 8, name, number) for number, name in enumerate(HOSTILE, 1)]
    for number, name in enumerate(HOSTILE):
        command = init_cmd("PS", "#x2000", "01").replace("</InitCmd>", f"<Comment>{name}</Comment></InitCmd>")
        content = (
            SMS
            + rx("#x1600", *entries, name=name)
            + f"<Mailbox><CoE>{command}</CoE></Mailbox>"
            + dc((name, times("#x300", FACTOR_1)))
        )
        document = esi(device(content, type_text=name, name=name), vendor=f"<Id>1</Id><Name>{name}</Name>")
        (found,) = subjects_of_document(read(document).document, f"{number}*/.xml")
        text = igh_header(configure(found))
        assert text.isascii() or all(char.isprintable() or char == "\n" for char in text)
        check_syntax(tmp_path, [text], options, standard)


def test_op_modes_that_newer_tools_ignore_are_listed_apart():
    """EL1262-0050 has 13 of them before and behind others."""
    old = "<VendorSpecific><TwinCAT IgnoreFromBuildNo='2200'/></VendorSpecific>"
    modes = dc(("A", times("0") + old), ("B", times("0")), ("C", times("0") + old), ("D", times("0")))
    assert list(choice_lines(configured(SMS + modes, op_mode="B"))) == [
        "OpMode:   1 'B': no distributed clocks",
        "          others: 3 'D'",
        "          ignored by newer tools: 0 'A', 2 'C'",
    ]


def test_the_heading_says_where_everything_comes_from(data):
    found = l6n(data, op_mode="1")
    text = igh_header(found._replace(subject=found.subject.standing_in("asked for revision 7")))
    head = text.partition("*/")[0]
    for words in (
        "vendor 0x00004321 (L6N vendor (example))",
        "product 0x000000e2, revision 0x00000001",
        "l6n_drive.xml, line 22",
        "1 'DC': AssignActivate 0x0300, SYNC0",
        "others: 0 'Synchron'",
        "0x1600",
        "NOT EXACT, accepted on request: asked for revision 7",
        "its target must be set to its actual position",
    ):
        assert words in head
    assert not re.search(r"0x000[67F]\b", text.partition("*/")[2]), "no controlword value that could enable"


def test_only_what_moves_has_the_warning(data):
    terminal = subjects_of_document(read_esi(data / "io_terminal_8di_8do.xml").document, "io.xml")[0]
    assert "Something may move" not in igh_header(configure(terminal))
    assert "Something may move" in igh_header(l6n(data))


def bus(data) -> list[Configuration]:
    """Two equal terminals and a drive."""
    terminal = subjects_of_document(read_esi(data / "io_terminal_8di_8do.xml").document, "io.xml")[0]
    places = [configure(terminal, Choice(position=0)), configure(terminal, Choice(position=2))]
    return [places[0], l6n(data, position=1), places[1]]


@needs_gcc
def test_a_bus_in_one_header(data, tmp_path):
    text = igh_bus_header(BusConfigurations(bus(data), ["position 3: 0x1:0x2 is unknown"], []))
    assert "- position 3: 0x1:0x2 is unknown" in text
    assert text.count("static ec_sync_info_t ") == 2, "equal devices share their tables"
    assert re.findall(r"#define (\w+_POSITION) (\d)", text) == [
        ("ECX_D808_0_POSITION", "0"),
        ("L6N_1_POSITION", "1"),
        ("ECX_D808_2_POSITION", "2"),
    ]
    main = """
    ecx_d808_config(ecrt_master_slave_config(NULL, 0, ECX_D808_2_POSITION, ECX_D808_VENDOR_ID, ECX_D808_PRODUCT_CODE));
    printf("%d\\n", ecrt_domain_reg_pdo_entry_list(NULL, ecx_d808_2_domain_regs));
    printf("%u\\n", ecx_d808_2_offsets.do_channel_8_output_bit_position);
    """
    lines = igh_output(tmp_path, text, main)
    assert lines[0] == "slave 0 2 0x00000e5c 0x0d080808"
    assert lines[-2:] == ["0", "7"]


@needs_gcc
def test_a_name_begins_all_names_of_a_bus(data, tmp_path):
    """So headers of two buses go into one program; the cycle and the helpers for bits are common to all headers."""
    headers = [igh_bus_header(BusConfigurations(bus(data), [], []), name) for name in ("left", "Right")]
    check_syntax(tmp_path, headers, IGH_16)
    left = set(re.findall(r"#define (\w+)", headers[0])) - {"CYCLE_NS", "ESICATALOG_BITS", "_Static_assert"}
    assert {"LEFT_H", "LEFT_L6N_VENDOR_ID", "LEFT_L6N_1_POSITION", "LEFT_ECX_D808_2_POSITION"} < left
    assert [name for name in left if not name.startswith("LEFT_")] == []
    assert "static inline int right_l6n_config(ec_slave_config_t *sc)\n" in headers[1]
    assert "static right_l6n_offsets_t right_l6n_1_offsets;\n" in headers[1]
    with pytest.raises(InputError, match="'a b' cannot begin names"):
        igh_bus_header(BusConfigurations(bus(data), [], []), "a b")


def test_a_bus_that_cannot_be():
    with pytest.raises(InputError, match="no slave of the bus"):
        igh_bus_header(BusConfigurations([], [], []))
    one = configured(SMS)
    with pytest.raises(InputError, match="two slaves stand at alias 0, position 0"):
        igh_bus_header(BusConfigurations([one, one], [], []))


@needs_gcc
def test_equal_types_of_different_devices_on_a_bus(tmp_path):
    first = configure(subject(SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')), Choice(position=0))
    second = configure(subject(SMS + pdo("RxPdo", "#x1600", 16, attributes='Sm="2"')), Choice(position=1))
    check_syntax(tmp_path, [igh_bus_header(BusConfigurations([first, second], [], []))], IGH_16)


TYPES_OF_C = [f"{sign}int{bits}_t" for sign in ("u", "") for bits in (8, 16, 32, 64)]


@needs_gcc
@pytest.mark.parametrize(("export", "options"), [(igh_header, IGH_16), (soem_header, SOEM_2)])
def test_headers_are_also_cpp(data, tmp_path, export, options):
    """Where members of a C++ class use a type, none of them may be called like it."""
    named = [entry("#x7000", 8, name, number, "USINT") for number, name in enumerate(TYPES_OF_C, 1)]
    for number, found in enumerate((l6n(data, op_mode="DC"), configured(SMS + rx("#x1600", *named), name="d"))):
        (tmp_path / f"h{number}.h").write_text(export(found))
    unit = tmp_path / "unit.cpp"
    unit.write_text('#include "h0.h"\n#include "h1.h"\n')
    flags = ("-x", "c++", "-std=c++11", "-Wall", "-Wextra", "-Werror", "-Wno-unused-variable", "-Wno-unused-function")
    gcc(*flags, "-fsyntax-only", *options, unit)
