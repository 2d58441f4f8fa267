"""Comparing slots and modules."""

from snippets import device, dictionary, esi, pdo
from test_compare import compared

SMS = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>"


def slot(*idents: int, attributes: str = 'MinInstances="1" MaxInstances="1"', default: int = 1) -> str:
    marks = {default: 'Default="1"'}
    listed = "".join(f"<ModuleIdent {marks.get(ident, '')}>{ident}</ModuleIdent>" for ident in idents)
    return f"<Slot {attributes}><Name>Axis</Name>{listed}</Slot>"


def module(ident: int, content: str = "", name: str = "M") -> str:
    return f'<Module><Type ModuleIdent="{ident}">T{ident}</Type><Name>{name}</Name>{content}</Module>'


def modular(slots: str, *modules: str, attributes: str = 'SlotPdoIncrement="16"') -> str:
    return esi(device(f"{SMS}<Slots {attributes}>{slots}</Slots>"), "".join(modules))


def told(left: str, right: str):
    return [(i.module, i.area, i.place, i.left, i.right, i.counts) for i in compared(left, right)]


BOTH = (module(1), module(2, name="Two"))


def test_a_module_that_fits_no_more_counts():
    assert told(modular(slot(1, 2), *BOTH), modular(slot(1), *BOTH)) == [
        (None, "slots and modules", "slot 0 modules", "0x00000001, 0x00000002", "0x00000001", True),
        (None, "slots and modules", "module 0x00000002", "T2, Two", None, True),
    ]
    back = told(modular(slot(1), *BOTH), modular(slot(1, 2), *BOTH))
    assert [counts for *_, counts in back] == [False, False]


def test_another_default_module_counts():
    found = told(modular(slot(1, 2), *BOTH), modular(slot(1, 2, default=2), *BOTH))
    assert found == [(None, "slots and modules", "slot 0 default module", "0x00000001", "0x00000002", True)]


def test_slots_and_increments():
    one = slot(1)
    found = told(modular(one, *BOTH), modular(one + one, *BOTH, attributes='SlotPdoIncrement="64"'))
    assert found[0][2:] == ("SlotPdoIncrement", "16", "64", True)
    words = "name Axis, MinInstances 1, MaxInstances 1, modules 0x00000001, default module 0x00000001"
    assert found[1][2:] == ("slot 1", None, words, False)


def test_modules_are_compared_as_devices_are():
    types = "<DataType><Name>SINT</Name><BitSize>8</BitSize></DataType>"
    mode = "<Object><Index>#x6060</Index><Name>Modes</Name><Type>SINT</Type><BitSize>8</BitSize></Object>"

    def content(bits: int, data: str, objects: str) -> str:
        command = f"<InitCmd><Transition>PS</Transition><Index>#x6060</Index><SubIndex>0</SubIndex><Data>{data}</Data>"
        return (
            pdo("RxPdo", "#x1600", bits, attributes='Sm="2"')
            + f"<Mailbox><CoE>{command}</InitCmd></CoE></Mailbox>"
            + dictionary(types, objects)
        )

    found = told(
        modular(slot(1), module(1, content(8, "08", mode))), modular(slot(1), module(1, content(16, "09", "")))
    )
    own = [item[1:] for item in found if item[0] == "module 0x00000001"]
    assert own == [
        ("PDO", "RxPDO 0x1600 entry 1", "0x7000:01 (8 bit) e1", "0x7000:01 (16 bit) e1", True),
        ("InitCmd", "CoE InitCmd 0x6060:00 data", "08", "09", True),
        ("objects", "object dictionary", "1 object", None, True),
    ]
    # it is plugged by default: the image of the device differs too
    assert [item[:3] for item in found if item[0] is None] == [
        (None, "process image", "SM2 size"),
        (None, "process image", "SM2 at 0.0"),
    ]


def test_a_device_that_becomes_modular():
    plain = esi(device(SMS))
    found = told(plain, modular(slot(1), module(1)))
    assert [(place, counts) for _, _, place, *_, counts in found] == [
        ("Slots", False),
        ("SlotPdoIncrement", True),
        ("slot 0", False),
        ("module 0x00000001", False),
    ]
