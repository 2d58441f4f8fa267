"""Rules about SyncManagers, PDOs, their assignment and the times of the clocks, on documents written for each."""

import pytest
from snippets import device, dictionary, pdo
from test_lint_rules import declared, linted, module, slots

MAILBOX_AND_PROCESS_DATA = (
    '<Sm DefaultSize="128">MBoxOut</Sm><Sm DefaultSize="128">MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>'
    "<Sm>DynamicOutputs</Sm><Sm>Orbita</Sm>"
)


@pytest.mark.parametrize(
    ("kind", "sm", "role"),
    [
        ("RxPdo", 0, "MBoxOut"),
        ("TxPdo", 1, "MBoxIn"),
        ("RxPdo", 3, "Inputs"),
        ("TxPdo", 4, "DynamicOutputs"),
        ("RxPdo", 2, None),
        ("RxPdo", 4, None),
        ("TxPdo", 5, None),  # a word of the vendor's says nothing
    ],
)
@pytest.mark.parametrize("in_module", [False, True])
def test_l27_knows_what_a_sync_manager_is_for(tmp_path, kind, sm, role, in_module):
    assigned = pdo(kind, "#x1600", 8, attributes=f'Sm="{sm}"')
    own, carried = (slots(1), module(assigned)) if in_module else (assigned, "")
    found = linted(tmp_path, "L27", device(MAILBOX_AND_PROCESS_DATA + own), carried)
    assert [item["message"].partition("which is ")[2] for item in found] == ([f"{role}: correct Sm"] if role else [])


@pytest.mark.parametrize("in_module", [False, True])
def test_l27_says_whose_sync_managers_it_counts(tmp_path, in_module):
    assigned = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')
    own, carried = (slots(1), module(assigned)) if in_module else (assigned, "")
    (found,) = linted(tmp_path, "L27", device("<Sm>MBoxOut</Sm>" + own), carried)
    of = "'T1'" if in_module else "the device"
    assert found["message"] == f"RxPdo 0x1600 is assigned to SM 2 of {of}, which has 1 SyncManager: correct Sm"


def test_l27_says_nothing_of_an_excluded_sync_manager_that_cannot_be_read(tmp_path):
    somewhere = pdo("RxPdo", "#x1600", 8, extra="<ExcludedSm>two</ExcludedSm>")
    assert linted(tmp_path, "L27", device(MAILBOX_AND_PROCESS_DATA + somewhere)) == []


def test_l35_says_nothing_of_an_image_of_unknown_length(tmp_path):
    variable = "<RxPdo Sm='2'><Index>#x1600</Index><Name>P</Name></RxPdo>"
    content = MAILBOX_AND_PROCESS_DATA + variable + pdo("RxPdo", "#x1601", 11, attributes='Sm="2"')
    assert linted(tmp_path, "L35", device(content)) == []


UNREADABLE = {
    "L66": pdo("RxPdo", "#x1600", 8, attributes='Sm="x" Mandatory="1"'),
    "L61": '<Mailbox><CoE SdoInfo="yes"/></Mailbox>',
    "L62 PdoAssign": pdo("RxPdo", "#x1600", 8, attributes='Fixed="1"') + '<Mailbox><CoE PdoAssign="yes"/></Mailbox>',
    "L62 Sm": pdo("RxPdo", "#x1600", 8, attributes='Fixed="1" Sm="x"') + "<Mailbox><CoE/></Mailbox>",
    "L62 PdoConfig": pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + '<Mailbox><CoE PdoConfig="yes"/></Mailbox>',
    "L62 Fixed": pdo("RxPdo", "#x1600", 8, attributes='Sm="2" Fixed="ja"') + "<Mailbox><CoE/></Mailbox>",
    "L50": "<Dc><OpMode><Name>DC</Name><AssignActivate>#x700</AssignActivate><CycleTimeSync0>5</CycleTimeSync0>"
    "<CycleTimeSync1>1.5</CycleTimeSync1></OpMode></Dc>",
    "L51": "<Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate>"
    "<CycleTimeSync0>#x10 us</CycleTimeSync0></OpMode></Dc>",
}


@pytest.mark.parametrize(("rule_id", "content"), UNREADABLE.items(), ids=UNREADABLE)
def test_what_cannot_be_read_is_not_called_missing(tmp_path, rule_id, content):
    """The reader tells of it."""
    assert linted(tmp_path, rule_id.split()[0], device(MAILBOX_AND_PROCESS_DATA + content)) == []


