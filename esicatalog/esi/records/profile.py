"""Profile of a device or module: profile numbers, channels, dictionary, diagnosis texts."""

from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

from esicatalog.esi.binding import RAW, Record, Xml
from esicatalog.esi.numbers import BOOL, INT, INTEGER
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.diagnostics import Diagnostics
from esicatalog.esi.records.dictionary import Dictionary, Object


class ChannelInfo(Record):
    """Profile of one channel."""

    profile_no: Annotated[int | None, Xml("ProfileNo", INT, "Profile number, e.g. 402")] = None
    add_info: Annotated[int | None, Xml("AddInfo", INT, "Module profile, e.g. 742 under 5001")] = None
    sub_add_info: Annotated[int | None, Xml("SubAddInfo", INT, "Further part of the profile number")] = None
    display_names: Annotated[tuple[Name, ...], Xml("DisplayName", doc="Display names")] = ()
    overwritten_by_module: Annotated[bool | None, Xml("@OverwrittenByModule", BOOL, "Replaced by a module's")] = None
    channel_group: Annotated[int | None, Xml("@ChannelGroup", INTEGER, "Channel group")] = None


class Profile(Record):
    """Profile element. ``dictionary`` is the inline one or the one ``dictionary_file`` names, when it was found."""

    CHOICES: ClassVar[tuple[tuple[str, ...], ...]] = (
        ("dictionary", "dictionary_file"),
        ("diag_messages", "diag_files"),
    )

    channel: Annotated[int | None, Xml("@Channel", INT, "Channel (obsolete)")] = None
    profile_no: Annotated[int | None, Xml("ProfileNo", INT, "Profile number, e.g. 402 drives, 5001 modular")] = None
    add_info: Annotated[int | None, Xml("AddInfo", INT, "Module profile, e.g. 100 digital input under 5001")] = None
    sub_add_info: Annotated[int | None, Xml("SubAddInfo", INT, "Further part of the profile number")] = None
    channel_count: Annotated[int | None, Xml("ChannelCount", INT, "Number of channels")] = None
    channel_infos: Annotated[tuple[ChannelInfo, ...], Xml("ChannelInfo")] = ()
    dictionary_file: Annotated[
        str | None, Xml("DictionaryFile", doc="External dictionary (EtherCATDict), path as the vendor wrote it")
    ] = None
    dictionary: Annotated[Dictionary | None, Xml("Dictionary")] = None
    diag_files: Annotated[tuple[str, ...], Xml("DiagFile", doc="External diagnosis texts (EtherCATDiag), as JSON")] = ()
    diag_messages: Annotated[Diagnostics | None, Xml("DiagMessages")] = None
    """The inline texts, or those of the documents that ``diag_files`` name."""
    vendor_specific: Annotated[str | None, Xml("VendorSpecific", RAW)] = None


def dictionaries_of(profiles: Iterable[Profile]) -> list[Dictionary]:
    """The dictionaries that profiles have, in their order."""
    return [profile.dictionary for profile in profiles if profile.dictionary is not None]


def declared_objects(profiles: Iterable[Profile]) -> Iterator[Object]:
    """The objects of all dictionaries of profiles, in document order."""
    return (declared for dictionary in dictionaries_of(profiles) for declared in dictionary.objects)
