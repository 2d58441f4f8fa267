"""Recipes for drive modes: they ask for nothing that the description rules out."""

import re
from collections.abc import Iterable
from contextlib import suppress
from itertools import combinations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from small_drives import DC, SMS, dictionary, init_cmd, one_device, one_drive, rx_pdo, supported_modes, verdict_of

from esicatalog.errors import InputError
from esicatalog.export.choice import Choice, PdoChoice
from esicatalog.export.configuration import configure
from esicatalog.export.subject import Subject
from esicatalog.identity import ModuleChoice
from esicatalog.model.drive_modes import DriveModeVerdict, drive_modes

CSV = supported_modes("00010000")
PDO_ASSIGN = '<Mailbox><CoE PdoAssign="1"/></Mailbox>'
NO_CONTROLWORD = (
    "the controlword 0x6040 is in none of the assigned RxPDOs, by which a drive is enabled: no RxPDO has it"
)
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
    csv = verdict_of(one_drive(dictionary(CSV) + pdos + PDO_ASSIGN), "CSV")
    assert csv.recipe == (
        f"RxPDO 0x1601 maps the setpoint; it is not assigned by default: choose --pdo 0x1601; {NO_CONTROLWORD}; "
        "0x6060 is in none of the assigned RxPDOs: write 9 to it before operation"
    )


def test_an_init_cmd_counts_where_no_assigned_pdo_has_0x6060():
    pdos = in_rx_pdo("1600", ("6040", 16), ("60FF", 32)) + in_rx_pdo("1602", ("6060", 8), attributes="")
    csv = verdict_of(one_drive("</Profile>" + pdos + init_cmd(9)), "CSV")
    assert csv.recipe.endswith("0x6060 = 9 is written by an InitCmd")


@pytest.mark.parametrize(("access", "is_written"), [("ro", False), ("rw", True), ("wo", True), ("r7w0", False)])
def test_a_0x6060_that_is_read_only_is_not_told_to_be_written(access, is_written):
    """The drive aborts the download (0x06010002). Beside an RxPDO it is process data, whatever SDOs may do.

    An InitCmd that writes it speaks against the dictionary.
    """
    flags = f"<Flags><Access>{access}</Access></Flags></Object>"
    mode = "<Object><Index>#x6060</Index><Name>m</Name><Type>SINT</Type><BitSize>8</BitSize>" + flags
    described = dictionary(CSV, mode)
    csv = verdict_of(one_drive(described + in_rx_pdo("1600", ("6040", 16), ("60FF", 32))), "CSV")
    told = ": write 9 to it before operation"
    if not is_written:
        told = ", and read-only by the description: nothing that is described sets 9 there"
    assert csv.recipe == f"RxPDO 0x1600 maps the setpoint; 0x6060 is in none of the assigned RxPDOs{told}"
    csv = verdict_of(one_drive(described + in_rx_pdo("1600", ("60FF", 32), ("6060", 8))), "CSV")
    assert csv.recipe.endswith("0x6060 is mapped in RxPDO 0x1600: set it to 9")
    csv = verdict_of(one_drive(described + in_rx_pdo("1600", ("6040", 16), ("60FF", 32)) + init_cmd(8)), "CSV")
    doubt = "" if is_written else " (read-only by the description)"
    assert csv.recipe.endswith(f": write 9 to it before operation, after the InitCmd that writes 8{doubt}")


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


def op_modes(*modes: tuple[str, str, str]) -> str:
    """OpModes by name, AssignActivate and what SM2 has in them, none for no list."""
    lists = {pdos: f'<Sm No="2"><Pdo>{pdos}</Pdo></Sm>' if pdos else "" for _, _, pdos in modes}
    items = "".join(
        f"<OpMode><Name>{name}</Name><AssignActivate>{activate}</AssignActivate>{lists[pdos]}</OpMode>"
        for name, activate, pdos in modes
    )
    return f"<Dc>{items}</Dc>"


EXCLUSIVE = in_rx_pdo("1600", ("6040", 16), ("607A", 32), ("6060", 8), excludes="1601")
EXCLUSIVE += in_rx_pdo("1601", ("6040", 16), ("60FF", 32), attributes="")