@pytest.mark.parametrize("rule_id", ["L10", "L14"])
def test_a_device_that_may_be_invisible_is_not_said_to_be_visible(tmp_path, rule_id):
    described = device(product="").replace('Physics="YY"', 'Invisible="ja"')
    assert linted(tmp_path, rule_id, described) == []


def test_l52_knows_the_sync_managers_that_a_pdo_excludes(tmp_path):
    listing = (
        '<Dc><OpMode><Name>a</Name><AssignActivate>0</AssignActivate><Sm No="2"><Pdo>#x1600</Pdo></Sm></OpMode></Dc>'
    )
    excluding = pdo("RxPdo", "#x1600", 8, extra="<ExcludedSm>2</ExcludedSm>")
    (found,) = linted(tmp_path, "L52", device(MAILBOX_AND_PROCESS_DATA + excluding + listing))
    words = "assigns PDO 0x1600 to SM 2, which its ExcludedSm rules out: correct one of them"
    assert found["message"] == f"OpMode 0 'a' {words}"


def test_l27_finds_a_pdo_that_may_not_go_to_its_own_sync_manager(tmp_path):
    assigned = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"', extra="<ExcludedSm>2</ExcludedSm>")
    (found,) = linted(tmp_path, "L27", device(MAILBOX_AND_PROCESS_DATA + assigned))
    assert found["message"].endswith("0x1600 is assigned to SM 2, which its ExcludedSm rules out: correct one of them")


@pytest.mark.parametrize(
    ("sm", "index", "words"),
    [
        (0, "#x1600", "assigns the RxPdo 0x1600 to SM 0, which is MBoxOut"),
        (2, "#x1A00", "assigns the TxPdo 0x1A00 to SM 2, which is Outputs"),
        (6, "#x1600", "names SM 6; there are 6: correct No"),
        (2, "#x1600", None),
        (5, "#x1A00", None),
    ],
)
def test_l52_knows_what_a_sync_manager_is_for(tmp_path, sm, index, words):
    mode = f'<OpMode><Name>DC</Name><AssignActivate>0</AssignActivate><Sm No="{sm}"><Pdo>{index}</Pdo></Sm></OpMode>'
    pdos = pdo("RxPdo", "#x1600", 8) + pdo("TxPdo", "#x1A00", 8)
    found = linted(tmp_path, "L52", device(f"{MAILBOX_AND_PROCESS_DATA}{pdos}<Dc>{mode}</Dc>"))
    assert [item["message"] for item in found] == ([f"OpMode 0 'DC' {words}"] if words else [])


@pytest.mark.parametrize(("limit", "count"), [('OSMax="10"', 1), ('OSMax="20"', 0), ("", 0)])
def test_l52_knows_how_often_a_pdo_may_be_sampled(tmp_path, limit, count):
    listed = '<Sm No="3"><Pdo OSFac="20">#x1A00</Pdo></Sm>'
    mode = f"<OpMode><Name>DC</Name><AssignActivate>0</AssignActivate>{listed}</OpMode>"
    content = MAILBOX_AND_PROCESS_DATA + pdo("TxPdo", "#x1A00", 8, attributes=limit)
    found = linted(tmp_path, "L52", device(f"{content}<Dc>{mode}</Dc>"))
    assert [item["message"] for item in found] == ["OpMode 0 'DC' samples PDO 0x1A00 20 times, its OSMax is 10"] * count


@pytest.mark.parametrize(
    ("rule_id", "role", "control", "count"),
    [
        ("L19", "DynamicOutputs", "#x20", 1),
        ("L19", "DynamicOutputs", "#x64", 0),
        ("L19", "DynamicInputs", "#x64", 1),
        ("L21", "DynamicOutputs", "#x24", 1),
        ("L21", "DynamicInputs", "#x20", 0),
        # It is outputs by bits 3:2 of its ControlByte, whatever its role is.
        ("L21", "Outputs", "#x20", 0),
        ("L21", "Inputs", "#x24", 1),
        ("L21", "MBoxOut", "#x26", 0),
    ],
)
def test_l19_and_l21_know_roles_and_directions(tmp_path, rule_id, role, control, count):
    sm = f'<Sm StartAddress="#x1000" ControlByte="{control}">{role}</Sm>'
    assert len(linted(tmp_path, rule_id, device(sm))) == count


