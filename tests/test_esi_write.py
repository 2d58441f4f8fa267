"""What the writer makes of records: order, spelling, required elements, texts, XML of the vendor's own."""

from pathlib import Path

import msgspec
import pytest
from lxml import etree
from snippets import device, dictionary, esi, only_device, read
from test_maximal import AFTER_1_17, MAXIMAL

from esicatalog.esi.binding import Record
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.device import Device, Fmmu, Port, SyncManager
from esicatalog.esi.records.diagnostics import DiagMessage, Diagnostics
from esicatalog.esi.records.dictionary import ArrayInfo, DataType, Dictionary, Flags, InfoSubItem, Object
from esicatalog.esi.records.document import DiagInfo, DictInfo, EsiInfo, Group, InfoList, ModuleInfo, Vendor
from esicatalog.esi.records.mailbox import InitCmd, Mailbox
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Exclude, Pdo
from esicatalog.esi.records.profile import Profile
from esicatalog.esi.records.slots import Slot, SlotModuleIdent, SlotSelection
from esicatalog.esi.write import record_element, write_esi


def xml(record: Record, tag: str) -> str:
    return etree.tostring(record_element(record, tag), encoding="unicode")


def tags(record: Record, tag: str) -> list[str]:
    return [str(child.tag) for child in record_element(record, tag)]


def written(text: str) -> str:
    """The first device of a document, read and written again."""
    return xml(only_device(text), "Device")


def same_when_written(text: str) -> Device:
    """The device of a document, which has to read the same after writing."""
    info = read(text).document.infos[0]
    assert read(write_esi(info)).document.infos[0] == info
    return info.devices[0]


# Numbers


def test_numbers_without_a_spelling_are_canonical():
    record = SyncManager(
        usage="Outputs", start_address=0x1100, control_byte=0x24, default_size=8, enable=1, virtual=False
    )
    assert xml(record, "Sm") == (
        '<Sm DefaultSize="8" StartAddress="#x1100" ControlByte="#x0024" Enable="1" Virtual="0">Outputs</Sm>'
    )


@pytest.mark.parametrize(
    ("product", "revision"),
    [("1026", "#x10000"), ("0x402", "#x00010000"), ("#x0x402", "65536"), ("#x1010533004", "none")],
)
def test_identities_stand_as_the_vendor_spelled_them(product, revision):
    assert f'<Type ProductCode="{product}" RevisionNo="{revision}">T1</Type>' in written(
        esi(device(product=product, revision=revision))
    )


@pytest.mark.parametrize("text", ["true", "false", "0", "1", "TRUE", "yes"])
def test_booleans_stand_as_the_vendor_spelled_them(text):
    assert f'<Mailbox><CoE SdoInfo="{text}"/></Mailbox>' in written(
        esi(device(f'<Mailbox><CoE SdoInfo="{text}"/></Mailbox>'))
    )


def test_items_of_a_list_stand_as_the_vendor_spelled_them():
    selection = "<Name>S</Name><ModuleIdent>#x0000000A</ModuleIdent><ModuleIdent>11</ModuleIdent><ModuleIdent/>"
    body = f"<SlotSelections>{selection}</SlotSelections>"
    assert body in written(esi(device(f"<Slots>{body}</Slots>")))
    assert xml(SlotSelection(module_idents=(10, 11)), "SlotSelections") == (
        "<SlotSelections><ModuleIdent>#x0000000A</ModuleIdent><ModuleIdent>#x0000000B</ModuleIdent></SlotSelections>"
    )


def test_a_spelling_counts_only_while_it_says_the_value():
    pdo = only_device(esi(device("<RxPdo><Index>5632</Index><Name>P</Name></RxPdo>"))).rx_pdos[0]
    assert "<Index>5632</Index>" in xml(pdo, "RxPdo")
    moved = msgspec.structs.replace(pdo, pdo_index=0x1610)
    assert "<Index>#x1610</Index>" in xml(moved, "RxPdo"), "5632 is 0x1600"


