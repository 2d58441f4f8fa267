"""Comparing start-up commands: added, removed, changed, sent in another order."""

from test_compare import told


def command(index: str, data: str, subindex: int = 0, transition: str = "PS", attributes: str = "") -> str:
    return (
        f"<InitCmd {attributes}><Transition>{transition}</Transition><Index>{index}</Index>"
        f"<SubIndex>{subindex}</SubIndex><Data>{data}</Data></InitCmd>"
    )


def commands(left: tuple[str, ...], right: tuple[str, ...], protocol: str = "CoE"):
    wrap = f"<Mailbox><{protocol}>{{}}</{protocol}></Mailbox>"
    return told(wrap.format("".join(left)), wrap.format("".join(right)))


MODE, PERIOD, LIMIT = command("#x6060", "08"), command("#x60C2", "02", 1), command("#x2000", "1000")


def test_a_changed_value():
    assert commands((MODE, PERIOD), (command("#x6060", "09"), PERIOD)) == [
        ("CoE InitCmd 0x6060:00 data", "08", "09", True)
    ]


def test_added_and_removed_ones_count():
    assert commands((MODE,), (PERIOD, MODE)) == [("CoE InitCmd 0x60C2:01", None, "at PS, data 02", True)]
    assert commands((PERIOD, MODE), (MODE,)) == [("CoE InitCmd 0x60C2:01", "at PS, data 02", None, True)]


def test_another_transition_and_complete_access():
    assert commands((MODE,), (command("#x6060", "08", transition="SO", attributes='CompleteAccess="1"'),)) == [
        ("CoE InitCmd 0x6060:00 at", "PS", "SO", True),
        ("CoE InitCmd 0x6060:00 CompleteAccess", "no", "yes", True),
    ]


def test_comments_do_not_count():
    commented = MODE.replace("</InitCmd>", "<Comment>csp</Comment></InitCmd>")
    assert commands((MODE,), (commented,)) == [("CoE InitCmd 0x6060:00 comment", None, "csp", False)]


def test_another_order_is_told_from_the_first_to_the_last_one():
    first, last = command("#x1000", "00"), command("#x1001", "00")
    assert commands((first, MODE, PERIOD, LIMIT, last), (first, LIMIT, MODE, PERIOD, last)) == [
        (
            "CoE InitCmd order",
            "0x6060:00, 0x60C2:01, 0x2000:00",
            "0x2000:00, 0x6060:00, 0x60C2:01",
            True,
        )
    ]


def test_the_writes_of_an_object_in_another_order():
    """With count 1 at the end one PDO is assigned, with count 0 none."""
    clear, fill, count = command("#x1C12", "00"), command("#x1C12", "0016", 1), command("#x1C12", "01")
    words = "0x1C12:00 = 00, 0x1C12:01, 0x1C12:00 = 01", "0x1C12:00 = 01, 0x1C12:01, 0x1C12:00 = 00"
    assert commands((clear, fill, count), (count, fill, clear)) == [("CoE InitCmd order", *words, True)]


def test_an_object_written_several_times():
    """The writes of a PDO assignment: count 0, entries, count n; one entry more in between."""
    clear, fill, count = command("#x1C12", "00"), command("#x1C12", "0016", 1), command("#x1C12", "01")
    second, count_two = command("#x1C12", "0116", 2), command("#x1C12", "02")
    assert commands((clear, fill, count), (clear, fill, second, count_two)) == [
        ("CoE InitCmd 0x1C12:00 data", "01", "02", True),
        ("CoE InitCmd 0x1C12:02", None, "at PS, data 0116", True),
    ]


def test_soe_commands_are_matched_by_their_idn():
    idn = "<InitCmd Chn='0'><Transition>PS</Transition><IDN>32</IDN><Data>{}</Data></InitCmd>"
    assert commands((idn.format("0B00"),), (idn.format("0200"),), "SoE") == [
        ("SoE InitCmd IDN 32 channel 0 data", "0B00", "0200", True)
    ]