@pytest.mark.parametrize(
    ("pdos", "advice"),
    [
        ("TxPdo", " and TxPdos, which run as its bits 3:2 say: the role must be Inputs"),
        ("RxPdo", ": its bits 3:2 must be 01 (the master writes)"),
        ("RxPdo TxPdo", ": its bits 3:2 must be 01 (the master writes)"),
        ("", ": its bits 3:2 must be 01 (the master writes)"),
    ],
)
def test_l19_knows_from_pdos_which_of_the_two_is_wrong(tmp_path, pdos, advice):
    content = '<Sm StartAddress="#x1000" ControlByte="#x20">Outputs</Sm>'
    content += "".join(pdo(tag, "#x1A00", 8, attributes='Sm="0"') for tag in pdos.split())
    (found,) = linted(tmp_path, "L19", device(content))
    assert found["message"] == "SM 0 Outputs has the ControlByte 0x20" + advice


ASSIGNED_0X1600 = dictionary(
    "<DataType><Name>DT1C12</Name><BitSize>32</BitSize>"
    "<SubItem><SubIdx>0</SubIdx><Name>N</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem>"
    "<SubItem><SubIdx>1</SubIdx><Name>P</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>16</BitOffs></SubItem>"
    "</DataType>",
    "<Object><Index>#x1C12</Index><Name>O</Name><Type>DT1C12</Type><BitSize>32</BitSize><Info>"
    "<SubItem><Name>N</Name><Info><DefaultData>01</DefaultData></Info></SubItem>"
    "<SubItem><Name>P</Name><Info><DefaultData>0016</DefaultData></Info></SubItem></Info></Object>",
)


@pytest.mark.parametrize(
    ("mode", "words"),
    [
        ('<Sm No="2"><Pdo>#x1601</Pdo></Sm>', "the OpMode 'DC' assigns 0x1601"),
        ('<Sm No="2"><Pdo>#x1600</Pdo><Pdo>#x1602</Pdo></Sm>', "the OpMode 'DC' assigns 0x1600, 0x1602"),
        ('<Sm No="3"><Pdo>#x1A00</Pdo></Sm>', None),
    ],
)
def test_l65_says_what_assigns(tmp_path, mode, words):
    """RxPdo 0x1600 has Sm=2, and 0x1C12:01 names it; the default OpMode may assign another one, be it not described."""
    pdos = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + pdo("RxPdo", "#x1601", 8) + pdo("TxPdo", "#x1A00", 8)
    modes = f"<Dc><OpMode><Name>DC</Name><AssignActivate>0</AssignActivate>{mode}</OpMode></Dc>"
    found = linted(tmp_path, "L65", device(ASSIGNED_0X1600 + MAILBOX_AND_PROCESS_DATA + pdos + modes))
    said = f"0x1C12 assigns 0x1600 by default, {words}: which of them counts depends on the master"
    assert [item["message"] for item in found] == ([said] if words else [])


@pytest.mark.parametrize(
    ("count", "words"), [("01", None), ("00", "0x1C12 assigns none by default, Sm=2 assigns 0x1600"), ("", None)]
)
def test_l65_believes_a_subindex_0_that_says_none(tmp_path, count, words):
    """ETG.1000.6: subindex 0 of 0x1C12 counts the assigned PDOs; what stands behind them is not assigned."""
    said = ASSIGNED_0X1600.replace("<DefaultData>01</DefaultData>", f"<DefaultData>{count}</DefaultData>" * bool(count))
    assigned = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')
    found = linted(tmp_path, "L65", device(said + MAILBOX_AND_PROCESS_DATA + assigned))
    assert [item["message"].partition(":")[0] for item in found] == ([words] if words else [])


