"""What is remembered about records."""

from esicatalog.model.memo import IdentityMemo


def test_a_full_memo_starts_anew():
    memo: IdentityMemo[int] = IdentityMemo(2)
    calls = []

    def compute(value: int) -> int:
        calls.append(value)
        return value

    assert [memo.get(key, None, compute, key) for key in (1, 2, 1, 3, 1)] == [1, 2, 1, 3, 1]
    assert calls == [1, 2, 3, 1]


def test_many_records_are_looked_up_at_once():
    memo: IdentityMemo[int] = IdentityMemo(10)
    one, two, twin = [1], [2], [1]
    asked = []

    def compute(record: list[int]) -> int:
        asked.append(record[0])
        return record[0] - 1

    assert memo.of_all([one, two, one, twin], compute) == [0, 1, 0, 0]
    assert memo.of_all([two, one], compute) == [1, 0]
    assert asked == [1, 2, 1]


def test_what_is_found_by_keys_is_computed_of_record_and_key():
    memo: IdentityMemo[str] = IdentityMemo(10)
    asked = []

    def compute(record: str, key: tuple[int, str]) -> str:
        asked.append(key)
        return record + key[1]

    keys = [(1, "x"), (1, "y"), (1, "x")]
    assert memo.get_all(keys, ["a", "a", "a"], compute) == ["ax", "ay", "ax"]
    assert asked == [(1, "x"), (1, "y")]
