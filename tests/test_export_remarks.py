"""What every export says of a configuration that the device may not have: start-up commands, defaults, slots, sizes."""

import pytest
from snippets import dictionary
from test_export_configuration import SMS, configured, entry, rx

from esicatalog.errors import InputError
from esicatalog.export.choice import parse_pdo_choice


def declared(*subindices: int) -> str:
    """A dictionary with the mapping 0x1600 of these subindices and three objects for it."""
    items = "".join(
        f"<SubItem><SubIdx>{n}</SubIdx><Name>{n}</Name><Type>{'UDINT' if n else 'USINT'}</Type>"
        f"<BitSize>{32 if n else 8}</BitSize><BitOffs>{32 * n}</BitOffs></SubItem>"
        for n in (0, *subindices)
    )
    mapping = f"<DataType><Name>DT1600</Name><BitSize>96</BitSize>{items}</DataType>"
    types = "".join(f"<DataType><Name>{name}</Name><BitSize>{n}</BitSize></DataType>" for name, n in SIZES.items())
    objects = "".join(
        f"<Object><Index>#x{index}</Index><Name>o</Name><Type>UDINT</Type><BitSize>32</BitSize>"
        "<Flags><Access>rw</Access><PdoMapping>R</PdoMapping></Flags></Object>"
        for index in ("7001", "7002", "7003")
    )
    record = "<Object><Index>#x1600</Index><Name>map</Name><Type>DT1600</Type><BitSize>96</BitSize></Object>"
    return dictionary(types + (mapping if subindices else ""), objects + (record if subindices else ""))


SIZES = {"USINT": 8, "UDINT": 32}
MAPPABLE = SMS + rx("#x1600", entry("#x7001", 32, "a")) + '<Mailbox><CoE PdoAssign="1" PdoConfig="1"/></Mailbox>'


def test_no_more_entries_than_the_mapping_has_subindices():
    three = parse_pdo_choice("0x1600=0x7001+0x7002+0x7003")
    with pytest.raises(InputError, match="3 entries are chosen for PDO 0x1600, which has room for 2: the dictionary"):
        configured(declared(1, 2) + MAPPABLE, pdos=three)
    for known in (declared(1, 2, 3), declared()):
        found = configured(known + MAPPABLE, pdos=three)
        assert [sm.byte_size for sm in found.sync_managers if sm.pdos] == [12]
