"""Comparing two descriptions: every area by hand-made devices, and the rules by which a difference counts."""

import pytest
from snippets import device, esi, pdo, read

from esicatalog.model.compare import compare_devices, summary_words
from esicatalog.model.compare_device import revision_verdict
from esicatalog.model.compare_documents import DescribedDevice, described_devices
from esicatalog.model.compare_facts import Difference, excerpts


def described(text: str) -> DescribedDevice:
    """The one device of a document, with its modules."""
    (found,) = described_devices(read(text).document)
    return found


def compared(left: str, right: str) -> list[Difference]:
    """Differences of the devices of two documents."""
    return compare_devices(described(left), described(right))


def told(left: str, right: str, **sides: str) -> list[tuple[str, str | None, str | None, bool]]:
    """Place, values and weight of what two contents of a device say differently."""
    found = compared(esi(device(left, **sides)), esi(device(right, **sides)))
    return [(item.place, item.left, item.right, item.counts) for item in found]


def test_spelling_makes_no_difference():
    plain = '<Sm MinSize="#x10" StartAddress="4096" Enable="1" Virtual="0">Outputs</Sm>'
    other = '<Sm MinSize="16" StartAddress="#x1000" Enable="#x1">Outputs</Sm>'
    command = "<InitCmd><Transition>PS</Transition><Index>{}</Index><SubIndex>{}</SubIndex><Data>{}</Data></InitCmd>"
    mailbox = "<Mailbox><CoE {}>{}</CoE></Mailbox>"
    assert (
        told(
            plain + mailbox.format('SdoInfo="true" PdoAssign="0"', command.format("24672", "#x0", "0a")),
            other + mailbox.format('SdoInfo="1"', command.format("#x6060", "0", "0A")),
        )
        == []
    )


def test_a_difference_names_area_place_kind_and_values():
    (found,) = compared(
        esi(device('<Sm StartAddress="#x1000">Outputs</Sm>')), esi(device('<Sm StartAddress="#x1100">Outputs</Sm>'))
    )
    assert found == Difference("SyncManager", "SM0 start address", "changed", "0x1000", "0x1100", True, None)


def test_kinds_follow_the_side_that_has_it():
    with_size, without = '<Sm DefaultSize="8">MBoxOut</Sm>', "<Sm>MBoxOut</Sm>"
    (added,) = compared(esi(device(without)), esi(device(with_size)))
    (removed,) = compared(esi(device(with_size)), esi(device(without)))
    assert (added.kind, added.left, added.right) == ("added", None, "8 bytes")
    assert (removed.kind, removed.left, removed.right) == ("removed", "8 bytes", None)


def test_sizes_that_are_not_known_are_no_numbers():
    """Variable content in front of 8 bits: the size is at least theirs, and they have no place."""
    known = "<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1601", 8, attributes='Sm="0"')
    empty = '<RxPdo Sm="0"><Index>#x1600</Index><Name>R</Name></RxPdo>'
    found = {item.place: item for item in compared(esi(device(known)), esi(device(known + empty)))}
    assert (found["SM0 size"].left, found["SM0 size"].right) == ("1 byte (8 bits)", "at least 1 byte (8 bits)")
    assert not [place for place in found if place.startswith("SM0 at")], "what lies before it stays"
    found = {item.place: item for item in compared(esi(device("<Sm>Outputs</Sm>" + empty)), esi(device(known)))}
    assert found["SM0 size"].left == "unknown length"


def test_texts_never_count():
    assert told("", "<URL>http://example.org</URL>", name="N") == [("link", None, "http://example.org", False)]
    found = compared(esi(device(name="A", type_text="T1")), esi(device(name="B", type_text="T2")))
    assert [(item.area, item.place, item.counts) for item in found] == [
        ("general", "type", False),
        ("general", "name", False),
    ]


CHECKED = '<Type ProductCode="#x1" RevisionNo="{}" {}>T</Type>'


