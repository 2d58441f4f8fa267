"""Slave files for ethercat_driver_ros2: keys as its documentation lists them, values where the driver puts them."""

import math
import re

import pytest
import yaml
from snippets import dictionary, pdo
from test_export_compile import configurations
from test_export_configuration import COE, EMPTY, FACTOR_1, SMS, configured, dc, entry, init_cmd, rx, times
from test_export_igh import HOSTILE, as_little_endian, l6n

from esicatalog.errors import InputError
from esicatalog.esi.reader import read_esi
from esicatalog.export.choice import parse_pdo_choice
from esicatalog.export.configuration import configure
from esicatalog.export.linuxcnc import linuxcnc_configuration
from esicatalog.export.ros2 import ros2_slave
from esicatalog.export.subject import subjects_of_document

KEYS = {
    "vendor_id": int,
    "product_id": int,
    "assign_activate": int,
    "auto_fault_reset": bool,
    "auto_state_transitions": bool,
    "sdo": list,
    "rpdo": list,
    "tpdo": list,
    "sm": list,
}
TYPES = re.compile(r"bool|u?int(8|16|32|64)|real(32|64)|bit([1-9]|[1-9][0-9]|1[0-9][0-9]|2[0-4][0-9]|25[0-5])")


def bits_of(kind: str) -> int:
    return 1 if kind == "bool" else int(re.sub(r"\D", "", kind))


def loaded(text: str) -> dict:
    """The file, after checking every key and value against what the driver reads."""
    found = yaml.load(text, Loader=yaml.CSafeLoader)
    assert all(isinstance(value, KEYS[key]) for key, value in found.items())
    for sdo in found.get("sdo", ()):
        assert sdo.keys() == {"index", "sub_index", "type", "value"}
        assert -(2**31) <= sdo["value"] < 2**31
    interfaces = []
    for key, interface in (("rpdo", "command_interface"), ("tpdo", "state_interface")):
        for item in found.get(key, ()):
            assert item.keys() == {"index", "channels"}
            for channel in item["channels"]:
                assert TYPES.fullmatch(channel["type"])
                allowed = {"index", "sub_index", "type", "mask", "factor", interface}
                assert channel.keys() <= (allowed | {"default"} if key == "rpdo" else allowed)
                assert key == "tpdo" or not math.isnan(channel["default"])
                assert 0 <= channel.get("mask", 0) <= 0xFF
                assert isinstance(channel.get(interface, ""), str)
                interfaces += [(interface, channel[interface])] if interface in channel else []
    assert len(set(interfaces)) == len(interfaces)
    for sm in found["sm"]:
        assert sm.keys() == {"index", "type", "pdo"}
        assert sm["type"] in ("output", "input")
        assert sm["pdo"] in ("rpdo", "tpdo", None)
    return found


def slave_of(content: str, **choice) -> dict:
    return loaded(ros2_slave(configured(content, name="d", **choice)))