# Order and required elements


def test_children_of_an_object_stand_in_the_order_of_the_schema():
    record = Object(
        default_data="00",
        unit=1,
        object_index=0x2000,
        names=(Name(text="O"),),
        type="USINT",
        bit_size=8,
        flags=Flags(access="rw", backup=1, setting=1, transition="PS", sdo_access="CompleteAccess"),
        xml="<Xml></Xml>",
    )
    assert xml(record, "Object") == (
        "<Object><Index>#x2000</Index><Name>O</Name><Type>USINT</Type><BitSize>8</BitSize>"
        "<Info><DefaultData>00</DefaultData><Unit>#x0001</Unit></Info>"
        "<Flags><Access>rw</Access><Transition>PS</Transition><SdoAccess>CompleteAccess</SdoAccess>"
        "<Backup>1</Backup><Setting>1</Setting></Flags><Xml/></Object>"
    )


def test_children_of_a_device_stand_in_the_order_of_the_schema():
    record = Device(
        type="T",
        sci="<Sci></Sci>",
        physics="YY",
        names=(Name(text="N"),),
        ports=(Port(type="MII"),),
        e_bus_current_ma=0,
        identification_ado=0x12,
        info_vendor_specific="<VendorSpecific><a></a></VendorSpecific>",
        group_type="G",
        sync_managers=(SyncManager(usage="Outputs"),),
        fmmus=(Fmmu(usage="Outputs"),),
        dc=True,
        has_slots=True,
    )
    assert tags(record, "Device") == ["Sci", "Type", "Name", "Info", "GroupType", "Fmmu", "Sm", "Dc", "Slots"]
    (info,) = record_element(record, "Device").iterchildren("Info")
    assert [child.tag for child in info] == ["Electrical", "Port", "VendorSpecific", "IdentificationAdo"]


def test_what_a_vendor_put_in_another_order_gets_that_of_the_schema():
    body = (
        "<Sm>Outputs</Sm><Fmmu>Outputs</Fmmu><RxPdo><Exclude>#x1601</Exclude><Name>P</Name><Index>#x1600</Index></RxPdo>"
        "<Mailbox><FoE/><CoE/><EoE/></Mailbox>"
    )
    assert written(esi(device(body))).endswith(
        "<Fmmu>Outputs</Fmmu><Sm>Outputs</Sm>"
        "<RxPdo><Index>#x1600</Index><Name>P</Name><Exclude>#x1601</Exclude></RxPdo>"
        "<Mailbox><EoE/><CoE/><FoE/></Mailbox></Device>"
    )


def test_repeated_elements_keep_their_order():
    record = only_device(esi(device("<Sm>B</Sm><Fmmu/><Sm>A</Sm><Sm>B</Sm>")))
    assert "<Fmmu/><Sm>B</Sm><Sm>A</Sm><Sm>B</Sm>" in xml(record, "Device")


def test_required_elements_stand_even_when_empty():
    assert xml(Dictionary(), "Dictionary") == "<Dictionary><Objects/></Dictionary>"
    assert xml(InfoSubItem(name="a"), "SubItem") == "<SubItem><Name>a</Name><Info/></SubItem>"
    assert xml(ModuleInfo(), "EtherCATModule") == "<EtherCATModule><Modules/></EtherCATModule>"
    assert xml(EsiInfo(vendor=Vendor(vendor_id=1)), "EtherCATInfo") == (
        "<EtherCATInfo><Vendor><Id>#x00000001</Id></Vendor>"
        "<Descriptions><Groups/><Devices/></Descriptions></EtherCATInfo>"
    )


def test_presence_is_an_empty_element():
    assert xml(Mailbox(foe=True, coe=True, coe_sdo_info=True), "Mailbox") == (
        '<Mailbox><CoE SdoInfo="1"/><FoE/></Mailbox>'
    )
    assert xml(Mailbox(), "Mailbox") == "<Mailbox/>"


