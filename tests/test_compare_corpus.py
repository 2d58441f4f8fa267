"""Comparing real descriptions: facts found in their XML, and what holds for all of them."""

import contextlib
import re
from collections import Counter
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest
from test_drive_modes import all_devices

from esicatalog.errors import DocumentError
from esicatalog.esi.containers import Archive
from esicatalog.esi.reader import Reader
from esicatalog.model.compare import compare_devices
from esicatalog.model.compare_device import revision_verdict
from esicatalog.model.compare_documents import DescribedDevice, described_devices
from esicatalog.model.compare_facts import ADDED, AREAS, CHANGED, REMOVED, Difference
from esicatalog.model.compare_image import compare_images
from esicatalog.model.process_data import ProcessData

MIRRORED = {ADDED: REMOVED, REMOVED: ADDED, CHANGED: CHANGED}
BECKHOFF, BECKHOFF_OLDER = "DiamondLightSource+ethercat.zip", "DiamondLightSource+ethercat-history.zip"
EYOU = "ruiofang+EU_EtherCAT.zip"


def respelled(content: bytes) -> bytes:
    """The same document with every hexadecimal number in other letters and with zeros before it."""
    return re.sub(rb">\s*#x([0-9A-Fa-f]+)(?![0-9A-Fa-fx])", lambda found: b">#x000" + found[1].swapcase(), content)


def read_devices(path: Path, wanted: str = "", prepared: Callable[[bytes], bytes] = bytes) -> list[DescribedDevice]:
    """The devices of the documents of an archive whose name holds ``wanted``, read anew."""
    opened = Archive(path)
    reader = Reader()
    found = []
    for member, _ in opened.members():
        if wanted in member:
            with contextlib.suppress(DocumentError):
                found += described_devices(reader.read(prepared(opened.read(member)), member, opened).document)
    return found


def compared(left: DescribedDevice, right: DescribedDevice) -> list[Difference]:
    return compare_devices(left, right)


def mirrored(differences: list[Difference]) -> Counter[tuple[str | None, ...]]:
    """The differences as they are for exchanged sides; which of them count has a direction."""
    return Counter(
        (item.module, item.area, item.place, MIRRORED[item.kind], item.right, item.left) for item in differences
    )


def as_told(differences: list[Difference]) -> Counter[tuple[str | None, ...]]:
    return Counter((item.module, item.area, item.place, item.kind, item.left, item.right) for item in differences)


def revisions(corpus: Path, archive: str, member: str, type_text: str) -> dict[int | None, DescribedDevice]:
    found = read_devices(corpus / "esi" / archive, member)
    return {item.device.revision_no: item for item in found if item.device.type == type_text}


def test_el1014_maps_other_objects_since_revision_16(corpus):
    """Revision 0 maps 0x3101:01 to :04, 0x00100000 maps 0x6000:01, 0x6010:01, 0x6020:01, 0x6030:01: one bit each."""
    el1014 = revisions(corpus, BECKHOFF, "Beckhoff EL1xxx.xml", "EL1014")
    found = compared(el1014[0], el1014[0x100000])
    entries = {item.place: (item.left, item.right) for item in found if item.area == "PDO"}
    assert entries == {
        f"TxPDO 0x1A0{n} entry 1": (f"0x3101:0{n + 1} (1 bit) BOOL Input", f"0x60{n}0:01 (1 bit) BOOL Input")
        for n in range(4)
    }
    assert [item.place for item in found if item.area == "process image"] == [f"SM0 at 0.{n}" for n in range(4)]
    others = {item.place: (item.left, item.right) for item in found if item.area not in ("PDO", "process image")}
    assert others == {
        "revision": ("0x00000000", "0x00100000"),
        "hidden revisions": ("0x27070000, 0x27080000, 0x270b0000", "0x00000000"),
        "E-bus current": ("110 mA", "90 mA"),
        "sync unit 0": (None, "FrameRepeatSupport yes"),
        "Eeprom ConfigData": ("0101", "0401000000000000"),
    }


def test_el1014_revisions_16_and_17_differ_in_their_number_only(corpus):
    """0x00110000 adds CheckRevisionNo LW_EQ and hides one revision more."""
    el1014 = revisions(corpus, BECKHOFF, "Beckhoff EL1xxx.xml", "EL1014")
    found = compared(el1014[0x100000], el1014[0x110000])
    assert [item.place for item in found if item.counts] == ["revision"]
    assert {item.place for item in found} == {"revision", "CheckRevisionNo", "hidden revisions"}
    back = compared(el1014[0x110000], el1014[0x100000])
    assert not any(item.counts for item in back)
    verdict = revision_verdict(el1014[0x110000].device, el1014[0x100000].device)
    assert verdict == "a master configured for 0x00110000 takes 0x00100000: CheckRevisionNo LW_EQ"


