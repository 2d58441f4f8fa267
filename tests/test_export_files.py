"""export sii and export esi on the command line: from the catalog and from files, merged, fitted, with files beside."""

from pathlib import Path

import msgspec
import pytest
from snippets import device, esi, read, write
from test_cli import run

from esicatalog import Catalog
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.encode import encode_sii

EYOU = "0x1097:0x2406:0x8f"


def exported(tmp_path: Path, *words: object, db: Path | None = None):
    out = tmp_path / "out"
    done = run("export", *words, "-o", out, db=db)
    assert done.exit_code == 0, done.stderr
    return out.read_bytes(), done.stderr


def test_an_image_says_what_the_device_is(data_db, tmp_path):
    data, words = exported(tmp_path, "sii", EYOU, db=data_db)
    image = decode_sii(data)
    assert (image.header.vendor_id, image.header.product_code, image.header.revision_no) == (0x1097, 0x2406, 0x8F)
    assert len(data) == image.header.byte_size
    assert image.findings == ()
    assert "merge this image into the device's own" in words


def test_merging_keeps_what_is_the_devices_own(data_db, tmp_path):
    data, _ = exported(tmp_path, "sii", EYOU, db=data_db)
    image = decode_sii(data)
    own = msgspec.structs.replace(image.header, station_alias=7, serial_no=1234)
    (tmp_path / "own.bin").write_bytes(encode_sii(msgspec.structs.replace(image, header=own)))
    merged, _ = exported(tmp_path, "sii", EYOU, "--merge", tmp_path / "own.bin", db=data_db)
    header = decode_sii(merged).header
    assert (header.station_alias, header.serial_no) == (7, 1234)


def test_merging_a_dump_up_to_its_end_mark_writes_no_more(data_db, tmp_path):
    data, _ = exported(tmp_path, "sii", EYOU, db=data_db)
    short = encode_sii(msgspec.structs.replace(decode_sii(data), trailing=b""))
    (tmp_path / "own.bin").write_bytes(short)
    for fit in ([], ["--fit"]):
        merged, words = exported(tmp_path, "sii", EYOU, "--merge", tmp_path / "own.bin", *fit, db=data_db)
        assert merged == short
        assert f"{len(data) - len(short)} were not in it" in words.splitlines()[1]


def test_merging_a_short_config_data_keeps_the_other_pdi_words(tmp_path):
    element = "<Eeprom><ByteSize>256</ByteSize><ConfigData>{}</ConfigData></Eeprom>"
    write(tmp_path, {f"{n}.xml": esi(device(element.format("050E03440A00FFAA"[:n]))) for n in (4, 16)})
    data, _ = exported(tmp_path, "sii", "--esi", tmp_path / "16.xml")
    (tmp_path / "own.bin").write_bytes(data)
    merged, words = exported(tmp_path, "sii", "--esi", tmp_path / "4.xml", "--merge", tmp_path / "own.bin")
    assert merged == data
    assert "PDI words from byte 2, where ConfigData ends" in words


def test_an_image_that_is_too_large_is_refused_and_fitted(data, tmp_path):
    text = (data / "eyou_servo_module.xml").read_text().replace("<ByteSize>2048</ByteSize>", "<ByteSize>256</ByteSize>")
    assert "<ByteSize>256</ByteSize>" in text
    write(tmp_path, {"small.xml": text})
    refused = run("export", "sii", "--esi", tmp_path / "small.xml")
    assert refused.exit_code == 2
    assert len(refused.stderr.splitlines()) == 1
    fitted, words = exported(tmp_path, "sii", "--esi", tmp_path / "small.xml", "--fit")
    assert len(fitted) == 256
    assert "names" in words


@pytest.mark.parametrize("source", ["catalog", "file"])
def test_esi_reads_back_as_the_device(data, data_db, tmp_path, source):
    words = [EYOU] if source == "catalog" else ["--esi", data / "eyou_servo_module.xml"]
    text, _ = exported(tmp_path, "esi", *words, db=data_db)
    (info,) = read(text).document.infos
    with Catalog.open(data_db) as catalog:
        described = catalog.device(EYOU)
    assert info.devices == (described.device,)
    assert info.modules == described.modules
    assert info.vendor.vendor_id == 0x1097


def test_esi_of_a_vendor(data_db, tmp_path):
    text, _ = exported(tmp_path, "esi", "--vendor", "0xe5c", db=data_db)
    (info,) = read(text).document.infos
    assert [device.type for device in info.devices] == ["ECX-A202", "ECX-D808", "ECX-D808"]
    refused = run("export", "esi", "--vendor", "0x9999", db=data_db)
    assert (refused.exit_code, "has no device and no module" in refused.stderr) == (1, True)


def test_files_beside(tmp_path):
    document = (
        "<EtherCATInfo><Vendor><Id>1</Id><Name>V</Name></Vendor><Descriptions><Groups><Group><Type>G</Type>"
        "<Name>G</Name></Group></Groups><Devices><Device Physics='YY'><Type ProductCode='1' RevisionNo='1'>D</Type>"
        "<Name>D</Name><GroupType>G</GroupType><Profile><ProfileNo>5001</ProfileNo>"
        "<DictionaryFile>dict/objects.xml</DictionaryFile></Profile></Device></Devices></Descriptions></EtherCATInfo>"
    )
    dictionary = (
        "<EtherCATDict><Dictionary><DataTypes><DataType><Name>UINT</Name><BitSize>16</BitSize></DataType></DataTypes>"
        "<Objects><Object><Index>#x2000</Index><Name>O</Name><Type>UINT</Type><BitSize>16</BitSize></Object></Objects>"
        "</Dictionary></EtherCATDict>"
    )
    write(tmp_path / "in", {"d.xml": document, "dict/objects.xml": dictionary})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([tmp_path / "in"], jobs=1)
    (tmp_path / "made").mkdir()
    done = run("export", "esi", "1:1:1", "--with-files", "-o", tmp_path / "made" / "d.xml", db=tmp_path / "c.db")
    assert done.exit_code == 0, done.stderr
    assert sorted(str(path.relative_to(tmp_path / "made")) for path in (tmp_path / "made").rglob("*.xml")) == [
        "d.xml",
        "dict/objects.xml",
    ]
    with Catalog.open(tmp_path / "again.db", create=True) as catalog:
        catalog.ingest([tmp_path / "made"], jobs=1)
        again = catalog.device("1:1:1").device
    with Catalog.open(tmp_path / "c.db") as catalog:
        assert catalog.device("1:1:1").device == again
    refused = run("export", "esi", "1:1:1", "--with-files", db=tmp_path / "c.db")
    assert (refused.exit_code, "-o OUT" in refused.stderr) == (2, True)
