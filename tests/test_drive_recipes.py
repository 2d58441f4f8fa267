"""Recipes for drive modes: they ask for nothing that the description rules out."""

import pytest
from small_drives import DC, dictionary, init_cmd, one_drive, rx_pdo, supported_modes, verdict_of

CSV = supported_modes("00010000")
PDO_CONFIG = '<Mailbox><CoE PdoConfig="1"/></Mailbox>'


def in_rx_pdo(index: str, *entries: tuple[str, int], excludes: str = "", attributes: str = 'Sm="2"') -> str:
    """An RxPDO of this index; Sm="2" assigns it by default."""
    excluded = f"</Name><Exclude>#x{excludes}</Exclude>" if excludes else "</Name>"
    return rx_pdo(*entries).replace("#x1600", f"#x{index}").replace("</Name>", excluded).replace('Sm="2"', attributes)


def mappable(index: str, letter: str = "R") -> str:
    """An object of 32 bits that the dictionary lets into PDOs of a direction."""
    flags = f"<Flags><PdoMapping>{letter}</PdoMapping></Flags>"
    return f"<Object><Index>#x{index}</Index><Name>o</Name><Type>DINT</Type><BitSize>32</BitSize>{flags}</Object>"


def test_0x6060_of_another_default_pdo_is_process_data():
    """Writing it by SDO is in vain: the RxPDO overwrites it in every cycle."""
    pdos = in_rx_pdo("1600", ("6040", 16)) + in_rx_pdo("1601", ("60FF", 32)) + in_rx_pdo("1602", ("6060", 8))
    csv = verdict_of(one_drive(dictionary(CSV) + pdos), "CSV")
    assert csv.recipe == (
        "RxPDO 0x1601 maps the setpoint; 0x6060 is mapped in RxPDO 0x1602 (assigned by default): set it to 9"
    )


def test_process_data_overwrite_what_an_init_cmd_writes():
    pdos = in_rx_pdo("1600", ("6040", 16), ("60FF", 32)) + in_rx_pdo("1602", ("6060", 8))
    csv = verdict_of(one_drive("</Profile>" + pdos + init_cmd(9) + DC), "CSV")
    assert csv.recipe.endswith("0x6060 is mapped in RxPDO 0x1602 (assigned by default): set it to 9")


def test_0x6060_beside_the_setpoint_counts_first():
    pdos = in_rx_pdo("1600", ("6060", 8)) + in_rx_pdo("1601", ("60FF", 32), ("6060", 8))
    csv = verdict_of(one_drive(dictionary(CSV) + pdos), "CSV")
    assert csv.recipe.endswith("0x6060 is mapped in RxPDO 0x1601: set it to 9")


@pytest.mark.parametrize("excluding", ["1600", "1601"])
def test_a_default_pdo_that_the_setpoint_excludes_does_not_stay(excluding):
    """Whichever of the two says so."""
    other = {"1600": "1601", "1601": "1600"}[excluding]
    excludes = {excluding: other}
    pdos = in_rx_pdo("1600", ("6060", 8), excludes=excludes.get("1600", ""))
    pdos += in_rx_pdo("1601", ("60FF", 32), excludes=excludes.get("1601", ""), attributes="")
    csv = verdict_of(one_drive(dictionary(CSV) + pdos), "CSV")
    assert csv.recipe == (
        "RxPDO 0x1601 maps the setpoint; it is not assigned by default; "
        "0x6060 is in none of the assigned RxPDOs: write 9 to it before operation"
    )


def test_an_init_cmd_counts_where_no_assigned_pdo_has_0x6060():
    pdos = in_rx_pdo("1600", ("6040", 16), ("60FF", 32)) + in_rx_pdo("1602", ("6060", 8), attributes="")
    csv = verdict_of(one_drive("</Profile>" + pdos + init_cmd(9)), "CSV")
    assert csv.recipe.endswith("0x6060 = 9 is written by an InitCmd")


def test_homing_has_no_setpoint_and_takes_0x6060_from_the_default_pdo():
    homing = supported_modes("20000000")
    hm = verdict_of(one_drive(dictionary(homing) + in_rx_pdo("1600", ("6040", 16), ("6060", 8))), "HM")
    assert hm.recipe == "0x6060 is mapped in RxPDO 0x1600 (assigned by default): set it to 6"


PLAIN = in_rx_pdo("1600", ("6040", 16))
FIXED = PLAIN.replace("<RxPdo ", '<RxPdo Fixed="1" ')


@pytest.mark.parametrize(
    ("objects", "rest", "step"),
    [
        (mappable("60FF"), PLAIN + PDO_CONFIG, "map the setpoint 0x60FF into an RxPDO"),
        ("", PLAIN + PDO_CONFIG, "no setpoint: neither an RxPDO nor the dictionary has 0x60FF"),
        (
            mappable("60FF", "T"),
            PLAIN + PDO_CONFIG,
            "no setpoint: no RxPDO has 0x60FF, and the dictionary lets it into none",
        ),
        (
            mappable("60FF"),
            PLAIN,
            "no setpoint: no RxPDO has 0x60FF, and none can be given it: "
            "its mapping cannot be changed: the device does not declare PdoConfig",
        ),
        (
            mappable("60FF"),
            FIXED + PDO_CONFIG,
            "no setpoint: no RxPDO has 0x60FF, and none can be given it: its mapping is Fixed",
        ),
        (mappable("60FF"), PDO_CONFIG, "no setpoint: the file describes no RxPDO to map 0x60FF into"),
    ],
)
def test_a_setpoint_is_to_be_mapped_only_where_it_can_be(objects, rest, step):
    csv = verdict_of(one_drive(dictionary(CSV, objects) + rest), "CSV")
    assert csv.verdict == "yes"
    assert csv.recipe.split("; ")[0] == step


def test_without_a_dictionary_nothing_is_known_of_objects():
    commanded = init_cmd(9).replace("<CoE>", '<CoE PdoConfig="1">')
    csv = verdict_of(one_drive("</Profile>" + PLAIN + commanded), "CSV")
    assert csv.recipe.startswith(
        "no RxPDO has the setpoint 0x60FF, and without a dictionary nothing says that it can be mapped; "
    )
    fixed = verdict_of(one_drive("</Profile>" + FIXED + commanded), "CSV")
    assert fixed.recipe.startswith("no setpoint: no RxPDO has 0x60FF, and none can be given it: its mapping is Fixed; ")


def test_a_record_is_mappable_by_its_members():
    """0x60C1:00 is the number of set-points, 0x60C1:01 the one that the master writes."""
    members = "".join(
        f"<SubItem><SubIdx>{n}</SubIdx><Name>s{n}</Name><Type>{kind}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{16 * n}</BitOffs>{flags}</SubItem>"
        for n, kind, bits, flags in (
            (0, "USINT", 8, ""),
            (1, "DINT", 32, "<Flags><Access>rw</Access><PdoMapping>R</PdoMapping></Flags>"),
        )
    )
    types = f"<DataType><Name>DT60C1</Name><BitSize>48</BitSize>{members}</DataType>"
    record = "<Object><Index>#x60C1</Index><Name>o</Name><Type>DT60C1</Type><BitSize>48</BitSize></Object>"
    found = one_drive(dictionary(supported_modes("40000000"), record, types=types) + PLAIN + PDO_CONFIG)
    assert verdict_of(found, "IP").recipe.startswith("map the setpoint 0x60C1 into an RxPDO; ")
    assert ("IP", "E") in {(item.mode, item.rank) for item in found.evidence}