def test_the_list_of_the_op_mode_that_a_recipe_names_wins():
    """With 'DC' SM2 has 0x1601, whatever Sm of 0x1600 says (ESI-FACTS 0.5 and 18)."""
    modes = op_modes(("SM", "0", ""), ("DC", "#x300", "#x1601"))
    found = one_drive("</Profile>" + EXCLUSIVE + PDO_ASSIGN + modes)
    csp, csv = verdict_of(found, "CSP"), verdict_of(found, "CSV")
    assert csp.recipe == (
        "RxPDO 0x1600 maps the setpoint; it is not assigned with OpMode 'DC': choose --pdo 0x1600; OpMode 'DC'; "
        "0x6060 is mapped in RxPDO 0x1600: set it to 8"
    )
    assert csv.recipe == (
        "RxPDO 0x1601 maps the setpoint; OpMode 'DC'; "
        "0x6060 is in none of the assigned RxPDOs: write 9 to it before operation"
    )
    assert (csp.rx_pdo_is_default, csv.rx_pdo_is_default) == (False, True)


@pytest.mark.parametrize(
    ("lists", "csp", "csv"),
    [
        (("#x1601", "#x1600"), "DC pos", "DC vel"),
        (("#x1601", "#x1601"), "DC vel", "DC vel"),
        (("", "#x1601"), "DC vel", "DC pos"),
    ],
)
def test_of_op_modes_with_sync0_that_counts_which_assigns_the_setpoint(lists, csp, csv):
    """Without a list SM2 has 0x1600, the setpoint of CSP; where none assigns the setpoint the first one counts."""
    modes = op_modes(("SM", "0", ""), ("DC vel", "#x300", lists[0]), ("DC pos", "#x300", lists[1]))
    found = one_drive("</Profile>" + EXCLUSIVE + PDO_ASSIGN + modes)
    assert (verdict_of(found, "CSP").op_mode, verdict_of(found, "CSV").op_mode) == (csp, csv)


def test_0x6060_of_a_pdo_that_the_op_mode_drops_is_no_process_data():
    pdos = in_rx_pdo("1600", ("6040", 16), ("607A", 32)) + in_rx_pdo("1602", ("6060", 8))
    modes = op_modes(("SM", "0", ""), ("DC", "#x300", "#x1600"))
    csp = verdict_of(one_drive("</Profile>" + pdos + modes), "CSP")
    assert csp.recipe.endswith("0x6060 is in none of the assigned RxPDOs: write 8 to it before operation")


def test_an_op_mode_is_named_so_that_an_export_takes_it():
    """Of two of one name the position alone chooses."""
    pdos = in_rx_pdo("1600", ("6040", 16), ("607A", 32))
    csp = verdict_of(
        one_drive("</Profile>" + pdos + op_modes(("SM", "0", ""), ("DC", "0", ""), ("DC", "#x300", ""))), "CSP"
    )
    assert csp.op_mode == "2"
    assert "; OpMode 2 'DC'; " in csp.recipe


def test_an_op_mode_whose_position_is_the_name_of_another_is_named_by_an_explicit_position():
    pdos = in_rx_pdo("1600", ("6040", 16), ("607A", 32))
    csp = verdict_of(one_drive("</Profile>" + pdos + op_modes(("1", "0", ""), ("", "#x300", ""))), "CSP")
    assert csp.op_mode == "#1"
    assert "; OpMode #1; " in csp.recipe


PLAIN_AND_CSV = in_rx_pdo("1600", ("6040", 16), attributes='Sm="2" Fixed="1"')
ADDED = in_rx_pdo("1601", ("60FF", 32), attributes='Fixed="1"')
MANDATORY = PLAIN_AND_CSV.replace("<RxPdo ", '<RxPdo Mandatory="1" ')
EXCLUDING = in_rx_pdo("1601", ("60FF", 32), attributes='Fixed="1"', excludes="1600")


