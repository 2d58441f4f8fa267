"""``ethercat cstruct``: byte for byte what IgH's own formatter made of real EEPROM images, and the same from ESI."""

from pathlib import Path

import pytest
from snippets import device, esi, pdo, read
from test_drive_modes import all_devices
from test_export_compile import IGH_15, check_syntax, needs_gcc

from esicatalog.export.choice import Choice
from esicatalog.export.configuration import configure
from esicatalog.export.cstruct import cstruct_of_configuration, cstruct_of_image
from esicatalog.export.sii import described_image
from esicatalog.export.subject import Subject, subjects_of_document
from esicatalog.identity import Identity
from esicatalog.sii.files import read_sii
from esicatalog.sii.image import General, RxPdos, SiiImage, Strings, SyncManagers
from esicatalog.sii.records import Pdo, PdoEntry, SiiString, SyncManager

DUMPS_WITH_OUTPUT = 35


@pytest.fixture(scope="module")
def dumps(corpus: Path) -> list[tuple[Path, Path]]:
    """Images with what IgH printed for them."""
    folder = corpus / "sii"
    found = []
    for dump in sorted(path for path in folder.rglob("*") if path.is_file()):
        printed = corpus / "igh" / f"{str(dump.relative_to(folder)).replace('/', '~', 1)}.cstruct.h"
        if printed.is_file():
            found.append((dump, printed))
    if not found:
        pytest.skip(f"no EEPROM dumps at {folder}")
    return found


def test_every_real_image_prints_as_igh_prints_it(dumps):
    for dump, printed in dumps:
        text = cstruct_of_image(read_sii(dump.read_bytes()))
        assert text.encode("utf-8", "surrogateescape") == printed.read_bytes(), dump.name
    assert len(dumps) == DUMPS_WITH_OUTPUT


SAME_DEVICE = ("EL2004", "EasyCAT_128_128", "EasyCAT_16_16", "EasyCAT_64_64", "LAB_1", "LAB_2", "DemoHMI_Custom")
"""Dumps whose devices, as the identity tells, are described in the corpus too."""


@pytest.mark.corpus
def test_descriptions_print_what_igh_printed_for_the_devices(corpus, dumps):
    described = {}
    for info, found, modules in all_devices(corpus):
        if info.vendor is not None and None not in (info.vendor.vendor_id, found.product_code, found.revision_no):
            identity = Identity(info.vendor.vendor_id, found.product_code, found.revision_no)
            described[identity] = Subject(identity.vendor_id, None, found, tuple(modules))
    seen = set()
    for dump, printed in dumps:
        header = read_sii(dump.read_bytes()).header
        name = next((name for name in SAME_DEVICE if name in dump.name), None)
        if name is not None:
            subject = described[Identity(header.vendor_id, header.product_code, header.revision_no)]
            assert cstruct_of_configuration(configure(subject)) == printed.read_text(), dump.name
            seen.add(name)
    assert seen == set(SAME_DEVICE)


def image(*pdos: Pdo, strings: tuple[bytes, ...] = (), sync_managers: int = 4) -> SiiImage:
    """An image with these RxPDOs; strings are numbered from 1, the first is the order number."""
    categories = (
        Strings(strings=tuple(SiiString(data=data) for data in strings)),
        General(order_string_number=1),
        SyncManagers(sync_managers=tuple(SyncManager(control_byte=0x64) for _ in range(sync_managers))),
        RxPdos(pdos=pdos),
    )
    return SiiImage(categories=categories if sync_managers else categories[:2])


def test_without_sync_managers_nothing_is_printed():
    assert cstruct_of_image(image(sync_managers=0, strings=(b"X",))) == ""


def test_unassigned_pdos_do_not_count():
    text = cstruct_of_image(image(Pdo(pdo_index=0x1600, sm=0xFF), Pdo(pdo_index=0x1601, sm=2), strings=(b"X",)))
    assert "0x1600" not in text
    assert "    {0x1601, 0, NULL},\n" in text
    assert "    {2, EC_DIR_OUTPUT, 1, slave_0_pdos + 0, EC_WD_ENABLE},\n" in text
    assert "pdo_entries" not in text


def test_names_end_at_63_bytes_and_at_a_zero():
    entries = (PdoEntry(entry_index=1, name_string_number=2), PdoEntry(entry_index=2, name_string_number=3))
    text = cstruct_of_image(image(Pdo(pdo_index=0x1600, sm=2, entries=entries), strings=(b"X", b"n" * 70, b"a\0b")))
    assert f"/* {'n' * 63} */" in text
    assert "/* a */" in text


def test_bytes_of_any_encoding_come_through():
    entries = (PdoEntry(entry_index=1, name_string_number=2, bit_length=8),)
    text = cstruct_of_image(image(Pdo(pdo_index=0x1600, sm=2, entries=entries), strings=(b"X", b"gr\xf6\xdfe")))
    assert b"/* gr\xf6\xdfe */" in text.encode("utf-8", "surrogateescape")


