"""Diagnosis texts of DiagMessages and EtherCATDiag documents (EtherCATBase.xsd DiagnosticsType)."""

from collections.abc import Iterable
from typing import Annotated

from esicatalog.esi.binding import Record, Xml
from esicatalog.esi.numbers import HEX, INT
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.dictionary import EnumInfo


class CauseRemedy(Record):
    """A cause and what to do about it."""

    idx: Annotated[str | None, Xml("@Idx", doc="Number of the pair")] = None
    causes: Annotated[tuple[Name, ...], Xml("Cause", doc="Cause in all languages")] = ()
    remedies: Annotated[tuple[Name, ...], Xml("Remedy", doc="Remedy in all languages")] = ()


class DiagMessage(Record):
    """One diagnosis text, referenced by the text ids in object 0x10F3."""

    text_id: Annotated[int | None, Xml("TextId", HEX, "Text id as in 0x10F3")] = None
    message_texts: Annotated[tuple[Name, ...], Xml("MessageText", doc="Message in all languages")] = ()
    descriptions: Annotated[tuple[Name, ...], Xml("Description", doc="Description in all languages")] = ()
    diag_class: Annotated[str | None, Xml("Flags/DiagClass", doc="error, warning or information")] = None
    diag_reset: Annotated[int | None, Xml("Flags/DiagReset", INT, "Value of DiagReset")] = None
    diag_reaction: Annotated[int | None, Xml("Flags/DiagReaction", INT, "Value of DiagReaction")] = None
    diag_type: Annotated[int | None, Xml("Flags/DiagType", INT, "Value of DiagType")] = None
    cause_remedies: Annotated[tuple[CauseRemedy, ...], Xml("CauseRemedy", doc="Causes and remedies")] = ()
    infos: Annotated[tuple[Name, ...], Xml("Info", doc="Further information in all languages")] = ()
    hints: Annotated[tuple[Name, ...], Xml("Hint", doc="Hints in all languages")] = ()
    urls: Annotated[tuple[Name, ...], Xml("URL", doc="Links in all languages")] = ()


class Diagnostics(Record):
    """All diagnosis texts of a device or document."""

    diag_resets: Annotated[tuple[EnumInfo, ...], Xml("DiagReset", doc="Ways to reset")] = ()
    diag_reactions: Annotated[tuple[EnumInfo, ...], Xml("DiagReaction", doc="Reactions of the device")] = ()
    diag_types: Annotated[tuple[EnumInfo, ...], Xml("DiagType", doc="Types of diagnosis")] = ()
    diag_messages: Annotated[tuple[DiagMessage, ...], Xml("DiagMessage", doc="Messages")] = ()


def joined_diagnostics(parts: Iterable[Diagnostics | None]) -> Diagnostics | None:
    """The diagnosis texts of several parts of a description as one; None where no part has any."""
    found = [part for part in parts if part is not None]
    if len(found) < 2:
        return found[0] if found else None
    return Diagnostics(
        diag_resets=tuple(item for part in found for item in part.diag_resets),
        diag_reactions=tuple(item for part in found for item in part.diag_reactions),
        diag_types=tuple(item for part in found for item in part.diag_types),
        diag_messages=tuple(item for part in found for item in part.diag_messages),
    )
