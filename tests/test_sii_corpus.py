"""Real EEPROM dumps: identities by their list, decoding by the tables that IgH's own formatter made of them."""

import csv
from pathlib import Path

import pytest

from esicatalog.sii.checksum import header_checksum
from esicatalog.sii.codes import SmControl
from esicatalog.sii.encode import encode_sii
from esicatalog.sii.files import image_of_file, read_sii
from esicatalog.sii.image import RawCategory, SiiImage
from esicatalog.sii.records import Pdo, SyncManager
from esicatalog.sii.text import sheet_lines

IGH_NAME_BYTES = 63


@pytest.fixture(scope="module")
def dumps(corpus: Path) -> list[tuple[dict[str, str], bytes]]:
    """Rows of the list, with the bytes of the file."""
    folder = corpus / "sii"
    if not (folder / "MANIFEST.tsv").is_file():
        pytest.skip(f"no EEPROM dumps at {folder}")
    with (folder / "MANIFEST.tsv").open(newline="") as listed:
        return [(row, (folder / row["file"]).read_bytes()) for row in csv.DictReader(listed, delimiter="\t")]


@pytest.fixture(scope="module")
def images(dumps: list[tuple[dict[str, str], bytes]]) -> dict[str, SiiImage]:
    return {row["file"]: read_sii(data) for row, data in dumps}


def test_the_container_is_recognised(dumps):
    for row, data in dumps:
        assert (image_of_file(data).data is data) == (row["format"] == "raw"), row["file"]


def test_the_same_image_as_intel_hex_and_raw(dumps):
    contents = [image_of_file(data).data for row, data in dumps if "EaserCAT-2000" in row["file"]]
    assert len(contents) == 2
    assert contents[0] == contents[1]


def test_identities_check_sums_and_categories_are_those_of_the_list(dumps, images):
    for row, _ in dumps:
        image = images[row["file"]]
        header = image.header
        assert f"0x{header.vendor_id:08X}" == row["vendor"], row["file"]
        assert f"0x{header.product_code:08X}" == row["product"], row["file"]
        assert f"0x{header.revision_no:08X}" == row["revision"], row["file"]
        assert (header.checksum == header_checksum(header)) == (row["crc_ok"] == "1"), row["file"]
        types = ",".join(str(category.category_type) for category in image.categories)
        assert types == row["categories"].removesuffix(",end"), row["file"]


def test_every_dump_is_encoded_byte_for_byte(dumps, images):
    for row, data in dumps:
        assert encode_sii(images[row["file"]]) == image_of_file(data).data, row["file"]


def test_every_category_with_a_known_layout_fits_it(images):
    raw = {c.category_type for image in images.values() for c in image.categories if isinstance(c, RawCategory)}
    assert raw <= {43, 2048, 2049}


def test_findings_of_real_dumps(images):
    found = {name: image.findings for name, image in images.items() if image.findings}
    assert {name.rsplit("__", 2)[1]: findings for name, findings in found.items()} == {
        "rtl_slavedemo": ("size word at byte 0x7C says 1920 bytes; the image has 2048",),
        "xmc4300_slavedemo": ("category 60 (DC) at byte 0xEE names strings (6) beyond the 2 of the table",),
    }


def test_every_sheet_is_printable(images):
    for image in images.values():
        assert all(line.isprintable() for line in sheet_lines(image))


def test_facts_of_a_coupler(images):
    image = next(image for name, image in images.items() if "ek1100" in name)
    general = image.general
    assert image.text(general.order_string_number) == "EK1100"
    assert general.e_bus_current_ma == -2000
    assert general.port_types == ("MII", "EBUS", "MII", "not used")


def igh_name(image: SiiImage, string_number: int) -> str:
    return (image.text(string_number) or "").encode()[:IGH_NAME_BYTES].decode()


def assigned(image: SiiImage, sm: int) -> list[Pdo]:
    return [pdo for pdo in (*image.tx_pdos, *image.rx_pdos) if pdo.sm == sm]


def pdos_text(image: SiiImage) -> str:
    """What ``ethercat pdos`` prints for these records."""
    lines = []
    for number, sm in enumerate(image.sync_managers):
        lines.append(
            f"SM{number}: PhysAddr 0x{sm.start_address:04x}, DefaultSize {sm.length_bytes:4}, "
            f"ControlRegister 0x{sm.control_byte:02x}, Enable {sm.enable:d}"
        )
        for pdo in assigned(image, number):
            kind = "RxPDO" if sm.direction == "output" else "TxPDO"
            lines.append(f'  {kind} 0x{pdo.pdo_index:04x} "{igh_name(image, pdo.name_string_number)}"')
            lines += [
                f"    PDO entry 0x{entry.entry_index:04x}:{entry.subindex:02x}, {entry.bit_length:2} bit, "
                f'"{igh_name(image, entry.name_string_number)}"'
                for entry in pdo.entries
            ]
    return "".join(f"{line}\n" for line in lines)


def cstruct_syncs(image: SiiImage) -> list[str]:
    """The rows of ``ec_sync_info_t`` that ``ethercat cstruct`` prints for these records."""
    offset = 0
    rows = []
    for number, sm in enumerate(image.sync_managers):
        count = len(assigned(image, number))
        pdos = f"slave_0_pdos + {offset}" if count else "NULL"
        rows.append(f"    {{{number}, {igh_direction(sm)}, {count}, {pdos}, {igh_watchdog(sm)}}},")
        offset += count
    return rows


def igh_direction(sm: SyncManager) -> str:
    return "EC_DIR_OUTPUT" if sm.direction == "output" else "EC_DIR_INPUT"


def igh_watchdog(sm: SyncManager) -> str:
    return "EC_WD_ENABLE" if sm.control & SmControl.WATCHDOG else "EC_WD_DISABLE"


@pytest.fixture(scope="module")
def igh(corpus: Path, images: dict[str, SiiImage]) -> list[tuple[SiiImage, str, str]]:
    """Images with the outputs of ``ethercat pdos`` and ``ethercat cstruct``."""
    folder = corpus / "igh"
    stems = {name: folder / name.replace("/", "~", 1) for name in images}
    found = [
        (images[name], Path(f"{stem}.pdos.txt").read_text(), Path(f"{stem}.cstruct.h").read_text())
        for name, stem in stems.items()
        if Path(f"{stem}.pdos.txt").is_file()
    ]
    if not found:
        pytest.skip(f"no outputs of IgH at {folder}")
    return found


def test_pdos_entries_and_names_are_those_that_igh_reads(igh):
    for image, pdos, _ in igh:
        assert pdos_text(image) == pdos


def test_identity_directions_and_watchdogs_are_those_that_igh_reads(igh):
    for image, _, cstruct in igh:
        if not image.sync_managers:
            continue
        header = image.header
        assert f" * Vendor ID:       0x{header.vendor_id:08x}\n" in cstruct
        assert f" * Product code:    0x{header.product_code:08x}\n" in cstruct
        assert f" * Revision number: 0x{header.revision_no:08x}\n" in cstruct
        assert [line for line in cstruct.splitlines() if "EC_DIR_" in line] == cstruct_syncs(image)
        order = image.text(image.general.order_string_number)
        assert cstruct.startswith(f'/* Master 0, Slave 0, "{order}"' if order else "/* Master 0, Slave 0\n")
