"""CiA 402 drive modes: the rules of evidence on small drives, and the verdicts on real ones."""

import re
from pathlib import Path

import pytest
import snippets
from small_drives import DC, dictionary, init_cmd, one_drive, rx_pdo, supported_modes, verdict_of, verdicts
from test_drive_recipes import chosen_in, mapped_with

from esicatalog.esi.containers import Archive
from esicatalog.esi.reader import Reader, read_esi
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.export.subject import Subject
from esicatalog.model.cia402 import denies, named_modes
from esicatalog.model.drive_evidence import RANKS
from esicatalog.model.drive_modes import DriveModes, DriveModeVerdict, drive_modes
from esicatalog.model.slots import reachable_modules

DATA = Path(__file__).parent.parent / "data"


def test_every_bit_of_0x6502_declares_its_mode():
    # 0x3AD: bits 0, 2, 3, 5, 7, 8, 9
    found = verdicts(one_drive(dictionary(supported_modes("AD030000"))))
    assert {mode for mode, word in found.items() if word == "yes"} == {"PP", "PV", "TQ", "HM", "CSP", "CSV", "CST"}
    assert {mode for mode, word in found.items() if word == "no"} == {"VL", "IP", "CSTCA"}


def test_the_documented_weights_are_those_that_count():
    """``| D3 | … | 0.40, split 0.20 | … |`` is D3 and D3 split."""
    text = (DATA.parent / "docs" / "drive-modes.md").read_text("utf-8")
    rows = [line.split("|")[1:-1] for line in text.splitlines() if re.match(r"\| [A-F]\S* ", line)]
    assert all(example.strip() for _, _, _, example in rows)
    weights = {
        " ".join((rank.strip(), *re.findall("[a-z]+", one))): float(re.search(r"[\d.]+", one)[0])
        for rank, _, weight, _ in rows
        for one in weight.split(",")
    }
    assert weights == {rank: score for rank, (_, score) in RANKS.items()}


def test_a_declaration_says_to_read_the_drive():
    declared = one_drive(dictionary(supported_modes("80010000"))).evidence
    assert all(item.evidence.endswith("read 0x6502 on the drive") for item in declared)


def test_a_declaration_names_the_object_of_its_axis():
    words = word_objects("6840", "6841")
    found = one_drive(dictionary(supported_modes("80000000"), words, supported_modes("00010000", index="6D02")))
    assert verdicts(found, axis=1)["CSV"] == "yes"
    declared = [item.evidence for item in found.evidence if item.axis == 1]
    assert declared and all(text.endswith("read 0x6D02 on the drive") for text in declared)


MODES_OF_OPERATION = "<Object><Index>#x6060</Index><Name>m</Name><Type>SINT</Type><BitSize>8</BitSize></Object>"


def enumerated(**texts: str) -> DriveModes:
    """A drive whose 0x6060 enumerates values (v8="CSP")."""
    values = "".join(f"<EnumInfo><Text>{text}</Text><Enum>{key[1:]}</Enum></EnumInfo>" for key, text in texts.items())
    types = f"<DataType><Name>EM</Name><BaseType>SINT</BaseType><BitSize>8</BitSize>{values}</DataType>"
    return one_drive(dictionary(MODES_OF_OPERATION.replace("SINT", "EM"), types=types))


def test_a_value_counts_by_its_code_unless_its_text_says_otherwise():
    found = enumerated(v1="Position", v3="", v6="Preserved home", v8="CSP", v9="reserved", v10="Cyclic sync velocity")
    assert verdicts(found) == {**dict.fromkeys(("PP", "PV", "HM", "CSP"), "likely"), "CSV": "no"}


def test_a_value_that_is_denied_speaks_against_its_mode():
    """The setpoint and SYNC0 alone would make CSV likely; against 0x6502 it is a conflict."""
    values = "<EnumInfo><Text>{}</Text><Enum>9</Enum></EnumInfo>"
    types = f"<DataType><Name>EM</Name><BaseType>SINT</BaseType><BitSize>8</BitSize>{values}</DataType>"
    enumerating, mapped = MODES_OF_OPERATION.replace("SINT", "EM"), rx_pdo(("6040", 16), ("60FF", 32)) + DC

    def csv(text: str, *objects: str) -> DriveModeVerdict:
        described = dictionary(enumerating, *objects, types=types.format(text))
        return verdict_of(one_drive(described + mapped), "CSV")

    denied = csv("CSV (not supported)")
    assert (denied.verdict, denied.recipe) == ("no", None)
    assert denied.evidence == "values of 0x6060 list 9 (CSV (not supported))"
    assert csv("CSV").verdict == "likely"
    contradicted = csv("not supported", supported_modes("00010000"))
    assert (contradicted.verdict, contradicted.conflict) == ("likely", True)


@pytest.mark.parametrize("text", ["CSP (csv not supported)", "CSV, no csp", "CSP not supported"])
def test_a_value_whose_text_names_another_mode_says_nothing_of_its_own(text):
    """Which of the two it denies is for people to read."""
    assert verdicts(enumerated(v9=text)) == {}


def test_a_list_of_values_is_that_of_the_base_type_too():
    types = "".join(
        f"<DataType><Name>{name}</Name><BaseType>{base}</BaseType><BitSize>8</BitSize>{values}</DataType>"
        for name, base, values in (
            ("Mode", "Modes", ""),
            ("Modes", "SINT", "<EnumInfo><Text>CSP</Text><Enum>8</Enum></EnumInfo>"),
        )
    )
    found = one_drive(dictionary(MODES_OF_OPERATION.replace("SINT", "Mode"), types=types))
    assert verdicts(found) == {"CSP": "likely"}


@pytest.mark.parametrize(
    "text",
    [
        "reserved",
        "Reserved (9)",
        "not supported",
        "CSV - not yet supported",
        "Unsupported",
        "unused",
        "not_used",
        "n/a",
        "N.A.",
        "not available",
        "not implemented",
        "does not support CSV",
        "no csv",
        "CSV: not possible",
    ],
)
def test_texts_that_deny_a_value(text):
    assert denies(text)
    assert verdicts(enumerated(v9=text)) == {"CSV": "no"}


@pytest.mark.parametrize(
    "text",
    [
        "Cyclic synchronous velocity (not available in SM-synchronous mode)",
        "csv, touch probe not possible",
        "CSV (jerk limit not supported)",
        "csv, reserved bits 4-6",
    ],
)
def test_a_text_that_denies_something_else_says_nothing_of_the_mode(text):
    assert denies(text)
    assert verdicts(enumerated(v9=text)) == {}


@pytest.mark.parametrize(
    "text", ["", "Cyclic synchronous velocity", "Preserved", "unusedly", "Nano axis", "notused", "Axis no. 1 (csv,csp)"]
)
def test_texts_that_deny_nothing(text):
    assert not denies(text)


def with_property(name: str, value: str) -> DriveModes:
    """A drive whose 0x6060 has a property."""
    properties = f"<Properties><Property><Name>{name}</Name><Value>{value}</Value></Property></Properties></Object>"
    return one_drive(dictionary(MODES_OF_OPERATION.replace("</Object>", properties)))