def test_absent_and_empty_texts_differ():
    assert xml(InitCmd(), "InitCmd") == "<InitCmd/>"
    assert xml(InitCmd(comment="", data=""), "InitCmd") == "<InitCmd><Data/><Comment/></InitCmd>"


# Attributes, texts, languages


def test_slot_attributes_stand_on_the_index():
    entry = Entry(entry_index=0x7000, depend_on_slot=True, subindex=1, bit_length=8)
    record = Pdo(
        pdo_index=0x1600,
        depend_on_slot=True,
        depend_on_slot_group=False,
        excludes=(Exclude(pdo_index=0x1601, depend_on_slot=True),),
        entries=(entry,),
    )
    assert xml(record, "RxPdo") == (
        '<RxPdo><Index DependOnSlot="1" DependOnSlotGroup="0">#x1600</Index><Exclude DependOnSlot="1">#x1601</Exclude>'
        '<Entry><Index DependOnSlot="1">#x7000</Index><SubIndex>1</SubIndex><BitLen>8</BitLen></Entry></RxPdo>'
    )
    slot = Slot(module_idents=(SlotModuleIdent(module_ident=0xB01, is_default=1),), min_instances=0, max_instances=2)
    assert xml(slot, "Slot") == (
        '<Slot MinInstances="0" MaxInstances="2"><ModuleIdent Default="1">#x00000B01</ModuleIdent></Slot>'
    )


def test_restrictions_stand_on_the_access():
    record = Flags(access="rw", write_restrictions="PreOP", pdo_mapping="R")
    assert xml(record, "Flags") == (
        '<Flags><Access WriteRestrictions="PreOP">rw</Access><PdoMapping>R</PdoMapping></Flags>'
    )


def test_initcmds_of_several_transitions():
    record = InitCmd(
        transitions=("PS", "SO"),
        object_index=0x1C12,
        subindex=1,
        data="0016",
        adapt_automatically=True,
        complete_access=False,
    )
    assert xml(record, "InitCmd") == (
        '<InitCmd CompleteAccess="0"><Transition>PS</Transition><Transition>SO</Transition><Index>#x1C12</Index>'
        '<SubIndex>1</SubIndex><Data AdaptAutomatically="1">0016</Data></InitCmd>'
    )


def test_names_in_all_languages():
    record = Group(type="G", names=(Name(text="Drives", lcid=1033), Name(text="驱动器", lcid=2052), Name(text="")))
    assert xml(record, "Group") == (
        '<Group><Type>G</Type><Name LcId="1033">Drives</Name><Name LcId="2052">驱动器</Name><Name/></Group>'
    )


def test_texts_are_escaped():
    comment = "<Comment>a &lt; b &amp;&amp; c &gt; d &quot;e&quot;\n\tnext&#13;last</Comment>"
    found = same_when_written(esi(device(comment + '<RxPdo Ref="&lt;&quot;&amp;&#10;&#9;x"/>')))
    assert found.comments[0].text == 'a < b && c > d "e"\n\tnext\rlast'
    assert found.rx_pdos[0].ref == '<"&\n\tx'
    assert "a &lt; b &amp;&amp; c &gt; d" in xml(found, "Device")


def test_characters_outside_of_xml_are_replaced():
    found = read(esi(device("<Comment>a&#1;b</Comment>"))).document
    assert found.recovered
    assert "<Comment>a\ufffdb</Comment>" in xml(found.infos[0].devices[0], "Device")


def test_leading_blanks_of_physics_stay():
    assert written(esi(device().replace('Physics="YY"', 'Physics=" Y K "'))).startswith('<Device Physics=" Y K">')


def test_images_are_hex_of_the_file():
    text = "<ImageData16x14>\n 424d 00\n 0a</ImageData16x14>"
    assert "<ImageData16x14>424D000A</ImageData16x14>" in written(esi(device(text)))
    assert "<ImageData16x14>42 4x</ImageData16x14>" in written(esi(device("<ImageData16x14>42 4x</ImageData16x14>")))


