"""Vendor libraries of any size, made up: no real vendor, no real device, but shaped like what vendors publish.

    python benchmarks/library.py FOLDER --devices 10000 [--objects 20] [--revisions 5] [--vendors 100] [--seed 1]

A third of the products are digital terminals without dictionary, a third servo drives (CiA 402) and a third stations
with slots and modules. Revisions of a product differ in software version, in a default value and, every third one, in
the layout of a PDO; the newest hides the oldest. Names stand in English and German. Documents hold about 35 devices.
The same arguments give the same bytes, and a larger library of the same seed begins with the documents of the smaller.
"""

import argparse
import random
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

from library_xml import SIMPLE_TYPES, Mapped, Record, object_element, op_mode, pdo_element, record_object, record_type

DEVICES_PER_DOCUMENT = 35
FIRST_VENDOR_ID = 0xE0000000
_STANDARD_OBJECTS = {"drive": 8, "station": 6, "terminal": 0}
"""Objects that every dictionary of the kind has; the others are the manufacturer's."""
_SHARED_OF_TEN = 6
"""Of ten manufacturer objects so many are the same in all dictionaries of a vendor."""

_QUANTITIES = ("current", "voltage", "temperature", "position", "velocity", "torque", "filter time", "gain", "offset")
_PARTS = ("motor", "brake", "encoder", "DC link", "amplifier", "channel 1", "channel 2", "input stage", "controller")


class Shape(NamedTuple):
    """What is asked for."""

    devices: int
    objects: int
    revisions: int
    vendors: int
    seed: int


_RX = (
    Mapped(0x6040, 0, "UINT", "Controlword"),
    Mapped(0x6060, 0, "SINT", "Modes of operation"),
    Mapped(0x607A, 0, "DINT", "Target position"),
    Mapped(0x60FF, 0, "DINT", "Target velocity"),
    Mapped(0x6071, 0, "INT", "Target torque"),
)
_TX = (
    Mapped(0x6041, 0, "UINT", "Statusword"),
    Mapped(0x6061, 0, "SINT", "Modes of operation display"),
    Mapped(0x6064, 0, "DINT", "Position actual value"),
    Mapped(0x606C, 0, "DINT", "Velocity actual value"),
    Mapped(0x6077, 0, "INT", "Torque actual value"),
)
_ADDED = {"Rx": Mapped(0x60B2, 0, "INT", "Torque offset"), "Tx": Mapped(0x60F4, 0, "DINT", "Following error")}
_DRIVE_MODES = (0x001, 0x0A1, 0x080, 0x180, 0x3A0, 0x3ED)
"""Defaults of 0x6502: pp, CSP and CSV, with and without torque and homing."""


_FMMUS = "<Fmmu>Outputs</Fmmu>\n<Fmmu>Inputs</Fmmu>\n"
_MAILBOX_SMS = (
    '<Sm MinSize="64" MaxSize="512" DefaultSize="128" StartAddress="#x1000" ControlByte="#x26" Enable="1">MBoxOut</Sm>'
    '\n<Sm MinSize="64" MaxSize="512" DefaultSize="128" StartAddress="#x1200" ControlByte="#x22" Enable="1">MBoxIn</Sm>'
    "\n"
    '<Sm DefaultSize="13" StartAddress="#x1400" ControlByte="#x64" Enable="1">Outputs</Sm>\n'
    '<Sm DefaultSize="13" StartAddress="#x1800" ControlByte="#x20" Enable="1">Inputs</Sm>\n'
)
_TERMINAL_SMS = (
    '<Sm DefaultSize="2" StartAddress="#x0F00" ControlByte="#x44" Enable="1">Outputs</Sm>\n'
    '<Sm DefaultSize="2" StartAddress="#x1000" ControlByte="#x00" Enable="1">Inputs</Sm>\n'
)