@pytest.mark.parametrize(
    ("pdos", "sync_managers", "obstacle"),
    [
        (MANDATORY + EXCLUDING, SMS, "cannot be assigned beside 0x1600, which is mandatory"),
        (
            EXCLUDING.replace("<RxPdo ", '<RxPdo Sm="2" ') + MANDATORY,
            SMS,
            "cannot be assigned beside 0x1600, which is mandatory",
        ),
        (
            PLAIN_AND_CSV + ADDED.replace("<RxPdo ", '<RxPdo Sm="4" '),
            SMS + '<Sm Virtual="1">Outputs</Sm>',
            "is of the virtual SM4: no register of the ESC is programmed for it, an FMMU alone may map it",
        ),
        (PLAIN_AND_CSV + ADDED.replace("<RxPdo ", '<RxPdo Sm="3" '), SMS, "cannot be assigned: SM3 is for Inputs"),
        (
            PLAIN_AND_CSV + ADDED,
            SMS.replace("<Sm>Outputs", '<Sm FixedAssignment="1">Outputs'),
            "cannot be chosen: the assignment of SM2 is fixed",
        ),
        (PLAIN_AND_CSV + ADDED.replace("</RxPdo>", "<ExcludedSm>2</ExcludedSm></RxPdo>"), SMS, "may not go to SM2"),
    ],
)
def test_a_pdo_that_the_description_rules_out_is_no_setpoint(pdos, sync_managers, obstacle):
    """What an export refuses to assign."""
    csv = verdict_of(one_drive(dictionary(CSV) + pdos + PDO_ASSIGN, sync_managers=sync_managers), "CSV")
    assert (csv.verdict, csv.rx_pdo_index) == ("yes", None)
    assert csv.recipe.split("; ")[0] == f"no setpoint: RxPDO 0x1601 has 0x60FF, but {obstacle}"


@pytest.mark.parametrize(
    ("first", "second", "obstacle"),
    [
        ("1601", "1601", "cannot be chosen: its index means the PDO that is described before it"),
        ("1600", "", "cannot be assigned without an index"),
    ],
)
def test_a_setpoint_in_a_pdo_that_no_index_means_is_none(first, second, obstacle):
    """An assignment holds indices, and of two PDOs of one index the first is assigned."""
    one = in_rx_pdo(first, ("6040", 16), attributes='Sm="2" Fixed="1"')
    other = in_rx_pdo(second, ("60FF", 32), attributes='Fixed="1"').replace("<Index>#x</Index>", "", 1)
    csv = verdict_of(one_drive(dictionary(CSV) + one + other + PDO_ASSIGN), "CSV")
    assert (csv.verdict, csv.rx_pdo_index) == ("yes", None)
    named = f"RxPDO 0x{second}" if second else "an RxPDO"
    assert csv.recipe.split("; ")[0] == f"no setpoint: {named} has 0x60FF, but {obstacle}"


def test_of_two_pdos_of_one_index_that_are_alike_either_is_meant():
    two = ADDED * 2
    csv = verdict_of(one_drive(dictionary(CSV) + PLAIN_AND_CSV + two + PDO_ASSIGN), "CSV")
    assert csv.recipe.startswith("RxPDO 0x1601 maps the setpoint; it is not assigned by default")


UNUSABLE = [
    ("<BitLen>{}</BitLen>", "", "without a usable BitLen"),
    ("<BitLen>{}</BitLen>", "<BitLen>-8</BitLen>", "without a usable BitLen"),
    ("<BitLen>{}</BitLen>", "<BitLen>0</BitLen>", "in an entry of 0 bits"),
    ("<SubIndex>0</SubIndex>", "<SubIndex>0h</SubIndex>", "without a usable SubIndex"),
]


@pytest.mark.parametrize(("place", "unusable", "obstacle"), UNUSABLE)
@pytest.mark.parametrize("attributes", ["", 'Sm="2"'])
def test_a_setpoint_in_an_entry_that_no_export_makes_is_none(place, unusable, obstacle, attributes):
    """Assigned by default or not."""
    pdos = in_rx_pdo("1601", ("60FF", 32), attributes=attributes).replace(place.format(32), unusable)
    csv = verdict_of(one_drive(dictionary(CSV) + pdos + PDO_ASSIGN), "CSV")
    assert (csv.verdict, csv.rx_pdo_index) == ("yes", None)
    assert csv.recipe.split("; ")[0] == f"no setpoint: RxPDO 0x1601 has 0x60FF, but {obstacle}"


