"""ethercat-conf.xml for the generic driver of LinuxCNC-Ethercat, read as its lcec_conf reads it."""

import re
from xml.etree import ElementTree

import pytest
from snippets import pdo
from test_export_compile import configurations
from test_export_configuration import COE, EMPTY, FACTOR_1, SMS, configured, dc, entry, init_cmd, rx, times
from test_export_igh import HOSTILE, l6n

from esicatalog.errors import InputError
from esicatalog.export.linuxcnc import linuxcnc_configuration

HEX2, HEX4, HEX8 = (re.compile(f"[0-9a-f]{{{count}}}") for count in (2, 4, 8))
DECIMAL, TIME = re.compile("-?[0-9]+"), re.compile(r"(\*[1-9][0-9]*|[0-9]+)")
HAL_TYPES = re.compile("bit|s32|u32|float-ieee|float-double-ieee")
ANY = re.compile(".+")
ALLOWED = {
    "masters": ({}, {"master"}),
    "master": ({"idx": DECIMAL, "appTimePeriod": DECIMAL, "refClockSyncCycles": DECIMAL}, {"slave"}),
    "slave": (
        {"idx": DECIMAL, "type": re.compile("generic"), "vid": HEX8, "pid": HEX8, "configPdos": ANY, "name": ANY},
        {"dcConf", "watchdog", "sdoConfig", "syncManager"},
    ),
    "dcConf": (
        {
            "assignActivate": re.compile("[0-9a-f]{1,4}"),
            "sync0Cycle": TIME,
            "sync0Shift": DECIMAL,
            "sync1Cycle": TIME,
            "sync1Shift": DECIMAL,
        },
        set(),
    ),
    "watchdog": ({"divider": DECIMAL, "intervals": DECIMAL}, set()),
    "sdoConfig": ({"idx": HEX4, "subIdx": re.compile("[0-9a-f]{2}|complete")}, {"sdoDataRaw"}),
    "sdoDataRaw": ({"data": re.compile("[0-9a-f]{2}( [0-9a-f]{2})*")}, set()),
    "syncManager": ({"idx": DECIMAL, "dir": re.compile("in|out")}, {"pdo"}),
    "pdo": ({"idx": HEX4}, {"pdoEntry"}),
    "pdoEntry": (
        {
            "idx": HEX4,
            "subIdx": HEX2,
            "bitLen": DECIMAL,
            "halPin": ANY,
            "halType": re.compile(HAL_TYPES.pattern + "|complex"),
        },
        {"complexEntry"},
    ),
    "complexEntry": ({"bitLen": DECIMAL, "halPin": ANY, "halType": HAL_TYPES}, set()),
}
OPTIONAL = {"sync1Cycle", "sync1Shift", "halPin", "halType"}
HAL_NAME_LEN = 47


def check(element: ElementTree.Element) -> None:
    attributes, children = ALLOWED[element.tag]
    # The parser of a slave must know its type before it takes configPdos.
    assert list(element.attrib) == [name for name in attributes if name in element.attrib]
    assert set(attributes) - set(element.keys()) <= OPTIONAL
    for name, value in element.items():
        assert attributes[name].fullmatch(value), (name, value)
    for child in element:
        assert child.tag in children
        check(child)


def slave_in(text: str) -> ElementTree.Element:
    """The slave, after checking every attribute and the limits of the parser and of HAL."""
    root = ElementTree.fromstring(text.encode())
    assert root.tag == "masters"
    check(root)
    (slave,) = root.iter("slave")
    pins = [element.get("halPin") for element in slave.iter() if element.get("halPin")]
    assert len(pins) == len(set(pins)) <= 256
    assert all(len(f"lcec.0.{slave.get('name')}.{pin}") <= HAL_NAME_LEN for pin in pins)
    for element in slave.iter("pdoEntry"):
        bits, kind = int(element.get("bitLen", "0")), element.get("halType")
        assert 0 < bits <= 255
        assert (kind == "complex") == bool(len(element))
        assert (element.get("halPin") is None) == (kind in (None, "complex"))
        assert kind not in ("u32", "s32", "bit") or bits <= 32
        assert sum(int(part.get("bitLen", "0")) for part in element) == (bits if kind == "complex" else 0)
    return slave


def slave_of(content: str, **choice) -> ElementTree.Element:
    return slave_in(linuxcnc_configuration(configured(content, name="d", **choice)))


def pins_of(slave: ElementTree.Element) -> list[tuple[str | None, str | None, str | None]]:
    return [
        (element.get("halPin"), element.get("halType"), element.get("bitLen"))
        for element in slave.iter()
        if element.tag in ("pdoEntry", "complexEntry")
    ]


