"""The headers for SOEM 1.4 and 2: the hook, the clocks, the packed process image."""

import re
import struct

import pytest
from snippets import pdo
from test_export_compile import SOEM_2, SOEM_14, STUBS, check_syntax, needs_gcc, output_of
from test_export_configuration import COE, FACTOR_1, SMS, configured, dc, entry, init_cmd, rx, times
from test_export_igh import HOSTILE, ODD, as_little_endian, l6n

from esicatalog.errors import InputError
from esicatalog.export.choice import parse_pdo_choice
from esicatalog.export.pysoem import pysoem_module
from esicatalog.export.soem import VERSIONS, soem_header

CALLS = {
    "1.4": ("ec_slave[3].configadr = 0x1003;", "3", (*SOEM_14,), STUBS / "soem14" / "fake_master.c"),
    "2": (
        "static ecx_contextt c; c.slavelist[3].configadr = 0x1003;",
        "&c, 3",
        (*SOEM_2,),
        STUBS / "soem2" / "fake_master.c",
    ),
}


def calls(folder, version: str, header: str, *functions: str, options: tuple[str, ...] = ()) -> list[str]:
    """What functions of the header make SOEM do for slave 3."""
    prepare, arguments, includes, source = CALLS[version]
    body = "\n".join(f"{function}({arguments});" for function in functions)
    return output_of(folder, header, f"{prepare}\n{body}", (*includes, *options), source)


def header_of(content: str, version: str = "1.4", **choice) -> str:
    return soem_header(configured(content, name="d", **choice), version)


@needs_gcc
@pytest.mark.parametrize("version", VERSIONS)
def test_the_hook_of_the_l6n_drive(data, tmp_path, version):
    """InitCmd of PS, assignments cleared, mappings, assignments: 0x60400010 is 16 bits of 0x6040:00."""
    chosen = parse_pdo_choice("0x1601,0x1A01")
    lines = calls(tmp_path, version, soem_header(l6n(data, pdos=chosen), version), "l6n_po2so_config")
    assert lines == [
        "sdo 3 0x6060:00 08",
        "sdo 3 0x1c12:00 00",
        "sdo 3 0x1c13:00 00",
        "sdo 3 0x1601:00 00",
        "sdo 3 0x1601:01 10004060",
        "sdo 3 0x1601:02 2000ff60",
        "sdo 3 0x1601:03 08006060",
        "sdo 3 0x1601:00 03",
        "sdo 3 0x1a01:00 00",
        "sdo 3 0x1a01:01 10004160",
        "sdo 3 0x1a01:02 20006c60",
        "sdo 3 0x1a01:00 02",
        "sdo 3 0x1c12:01 0116",
        "sdo 3 0x1c12:00 01",
        "sdo 3 0x1c13:01 011a",
        "sdo 3 0x1c13:00 01",
    ]


@needs_gcc
@pytest.mark.parametrize("version", VERSIONS)
def test_the_application_sees_that_commands_of_the_hook_failed(data, tmp_path, version):
    """SOEM drops what the hook returns: 0x1601 is written five times, here for each of two slaves."""
    header = soem_header(l6n(data, pdos=parse_pdo_choice("0x1601,0x1A01")), version)
    prepare, arguments, includes, source = CALLS[version]
    hook = f"l6n_po2so_config({arguments});"
    body = f'{prepare}\n{hook}\n{hook}\nprintf("failed %d\\n", l6n_po2so_failed);'
    for refused, count in ((0x1601, 10), (0x2000, 0)):
        lines = output_of(tmp_path, header, body, (*includes, f"-DREFUSED={refused}"), source)
        assert lines[-1] == f"failed {count}"


@needs_gcc
@pytest.mark.parametrize("version", VERSIONS)
def test_a_hook_that_sends_nothing_counts_nothing(tmp_path, version):
    header = header_of(SMS + rx("#x1600", entry("#x7000", 16)), version)
    assert "failed" not in header
    assert "It has nothing to send." in header
    assert "   return 0;" in header
    check_syntax(tmp_path, [header], CALLS[version][2])


@needs_gcc
@pytest.mark.parametrize(
    ("mailbox", "attributes", "written"),
    [
        ("<CoE/>", 'Sm="2"', []),
        ('<CoE PdoAssign="1"/>', 'Sm="2"', ["0x1c12:00", "0x1c12:01", "0x1c12:00"]),
        ('<CoE PdoConfig="1"/>', 'Sm="2"', ["0x1600:00", "0x1600:01", "0x1600:00"]),
        ('<CoE PdoConfig="1"/>', 'Sm="2" Fixed="1"', []),
    ],
)
def test_only_what_the_device_declares_is_written(tmp_path, mailbox, attributes, written):
    content = SMS + pdo("RxPdo", "#x1600", 8, attributes=attributes) + f"<Mailbox>{mailbox}</Mailbox>"
    lines = calls(tmp_path, "1.4", header_of(content), "d_po2so_config")
    assert [line.split()[2] for line in lines] == written