@pytest.mark.parametrize(
    ("check", "left", "right", "counts", "words"),
    [
        ("", "#x10", "#x11", True, "its own choice: no CheckRevisionNo"),
        ("NONE", "#x10", "#x11", False, "takes 0x00000011: CheckRevisionNo NONE"),
        ("EQ", "#x10", "#x11", True, "refuses 0x00000011: CheckRevisionNo EQ"),
        ("L24_EQ_H8_EQ_OR_G", "#x01000010", "#x02000010", False, "takes 0x02000010: CheckRevisionNo L24_EQ_H8_EQ_OR_G"),
        ("L16_EQ", "#x10", "#x11", True, "takes 0x00000011 is not known: nor is its CheckRevisionNo 'L16_EQ'"),
        ("EQ_OR_G", "#x10", "#x11", False, "takes"),
        ("EQ_OR_G", "#x11", "#x10", True, "refuses"),
        ("LW_EQ_HW_EQ_OR_G", "#x00100001", "#x00110001", False, "takes"),
        ("LW_EQ_HW_EQ_OR_G", "#x00100001", "#x00110002", True, "refuses"),
    ],
)
def test_the_revision_counts_as_check_revision_no_of_the_left_says(check, left, right, counts, words):
    attribute = f'CheckRevisionNo="{check}"' if check else ""
    documents = [
        esi(f"<Device>{CHECKED.format(revision, attribute)}<Name>N</Name><GroupType>G</GroupType></Device>")
        for revision in (left, right)
    ]
    (found,) = compared(*documents)
    assert (found.area, found.place, found.counts) == ("identity", "revision", counts)
    assert words in revision_verdict(described(documents[0]).device, described(documents[1]).device)


def test_of_one_revision_there_is_no_verdict():
    one = described(esi(device()))
    assert revision_verdict(one.device, one.device) is None


def test_vendors_are_compared():
    one = described(esi(device()))
    (found,) = compare_devices(one._replace(vendor_id=2), one._replace(vendor_id=0x1097))
    assert (found.area, found.place, found.left, found.right) == ("identity", "vendor", "0x00000002", "0x00001097")
    assert found.counts


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        (
            "<Info><Electrical><EBusCurrent>100</EBusCurrent></Electrical></Info>",
            "<Info><Electrical><EBusCurrent>-2000</EBusCurrent></Electrical></Info>",
            [("E-bus current", "100 mA", "-2000 mA", False)],
        ),
        (
            "<Profile><ProfileNo>402</ProfileNo></Profile>",
            "<Profile><ProfileNo>5001</ProfileNo><AddInfo>742</AddInfo></Profile>",
            [("profile 0 number", "402", "5001/742", True)],
        ),
        ("", '<Su SeparateSu="1">own</Su>', [("sync unit 0", None, "name own, SeparateSu yes", False)]),
        (
            "<ESC><Reg0420>#x03E8</Reg0420></ESC>",
            "<ESC><Reg0420>500</Reg0420></ESC>",
            [("ESC register 0x0420", "0x03E8", "0x01F4", True)],
        ),
        (
            "<HideType RevisionNo='#x1'/>",
            "<HideType RevisionNo='#x1'/><HideType ProductCode='#x5' RevisionNo='#x2'/>",
            [("hidden revisions", "0x00000001", "0x00000001, product 0x00000005 0x00000002", False)],
        ),
        ("<Fmmu>Outputs</Fmmu>", "<Fmmu>Inputs</Fmmu>", [("FMMU0 usage", "Outputs", "Inputs", True)]),
        ("", "<Fmmu>Inputs</Fmmu>", [("FMMU0", None, "usage Inputs", False)]),
        ("<Fmmu>Inputs</Fmmu>", "", [("FMMU0", "usage Inputs", None, True)]),
        (
            "<Eeprom><ByteSize>128</ByteSize><BootStrap>0010000100110001</BootStrap></Eeprom>",
            "<Eeprom><ByteSize>256</ByteSize><BootStrap>0010000200120002</BootStrap></Eeprom>",
            [
                ("Eeprom bootstrap mailbox", "0010000100110001", "0010000200120002", True),
                ("Eeprom size", "128 bytes", "256 bytes", False),
            ],
        ),
    ],
)
def test_what_a_device_says_itself(left, right, expected):
    assert told(left, right) == expected


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        (
            'ControlByte="#x24"',
            'ControlByte="#x64"',
            [
                (
                    "SM0 control byte",
                    "0x24 (buffered, output, PDI interrupt)",
                    "0x64 (buffered, output, PDI interrupt, watchdog)",
                    True,
                )
            ],
        ),
        ('MaxSize="128"', 'MaxSize="256"', [("SM0 max size", "128 bytes", "256 bytes", False)]),
        ('MaxSize="256"', 'MaxSize="128"', [("SM0 max size", "256 bytes", "128 bytes", True)]),
        ('MinSize="34"', 'MinSize="40"', [("SM0 min size", "34 bytes", "40 bytes", True)]),
        ('MinSize="40"', 'MinSize="34"', [("SM0 min size", "40 bytes", "34 bytes", False)]),
        ('MinSize="zz"', 'MinSize="34"', [("SM0 min size", "zz", "34 bytes", True)]),
        ('Virtual="1"', "", [("SM0 Virtual", "yes", "no", True)]),
    ],
)
def test_sync_managers(left, right, expected):
    assert told(f"<Sm {left}>Outputs</Sm>", f"<Sm {right}>Outputs</Sm>") == expected