@pytest.mark.parametrize(("place", "unusable", "obstacle"), UNUSABLE)
def test_0x6060_in_an_entry_that_no_export_makes_cannot_be_set(place, unusable, obstacle):
    pdos = in_rx_pdo("1600", ("6040", 16), ("60FF", 32)) + in_rx_pdo("1601", ("6060", 8)).replace(
        place.format(8), unusable
    )
    csv = verdict_of(one_drive(dictionary(CSV) + pdos + PDO_ASSIGN), "CSV")
    assert csv.recipe == (
        f"RxPDO 0x1600 maps the setpoint; 0x6060 is mapped in RxPDO 0x1601 (assigned by default), but {obstacle}"
    )


def test_a_setpoint_in_a_pdo_that_is_ruled_out_may_be_mapped_into_another():
    fixed = SMS.replace("<Sm>Outputs", '<Sm FixedAssignment="1">Outputs')
    pdos = in_rx_pdo("1600", ("6040", 16)) + ADDED
    csv = verdict_of(one_drive(dictionary(CSV, mappable("60FF")) + pdos + PDO_CONFIG, sync_managers=fixed), "CSV")
    assert csv.recipe.startswith("map the setpoint 0x60FF into an RxPDO; ")


def test_a_recipe_says_what_a_device_without_pdo_assign_may_do():
    csv = verdict_of(one_drive(dictionary(CSV) + PLAIN_AND_CSV + ADDED), "CSV")
    assert csv.recipe.startswith(
        "RxPDO 0x1601 maps the setpoint; it is not assigned by default, and the device does not declare PdoAssign: "
        "it may keep its default assignment: choose --pdo 0x1600,0x1601; "
    )


def commands(*writes: tuple[str, int]) -> str:
    """InitCmds that write to 0x6060, by transition."""
    items = "".join(
        f"<InitCmd><Transition>{transition}</Transition><Index>#x6060</Index><SubIndex>0</SubIndex>"
        f"<Data>{mode:02X}</Data></InitCmd>"
        for transition, mode in writes
    )
    return f"<Mailbox><CoE>{items}</CoE></Mailbox>"


AT_SO = " of SO: call send_so() of an export that has it (IgH, SOEM, pysoem), else write 9 to it before operation"
BOTH = in_rx_pdo("1600", ("6040", 16), ("607A", 32), ("60FF", 32))


@pytest.mark.parametrize("writes", [(("PS", 8), ("SO", 9)), (("SO", 9), ("PS", 8)), (("PS", 8), ("PS", 9))])
def test_the_last_write_of_a_start_counts(writes):
    """IP, PS, SO are the order of a start, SO leads to OP (ESI-FACTS section 10)."""
    found = one_drive("</Profile>" + BOTH + commands(*writes) + DC)
    csp, csv = verdict_of(found, "CSP"), verdict_of(found, "CSV")
    assert (csp.verdict, csv.verdict) == ("likely", "yes")
    assert csp.recipe.endswith("write 8 to it before operation, after the InitCmd that writes 9")
    assert csv.recipe.endswith(f"0x6060 = 9 is written by an InitCmd{'' if ('PS', 9) in writes else AT_SO}")


@pytest.mark.parametrize(("transition", "words"), [("SO", AT_SO), ("PS", "")])
def test_masters_send_commands_before_safe_op(transition, words):
    """An export sends one of SO by a function that the application calls, or leaves it out (ros2, linuxcnc)."""
    csv = verdict_of(one_drive("</Profile>" + BOTH + commands((transition, 9)) + DC), "CSV")
    assert (csv.verdict, csv.recipe.split("; ")[-1]) == ("yes", f"0x6060 = 9 is written by an InitCmd{words}")


@pytest.mark.parametrize("transition", ["OS", "SP", "OP"])
def test_a_command_that_leads_back_starts_no_mode(transition):
    """SP SafeOP to PreOP, OP OP to PreOP, OS OP to SafeOP (ESI-FACTS section 10)."""
    found = one_drive("</Profile>" + BOTH + commands((transition, 6)) + DC)
    assert "HM" not in {item.mode for item in (*found.evidence, *found.verdicts)}