def test_el7031_loses_a_parameter_and_gets_others(corpus):
    """0x8000 has no subindex 8 any more, 0x8011 has a seventh, its sixth defaults to 0 instead of 10, 0x8013 is new."""
    el7031 = revisions(corpus, BECKHOFF_OLDER, "Beckhoff EL7xxx.xml", "EL7031")
    found = {item.place: item for item in compared(el7031[0x100000], el7031[0x110000])}
    assert (found["0x8000:08"].kind, found["0x8000:08"].counts) == (REMOVED, True)
    assert (found["0x8011:07"].kind, found["0x8011:07"].counts) == (ADDED, False)
    assert (found["0x8011:06 default"].left, found["0x8011:06 default"].right) == ("10 (0xA)", "0")
    assert found["0x8013"].kind == ADDED
    assert {item.area for item in found.values()} == {"identity", "general", "objects"}


def test_el7031_gets_a_positioning_interface(corpus):
    """0x00120000 describes RxPDO 0x1605, 0x1606 and TxPDO 0x1A05, 0x1A06, all optional, and DiagHistory."""
    el7031 = revisions(corpus, BECKHOFF_OLDER, "Beckhoff EL7xxx.xml", "EL7031")
    found = compared(el7031[0x110000], el7031[0x120000])
    pdos = [(item.place, item.kind, item.counts) for item in found if item.place[2:5] == "PDO"]
    assert pdos == [(place, ADDED, False) for place in ("RxPDO 0x1605", "RxPDO 0x1606", "TxPDO 0x1A05", "TxPDO 0x1A06")]
    assert [item.place for item in found if item.area == "Mailbox"] == ["CoE DiagHistory"]
    assert not [item for item in found if item.area in ("process image", "SyncManager", "Dc")]
    # 0x8011:01 and :02: c800 → 9001, 0200 → 0400
    defaults = {item.place: (item.left, item.right) for item in found if item.place.startswith("0x8011:0")}
    assert defaults["0x8011:01 default"] == ("200 (0xC8)", "400 (0x190)")
    assert defaults["0x8011:02 default"] == ("2", "4")


def test_eyou_with_and_without_slot_are_the_same_by_default(corpus):
    """Two files of one identity: modules in a slot, or the PDOs of all modules in the device."""
    (with_slot,) = read_devices(corpus / "esi" / EYOU, "ECAT_V143.xml")
    (without,) = read_devices(corpus / "esi" / EYOU, "ECAT_V143_no_slot.xml")
    found = compared(with_slot, without)
    assert {item.area for item in found} == {"PDO", "slots and modules"}
    added = {item.place: item.counts for item in found if item.area == "PDO"}
    assert added == {
        "RxPDO 0x1600": True,
        "RxPDO 0x1601": False,
        "RxPDO 0x1602": False,
        "TxPDO 0x1A00": True,
        "TxPDO 0x1A01": False,
        "TxPDO 0x1A02": False,
    }
    assert {item.place for item in found if item.kind == REMOVED and item.place.startswith("module")} == {
        "module 0x00119800",
        "module 0x00219800",
        "module 0x00319800",
    }


def check_archive(path: Path) -> int:
    """No device differs from itself in another spelling, and neighbours differ alike from both sides.

    VendorSpecific is the vendor's own XML: there another spelling may be another value.
    """
    devices, again = read_devices(path), read_devices(path, prepared=respelled)
    for device, same in zip(devices, again, strict=True):
        assert [item for item in compared(device, same) if "VendorSpecific" not in item.place] == []
    for left, right in pairwise(devices):
        found = compared(left, right)
        assert mirrored(found) == as_told(compared(right, left))
        assert {item.area for item in found} <= set(AREAS)
        assert all(item.left != item.right for item in found)
    check_layouts(devices)
    return len(devices)


def check_layouts(devices: list[DescribedDevice]) -> None:
    """Of neighbours by identity, the signature of the catalog and the comparison say the same."""
    signatures = [ProcessData(item.device, item.modules).image_signature for item in devices]
    in_order = sorted(
        zip(devices, signatures, strict=True),
        key=lambda pair: (pair[0].device.product_code or 0, pair[0].device.revision_no or 0),
    )
    for (left, signature), (right, other) in pairwise(in_order):
        differences = compare_images(left.device, left.modules, right.device, right.modules)
        assert (signature != other) == any(True for _ in differences)


def test_sample_archives(sample_archives):
    assert sum(map(check_archive, sample_archives)) > 0


@pytest.mark.corpus
def test_the_whole_corpus(corpus):
    count = sum(map(check_archive, sorted((corpus / "esi").glob("*.zip"))))
    assert count == sum(1 for _ in all_devices(corpus))
