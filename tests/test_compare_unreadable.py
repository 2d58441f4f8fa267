"""Values that cannot be read are told as the vendor wrote them: two such texts are two values, none is another."""

import pytest
from snippets import device, dictionary, esi, pdo
from test_compare import compared, described, told

from esicatalog.model.compare_documents import paired_devices

USINT = "<DataType><Name>USINT</Name><BitSize>8</BitSize></DataType>"
MAPPING = (
    "<RxPdo><Index>{index}</Index><Name>P</Name>{more}<Entry><Index>{entry}</Index><SubIndex>{subindex}</SubIndex>"
    "<BitLen>{bits}</BitLen><Name>E</Name><DataType>USINT</DataType></Entry></RxPdo>"
)


def mapping(index="#x1600", entry="#x7000", subindex="1", bits="8", more="") -> str:
    return MAPPING.format(index=index, entry=entry, subindex=subindex, bits=bits, more=more)


def op_mode(pdo_words: str) -> str:
    return f'<Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate><Sm No="2">{pdo_words}</Sm></OpMode></Dc>'


def command(words: str) -> str:
    return f"<Mailbox><CoE><InitCmd><Transition>PS</Transition>{words}<Data>00</Data></InitCmd></CoE></Mailbox>"


def of_object(words: str, index: str = "#x2000") -> str:
    declared = f"<Object><Index>{index}</Index><Name>O</Name><Type>USINT</Type><BitSize>8</BitSize>{words}</Object>"
    return dictionary(USINT, declared)


def of_sub_item(words: str) -> str:
    record = (
        "<DataType><Name>DT2000</Name><BitSize>16</BitSize><SubItem><SubIdx>0</SubIdx><Name>S</Name><Type>USINT</Type>"
        f"<BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem><SubItem><Name>I</Name><Type>USINT</Type>{words}</SubItem>"
        "</DataType>"
    )
    declared = "<Object><Index>#x2000</Index><Name>O</Name><Type>DT2000</Type><BitSize>16</BitSize></Object>"
    return dictionary(USINT + record, declared)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (mapping(entry="#x7000h"), mapping(entry="#x7010h")),
        (mapping(subindex="x1"), mapping(subindex="x2")),
        (mapping(bits="8 bit"), mapping(bits="16 bit")),
        (mapping(index="#x1600h"), mapping(index="#x1601h")),
        (mapping(more="<Exclude>1601h</Exclude>"), mapping(more="<Exclude>1602h</Exclude>")),
        (mapping(more="<Exclude>1601h</Exclude>"), mapping()),
        (op_mode("<Pdo>1A00h</Pdo>"), op_mode("<Pdo>1A01h</Pdo>")),
        (op_mode("").replace('No="2"', 'No="SM2"'), op_mode("").replace('No="2"', 'No="SM3"')),
        (op_mode('<Pdo OSFac="1x">#x1A00</Pdo>'), op_mode('<Pdo OSFac="2x">#x1A00</Pdo>')),
        (command("<Index>6060h</Index><SubIndex>0</SubIndex>"), command("<Index>6061h</Index><SubIndex>0</SubIndex>")),
        (
            command("<Index>#x6060</Index><SubIndex>a1</SubIndex>"),
            command("<Index>#x6060</Index><SubIndex>a2</SubIndex>"),
        ),
        (command("<IDN>S1</IDN>"), command("<IDN>S2</IDN>")),
        (
            "<Mailbox><CoE><Object><Index>1h</Index></Object></CoE></Mailbox>",
            "<Mailbox><CoE><Object><Index>2h</Index></Object></CoE></Mailbox>",
        ),
        (of_object("", "2000h"), of_object("", "2001h")),
        (of_object("<Info><MinValue>a</MinValue></Info>"), of_object("<Info><MinValue>b</MinValue></Info>")),
        (of_object("<Info><MaxValue>a</MaxValue></Info>"), of_object("")),
        (of_sub_item("<SubIdx>x1</SubIdx>"), of_sub_item("<SubIdx>x2</SubIdx>")),
        (of_sub_item("<BitSize>8 bit</BitSize>"), of_sub_item("<BitSize>9 bit</BitSize>")),
        (of_sub_item("<BitOffs>x8</BitOffs>"), of_sub_item("<BitOffs>x9</BitOffs>")),
        ("<Profile><ProfileNo>402a</ProfileNo></Profile>", "<Profile><ProfileNo>402b</ProfileNo></Profile>"),
        (
            "<Profile><ProfileNo>5001</ProfileNo><AddInfo>7a</AddInfo></Profile>",
            "<Profile><ProfileNo>5001</ProfileNo><AddInfo>7b</AddInfo></Profile>",
        ),
        ("<HideType RevisionNo='1h'/>", "<HideType RevisionNo='2h'/>"),
    ],
)
def test_two_texts_are_two_values(left, right):
    assert told(left, right)
    assert told(right, left)