@pytest.mark.parametrize(
    ("place", "unread"),
    [
        ("<SubIndex>0</SubIndex>", "<SubIndex>0h</SubIndex>"),
        ("<SubIndex>0</SubIndex>", "<SubIndex>256</SubIndex>"),
        ("<InitCmd>", '<InitCmd CompleteAccess="yes">'),
    ],
)
def test_a_command_that_does_not_tell_where_it_writes_to_starts_no_mode(place, unread):
    """No export sends it."""
    pdos = in_rx_pdo("1600", ("6040", 16), ("60FF", 32))
    command = init_cmd(9)
    told, csv = (
        verdict_of(one_drive("</Profile>" + pdos + text + DC), "CSV")
        for text in (command, command.replace(place, unread))
    )
    assert (told.verdict, csv.verdict) == ("yes", "likely")
    assert told.recipe.endswith("0x6060 = 9 is written by an InitCmd")
    assert csv.recipe.endswith("0x6060 is in none of the assigned RxPDOs: write 9 to it before operation")


TX_PDO = in_rx_pdo("1A00", ("6041", 16), attributes='Sm="3"').replace("RxPdo", "TxPdo")
OTHER_TX_PDO = in_rx_pdo("1A01", ("6041", 16), attributes="").replace("RxPdo", "TxPdo")
EXCLUDING_INPUTS = in_rx_pdo("1601", ("60FF", 32), attributes='Fixed="1"', excludes="1A00")


def test_a_setpoint_that_excludes_what_another_sync_manager_has_by_default():
    """``--pdo 0x1601`` alone is refused: SM3 would keep 0x1A00. Where SM3 can have nothing else no choice is left."""
    excluding = dictionary(CSV) + PLAIN_AND_CSV + EXCLUDING_INPUTS + TX_PDO
    csv = verdict_of(one_drive(excluding + OTHER_TX_PDO + PDO_ASSIGN), "CSV")
    assert csv.recipe.startswith(
        "RxPDO 0x1601 maps the setpoint; it is not assigned by default: choose --pdo 0x1600,0x1601; choose the PDOs of "
        "SM3 too, without 0x1A00; "
    )
    csv = verdict_of(one_drive(excluding + PDO_ASSIGN), "CSV")
    assert csv.recipe.split("; ")[0] == (
        "no setpoint: RxPDO 0x1601 has 0x60FF, but cannot be assigned beside 0x1A00, the only one that SM3 can have"
    )


def test_a_mandatory_pdo_that_the_op_mode_lists_stays_without_an_sm():
    listed = MANDATORY.replace('Sm="2"', "")
    csv = verdict_of(
        one_drive(dictionary(CSV) + listed + EXCLUDING + PDO_ASSIGN + op_modes(("SM", "0", "#x1600"))), "CSV"
    )
    assert csv.recipe.split("; ")[0] == (
        "no setpoint: RxPDO 0x1601 has 0x60FF, but cannot be assigned beside 0x1600, which is mandatory"
    )


INDICES = ("1600", "1601", "1602", "1A00", "1A01")
ENTRIES = (("6040", 16), ("60FF", 32), ("607A", 32), ("6060", 8))


@st.composite
def drives(draw: st.DrawFn) -> str:
    """PDOs that are assigned, mandatory, excluded and listed in any way."""
    content = ""
    for index in INDICES:
        is_rx = index.startswith("16")
        attributes = draw(st.sampled_from(["", 'Sm="2"' if is_rx else 'Sm="3"']))
        attributes += draw(st.sampled_from(["", "", ' Mandatory="1"']))
        entries = draw(st.sets(st.sampled_from(ENTRIES), min_size=1)) if is_rx else {("6041", 16)}
        excluded = draw(st.sampled_from(["", *(other for other in INDICES if other != index)]))
        described = in_rx_pdo(index, *sorted(entries), attributes=attributes, excludes=excluded)
        content += described if is_rx else described.replace("RxPdo", "TxPdo")
    listed = draw(st.sampled_from(["", "#x1600", "#x1602"]))
    return f"</Profile>{content}{PDO_ASSIGN}{op_modes(('DC', '#x300', listed))}"


