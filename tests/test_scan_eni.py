"""ENI files: identities, addresses, numbers as bit patterns, hostile documents."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from esicatalog.identity import Identity
from esicatalog.scan.front import read_eni
from esicatalog.scan.records import ScanError


def eni(*slaves: str) -> bytes:
    inside = "\n".join(f"<Slave>{slave}</Slave>" for slave in slaves)
    return f'<?xml version="1.0"?>\n<EtherCATConfig>\n<Config>\n{inside}\n</Config></EtherCATConfig>'.encode()


def info(vendor="2", product="72100946", revision="1179648", more="") -> str:
    return (
        f"<Info>{more}<VendorId>{vendor}</VendorId><ProductCode>{product}</ProductCode>"
        f"<RevisionNo>{revision}</RevisionNo></Info>"
    )


def messages(scan) -> list[tuple[int, str]]:
    return [(finding.line, finding.message) for finding in scan.findings]


def test_identity_and_addresses():
    more = (
        "<Name><![CDATA[Box 1 & more]]></Name><PhysAddr>1001</PhysAddr><AutoIncAddr>0</AutoIncAddr>"
        '<Identification Value="#x0159"><Ado>#x0012</Ado></Identification><SerialNo>7</SerialNo>'
    )
    scan = read_eni(eni(info(more=more), info(more="<AutoIncAddr>65535</AutoIncAddr>")))
    assert scan.format == "ENI"
    first, second = scan.slaves
    assert first.identity == Identity(2, 0x044C2C52, 0x120000)
    assert (first.line, first.position, first.name, first.serial_no) == (4, 0, "Box 1 & more", 7)
    assert (first.configured_address, first.identification_value, first.identification_register) == (1001, 0x159, 0x12)
    assert (second.line, second.position, second.name, second.configured_address) == (5, 1, None, None)
    assert scan.findings == ()
    assert (first.alias, second.alias) == (0x159, None)


def test_the_identification_of_register_0x12_is_the_station_alias():
    """0x0134 is the AL status code, into which a device writes its own identification when it is asked for it."""
    told = '<Identification Value="7"><Ado>{}</Ado></Identification>'
    scan = read_eni(eni(*(info(more=told.format(register)) for register in (18, 308))))
    assert [(slave.alias, slave.identification_value) for slave in scan.slaves] == [(7, 7), (None, 7)]


@pytest.mark.parametrize(
    ("text", "value"),
    [("0x1234", 0x1234), ("#x1234", 0x1234), (" 4660 ", 0x1234), ("-1", 0xFFFF_FFFF), ("-2147483648", 0x8000_0000)],
)
def test_numbers(text, value):
    assert read_eni(eni(info(product=text))).slaves[0].product_code == value


@pytest.mark.parametrize("text", ["", "x", "4294967296", "-2147483649", "--1", "-", "1.5", "9" * 5000])
def test_a_bad_number_leaves_the_slave_in_the_list(text):
    scan = read_eni(eni(info(product=text)))
    assert scan.slaves[0].identity is None
    assert scan.slaves[0].vendor_id == 2
    assert (4, "slave 0 has no readable ProductCode; kept without") in messages(scan)


def test_a_slave_without_info_stays_in_the_list():
    scan = read_eni(eni("", info()))
    assert [slave.identity is None for slave in scan.slaves] == [True, False]
    assert messages(scan) == [(4, "slave 0 has no readable VendorId, ProductCode, RevisionNo; kept without")]


@pytest.mark.parametrize("names", [('<EtherCATConfig xmlns="{}">', "{}"), ('<e:EtherCATConfig xmlns:e="{}">', "e:{}")])
def test_a_namespace_does_not_matter(names):
    """Some generators write the namespace of EtherCATInfo."""
    root, name = names
    content = eni(info(vendor="154", more="<Name>S</Name><AutoIncAddr>x</AutoIncAddr>")).decode()
    for tag in re.findall(r"</(\w+)>", content):
        content = re.sub(f"(</?){tag}\\b", rf"\g<1>{name.format(tag)}", content)
    opening = f"<{name.format('EtherCATConfig')}>"
    assert opening in content
    content = content.replace(opening, root.format("http://www.ethercat.org/2007/EtherCATInfo"))
    scan = read_eni(content.encode())
    (slave,) = scan.slaves
    assert (slave.identity, slave.name) == (Identity(154, 72100946, 1179648), "S")
    assert [text.partition(";")[0] for _, text in messages(scan)] == ["AutoIncAddr 'x' is not a number"]


def test_mailbox_clocks_and_process_data():
    scan = read_eni(
        eni(
            info()
            + "<Mailbox><Send><Start>4096</Start><Length>128</Length></Send><Recv><Length>192</Length></Recv>"
            + "<Protocol>CoE</Protocol><Protocol>FoE</Protocol></Mailbox>"
            + "<ProcessData><Send><BitLength>16</BitLength></Send><Send><BitLength>8</BitLength></Send></ProcessData>"
            + "<DC><PotentialReferenceClock>0</PotentialReferenceClock><ReferenceClock>true</ReferenceClock>"
            + "<CycleTime0>1000000</CycleTime0><CycleTime1>0</CycleTime1></DC>",
            info() + "<Mailbox><Receive><Length>64</Length></Receive></Mailbox><DC/>",
            info(),
        )
    )
    first, second, third = scan.slaves
    assert (first.mailbox_protocols, first.mailbox_out_bytes, first.mailbox_in_bytes) == (("CoE", "FoE"), 128, 192)
    assert (first.output_bits, first.input_bits, first.dc_capable, first.reference_clock) == (24, 0, True, True)
    assert (second.mailbox_in_bytes, second.dc_capable, second.reference_clock) == (64, True, None)
    assert (first.potential_reference_clock, second.potential_reference_clock) == (False, None)
    assert (first.sync0_cycle_ns, second.sync0_cycle_ns) == (1_000_000, None)
    assert (third.mailbox_protocols, third.output_bits, third.dc_capable) == (None, None, None)


def test_auto_increment_addresses_against_the_order():
    scan = read_eni(eni(info(more="<AutoIncAddr>-1</AutoIncAddr>"), info(more="<AutoIncAddr>0</AutoIncAddr>")))
    assert [slave.position for slave in scan.slaves] == [1, 0]
    assert messages(scan) == [
        (4, "AutoIncAddr says ring position 1, but the slave is listed at 0"),
        (5, "AutoIncAddr says ring position 0, but the slave is listed at 1"),
    ]


def test_a_configuration_without_slaves():
    scan = read_eni(eni())
    assert scan.slaves == ()
    assert messages(scan) == [(1, "the configuration has no slaves")]


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "no ENI file: not well-formed XML"),
        (b"Slave:1\n", "no ENI file: not well-formed XML"),
        (eni(info())[:-5], "no ENI file: not well-formed XML"),
        (b"<EtherCATInfo/>", "an ESI document instead of an ENI file"),
        (b'<EtherCATInfo xmlns="urn:a"/>', "an ESI document instead of an ENI file"),
        (b"<a/>", "root element 'a' instead of an ENI file"),
        (b'<!DOCTYPE EtherCATConfig [<!ENTITY x "2">]><EtherCATConfig/>', "the document declares XML entities"),
        (b'<!DOCTYPE a [<!ENTITY x SYSTEM "file:///etc/hostname">]><EtherCATConfig/>', "the document declares XML"),
    ],
)
def test_other_documents(data, message):
    with pytest.raises(ScanError) as caught:
        read_eni(data)
    assert str(caught.value).startswith(message)
    assert "\n" not in str(caught.value)


def test_entities_do_not_expand():
    levels = "".join(f'<!ENTITY e{level} "{f"&e{level - 1};" * 10}">' for level in range(1, 30))
    document = f'<!DOCTYPE a [<!ENTITY e0 "0123456789">{levels}]><EtherCATConfig v="&e29;">&e29;</EtherCATConfig>'
    with pytest.raises(ScanError):
        read_eni(document.encode())


@given(st.binary() | st.binary().map(lambda data: b"<EtherCATConfig><Config><Slave>" + data))
def test_any_bytes_give_a_scan_or_the_exception(data):
    try:
        read_eni(data)
    except ScanError as error:
        assert "\n" not in str(error)


@given(st.text(st.characters(exclude_categories=("Cc", "Cs"), exclude_characters="<&>"), max_size=12))
def test_any_text_in_a_number_gives_a_scan(text):
    (slave,) = read_eni(eni(info(vendor=text, more=f"<AutoIncAddr>{text}</AutoIncAddr>"))).slaves
    assert slave.vendor_id is None or 0 <= slave.vendor_id <= 0xFFFF_FFFF