def test_a_subindex_that_cannot_be_read_is_told_once():
    (found,) = compared(esi(device(mapping(subindex="x1"))), esi(device(mapping(subindex="x2"))))
    assert (found.left, found.right) == ("0x7000:? 'x1' (8 bit) USINT E", "0x7000:? 'x2' (8 bit) USINT E")


@pytest.mark.parametrize("other", ["#x1010533005", ""])
def test_revisions(other):
    """More than 32 bits are no RevisionNo."""
    left, right = (
        f'<Device Physics="YY"><Type ProductCode="#x1"{code}>T</Type><Name>N</Name></Device>'
        for code in (' RevisionNo="#x1010533004"', f' RevisionNo="{other}"' if other else "")
    )
    (found,) = compared(esi(left), esi(right))
    assert (found.place, found.left, found.right, found.counts) == ("revision", "#x1010533004", other or None, True)


def test_devices_belong_together_by_what_stands_for_the_revision():
    documents = [
        [described(esi(device(revision=revision, type_text="T"))) for revision in order]
        for order in (("#x1010533004", "#x1010533005"), ("#x1010533005", "#x1010533004"))
    ]
    for left, right in paired_devices(*documents):
        assert left.device.spelling == right.device.spelling


def test_an_entry_is_told_with_what_could_not_be_read():
    (found,) = [item for item in told(mapping(bits="8 bit"), mapping(bits="16 bit")) if "entry" in item[0]]
    assert found == (
        "RxPDO 0x1600 entry 1",
        "0x7000:01 (no length) (bit_length 8 bit) USINT E",
        "0x7000:01 (no length) (bit_length 16 bit) USINT E",
        True,
    )


def test_a_pdo_with_another_unreadable_index_is_another_one():
    assert [item[0] for item in told(mapping(index="#x1600h"), mapping(index="#x1601h"))] == [
        "RxPDO #x1600h",
        "RxPDO #x1601h",
    ]


def test_modules_and_what_slots_say_of_them():
    slots = "<Slots><Slot><Name>S</Name><ModuleIdent{}>{}</ModuleIdent></Slot></Slots>"
    left, right = (device(slots.format(*words)) for words in (("", "1h"), ("", "2h")))
    (found,) = compared(esi(left), esi(right))
    assert (found.place, found.counts) == ("slot 0 modules", True)
    default, none = (device(slots.format(words, "#x1")) for words in (' Default="y"', ""))
    assert [item.place for item in compared(esi(default), esi(none))] == ["slot 0 modules"]
    groups = "<Slots><ModulePdoGroup Alignment='{}'>G</ModulePdoGroup></Slots>"
    assert compared(esi(device(groups.format("a"))), esi(device(groups.format("b"))))


def test_an_enumeration():
    types = USINT + (
        "<DataType><Name>E</Name><BaseType>USINT</BaseType><BitSize>8</BitSize>"
        "<EnumInfo><Text>on</Text><Enum>{}</Enum></EnumInfo></DataType>"
    )
    declared = "<Object><Index>#x2000</Index><Name>O</Name><Type>E</Type><BitSize>8</BitSize></Object>"
    (found,) = told(*(dictionary(types.format(words), declared) for words in ("1x", "2x")))
    assert found[0] == "0x2000 values that cannot be read"
    assert "DataType E EnumInfo/Enum: '1x'" in found[1]


def test_the_same_text_is_no_difference():
    content = mapping("1600h", "7000h", "x", "8 bit") + of_object("<Info><MinValue>a</MinValue></Info>")
    assert told(content, content + "<!-- -->") == []
    assert told(pdo("RxPdo", "#x1600", 8), pdo("RxPdo", "5632", 8).replace("RxPdo 5632", "RxPdo #x1600")) == []