@pytest.mark.parametrize("size", ["", 'DefaultSize="0"', 'DefaultSize="1"'])
def test_l22_goes_by_the_pdos_where_default_size_is_less(tmp_path, size):
    """Sixteen bytes, three times, from 0x1000 reach up to 0x102F."""
    sms = (
        f'<Sm {size} StartAddress="#x1000" ControlByte="#x64">Outputs</Sm>'
        '<Sm StartAddress="#x1008" ControlByte="#x20">Inputs</Sm>'
    )
    pdos = pdo("RxPdo", "#x1600", 32, 32, 32, 32, attributes='Sm="0"') + pdo("TxPdo", "#x1A00", 8, attributes='Sm="1"')
    (found,) = linted(tmp_path, "L22", device(sms + pdos))
    assert found["message"].startswith("SM 0 takes 0x1000 to 0x102F and SM 1 starts at 0x1008: they overlap by 3 bytes")


@pytest.mark.parametrize("rule", ["L24", "L25"])
def test_the_length_of_an_image_is_not_held_against_sizes_when_it_is_not_known(tmp_path, rule):
    """0x1602 is exchanged too, in as many bytes as it takes."""
    sms = '<Sm DefaultSize="6" MinSize="4">Outputs</Sm>'
    listed = '<Sm No="0"><Pdo>#x1600</Pdo><Pdo>#x1602</Pdo></Sm>'
    modes = f"<Dc><OpMode><Name>DC</Name><AssignActivate>0</AssignActivate>{listed}</OpMode></Dc>"
    assert linted(tmp_path, rule, device(sms + pdo("RxPdo", "#x1600", 8) + modes)) == []


def test_l25_says_1_byte(tmp_path):
    content = device('<Sm DefaultSize="1" MinSize="4">Outputs</Sm>' + pdo("RxPdo", "#x1600", 8, attributes='Sm="0"'))
    (found,) = linted(tmp_path, "L25", content)
    assert "the assigned PDOs take 1 byte, MinSize is 4" in found["message"]


@pytest.mark.parametrize(("first", "second", "words"), [("0016", "0116", None), ("0116", "0016", "0x1601, 0x1600")])
def test_l65_knows_the_order(tmp_path, first, second, words):
    """In document order 0x1600 lies first; 0x1C12:01 and :02 may have it otherwise, and then no place is the same."""
    sub_item = (
        "<SubItem><SubIdx>{0}</SubIdx><Name>P{0}</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>{0}6</BitOffs>"
    )
    value = "<SubItem><Name>P</Name><Info><DefaultData>{}</DefaultData></Info></SubItem>"
    assigned = dictionary(
        "<DataType><Name>DT1C12</Name><BitSize>48</BitSize>"
        "<SubItem><SubIdx>0</SubIdx><Name>N</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem>"
        f"{sub_item.format(1)}</SubItem>{sub_item.format(2)}</SubItem></DataType>",
        "<Object><Index>#x1C12</Index><Name>O</Name><Type>DT1C12</Type><BitSize>48</BitSize><Info>"
        f"{value.format('02')}{value.format(first)}{value.format(second)}</Info></Object>",
    )
    pdos = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + pdo("RxPdo", "#x1601", 16, attributes='Sm="2"')
    found = linted(tmp_path, "L65", device(assigned + MAILBOX_AND_PROCESS_DATA + pdos))
    said = (
        f"0x1C12 assigns {words} by default, Sm=2 assigns 0x1600, 0x1601 in that order: which of them counts depends "
        "on the master"
    )
    assert [item["message"] for item in found] == ([said] if words else [])


@pytest.mark.parametrize(
    ("sm", "listed", "count"),
    [
        (2, "", 1),
        (6, "", 0),
        (2, '<Sm No="5"><Pdo>#x1601</Pdo></Sm>', 0),
    ],
    ids=["both exchanged", "one on a virtual SyncManager", "one moved by the OpMode"],
)
def test_l31_knows_what_is_exchanged(tmp_path, sm, listed, count):
    pdos = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"', extra="<Exclude>#x1601</Exclude>") + pdo(
        "RxPdo", "#x1601", 8, attributes=f'Sm="{sm}"', extra="<Exclude>#x1600</Exclude>"
    )
    mode = f"<Dc><OpMode><Name>DC</Name><AssignActivate>0</AssignActivate>{listed}</OpMode></Dc>"
    virtual = '<Sm Virtual="1">Outputs</Sm>'
    assert len(linted(tmp_path, "L31", device(MAILBOX_AND_PROCESS_DATA + virtual + pdos + mode))) == count


