"""An image against a description that says less than it, or says it in other words."""

import msgspec
import pytest
from snippets import device, esi, pdo, read
from test_export_configuration import subject

from esicatalog.export.sii import described_image
from esicatalog.export.sii_verify import verify_image
from esicatalog.export.subject import subjects_of_document
from esicatalog.sii.image import RawCategory

WHOLE = (
    "<Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu><Fmmu>MBoxState</Fmmu>"
    '<Sm DefaultSize="128" StartAddress="#x1000" ControlByte="#x26" Enable="1">MBoxOut</Sm>'
    '<Sm DefaultSize="128" StartAddress="#x1080" ControlByte="#x22" Enable="1">MBoxIn</Sm>'
    '<Sm DefaultSize="2" StartAddress="#x1100" ControlByte="#x64" Enable="1">Outputs</Sm>'
    '<RxPdo Sm="2"><Index>#x1600</Index><Name>R</Name><Entry><Index>#x7000</Index><SubIndex>1</SubIndex>'
    "<BitLen>16</BitLen><Name>o</Name><DataType>UINT</DataType></Entry></RxPdo><Mailbox><CoE/></Mailbox>"
    "<Dc><OpMode><Name>DC</Name><Desc>with SYNC0</Desc><AssignActivate>#x300</AssignActivate></OpMode></Dc>"
    "<Eeprom><ByteSize>2048</ByteSize><ConfigData>05080000000000000000000000FF</ConfigData>"
    "<BootStrap>0010800080108000</BootStrap></Eeprom>"
)
IMAGE = described_image(subject(WHOLE))


def told(content: str, image=IMAGE) -> list[str]:
    return [item.text for item in verify_image(image, subject(content))]


def without(*parts: str) -> str:
    content = WHOLE
    for part in parts:
        assert part in content
        content = content.replace(part, "")
    return content


@pytest.mark.parametrize(
    "content",
    [
        WHOLE,
        without(' DefaultSize="128"'),
        without(' StartAddress="#x1000"', ' ControlByte="#x26"'),
        WHOLE.replace(">MBoxOut</Sm>", "/>").replace(">MBoxIn</Sm>", "/>").replace(">Outputs</Sm>", "/>"),
        WHOLE.replace(' ControlByte="#x26" Enable="1">MBoxOut', ">"),
        without("<DataType>UINT</DataType>"),
        WHOLE.replace("UINT", "DT1234"),
        without("<BitLen>16</BitLen>"),
        without("<Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu><Fmmu>MBoxState</Fmmu>"),
        WHOLE.replace("<Fmmu>Outputs</Fmmu>", "<Fmmu/>"),
        without("<AssignActivate>#x300</AssignActivate>"),
        without("<BootStrap>0010800080108000</BootStrap>"),
    ],
)
def test_what_is_not_said_is_no_difference(content):
    assert told(content) == []


def test_ports_and_current_that_are_not_said_are_no_difference():
    general = msgspec.structs.replace(IMAGE.general, e_bus_current_ma=130)
    categories = tuple(general if item == IMAGE.general else item for item in IMAGE.categories)
    image = msgspec.structs.replace(IMAGE, categories=categories)
    text = esi(device(WHOLE)).replace('Physics="YY"', "")
    (described,) = subjects_of_document(read(text).document, "x.xml")
    assert verify_image(image, described) == ()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (
            WHOLE.replace('DefaultSize="128" StartAddress="#x1000"', 'DefaultSize="0" StartAddress="#x1000"'),
            "bytes of the receive mailbox: the image has 128; described is 0",
        ),
        (
            WHOLE.replace("0010800080108000", "00" * 8),
            "bytes of the bootstrap send mailbox: the image has 128; described",
        ),
        (WHOLE.replace("0508", "0000"), "PDI control: the image has 0x0805; described is 0x0000"),
        (
            WHOLE.replace("<Mailbox><CoE/></Mailbox>", "<Mailbox/>"),
            "mailbox protocols: the image has CoE; described is none",
        ),
        (
            without("<Mailbox><CoE/></Mailbox>"),
            "mailbox protocols: the image has CoE; the description has no Mailbox element",
        ),
        (WHOLE.replace("Inputs</Fmmu>", "Outputs</Fmmu>"), "FMMU1: the image has Inputs; described is Outputs"),
        (
            WHOLE.replace("UINT", "INT"),
            "RxPDO 0x1600, entry 1: the image has 0x7000:01, 16 bits, UINT; described is 0x7000:01, 16 bits, INT",
        ),
    ],
)
def test_what_is_said_is_compared_also_zeros(content, words):
    assert any(text.startswith(words) for text in told(content))


def test_descriptions_of_op_modes_are_compared_with_an_image_that_has_some():
    (clocks,) = (item for item in IMAGE.categories if item.category_type == 60)
    named = msgspec.structs.replace(clocks.modes[0], description_string_number=clocks.modes[0].name_string_number)
    own = msgspec.structs.replace(clocks, modes=(named,))
    image = msgspec.structs.replace(
        IMAGE, categories=tuple(own if item == clocks else item for item in IMAGE.categories)
    )
    assert told(WHOLE, image) == ["description of OpMode 1: the image has 'DC'; described is 'with SYNC0'"]
    assert told(WHOLE.replace("<Desc>with SYNC0", "<Desc>DC"), image) == []
    assert told(WHOLE.replace("<Desc>with SYNC0</Desc>", ""), image) == [
        "description of OpMode 1: the image has 'DC'; not described"
    ]


def test_texts_may_be_in_any_language_of_the_description():
    names = '<Name LcId="1033">Drive</Name><Name LcId="1031">Antrieb</Name>'
    text = esi(device(WHOLE)).replace("<Name>N</Name>", names)
    (described,) = subjects_of_document(read(text).document, "x.xml")
    for language in (1033, 1031):
        assert verify_image(described_image(described, language=language), described) == ()
    (other,) = verify_image(IMAGE, described)
    assert other.text == "name: the image has 'N'; described is 'Drive'"


@pytest.mark.parametrize(
    ("said", "number", "word"),
    [("<Su/>", 43, "described, not computed here"), ("", 43, "not described"), ("<Su/>", 42, "not described")],
)
def test_a_category_that_is_not_computed_is_not_called_undescribed(said, number, word):
    raw = RawCategory(category_type=number, data=b"\xf0\xff")
    image = msgspec.structs.replace(IMAGE, categories=(*IMAGE.categories, raw))
    content = WHOLE.replace("<RxPdo", f"{said}<RxPdo")
    (text,) = told(content, image)
    assert text.endswith(f"the image has f0 ff; {word}")


def test_pdos_are_compared_by_index():
    """A further PDO before the described one does not shift what is compared."""
    image = described_image(subject(WHOLE.replace("<RxPdo", pdo("RxPdo", "#x1601", 8) + "<RxPdo", 1)))
    found = told(without("<DataType>UINT</DataType>"), image)
    assert not any("0x1600" in text for text in found)
    assert any(text.startswith("RxPDO 0x1601: the image has") for text in found)
