"""esicatalog sii decode: a sheet and JSON of an EEPROM image, one line for what is none."""

import json

from sii.by_hand import WHOLE
from test_cli import one_line_error, run


def test_sheet_and_json(tmp_path):
    (tmp_path / "dump.bin").write_bytes(WHOLE)
    sheet = run("sii", "decode", str(tmp_path / "dump.bin")).stdout
    assert "Sync managers" in sheet
    found = json.loads(run("sii", "decode", str(tmp_path / "dump.bin"), "--format", "json").stdout)
    assert f"0x{found['header']['vendor_id']:08x}" in sheet
    assert found["header"]["checksum"] == WHOLE[14]


def test_what_is_no_image_is_one_line(tmp_path):
    (tmp_path / "short.bin").write_bytes(b"\1\2\3")
    assert "the header alone takes 128" in one_line_error(run("sii", "decode", str(tmp_path / "short.bin")))
    assert "No such file" in one_line_error(run("sii", "decode", str(tmp_path / "missing.bin")))