def excluding(index: str, excluded: str, sm: str = 'Sm="2"', attributes: str = 'DependOnSlot="1"') -> str:
    """A RxPdo of a module that excludes another one."""
    text = pdo("RxPdo", index, 8, attributes=sm, extra=f"<Exclude {attributes}>{excluded}</Exclude>")
    return text.replace("<Index>", '<Index DependOnSlot="1">', 1)


@pytest.mark.parametrize(
    ("pdos", "words"),
    [
        (excluding("#x1600", "#x1600"), "excludes itself"),
        (excluding("#x1600", "#x1601") + excluding("#x1601", "#x1600"), "exclude each other"),
        (excluding("#x1600", "#x1601") + excluding("#x1601", "#x1600", sm=""), None),
        (excluding("#x1600", "#x1600", attributes=""), None),  # in slot 1 it is another PDO
    ],
)
def test_l31_looks_into_modules(tmp_path, pdos, words):
    found = linted(tmp_path, "L31", device(MAILBOX_AND_PROCESS_DATA + slots(1)), module(pdos))
    assert [item["path"].partition("/RxPdo")[0] for item in found] == ["EtherCATInfo/Descriptions/Modules/Module"] * (
        words is not None
    )
    assert all(words in item["message"] for item in found)


def test_l31_leaves_out_what_the_op_mode_of_the_device_assigns(tmp_path):
    pdos = excluding("#x1600", "#x1601") + excluding("#x1601", "#x1600")
    mode = "<Dc><OpMode><Name>A</Name><AssignActivate>0</AssignActivate>{}</OpMode></Dc>".format(
        '<Sm No="2"><Pdo>#x1600</Pdo></Sm>'
    )
    assert linted(tmp_path, "L31", device(MAILBOX_AND_PROCESS_DATA + mode + slots(1)), module(pdos)) == []


@pytest.mark.parametrize(
    ("other", "preset", "count"),
    [("#x1601", 1, 1), ("#x1601", 0, 0), ("#x1602", 1, 0)],
    ids=["both preset", "one preset", "no such PDO"],
)
def test_l31_looks_at_the_default_modules_of_several_slots(tmp_path, other, preset, count):
    """The image leaves out the second one, in slot 1."""
    slot = '<Slot MinInstances="{0}" MaxInstances="1"><Name>s</Name><ModuleIdent Default="{0}">{1}</ModuleIdent></Slot>'
    carried = f"<Slots>{slot.format(preset, '#x10')}{slot.format(1, '#x20')}</Slots>"
    modules = module(pdo("RxPdo", "#x1601", 8, attributes='Sm="2"')) + module(
        pdo("RxPdo", "#x1600", 8, attributes='Sm="2"', extra=f"<Exclude>{other}</Exclude>"), "#x20"
    )
    found = linted(tmp_path, "L31", device(MAILBOX_AND_PROCESS_DATA + carried), modules)
    said = "RxPdo 0x1600 of module 0x20 in slot 1 and 0x1601 exclude each other, but the default modules bring both"
    assert [item["message"].partition(":")[0] for item in found] == [said] * count


@pytest.mark.parametrize(
    ("of_object", "of_entry", "count"),
    [
        ("", "", 0),
        ('DependOnSlot="1"', 'DependOnSlot="1"', 0),
        ('DependOnSlot="1"', "", 2),
        ("", 'DependOnSlot="1"', 2),
    ],
)
def test_l55_knows_what_moves_with_its_object(tmp_path, of_object, of_entry, count):
    entry = f"<Entry><Index {of_entry}>#x7000</Index><SubIndex>0</SubIndex><BitLen>16</BitLen></Entry>"
    mapping = f"<RxPdo Sm='2'><Index>#x1600</Index><Name>p</Name>{entry}</RxPdo>"
    command = f"<Mailbox><CoE><InitCmd><Transition>PS</Transition><Index {of_entry}>#x7000</Index><Data>0100</Data>"
    described = dictionary("", declared("#x7000", "UINT", 16, of_object))
    carried = module(mapping + command + "</InitCmd></CoE></Mailbox>" + described)
    found = linted(tmp_path, "L55", device(MAILBOX_AND_PROCESS_DATA + slots(1)), carried)
    words = "0x7000:00, which does not move with the slot as the object does: give it the DependOnSlot of the object"
    said = [f"RxPdo 0x1600 maps {words}", f"InitCmd for {words}"]
    assert sorted(item["message"] for item in found) == sorted(said[:count])