def test_hex_bytes_stand_as_the_vendor_wrote_them():
    types = "<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>"
    info = "<Info><DefaultData>00aB</DefaultData></Info>"
    objects = f"<Object><Index>#x2000</Index><Name>O</Name><Type>UINT</Type><BitSize>16</BitSize>{info}</Object>"
    assert info in written(esi(device(dictionary(types, objects))))


# XML of the vendor's own


@pytest.mark.parametrize(
    "raw",
    [
        "<VendorSpecific><A b='1'>text</A><A/></VendorSpecific>",
        "<VendorSpecific>text <b>bold</b> <i>and</i> tail</VendorSpecific>",
        "<VendorSpecific><a> </a><b>  two  </b></VendorSpecific>",
        '<VendorSpecific><v:a xmlns:v="http://example.org/v" v:b="1"><v:c/></v:a></VendorSpecific>',
        '<VendorSpecific><d xmlns="urn:d"><e/></d><d/></VendorSpecific>',
        '<VendorSpecific xml:space="preserve"> <a/> </VendorSpecific>',
        "<VendorSpecific><a>&lt;&amp;&gt;&#13;</a></VendorSpecific>",
        "<VendorSpecific><![CDATA[<not> & markup]]></VendorSpecific>",
        "<VendorSpecific><never:declared a='1'/></VendorSpecific>",
    ],
)
def test_vendor_specific_xml_reads_the_same(raw):
    for place in ("{}", "<Dc>{}</Dc>", "<Info>{}</Info>", "<Profile>{}</Profile>"):
        same_when_written(esi(device(place.format(raw))))


# Values that no record holds


@pytest.mark.parametrize(
    "body",
    [
        "<Odd a='1'>x</Odd>",
        "<Odd/>",
        "<Odd><Deep><Deeper at='2'/></Deep></Odd>",
        "<Odd>1</Odd><Odd>2</Odd><Odd><In>3</In><In>4</In></Odd>",
        "<Odd><b>bold</b> tail</Odd>",
        "<Dc odd='1'>stray</Dc>",
        "<Sm>Outputs</Sm><Sm odd='2'>Inputs</Sm>",
        "<RxPdo><Index odd='3'>#x1600</Index><Name>P</Name><Odd>4</Odd></RxPdo>",
        "<Mailbox><VoE><Own>5</Own></VoE></Mailbox>",
        "<GroupType>again</GroupType>",
        "<Mailbox><CoE/></Mailbox><Mailbox><CoE SdoInfo='1'/></Mailbox>",
        "<Mailbox><CoE/></Mailbox><Mailbox><EoE/><FoE/></Mailbox>",
        "<Odd><In/><In/><Other> </Other></Odd>",
        "<Info odd='6'/><Info><Odd>7</Odd></Info>",
        "<Info><Port/><Port><Odd/></Port></Info>",
        "<Dc><OpMode/>stray</Dc>",
        "stray<Odd>8</Odd>",
        '<Odd xmlns:o="http://example.org/o/p" o:a="9"><o:in>10</o:in></Odd>',
        '<Dc xmlns:o="http://example.org/o" o:a="11"/>',
    ],
)
def test_unmapped_values_come_back_where_they_were(body):
    assert same_when_written(esi(device(body))).unmapped


def test_unmapped_values_of_modules_come_back():
    text = esi(modules="<Module odd='1'><Type ModuleIdent='1' odd='2'>M</Type><Name>M</Name><Odd>3</Odd></Module>")
    info = read(text).document.infos[0]
    assert len(info.modules[0].unmapped) == 3
    assert read(write_esi(info)).document.infos[0] == info