def written(found: dict, commands: dict[str, float]) -> bytes:
    """The output image after one cycle, as the driver makes it (ec_pdo_single_interface_channel_manager.cpp)."""
    channels = [channel for item in found["rpdo"] for channel in item["channels"]]
    image = bytearray(-(-sum(bits_of(channel["type"]) for channel in channels) // 8) + 8)
    at = 0
    for channel in channels:
        kind, mask, start = channel["type"], channel.get("mask", 255), at // 8
        at += bits_of(kind)
        if channel["index"] == 0:
            continue
        value = commands.get(channel.get("command_interface", ""), math.nan)
        value = channel["default"] if math.isnan(value) else channel.get("factor", 1) * value
        if kind == "bool":
            image[start] = image[start] & ~mask | (mask if value else 0)
        elif kind.startswith("bit"):
            image[start] = image[start] & ~mask | int(value) & mask
        else:
            size = bits_of(kind) // 8
            image[start : start + size] = int(value).to_bytes(size, "little", signed=not kind.startswith("u"))
    return bytes(image[:-8])


def read(found: dict, image: bytes) -> dict[str, float]:
    values, at = {}, 0
    for channel in (channel for item in found["tpdo"] for channel in item["channels"]):
        kind, start = channel["type"], at // 8
        at += bits_of(kind)
        if "state_interface" in channel:
            if kind == "bool":
                value = 1 if image[start] & channel["mask"] else 0
            elif kind.startswith("bit"):
                value = image[start] & channel["mask"]
            else:
                size = bits_of(kind) // 8
                value = int.from_bytes(image[start : start + size], "little", signed=not kind.startswith("u"))
            values[channel["state_interface"]] = channel.get("factor", 1) * value
    return values


def test_the_l6n_drive(data):
    found = loaded(ros2_slave(l6n(data, pdos=parse_pdo_choice("0x1601,0x1A01"), op_mode="DC")))
    assert found == {
        "vendor_id": 0x4321,
        "product_id": 0xE2,
        "assign_activate": 0x300,
        "auto_fault_reset": False,
        "auto_state_transitions": False,
        "sdo": [{"index": 0x6060, "sub_index": 0, "type": "uint8", "value": 8}],
        "rpdo": [
            {
                "index": 0x1601,
                "channels": [
                    {
                        "index": 0x6040,
                        "sub_index": 0,
                        "type": "uint16",
                        "command_interface": "control_word",
                        "default": 0,
                    },
                    {"index": 0x60FF, "sub_index": 0, "type": "int32", "command_interface": "velocity", "default": 0},
                    {
                        "index": 0x6060,
                        "sub_index": 0,
                        "type": "int8",
                        "command_interface": "mode_of_operation",
                        "default": 8,
                    },
                ],
            }
        ],
        "tpdo": [
            {
                "index": 0x1A01,
                "channels": [
                    {"index": 0x6041, "sub_index": 0, "type": "uint16", "state_interface": "status_word"},
                    {"index": 0x606C, "sub_index": 0, "type": "int32", "state_interface": "velocity"},
                ],
            }
        ],
        "sm": [
            {"index": 0, "type": "output", "pdo": None},
            {"index": 1, "type": "input", "pdo": None},
            {"index": 2, "type": "output", "pdo": "rpdo"},
            {"index": 3, "type": "input", "pdo": "tpdo"},
        ],
    }


def test_what_the_drive_plugin_needs_is_told(data):
    text = " ".join(ros2_slave(l6n(data, pdos=parse_pdo_choice("0x1600,0x1A01"))).replace("#", "").split())
    assert "EcCiA402Drive switches the drive on by itself where it does not know auto_state_transitions" in text
    assert "0x6061 is not mapped: without CSP read from there EcCiA402Drive sends 0 as target position" in text
    assert "0x6061 is not mapped" not in ros2_slave(l6n(data))
    # 0x1601 has the target velocity; what is not mapped, the target position, need not be held.
    velocity = ros2_slave(l6n(data, pdos=parse_pdo_choice("0x1601,0x1A01")))
    assert "0x60ff" in velocity
    assert "0x6061 is not mapped" not in velocity
    assert '<param name="position">5</param>' in ros2_slave(l6n(data, position=5))


CONTROL, STATUS = entry("#x6040", 16), entry("#x6041", 16)
TARGET, ACTUAL = entry("#x607A", 32), entry("#x6064", 32)
DISPLAY, GAP = entry("#x6061", 8), entry("#x0", 8)
GAPS, HELD, PROFILED = "there are gaps", "EcCiA402Drive cannot hold the actual position", "the start-up command sets PP"


@pytest.mark.parametrize(
    ("outputs", "inputs", "mode", "told"),
    [
        ((CONTROL, TARGET), (STATUS, ACTUAL, DISPLAY), "08", set()),
        ((CONTROL, TARGET), (STATUS, ACTUAL, DISPLAY), "01", {PROFILED}),
        ((CONTROL, TARGET), (STATUS, DISPLAY), "08", {HELD}),
        ((CONTROL, GAP, TARGET), (STATUS, ACTUAL, DISPLAY), "08", {GAPS}),
        # Of 5 channels 4 are served, so that the last one, after which the drive's state is looked at, never comes.
        ((CONTROL, TARGET), (STATUS, DISPLAY, GAP), "08", {GAPS, HELD}),
        # Without controlword there is nothing for EcCiA402Drive to do.
        ((TARGET, GAP), (STATUS, DISPLAY), "01", set()),
    ],
)
def test_what_the_drive_plugin_makes_of_gaps_and_modes(outputs, inputs, mode, told):
    command = init_cmd("PS", "#x6060", mode).replace("<SubIndex>1<", "<SubIndex>0<")
    transmit = rx("#x1A00", *inputs, attributes='Sm="3"').replace("RxPdo", "TxPdo")
    text = ros2_slave(configured(f"{SMS}{rx('#x1600', *outputs)}{transmit}<Mailbox><CoE>{command}</CoE></Mailbox>"))
    words = " ".join(text.replace("#", "").split())
    assert {remark for remark in (GAPS, HELD, PROFILED) if remark in words} == told
    assert ("auto_state_transitions" in loaded(text)) == (CONTROL in outputs)


def test_a_soe_drive_is_none_for_the_drive_plugin():
    """0x8040 and 0x8041 are IDNs, P-0-0064 and P-0-0065, and no words of axis 4; 0x807A is no target position."""
    idn = "<Object><Index>#x{}</Index><Name>n</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"
    declared = dictionary("", idn.format("8040") + idn.format("8041")).replace("<ProfileNo>402</ProfileNo>", "")
    outputs = rx("#x18", entry("#x86", 16, "Master control word"), entry("#x807A", 32, "Probe counter", 0, "UDINT"))
    text = ros2_slave(configured(f"{declared}{SMS}{outputs}<Mailbox><SoE/></Mailbox>"))
    (found,) = loaded(text)["rpdo"]
    assert [(c["type"], c["command_interface"]) for c in found["channels"]] == [
        ("uint16", "master_control_word"),
        ("uint32", "probe_counter"),
    ]
    assert "EcCiA402Drive" not in text
    assert "auto_state_transitions" not in text
    assert "Something may move" in text


def mode_content(mode: str, *entries: str) -> str:
    """A device whose InitCmd writes a mode of operation, and that maps these entries."""
    command = init_cmd("PS", "#x6060", mode).replace("<SubIndex>1<", "<SubIndex>0<")
    return SMS + rx("#x1600", *entries) + COE.replace('"1"/>', f'"1">{command}</CoE>')


MODE = entry("#x6060", 8, "Modes of operation", 0, "SINT")
DRIVE_402 = "<Profile><ProfileNo>402</ProfileNo></Profile>"


def channels_of(content: str, key: str = "rpdo") -> dict[int, dict]:
    return {channel["index"]: channel for item in slave_of(content)[key] for channel in item["channels"]}


def test_the_default_of_a_mapped_mode_is_that_of_the_start_up_command_on_any_device():
    """FD is -3, a manufacturer's mode."""
    assert channels_of(mode_content("FD", MODE))[0x6060]["default"] == -3
    unsigned = channels_of(mode_content("FD", MODE.replace("SINT", "USINT")))[0x6060]
    assert (unsigned["type"], unsigned["default"]) == ("uint8", 0xFD)


def test_a_mapped_mode_begins_with_that_of_a_command_which_the_driver_does_not_send():
    """Commands of SO are left out; the cyclic value does what they are for, so nothing else is asked of anyone."""
    target = entry("#x60FF", 32, "Target velocity", 0, "DINT")
    content = mode_content("09", entry("#x6040", 16), MODE, target)
    for sent in (content, content.replace("<Transition>PS<", "<Transition>SO<")):
        assert channels_of(sent)[0x6060]["default"] == 9
        assert "0x6060 is mapped" not in ros2_slave(configured(sent))
    against = " ".join(ros2_slave(configured(content.replace("#x60FF", "#x607A"))).replace("\n#", "").split())
    assert (
        "0x6060 is mapped: command the mode that is wanted, for the 9 (CSV) of the start-up command does not go with "
        "the mapped setpoint 0x607A"
    ) in against


@pytest.mark.parametrize("name", ["Mode of operation", "Modes of operation"])
def test_the_default_of_a_mapped_mode_does_not_depend_on_names_of_other_entries(name):
    found = channels_of(DRIVE_402 + mode_content("08", MODE, entry("#x2010", 8, name, 0, "USINT")))
    assert (found[0x6060]["command_interface"], found[0x6060]["default"]) == ("mode_of_operation", 8)
    assert found[0x2010]["default"] == 0


@pytest.mark.parametrize(
    ("key", "interface", "position", "velocity"),
    [("rpdo", "command_interface", "607A", "60FF"), ("tpdo", "state_interface", "6064", "606C")],
)
def test_entries_of_a_vendor_do_not_take_the_names_of_the_profile(key, interface, position, velocity):
    entries = [entry(f"#x201{n}", 32, name, 0, "DINT") for n, name in enumerate(("Position", "Velocity", "Effort"))]
    entries += [entry(f"#x{index}", 32, "of the profile", 0, "DINT") for index in (position, velocity)]
    content = rx("#x1600", *entries)
    if key == "tpdo":
        content = content.replace("RxPdo", "TxPdo").replace("#x1600", "#x1A00").replace('Sm="2"', 'Sm="3"')
    found = channels_of(DRIVE_402 + SMS + content, key)
    names = {index: channel[interface] for index, channel in found.items()}
    assert (names[int(position, 16)], names[int(velocity, 16)]) == ("position", "velocity")
    assert (names[0x2010], names[0x2011], names[0x2012]) == ("position_2010_00", "velocity_2011_00", "effort")


def test_other_devices_have_no_keys_of_drives():
    assert not slave_of(SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')).keys() & {
        "auto_fault_reset",
        "auto_state_transitions",
        "assign_activate",
    }


MIXED = SMS + rx(
    "#x1600",
    entry("#x7000", 1, "flag", 1, "BOOL"),
    entry("#x7000", 3, "level", 2, "BIT3"),
    entry("#x7000", 6, "across", 3),
    entry("#x0", 6),
    entry("#x7000", 16, "whole", 4, "INT"),
    entry("#x7000", 24, "three bytes", 5, "INT24"),
    entry("#x7000", 16, "again", 4, "INT"),
    entry("#x7000", 8, "last", 6, "USINT"),
)


def test_a_pdo_that_is_known_to_be_empty_has_no_channels():
    """EL1202: "Reserved", a Fixed PDO without entries."""
    reserved = '<TxPdo Fixed="1" Sm="3"><Index>#x1A02</Index><Name>Reserved</Name></TxPdo>'
    found = slave_of(SMS + pdo("TxPdo", "#x1A00", 8, attributes='Sm="3"') + reserved)
    assert [(item["index"], len(item["channels"])) for item in found["tpdo"]] == [(0x1A00, 1), (0x1A02, 0)]


def test_an_entry_of_no_bits_is_left_out():
    """The driver reads and writes a byte for every channel, also for a bit0 (ec_pdo_channel_manager.cpp)."""
    assert list(channels_of(EMPTY)) == [0x7000]
    found = slave_of(EMPTY)
    assert [item["sub_index"] for item in found["rpdo"][0]["channels"]] == [1, 0x11]
    assert written(found, {"first": 0x1234, "last": 5}) == as_little_endian((0x1234, 16), (5, 8))


def test_outputs_lie_where_the_driver_writes_them():
    text = ros2_slave(configured(MIXED))
    found = loaded(text)
    image = written(found, {"flag": 1, "level": 5, "whole": -2, "last": 200})
    assert image == as_little_endian((1, 1), (5, 3), (0, 6), (0, 6), (-2, 16), (0, 24), (0, 16), (200, 8))
    assert written(found, {"level": 2}) == as_little_endian((0, 1), (2, 3), (0, 76))
    words = " ".join(text.replace("#", "").split())
    assert "older versions of ethercat_driver_ros2 clear the rest of the byte when they write a bitN" in words
    for place in ("0x7000:03 across", "0x7000:05 three bytes"):
        assert f"{place} has no interface: ethercat_driver_ros2 has no type for it at its place" in words
    assert "0x7000:04 is mapped 2 times, perhaps as different values: whole (16 bit), again (16 bit): ethercat" in words


def test_inputs_lie_where_the_driver_reads_them():
    found = slave_of(MIXED.replace("RxPdo", "TxPdo").replace("#x1600", "#x1A00").replace('Sm="2"', 'Sm="3"'))
    image = as_little_endian((1, 1), (5, 3), (63, 6), (63, 6), (-2, 16), (-1, 24), (7, 16), (200, 8))
    assert read(found, image) == {"flag": 1, "level": 5, "whole": -2, "last": 200}


def test_signed_bits_that_the_driver_reads_without_their_sign_are_told():
    entries = [entry("#x6000", 3, "low", 1, "SINT"), entry("#x6000", 5, "high", 2, "USINT")]
    inputs = rx("#x1A00", *entries).replace("RxPdo", "TxPdo").replace('Sm="2"', 'Sm="3"')
    text = ros2_slave(configured(SMS + inputs))
    assert read(loaded(text), as_little_endian((-1, 3), (31, 5))) == {"low": 7, "high": 31}
    assert "0x6000:01 low: ethercat_driver_ros2 reads 3 bits without their sign" in text
    assert "0x6000:02 high: " not in text
    assert "without their sign" not in ros2_slave(configured(SMS + rx("#x1600", *entries)))


def test_samples_are_channels_of_their_own():
    """0x7000:01 in three samples with OSIndexInc 16."""
    content = SMS + rx("#x1600", entry("#x7000", 16, "value", 1, "INT"), attributes='Sm="2" OSFac="3" OSIndexInc="16"')
    (found,) = slave_of(content)["rpdo"]
    assert [(channel["index"], channel["sub_index"]) for channel in found["channels"]] == [
        (0x7000, 1),
        (0x7010, 1),
        (0x7020, 1),
    ]
    assert [channel["command_interface"] for channel in found["channels"]] == [
        "value_7000_01",
        "value_7010_01",
        "value_7020_01",
    ]


def test_a_virtual_sync_manager_is_not_told_to_the_driver():
    outputs = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + pdo("RxPdo", "#x1610", 32, attributes='Sm="4"')
    found = slave_of(SMS + '<Sm ControlByte="#x64" Virtual="1">Outputs</Sm>' + outputs)
    assert [sm["index"] for sm in found["sm"]] == [0, 1, 2]


def test_floating_point():
    reals = rx("#x1600", entry("#x7000", 32, "a", 1, "REAL"), entry("#x7000", 64, "b", 2, "LREAL"))
    text = ros2_slave(configured(SMS + reals))
    assert [channel["type"] for channel in loaded(text)["rpdo"][0]["channels"]] == ["real32", "real64"]
    assert "real32 and real64 need a version of ethercat_driver_ros2 that knows these types" in text


def test_long_entries_are_cut_as_igh_needs_it():
    channels = slave_of(SMS + rx("#x1600", entry("#x7000", 600, "block", 1)))["rpdo"][0]["channels"]
    assert [(channel["type"], channel["mask"]) for channel in channels] == [("bit248", 0), ("bit248", 0), ("bit104", 0)]


def test_commands():
    coe = "".join(
        (
            init_cmd("IP", "#x2001", "FF"),
            init_cmd("PS", "#x2002", "FEFFFFFF"),
            init_cmd("PS", "#x2003", "0102030405060708"),
            init_cmd("PS", "#x2004", "FFFFFFFFFFFFFFFF"),
            init_cmd("PS", "#x2005", "010203"),
            init_cmd("PS", "#x1C12", "0016"),
            init_cmd("SO", "#x2006", "01"),
        )
    )
    text = ros2_slave(
        configured(SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + f"<Mailbox><CoE>{coe}</CoE></Mailbox>")
    )
    assert [(sdo["index"], sdo["type"], sdo["value"]) for sdo in loaded(text)["sdo"]] == [
        (0x2001, "uint8", 255),
        (0x2002, "int32", -2),
        (0x2004, "int64", -1),
    ]
    words = " ".join(text.replace("#", "").split())
    for place in ("PS 0x2003:01", "PS 0x2005:01", "PS 0x1C12:01", "SO 0x2006:01"):
        assert f"{place} is left out" in words


@pytest.mark.parametrize("export", [ros2_slave, linuxcnc_configuration])
def test_commands_on_pdos_that_the_master_does_not_write_are_sent(export):
    """SM2 has a PDO without described entries, so the file leaves it out; 0x1A05 is assigned nowhere.

    Those on SM3 and 0x1A00 (0x7000:01, 8 bits) write what the master writes too.
    """
    written = {"1C12": "01", "1600": "01", "1A05": "01", "1C13": "001A", "1A00": "08010070"}
    commands = "".join(init_cmd("PS", f"#x{index}", data) for index, data in written.items())
    inputs = pdo("TxPdo", "#x1A00", 8, attributes='Sm="3"')
    text = export(configured(f"{SMS}{rx('#x1600')}{inputs}<Mailbox><CoE>{commands}</CoE></Mailbox>"))
    left_out = [place for place in re.findall(r"PS (0x\w+):01", text) if f"PS {place}:01 is left out" in text]
    assert left_out == ["0x1C13", "0x1A00"]
    sent = re.findall(r'sdoConfig idx="(\w+)"|- {index: 0x(1c12|1600|1a05), sub_index: 1, type: uint8', text)
    assert [first or second for first, second in sent] == ["1c12", "1600", "1a05"]


def test_the_list_of_modules_is_written_one_by_one(data):
    """The number of them, 0xF030:00, is described as ro."""
    (subject,) = subjects_of_document(read_esi(data / "two_axis_modular_drive.xml").document, "x.xml")
    found = loaded(ros2_slave(configure(subject)))
    assert [(sdo["sub_index"], sdo["value"]) for sdo in found["sdo"] if sdo["index"] == 0xF030] == [
        (1, 0x10800),
        (2, 0x10800),
    ]
    assert "position_axis1" in {channel.get("command_interface") for channel in found["rpdo"][1]["channels"]}


@pytest.mark.parametrize(
    ("mode", "words"),
    [
        (times("#x300", FACTOR_1), None),
        (times("#x300", FACTOR_1, shift0="5000"), "SYNC0 every 1000000 ns with a shift of 5000 ns;"),
        (times("#x300", 'Factor="2">0'), "SYNC0 every 2000000 ns;"),
        (times("#x700", FACTOR_1, FACTOR_1, shift1="20000"), "SYNC0 every 1000000 ns and SYNC1 20000 ns behind it;"),
    ],
)
def test_clocks_that_the_driver_sets_otherwise(mode, words):
    text = ros2_slave(configured(SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + dc(("m", mode))))
    assert ("the OpMode asks for" in text) == (words is not None)
    assert words is None or words in " ".join(text.replace("#", "").split())


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (SMS, "assigns no PDO"),
        (SMS + rx("#x1600"), "needs the entries of all PDOs"),
        (
            "<Sm>Outputs</Sm><Sm>Outputs</Sm>"
            + pdo("RxPdo", "#x1600", 8, attributes='Sm="0"')
            + pdo("RxPdo", "#x1601", 8, attributes='Sm="1"'),
            "SM0, SM1 have PDOs; ethercat_driver_ros2 assigns every rpdo to each SyncManager of the direction",
        ),
    ],
)
def test_what_the_driver_cannot_configure_is_refused(content, message):
    with pytest.raises(InputError, match=message):
        ros2_slave(configured(content))