PRESET = (
    '<Slots SlotPdoIncrement="{}" SlotIndexIncrement="{}"><Slot MinInstances="{}" MaxInstances="{}"><Name>s</Name>'
    '<ModuleIdent Default="1">#x10</ModuleIdent></Slot></Slots>'
)
MOVING = module(
    pdo("RxPdo", "#x1600", 8).replace("<Index>", '<Index DependOnSlot="1">')
    + dictionary("", declared("#x7000", "UINT", 16, 'DependOnSlot="1"'))
)


@pytest.mark.parametrize(
    ("own", "placed", "message"),
    [
        ("", (1, 0, 2, 2), "object 0x7000 of the default module in slot 1 meets that of slot 0"),
        ("", (0, 0, 2, 2), "RxPdo 0x1600, object 0x7000 of the default module in slot 1 meet those of slot 0"),
        ("", (1, 16, 2, 2), None),
        (
            pdo("RxPdo", "#x1600", 8),
            (1, 16, 1, 1),
            "RxPdo 0x1600 of the default module in slot 0 meets that of the device",
        ),
        (pdo("RxPdo", "#x1600", 8, attributes='OverwrittenByModule="1"'), (1, 16, 1, 1), None),
        (pdo("RxPdo", "#x1601", 8), (1, 16, 1, 1), None),
    ],
)
def test_l55_looks_at_objects_and_at_the_device(tmp_path, own, placed, message):
    found = linted(tmp_path, "L55", device(own + PRESET.format(*placed)), MOVING)
    assert [item["message"].partition(": ")[0] for item in found] == ([message] if message else [])


def op_mode(*times: str, activate: str = "#x300") -> str:
    return f"<Dc><OpMode><Name>DC</Name><AssignActivate>{activate}</AssignActivate>{''.join(times)}</OpMode></Dc>"


def time_only(dc: str) -> str:
    return dc.replace("<Dc>", '<Dc TimeLoopControlOnly="1">')


CYCLE_0, NO_CYCLE_0 = '<CycleTimeSync0 Factor="1">0</CycleTimeSync0>', "<CycleTimeSync0>0</CycleTimeSync0>"


@pytest.mark.parametrize(
    ("rule_id", "content", "words"),
    [
        (
            "L26",
            '<Sm DefaultSize="0">MBoxOut</Sm>',
            "SM 0 MBoxOut has DefaultSize 0: the mailbox has no length; give it",
        ),
        ("L26", '<Sm DefaultSize="0">Outputs</Sm>', None),
        # A time of 0 counts with its Factor only.
        ("L51", op_mode(NO_CYCLE_0), "OpMode 0 'DC' makes SYNC pulses with CycleTimeSync0 0 and no Factor"),
        ("L51", op_mode(NO_CYCLE_0.replace(">", ' Factor="0">', 1)), "OpMode 0 'DC' makes SYNC pulses with"),
        ("L51", op_mode(), "OpMode 0 'DC' makes SYNC pulses without CycleTimeSync0"),
        ("L51", op_mode(CYCLE_0), None),
        (
            "L51",
            op_mode("<CycleTimeSync0>-1000</CycleTimeSync0>", activate="#x301"),
            "OpMode 0 'DC' has CycleTimeSync0 -1000: no cycle takes less than nothing",
        ),
        (
            "L50",
            op_mode(CYCLE_0, "<CycleTimeSync1>-1</CycleTimeSync1>", activate="#x700"),
            "OpMode 0 'DC' has CycleTimeSync1 -1: no cycle takes less than nothing",
        ),
        # The sync unit is off, or the word is none that the registers can hold: nothing is programmed.
        ("L51", op_mode("<CycleTimeSync0>-1000</CycleTimeSync0>", activate="0"), None),
        ("L50", op_mode("<CycleTimeSync1>5</CycleTimeSync1>", activate="#x10300"), None),
        ("L49", op_mode(activate="#x10200"), None),
        # Bit 0x0001: the device makes its SYNC signals itself.
        ("L51", op_mode(NO_CYCLE_0, activate="#x301"), None),
        (
            "L50",
            op_mode(CYCLE_0, "<CycleTimeSync1>0</CycleTimeSync1>", activate="#x700"),
            "OpMode 0 'DC' makes SYNC1 (AssignActivate 0x0700) with CycleTimeSync1 0 and no Factor: its time",
        ),
        ("L50", op_mode(CYCLE_0, "<ShiftTimeSync1>0</ShiftTimeSync1>", activate="#x700"), None),
        ("L50", op_mode(CYCLE_0, '<CycleTimeSync1 Factor="1">0</CycleTimeSync1>', activate="#x700"), None),
        # A device that has nothing but the time of the clocks makes no pulse, whatever its registers are given.
        ("L50", time_only(op_mode(CYCLE_0, activate="#x700")), None),
        ("L50", time_only(op_mode(CYCLE_0, "<CycleTimeSync1>5</CycleTimeSync1>", activate="#x700")), None),
        ("L51", time_only(op_mode()), None),
    ],
)
def test_zero_is_no_length_and_no_time(tmp_path, rule_id, content, words):
    found = linted(tmp_path, rule_id, device(content))
    assert len(found) == (words is not None)
    assert all(item["message"].startswith(words) for item in found)


