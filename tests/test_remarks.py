"""Functions that remark something and return a result."""

from esicatalog.remarks import Remarking, in_turn, remarked


def half(number: int) -> Remarking[int]:
    if number % 2:
        yield f"{number} is odd"
    return number // 2


def halves(*numbers: int) -> Remarking[list[int]]:
    yield "rounded down"
    found = yield from in_turn(map(half, numbers))
    if 0 in found:
        yield "one is 0"
    return found


def test_result_and_remarks_are_parted_in_the_order_of_the_work():
    assert remarked(half(4)) == (2, ())
    assert remarked(halves(3, 4, 1)) == ([1, 2, 0], ("rounded down", "3 is odd", "1 is odd", "one is 0"))
    assert remarked(in_turn(map(half, ()))) == ([], ())