def test_the_l6n_drive(data):
    text = linuxcnc_configuration(l6n(data, op_mode="DC", position=3, cycle_ns=500_000))
    root = ElementTree.fromstring(text.encode())
    assert root[0].attrib == {"idx": "0", "appTimePeriod": "500000", "refClockSyncCycles": "1"}
    slave = slave_in(text)
    assert slave.attrib == {
        "idx": "3",
        "type": "generic",
        "vid": "00004321",
        "pid": "000000e2",
        "configPdos": "true",
        "name": "l6n",
    }
    assert [(element.tag, element.attrib) for element in slave][:3] == [
        ("dcConf", {"assignActivate": "300", "sync0Cycle": "*1", "sync0Shift": "0"}),
        ("sdoConfig", {"idx": "6060", "subIdx": "00"}),
        ("syncManager", {"idx": "0", "dir": "out"}),
    ]
    (outputs,) = (sm for sm in slave.iter("syncManager") if sm.get("idx") == "2")
    assert [element.attrib for element in outputs.iter("pdoEntry")] == [
        {"idx": "6040", "subIdx": "00", "bitLen": "16", "halPin": "controlword", "halType": "u32"},
        {"idx": "607a", "subIdx": "00", "bitLen": "32", "halPin": "target-position", "halType": "s32"},
        {"idx": "60b8", "subIdx": "00", "bitLen": "16", "halPin": "touch-probe-function", "halType": "u32"},
    ]
    assert "its target must be set to its actual position" in " ".join(text.split())


def test_without_clocks_nothing_is_synchronized(data):
    text = linuxcnc_configuration(l6n(data))
    assert 'refClockSyncCycles="0"' in text
    assert "dcConf" not in text


TYPES = SMS + rx(
    "#x1600",
    entry("#x7000", 1, "flag", 1, "BOOL"),
    entry("#x0", 7),
    entry("#x7000", 16, "word", 2, "INT"),
    entry("#x7000", 32, "real", 3, "REAL"),
    entry("#x7000", 64, "long real", 4, "LREAL"),
    entry("#x7000", 64, "counter", 5, "ULINT"),
    entry("#x7000", 24, "three bytes", 6, "INT24"),
    entry("#x7000", 80, "text", 7, "STRING(10)"),
    entry("#x7000", 4, "nibble", 8, "BIT4"),
    entry("#x7000", 32, "shifted real", 9, "REAL"),
    entry("#x7000", 16, "again", 2, "INT"),
)


def test_types_of_pins():
    text = linuxcnc_configuration(configured(TYPES, name="d"))
    assert pins_of(slave_in(text)) == [
        ("flag", "bit", "1"),
        (None, None, "7"),
        ("word", "s32", "16"),
        ("real", "float-ieee", "32"),
        ("long-real", "float-double-ieee", "64"),
        (None, "complex", "64"),
        ("counter-lo", "u32", "32"),
        ("counter-hi", "u32", "32"),
        ("three-bytes", "s32", "24"),
        (None, None, "80"),
        ("nibble", "u32", "4"),
        (None, None, "32"),
        (None, None, "16"),
    ]
    words = " ".join(text.split())
    assert "0x7000:07 text has no pin: no HAL type takes it at its place" in words
    assert "0x7000:09 shifted real has no pin" in words
    assert "0x7000:02 is mapped 2 times, perhaps as different values: word (16 bit), again (16 bit): LinuxCNC" in words
    assert "without their sign" not in words
    inputs = TYPES.replace("RxPdo", "TxPdo").replace("#x1600", "#x1A00").replace('Sm="2"', 'Sm="3"')
    assert "0x7000:06 three bytes: LinuxCNC-Ethercat reads 24 bits without their sign" in " ".join(
        linuxcnc_configuration(configured(inputs)).split()
    )


def remarks_of(content: str) -> str:
    return " ".join(linuxcnc_configuration(configured(content)).split())


LEFT_OUT = (
    "PDO 0x1600 maps 0x7000:02 to :03, 0x7000:10 in no bits, which LinuxCNC-Ethercat cannot handle: left out, and no "
    "other entry moves"
)


def test_an_entry_of_no_bits_is_left_out():
    """The parser refuses bitLen="0" (parsePdoEntryAttrs)."""
    assert pins_of(slave_of(EMPTY)) == [("first", "u32", "16"), ("last", "u32", "8")]
    assert LEFT_OUT in remarks_of(EMPTY)