def test_slots_and_op_modes_are_counted_as_options_take_them(tmp_path):
    """From 0, slots over all instances: --module 2=IDENT plugs into the one that L53 tells of, --op-mode 1 is L51's."""
    idents = "<ModuleIdent>1</ModuleIdent><ModuleIdent>2</ModuleIdent>"
    slots = "".join(
        f'<Slot MinInstances="{least}" MaxInstances="{most}"><Name>s</Name>{idents}</Slot>'
        for least, most in ((0, 2), (1, 1))
    )
    modules = "".join(f'<Module><Type ModuleIdent="{n}">M{n}</Type><Name>M</Name></Module>' for n in (1, 2))
    modes = "".join(
        f"<OpMode><Name>{name}</Name><AssignActivate>{word}</AssignActivate></OpMode>"
        for name, word in (("Free", 0), ("DC", "#x300"))
    )
    content = device(f"{MAILBOX_AND_PROCESS_DATA}<Dc>{modes}</Dc><Slots>{slots}</Slots>")
    (slot,) = linted(tmp_path, "L53", content, modules)
    assert slot["message"].startswith("slot 2 needs a module (MinInstances 1) and presets none")
    (mode,) = linted(tmp_path, "L51", content, modules)
    assert mode["message"].startswith("OpMode 1 'DC' makes SYNC pulses without CycleTimeSync0")


@pytest.mark.parametrize(
    ("slot", "ident", "count"),
    [
        ("", "", 1),
        ("", 'Default="1"', 0),
        ("", 'Default="yes"', 0),
        ('Default="#xZ"', "", 0),
        ('Fallback="#xZ"', "", 0),
        ('MaxInstances="#xZ"', "", 1),
    ],
)
def test_a_preset_that_cannot_be_read_is_not_missing(tmp_path, slot, ident, count):
    idents = f"<ModuleIdent {ident}>1</ModuleIdent><ModuleIdent>2</ModuleIdent>"
    modules = "".join(f'<Module><Type ModuleIdent="{n}">M{n}</Type><Name>M</Name></Module>' for n in (1, 2))
    content = f'{MAILBOX_AND_PROCESS_DATA}<Slots><Slot MinInstances="1" {slot}><Name>s</Name>{idents}</Slot></Slots>'
    assert len(linted(tmp_path, "L53", device(content), modules)) == count


@pytest.mark.parametrize(
    ("attributes", "modes", "words"),
    [
        ("", ["#x1600", "#x1601"], "the OpMode 'M0' assigns both: take one of them out of its list"),
        ("", [], None),
        ("", ["#x1600"], None),
        ('Sm="0" Mandatory="1"', ["#x1602"], "both are assigned by default: one of them must lose its Sm"),
        ('Sm="0"', ["#x1602"], None),
    ],
)
@pytest.mark.parametrize("before", [[], ["#x1602"]])
def test_l31_knows_the_lists_of_op_modes(tmp_path, attributes, modes, words, before):
    """0x1600 and 0x1601 exclude each other. Mandatory PDOs stay beside a list, those with an Sm alone do not."""
    excluding = "<Exclude>#x1601</Exclude>"
    pdos = pdo("RxPdo", "#x1600", 8, attributes=attributes, extra=excluding)
    pdos += pdo("RxPdo", "#x1601", 8, attributes=attributes) + pdo("RxPdo", "#x1602", 8)
    lists = [found for found in (modes, before) if found]
    op_modes = "".join(
        f"<OpMode><Name>M{number}</Name><AssignActivate>0</AssignActivate>"
        f'<Sm No="0">{"".join(f"<Pdo>{index}</Pdo>" for index in indices)}</Sm></OpMode>'
        for number, indices in enumerate(lists)
    )
    found = linted(tmp_path, "L31", device(f"<Sm>Outputs</Sm>{pdos}<Dc>{op_modes}</Dc>"))
    said = f"RxPdo 0x1601 and 0x1600 exclude each other, but {words}"
    assert [item["message"] for item in found] == ([said] if words else [])