@pytest.mark.parametrize("name", [*HOSTILE, "on", "null", "a: b # c", "x} y"])
def test_names_of_a_vendor_break_nothing(name):
    entries = [entry("#x7000", 3 if number % 2 else 8, name, number) for number in range(1, 5)]
    command = init_cmd("PS", "#x2000", "01").replace("</InitCmd>", f"<Comment>{name}</Comment></InitCmd>")
    content = SMS + rx("#x1600", *entries, name=name) + dc((name, times("#x320", FACTOR_1)))
    found = slave_of(content + COE.replace('"1"/>', f'"1">{command}</CoE>'))
    assert [channel["sub_index"] for channel in found["rpdo"][0]["channels"]] == [1, 2, 3, 4]
    assert found["assign_activate"] == 0x320


@pytest.mark.corpus
def test_files_of_the_whole_corpus(corpus):
    refused = 0
    for found in configurations(corpus):
        try:
            text = ros2_slave(found)
        except InputError:
            refused += 1
            continue
        slave = loaded(text)
        for key, usage in (("rpdo", "output"), ("tpdo", "input")):
            bits = sum(bits_of(channel["type"]) for item in slave.get(key, ()) for channel in item["channels"])
            assert bits == sum(sm.bit_size for sm in found.images(usage) if sm.is_described)
    assert refused < 200


def test_a_sync_manager_without_a_role_has_no_empty_comment():
    """``ethercat xml`` prints no roles."""
    sms = '<Sm ControlByte="#x26"/><Sm ControlByte="#x22"/><Sm ControlByte="#x64"/><Sm ControlByte="#x20"/>'
    found = configured(sms + rx("#x1600", entry("#x7000", 16)))
    lines = ros2_slave(found).splitlines()
    assert [line for line in lines if line.startswith("  - {index: 2")] == [
        "  - {index: 2, type: output, pdo: rpdo}",
    ]
    assert not re.search(r"<!--\s*-->", linuxcnc_configuration(found))