def test_options_of_0x6060_list_modes():
    found = with_property("options", '{"8": "CSP", "9": "CSV", "10": "not supported", "-2": "Jog"}')
    assert verdicts(found) == {"CSP": "likely", "CSV": "likely", "CST": "no"}
    assert {item.rank for item in found.evidence} == {"B2", "B2-"}


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("options", "8, 9"),
        ("options", "[8, 9]"),
        ("options", ""),
        ("options", '{"CSP": "8"}'),
        ("unit", '{"8": "CSP"}'),
    ],
)
def test_what_is_no_list_of_options_lists_nothing(name, value):
    assert verdicts(with_property(name, value)) == {}


def bounded(*bounds: str, kind: str = "SINT") -> DriveModes:
    """A drive whose 0x6060 has a minimum and maximum."""
    info = "".join(f"<{name}>{bound}</{name}>" for name, bound in zip(("MinValue", "MaxValue"), bounds, strict=True))
    info = f"<Info>{info}</Info>".replace("<MinValue></MinValue>", "")
    return one_drive(dictionary(MODES_OF_OPERATION.replace("SINT", kind).replace("</Object>", f"{info}</Object>")))


@pytest.mark.parametrize(
    ("bounds", "kind", "modes"),
    [
        (("1", "4"), "SINT", {"PP", "VL", "PV", "TQ"}),
        (("8", "10"), "SINT", {"CSP", "CSV", "CST"}),
        (("-128", "3"), "SINT", {"PP", "VL", "PV"}),
        (("#x80", "3"), "USINT", {"PP", "VL", "PV"}),  # the bits of -128
        (("", "3"), "SINT", {"PP", "VL", "PV"}),
        (("-128", "127"), "SINT", set()),  # the whole range of the type
        (("0", "127"), "SINT", set()),
        (("0", "255"), "USINT", set()),  # -1
        (("0", "0"), "SINT", set()),
    ],
)
def test_a_bounded_0x6060_makes_the_codes_within_possible(bounds, kind, modes):
    found = bounded(*bounds, kind=kind)
    assert verdicts(found) == dict.fromkeys(modes, "possible")
    assert {(item.rank, item.score) for item in found.evidence if item.mode} <= {("E", 0.25)}


def test_a_list_of_values_says_more_than_their_bounds():
    listing = "<Info><MinValue>1</MinValue><MaxValue>10</MaxValue></Info><Properties><Property><Name>options</Name>"
    listing += '<Value>{"8": "CSP"}</Value></Property></Properties></Object>'
    found = one_drive(dictionary(MODES_OF_OPERATION.replace("</Object>", listing)))
    assert verdicts(found) == {"CSP": "likely"}


@pytest.mark.parametrize("data", ["", "00000000"])
def test_absent_and_zero_0x6502_say_nothing(data):
    assert verdicts(one_drive(dictionary(supported_modes(data)))) == {}


@pytest.mark.parametrize("index", ["6502", "6060"])
def test_the_number_of_entries_is_no_value(index):
    """Subindex 0 of a record: 1, with the bit of PP; a maximum of 1, PP again."""
    sub_items = "".join(
        f"<SubItem><SubIdx>{at}</SubIdx><Name>s</Name><Type>{kind}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{offset}</BitOffs></SubItem>"
        for at, kind, bits, offset in ((0, "USINT", 8, 0), (1, "UDINT", 32, 16))
    )
    types = f"<DataType><Name>DT</Name><BitSize>48</BitSize>{sub_items}</DataType>"
    values = "".join(
        f"<SubItem><Name>s</Name><Info><MinValue>0</MinValue><MaxValue>1</MaxValue><DefaultData>{data}</DefaultData>"
        "</Info></SubItem>"
        for data in ("01", "80000000")
    )
    record = f"<Object><Index>#x{index}</Index><Name>m</Name><Type>DT</Type><BitSize>48</BitSize>"
    found = one_drive(dictionary(f"{record}<Info>{values}</Info></Object>", types=types))
    assert [item.rank for item in found.evidence] == ["F"]


def test_swapped_bytes_are_likely_and_named():
    found = one_drive(dictionary(supported_modes("000003A0")))
    assert verdicts(found) == {"HM": "likely", "CSP": "likely", "CSV": "likely", "CST": "likely"}
    assert all(item.conflict and item.rank == "A+ swapped" for item in found.evidence)


@pytest.mark.parametrize("element", ["DefaultValue", "DefaultString"])
@pytest.mark.parametrize("kind", ["UDINT", "DINT"])
@pytest.mark.parametrize(
    ("number", "modes"),
    [
        ("#x80030000", ["CSP", "CSV", "CST"]),  # 0x00000380
        ("#x00030000", ["CSV", "CST"]),  # 0x00000300
        ("#x00FF0000", []),  # 0x0000FF00 goes beyond bit 10: nonsense either way
    ],
)
def test_swapped_bytes_of_a_number_are_likely_and_named(element, kind, number, modes):
    said = supported_modes(number).replace("DefaultData", element).replace("UDINT", kind)
    found = one_drive(dictionary(said))
    assert verdicts(found) == dict.fromkeys(modes, "likely")
    assert {item.rank for item in found.evidence if item.mode} <= {"A+ swapped"}


def test_a_short_default_claims_nothing_absent():
    found = one_drive(dictionary(supported_modes("0001")))
    assert verdicts(found) == {"CSV": "likely"}


def test_bits_of_a_signed_0x6502_count_up_to_its_sign():
    # 0xC00101A0: bits 5, 7, 8 of the profile and 16, 30, 31 of the manufacturer; as a DINT a negative number.
    signed = supported_modes("A00101C0").replace("UDINT", "DINT")
    found = verdicts(one_drive(dictionary(signed)))
    assert {mode for mode, word in found.items() if word == "yes"} == {"HM", "CSP", "CSV"}
    assert {mode for mode, word in found.items() if word == "no"} == {"PP", "VL", "PV", "TQ", "IP", "CST", "CSTCA"}


def test_a_sign_is_no_bit_beyond_the_type():
    # 0xA1 in a byte: bits 0, 5 and 7, the sign. Bits 8 to 10 are not there.
    narrow = supported_modes("A1").replace("UDINT", "SINT").replace("<BitSize>32", "<BitSize>8")
    found = verdicts(one_drive(dictionary(narrow)))
    assert {mode for mode, word in found.items() if word == "yes"} == {"PP", "HM", "CSP"}


def test_a_negative_number_of_an_unsigned_0x6502_says_nothing():
    negative = (
        supported_modes("0").replace("DefaultData>0<", "DefaultValue>-1<").replace("/DefaultData", "/DefaultValue")
    )
    assert verdicts(one_drive(dictionary(negative))) == {}


def word_objects(*indices: str, kind: str = "UINT") -> str:
    """Objects of 16 bits."""
    return "".join(
        f"<Object><Index>#x{index}</Index><Name>w</Name><Type>{kind}</Type><BitSize>16</BitSize></Object>"
        for index in indices
    )


ACCELERATION = '<TxPdo Sm="3"><Index>#x1A00</Index><Name>I</Name><Entry><Index>#x6040</Index><SubIndex>0</SubIndex>'
ACCELERATION += "<BitLen>16</BitLen></Entry></TxPdo>"