class Product:
    """One product: what its revisions share is made once."""

    def __init__(self, shape: Shape, vendor: int, number: int, shared: tuple[str, ...], rng: random.Random) -> None:
        self.vendor, self.number, self._shape = vendor, number, shape
        self.kind = ("terminal", "drive", "station")[rng.randrange(3)]
        self._power = rng.choice((1, 2, 5, 10, 20, 40))
        self._sync1 = rng.random() < 0.3
        self._foe, self._complete_access = rng.random() < 0.5, rng.random() < 0.6
        self._modes = rng.choice(_DRIVE_MODES)
        self._channels = rng.choice((2, 4, 8, 16))
        self._shared = shared
        standard = _STANDARD_OBJECTS[self.kind]
        own = [_manufacturer_object(0x3000 + at, rng) for at in range(len(shared), shape.objects - standard)]
        self._own = "".join(own)
        self._cycle_ns = rng.choice((62_500, 125_000, 250_000, 1_000_000))

    @property
    def type(self) -> str:
        """Order code."""
        return f"{self.kind[0].upper()}{self.vendor:02d}-{self.number:04d}-{self._power:02d}A"

    def revision_no(self, revision: int) -> int:
        """RevisionNo of the revision counted from 0."""
        return (revision + 1) << 16

    def device(self, revision: int) -> str:
        """The Device element of a revision."""
        code, hidden = 0x10000 + self.number, ""
        if revision and revision == self._shape.revisions - 1:
            hidden = f'<HideType ProductCode="#x{code:08X}" RevisionNo="#x{self.revision_no(0):08X}"/>\n'
        german = {"terminal": "Klemme", "drive": "Servoverstärker", "station": "Feldbusstation"}[self.kind]
        body: Callable[[int], str] = {"terminal": self._terminal, "drive": self._drive, "station": self._station}[
            self.kind
        ]
        current = f"<EBusCurrent>{40 + 10 * self._channels}</EBusCurrent>"
        info = f"<Info><Electrical>{current}</Electrical></Info>\n" if self.kind == "terminal" else ""
        return (
            f'<Device Physics="{"KK" if self.kind == "terminal" else "YY"}">\n'
            f'<Type ProductCode="#x{code:08X}" RevisionNo="#x{self.revision_no(revision):08X}">{self.type}</Type>\n'
            f"{hidden}"
            f'<Name LcId="1033">{self.type} {self.kind}, {self._power} A</Name>\n'
            f'<Name LcId="1031">{self.type} {german}, {self._power} A</Name>\n{info}'
            f"<GroupType>{self.kind}s</GroupType>\n{body(revision)}</Device>\n"
        )

    def _terminal(self, revision: int) -> str:
        count = self._channels + (1 if revision % 3 == 2 else 0)
        rx = tuple(Mapped(0x7000 + 16 * at, 1, "BOOL", f"Output {at + 1}") for at in range(count))
        tx = tuple(Mapped(0x6000 + 16 * at, 1, "BOOL", f"Input {at + 1}") for at in range(self._channels))
        pdos = pdo_element("Rx", 0x1600, 0, "Digital outputs", rx) + pdo_element("Tx", 0x1A00, 1, "Digital inputs", tx)
        profile = "<Profile><ProfileNo>5001</ProfileNo></Profile>\n"
        eeprom = "<Eeprom><ByteSize>128</ByteSize><ConfigData>040C000000000000</ConfigData></Eeprom>\n"
        return f"{profile}{_FMMUS}{_TERMINAL_SMS}{pdos}{eeprom}"

    def _drive(self, revision: int) -> str:
        added = revision % 3 == 2
        rx, tx = (entries + ((_ADDED[way],) if added else ()) for way, entries in (("Rx", _RX), ("Tx", _TX)))
        pdos = pdo_element("Rx", 0x1600, 2, "Outputs", rx) + pdo_element("Tx", 0x1A00, 3, "Inputs", tx)
        mode = 9 if self._modes & 0x100 else 8 if self._modes & 0x80 else 1
        start = (
            "<InitCmd>\n<Transition>PS</Transition>\n<Index>#x6060</Index>\n<SubIndex>0</SubIndex>\n"
            f"<Data>{mode:02X}</Data>\n<Comment>Modes of operation</Comment>\n</InitCmd>\n"
        )
        modes = op_mode("DC", 0x700 if self._sync1 else 0x300, self._sync1) + op_mode("Synchron", 0)
        return self._with_mailbox(revision, 402, pdos, start, f"<Dc>\n{modes}</Dc>\n")

    def _station(self, revision: int) -> str:
        idents = "".join(f"<ModuleIdent>#x{self.module_ident(at):08X}</ModuleIdent>\n" for at in range(4))
        slot = f'<Slot MinInstances="0" MaxInstances="8">\n<Name>Terminal</Name>\n{idents}</Slot>\n'
        slots = f'<Slots MaxSlotCount="8" SlotPdoIncrement="1" SlotIndexIncrement="16">\n{slot}</Slots>\n'
        return self._with_mailbox(revision, 5001, "", "", f"<Dc>\n{op_mode('DC', 0x300)}</Dc>\n{slots}")

    def _with_mailbox(self, revision: int, profile_no: int, pdos: str, init_cmds: str, rest: str) -> str:
        foe = "<FoE/>" if self._foe else ""
        access = ' CompleteAccess="true"' if self._complete_access else ""
        mailbox = f'<Mailbox DataLinkLayer="true">\n<CoE SdoInfo="true"{access}>\n{init_cmds}</CoE>{foe}</Mailbox>\n'
        profile = f"<Profile>\n<ProfileNo>{profile_no}</ProfileNo>\n{self._dictionary(revision)}</Profile>\n"
        eeprom = "<Eeprom><ByteSize>2048</ByteSize><ConfigData>080C000000000000</ConfigData></Eeprom>\n"
        return f"{profile}{_FMMUS}{_MAILBOX_SMS}{pdos}{mailbox}{rest}{eeprom}"

    def _dictionary(self, revision: int) -> str:
        code = 0x10000 + self.number
        identity = (
            ("Vendor ID", "UDINT", FIRST_VENDOR_ID + self.vendor),
            ("Product code", "UDINT", code),
            ("Revision", "UDINT", self.revision_no(revision)),
            ("Serial number", "UDINT", 0),
        )
        cycle = (("Type", "UINT", 2), ("Cycle time", "UDINT", 1_000_000), ("Shift time", "UDINT", 0))
        cycle += (("Types supported", "UINT", 4), ("Minimum cycle time", "UDINT", self._cycle_ns))
        records = (Record(0x1018, "Identity", identity), Record(0x1C32, "SM output parameter", cycle))
        objects = (
            object_element(0x1000, "Device type", "UDINT", 0x20192 if self.kind == "drive" else 5001),
            object_element(0x1008, "Device name", "STRING(8)", self.type[:8]),
            object_element(0x100A, "Software version", "STRING(8)", f"V{revision + 1:07d}"),
            *map(record_object, records),
            object_element(0x2000, "Nominal current", "UINT", 100 * self._power + revision),
            object_element(0x6502, "Supported drive modes", "UDINT", self._modes) if self.kind == "drive" else "",
            object_element(0x6040, "Controlword", "UINT", 0, "rw", "r") if self.kind == "drive" else "",
        )
        types = SIMPLE_TYPES + "".join(map(record_type, records))
        listed = "".join((*objects, *self._shared, self._own))
        return f"<Dictionary>\n<DataTypes>\n{types}</DataTypes>\n<Objects>\n{listed}</Objects>\n</Dictionary>\n"

    def module_ident(self, at: int) -> int:
        """ModuleIdent of one of the modules that fit a station."""
        return (self.number << 8) + at

    def modules(self) -> str:
        """The Module elements that a station brings."""
        if self.kind != "station":
            return ""
        return "".join(self._module(at) for at in range(4))

    def _module(self, at: int) -> str:
        direction, sm = (("Rx", 2), ("Tx", 3))[at % 2]
        base, index = (0x7000, 0x1600) if direction == "Rx" else (0x6000, 0x1A00)
        entries = tuple(Mapped(base, bit + 1, "BOOL", f"Bit {bit + 1}") for bit in range(4 * (1 + at // 2)))
        pdo = pdo_element(direction, index, sm, f"{direction} channels", entries)
        ident = f'<Type ModuleIdent="#x{self.module_ident(at):08X}">{self.type}-M{at}</Type>'
        return f'<Module>\n{ident}\n<Name LcId="1033">Terminal {at} of {self.type}</Name>\n{pdo}</Module>\n'


def _manufacturer_object(index: int, rng: random.Random) -> str:
    data_type = rng.choice(("UINT", "INT", "UDINT", "DINT"))
    name = f"{rng.choice(_PARTS)} {rng.choice(_QUANTITIES)}".capitalize()
    return object_element(index, name, data_type, rng.randrange(1000), rng.choice(("ro", "rw")))


def documents(shape: Shape) -> Iterator[tuple[str, str]]:
    """Path and text of every document."""
    products = -(-shape.devices // shape.revisions)
    per_document = max(1, DEVICES_PER_DOCUMENT // shape.revisions)
    shared_count = max(0, shape.objects - max(_STANDARD_OBJECTS.values())) * _SHARED_OF_TEN // 10
    left = shape.devices
    for number, first in enumerate(range(0, products, per_document)):
        vendor = number % shape.vendors
        vendor_rng = random.Random(f"{shape.seed} vendor {vendor}")
        shared = tuple(_manufacturer_object(0x2100 + at, vendor_rng) for at in range(shared_count))
        rng = random.Random(f"{shape.seed} document {number}")
        made = [Product(shape, vendor, at, shared, rng) for at in range(first, min(products, first + per_document))]
        devices = [product.device(revision) for product in made for revision in range(shape.revisions)][:left]
        left -= len(devices)
        yield f"vendor {vendor:04d}/products {number:05d}.xml", _document(vendor, devices, made)


def _document(vendor: int, devices: list[str], products: list[Product]) -> str:
    kinds = dict.fromkeys(product.kind for product in products)
    groups = "".join(
        f'<Group><Type>{kind}s</Type><Name LcId="1033">{kind.capitalize()}s</Name></Group>\n' for kind in kinds
    )
    modules = "".join(product.modules() for product in products)
    listed = f"<Modules>\n{modules}</Modules>\n" if modules else ""
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<EtherCATInfo Version="1.17">\n'
        f'<Vendor>\n<Id>#x{FIRST_VENDOR_ID + vendor:08X}</Id>\n<Name LcId="1033">Made-up vendor {vendor:04d}</Name>\n'
        f"</Vendor>\n<Descriptions>\n<Groups>\n{groups}</Groups>\n<Devices>\n{''.join(devices)}</Devices>\n{listed}"
        "</Descriptions>\n</EtherCATInfo>\n"
    )


def write_library(folder: Path, shape: Shape) -> tuple[int, int]:
    """Write a library into a new folder; returns the number of documents and of bytes."""
    count = size = 0
    for path, text in documents(shape):
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        size += target.write_bytes(text.encode())
        count += 1
    return count, size


def main() -> None:
    """Write a library and say what it holds."""
    parser = argparse.ArgumentParser(description="Write a made-up library of ESI documents.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--devices", type=int, default=10_000, help="Device elements in all")
    parser.add_argument("--objects", type=int, default=20, help="objects in a dictionary, at least 8")
    parser.add_argument("--revisions", type=int, default=5, help="revisions of a product")
    parser.add_argument("--vendors", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    shape = Shape(given.devices, given.objects, given.revisions, given.vendors, given.seed)
    count, size = write_library(given.folder, shape)
    print(f"{given.devices} devices in {count} documents, {size / 1e6:.0f} MB")


if __name__ == "__main__":
    main()
