"""Generated C headers compile without a warning, and programs that use them put every bit where it belongs.

The headers below tests/export declare what IgH EtherLab and SOEM declare; fake_master.c places entries as IgH does.
"""

import re
import shutil
import subprocess
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from test_drive_modes import all_devices, devices_of

from esicatalog.errors import InputError
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.document import EsiInfo
from esicatalog.esi.records.module import Module
from esicatalog.export.choice import Choice
from esicatalog.export.configuration import Configuration, configure
from esicatalog.export.igh import igh_header
from esicatalog.export.soem import soem_header
from esicatalog.export.soem_sii import check_counted
from esicatalog.export.subject import Subject
from esicatalog.model.sm_facts import TRANSFER_DIRECTIONS

STUBS = Path(__file__).parent / "export"
FLAGS = ("-std=gnu11", "-Wall", "-Wextra", "-Werror")
UNUSED = ("-Wno-unused-function", "-Wno-unused-variable", "-Wno-unused-const-variable")
IGH_15 = ("-I", str(STUBS / "igh"), "-DECRT_MINOR=5")
IGH_16 = ("-I", str(STUBS / "igh"), "-DECRT_MINOR=6")
SOEM_14 = ("-I", str(STUBS / "soem14"))
SOEM_2 = ("-I", str(STUBS / "soem2"))
HEADERS_A_CALL = 100
MORE_IN_SII = r"EL(1202-0100|1252(-00[15]0)?|1262(-0050)?|2252|2262|3702|3742|4712|4732)|E(P|PP|R)1258-000[12]"
"""Virtual SyncManagers with PDOs, and of EL2262 PDOs that exclude each other."""
SMALL_BYTES = 100_000

needs_gcc = pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc to compile generated headers with")


def gcc(*arguments: object) -> None:
    """Run gcc; what it says is the assertion's message."""
    done = subprocess.run(["gcc", *map(str, arguments)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[:3000]


def check_syntax(folder: Path, headers: Iterable[str], options: Iterable[str], *more: str) -> None:
    """Check headers, all of them together in one translation unit."""
    names = []
    for number, text in enumerate(headers):
        (folder / f"h{number}.h").write_text(text)
        names.append(f'#include "h{number}.h"\n')
    unit = folder / "unit.c"
    unit.write_text("".join(names) + "\ntypedef int not_empty;\n")
    gcc(*FLAGS, *UNUSED, *options, *more, "-fsyntax-only", unit)


def output_of(folder: Path, header: str, main: str, options: Iterable[str], *sources: Path) -> list[str]:
    """Lines that a program prints which includes the header; ``main`` is the body of its main function."""
    (folder / "generated.h").write_text(header)
    program = folder / "program.c"
    program.write_text(f'#include <stdio.h>\n#include "generated.h"\nint main(void)\n{{\n{main}\nreturn 0;\n}}\n')
    gcc(*FLAGS, *UNUSED, *options, "-o", folder / "program", program, *sources)
    return subprocess.run([folder / "program"], capture_output=True, text=True, check=True).stdout.splitlines()


def igh_output(folder: Path, header: str, main: str) -> list[str]:
    return output_of(folder, header, main, IGH_16, STUBS / "igh" / "fake_master.c")


def configurations(corpus: Path) -> Iterator[Configuration]:
    """Every device of the corpus that exchanges process data, with a prefix of its own."""
    return configured(all_devices(corpus))


def configured(devices: Iterable[tuple[EsiInfo, Device, Iterable[Module]]]) -> Iterator[Configuration]:
    for number, (info, device, modules) in enumerate(devices):
        vendor_id = info.vendor.vendor_id if info.vendor is not None else None
        if vendor_id is None or device.product_code is None or device.revision_no is None:
            continue
        subject = Subject(vendor_id, None, device, tuple(modules))
        try:
            found = configure(subject, Choice(name=f"d{number}"))
        except InputError as error:
            # Files from before schema 1.2 name shared PDOs, whose entries stand nowhere.
            assert "has no index" in str(error)
            continue
        if any(sm.bit_size for sm in found.sync_managers):
            yield found


def for_soem(found: Iterable[Configuration]) -> Iterator[Configuration]:
    """Those of which SOEM exchanges what is described: others are terminals whose SII assigns more than one may."""
    for item in found:
        try:
            for direction in TRANSFER_DIRECTIONS.values():
                check_counted(item, direction)
        except InputError as error:
            assert str(error).startswith("SOEM would exchange ")
            assert re.fullmatch(MORE_IN_SII, item.subject.device.type or "")
            continue
        yield item


@pytest.fixture(scope="module")
def sample(corpus: Path) -> list[Configuration]:
    """Of many vendors: the small archives are other people's than the large ones."""
    small = [path for path in sorted((corpus / "esi").glob("*.zip")) if path.stat().st_size <= SMALL_BYTES]
    found = list(configured(devices_of(small)))
    assert len(found) > 100
    return found


@needs_gcc
@pytest.mark.parametrize("options", [IGH_15, IGH_16], ids=["1.5", "1.6"])
def test_a_sample_of_igh_headers(sample, tmp_path, options):
    check_syntax(tmp_path, map(igh_header, sample), options)


@needs_gcc
@pytest.mark.parametrize(("version", "options"), [("1.4", SOEM_14), ("2", SOEM_2)])
def test_a_sample_of_soem_headers(sample, tmp_path, version, options):
    check_syntax(tmp_path, (soem_header(found, version) for found in for_soem(sample)), options)


@pytest.fixture(scope="module")
def batches(corpus: Path) -> list[list[Configuration]]:
    found = list(configurations(corpus))
    assert len(found) > 1_800
    return [found[start : start + HEADERS_A_CALL] for start in range(0, len(found), HEADERS_A_CALL)]


@needs_gcc
@pytest.mark.corpus
@pytest.mark.parametrize("options", [IGH_15, IGH_16], ids=["1.5", "1.6"])
def test_igh_headers_of_the_whole_corpus(batches, tmp_path, options):
    for batch in batches:
        check_syntax(tmp_path, map(igh_header, batch), options)


@needs_gcc
@pytest.mark.corpus
@pytest.mark.parametrize(("version", "options"), [("1.4", SOEM_14), ("2", SOEM_2)])
def test_soem_headers_of_the_whole_corpus(batches, tmp_path, version, options):
    for batch in batches:
        check_syntax(tmp_path, (soem_header(found, version) for found in for_soem(batch)), options)