@needs_gcc
def test_commands_on_the_pdo_configuration_are_not_sent_twice(tmp_path):
    own = init_cmd("PS", "#x1C12", "0016") + init_cmd("PS", "#x1A05", "05")
    assigned = SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')
    for coe, sent in (("<CoE>", ["0x1c12:01 0016", "0x1a05:01 05"]), ('<CoE PdoAssign="1">', ["0x1a05:01 05"])):
        content = f"{assigned}<Mailbox>{coe}{own}</CoE></Mailbox>"
        lines = calls(tmp_path, "1.4", header_of(content), "d_po2so_config")
        assert [line.removeprefix("sdo 3 ") for line in lines][: len(sent)] == sent


@needs_gcc
def test_a_long_sync0_cycle_does_not_overflow(tmp_path):
    header = header_of(SMS + dc(("m", times("#x300", 'Factor="3">0'))), cycle_ns=1_000_000_000)
    assert calls(tmp_path, "1.4", header, "d_config_dc") == ["dcsync0 3 1 3000000000 0"]


@needs_gcc
@pytest.mark.parametrize("version", VERSIONS)
def test_bits_are_what_the_device_is_checked_by(tmp_path, version):
    """SOEM sets Obytes for more than 7 bits only: of 4 bits (EL2004) it says 0 bytes, and 4 in Obits."""
    bits = [entry("#x7000", 1, f"Output {n}", n) for n in range(1, 5)]
    slave = {"1.4": "ec_slave[slave]", "2": "context->slavelist[slave]"}[version]
    header = header_of(SMS + rx("#x1600", *bits), version)
    assert "#define D_OUTPUT_BITS 4\n" in header
    assert "#define D_INPUT_BITS 0\n" in header
    assert "points to" not in header
    words = " ".join(header.replace("*", "").split())
    assert f"take {slave}.outputs as image, and as start_bit {slave}.Ostartbit." in words
    assert f"what {slave}.Obits is after the mapping" in words
    check_syntax(tmp_path, [header], CALLS[version][2])
    whole = header_of(SMS + rx("#x1600", entry("#x7000", 12)), version)
    assert "#define D_OUTPUT_BITS 12\n" in whole
    assert f"what {slave}.outputs points to." in whole
    assert "start_bit" not in whole


def test_without_all_content_nothing_says_how_many_bits_there_are():
    header = header_of(SMS + rx("#x1600", entry("#x7000", 16)) + rx("#x1601"))
    assert "OUTPUT_BITS" not in header
    assert "sizeof(d_outputs_t) == 2," in header


NOT_DESCRIBED = rx("#x1601") + rx("#x1602", entry("#x7002", 16, "behind"))


@needs_gcc
@pytest.mark.parametrize("version", VERSIONS)
def test_the_structure_ends_before_a_pdo_without_described_entries(tmp_path, version):
    """What lies behind it, in later SyncManagers of the direction too, has no known place."""
    later = "<Sm>Outputs</Sm>" + rx("#x1610", entry("#x7010", 16, "later"), attributes='Sm="4"')
    first = rx("#x1600", entry("#x7000", 16, "first"), entry("#x7000", 4, "bits", 1))
    header = header_of(SMS + later + first + NOT_DESCRIBED, version)
    assert "sizeof(d_outputs_t) == 3," in header
    assert "d_set_bits" in header
    assert "7002" not in header and "7010" not in header
    words = " ".join(header.replace("*", "").split())
    assert "PDO 0x1601 of SM2 has no described entries" in words
    assert "the structure of the outputs ends before PDO 0x1601 of SM2, which has no described entries" in words
    check_syntax(tmp_path, [header], CALLS[version][2])
    begins = header_of(SMS + later + NOT_DESCRIBED, version)
    assert "d_outputs_t" not in begins
    assert "there is no structure of the outputs: they begin with PDO 0x1601" in " ".join(begins.split())


@pytest.mark.parametrize("export", [soem_header, pysoem_module])
def test_the_structure_ends_before_a_sync_manager_with_a_size_and_no_pdo(export):
    """SM2 exchanges 16 bytes that nothing describes: where SM4 lies behind them is not known."""
    behind = "<Sm>Outputs</Sm>" + rx("#x1600", entry("#x7000", 16, "behind"), attributes='Sm="4"')
    content = SMS.replace('"#x64"', '"#x64" DefaultSize="16"') + behind
    text = " ".join(re.sub("[*#]", " ", export(configured(content, name="d"))).split())
    assert "7000" not in text
    assert "SM2 has DefaultSize 16 and no PDO: what it exchanges is not described" in text
    assert "there is no structure of the outputs: they begin with SM2, which has no PDO" in text
    sms = SMS + '<Sm DefaultSize="16">Outputs</Sm><Sm>Outputs</Sm>'
    content = rx("#x1600", entry("#x7000", 16, "first")) + rx("#x1601", entry("#x7001", 16), attributes='Sm="5"')
    text = " ".join(re.sub("[*#]", " ", export(configured(sms + content, name="d"))).split())
    assert "0x7000:00 first" in text and "7001" not in text
    assert (
        "the structure of the outputs ends before SM4, which has no PDO: the device exchanges more than it has" in text
    )


