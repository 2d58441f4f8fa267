"""Numbers and texts as every part of the program writes them."""


def counted(number: int, one: str, many: str | None = None) -> str:
    """A number of things: "1 byte", "2 bytes"; ``many`` where it is not ``one`` with an s."""
    return f"{number} {one if number == 1 else many or one + 's'}"


def one_line(text: str) -> str:
    """A text with single blanks between its words, as people type it."""
    return " ".join(text.split())


def hex32(value: int | None, absent: str = "-") -> str:
    """A number of 32 bits: ``0x`` and eight digits; ``absent`` where there is none."""
    return f"0x{value:08x}" if value is not None else absent


def index_words(index: int | None) -> str:
    """An index of an object or PDO, or an address: ``0x`` and four digits."""
    return f"0x{index:04X}" if index is not None else "without index"
