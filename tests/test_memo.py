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
