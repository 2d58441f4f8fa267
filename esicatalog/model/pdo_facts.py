"""Small facts about PDOs and their entries that every reader of the catalog needs."""

from typing import Annotated

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.records.pdo import Entry, Pdo


class PdoFacts(Record):
    """What a PDO amounts to."""

    bit_size: Annotated[int, Doc("Sum of the entries' lengths in bits, padding included, OSFac not expanded")] = 0
    entry_count: Annotated[int, Doc("Number of entries, padding included")] = 0


class EntryFacts(Record):
    """What an entry is."""

    is_padding: Annotated[bool, Doc("Padding gap: index 0, only the length counts")] = False


def pdo_facts(pdo: Pdo) -> PdoFacts:
    """Size and number of entries of a PDO."""
    return PdoFacts(bit_size=sum(entry.bit_length or 0 for entry in pdo.entries), entry_count=len(pdo.entries))


def entry_facts(entry: Entry) -> EntryFacts:
    """Index 0 is padding whatever else the entry carries (ESI-FACTS section 9)."""
    return EntryFacts(is_padding=entry.entry_index == 0)