def test_what_older_versions_make_of_a_type_is_told():
    """Their generic driver writes every float as an integer, and reads the sign of bytes that begin on one."""
    floats = (entry("#x7000", 32, "a", 1, "REAL"), entry("#x7000", 32, "b", 2, "REAL"))
    as_integer = "older versions of LinuxCNC-Ethercat write float-ieee as an integer"
    outputs = SMS + rx("#x1600", *floats)
    assert remarks_of(outputs).count(as_integer) == 1
    assert "float-double-ieee" not in remarks_of(outputs)
    assert "float-double-ieee needs a version of LinuxCNC-Ethercat that knows it" in remarks_of(SMS + TYPES)

    def inputs(*entries: str) -> str:
        mapped = rx("#x1A00", *entries, attributes='Sm="3"').replace("RxPdo", "TxPdo")
        return remarks_of(SMS + mapped)

    assert as_integer not in inputs(*floats)
    bit = entry("#x6000", 1, "bit", 1, "BOOL")
    for kind, bits, is_told in (("SINT", 8, True), ("INT", 16, True), ("DINT", 32, False), ("UINT", 16, False)):
        value = entry("#x6000", bits, "value", 2, kind)
        words = f"0x6000:02 value: older versions of LinuxCNC-Ethercat read {bits} bits that begin inside a byte"
        assert (words in inputs(bit, value)) == is_told
        assert "older versions" not in inputs(value)


def test_samples_have_pins_of_their_own():
    """0x7000:01 in three samples with OSIndexInc 16."""
    content = SMS + rx("#x1600", entry("#x7000", 16, "value", 1, "INT"), attributes='Sm="2" OSFac="3" OSIndexInc="16"')
    found = [(e.get("idx"), e.get("subIdx"), e.get("halPin")) for e in slave_of(content).iter("pdoEntry")]
    assert found == [
        ("7000", "01", "value-7000-01"),
        ("7010", "01", "value-7010-01"),
        ("7020", "01", "value-7020-01"),
    ]


def test_a_virtual_sync_manager_is_not_told_to_the_driver():
    outputs = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + pdo("RxPdo", "#x1610", 32, attributes='Sm="4"')
    found = slave_of(SMS + '<Sm ControlByte="#x64" Virtual="1">Outputs</Sm>' + outputs)
    assert [sm.get("idx") for sm in found.iter("syncManager")] == ["0", "1", "2"]


def test_long_names_fit_the_names_of_hal():
    name = "a very long name of an entry that goes on and on"
    entries = [entry("#x7000", 64, name, number, "ULINT") for number in range(1, 4)]
    slave = slave_of(SMS + rx("#x1600", *entries))
    found = linuxcnc_configuration(configured(SMS + rx("#x1600", *entries), name="a_prefix_that_is_long_itself"))
    assert slave_in(found).get("name") == "a-prefix-that-i"
    pins = [pin for pin, _, _ in pins_of(slave) if pin is not None]
    assert [pin[-3:] for pin in pins] == ["-lo", "-hi"] * 3


def test_long_names_keep_the_word_that_tells_them_apart():
    """HAL has 47 characters, ``lcec.0.a-prefix-that-i.`` takes 23 of them: 24 are left."""
    entries = [entry("#x7000", 16, f"Modes of operation display, axis {axis}", axis) for axis in (2, 1, 3)]
    text = linuxcnc_configuration(configured(SMS + rx("#x1600", *entries), name="a_prefix_that_is_long_itself"))
    assert [pin for pin, _, _ in pins_of(slave_in(text))] == [
        "modes-of-operation-dis-2",
        "modes-of-operation-dis-1",
        "modes-of-operation-dis-3",
    ]
    whole = entry("#x7000", 16, "One" + "word" * 11, 1)
    text = linuxcnc_configuration(configured(SMS + rx("#x1600", whole), name="a_prefix_that_is_long_itself"))
    assert pins_of(slave_in(text))[0][0] == "onewordwordwordwordwordw"


def test_more_entries_than_pins():
    slave = slave_of(
        SMS
        + pdo("RxPdo", "#x1600", *[1] * 254, attributes='Sm="2"')
        + rx("#x1601", *(entry("#x7001", 8, f"x{number}", number) for number in range(1, 5)))
    )
    pins = [pin for pin, _, _ in pins_of(slave)]
    assert (len(pins), pins[-3:]) == (258, ["x2", None, None])


def test_long_entries_are_cut_as_igh_needs_it():
    slave = slave_of(SMS + rx("#x1600", entry("#x7000", 600, "block", 1)))
    assert [length for _, _, length in pins_of(slave)] == ["248", "248", "104"]


@pytest.mark.parametrize(
    ("mode", "attributes"),
    [
        (times("#x300", 'Factor="2">0', shift0="-5000"), {"sync0Cycle": "*2", "sync0Shift": "-5000"}),
        (
            times("#x700", FACTOR_1, FACTOR_1, shift1="20000"),
            {"sync0Cycle": "*1", "sync0Shift": "0", "sync1Cycle": "20000", "sync1Shift": "0"},
        ),
        (
            times("#x700", 'Factor="-8">0', 'Factor="-1">0'),
            {"sync0Cycle": "125000", "sync0Shift": "0", "sync1Cycle": "875000", "sync1Shift": "0"},
        ),
    ],
)
def test_the_clocks(mode, attributes):
    slave = slave_of(SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + dc(("m", mode)))
    found = dict(slave[0].attrib)
    assert found.pop("assignActivate") in ("300", "700")
    assert found == attributes