@settings(max_examples=100)
@given(drives())
def test_exports_take_what_a_recipe_asks_for(content):
    """The RxPDOs that it lists, none where those of the setpoint are assigned, with other PDOs where it says so.

    The controlword is among what is assigned then, or the recipe says that it is not.
    """
    device = one_device(content)
    for verdict in drive_modes(device).verdicts:
        if verdict.rx_pdo_index is None or verdict.recipe is None:
            continue
        left_out = [int(index, 16) for index in re.findall("too, without (0x[0-9A-F]+)", verdict.recipe)]
        others = [pdo.pdo_index for pdo in device.tx_pdos if pdo.pdo_index not in left_out]
        further = [chosen for count in range(3) for chosen in combinations(others, count)] if left_out else [()]
        listed = chosen_in(verdict.recipe)
        assert verdict.rx_pdo_is_default == (not listed)
        found = [mapped_with(Subject(1, "V", device), verdict, (*listed, *more)) for more in further]
        made = next(pdos for pdos in found if verdict.rx_pdo_index in pdos)
        assert made.keys() >= set(listed)
        has_controlword = any(0x6040 in entries for entries in made.values())
        assert has_controlword == ("the controlword 0x6040 is in none" not in verdict.recipe)


def chosen_in(recipe: str) -> list[int]:
    """What a recipe tells to choose."""
    found = re.search("choose --pdo ([0-9A-Fx,]+)", recipe)
    return [int(index, 16) for index in found[1].split(",")] if found else []


def mapped_with(subject: Subject, verdict: DriveModeVerdict, pdos: Iterable[int]) -> dict[int, set[int]]:
    """What PDOs of an export map that follows a recipe, by their indices; none for a choice that is refused."""
    plugged = re.findall(r"plug module (\w+) into slot (\d+)", verdict.recipe)
    modules = {int(slot): ModuleChoice(int(ident, 16)) for ident, slot in plugged}
    with suppress(InputError):
        found = configure(subject, Choice(tuple(map(PdoChoice, pdos)), modules=modules, op_mode=verdict.op_mode))
        return {pdo.pdo_index: {e.entry_index for e in pdo.entries} for sm in found.sync_managers for pdo in sm.pdos}
    return {}


CONTROL, MODE = in_rx_pdo("1600", ("6040", 16)), in_rx_pdo("1602", ("6060", 8), ("60FE", 32))
VELOCITY = in_rx_pdo("1606", ("60FF", 32), attributes="")


@pytest.mark.parametrize(
    ("pdos", "choice", "step"),
    [
        (CONTROL + in_rx_pdo("1601", ("607A", 32)), "0x1600,0x1606", "write 9"),
        (CONTROL + MODE, "0x1600,0x1602,0x1606", "0x6060 is mapped in RxPDO 0x1602: set it to 9"),
        (in_rx_pdo("1600", ("6040", 16), ("607A", 32), ("6060", 8)), "0x1600,0x1606", "in RxPDO 0x1600: set it to 9"),
        (CONTROL + in_rx_pdo("1601", ("6860", 8), ("6840", 16), ("687A", 32)), "0x1600,0x1601,0x1606", "write 9"),
        (CONTROL + in_rx_pdo("1602", ("6060", 8), excludes="1606"), "0x1600,0x1606", "write 9"),
    ],
)
def test_a_recipe_lists_what_goes_with_the_setpoint(pdos, choice, step):
    """Chosen PDOs replace those of their SyncManager: controlword, mode and what else is there stay by being chosen.

    Not the setpoint of another mode of the axis (0x607A), nor what excludes the setpoint.
    """
    found = one_drive(dictionary(CSV) + pdos + VELOCITY + PDO_ASSIGN)
    (csv,) = [item for item in found.verdicts if (item.axis, item.mode) == (0, "CSV")]
    assert csv.recipe.startswith(
        f"RxPDO 0x1606 maps the setpoint; it is not assigned by default: choose --pdo {choice}; "
    )
    assert step in csv.recipe.split("; ")[-1]


def test_a_recipe_does_not_list_what_maps_an_object_again():
    """Every copy of the controlword would be sent, and programs that find entries by index write the first one only."""
    default = in_rx_pdo("1600", ("6040", 16), ("607A", 32), ("6060", 8))
    other = in_rx_pdo("1601", ("6040", 16), ("60FF", 32), attributes="")
    csv = verdict_of(one_drive(dictionary(CSV) + default + other + PDO_ASSIGN), "CSV")
    assert csv.recipe == (
        "RxPDO 0x1601 maps the setpoint; it is not assigned by default: choose --pdo 0x1601; "
        "0x6060 is in none of the assigned RxPDOs: write 9 to it before operation"
    )