@pytest.mark.parametrize(
    ("objects", "pdos"),
    [
        ("", ""),
        (word_objects("6030", "6040", kind="INT"), ACCELERATION),
        (word_objects("6030", "6040"), ""),
    ],
)
def test_encoder_claims_no_mode(objects, pdos):
    """CiA 406 has the acceleration value at 0x6040 and the number of distinguishable revolutions at 0x6502."""
    found = one_drive(dictionary(supported_modes("00010000"), objects) + pdos, profile="406")
    assert (found.verdicts, found.evidence) == ((), ())


@pytest.mark.parametrize("profile", ["406", "0"])
def test_both_words_in_a_dictionary_are_an_axis(profile):
    found = one_drive(dictionary(supported_modes("00010000"), word_objects("6040", "6041")), profile=profile)
    assert verdicts(found)["CSV"] == "yes"


@pytest.mark.parametrize(("number", "modes"), [("406", {"CSV"}), ("0", {"CSV", "IP"})])
@pytest.mark.parametrize("moves", ["", ' DependOnSlot="1"'])
def test_an_encoder_module_of_a_drive_says_nothing_of_modes(number, modes, moves):
    """0x6502 of CiA 406, 64 revolutions, is not the bit of IP; in a module of another profile it is."""
    revolutions = dictionary(supported_modes("40000000").replace("<Index>", f"<Index{moves}>"))
    module = f'<Module><Type ModuleIdent="2">M</Type><Name>E</Name><Profile><ProfileNo>{number}</ProfileNo>'
    own = "<Profile><ProfileNo>402</ProfileNo>" + dictionary(supported_modes("00010000")) + rx_pdo(("60FF", 32))
    found = modular_drive(slot(2, is_default=True), f"{module}{revolutions}</Module>", profile=own)
    assert {mode for mode, word in verdicts(found).items() if word != "no"} == modes
    assert {item.module_ident for item in found.evidence} == ({None} if number == "406" else {None, 2})


def test_input_channel_0x6040_is_no_controlword():
    channels = '<TxPdo Sm="3"><Index>#x1A00</Index><Name>I</Name><Entry><Index>#x6040</Index><SubIndex>1</SubIndex>'
    channels += "<BitLen>1</BitLen></Entry></TxPdo>"
    assert one_drive(f"</Profile>{channels}", profile="5001").verdicts == ()


def test_setpoint_with_sync0_is_likely_cyclic():
    body = "</Profile>" + rx_pdo(("6040", 16), ("60FF", 32)) + DC
    assert verdicts(one_drive(body)) == {"CSV": "likely"}


SUPERSEDED = DC.replace("</OpMode>", '<VendorSpecific><TwinCAT IgnoreFromBuildNo="1"/></VendorSpecific></OpMode>')
TIME_ONLY = DC.replace("<Dc>", '<Dc TimeLoopControlOnly="1">')


@pytest.mark.parametrize("dc", [SUPERSEDED, TIME_ONLY], ids=["superseded", "time only"])
def test_no_mode_is_inferred_from_an_op_mode_without_sync0(dc):
    """One that newer tools ignore, and one of a device that uses the DC time alone."""
    own = one_drive("</Profile>" + rx_pdo(("6040", 16), ("60FF", 32)) + dc)
    module = drive_module(2, "6040", "60FF", name="Outputs", moves=False)
    of_module = modular_drive(slot(2, is_default=True), module, dc=dc)
    by_name = modular_drive(slot(2, is_default=True), asking_for_dc(module), dc=dc)
    for found in (own, of_module, by_name):
        assert verdicts(found) == {"PV": "possible", "CSV": "possible"}


def test_a_module_may_ask_for_the_op_mode_with_sync0():
    module = asking_for_dc(drive_module(2, "6040", "60FF", name="Outputs", moves=False))
    assert verdicts(modular_drive(slot(2, is_default=True), module, dc=DC)) == {"CSV": "likely"}


def asking_for_dc(module: str) -> str:
    """The module with the OpMode that it asks for."""
    return module.replace("</Module>", "<DcOpModeName>DC</DcOpModeName></Module>")


def test_setpoint_without_dc_is_possible_for_both():
    body = "</Profile>" + rx_pdo(("6040", 16), ("607A", 32))
    assert verdicts(one_drive(body)) == {"PP": "possible", "CSP": "possible"}


def test_profile_companions_point_to_the_profile_mode():
    body = "</Profile>" + rx_pdo(("6040", 16), ("607A", 32), ("6081", 32)) + DC
    assert verdicts(one_drive(body)) == {"PP": "likely", "CSP": "possible"}


def test_declared_absent_beats_inference():
    # 0x80 = CSP only; the PDO maps 0x60FF with DC
    profile = dictionary(supported_modes("80000000"))
    found = one_drive(profile + rx_pdo(("6040", 16), ("60FF", 32)) + DC)
    csv = next(item for item in found.verdicts if item.mode == "CSV")
    assert (csv.verdict, csv.conflict) == ("no", True)


@pytest.mark.parametrize(
    ("angle", "rank", "verdict"), [([("60EA", 16)], "B1", "yes"), ([], "C2", "likely")], ids=["with angle", "without"]
)
def test_the_commutation_angle_is_a_setpoint_too(angle, rank, verdict):
    body = "</Profile>" + rx_pdo(("6040", 16), ("6071", 16), *angle) + init_cmd(11)
    found = one_drive(body)
    (evidence,) = [item for item in found.evidence if item.mode == "CSTCA"]
    assert (evidence.rank, verdicts(found)["CSTCA"]) == (rank, verdict)
    assert "its setpoint 0x6071 and 0x60EA" in evidence.evidence


@pytest.mark.parametrize(("excluded", "rank"), [("", "B1"), ("<Exclude>#x1600</Exclude>", "C2")])
def test_objects_of_the_setpoint_may_lie_in_two_pdos(excluded, rank):
    """Drives with one object a PDO assign both, where these do not exclude each other."""
    angle = rx_pdo(("60EA", 16)).replace(' Sm="2"', "").replace("1600", "1601").replace("</Name>", f"</Name>{excluded}")
    found = one_drive("</Profile>" + rx_pdo(("6040", 16), ("6071", 16)) + angle + init_cmd(11))
    assert [item.rank for item in found.evidence if item.mode == "CSTCA"] == [rank]
    (cstca,) = [item for item in found.verdicts if item.mode == "CSTCA"]
    in_two = "RxPDO 0x1600 and RxPDO 0x1601 map the setpoint; not all are assigned by default"
    assert (in_two in cstca.recipe) == (rank == "B1")


def excluding(pdo: str, *excluded: str) -> str:
    return pdo.replace("</Name>", "</Name>" + "".join(f"<Exclude>#x{index}</Exclude>" for index in excluded))


def unassigned(index: str, entry: str, *excluded: str) -> str:
    """A RxPDO of one object that is not assigned by default."""
    return excluding(rx_pdo((entry, 16)).replace(' Sm="2"', "").replace("1600", index), *excluded)