def test_sync_managers_are_matched_by_their_number():
    first, second = '<Sm StartAddress="#x1000">MBoxOut</Sm>', '<Sm StartAddress="#x1080">MBoxIn</Sm>'
    assert told(first + second, first) == [("SM1", "usage MBoxIn, start address 0x1080", None, True)]


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        ("<CoE/>", "<CoE/><FoE/>", [("FoE", None, "supported", False)]),
        ("<CoE/><FoE/>", "<CoE/>", [("FoE", "supported", None, True)]),
        ("<CoE/>", '<CoE CompleteAccess="1"/>', [("CoE CompleteAccess", "no", "yes", False)]),
        ('<CoE CompleteAccess="1"/>', "<CoE/>", [("CoE CompleteAccess", "yes", "no", True)]),
        ("<CoE/>", '<CoE PdoUpload="1"/>', [("CoE PdoUpload", "no", "yes", True)]),
    ],
)
def test_a_protocol_counts_when_it_is_lost(left, right, expected):
    assert told(f"<Mailbox>{left}</Mailbox>", f"<Mailbox>{right}</Mailbox>") == expected


def test_a_device_without_mailbox():
    assert told("<Mailbox><CoE/></Mailbox>", "") == [
        ("mailbox", "described", None, True),
        ("CoE", "supported", None, True),
    ]


def op_mode(name: str, activate: str = "0", content: str = "") -> str:
    return f"<OpMode><Name>{name}</Name><AssignActivate>{activate}</AssignActivate>{content}</OpMode>"


FREE, DC = op_mode("Synchron"), op_mode("DC", "#x300", "<CycleTimeSync0 Factor='1'>0</CycleTimeSync0>")


def clocks(left: str, right: str) -> list[tuple[str, str | None, str | None, bool]]:
    return told(f"<Dc>{left}</Dc>", f"<Dc>{right}</Dc>")


def test_op_modes_are_matched_by_name():
    other = op_mode("DC", "#x700", "<CycleTimeSync0 Factor='1'>0</CycleTimeSync0><ShiftTimeSync1>500</ShiftTimeSync1>")
    assert clocks(FREE + DC, FREE + other) == [
        (
            "OpMode DC AssignActivate",
            "0x0300 (sync unit active, SYNC0)",
            "0x0700 (sync unit active, SYNC0, SYNC1)",
            True,
        ),
        ("OpMode DC ShiftTimeSync1", None, "500 ns", True),
    ]


def test_an_op_mode_put_between_others_is_one_difference():
    assert clocks(FREE + DC, FREE + op_mode("DC2", "#x700") + DC) == [
        ("OpMode DC2", None, "AssignActivate 0x0700 (sync unit active, SYNC0, SYNC1)", False)
    ]


def test_a_lost_op_mode_counts():
    words = "AssignActivate 0x0300 (sync unit active, SYNC0), CycleTimeSync0 Factor 1"
    assert clocks(FREE + DC, FREE) == [("OpMode DC", words, None, True)]


def test_a_new_name_is_only_a_name():
    renamed = DC.replace("<Name>DC<", "<Name>DC-Synchron<")
    assert clocks(FREE + DC, FREE + renamed) == [
        ("OpMode 0x0300 (sync unit active, SYNC0) name", "DC", "DC-Synchron", False)
    ]


def test_another_default_op_mode_counts():
    assert clocks(FREE + DC, DC + FREE) == [
        (
            "default OpMode",
            "Synchron (position 0), AssignActivate 0x0000 (no DC)",
            "DC (position 0), AssignActivate 0x0300 (sync unit active, SYNC0), CycleTimeSync0 Factor 1",
            True,
        ),
        ("OpMode order", "Synchron, DC", "DC, Synchron", False),
    ]


def test_another_order_of_op_modes_is_told():
    """A choice by position means another one then; by name it does not."""
    second, third = op_mode("DC", "#x300"), op_mode("DC2", "#x700")
    assert clocks(FREE + second + third, FREE + third + second) == [
        ("OpMode order", "Synchron, DC, DC2", "Synchron, DC2, DC", False)
    ]
    assert clocks(FREE + second, FREE + third + second) == [
        ("OpMode DC2", None, "AssignActivate 0x0700 (sync unit active, SYNC0, SYNC1)", False)
    ]


def test_a_superseded_op_mode_gives_the_default_away():
    ignored = op_mode("Synchron", content='<VendorSpecific><TwinCAT IgnoreFromBuildNo="1"/></VendorSpecific>')
    found = clocks(FREE + DC, ignored + DC)
    assert [place for place, _, _, counts in found if counts] == ["default OpMode"]