@needs_gcc
def test_the_mapping_of_samples(tmp_path):
    """Three samples of 0x7000:01, 16 bits, OSIndexInc 16."""
    content = SMS + pdo("RxPdo", "#x1600", 16, attributes='Sm="2" OSFac="3" OSIndexInc="16"') + COE
    lines = calls(tmp_path, "1.4", header_of(content), "d_po2so_config")
    assert [line for line in lines if "0x1600" in line] == [
        "sdo 3 0x1600:00 00",
        "sdo 3 0x1600:01 10010070",
        "sdo 3 0x1600:02 10011070",
        "sdo 3 0x1600:03 10012070",
        "sdo 3 0x1600:00 03",
    ]


@needs_gcc
@pytest.mark.parametrize("version", VERSIONS)
def test_other_commands(tmp_path, version):
    coe = init_cmd("IP", "#x2001", "01") + init_cmd("SO", "#x2002", "0200", 'CompleteAccess="1"')
    soe = "<SoE><InitCmd Chn='1'><Transition>PS</Transition><IDN>32</IDN><Data>0B00</Data></InitCmd></SoE>"
    watchdogs = "<ESC><Reg0400>2498</Reg0400><Reg0420>100</Reg0420></ESC>"
    content = SMS + f"<Mailbox><CoE>{coe}</CoE>{soe}</Mailbox>{watchdogs}"
    assert calls(tmp_path, version, header_of(content, version), "d_po2so_config", "d_send_so") == [
        "sdo 3 0x2001:01 01",
        "idn 3 1 0x40 0x0020 0b00",
        "register 0x1003 0x0400 c209",
        "register 0x1003 0x0420 6400",
        "sdo 3 0x2002:01 complete 0200",
    ]


@needs_gcc
@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize(
    ("mode", "printed"),
    [
        (times("#x300", FACTOR_1, shift0="-5000"), ["dcsync0 3 1 1000000 -5000"]),
        (times("#x320", FACTOR_1), ["dcsync0 3 1 1000000 0", "register 0x1003 0x0980 20"]),
        (times("#x700", FACTOR_1, FACTOR_1, shift1="20000"), ["dcsync01 3 1 1000000 20000 0"]),
        (
            times("#x730", 'Factor="-8">0', 'Factor="-1">0'),
            ["dcsync01 3 1 125000 875000 0", "register 0x1003 0x0980 30"],
        ),
        # SOEM knows neither the sync unit without pulses nor SYNC1 alone.
        (times("#x120"), ["register 0x1003 0x0980 2001"]),
        (times("#x500", FACTOR_1, FACTOR_1), ["dcsync01 3 1 1000000 0 0", "register 0x1003 0x0980 0005"]),
        (times("#x030"), ["register 0x1003 0x0980 3000"]),
    ],
)
def test_the_clocks(tmp_path, version, mode, printed):
    content = SMS + dc(("m", mode))
    assert calls(tmp_path, version, header_of(content, version), "d_config_dc") == printed


@needs_gcc
def test_the_cycle_can_be_set_when_compiling(tmp_path):
    header = header_of(SMS + dc(("m", times("#x300", FACTOR_1))))
    assert calls(tmp_path, "1.4", header, "d_config_dc", options=("-DCYCLE_NS=250000",)) == ["dcsync0 3 1 250000 0"]


@needs_gcc
def test_a_cycle_that_drifts_against_a_fixed_sync0_does_not_compile(tmp_path):
    header = header_of(SMS + dc(("m", times("#x300", ">250000"))))
    assert calls(tmp_path, "1.4", header, "d_config_dc", options=("-DCYCLE_NS=125000",)) == ["dcsync0 3 1 250000 0"]
    with pytest.raises(AssertionError, match="CYCLE_NS must be a multiple or a divisor of 250000 ns"):
        calls(tmp_path, "1.4", header, "d_config_dc", options=("-DCYCLE_NS=700000",))