@pytest.mark.parametrize(
    ("pdos", "together"),
    [
        # A PDO that excludes itself excludes nothing.
        ((excluding(rx_pdo(("6071", 16)), "1600"), unassigned("1601", "60EA")), (0x1600, 0x1601)),
        # Another PDO has the torque too, or another one the angle; either side may say what goes not together.
        (
            (excluding(rx_pdo(("6071", 16)), "1601"), unassigned("1601", "60EA"), unassigned("1602", "6071")),
            (0x1602, 0x1601),
        ),
        (
            (rx_pdo(("6071", 16)), unassigned("1601", "60EA", "1600"), unassigned("1602", "60EA")),
            (0x1600, 0x1602),
        ),
        ((rx_pdo(("6071", 16)), unassigned("1601", "60EA", "1600", "1602"), unassigned("1602", "6071")), ()),
    ],
    ids=["itself", "another torque", "another angle", "none left"],
)
def test_of_several_pdos_with_a_setpoint_those_count_that_go_together(pdos, together):
    found = one_drive("</Profile>" + rx_pdo(("6040", 16)).replace("1600", "1610") + "".join(pdos) + init_cmd(11))
    (cstca,) = [item for item in found.verdicts if item.mode == "CSTCA"]
    assert [item.rank for item in found.evidence if item.mode == "CSTCA"] == ["B1" if together else "C2"]
    words = [f"RxPDO 0x{index:04X}" for index in together]
    assert (" and ".join(words) + " map the setpoint" in cstca.recipe) == bool(together)


def test_the_recipe_names_all_objects_of_the_setpoint():
    angle = "<Object><Index>#x60EA</Index><Name>m</Name><Type>UINT</Type><BitSize>16</BitSize><Flags>"
    angle += "<PdoMapping>R</PdoMapping></Flags></Object>"
    drive = dictionary(supported_modes("00040000"), angle) + rx_pdo(("6040", 16), ("6071", 16))
    found = one_drive(f'{drive}<Mailbox><CoE PdoConfig="1"/></Mailbox>')
    (cstca,) = [item for item in found.verdicts if item.mode == "CSTCA"]
    assert cstca.recipe.startswith("map the setpoint 0x6071 and 0x60EA into an RxPDO")


def test_a_setpoint_in_a_virtual_pdo_is_not_mapped():
    """Nothing transports it: neither inference nor a name nor a command finds it there."""
    virtual = rx_pdo(("6040", 16), ("60FF", 32), name="csv").replace("<RxPdo ", '<RxPdo Virtual="1" ')
    assert [item.rank for item in one_drive("</Profile>" + virtual + DC).evidence] == ["F"]
    (commanded,) = one_drive("</Profile>" + virtual + init_cmd(9) + DC).evidence
    assert (commanded.mode, commanded.rank) == ("CSV", "C2")
    real = rx_pdo(("6040", 16), ("60FF", 32)).replace("1600", "1601")
    (csv,) = [item for item in one_drive("</Profile>" + virtual + real + DC).verdicts if item.mode == "CSV"]
    assert csv.rx_pdo_index == 0x1601


def test_second_axis_needs_its_own_controlword():
    with_axis = "</Profile>" + rx_pdo(("6040", 16), ("607A", 32), ("6840", 16), ("68FF", 32)) + DC
    without = "</Profile>" + rx_pdo(("6040", 16), ("607A", 32), ("68FF", 32)) + DC
    assert verdicts(one_drive(with_axis), axis=1) == {"CSV": "likely"}
    assert verdicts(one_drive(without), axis=1) == {}


def test_an_axis_of_which_nothing_else_is_known_is_an_axis():
    """Its controlword is evidence of CiA 402 (ESI-FACTS 16), though none of any mode."""
    found = one_drive("</Profile>" + rx_pdo(("6040", 16), ("607A", 32), ("6840", 16)) + DC)
    assert [(item.rank, item.evidence) for item in found.evidence if item.axis == 1] == [
        ("F", "controlword 0x6840, but nothing says which modes")
    ]
    assert verdicts(found, axis=1) == {}
    without_profile = one_drive("</Profile>" + rx_pdo(("6040", 16), ("6840", 16)), profile="0")
    assert [(item.axis, item.rank) for item in without_profile.evidence] == [(0, "F"), (1, "F")]
    (by_number,) = one_drive("</Profile>").evidence
    assert (by_number.rank, by_number.evidence) == ("F", "profile number 402, but nothing says which modes")


MODES_TYPE = (
    "<DataType><Name>MODES</Name><BaseType>USINT</BaseType><BitSize>8</BitSize>"
    "<EnumInfo><Text>Cyclic synchronous velocity mode (CSV)</Text><Enum>9</Enum></EnumInfo></DataType>"
)


def test_a_motion_terminal_lists_modes_in_a_plain_object_too():
    plain = "<Object><Index>#x2010</Index><Name>m</Name><Type>MODES</Type><BitSize>8</BitSize></Object>"
    (csv,) = one_drive("<AddInfo>742</AddInfo>" + dictionary(plain, types=MODES_TYPE), profile="5001").verdicts
    assert (csv.kind, csv.mode, csv.verdict) == ("MDP 742", "CSV", "likely")
    assert "0x2010" in csv.evidence


@pytest.mark.parametrize("is_default", [True, False])
def test_a_motion_terminal_in_a_slot_is_named(is_default):
    plain = "<Object><Index>#x2010</Index><Name>m</Name><Type>MODES</Type><BitSize>8</BitSize></Object>"
    profile = f"<Profile><ProfileNo>5001</ProfileNo><AddInfo>742</AddInfo>{dictionary(plain, types=MODES_TYPE)}"
    modules = "".join(
        f"<Module><Type ModuleIdent='{ident}'>M{ident}</Type><Name>Motion</Name>{content}</Module>"
        for ident, content in ((1, ""), (2, profile))
    )
    default = 2 if is_default else 1
    idents = "".join(f"<ModuleIdent Default='{int(ident == default)}'>{ident}</ModuleIdent>" for ident in (1, 2))
    slots = f'<Slots><Slot MinInstances="1" MaxInstances="1">{idents}</Slot></Slots>'
    info = snippets.read(snippets.esi(snippets.device(slots), modules)).document.infos[0]
    (csv,) = drive_modes(info.devices[0], info.modules).verdicts
    assert (csv.kind, csv.mode, csv.module_ident, csv.module_is_default) == ("MDP 742", "CSV", 2, is_default)
    assert csv.evidence.startswith("module 'M2 / Motion': values of 0x2010 list ")


def two_dictionaries(first: str, second: str) -> DriveModes:
    """A profile 5001 and one of 402, each with a 0x6502."""
    both = (
        dictionary(supported_modes(first)) + f"<Profile><ProfileNo>402</ProfileNo>{dictionary(supported_modes(second))}"
    )
    return one_drive(both, profile="5001")


@pytest.mark.parametrize("first", ["00000000", "", "80000000"])
def test_a_dictionary_that_says_nothing_hides_no_other(first):
    """Zero and absent say nothing; bit 7 of the second is CSP."""
    found = two_dictionaries(first, "80000000")
    csp = verdict_of(found, "CSP")
    assert (csp.verdict, csp.conflict) == ("yes", False)
    assert verdict_of(found, "CSV").verdict == "no"


def test_dictionaries_that_say_different_things_are_a_conflict():
    found = two_dictionaries("80000000", "80010000")
    assert [(verdict_of(found, mode).verdict, verdict_of(found, mode).conflict) for mode in ("CSP", "CSV", "CST")] == [
        ("yes", False),
        ("likely", True),
        ("no", False),
    ]
    assert {(item.rank, item.conflict) for item in found.evidence if item.mode == "CSV"} == {("A-", True), ("A+", True)}