def test_op_modes_of_one_name_are_matched_by_their_content_first():
    first, second, third = (op_mode("DC", "#x300", f"<ShiftTimeSync0>{shift}</ShiftTimeSync0>") for shift in (1, 2, 3))
    words = "AssignActivate 0x0300 (sync unit active, SYNC0), ShiftTimeSync0 2 ns"
    assert clocks(first + third, first + second + third) == [("OpMode DC", None, words, False)]


def test_absent_and_zero_times_are_the_same():
    zero = "<CycleTimeSync0 Factor='1'>0</CycleTimeSync0><CycleTimeSync1 Factor='0'>0</CycleTimeSync1>"
    assert clocks(DC, op_mode("DC", "#x300", zero)) == []


def test_pdo_lists_of_op_modes():
    lists = '<Sm No="2"><Pdo OSFac="4">#x1600</Pdo></Sm>', '<Sm No="2"><Pdo>#x1600</Pdo><Pdo>#x1601</Pdo></Sm>'
    assert clocks(FREE + op_mode("DC", "#x300", lists[0]), FREE + op_mode("DC", "#x300", lists[1])) == [
        ("OpMode DC SM2 PDOs", "0x1600 4 times", "0x1600, 0x1601", True)
    ]


def test_flags_of_the_clocks():
    assert told("<Dc/>", '<Dc TimeLoopControlOnly="1"/>') == [("TimeLoopControlOnly", "no", "yes", True)]
    assert told("", "<Dc/>") == [("Dc", None, "supported", False)]


def test_long_texts_are_cut_to_their_first_difference():
    xml = "<Info><VendorSpecific><Own>{}</Own></VendorSpecific></Info>"
    ((place, left, right, counts),) = told(xml.format("a" * 500 + "b"), xml.format("a" * 500 + "c"))
    assert (place, counts) == ("VendorSpecific of Info", False)
    assert left == "…" + "a" * 20 + "b</Own></VendorSpecific>"
    assert right == "…" + "a" * 20 + "c</Own></VendorSpecific>"


def test_the_summary_counts_by_area():
    sms = "<Sm>Outputs</Sm>"
    left = device(sms + pdo("RxPdo", "#x1600", 8, attributes='Sm="0"'), name="A")
    right = device(sms + pdo("RxPdo", "#x1600", 16, attributes='Sm="0"'), name="B")
    # name; the entry; the size of the image and the entry at 0.0
    assert summary_words(compared(esi(left), esi(right)), True) == (
        "4 differences, 3 count for a master: 1 PDO, 2 process image"
    )
    assert summary_words(compared(esi(left), esi(left)), True) == "no differences"
    other_name = left.replace(">A<", ">B<")
    same = "1 difference, none counts for a master; the default process image is the same"
    assert summary_words(compared(esi(left), esi(other_name)), True) == same
    assert summary_words(compared(esi(left), esi(other_name)), False) == f"{same} as far as it is described"


def test_texts_about_a_diagnosis():
    """Each is told, and none counts."""
    message = "<DiagMessage><TextId>1</TextId><MessageText>m</MessageText>{}</DiagMessage>"
    profile = "<Profile>{}<DiagMessages>{}</DiagMessages></Profile>"
    causes = "<CauseRemedy><Cause>{}</Cause><Remedy>check</Remedy></CauseRemedy>"
    resets = "<DiagReset><Text>{}</Text><Enum>1</Enum></DiagReset>"
    assert told(
        profile.format("", resets.format("by hand") + message.format(causes.format("hot") + "<Hint>old</Hint>")),
        profile.format("", resets.format("by power") + message.format(causes.format("cold") + "<Hint>new</Hint>")),
    ) == [
        ("diagnosis text 0x0001 causes and remedies", "hot: check", "cold: check", False),
        ("diagnosis text 0x0001 hint", "old", "new", False),
        ("diagnosis texts resets", "1 by hand", "1 by power", False),
    ]
    assert told(
        *(profile.format(f"<DiagFile>{name}</DiagFile>", message.format("")) for name in ("a.xml", "b.xml"))
    ) == [("profile 0 diagnosis files", "a.xml", "b.xml", False)]


@pytest.mark.parametrize("length", [70, 76, 77, 161, 400])
@pytest.mark.parametrize("at", [0, 25, 69, -1])
def test_parts_of_different_texts_are_different(length, at):
    left = "a" * length
    right = left[:at] + "b" + left[at + 1 :] if at >= 0 else left + "b"
    for longest in (76, 160):
        said, also = excerpts(left, right, longest)
        assert said != also
        assert max(len(said), len(also)) <= longest
