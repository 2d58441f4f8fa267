"""Numbers and texts as every part of the program writes them."""

from typing import overload


def counted(number: int, one: str, many: str | None = None) -> str:
    """A number of things: "1 byte", "2 bytes"; ``many`` where it is not ``one`` with an s."""
    return f"{number} {one if number == 1 else many or one + 's'}"


def one_line(text: str) -> str:
    """A text with single blanks between its words, as people type it."""
    return " ".join(text.split())


@overload
def hex32(value: int) -> str: ...
@overload
def hex32(value: None) -> None: ...
def hex32(value: int | None) -> str | None:
    """A number of 32 bits: ``0x`` and eight digits."""
    return None if value is None else f"0x{value:08x}"


def index_words(index: int | None) -> str:
    """An index of an object or PDO, or an address: ``0x`` and four digits."""
    return f"0x{index:04X}" if index is not None else "without index"