def test_listed_modes_of_a_motion_terminal_are_likely():
    """They weigh as much as a list of 0x6060, which is no "yes" either."""
    types = (
        "<DataType><Name>MODES</Name><BaseType>USINT</BaseType><BitSize>8</BitSize>"
        "<EnumInfo><Text>Cyclic synchronous velocity mode (CSV)</Text><Enum>9</Enum></EnumInfo></DataType>"
        "<DataType><Name>DT8010</Name><BitSize>24</BitSize><SubItem><SubIdx>1</SubIdx><Name>Mode</Name>"
        "<Type>MODES</Type><BitSize>8</BitSize><BitOffs>16</BitOffs></SubItem></DataType>"
    )
    settings = "<Object><Index>#x8010</Index><Name>m</Name><Type>DT8010</Type><BitSize>24</BitSize></Object>"
    (csv,) = one_drive("<AddInfo>742</AddInfo>" + dictionary(settings, types=types), profile="5001").verdicts
    assert (csv.kind, csv.mode, csv.verdict, csv.score) == ("MDP 742", "CSV", "likely", 0.75)


def test_what_speaks_soe_may_be_a_drive():
    body = "</Profile><Mailbox><SoE/></Mailbox>"
    (found,) = one_drive(body, profile="0").verdicts
    assert (found.kind, found.verdict) == ("SoE", "unknown")
    assert found.evidence.startswith("speaks SoE: if it is a drive, its modes are in IDN S-0-0032")


def test_idns_are_no_objects():
    """P-0-0064 and P-0-0065 are IDN 0x8040 and 0x8041: words of 16 bits, as those of axis 4 would be."""
    motor_current = word_objects("8040", "8041")
    for protocols, axes in (("<SoE/>", set()), ("<CoE/><SoE/>", {4})):
        found = one_drive(dictionary(motor_current) + f"<Mailbox>{protocols}</Mailbox>", profile="0")
        assert {item.axis for item in found.evidence} == axes
        assert [item.kind for item in found.verdicts] == ["SoE"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Axis (csv,csp,cst)", {"CSV", "CSP", "CST"}),
        ("Axis (pp,pv,pt)", {"PP", "PV", "TQ"}),
        ("pv - axis", {"PV"}),
        ("Cyclic velocity Mode", {"CSV"}),
        ("Cyclic Synchronous Position Mode", {"CSP"}),
        ("Position Mode (DC)", {"CSP"}),
        ("Profile Velocity Mode", {"PV"}),
        ("CSV file export", set()),
        ("IP address", set()),
        ("Application parameters", set()),
        ("Cyclic synchronous torque mode with commutation angle", {"CSTCA"}),
        ("Cyclic Synchronous Torque with Commutation Angle Mode (CSTCA)", {"CSTCA"}),
        ("Cyclic synchronous torque mode (CSTCA)", {"CSTCA"}),
        ("Cyclic synchronous torque mode (CST)", {"CST"}),
        ("cst, cstca", {"CST", "CSTCA"}),
        ("Profile Position Mode (DC)", {"PP"}),
        ("Cyclic_Synchronous_Velocity", {"CSV"}),
        ("Cyclic-synchronous velocity", {"CSV"}),
        ("Cyclic Sync. Position", {"CSP"}),
        ("Profile-Velocity", {"PV"}),
        ("CSV_file", set()),
        ("DCSPeed", set()),
    ],
)
def test_names_count_on_word_boundaries(text, expected):
    assert named_modes(text) == expected


def example(name: str) -> tuple[Device, list[Module]]:
    info = read_esi(DATA / name).document.infos[0]
    device = info.devices[0]
    return device, reachable_modules(device, info.modules)


def test_alternative_modules_give_recipes_of_their_own():
    found = drive_modes(*example("eyou_servo_module.xml"))
    by_mode = {item.mode: item for item in found.verdicts}
    assert {mode for mode, item in by_mode.items() if item.verdict == "yes"} == {"CSV", "CSP", "CST", "PP", "PV", "TQ"}
    assert {by_mode[mode].module_ident for mode in ("CSV", "CSP", "CST")} == {0x119800}
    assert {by_mode[mode].module_ident for mode in ("PP", "TQ")} == {0x219800}
    assert by_mode["CSV"].module_is_default is True
    assert by_mode["PP"].module_is_default is False
    against_names = [item for item in found.evidence if item.rank == "C3"]
    assert {item.module_ident for item in against_names} == {0x219800, 0x319800}


def test_two_slots_are_two_axes():
    found = drive_modes(*example("two_axis_modular_drive.xml"))
    for axis in (0, 1):
        yes = {item.mode for item in found.verdicts if item.axis == axis and item.verdict == "yes"}
        assert yes == {"CSP", "CSV", "CST", "CSTCA"}
    second = next(item for item in found.verdicts if item.axis == 1 and item.mode == "CSV")
    assert second.rx_pdo_index == 0x1701 + 64
    assert "0x6860" in (second.evidence or "")


def drive_module(ident: int, *entries: str, name: str = "csv", moves: bool = True) -> str:
    """A module of profile 402 whose RxPDO maps these words and names a mode."""
    attribute = ' DependOnSlot="1"' if moves else ""
    rows = "".join(
        f"<Entry><Index{attribute}>#x{index}</Index><SubIndex>0</SubIndex><BitLen>16</BitLen></Entry>"
        for index in entries
    )
    return (
        f'<Module><Type ModuleIdent="{ident}">M{ident}</Type><Name>Module</Name><RxPdo Sm="2">'
        f"<Index{attribute}>#x1600</Index><Name>{name}</Name>{rows}</RxPdo>"
        "<Profile><ProfileNo>402</ProfileNo></Profile></Module>"
    )


def slot(ident: int, instances: int = 1, *, is_default: bool = False) -> str:
    return (
        f'<Slot MinInstances="{int(is_default)}" MaxInstances="{instances}"><Name>S</Name>'
        f'<ModuleIdent Default="{int(is_default)}">{ident}</ModuleIdent></Slot>'
    )


def modular_drive(slots: str, modules: str, *, profile: str = "", increment: str = "#x800", dc: str = "") -> DriveModes:
    content = f'{profile}{dc}<Slots SlotIndexIncrement="{increment}" SlotPdoIncrement="16">{slots}</Slots>'
    info = Reader().read(snippets.esi(snippets.device(content), modules).encode()).document.infos[0]
    return drive_modes(info.devices[0], reachable_modules(info.devices[0], info.modules))


IO_MODULE = '<Module><Type ModuleIdent="1">IO</Type><Name>I/O</Name></Module>'


def declaring(module: str, data: str) -> str:
    """The module with this default of 0x6502."""
    return module.replace("<ProfileNo>402</ProfileNo></Profile>", dictionary(supported_modes(data)))


def placeholder(mark: str = ' OverwrittenByModule="1"') -> str:
    """The profile of a device whose 0x6502, CSP, is marked."""
    objects = supported_modes("80000000").replace("<Index>", f"<Index{mark}>")
    return f"<Profile><ProfileNo>402</ProfileNo>{dictionary(objects)}"


