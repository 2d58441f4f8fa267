"""Documents: vendor, groups, devices and modules of one file, and the external kinds it can refer to."""

from typing import Annotated

from esicatalog.esi.binding import RAW, Record, Xml
from esicatalog.esi.notes import Unmapped
from esicatalog.esi.numbers import IDENTITY, IMAGE, INT
from esicatalog.esi.records.common import Name, display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.diagnostics import Diagnostics
from esicatalog.esi.records.dictionary import Dictionary
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo


class Vendor(Record):
    """Vendor element."""

    vendor_id: Annotated[int | None, Xml("Id", IDENTITY, "Vendor id assigned by the ETG")] = None
    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names in all languages")] = ()
    comments: Annotated[tuple[Name, ...], Xml("Comment", doc="Comments in all languages")] = ()
    urls: Annotated[tuple[Name, ...], Xml("URL", doc="Links in all languages")] = ()
    description_url: Annotated[str | None, Xml("DescriptionURL", doc="Link to the description")] = None
    file_version: Annotated[int | None, Xml("@FileVersion", INT, "The vendor's own version of the file")] = None
    unique_name: Annotated[str | None, Xml("@UniqueName", doc="Unique name (obsolete)")] = None
    image_symbol: Annotated[str | None, Xml("Image16x14", doc="Image as a symbolic name (obsolete)")] = None
    image_file: Annotated[str | None, Xml("ImageFile16x14", doc="Image file name")] = None
    image_data: Annotated[str | None, Xml("ImageData16x14", IMAGE, "Image, bytes in hex")] = None
    vendor_specific: Annotated[str | None, Xml("VendorSpecific", RAW, "Vendor-specific XML")] = None


class Group(Record):
    """Group of devices; its key is ``type`` within the vendor."""

    type: Annotated[str | None, Xml("Type", doc="Key of the group, referred to by GroupType")] = None
    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names in all languages")] = ()
    comments: Annotated[tuple[Name, ...], Xml("Comment", doc="Comments in all languages")] = ()
    sort_order: Annotated[int | None, Xml("@SortOrder", INT, "Display order, ascending")] = None
    parent_group: Annotated[str | None, Xml("@ParentGroup", doc="Key of the parent group")] = None
    image_symbol: Annotated[str | None, Xml("Image16x14", doc="Image as a symbolic name (obsolete)")] = None
    image_file: Annotated[str | None, Xml("ImageFile16x14", doc="Image file name")] = None
    image_data: Annotated[str | None, Xml("ImageData16x14", IMAGE, "Image, bytes in hex")] = None
    vendor_specific: Annotated[str | None, Xml("VendorSpecific", RAW, "Vendor-specific XML")] = None


class SharedPdo(Pdo):
    """Descriptions/Pdos/Pdo of files before schema 1.2, referred to by RxPdo@Ref and TxPdo@Ref."""

    shared_name: Annotated[str | None, Xml("@Name", doc="Name that @Ref refers to")] = None


class EsiInfo(Record):
    """EtherCATInfo element: a vendor with groups, devices and modules."""

    schema_version: Annotated[str | None, Xml("@Version", doc="Schema version that the author used")] = None
    info_references: Annotated[tuple[str, ...], Xml("InfoReference", doc="Module documents it refers to")] = ()
    vendor: Annotated[Vendor | None, Xml("Vendor")] = None
    groups: Annotated[tuple[Group, ...], Xml("Descriptions/Groups/Group")] = ()
    devices: Annotated[tuple[Device, ...], Xml("Descriptions/Devices/Device")] = ()
    modules: Annotated[tuple[Module, ...], Xml("Descriptions/Modules/Module")] = ()
    shared_pdos: Annotated[tuple[SharedPdo, ...], Xml("Descriptions/Pdos/Pdo")] = ()

    @property
    def vendor_id(self) -> int | None:
        """Id of the vendor; None where none is given, or no vendor."""
        return self.vendor.vendor_id if self.vendor is not None else None

    @property
    def vendor_name(self) -> str | None:
        """Name of the vendor as it is shown; None where none is given, or no vendor."""
        return display_text(self.vendor.names) if self.vendor is not None else None


