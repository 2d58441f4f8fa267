"""Whether names of a vendor are spellings of one, or those of several makers who use its id."""

import re
from collections.abc import Iterable

_WORD = re.compile(r"\w+")
_LEGAL_FORMS = frozenset(
    {"ag", "and", "co", "corp", "corporation", "gmbh", "inc", "kg", "limited", "llc", "ltd", "sa", "sas", "srl"}
)


def may_be_same(name: str, other: str) -> bool:
    """Whether two names can be spellings of one: they share a word that is no legal form (rule L09)."""
    return name == other or not _words(name).isdisjoint(_words(other))


def own_vendor_name(vendor_name: str | None, document_names: Iterable[str | None]) -> str | None:
    """The maker of a device by its own documents, where none of them can mean the one of its vendor id; else None.

    ``vendor_name`` is the name of the id in all documents. Of several names the first in the order of characters.
    """
    written = sorted({name for name in document_names if name})
    if not written or not vendor_name or any(may_be_same(vendor_name, name) for name in written):
        return None
    return written[0]


def _words(name: str) -> frozenset[str]:
    words = frozenset(_WORD.findall(name.lower()))
    return words - _LEGAL_FORMS or words