ONE_LISTED = "the OpMode 'M0' lists {} and {} stays, being mandatory: correct the list or Mandatory"


@pytest.mark.parametrize(
    ("mandatory", "lists", "words"),
    [
        ((True, True), ("#x1600",), None),
        ((True, True), ("#x1601",), None),
        ((True, True), ("#x1600", "#x1602"), "both are mandatory and the OpMode 'M1' lists neither: list one of them"),
        ((False, True), ("#x1600",), ONE_LISTED.format("0x1600", "0x1601")),
        ((True, False), ("#x1601",), ONE_LISTED.format("0x1601", "0x1600")),
        ((True, False), ("#x1600",), None),
        ((True, True), ("#x1601#x1600",), "the OpMode 'M0' assigns both: take one of them out of its list"),
    ],
)
def test_l31_says_which_pdo_is_listed_and_which_stays_because_it_is_mandatory(tmp_path, mandatory, lists, words):
    """0x1600 and 0x1601 exclude each other: a list chooses between two mandatory ones, not against a single one."""
    pdos = pdo("RxPdo", "#x1602", 8) + "".join(
        pdo("RxPdo", index, 8, attributes=f'Sm="0" Mandatory="{int(stays)}"', extra=f"<Exclude>{other}</Exclude>")
        for index, other, stays in zip(("#x1600", "#x1601"), ("#x1601", "#x1600"), mandatory, strict=True)
    )
    op_modes = "".join(
        f"<OpMode><Name>M{number}</Name><AssignActivate>0</AssignActivate>"
        f'<Sm No="0">{"".join(f"<Pdo>#{index}</Pdo>" for index in indices.split("#")[1:])}</Sm></OpMode>'
        for number, indices in enumerate(lists)
    )
    found = linted(tmp_path, "L31", device(f"<Sm>Outputs</Sm>{pdos}<Dc>{op_modes}</Dc>"))
    said = f"RxPdo 0x1601 and 0x1600 exclude each other, but {words}"
    assert [item["message"] for item in found] == ([said] if words else [])


@pytest.mark.parametrize(
    ("mandatory", "sm", "others", "message"),
    [
        ('Mandatory="1"', 'Sm="2"', ("", ""), "excludes 0x1601, 0x1602: these can never be assigned; drop Mandatory"),
        ('Mandatory="1"', 'Sm="2"', ("", 'Virtual="1"'), "excludes 0x1601: these can never"),
        ('Mandatory="1"', 'Sm="2"', ("", 'Sm="2"'), "excludes 0x1601: these can never"),  # of 0x1602 L31 tells
        ("", 'Sm="2"', ("", ""), None),
    ],
)
def test_l66_finds_what_a_mandatory_pdo_shuts_out(tmp_path, mandatory, sm, others, message):
    """It stays assigned whatever is chosen; 0x1602 is excluded from its own side."""
    exclude = "<Exclude>#x{}</Exclude>"
    pdos = (
        pdo("RxPdo", "#x1600", 8, attributes=f"{mandatory} {sm}", extra=exclude.format(1601))
        + pdo("RxPdo", "#x1601", 8, attributes=others[0])
        + pdo("RxPdo", "#x1602", 8, attributes=others[1], extra=exclude.format(1600))
        + pdo("TxPdo", "#x1A00", 8)
    )
    found = linted(tmp_path, "L66", device(MAILBOX_AND_PROCESS_DATA + pdos))
    expected = [f"RxPdo 0x1600 is Mandatory and {message}"] if message else []
    assert [item["message"][: len(expected[0])] for item in found] == expected