def test_the_period_is_that_of_a_fixed_sync0_where_the_usual_one_would_drift():
    content = SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + dc(("m", times("#x300", ">700000")))
    text = linuxcnc_configuration(configured(content))
    assert 'appTimePeriod="700000"' in text
    assert 'sync0Cycle="700000"' in text
    assert "the bus cycle is the SYNC0 cycle, 700000 ns" in text


def test_a_device_that_uses_the_time_only_has_synchronized_clocks_and_no_dc_conf():
    modes = dc(("DC", times("#x320"))).replace("<Dc>", '<Dc TimeLoopControlOnly="1">')
    text = linuxcnc_configuration(configured(SMS + rx("#x1600", entry("#x7000", 8, "v", 1)) + modes))
    assert 'refClockSyncCycles="1"' in text
    assert slave_in(text).find("dcConf") is None


def test_commands():
    coe = "".join(
        (
            init_cmd("IP", "#x2001", "0102030405060708090A0B0C0D0E0F1011"),
            init_cmd("PS", "#xF800", "0A00", 'CompleteAccess="1"').replace("<SubIndex>1<", "<SubIndex>0<"),
            init_cmd("PS", "#x2002", "01", 'CompleteAccess="1"'),
            init_cmd("SO", "#x2003", "01"),
        )
    )
    soe = "<SoE><InitCmd><Transition>PS</Transition><IDN>32</IDN><Data>0B00</Data></InitCmd></SoE>"
    content = SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + f"<Mailbox><CoE>{coe}</CoE>{soe}</Mailbox>"
    text = linuxcnc_configuration(configured(content + "<ESC><Reg0400>2498</Reg0400></ESC>"))
    slave = slave_in(text)
    assert [
        (sdo.get("idx"), sdo.get("subIdx"), [line.get("data") for line in sdo]) for sdo in slave.iter("sdoConfig")
    ] == [
        ("2001", "01", ["01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e 0f 10", "11"]),
        ("f800", "complete", ["0a 00"]),
    ]
    words = " ".join(text.split())
    for place in ("PS 0x2002", "SO 0x2003:01", "PS S-0-0032"):
        assert f"{place} is left out" in words
    assert [element.attrib for element in slave.iter("watchdog")] == [{"divider": "2498", "intervals": "0"}]


@pytest.mark.parametrize(
    ("content", "choice", "message"),
    [
        (SMS, {}, "assigns no PDO"),
        (SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"'), {"alias": 7}, "give no alias"),
        (SMS + rx("#x1600", entry("#x7000", 8, "x", 255)), {}, "cannot map 0x7000:FF"),
    ],
)
def test_what_the_driver_cannot_configure_is_refused(content, choice, message):
    with pytest.raises(InputError, match=message):
        linuxcnc_configuration(configured(content, **choice))


def test_options_that_remarks_name_are_explained():
    """An XML comment cannot have two hyphens in a row."""
    once = SMS + rx("#x1600", entry("#x7000", 16, "value", 1))
    words = 'In this comment "- -" stands for two hyphens'
    found = linuxcnc_configuration(configured(once + rx("#x1601", entry("#x7000", 16, "value", 1))))
    assert "choose PDOs (- -pdo)" in " ".join(found.split())
    assert found.count(words) == 1
    assert words not in linuxcnc_configuration(configured(once))


@pytest.mark.parametrize("name", [*HOSTILE, "-- x --", "---", "x --&gt; &lt;slave/&gt;", "]]&gt;", "&amp;amp;"])
def test_names_of_a_vendor_break_nothing(name):
    entries = [entry("#x7000", 3 if number % 2 else 8, name, number) for number in range(1, 5)]
    command = init_cmd("PS", "#x2000", "01").replace("</InitCmd>", f"<Comment>{name}</Comment></InitCmd>")
    content = SMS + rx("#x1600", *entries, name=name) + dc((name, times("#x320", FACTOR_1)))
    slave = slave_of(content + COE.replace('"1"/>', f'"1">{command}</CoE>'))
    assert [element.get("subIdx") for element in slave.iter("pdoEntry")] == ["01", "02", "03", "04"]


@pytest.mark.corpus
def test_files_of_the_whole_corpus(corpus):
    refused = 0
    for found in configurations(corpus):
        try:
            text = linuxcnc_configuration(found)
        except InputError:
            refused += 1
            continue
        slave = slave_in(text)
        for sm in slave.iter("syncManager"):
            (described,) = (item for item in found.sync_managers if str(item.number) == sm.get("idx"))
            assert sum(int(element.get("bitLen", "0")) for element in sm.iter("pdoEntry")) == described.bit_size
    assert refused < 50
