"""Which description fits a found revision: CheckRevisionNo word by word, and the order of the candidates."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from esicatalog.model.revisions import CHECK_REVISION_NO, Described, accepts_revision, rank

UINT32 = st.integers(0, 0xFFFF_FFFF)
DESCRIBED = st.builds(
    Described, st.none() | UINT32, st.none() | st.sampled_from([*CHECK_REVISION_NO, "odd"]), st.booleans()
)


@pytest.mark.parametrize(
    ("check", "found", "configured", "accepted"),
    [
        ("NONE", 1, 9, True),
        ("EQ", 0x00110000, 0x00110000, True),
        ("EQ", 0x00110001, 0x00110000, False),
        ("EQ_OR_G", 0x00120000, 0x00110000, True),
        ("EQ_OR_G", 0x00100000, 0x00110000, False),
        ("LW_EQ", 0x00100014, 0x00110014, True),
        ("LW_EQ", 0x00110015, 0x00110014, False),
        ("LW_EQ_HW_EQ_OR_G", 0x00120014, 0x00110014, True),
        ("LW_EQ_HW_EQ_OR_G", 0x00100014, 0x00110014, False),
        ("LW_EQ_HW_EQ_OR_G", 0x00120015, 0x00110014, False),
        ("HW_EQ", 0x00110000, 0x0011FFFF, True),
        ("HW_EQ", 0x00120000, 0x00110000, False),
        ("HW_EQ_LW_EQ_OR_G", 0x00110002, 0x00110001, True),
        ("HW_EQ_LW_EQ_OR_G", 0x00110000, 0x00110001, False),
        ("L24_EQ_H8_EQ_OR_G", 0x02345678, 0x01345678, True),
        ("L24_EQ_H8_EQ_OR_G", 0x00345678, 0x01345678, False),
        ("L24_EQ_H8_EQ_OR_G", 0x02345679, 0x01345678, False),
        ("L24_EQ_H8_EQ_OR_G", 0x02355678, 0x01345678, False),
        (None, 1, 1, False),
        ("whatever", 1, 1, False),
    ],
)
def test_check_revision_no(check, found, configured, accepted):
    assert accepts_revision(check, found, configured) is accepted


def best(found, *described):
    first = rank(found, [Described(*item) for item in described])[0]
    return first.match, first.position


OLD, NEW = 0x00100000, 0x00130000


@pytest.mark.parametrize(
    ("found", "described", "match", "position"),
    [
        (NEW, [(OLD, "EQ_OR_G", False), (NEW, None, True)], "exact", 1),
        (0x00120000, [(OLD, "EQ_OR_G", False), (0x00110000, "EQ_OR_G", False)], "accepted", 1),
        (0x00120000, [(NEW, "LW_EQ", False), (OLD, "LW_EQ", False)], "accepted", 1),
        (0x00120000, [(NEW, "LW_EQ", False), (0x00110001, None, False)], "accepted", 0),
        (0x00120000, [(0x00110001, None, False), (OLD, None, False)], "older", 1),
        (0x00120000, [(0x00110001, None, False), (0x00100001, None, False)], "older", 0),
        (0x00120000, [(NEW, None, False), (0x00140000, None, False)], "newer", 0),
        (0x00120000, [(None, None, False)], "product", 0),
        (0x00120000, [(0x00110000, None, True), (OLD, None, False)], "older", 1),
        (0x00120000, [(0x00110000, "EQ_OR_G", True), (OLD, None, False)], "accepted", 0),
        (None, [(NEW, None, True), (OLD, None, False)], "product", 1),
        (None, [(NEW, None, True), (OLD, None, True)], "product", 0),
    ],
)
def test_the_order_of_candidates(found, described, match, position):
    """The order of the rules; hidden ones come last within a rule, not across rules."""
    assert best(found, *described) == (match, position)


_OF_VISIBLE = " of those that its vendor does not hide"


@pytest.mark.parametrize(
    ("found", "described", "because"),
    [
        (0x001300FB, {0x001300FA: True, 0x00121482: False}, f"0x00121482 is the nearest older one{_OF_VISIBLE}"),
        (0x001300FB, {0x00110000: True, 0x00121482: False}, "0x00121482 is the nearest older one"),
        (0x0FFFFF, {0x100000: True, 0x110000: False}, f"only newer ones are described, next 0x00110000{_OF_VISIBLE}"),
        (0x0FFFFF, {0x120000: True, 0x110000: False}, "only newer ones are described, next 0x00110000"),
    ],
)
def test_a_hidden_revision_that_is_nearer_is_not_denied(found, described, because):
    """The choice passes over what a vendor hides; the reason does not call it not described."""
    ranked = rank(found, [Described(revision, None, hidden) for revision, hidden in described.items()])
    assert ranked[0].reason == f"no exact ESI; nearest shown because {because}"


def test_anything_but_exact_says_so():
    reasons = [
        item.reason for item in rank(5, [Described(r, c, h) for r, c, h in ((4, None, False), (9, "LW_EQ", True))])
    ]
    assert reasons == [
        "no exact ESI; nearest shown because 0x00000004 is the nearest older one",
        "no exact ESI; nearest shown because only newer ones are described, next 0x00000009 (hidden by its vendor)",
    ]
    (newer,) = rank(0x00100000, [Described(0x00200000, "LW_EQ", False)])
    assert newer.reason.endswith("accepts it by its CheckRevisionNo LW_EQ; it is newer than the device")


def test_every_variant_is_ranked_by_its_own_rule_and_the_preferred_one_among_equals():
    described = [Described(0x10, None, False, 1), Described(0x10, "EQ_OR_G", False, 2), Described(0x11, None, False)]
    first, *_ = rank(0x12, described)
    assert (first.match, first.position) == ("accepted", 1)
    assert first.reason.endswith("because 0x00000010@2 accepts it by its CheckRevisionNo EQ_OR_G")
    alike = [Described(0x10, "EQ_OR_G", False, 2), Described(0x10, "EQ_OR_G", False, 1)]
    assert [item.position for item in rank(0x12, alike)] == [1, 0]


def test_a_rule_that_nobody_knows_is_told():
    (only,) = rank(0x12, [Described(0x10, "L16_EQ", False)])
    assert only.match == "older"
    assert only.reason.endswith("; its CheckRevisionNo 'L16_EQ' is not known")


@given(UINT32, st.lists(DESCRIBED, min_size=1, max_size=8))
def test_every_candidate_is_ranked_once_and_exact_wins(found, described):
    ranked = rank(found, described)
    assert sorted(item.position for item in ranked) == list(range(len(described)))
    if any(item.revision_no == found for item in described):
        assert ranked[0].match == "exact"
        assert described[ranked[0].position].revision_no == found
    else:
        assert ranked[0].match != "exact"
        assert all(item.reason.startswith("no exact ESI; nearest shown because") for item in ranked)