CSV_MODULE = declaring(drive_module(2, "6040", "60FF", name="Outputs", moves=False), "00010000")
CSP_MODULE = declaring(drive_module(2, "6040", name="Outputs", moves=False).replace("#x1600", "#x1601"), "80000000")
MOVING = '<Index DependOnSlot="1">'


def test_an_object_marked_overwritten_by_module_yields_to_the_module():
    """The placeholder gave a CSP that the module denies, and held down its CSV."""
    found = modular_drive(slot(2, is_default=True), CSV_MODULE, profile=placeholder())
    csv, csp = (next(item for item in found.verdicts if item.mode == mode) for mode in ("CSV", "CSP"))
    assert (csv.verdict, csv.conflict, csv.module_ident) == ("yes", False, 2)
    assert (csp.verdict, csp.conflict) == ("no", False)
    assert {item.module_ident for item in found.evidence} == {2}


def test_an_object_that_is_not_marked_counts_beside_the_modules():
    found = modular_drive(slot(2, is_default=True), CSV_MODULE, profile=placeholder(mark=""))
    csv, csp = (verdict_of(found, mode) for mode in ("CSV", "CSP"))
    assert (csv.verdict, csv.conflict) == (csp.verdict, csp.conflict) == ("likely", True)


@pytest.mark.parametrize(
    ("slots", "modules", "csv", "conflict"),
    [
        (slot(2, is_default=True), CSP_MODULE, "no", True),
        # A preset makes a slot that is never empty, whatever MinInstances says.
        (slot(2, is_default=True).replace('MinInstances="1"', 'MinInstances="0"'), CSP_MODULE, "no", True),
        (slot(2).replace('MinInstances="0"', 'MinInstances="1"'), CSP_MODULE, "no", True),
        (slot(2), CSP_MODULE, "yes", False),
        # Beside a module that says nothing, or that no document describes, the device's own evidence is all there is.
        (slot(2, is_default=True).replace("</Slot>", "<ModuleIdent>1</ModuleIdent></Slot>"), CSP_MODULE, "yes", False),
        (slot(2, is_default=True).replace("</Slot>", "<ModuleIdent>9</ModuleIdent></Slot>"), CSP_MODULE, "yes", False),
        # The slot of another axis may be as full as it likes.
        (slot(1, is_default=True) + slot(2, is_default=True), CSP_MODULE.replace("<Index>", MOVING), "yes", False),
    ],
)
def test_where_a_slot_is_never_empty_no_device_is_alone(slots, modules, csv, conflict):
    """The RxPDO of the device is named after CSV, and the module's 0x6502 says that there is none."""
    outputs = rx_pdo(("6040", 16), ("60FF", 32), name="CSV outputs")
    found = modular_drive(slots, IO_MODULE + modules, profile=f"<Profile><ProfileNo>402</ProfileNo></Profile>{outputs}")
    verdict = next(item for item in found.verdicts if item.mode == "CSV" and item.axis == 0)
    assert (verdict.verdict, verdict.conflict) == (csv, conflict)


def test_a_marked_object_counts_while_the_slot_is_empty():
    found = modular_drive(slot(2), CSV_MODULE, profile=placeholder() + rx_pdo(("6040", 16), ("6071", 16)))
    answers = {item.mode: (item.verdict, item.conflict, item.module_ident) for item in found.verdicts}
    assert (answers["CSP"], answers["CSV"]) == (("yes", False, None), ("yes", False, 2))
    assert len(found.evidence) == len(set(found.evidence))


def test_a_marked_object_counts_beside_a_module_without_it():
    """The slot is never empty: it is the alternative that leaves the device's object in place."""
    either = (
        '<Slot MinInstances="1" MaxInstances="1"><ModuleIdent Default="1">2</ModuleIdent><ModuleIdent>3</ModuleIdent>'
    )
    plain = drive_module(3, "6040", "607A", name="Outputs", moves=False)
    found = modular_drive(f"{either}</Slot>", CSV_MODULE + plain, profile=placeholder())
    answers = {item.mode: (item.verdict, item.module_ident) for item in found.verdicts}
    assert (answers["CSP"], answers["CSV"]) == (("yes", 3), ("yes", 2))
    assert [item.module_ident for item in found.evidence if (item.mode, item.rank) == ("CSP", "A+")] == [None]


def test_a_marked_object_yields_to_what_every_module_of_a_needed_slot_declares():
    needed = '<Slot MinInstances="1" MaxInstances="1"><ModuleIdent>2</ModuleIdent><ModuleIdent>3</ModuleIdent></Slot>'
    other = (
        CSV_MODULE.replace('ModuleIdent="2"', 'ModuleIdent="3"').replace("60FF", "6071").replace("00010000", "00020000")
    )
    found = modular_drive(needed, CSV_MODULE + other, profile=placeholder())
    assert {item.mode: item.module_ident for item in found.verdicts if item.verdict == "yes"} == {"CSV": 2, "CST": 3}


def writing(mode: int, mark: str = "") -> str:
    """A mailbox that writes a mode's code to 0x6060."""
    return init_cmd(mode).replace("<InitCmd>", f"<InitCmd{mark}>")


MARKED = ' OverwrittenByModule="1"'
BOTH_SETPOINTS = rx_pdo(("6040", 16), ("607A", 32), ("60FF", 32))


@pytest.mark.parametrize(
    ("of_device", "of_module", "name", "expected"),
    [
        # 0x6060 holds 9, and the module has the setpoint of CSV.
        (writing(9), "", "M", {"CSV": ("B1", False)}),
        (writing(9), "", "Axis csp", {"CSV": ("C3", True)}),
        # At PS the device writes before the module, at SO behind it.
        (writing(8), writing(9), "M", {"CSV": ("B1", False)}),
        (writing(8).replace("PS", "SO"), writing(9), "M", {"CSP": ("B1", False)}),
        (writing(10), "", "M", {"CST": ("C2", True)}),
    ],
)
def test_init_cmds_of_device_and_module_are_those_of_one_start(of_device, of_module, name, expected):
    profile = f"<Profile><ProfileNo>402</ProfileNo></Profile>{of_device}"
    module = f'<Module><Type ModuleIdent="2">{name}</Type><Name>{name}</Name>{BOTH_SETPOINTS}{of_module}</Module>'
    found = modular_drive(slot(2, is_default=True), module, profile=profile)
    started = {item.mode: (item.rank, item.conflict) for item in found.evidence if item.rank in ("B1", "C2", "C3")}
    assert started == expected
    ((mode, (rank, _)),) = expected.items()
    assert (verdicts(found).get(mode) == "yes") is (rank == "B1")


def test_beside_a_module_of_a_further_axis_the_pdos_of_the_device_are_there():
    """The device maps the setpoint of the second axis and nothing else of it."""
    module = (
        drive_module(2, "6040", name="Outputs")
        .replace("</RxPdo>", f"</RxPdo>{writing(9)}")
        .replace(
            "<InitCmd><Transition>PS</Transition><Index>",
            '<InitCmd><Transition>PS</Transition><Index DependOnSlot="1">',
        )
    )
    outputs = rx_pdo(("68FF", 32)).replace("#x1600", "#x1700")
    found = modular_drive(slot(1, is_default=True) + slot(2, is_default=True), IO_MODULE + module, profile=outputs)
    assert verdicts(found, axis=1)["CSV"] == "yes"