class ModuleInfo(Record):
    """EtherCATModule element: a vendor with modules for other documents."""

    schema_version: Annotated[str | None, Xml("@Version", doc="Schema version that the author used")] = None
    vendor: Annotated[Vendor | None, Xml("Vendor")] = None
    modules: Annotated[tuple[Module, ...], Xml("Modules/Module")] = ()


class DictInfo(Record):
    """EtherCATDict element: a dictionary for other documents."""

    schema_version: Annotated[str | None, Xml("@Version", doc="Schema version that the author used")] = None
    dictionary: Annotated[Dictionary | None, Xml("Dictionary")] = None


class DiagInfo(Record):
    """EtherCATDiag element: diagnosis texts for other documents."""

    schema_version: Annotated[str | None, Xml("@Version", doc="Schema version that the author used")] = None
    diag_messages: Annotated[Diagnostics | None, Xml("DiagMessages")] = None


class InfoList(Record):
    """EtherCATInfoList element: what the IgH tool prints for several slaves."""

    infos: Annotated[tuple[EsiInfo, ...], Xml("EtherCATInfo")] = ()


class Reference(Record):
    """A document that another one pulls in."""

    kind: str = ""
    """DictionaryFile, DiagFile or InfoReference."""
    text: str = ""
    """As the vendor wrote it; what a document of modules pulls in is named as seen from the one that refers to it."""
    location: str | None = None
    """Where it was found, relative to the folder or archive; None when it was not."""
    sha256: str | None = None
    is_whole: bool = False
    """Whether it was read as :attr:`Document.is_whole` says; else it may say more than is known of it."""


class Document(Record):
    """One document with everything it says and everything it pulls in."""

    root: str = ""
    """Root element: EtherCATInfo, EtherCATInfoList, EtherCATModule, EtherCATDict or EtherCATDiag."""
    encoding: str = ""
    recovered: str | None = None
    """What was wrong when the document could only be read by recovery."""
    is_whole: bool = True
    """Whether no element of it may be lost; else nothing follows from what it does not have.

    What is wrong with its encoding alone, or with the place of its XML declaration, loses none.
    """
    schema_version: str | None = None
    """Schema version that the author of an EtherCATDict or EtherCATDiag document used; others say it in ``infos``."""
    infos: tuple[EsiInfo, ...] = ()
    """The EtherCATInfo elements; an EtherCATModule document counts as one without devices."""
    dictionary: Dictionary | None = None
    """Of an EtherCATDict document."""
    diag_messages: Diagnostics | None = None
    """Of an EtherCATDiag document."""
    referenced_modules: tuple[tuple[Module, ...], ...] = ()
    """Modules of the documents named by InfoReference, one tuple an ``infos`` item."""
    referenced_vendor_ids: tuple[tuple[int | None, ...], ...] = ()
    """The vendor of each of these: a document of modules has its own."""
    references: tuple[Reference, ...] = ()
    device_lines: tuple[tuple[int, ...], ...] = ()
    module_lines: tuple[tuple[int, ...], ...] = ()
    unmapped: tuple[Unmapped, ...] = ()
    """Values outside of devices and modules that no field holds."""

    @property
    def is_all_whole(self) -> bool:
        """Whether nothing is lost of it and of the documents that were found for it."""
        return self.is_whole and all(item.is_whole for item in self.references if item.sha256 is not None)

    def damage(self, file_name: str) -> str | None:
        """That its descriptions may lack something, in words; None for a whole document."""
        return None if self.is_all_whole else damage_words(file_name, self.recovered)


def damage_words(file_name: str, reason: str | None) -> str:
    """That a document is not whole, and why; without reason, one that it pulls in is not."""
    return (
        f"{file_name} could not be read whole ({reason or 'a document that it refers to is damaged'}): what "
        "stands behind or around the damage may be missing here; take an undamaged file"
    )