def test_unmapped_values_come_in_the_order_of_the_schema():
    info = read(esi(device("<Sm odd='1'>Outputs</Sm><Fmmu odd='2'/>"))).document.infos[0]
    again = read(write_esi(info)).document.infos[0].devices[0]
    assert [(item.path, item.value) for item in again.unmapped] == [("Fmmu/@odd", "2"), ("Sm/@odd", "1")]


def test_what_has_no_path_of_names_is_left_out():
    assert "Odd" not in written(esi(device("<never:Odd>1</never:Odd>")))
    entity = '<!DOCTYPE EtherCATInfo [<!ENTITY e "x">]>' + esi(device("<Comment>&e;</Comment>"))
    assert "<Comment/>" in written(entity)


# Documents


def test_a_document_is_declared_and_indented():
    info = EsiInfo(schema_version="1.17", vendor=Vendor(vendor_id=0xE5C, names=(Name(text="Grün"),)))
    assert write_esi(info).decode() == (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<EtherCATInfo Version="1.17">\n'
        "  <Vendor>\n"
        "    <Id>#x00000E5C</Id>\n"
        "    <Name>Grün</Name>\n"
        "  </Vendor>\n"
        "  <Descriptions>\n"
        "    <Groups/>\n"
        "    <Devices/>\n"
        "  </Descriptions>\n"
        "</EtherCATInfo>\n"
    )


def test_every_kind_of_document_reads_the_same():
    module = Module(type="M", module_ident=1, names=(Name(text="M"),))
    infos = (EsiInfo(vendor=Vendor(vendor_id=1)), EsiInfo(vendor=Vendor(vendor_id=2)))
    data_type = DataType(name="A", base_type="UINT", bit_size=32, array_infos=(ArrayInfo(lbound=1, elements=2),))
    a_dictionary = Dictionary(data_types=(data_type,))
    texts = Diagnostics(diag_messages=(DiagMessage(text_id=1, message_texts=(Name(text="t"),), diag_reset=2),))
    assert read(write_esi(InfoList(infos=infos))).document.infos == infos
    found = read(write_esi(ModuleInfo(vendor=Vendor(vendor_id=1), modules=(module,)))).document
    assert (found.root, found.infos[0].modules) == ("EtherCATModule", (module,))
    found = read(write_esi(DictInfo(dictionary=a_dictionary))).document
    assert (found.root, found.dictionary) == ("EtherCATDict", a_dictionary)
    found = read(write_esi(DiagInfo(diag_messages=texts))).document
    assert (found.root, found.diag_messages) == ("EtherCATDiag", texts)


def test_a_reference_is_written_as_a_reference():
    profile = Profile(profile_no=402, dictionary_file="sub\\d.xml", diag_files=("a.xml", "b.xml"))
    assert xml(profile, "Profile") == (
        "<Profile><ProfileNo>402</ProfileNo><DictionaryFile>sub\\d.xml</DictionaryFile>"
        "<DiagFile>a.xml</DiagFile><DiagFile>b.xml</DiagFile></Profile>"
    )


@pytest.mark.parametrize("content", [MAXIMAL.read_bytes(), AFTER_1_17.encode()], ids=["1.17", "later"])
def test_a_document_with_everything_reads_the_same(content):
    info = read(content).document.infos[0]
    again = read(write_esi(info))
    assert again.findings == ()
    assert again.document.infos[0] == info


def test_a_document_with_everything_is_written_valid(corpus: Path):
    schema = etree.XMLSchema(etree.parse(corpus / "xsd" / "1.17" / "EtherCATInfo.xsd"))
    text = write_esi(read(MAXIMAL.read_bytes()).document.infos[0])
    assert schema.validate(etree.fromstring(text)), schema.error_log


@pytest.mark.parametrize("name", ["eyou_servo_module", "io_terminal_8di_8do", "l6n_drive", "two_axis_modular_drive"])
def test_our_examples_read_the_same(data: Path, name: str):
    info = read((data / f"{name}.xml").read_bytes()).document.infos[0]
    assert read(write_esi(info)).document.infos[0] == info