@pytest.mark.parametrize(
    ("pdos", "words"),
    [
        (in_rx_pdo("1601", ("6040", 16), attributes=""), "RxPDO 0x1601 has it"),
        (
            in_rx_pdo("1601", ("6040", 16), attributes="", excludes="1600")
            + in_rx_pdo("1602", ("6040", 16), attributes=""),
            "RxPDO 0x1602 has it",
        ),
        (
            in_rx_pdo("1601", ("6040", 16), attributes="", excludes="1600"),
            "no RxPDO that may be beside them has it",
        ),
    ],
)
def test_a_recipe_tells_which_pdo_has_the_controlword_that_is_not_assigned(pdos, words):
    """One that what is assigned excludes cannot be chosen beside it."""
    drive = one_drive(dictionary(CSV) + in_rx_pdo("1600", ("60FF", 32)) + pdos + PDO_ASSIGN)
    told = verdict_of(drive, "CSV").recipe.split("; ")[1]
    assert told == NO_CONTROLWORD.replace("no RxPDO has it", words)


def test_controlword_and_mode_count_at_the_subindex_at_which_they_are_mapped():
    """Whoever wrote 0x6060 by SDO would have it overwritten in every cycle."""
    pdo = in_rx_pdo("1600", ("6040", 16), ("60FF", 32), ("6060", 8)).replace("<SubIndex>0<", "<SubIndex>1<")
    csv = verdict_of(one_drive(dictionary() + pdo + DC), "CSV")
    assert "controlword" not in csv.recipe
    assert csv.recipe.endswith("is mapped in RxPDO 0x1600: set it to 9")


def test_a_pdo_that_comes_back_with_the_choice_counts():
    """0x1600 keeps 0x1603 of another SyncManager out; 0x1601, which replaces it, does not."""
    pdos = in_rx_pdo("1600", ("6040", 16), ("607A", 32), excludes="1603")
    pdos += in_rx_pdo("1601", ("6040", 16), ("60FF", 32), excludes="1600", attributes="")
    pdos += in_rx_pdo("1603", ("6060", 8), attributes='Sm="4"')
    found = one_drive(dictionary(CSV) + pdos + PDO_ASSIGN, sync_managers=SMS + "<Sm>Outputs</Sm>")
    assert verdict_of(found, "CSV").recipe == (
        "RxPDO 0x1601 maps the setpoint; it is not assigned by default: choose --pdo 0x1601; "
        "0x6060 is mapped in RxPDO 0x1603 (assigned by default): set it to 9"
    )


def test_a_choice_that_takes_the_controlword_of_another_axis_says_so():
    both = in_rx_pdo("1600", ("6040", 16), ("607A", 32), ("6840", 16), ("687A", 32), excludes="1601")
    first = in_rx_pdo("1601", ("6040", 16), ("60FF", 32), attributes="")
    csv = verdict_of(one_drive(dictionary(CSV) + both + first + PDO_ASSIGN), "CSV")
    assert csv.recipe.split("; ")[1:3] == [
        "it is not assigned by default: choose --pdo 0x1601",
        "axis 1 then has no controlword",
    ]
    without = first.replace("#x6040", "#x6042")
    csv = verdict_of(one_drive(dictionary(CSV) + both + without + PDO_ASSIGN), "CSV")
    assert csv.recipe.split("; ")[2:4] == [
        NO_CONTROLWORD.replace("no RxPDO has", "no RxPDO that may be beside them has"),
        "axis 1 then has no controlword",
    ]


@pytest.mark.parametrize(
    ("objects", "place"),
    [
        ((), "0x60FF:05, which neither CiA 402 nor a dictionary has"),
        ((mappable("60FF"),), "0x60FF:05, which neither CiA 402 nor a dictionary has"),
    ],
)
def test_a_setpoint_at_a_subindex_that_nothing_has_is_named_with_it(objects, place):
    """0x60FF is a VAR of CiA 402, whose only subindex is 0."""
    pdo = in_rx_pdo("1600", ("60FF", 32), ("6040", 16)).replace("<SubIndex>0<", "<SubIndex>5<", 1)
    found = one_drive(dictionary(*objects) + pdo + DC)
    csv = verdict_of(found, "CSV")
    assert csv.evidence == f"RxPDO 0x1600 maps {place}, and a DC OpMode generates SYNC0"
    assert csv.recipe.startswith(f"RxPDO 0x1600 maps the setpoint as {place}; ")