@needs_gcc
def test_a_name_cannot_end_its_comment(tmp_path):
    entries = (PdoEntry(entry_index=1, name_string_number=2, bit_length=8),)
    hostile = (b"*/ int order; /*", b"*/ int injected; /* \r\n")
    text = cstruct_of_image(image(Pdo(pdo_index=0x1600, sm=2, entries=entries), strings=hostile))
    assert text.count("*/") == 2
    check_syntax(tmp_path, ["#include <ecrt.h>\n" + text], IGH_15, "-Wno-missing-field-initializers")


SMS = (
    '<Sm ControlByte="#x26">MBoxOut</Sm><Sm ControlByte="#x22">MBoxIn</Sm><Sm ControlByte="#x64">Outputs</Sm>'
    '<Sm ControlByte="#x20">Inputs</Sm>'
)


def test_virtual_sync_managers_are_in_the_image_too():
    """The EEPROM image has them, so the tool prints them, here as inputs: no ControlByte."""
    content = SMS + '<Sm Virtual="1">Inputs</Sm>' + pdo("TxPdo", "#x1A00", 8, attributes='Sm="4"')
    (subject,) = subjects_of_document(read(esi(device(content))).document, "x.xml")
    text = cstruct_of_configuration(configure(subject))
    assert "    {4, EC_DIR_INPUT, 0, NULL, EC_WD_DISABLE},\n    {0xff}\n" in text


def test_a_description_prints_in_the_same_form():
    gap = "<Entry><Index>0</Index><BitLen>7</BitLen></Entry>"
    content = SMS + pdo("RxPdo", "#x1600", 1, attributes='Sm="2"').replace("</RxPdo>", f"{gap}</RxPdo>")
    (subject,) = subjects_of_document(read(esi(device(content, "#x2", "#x3", "EL1"))).document, "x.xml")
    assert cstruct_of_configuration(configure(subject, Choice(position=5))) == (
        '/* Master 0, Slave 5, "EL1"\n'
        " * Vendor ID:       0x00000e5c\n"
        " * Product code:    0x00000002\n"
        " * Revision number: 0x00000003\n"
        " */\n"
        "\n"
        "ec_pdo_entry_info_t slave_5_pdo_entries[] = {\n"
        "    {0x7000, 0x01, 1}, /* e1 */\n"
        "    {0x0000, 0x00, 7},\n"
        "};\n"
        "\n"
        "ec_pdo_info_t slave_5_pdos[] = {\n"
        "    {0x1600, 2, slave_5_pdo_entries + 0}, /* RxPdo #x1600 */\n"
        "};\n"
        "\n"
        "ec_sync_info_t slave_5_syncs[] = {\n"
        "    {0, EC_DIR_OUTPUT, 0, NULL, EC_WD_DISABLE},\n"
        "    {1, EC_DIR_INPUT, 0, NULL, EC_WD_DISABLE},\n"
        "    {2, EC_DIR_OUTPUT, 1, slave_5_pdos + 0, EC_WD_ENABLE},\n"
        "    {3, EC_DIR_INPUT, 0, NULL, EC_WD_DISABLE},\n"
        "    {0xff}\n"
        "};\n"
        "\n"
    )


def test_a_pdo_for_a_sync_manager_that_is_not_described_is_not_printed():
    """The tool attaches it to none, and SM numbers stay what they are."""
    content = (
        '<Sm ControlByte="#x64">Outputs</Sm><Sm ControlByte="#x20">Inputs</Sm>'
        + pdo("RxPdo", "#x1600", 16, attributes='Sm="0"')
        + pdo("TxPdo", "#x1A00", 16, attributes='Sm="3"')
    )
    (subject,) = subjects_of_document(read(esi(device(content))).document, "x.xml")
    text = cstruct_of_configuration(configure(subject))
    assert "1a00" not in text
    assert text.endswith(
        "    {0, EC_DIR_OUTPUT, 1, slave_0_pdos + 0, EC_WD_ENABLE},\n"
        "    {1, EC_DIR_INPUT, 0, NULL, EC_WD_DISABLE},\n"
        "    {0xff}\n};\n\n"
    )
    assert text == cstruct_of_image(described_image(subject))


def test_names_are_printed_as_they_are_written_those_of_gaps_too():
    """As an image has them, from which the tool prints."""
    gap = "<Entry><Index>0</Index><BitLen>7</BitLen><Name>Status__</Name></Entry>"
    content = SMS + pdo("TxPdo", "#x1A00", 1, attributes='Sm="3"').replace("</TxPdo>", f"{gap}</TxPdo>")
    content = content.replace("<Name>e1", "<Name>two  blanks").replace("<Name>TxPdo #", "<Name>TxPdo  #")
    (subject,) = subjects_of_document(read(esi(device(content))).document, "x.xml")
    text = cstruct_of_configuration(configure(subject))
    assert "    {0x7000, 0x01, 1}, /* two  blanks */\n    {0x0000, 0x00, 7}, /* Status__ */\n" in text
    assert "/* TxPdo  #x1A00 */" in text
    assert text == cstruct_of_image(described_image(subject))


def test_the_order_number_ends_at_63_bytes_too():
    (subject,) = subjects_of_document(read(esi(device(SMS, type_text="T" * 70))).document, "x.xml")
    text = cstruct_of_configuration(configure(subject))
    assert text.startswith(f'/* Master 0, Slave 0, "{"T" * 63}"\n')
    assert text == cstruct_of_image(described_image(subject))
