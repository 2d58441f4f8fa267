"""Numbers of things in words."""


def counted(number: int, one: str, many: str | None = None) -> str:
    """A number of things: "1 byte", "2 bytes"; ``many`` where it is not ``one`` with an s."""
    return f"{number} {one if number == 1 else many or one + 's'}"
