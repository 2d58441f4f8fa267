"""The string table of an SII image in the making."""

from esicatalog.esi.records.common import ENGLISH, Name, display_text
from esicatalog.sii.encode import string_table
from esicatalog.sii.errors import SiiEncodeError
from esicatalog.sii.image import Strings
from esicatalog.sii.strings import MAX_STRING_BYTES, encode_text


class Texts:
    """String numbers of texts in one language (an LcId), in the order of first use; equal texts share a number."""

    def __init__(self, language: int | None = None) -> None:
        self._language = ENGLISH if language is None else language
        self._numbers: dict[str, int] = {}

    def number(self, text: str | None) -> int:
        """The string number of a text, 0 for none."""
        text = storable(text or "")
        return self._numbers.setdefault(text, len(self._numbers) + 1) if text else 0

    def number_of(self, names: tuple[Name, ...]) -> int:
        """The string number of a text that exists in several languages."""
        return self.number(display_text(names, self._language))

    def table(self) -> Strings:
        """The string table with all texts so far; it may hold more than 255."""
        return string_table(self._numbers)


def storable(text: str) -> str:
    """As much of a text as a string of an image holds: 255 bytes."""
    for end in range(min(len(text), MAX_STRING_BYTES), 0, -1):
        try:
            encode_text(text[:end])
        except SiiEncodeError:
            continue
        return text[:end]
    return ""