@needs_gcc
def test_the_process_image(tmp_path):
    main = """
    d_outputs_t image;
    const uint8_t bits[9] = {1, 2, 3, 4, 5, 6, 7, 8, 0x3f};
    memset(&image, 0, sizeof(image));
    d_set_flag(&image, 1);
    d_set_small(&image, -5);
    d_set_nibble(&image, 0xA);
    d_set_shifted_real(&image, 1.5f);
    d_set_rest(&image, 0x5);
    image.long_real = -0.25;
    d_set_three_bytes(&image, -70000);
    memcpy(image.text, "abc", sizeof(image.text));
    d_set_one_more_bit(&image, 0);
    d_set_long_bits(&image, bits);
    for (size_t i = 0; i < sizeof(image); i++)
        printf("%02x", ((uint8_t *) &image)[i]);
    """
    (line,) = output_of(tmp_path, header_of(ODD), main, SOEM_14)
    expected = as_little_endian(
        (1, 1),
        (0, 3),
        (-5, 12),
        (0xA, 4),
        (0x3FC00000, 32),
        (5, 4),
        (int.from_bytes(struct.pack("<d", -0.25), "little"), 64),
        (-70000, 24),
        (int.from_bytes(b"abc", "little"), 24),
        (0, 1),
        (int.from_bytes(bytes([1, 2, 3, 4, 5, 6, 7, 8, 0x3F]), "little"), 70),
    )
    assert line == expected.hex()


@needs_gcc
def test_less_than_a_byte_begins_where_soem_says(tmp_path):
    content = SMS + rx("#x1600", entry("#x7000", 1, "a", 1), entry("#x7000", 2, "b", 2))
    main = """
    uint8_t image[2] = {0, 0};
    d_set_a(image, 6, 1);
    d_set_b(image, 6, 3);
    printf("%02x%02x", image[0], image[1]);
    """
    assert output_of(tmp_path, header_of(content), main, SOEM_14) == ["c001"]


def test_what_soem_would_not_map_is_told():
    sms = "<Sm>Outputs</Sm><Sm>Outputs</Sm>"
    nibbles = pdo("RxPdo", "#x1600", 4, attributes='Sm="0"') + pdo("RxPdo", "#x1601", 4, attributes='Sm="1"')
    text = header_of(sms + nibbles)
    assert "the outputs take 2 bytes in 2 SyncManagers, and SOEM maps only the 1" in " ".join(
        text.replace("*", "").split()
    )
    assert "sizeof(d_outputs_t) == 2" in text


@needs_gcc
@pytest.mark.parametrize("version", VERSIONS)
def test_names_of_a_vendor_break_nothing(tmp_path, version):
    entries = [entry("#x7000", 3 if number % 2 else 8, name, number) for number, name in enumerate(HOSTILE, 1)]
    for name in HOSTILE:
        content = SMS + rx("#x1600", *entries, name=name) + COE + dc((name, times("#x320", FACTOR_1)))
        text = header_of(content, version)
        check_syntax(tmp_path, [text], SOEM_14 if version == "1.4" else SOEM_2)


TERMINAL = (
    '<Sm StartAddress="#x0981" Virtual="1">Outputs</Sm><Sm StartAddress="#x0F00" ControlByte="#x44">Outputs</Sm>'
    + pdo("RxPdo", "#x1602", 8, attributes='Sm="0" Virtual="1"')
    + pdo("RxPdo", "#x1600", 2, attributes='Sm="1"')
)
"""As EL2252: bits of two outputs, and register 0x0981, which the SII assigns as well."""
EXCLUDED = pdo("RxPdo", "#x1603", 4, attributes='Sm="1"', extra="<Exclude>#x1600</Exclude>")


@pytest.mark.parametrize("make", [soem_header, pysoem_module])
@pytest.mark.parametrize(
    ("content", "chosen", "counted"),
    [
        (TERMINAL, "", "10 output bits (SM0 8, SM1 2) with it, not 2 output bits (SM1 2)"),
        (TERMINAL + EXCLUDED, "0x1602", "14 output bits (SM0 8, SM1 6) with it, not 10 output bits (SM0 8, SM1 2)"),
        (SMS + rx("#x1600", entry("#x7000", 8)) + rx("#x1601", entry("#x7000", 16), attributes=""), "0x1601", "8 "),
    ],
    ids=["virtual", "excluded", "not assigned by the SII"],
)
def test_what_soem_counts_otherwise_is_refused(make, content, chosen, counted):
    """Without CoE ecx_siiPDO adds up all PDOs of the SII, and outputs[0] would lie in register 0x0981."""
    choice = {"pdos": parse_pdo_choice(chosen)} if chosen else {}
    with pytest.raises(InputError, match=f"^SOEM would exchange {re.escape(counted)}"):
        make(configured(content, **choice))
    assert make(configured(content + COE)), "with CoE SOEM asks the device"


def test_all_that_soem_counts_can_be_chosen():
    found = header_of(TERMINAL, pdos=parse_pdo_choice("0x1602"))
    assert "#define D_OUTPUT_BITS 10" in found
    assert "zeros are written to 0x0981 until the application sets it" in " ".join(found.replace("\n *", "").split())