def test_a_marked_init_cmd_yields_to_that_of_the_module():
    """0x6060 holds 9 in operation: the device's command for 8 is not sent. The setpoint is that of the device's PDO."""
    module = f'<Module><Type ModuleIdent="2">M</Type><Name>Module</Name>{writing(9)}</Module>'
    profile = f"<Profile><ProfileNo>402</ProfileNo></Profile>{BOTH_SETPOINTS}{writing(8, MARKED)}"
    found = modular_drive(slot(2, is_default=True), module, profile=profile, dc=DC)
    csp, csv = verdict_of(found, "CSP"), verdict_of(found, "CSV")
    assert (csp.verdict, csv.verdict) == ("likely", "yes")
    assert csp.recipe.endswith("write 8 to it before operation, after the InitCmd that writes 9")
    assert csv.recipe == (
        "plug module 0x2 into slot 0 (default); RxPDO 0x1600 maps the setpoint; OpMode 'DC'; "
        "0x6060 = 9 is written by an InitCmd"
    )
    assert [(item.mode, item.rank) for item in found.evidence if item.object_index == 0x6060] == [("CSV", "B1")]


@pytest.mark.parametrize("is_default", [True, False])
def test_a_marked_pdo_yields_to_that_of_the_module(is_default):
    """Beside the module, which has the controlword alone in 0x1600, no setpoint is left; without it the device's is."""
    module = drive_module(2, "6040", name="Outputs", moves=False)
    profile = f"<Profile><ProfileNo>402</ProfileNo></Profile>{BOTH_SETPOINTS.replace('<RxPdo', '<RxPdo' + MARKED)}"
    found = modular_drive(slot(2, is_default=is_default), module, profile=profile, dc=DC)
    assert verdicts(found) == ({} if is_default else {"CSP": "likely", "CSV": "likely"})


SUPERSEDED_DC = SUPERSEDED.replace("</AssignActivate>", '</AssignActivate><Sm No="2"><Pdo>#x1601</Pdo></Sm>')


def test_a_module_asks_for_the_op_mode_that_tools_still_count():
    """Of two of one name; the superseded one would assign another PDO."""
    module = asking_for_dc(drive_module(2, "6040", "60FF", name="Outputs", moves=False))
    both = SUPERSEDED_DC.replace("</Dc>", DC.removeprefix("<Dc>"))
    csv = verdict_of(modular_drive(slot(2, is_default=True), module, dc=both), "CSV")
    assert (csv.rx_pdo_is_default, csv.op_mode) == (True, "1")
    assert "RxPDO 0x1600 maps the setpoint; OpMode 1 'DC'; " in csv.recipe


def test_a_module_that_asks_for_an_op_mode_that_is_none_asks_for_nothing():
    module = asking_for_dc(drive_module(2, "6040", "60FF", name="Outputs", moves=False)).replace(">DC<", ">DCx<")
    csv = verdict_of(modular_drive(slot(2, is_default=True), module, dc=DC), "CSV")
    assert (csv.verdict, csv.op_mode) == ("likely", "DC")


def test_a_drive_behind_eight_slots_of_inputs_is_found():
    """The number of the slot was taken for an axis, of which there are eight."""
    found = modular_drive(slot(1, 8) + slot(2, is_default=True), IO_MODULE + drive_module(2, "6040", "60FF"))
    assert [(item.axis, item.mode, item.verdict) for item in found.verdicts if item.verdict == "yes"] == [
        (8, "CSV", "yes")
    ]
    (csv,) = [item for item in found.verdicts if item.mode == "CSV"]
    assert csv.recipe.startswith("plug module 0x2 into slot 8 (default); RxPDO 0x1680 maps the setpoint")
    assert "0xA060" in csv.recipe  # 0x6060 + 8 * 0x800


@pytest.mark.parametrize(
    ("module", "words", "is_default"),
    [
        (
            drive_module(2, "6040", "60FF").replace('<Index DependOnSlot="1">#x16', "<Index>#x16"),
            "no setpoint: RxPDO 0x1600 has 0x60FF, but is ambiguous: "
            "module 0x2 in slot 0 and module 0x2 in slot 1 describe it in different ways; ",
            None,
        ),
        (
            drive_module(2, "6040", "60FF", moves=False),
            "RxPDO 0x1600 maps the setpoint; assigned twice by default, which no export makes: choose --pdo 0x1600; ",
            False,
        ),
        (drive_module(2, "6040", "60FF"), "RxPDO 0x1600 maps the setpoint; ", True),
    ],
)
def test_a_setpoint_in_a_pdo_that_two_slots_assign_is_not_there_as_it_stands(module, words, is_default):
    """Whatever an export assigns, it assigns once."""
    found = modular_drive(slot(2, is_default=True) * 2, module)
    csv = next(item for item in found.verdicts if item.mode == "CSV" and item.axis == 0)
    assert csv.verdict == "yes"
    assert csv.recipe.startswith(f"plug module 0x2 into slot 0 (default); {words}")
    assert csv.rx_pdo_is_default is is_default


def test_objects_that_do_not_depend_on_the_slot_belong_to_the_first_axis():
    """A drive in slot 1 was axis 1, and 0x6502 of the device, which has CSP only, did not speak against its CSV."""
    profile = f"<Profile><ProfileNo>402</ProfileNo>{dictionary(supported_modes('80000000'))}"
    modules = IO_MODULE + drive_module(2, "6040", "60FF", moves=False)
    found = modular_drive(slot(1) + slot(2, is_default=True), modules, profile=profile)
    assert {item.axis for item in found.verdicts} == {0}
    (csv,) = [item for item in found.verdicts if item.mode == "CSV"]
    assert (csv.verdict, csv.conflict) == ("no", True)
    assert verdicts(found)["CSP"] == "yes"


def test_objects_that_stay_where_the_increment_is_zero_belong_to_the_first_axis():
    modules = IO_MODULE + drive_module(2, "6040", "60FF")
    found = modular_drive(slot(1) + slot(2, is_default=True), modules, increment="0")
    assert verdicts(found, axis=0)["CSV"] == "yes"
    assert verdicts(found, axis=1) == {}


def test_a_module_with_the_objects_of_the_second_axis_is_that_axis():
    modules = IO_MODULE + drive_module(2, "6840", "68FF", moves=False)
    found = modular_drive(slot(1) + slot(2, is_default=True), modules)
    assert (verdicts(found, axis=0), verdicts(found, axis=1)["CSV"]) == ({}, "yes")


def test_a_drive_in_every_slot_is_an_axis_in_every_slot():
    found = modular_drive(slot(2, 3), drive_module(2, "6040", "60FF"))
    assert [(item.axis, item.rx_pdo_index) for item in found.verdicts if item.mode == "CSV"] == [
        (0, 0x1600),
        (1, 0x1610),
        (2, 0x1620),
    ]


def test_a_recipe_names_the_slot_that_has_the_module_by_default():
    modules = drive_module(2, "6040", "60FF", moves=False)
    found = modular_drive(slot(2, 2) + slot(2, is_default=True), modules)
    (csv,) = [item for item in found.verdicts if item.mode == "CSV"]
    assert csv.recipe.startswith("plug module 0x2 into slot 2 (default)")


def test_of_equal_answers_that_with_the_setpoint_in_an_rx_pdo_counts():
    """The dictionary of the device lets 0x607A into RxPDOs (E, 0.25): the default module has none with it."""
    mappable = "<Flags><PdoMapping>R</PdoMapping></Flags></Object>"
    profile = dictionary(supported_modes("", index="607A").replace("</Object>", mappable))
    both = (
        '<Slot MinInstances="1" MaxInstances="1"><ModuleIdent Default="1">2</ModuleIdent><ModuleIdent>3</ModuleIdent>'
    )
    modules = drive_module(2, "6040", "60FF", name="Outputs", moves=False)
    modules += drive_module(3, "6040", "607A", name="Outputs", moves=False)
    found = modular_drive(f"{both}</Slot>", modules, profile=f"<Profile><ProfileNo>402</ProfileNo>{profile}")
    (profile_position,) = [item for item in found.verdicts if item.mode == "PP"]
    assert (profile_position.score, profile_position.module_ident) == (0.25, 3)
    assert profile_position.recipe.startswith(
        "plug module 0x3 into slot 0 (not the default); RxPDO 0x1600 maps the setpoint; "
    )


def test_profile_402_of_a_module_counts_in_every_slot():
    """Without a controlword the module in the second slot was no drive, the one in the first slot was."""
    found = modular_drive(slot(2, 2), drive_module(2, "60FF"))
    assert [item.axis for item in found.verdicts if item.mode == "CSV"] == [0, 1]


@pytest.mark.parametrize(
    ("names", "written", "ranks"),
    [
        (("Axis (csp, csv)", "p"), None, {"C1"}),
        (("Axis (csp only, csv not supported)", "p"), None, set()),
        (("Axis", "CSV (reserved)"), None, set()),
        (("Axis", "CSV"), None, {"C1"}),
        (("Axis (csp only, csv not supported)", "p"), 9, {"C3"}),
        (("Axis (not supported)", "p"), 9, {"B1"}),  # names no mode
    ],
)
def test_a_name_that_denies_modes_claims_none(names, written, ranks):
    module, pdo = names
    moving = drive_module(2, "6040", "60FF", name=pdo, moves=False).replace("<Name>Module<", f"<Name>{module}<")
    if written is not None:
        moving = moving.replace("</RxPdo>", f"</RxPdo>{writing(written)}")
    found = modular_drive(slot(2, is_default=True), moving)
    assert {item.rank for item in found.evidence if item.mode == "CSV"} - {"D3 split"} == ranks


def test_the_name_of_cstca_is_no_cst():
    """Its words begin with those of CST: the command to run it seemed to go against the name."""
    module = drive_module(2, "6040", "6071", "60EA", name="Outputs", moves=False)
    module = module.replace("<Name>Module</Name>", "<Name>Cyclic synchronous torque mode with commutation angle</Name>")
    found = modular_drive(slot(2, is_default=True), module.replace("<Profile>", init_cmd(11) + "<Profile>"))
    assert {(item.mode, item.rank) for item in found.evidence if item.rank[0] in "BC"} == {
        ("CSTCA", "B1"),
        ("CSTCA", "C1"),
    }
    assert verdicts(found)["CSTCA"] == "yes"


def corpus_devices(corpus: Path, archive: str, member_part: str):
    opened = Archive(corpus / "esi" / archive)
    reader = Reader()
    for member, _ in opened.members():
        if member_part in member:
            for info in reader.read(opened.read(member), member, opened).document.infos:
                for device in info.devices:
                    yield device, reachable_modules(device, info.modules)


def yes_modes(found: DriveModes) -> set[str]:
    return {item.mode for item in found.verdicts if item.verdict == "yes" and item.kind == "CiA 402"}


def test_eyou_with_slots(corpus):
    ((device, modules),) = corpus_devices(corpus, "ruiofang+EU_EtherCAT.zip", "ECAT_V143.xml")
    found = drive_modes(device, modules)
    by_mode = {item.mode: item for item in found.verdicts}
    assert yes_modes(found) == {"CSV", "CSP", "CST", "PP", "PV", "TQ"}
    assert all(by_mode[mode].module_ident == 0x119800 for mode in ("CSV", "CSP", "CST"))
    assert all(by_mode[mode].module_ident == 0x219800 for mode in ("PP", "TQ"))
    conflicts = {(item.rank, item.module_ident) for item in found.evidence if item.conflict}
    assert conflicts == {("A+ short", None), ("C3", 0x219800), ("C3", 0x319800)}


def test_hpmicro_sample(corpus):
    found = [
        drive_modes(device, modules)
        for device, modules in corpus_devices(corpus, "hpmicro+hpm_sdk.zip", "")
        if device.type == "ECAT_CIA402"
    ]
    assert found
    for item in found:
        modules = {v.mode: v.module_ident for v in item.verdicts if v.axis == 0 and v.verdict == "yes"}
        assert modules == {"CSP": 0x219800, "CSV": 0x319800}


def all_devices(corpus: Path):
    return devices_of(sorted((corpus / "esi").glob("*.zip")))


def devices_of(archives):
    reader = Reader()
    for path in archives:
        opened = Archive(path)
        for member, _ in opened.members():
            try:
                document = reader.read(opened.read(member), member, opened).document
            except Exception:
                continue
            for info, referenced in zip(document.infos, document.referenced_modules, strict=True):
                for device in info.devices:
                    yield info, device, reachable_modules(device, (*info.modules, *referenced))


@pytest.mark.corpus
def test_verdicts_on_the_whole_corpus(corpus):
    seen = set()
    for info, device, modules in all_devices(corpus):
        vendor = info.vendor.names[0].text if info.vendor is not None and info.vendor.names else ""
        found = drive_modes(device, modules)
        words = {(item.kind, item.mode): item.verdict for item in found.verdicts}
        for verdict in found.verdicts if None not in (device.product_code, device.revision_no) else ():
            if verdict.rx_pdo_index is not None:
                made = mapped_with(Subject(1, "V", device, modules), verdict, chosen_in(verdict.recipe))
                assert 0x6040 + 0x800 * verdict.axis in set().union(*made.values())
                assert verdict.rx_pdo_index in made
        numbers = {p.profile_no for p in device.profiles}
        if numbers == {406}:
            assert not found.verdicts
        if (device.type or "").startswith("AX5") and device.mailbox is not None and device.mailbox.soe:
            assert words == {("SoE", "SoE"): "unknown"}
            seen.add("AX5")
        if (device.type or "").startswith("EJ7211-0010"):
            assert words and {kind for kind, _ in words} == {"MDP 742"}
            seen.add("EJ7211-0010")
        if device.type == "EJ7211-0011":
            assert words["CiA 402", "CSV"] == "likely"
            seen.add("EJ7211-0011")
        if vendor == "Ingenia":
            assert yes_modes(found) >= {"PP", "PV", "HM", "IP", "CSP", "CSV", "CST"}
            seen.add("Ingenia")
        if device.type == "EPOS4" and device.has_slots:
            assert yes_modes(found) == {"PP", "PV", "CSP", "CSV", "CST"}
            seen.add("EPOS4")
    assert seen == {"AX5", "EJ7211-0010", "EJ7211-0011", "Ingenia", "EPOS4"}
